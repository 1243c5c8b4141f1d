// Files of facets: the same bytes for the same facets, parts by boxes, damage found.
#include "input/temporary_folder.h"
#include "tiles/facet_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>

using namespace isoscope;

namespace {

const TileGrid unit_bricks(1, {{0, 0, 0}, {8, 8, 8}});
constexpr double inf = Box3::inf;
const Box3 everywhere{{-inf, -inf, -inf}, {inf, inf, inf}};

std::vector<Triangle3> some_facets() {
  std::vector<Triangle3> facets;
  for (int i = 0; i < 8; ++i) {
    const double x = i;
    facets.push_back({Vec3{x, 0, 0}, Vec3{x + 1, 0, 0}, Vec3{x, 1, 0}});
  }
  facets.push_back({Vec3{0, 5, 5}, Vec3{8, 5, 5}, Vec3{0, 6, 5}}); // over many bricks
  return facets;
}

} // namespace

TEST_CASE("A facet begins with its lowest vertex and keeps its side") {
  const Triangle3 f{Vec3{2, 0, 0}, Vec3{1, 3, 0}, Vec3{1, 2, 0}};
  CHECK(canonical(f) == Triangle3{Vec3{1, 2, 0}, Vec3{2, 0, 0}, Vec3{1, 3, 0}});
}

TEST_CASE("The same facets make the same bytes in any order, and come back") {
  const TemporaryFolder folder;
  std::vector<Triangle3> facets = some_facets(), turned = facets;
  std::reverse(turned.begin(), turned.end());
  for (Triangle3& f : turned) std::rotate(f.begin(), f.begin() + 1, f.end());
  REQUIRE(write_facets(folder / "a.facets", unit_bricks, facets).ok());
  REQUIRE(write_facets(folder / "b.facets", unit_bricks, turned).ok());
  CHECK(bytes_of(folder / "a.facets") == bytes_of(folder / "b.facets"));
  std::vector<Triangle3> back;
  REQUIRE(read_facets(folder / "a.facets", everywhere, back).ok());
  make_canonical(facets);
  make_canonical(back);
  CHECK(back == facets);
  const auto bricks = read_bricks(folder / "a.facets");
  REQUIRE(bricks.ok());
  CHECK(bricks->size() == 9);
}

TEST_CASE("A box gets the bricks whose facets come near it, however long they are") {
  const TemporaryFolder folder;
  REQUIRE(write_facets(folder / "a.facets", unit_bricks, some_facets()).ok());
  std::vector<Triangle3> some;
  REQUIRE(read_facets(folder / "a.facets", {{2.5, 0, 0}, {3.5, 1, 1}}, some).ok());
  CHECK(some.size() == 2);
  some.clear();
  REQUIRE(read_facets(folder / "a.facets", {{7, 5, 5}, {7.5, 5.5, 5.5}}, some).ok());
  CHECK(some.size() == 1);
}

TEST_CASE("A file that is cut short or changed is refused") {
  const TemporaryFolder folder;
  REQUIRE(write_facets(folder / "a.facets", unit_bricks, some_facets()).ok());
  const std::string whole = bytes_of(folder / "a.facets");
  std::string changed = whole;
  changed[40] = static_cast<char>(changed[40] ^ 1);
  for (const std::string& text :
       {whole.substr(0, whole.size() - 1), whole.substr(0, 10), changed, std::string()}) {
    std::ofstream(folder / "b.facets", std::ios::binary) << text;
    const auto read = read_bricks(folder / "b.facets");
    REQUIRE(!read.ok());
    CHECK(read.error().code == ErrorCode::bad_input);
  }
  CHECK(read_bricks(folder / "none.facets").error().code == ErrorCode::io);
}
