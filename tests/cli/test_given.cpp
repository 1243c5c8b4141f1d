// Volumes as people give them: options, statuses, what is printed, recordings.
#include "input/gallery_shapes.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/clouds.h"
#include "support/run_program.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <fstream>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string write(const TemporaryFolder& folder, const char* name, TriangleSoup soup, double scale,
                  Vec3 to = {}) {
  for (Vec3& p : soup.points) p = scale * p + to;
  REQUIRE(write_mesh(folder / name, {soup.points, soup.triangles}).ok());
  return (folder / name).string();
}

} // namespace

TEST_CASE("Two surfaces: a certified mesh between them, a recording that replays") {
  const TemporaryFolder folder;
  const std::string outer = write(folder, "outer.off", make_sphere(2), 1),
                    inner = write(folder, "inner.off", make_sphere(2), 0.7),
                    out = (folder / "out.off").string(), report = (folder / "report.json").string(),
                    recording = (folder / "run.isorun").string();
  const Ended ended = run_batch({"--inside", inner, "--outside", outer, "--effort", "0", "-o", out,
                                 "--report", report, "--record", recording});
  CAPTURE(ended.out + ended.error);
  CHECK(ended.status == 0);
  CHECK(ended.says("between the two surfaces, which no facet meets"));
  CHECK(ended.says("(given)"));
  CHECK(ended.says("χ = 2"));
  const auto json = nlohmann::json::parse(bytes_of(report));
  CHECK(json["input"]["path"] == outer);
  CHECK(json["input"]["inside"] == inner);
  CHECK(json["certificate"]["holds"] == true);
  std::filesystem::remove(outer);
  std::filesystem::remove(inner);
  const Ended replayed = run_batch({"replay", recording, "--check"});
  CAPTURE(replayed.out + replayed.error);
  CHECK(replayed.status == 0);
}

TEST_CASE("Surfaces that bound no volume end with 3 and the place") {
  const TemporaryFolder folder;
  TriangleSoup torn = make_sphere(2);
  torn.triangles.pop_back();
  const std::string unit = write(folder, "unit.off", make_sphere(2), 1),
                    small = write(folder, "small.off", make_sphere(2), 0.5),
                    aside = write(folder, "aside.off", make_sphere(2), 0.5, {0.7, 0, 0}),
                    away = write(folder, "away.off", make_sphere(2), 0.5, {5, 0, 0}),
                    open = write(folder, "open.off", torn, 0.5);
  const auto refused = [&](const std::string& inner, const std::string& outer, const std::string& words) {
    const Ended ended = run_batch({"--inside", inner, "--outside", outer});
    CAPTURE(ended.error);
    CHECK(ended.status == 3);
    CHECK(ended.says(words));
    CHECK(ended.says("near ("));
    CHECK(std::count(ended.error.begin(), ended.error.end(), '\n') == 1);
  };
  refused(aside, unit, "touch or cross");
  refused(unit, unit, "touch or cross");
  refused(away, unit, "not inside the outer one");
  refused(unit, small, "larger surface is the outer one");
  refused(open, unit, "inner surface is open");
}

TEST_CASE("Options of volumes that contradict each other end with 2") {
  const auto wrong = [](const std::vector<std::string>& arguments, const std::string& words) {
    const Ended ended = run_batch(arguments);
    CAPTURE(ended.error);
    CHECK(ended.status == 2);
    CHECK(ended.says(words));
  };
  wrong({"--inside", "a.off"}, "--outside is missing");
  wrong({"--outside", "a.off"}, "--inside is missing");
  wrong({"c.off", "--inside", "a.off", "--outside", "b.off"}, "INPUT is given");
  wrong({"--inside", "a.off", "--outside", "b.off", "--tolerance", "1%"}, "--tolerance is given");
  wrong({"--inside", "a.off", "--outside", "b.off", "--levels", "0", "1"}, "one kind of volume");
  wrong({"a.nrrd", "--levels", "1", "0"}, "the smaller first");
  wrong({"a.nrrd", "--levels", "1"}, "--levels");
  wrong({"a.nrrd", "--label", "one"}, "--label");
  wrong({"gallery:density", "--tolerance", "1%"}, "--tolerance is given");
  wrong({"gallery:sphere", "--levels", "0", "1"}, "no grid");
}

TEST_CASE("A grid and a segmentation from files") {
  const TemporaryFolder folder;
  std::string labels;
  for (int i = 0; i < 20 * 20 * 20; ++i) {
    const int x = i % 20 - 10, y = i / 20 % 20 - 10, z = i / 400 - 10;
    labels += x * x + y * y + z * z < 49 ? '\5' : '\0';
  }
  folder.file("labels.raw", labels);
  const std::string header =
      folder
          .file("labels.grid", "isoscope-grid 1\nsize 20 20 20\ntype uint8\nspacing 2 2 2\ndata labels.raw\n")
          .string();
  const std::string recording = (folder / "run.isorun").string();
  const Ended ended = run_batch(
      {header, "--label", "5", "--levels", "-1", "1", "--until", "refinement", "--record", recording});
  CAPTURE(ended.out + ended.error);
  CHECK(ended.status == 0);
  CHECK(ended.says("between the two levels on every facet"));
  std::filesystem::remove(header);
  CHECK(run_batch({"replay", recording, "--check"}).status == 0);
  CHECK(run_batch({header}).status == 3);
}

TEST_CASE("Points that the result does not follow are told, also quietly, and are no failure") {
  const TemporaryFolder folder;
  testing::Random random(12);
  std::vector<Vec3> points = testing::sphere_points(random, 4000, 1, 0.005);
  while (points.size() < 8000) { // a brim, which has no inside
    const Vec3 p = 2 * random.in_box({{-1, -1, 0}, {1, 1, 0}});
    if (length(p) > 1 && length(p) < 2) points.push_back(p + testing::noise(random, 0.005));
  }
  const std::string file = (folder / "hat.xyz").string();
  {
    std::ofstream text(file);
    text.precision(9);
    for (const Vec3& p : points) text << p.x << ' ' << p.y << ' ' << p.z << '\n';
    REQUIRE(text.good());
  }
  const Ended ended = run_batch({file, "--until", "refinement", "--quiet"});
  CAPTURE(ended.error);
  CHECK(ended.status == 0);
  CHECK(ended.error.find("of the points are farther than 3 δ from the result") != std::string::npos);
  const Ended unasked = run_batch({file, "--until", "refinement", "--quiet", "--cover", "off"});
  CHECK(unasked.error.find("farther than") == std::string::npos);
}
