// Every source file keeps the rules of layering_rules.h, and those rules notice what they should.
#include "layering/layering_rules.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;
using isoscope::layering::broken_rules;

namespace {

bool is_checked(const fs::path& file) {
  static const char* const endings[] = {".h", ".cpp", ".vert", ".frag", ".glsl", ".geom", ".cmake"};
  for (const char* ending : endings)
    if (file.extension() == ending) return true;
  return file.filename() == "CMakeLists.txt" || file.parent_path().filename() == "scripts";
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::string purpose = "// A file that serves the test of the rules.\n";

} // namespace

TEST_CASE("every source file keeps the rules") {
  const fs::path root = ISOSCOPE_SOURCE_DIR;
  int files = 0;
  for (const char* top : {"core", "viewer", "shaders", "tests", "third_party", "scripts"}) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || !is_checked(entry.path())) continue;
      ++files;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      for (const std::string& broken : broken_rules(path, text_of(entry.path()))) FAIL_CHECK(broken);
    }
  }
  CHECK(files > 20);
}

TEST_CASE("includes follow the arrows") {
  const auto includes = [](const char* path, const char* line) {
    return broken_rules(path, purpose + line + "\n").size();
  };
  CHECK(includes("core/mesh/zero_set.h", "#include \"base/ids.h\"") == 0);
  CHECK(includes("core/mesh/zero_set.h", "#include \"mesh/complex.h\"") == 0);
  CHECK(includes("core/mesh/zero_set.h", "#include <vector>") == 0);
  CHECK(includes("core/mesh/zero_set.h", "#include \"refine/refinement.h\"") == 1);
  CHECK(includes("core/base/ids.h", "#include \"mesh/complex.h\"") == 1);
  CHECK(includes("core/criteria/height.cpp", "#include \"journal/event.h\"") == 1);
  CHECK(includes("core/run/session.cpp", "#include \"scene/camera.h\"") == 1);
  CHECK(includes("core/attic/old.cpp", "#include \"base/ids.h\"") == 1);
  CHECK(includes("core/improve/relaxation.cpp", "#include \"collapse/tet_patch.h\"") == 0);
  CHECK(includes("core/collapse/tet_patch.cpp", "#include \"improve/relaxation.h\"") == 1);
  CHECK(includes("core/questions/snapshot.cpp", "#include \"compare/compare_runs.h\"") == 1);
  CHECK(includes("core/run/session.cpp", "#include \"edge/probe.h\"") == 1);
  CHECK(includes("viewer/scene/camera.h", "#include \"questions/snapshot.h\"") == 0);
  CHECK(includes("viewer/edge/probe.h", "#include \"ask/investigation.h\"") == 1);
  CHECK(includes("viewer/edge/probe.h", "#include \"model/shown_run.h\"") == 0);
  CHECK(includes("viewer/talk/bookmarks.h", "#include \"app/app_model.h\"") == 1);
  CHECK(includes("viewer/app/app.h", "#include \"cli/exit_status.h\"") == 0);
  CHECK(includes("viewer/ui/theme.h", "#include \"cli/exit_status.h\"") == 1);
  CHECK(includes("viewer/gl/buffer.h", "#include \"scene/camera.h\"") == 1);
  CHECK(includes("viewer/platform/window.h", "#include \"mesh/complex.h\"") == 1);
}

TEST_CASE("tests lie in folders called like rooms") {
  CHECK(broken_rules("tests/mesh/a.cpp", purpose).empty());
  CHECK(broken_rules("tests/talk/a.cpp", purpose).empty());
  CHECK(broken_rules("tests/support/a.h", purpose).empty());
  CHECK(broken_rules("tests/batch/a.cpp", purpose).size() == 1);
  CHECK(broken_rules("tests/CMakeLists.txt", "").empty());
}

TEST_CASE("libraries stay in their places") {
  const auto includes = [](const char* path, const char* line) {
    return broken_rules(path, purpose + line + "\n").size();
  };
  CHECK(includes("core/mesh/delaunay.cpp", "#include <CGAL/Delaunay_triangulation_3.h>") == 0);
  CHECK(includes("core/mesh/delaunay.h", "#include <CGAL/Delaunay_triangulation_3.h>") == 1);
  CHECK(includes("viewer/scene/camera.cpp", "#include <CGAL/Point_3.h>") == 1);
  CHECK(includes("core/base/parallel.cpp", "#include <oneapi/tbb/parallel_for.h>") == 0);
  CHECK(includes("core/mesh/delaunay.cpp", "#include <tbb/parallel_for.h>") == 1);
  CHECK(includes("core/cli/isoscope_mpi.cpp", "#include <mpi.h>") == 0);
  CHECK(includes("core/cli/tiles.cpp", "#include <mpi.h>") == 1);
  CHECK(includes("core/run/session.cpp", "#include <glm/glm.hpp>") == 1);
  CHECK(includes("core/run/session.cpp", "#  include <glad/gl.h>") == 1);
  CHECK(includes("core/run/session.cpp", "#include <GLFW/glfw3.h>") == 1);
  CHECK(includes("core/run/session.cpp", "#include \"imgui.h\"") == 1);
  CHECK(includes("viewer/scene/camera.h", "#include <glm/glm.hpp>") == 0);
  CHECK(includes("viewer/scene/camera.h", "#include \"imgui.h\"") == 1);
  CHECK(includes("viewer/ui/widgets.cpp", "#include <imgui.h>") == 0);
}

TEST_CASE("purpose, length and words") {
  CHECK(broken_rules("core/base/a.h", purpose).empty());
  CHECK(broken_rules("core/base/a.h", "#pragma once\n").size() == 1);
  CHECK(broken_rules("core/base/a.h", "").size() == 1);
  CHECK(broken_rules("shaders/a.vert", "#version 410 core\n" + purpose).empty());
  CHECK(broken_rules("scripts/a", "#!/usr/bin/env bash\n# Does what the test of the rules needs.\n").empty());

  std::string text = purpose;
  for (int i = 1; i < 500; ++i) text += "\n";
  CHECK(broken_rules("core/base/a.h", text).empty());
  CHECK(broken_rules("core/base/a.h", text + "\n").size() == 1);

  CHECK(broken_rules("core/base/a.h", purpose + "// TODO\n").size() == 1);
  CHECK(broken_rules("core/base/a.h", purpose + "int XXXX;\n").empty());
  CHECK(broken_rules("core/base/a.h", purpose + "#if 0\n#endif\n").size() == 1);
  CHECK(broken_rules("viewer/talk/a.h", purpose + "class AppModel;\n").size() == 1);
  CHECK(broken_rules("viewer/app/a.h", purpose + "class AppModel;\n").empty());
  CHECK(broken_rules("core/base/a.h", purpose + "// see /home/someone/model.off\n").size() == 1);
}
