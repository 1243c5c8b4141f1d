// Insertion on random, lattice and cospherical points: valid, Delaunay, reproducible, reversible.
#include "mesh/predicates.h"
#include "mesh/support.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace isoscope;
using namespace isoscope::test;

namespace {

struct Family {
  const char* name;
  Box3 box;
  std::vector<Vec3> points;
};

std::vector<Family> families() {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}}, lattice{{0, 0, 0}, {9, 9, 9}}, wide{{-30, -30, -30}, {30, 30, 30}};
  std::vector<Vec3> flat = random_points(300, unit, 5);
  for (Vec3& p : flat) p.z = 0.5;
  return {{"random", unit, random_points(1500, unit, 1)},
          {"lattice with the box's corners, edges and faces", lattice, lattice_points(10, 2)},
          {"cospherical", wide, cospherical_points(3)},
          {"coplanar", unit, flat}};
}

void check_valid(const Complex& c) {
  const auto defects = check_complex(c);
  for (const Defect& d : defects) MESSAGE(d.what);
  CHECK(defects.empty());
  CHECK(check_delaunay(c).empty());
}

double volume(const Complex& c) {
  double sum = 0;
  for (std::size_t i = 0; i < c.tets.size(); ++i) {
    if (!c.tets[i].alive()) continue;
    const auto p = c.positions(TetId(i));
    sum += dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6;
  }
  return sum;
}

} // namespace

TEST_CASE("every family gives a valid Delaunay triangulation of the box") {
  for (const Family& f : families()) {
    INFO(f.name);
    const Grown g = grow(f.box, f.points);
    check_valid(g.complex);
    CHECK(g.complex.vertices.size() + g.refused == f.points.size() + 8);
    const Vec3 e = f.box.extent();
    CHECK(volume(g.complex) == doctest::Approx(e.x * e.y * e.z).epsilon(1e-12));
  }
}

TEST_CASE("box corners are refused, points on the box's surface are not, points outside are") {
  Grown g(Box3{{0, 0, 0}, {1, 1, 1}});
  const Complex before = g.complex;
  CHECK_FALSE(g.insert({1, 0, 1}));
  CHECK_FALSE(g.insert({0.5, 0.5, 1.5}));
  CHECK(g.complex == before);
  CHECK(g.insert({0.5, 0.5, 1}));
  CHECK_FALSE(g.insert({0.5, 0.5, 1}));
  CHECK(g.insert({0.25, 0, 0}));
  check_valid(g.complex);
}

TEST_CASE("coplanar corners give no tetrahedra and take no points") {
  Delaunay d;
  const Box3 flat{{0, 0, 0}, {1, 1, 0}};
  const auto corners = box_corners(flat);
  const Delta start = d.start(std::span(corners).first(4));
  CHECK(start.added.empty());
  CHECK_FALSE(d.insert({{0.5, 0.5, 0}, 1, VertexKind::sample, true, 0, {}}, TetId{}));
}

TEST_CASE("undoing every insertion retraces the states bit by bit, and replay repeats them") {
  for (const Family& f : families()) {
    INFO(f.name);
    const Grown g = grow(f.box, f.points);
    Complex c;
    std::vector<Complex> states{c};
    for (std::size_t i = 0; i < g.deltas.size(); ++i) {
      c.apply(g.deltas[i]);
      if (i % 100 == 0) states.push_back(c);
    }
    CHECK(c == g.complex);
    bool same = true;
    for (std::size_t i = g.deltas.size(); i-- > 0;) {
      if (i % 100 == 0) {
        same = same && c == states.back();
        states.pop_back();
      }
      const Complex after = i % 50 == 0 ? c : Complex{};
      c.undo(g.deltas[i]);
      if (i % 50 == 0) {
        Complex again = c;
        again.apply(g.deltas[i]);
        same = same && again == after;
      }
    }
    CHECK(same);
    CHECK(c == Complex{});
  }
}

