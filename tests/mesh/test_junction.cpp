// Z inside tetrahedra of three labels and four.
#include "mesh/junction.h"
#include "mesh/predicates.h"
#include "mesh/zero_set.h"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <set>

using namespace isoscope;

namespace {

const std::array<VertexId, 4> ids{VertexId(0u), VertexId(1u), VertexId(2u), VertexId(3u)};
const std::array<double, 4> plain{1, 1, 1, 1};

std::array<Vec3, 4> random_tetrahedron(std::mt19937_64& random) {
  std::uniform_real_distribution<double> in(-1, 1);
  for (;;) {
    std::array<Vec3, 4> p;
    for (Vec3& v : p) v = {in(random), in(random), in(random)};
    const double volume = dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]));
    if (std::abs(volume) < 0.1) continue;
    if (orientation(p[0], p[1], p[2], p[3]) < 0) std::swap(p[2], p[3]);
    return p;
  }
}

double weight(const std::array<Vec3, 4>& p, std::size_t k, Vec3 x) {
  std::array<double, 4> f{};
  f[k] = 1;
  return interpolate(p, f)(x);
}

} // namespace

TEST_CASE("labels are counted, and functions seen from each") {
  CHECK(label_count({1, 1, 1, 1}) == 1);
  CHECK(label_count({0, 0, 0, 0}) == 0);
  CHECK(label_count({1, -2, 0, -2}) == 2);
  CHECK(label_count({-3, -2, -1, 1}) == 4);
  CHECK(outer_labels({-3, -2, 0, -1}) == LabelPair{-1, -3});
  CHECK(label_of(7, 3) == 1);
  CHECK(label_of(-1, 3) == -3);
  CHECK(label_of(0, 3) == 0);
  CHECK(seen_from(-2, {-1, -1, 7, -1}, {-2, -1, 1, -2}) == std::array<double, 4>{1, -1, -7, 1});
  for (const int label : {1, -1, -5})
    CHECK(place_of(label) == (label > 0 ? 0u : static_cast<std::size_t>(-label)));
}

TEST_CASE("each label's part is bounded by a closed surface in which it weighs no more than half") {
  std::mt19937_64 random(3);
  for (const TetLabels& labels :
       {TetLabels{1, -1, -2, -2}, {-1, 1, -1, -2}, {-1, -2, -3, 1}, {-4, -4, -1, -2}}) {
    for (int round = 0; round < 50; ++round) {
      const auto p = random_tetrahedron(random);
      const Junction junction = make_junction(p, plain, labels, ids);
      CHECK(junction.count == (label_count(labels) == 3 ? 8 : 12));
      std::map<std::pair<std::uint8_t, std::uint8_t>, int> uses;
      for (std::size_t i = 0; i < junction.count; ++i) {
        const Junction::Facet& f = junction.facets[i];
        CHECK(f.labels.front > f.labels.back);
        const Vec3 a = junction.position[f.corner[0]], b = junction.position[f.corner[1]],
                   c = junction.position[f.corner[2]];
        for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(f.corner[k], f.corner[(k + 1) % 3])];
        // The front label's corners lie before the facet's plane, at least one of them.
        bool before = false, behind = false;
        for (std::size_t k = 0; k < 4; ++k) {
          const double side = dot(cross(b - a, c - a), p[k] - a);
          before = before || (labels[k] == f.labels.front && side > 0);
          behind = behind || (labels[k] == f.labels.back && side < 0);
        }
        CHECK(before);
        CHECK(behind);
        for (const std::int8_t label : {f.labels.front, f.labels.back})
          for (const Vec3 x : {a, b, c}) {
            double own = 0;
            for (std::size_t k = 0; k < 4; ++k)
              if (labels[k] == label) own += weight(p, k, x);
            CHECK(own <= 0.5 + 1e-12);
          }
      }
      // Edges inside the tetrahedron bound two facets, or three where a facet's three labels meet.
      for (const auto& [edge, count] : uses) {
        if (edge.second != Junction::center_corner) continue;
        const bool middle = edge.first >= Junction::first_facet;
        CHECK(count == (middle ? 3 : 2));
      }
    }
  }
}

TEST_CASE("tetrahedra agree on their common facet to the last bit, however they number it") {
  std::mt19937_64 random(11);
  for (int round = 0; round < 200; ++round) {
    const auto p = random_tetrahedron(random);
    const Junction one = make_junction(p, plain, {1, -1, -2, -3}, ids);
    // The same facet opposite corner 3 seen from a tetrahedron with its corners in another order.
    const std::array<Vec3, 4> q{p[2], p[0], p[1], p[3]};
    const std::array<VertexId, 4> order{ids[2], ids[0], ids[1], VertexId(9u)};
    const Junction other = make_junction(q, plain, {-2, 1, -1, -1}, order);
    CHECK(one.position[Junction::first_facet + 3] == other.position[Junction::first_facet + 3]);
  }
}

TEST_CASE("two labels leave one polygon, whichever they are") {
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}, Vec3{0, 0, 4}};
  std::vector<LabelledTriangle> sides, rooms, none;
  append_zero_triangles(p, {1, -1, -1, 1}, {1, -1, -1, 1}, ids, sides);
  append_zero_triangles(p, {-1, -1, -1, -1}, {-1, -2, -2, -1}, ids, rooms);
  append_zero_triangles(p, {-1, -1, -1, 0}, {-1, -2, -3, 0}, ids, none);
  REQUIRE(sides.size() == 2);
  REQUIRE(rooms.size() == 2);
  CHECK(none.empty());
  for (std::size_t i = 0; i < 2; ++i) CHECK(sides[i].corners == rooms[i].corners);
  CHECK(rooms[0].labels == LabelPair{-1, -2});
}
