// The order of the folders, the places of libraries, and the checks over one file's text.
#include "layering/layering_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace isoscope::layering {
namespace {

constexpr int longest_file = 500;

// All folders from the bottom up: a folder's files include those of its own and of folders below. Folders of
// one tier stand beside each other and do not know each other.
using Tiers = std::vector<std::vector<std::string_view>>;

const Tiers& core_tiers() {
  static const Tiers tiers = {{"core/base"},
                              {"core/input"},
                              {"core/tolerance", "core/mesh"},
                              {"core/criteria", "core/journal"},
                              {"core/refine", "core/query", "core/recording"},
                              {"core/collapse"},
                              {"core/improve"},
                              {"core/simplify"},
                              {"core/run"},
                              {"core/questions", "core/compare", "core/tiles", "core/sweep"},
                              {"core/cli"}};
  return tiers;
}

const Tiers& viewer_tiers() {
  static const Tiers tiers = {{"viewer/platform", "viewer/gl"},
                              {"viewer/scene"},
                              {"viewer/model"},
                              {"viewer/command"},
                              {"viewer/ui"},
                              {"viewer/edge"},
                              {"viewer/debug"},
                              {"viewer/ask"},
                              {"viewer/view"},
                              {"viewer/talk", "viewer/export"},
                              {"viewer/lesson"},
                              {"viewer/two_runs"},
                              {"viewer/timeline", "viewer/mosaic"},
                              {"viewer/steering"},
                              {"viewer/app"}};
  return tiers;
}

/// Of tests: those that are no room's.
constexpr std::array<std::string_view, 7> common_test_folders{"bench",    "corpus",  "experiments", "fuzz",
                                                              "layering", "package", "support"};

/// Where a folder stands; both ladders in one, the viewer's on top. Nothing for a folder that is in neither.
std::optional<std::size_t> tier_of(std::string_view folder) {
  std::size_t number = 0;
  for (const Tiers* tiers : {&core_tiers(), &viewer_tiers()})
    for (const auto& tier : *tiers) {
      if (std::find(tier.begin(), tier.end(), folder) != tier.end()) return number;
      ++number;
    }
  return std::nullopt;
}

// Headers of libraries: the beginning of the include, and the places (beginnings of paths) that may include
// it.
struct LibraryRule {
  std::string_view header;
  std::vector<std::string_view> places;
  bool sources_only; // only in .cpp files
};

const std::vector<LibraryRule>& library_rules() {
  static const std::vector<LibraryRule> rules = {
      {"CGAL/", {"core/", "tests/"}, true},
      {"tbb/", {"core/base/parallel.cpp"}, true},
      {"oneapi/", {"core/base/parallel.cpp"}, true},
      {"glad/",
       {"viewer/gl/", "viewer/scene/", "viewer/platform/", "viewer/export/", "viewer/app/", "tests/"},
       false},
      {"GL/", {}, false},
      // Codes of keys, which commands have.
      {"GLFW/", {"viewer/", "tests/"}, true},
      {"imgui", {"viewer/ui/", "viewer/app/", "tests/"}, false},
      {"backends/imgui", {"viewer/app/", "tests/"}, false},
      {"glm/", {"viewer/", "tests/"}, false},
      {"stb_", {"viewer/platform/", "tests/"}, false},
      {"CLI/", {"core/cli/command_line.cpp", "tests/"}, true},
      {"mpi.h", {"core/cli/isoscope_mpi.cpp"}, true},
      {"sqlite3", {"core/recording/", "tests/recording/"}, true},
      {"zlib", {"core/input/", "core/recording/", "core/sweep/", "tests/"}, true},
      {"viewer/", {}, false},
      {"core/", {}, false},
  };
  return rules;
}

bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](auto e) { return text.ends_with(e); });
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  return text;
}

// The name between the quotes or angle brackets of an include line, else empty.
std::string_view included_name(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with("#")) return {};
  line = trimmed(line.substr(1));
  if (!line.starts_with("include")) return {};
  const std::size_t begin = line.find_first_of("\"<");
  const std::size_t end = line.find_last_of("\">");
  return begin == line.npos || end <= begin ? std::string_view{} : line.substr(begin + 1, end - begin - 1);
}

bool holds_word(std::string_view line, std::string_view word) {
  const auto is_letter = [&](std::size_t i) {
    return i < line.size() && (std::isalnum(static_cast<unsigned char>(line[i])) != 0 || line[i] == '_');
  };
  for (std::size_t at = line.find(word); at != line.npos; at = line.find(word, at + 1))
    if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  return false;
}

