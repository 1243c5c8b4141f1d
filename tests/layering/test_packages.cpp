// third_party/README.md and the scripts' package list name the same packages.
#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace {

using Names = std::set<std::string>;

Names packages_of_scripts() {
  Names names;
  std::ifstream in(ISOSCOPE_SOURCE_DIR "/scripts/packages");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line[0] == '[') continue;
    std::istringstream words(line);
    std::string package, reason;
    words >> package >> reason;
    CHECK_MESSAGE(!reason.empty(), package << " has no reason");
    names.insert(package);
  }
  return names;
}

// The second column of the README's tables, names in backticks.
Names packages_of_readme() {
  Names names;
  std::ifstream in(ISOSCOPE_SOURCE_DIR "/third_party/README.md");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| ")) continue;
    const std::size_t begin = line.find("| `", 2);
    if (begin == std::string::npos) continue;
    const std::size_t end = line.find('`', begin + 3);
    REQUIRE(end != std::string::npos);
    names.insert(line.substr(begin + 3, end - begin - 3));
  }
  return names;
}

} // namespace

TEST_CASE("the README explains exactly the packages that the scripts install") {
  const Names scripts = packages_of_scripts(), readme = packages_of_readme();
  CHECK(scripts.size() > 10);
  for (const std::string& name : scripts)
    CHECK_MESSAGE(readme.count(name) == 1, name << " is missing in third_party/README.md");
  for (const std::string& name : readme)
    CHECK_MESSAGE(scripts.count(name) == 1, name << " is missing in scripts/packages");
}