TEST_CASE("slots do not depend on the hint") {
  for (const Family& f : families()) {
    INFO(f.name);
    const Grown g = grow(f.box, f.points);
    Delaunay d;
    Complex c;
    c.apply(d.start(box_corners(f.box)));
    Random random(17);
    for (const Vec3 p : f.points) {
      TetId hint;
      while (!hint.valid()) {
        const TetId t(random.below(c.tets.size()));
        if (c.tet(t).alive()) hint = t;
      }
      if (const auto delta = d.insert({p, 1, VertexKind::sample, true, 0, {}}, hint)) c.apply(*delta);
    }
    CHECK(c == g.complex);
  }
}

TEST_CASE("removed is ascending by slot, added by vertices, and freed slots come back last first") {
  const Grown g = grow(Box3{{0, 0, 0}, {1, 1, 1}}, random_points(200, {{0, 0, 0}, {1, 1, 1}}, 4));
  for (const Delta& d : g.deltas) {
    CHECK(std::is_sorted(d.removed.begin(), d.removed.end(), [](auto& a, auto& b) { return a.id < b.id; }));
    CHECK(std::is_sorted(d.added.begin(), d.added.end(), [](auto& a, auto& b) {
      auto x = a.v, y = b.v;
      std::sort(x.begin(), x.end());
      std::sort(y.begin(), y.end());
      return x < y;
    }));
    if (!d.removed.empty()) CHECK(d.added.front().id == d.removed.back().id);
  }
}

TEST_CASE("queries agree with exhaustive search, ties included") {
  const Grown g = grow(Box3{{0, 0, 0}, {9, 9, 9}}, lattice_points(6, 8));
  const Complex& c = g.complex;
  Random random(9);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p{double(random.below(20)) / 2, double(random.below(20)) / 2, double(random.below(20)) / 2};
    TetId expected;
    for (std::size_t i = 0; i < c.tets.size(); ++i) {
      if (!c.tets[i].alive()) continue;
      const auto q = c.positions(TetId(i));
      const bool inside = orientation(q[1], q[3], q[2], p) >= 0 && orientation(q[0], q[2], q[3], p) >= 0 &&
                          orientation(q[0], q[3], q[1], p) >= 0 && orientation(q[0], q[1], q[2], p) >= 0;
      if (inside && !expected.valid()) expected = TetId(i);
      if (k == 0) {
        const Vec3 m = g.delaunay.circumcenter(TetId(i));
        for (const Vec3 corner : q) CHECK(distance(m, corner) == doctest::Approx(distance(m, q[0])));
        CHECK(g.delaunay.strictly_inside_circumsphere(TetId(i), 0.25 * (q[0] + q[1] + q[2] + q[3])));
        CHECK_FALSE(g.delaunay.strictly_inside_circumsphere(TetId(i), q[2]));
      }
    }
    CHECK(g.delaunay.locate(p, g.some_tet()) == expected);
    VertexId nearest(0);
    for (std::size_t v = 1; v < c.vertices.size(); ++v) {
      if (squared_length(c.vertices[v].position - p) < squared_length(c.position(nearest) - p))
        nearest = VertexId(v);
    }
    CHECK(g.delaunay.nearest_vertex(p, g.some_tet()) == nearest);
  }
  CHECK_FALSE(g.delaunay.locate({-1, 4, 4}, g.some_tet()).valid());
}

TEST_CASE("speed of insertion, apply and undo") {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  using Clock = std::chrono::steady_clock;
  const auto microseconds = [](auto a, auto b) {
    return std::chrono::duration<double, std::micro>(b - a).count();
  };
  const auto t0 = Clock::now();
  const Grown g = grow(unit, random_points(5000, unit, 1));
  const auto t1 = Clock::now();
  Complex c;
  for (const Delta& d : g.deltas) c.apply(d);
  const auto t2 = Clock::now();
  for (std::size_t i = g.deltas.size(); i-- > 0;) c.undo(g.deltas[i]);
  const auto t3 = Clock::now();
  const double n = static_cast<double>(g.deltas.size());
  MESSAGE("insert + apply " << microseconds(t0, t1) / n << " us, apply " << microseconds(t1, t2) / n
                            << " us, undo " << microseconds(t2, t3) / n << " us");
  CHECK(c == Complex{});
}