// "core/mesh" of "core/mesh/complex.cpp".
std::string_view room_of(std::string_view path) {
  const std::size_t first = path.find('/');
  const std::size_t second = first == path.npos ? path.npos : path.find('/', first + 1);
  return second == path.npos ? std::string_view{} : path.substr(0, second);
}

/// Tests lie in folders that are called like the rooms whose they are.
bool mirrors_a_room(std::string_view path) {
  const std::string_view folder = room_of(path);
  if (!folder.starts_with("tests/")) return true;
  const std::string name(folder.substr(6));
  return tier_of("core/" + name) || tier_of("viewer/" + name) ||
         std::find(common_test_folders.begin(), common_test_folders.end(), name) != common_test_folders.end();
}

std::string check_include(std::string_view path, std::string_view name) {
  for (const LibraryRule& rule : library_rules()) {
    if (!name.starts_with(rule.header)) continue;
    const bool here = std::any_of(rule.places.begin(), rule.places.end(),
                                  [&](std::string_view place) { return path.starts_with(place); });
    if (!here) return "may not include " + std::string(name);
    if (rule.sources_only && !path.ends_with(".cpp")) return "includes " + std::string(name) + " in a header";
    return {};
  }

  if (!path.starts_with("core/") && !path.starts_with("viewer/")) return {};
  const std::string_view own = room_of(path);
  if (own.empty()) return {};
  const auto tier = tier_of(own);
  if (!tier) return "lies in a folder that the order of folders does not know";
  const std::size_t slash = name.find('/');
  if (slash == name.npos) return {};
  const std::string folder(name.substr(0, slash));
  if (folder == "embedded")
    return path.starts_with("viewer/") ? std::string() : "may not include " + std::string(name);
  const std::string in_core = "core/" + folder, in_viewer = "viewer/" + folder;
  const std::string& other = tier_of(in_viewer) ? in_viewer : in_core;
  const auto below = tier_of(other);
  if (!below || other == own) return {};
  const auto base_alone = {"viewer/gl", "viewer/platform"};
  const bool stands_alone = std::find(base_alone.begin(), base_alone.end(), own) != base_alone.end();
  // The viewer takes from the batch program what both print, in one place.
  const bool fits = *below < *tier && (!stands_alone || other == "core/base") &&
                    (other != "core/cli" || own == "viewer/app");
  return fits ? std::string() : "may not include " + std::string(name);
}

bool begins_with_purpose(std::string_view path, const std::vector<std::string_view>& lines) {
  const bool c_like = ends_with_any(path, {".h", ".cpp", ".vert", ".frag", ".glsl", ".geom"});
  const std::string_view mark = c_like ? "// " : "# ";
  // A shebang or a shader's #version has to be first.
  const std::size_t first =
      !lines.empty() && (lines[0].starts_with("#!") || lines[0].starts_with("#version"));
  return lines.size() > first && lines[first].starts_with(mark) && lines[first].size() > mark.size() + 10;
}

} // namespace

std::vector<std::string> broken_rules(std::string_view path, std::string_view text) {
  std::vector<std::string> broken;
  const std::vector<std::string_view> lines = lines_of(text);
  const auto say = [&](std::size_t line, const std::string& what) {
    broken.push_back(std::string(path) + ":" + std::to_string(line) + ": " + what);
  };

  // A folder's build list says what it is by its name.
  if (!path.ends_with("CMakeLists.txt") && !begins_with_purpose(path, lines))
    say(1, "does not begin with a sentence of purpose");
  if (lines.size() > longest_file)
    say(lines.size(), "is longer than " + std::to_string(longest_file) + " lines");

  if (!mirrors_a_room(path)) say(1, "lies in a folder of tests that is called like no room");

  // This test spells the forbidden words in order to forbid them.
  if (path.starts_with("tests/layering/")) return broken;
  const bool is_source = ends_with_any(path, {".h", ".cpp"});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (const std::string_view name = included_name(lines[i]); is_source && !name.empty())
      if (const std::string what = check_include(path, name); !what.empty()) say(i + 1, what);
    for (const std::string_view word : {"TODO", "FIXME", "XXX"})
      if (holds_word(lines[i], word)) say(i + 1, "says " + std::string(word));
    if (trimmed(lines[i]).starts_with("#if 0")) say(i + 1, "keeps dead code");
    if (path.starts_with("viewer/") && room_of(path) != "viewer/app" && holds_word(lines[i], "AppModel"))
      say(i + 1, "names the whole window");
    for (const std::string_view place : {"/work/", "/home/", "/root/"})
      if (lines[i].find(place) != std::string_view::npos) say(i + 1, "names a place of one machine");
  }
  return broken;
}

} // namespace isoscope::layering
