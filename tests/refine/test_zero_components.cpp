// Components of Z that are followed through changes of T, and those that nothing asks for.
#include "mesh/zero_set.h"
#include "refine/pockets.h"
#include "refine/zero_components.h"

#include <doctest/doctest.h>

#include <random>

using namespace isoscope;

namespace {

/// T in a cube of side 8 whose corners are outside.
struct Box {
  Delaunay delaunay;
  Complex complex;
  ZeroComponents components;

  Box() {
    std::vector<Vertex> corners;
    for (unsigned k = 0; k < 8; ++k)
      corners.push_back(vertex({k & 1u ? 8.0 : 0, k & 2u ? 8.0 : 0, k & 4u ? 8.0 : 0}, +1, VertexKind::box));
    complex.apply(delaunay.start(corners));
  }
  static Vertex vertex(Vec3 position, int label, VertexKind kind) {
    Vertex v;
    v.position = position;
    v.value = label;
    v.kind = kind;
    return v;
  }
  void insert(Vec3 position, int label, VertexKind kind = VertexKind::sample) {
    const auto delta = delaunay.insert(vertex(position, label, kind), {});
    REQUIRE(delta.has_value());
    complex.apply(*delta);
    components.replace(complex, delta->removed, delta->added);
  }
  std::size_t count() { return components.count(complex, delaunay); }
  VertexId last() const { return VertexId(static_cast<std::uint32_t>(complex.vertices.size() - 1)); }
};

} // namespace

TEST_CASE("components of Z: none, one around a point, two, and one again once they are joined") {
  Box box;
  CHECK(box.count() == 0);
  box.insert({2, 4, 4}, -1);
  CHECK(box.count() == 1);
  box.insert({4, 4, 4}, +1);
  box.insert({4, 3, 4}, +1);
  box.insert({4, 5, 4}, +1);
  box.insert({4, 4, 3}, +1);
  box.insert({4, 4, 5}, +1);
  box.insert({6, 4, 4}, -1);
  CHECK(box.count() == extract_zero_set(box.complex).components.size());
  // From one to the other around what lies between.
  for (const double x : {2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5}) box.insert({x, 6.5, 4}, -1);
  box.insert({2, 5.5, 4}, -1);
  box.insert({6, 5.5, 4}, -1);
  CHECK(box.count() == 1);
}

TEST_CASE("components that are followed are those that all of Z has") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0.1, 7.9);
  Box box;
  std::size_t most = 0;
  for (int i = 0; i < 600; ++i) {
    // Few of one label at first, then as many of both.
    const bool inside = random() % (i < 300 ? 8u : 2u) == 0;
    box.insert({coordinate(random), coordinate(random), coordinate(random)}, inside ? -1 : +1);
    const std::size_t all = extract_zero_set(box.complex).components.size();
    REQUIRE(box.count() == all);
    most = std::max(most, all);
  }
  CHECK(most > 5);
}

TEST_CASE("a sphere of Z is a pocket where its inside has neither samples nor witnesses") {
  const auto pockets = [](VertexKind kind, VertexKind other) {
    Box box;
    // A body with samples, far from a point or two.
    box.insert({1, 1, 1}, -1);
    for (const Vec3 p : {Vec3{4, 4, 3}, {4, 3, 4}, {3, 4, 4}, {5, 5, 3}, {5, 3, 5}, {3, 5, 5}, {4, 4, 4}})
      box.insert(p, +1);
    box.insert({6, 6, 6}, -1, kind);
    const VertexId first = box.last();
    box.insert({6.25, 6, 6}, -1, other);
    CHECK(extract_zero_set(box.complex).components.size() == 2);
    const auto found = find_pockets(box.complex);
    if (!found.empty()) CHECK(found.front() == std::vector{first, box.last()});
    return found.size();
  };
  CHECK(pockets(VertexKind::containment, VertexKind::topology) == 1);
  CHECK(pockets(VertexKind::containment, VertexKind::sample) == 0);
  CHECK(pockets(VertexKind::witness, VertexKind::topology) == 0);
}

TEST_CASE("a pocket of the outside within a body") {
  Box box;
  for (unsigned k = 0; k < 27; ++k) {
    const Vec3 p{2.0 + 2 * (k % 3), 2.0 + 2 * (k / 3 % 3), 2.0 + 2 * (k / 9)};
    if (k == 13)
      box.insert(p, +1, VertexKind::topology);
    else
      box.insert(p, -1, VertexKind::sample);
  }
  CHECK(extract_zero_set(box.complex).components.size() == 2);
  const auto found = find_pockets(box.complex);
  REQUIRE(found.size() == 1);
  REQUIRE(found.front().size() == 1);
  CHECK(box.complex.position(found.front().front()) == Vec3{4, 4, 4});
}
