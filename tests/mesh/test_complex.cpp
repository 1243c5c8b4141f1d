// Deltas on hand-made stars: neighbours, undo as the identity, growth from nothing and back.
#include "mesh/complex.h"
#include "mesh/incidence.h"
#include "mesh/validity.h"
#include "mesh/zero_set.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

VertexId vertex(int i) {
  return VertexId(i);
}
TetId tet(int i) {
  return TetId(i);
}
TetRecord record(int id, int a, int b, int c, int d) {
  return {tet(id), {vertex(a), vertex(b), vertex(c), vertex(d)}};
}
Vertex at(double x, double y, double z) {
  return {{x, y, z}, 1, VertexKind::box, true, 0, {}};
}

/// One tetrahedron from nothing.
Delta one_tet() {
  Delta d;
  d.added_vertices = {at(0, 0, 0), at(4, 0, 0), at(0, 4, 0), at(0, 0, 4)};
  d.added = {record(0, 0, 1, 2, 3)};
  return d;
}

/// Splits it in four about (1, 1, 1); slot 0 is reused.
Delta split() {
  Delta d;
  d.slots_before = 1;
  d.added_vertices = {at(1, 1, 1)};
  d.removed = {record(0, 0, 1, 2, 3)};
  d.added = {record(0, 0, 1, 2, 4), record(1, 0, 1, 4, 3), record(2, 0, 2, 3, 4), record(3, 1, 2, 4, 3)};
  return d;
}

} // namespace

TEST_CASE("a complex grows from nothing, and undo gives nothing back") {
  Complex c;
  c.apply(one_tet());
  CHECK(check_complex(c).empty());
  CHECK(c.alive_tets() == 1);
  CHECK(c.tet(tet(0)).neighbor == std::array<TetId, 4>{});
  c.undo(one_tet());
  CHECK(c == Complex{});
}

TEST_CASE("a star of four has its neighbours across the facets about its centre") {
  Complex c;
  c.apply(one_tet());
  const Complex before = c;
  const Delta d = split();
  c.apply(d);
  CHECK(check_complex(c).empty());
  CHECK(c.alive_tets() == 4);
  int inner = 0, hull = 0;
  for (const Tet& t : c.tets) {
    for (const TetId n : t.neighbor) (n.valid() ? inner : hull) += 1;
  }
  CHECK(inner == 12);
  CHECK(hull == 4);
  c.undo(d);
  CHECK(c == before);
}

TEST_CASE("removing lays facets bare and adding covers them, both ways") {
  Complex c;
  c.apply(one_tet());
  c.apply(split());
  const Complex before = c;
  Delta bare;
  bare.slots_before = 4;
  bare.removed = {split().added[0], split().added[2]};
  c.apply(bare);
  CHECK(check_complex(c).empty());
  CHECK(c.alive_tets() == 2);
  CHECK(c.tets[0] == Tet{});
  const Complex two = c;
  Delta cover;
  cover.slots_before = 4;
  cover.added = {{tet(5), split().added[2].v}};
  c.apply(cover);
  CHECK(check_complex(c).empty());
  CHECK(c.alive_tets() == 3);
  CHECK(c.tets.size() == 6);
  c.undo(cover);
  CHECK(c == two);
  c.undo(bare);
  CHECK(c == before);
}

TEST_CASE("clearing everything and undoing it is the identity") {
  Complex c;
  c.apply(one_tet());
  const Complex before = c;
  Delta clear;
  clear.slots_before = 1;
  clear.removed = {record(0, 0, 1, 2, 3)};
  clear.killed_vertices = {vertex(0), vertex(1), vertex(2), vertex(3)};
  c.apply(clear);
  CHECK(c.alive_tets() == 0);
  CHECK(check_complex(c).empty());
  CHECK_FALSE(c.vertices[2].alive);
  c.undo(clear);
  CHECK(c == before);
}

TEST_CASE("values and moves go there and back, also when one vertex changes twice") {
  Complex c;
  c.apply(one_tet());
  const Complex before = c;
  Delta d;
  d.values = {{vertex(1), 1, -3}, {vertex(1), -3, 7}};
  d.moves = {{vertex(3), {0, 0, 4}, {0, 0, 5}}, {vertex(3), {0, 0, 5}, {0, 1, 5}}};
  c.apply(d);
  CHECK(c.value(vertex(1)) == 7);
  CHECK(c.position(vertex(3)) == Vec3{0, 1, 5});
  CHECK(c.tets == before.tets);
  c.undo(d);
  CHECK(c == before);
}

TEST_CASE("a dropped facet is no part of Z, goes there and back, and keeps its vertex in any order") {
  Complex c;
  c.apply(one_tet());
  Delta sided = split();
  sided.added[0].side = +1;
  for (int i = 1; i < 4; ++i) sided.added[static_cast<std::size_t>(i)].side = -1;
  sided.form = {ZeroForm::interpolated, ZeroForm::embedded};
  c.apply(sided);
  CHECK(extract_zero_set(c).polygons.size() == 3);
  const Complex before = c;

  // The facet 0-1-4, opposite vertex 2 of the first and vertex 3 of the second.
  REQUIRE(c.tet(tet(0)).neighbor[2] == tet(1));
  REQUIRE(c.tet(tet(1)).neighbor[3] == tet(0));
  Delta drop;
  drop.dropped = {{tet(0), 0, 4}, {tet(1), 0, 8}};
  CHECK_FALSE(drop.empty());
  c.apply(drop);
  CHECK(check_complex(c).empty());
  CHECK_FALSE(c.on_zero_set(tet(0), 2));
  CHECK_FALSE(c.on_zero_set(tet(1), 3));
  CHECK(c.on_zero_set(tet(0), 1));
  CHECK(extract_zero_set(c).polygons.size() == 2);
  c.undo(drop);
  CHECK(c == before);

  // The same by tetrahedra that are replaced.
  Delta replaced;
  replaced.slots_before = 4;
  replaced.removed = {{tet(0), c.tet(tet(0)).v, 1, 0}, {tet(1), c.tet(tet(1)).v, -1, 0}};
  replaced.added = {{tet(0), c.tet(tet(0)).v, 1, 4}, {tet(1), c.tet(tet(1)).v, -1, 8}};
  c.apply(replaced);
  CHECK(extract_zero_set(c).polygons.size() == 2);
  c.tets[1].dropped = 0;
  CHECK(check_complex(c).size() == 2); // said once from each side
  c.tets[1].dropped = 8;
  c.undo(replaced);
  CHECK(c == before);

  const std::array<VertexId, 4> from{vertex(7), vertex(3), vertex(5), vertex(1)};
  CHECK(reordered_bits(1, from, canonical_order(from)) == (from[0] == canonical_order(from)[3] ? 8 : 4));
  CHECK(reordered_bits(0, from, canonical_order(from)) == 0);
  CHECK(reordered_bits(15, from, canonical_order(from)) == 15);
  CHECK(reordered_bits(reordered_bits(6, from, canonical_order(from)), canonical_order(from), from) == 6);
}

TEST_CASE("the checks find what is wrong") {
  Complex c;
  c.apply(one_tet());
  Complex flipped = c;
  std::swap(flipped.tets[0].v[2], flipped.tets[0].v[3]);
  CHECK(check_complex(flipped).size() == 1);
  Complex lonely = c;
  lonely.tets[0].neighbor[1] = tet(0);
  CHECK_FALSE(check_complex(lonely).empty());
  Complex dead = c;
  dead.vertices[1].alive = false;
  CHECK_FALSE(check_complex(dead).empty());
  Complex dirty = c;
  dirty.tets.emplace_back().neighbor[0] = tet(0);
  CHECK_FALSE(check_complex(dirty).empty());
}

TEST_CASE("interpolation is affine and exact at simple corners") {
  const AffineFunction f =
      interpolate({Vec3{1, 0, 0}, Vec3{3, 0, 0}, Vec3{1, 2, 0}, Vec3{1, 0, 2}}, {1, 5, -3, 3});
  CHECK(f.gradient == Vec3{2, -2, 1});
  CHECK(f(Vec3{1, 0, 0}) == 1);
  CHECK(f(Vec3{3, 0, 0}) == 5);
  CHECK(f(Vec3{2, 1, 1}) == 2);
}

TEST_CASE("a vertex with F = 0 has no sign") {
  Complex c;
  c.apply(one_tet());
  CHECK_FALSE(c.heterogeneous(tet(0)));
  c.vertices[0].value = 0;
  CHECK_FALSE(c.heterogeneous(tet(0)));
  c.vertices[1].value = -1;
  CHECK(c.heterogeneous(tet(0)));
}

TEST_CASE("an edge of Z with four tetrahedra turns within its two facets, where others are positive there") {
  // Two of its ends, what is opposite to it in Z, and an apex on each side.
  const auto around_edge = [](Vec3 c, Vec3 d) {
    Complex complex;
    complex.form = ZeroForm::embedded;
    Delta all;
    all.added_vertices = {at(-1, 0, 0),      at(1, 0, 0), at(c.x, c.y, c.z),
                          at(d.x, d.y, d.z), at(0, 0, 1), at(0, 0, -1)};
    for (std::size_t v = 0; v < 4; ++v) all.added_vertices[v].value = 0;
    all.added_vertices[5].value = -1;
    all.added = {{tet(0), canonical_order({vertex(0), vertex(1), vertex(4), vertex(2)}), 1, 0},
                 {tet(1), canonical_order({vertex(0), vertex(1), vertex(3), vertex(4)}), 1, 0},
                 {tet(2), canonical_order({vertex(0), vertex(1), vertex(5), vertex(3)}), -1, 0},
                 {tet(3), canonical_order({vertex(0), vertex(1), vertex(2), vertex(5)}), -1, 0}};
    for (TetRecord& t : all.added) {
      const auto p = [&](std::size_t k) { return all.added_vertices[t.v[k].index()].position; };
      if (dot(cross(p(1) - p(0), p(2) - p(0)), p(3) - p(0)) < 0) std::swap(t.v[2], t.v[3]);
    }
    complex.apply(all);
    return complex;
  };
  // The third corner of a facet is a hair beside the edge: no double lies between them.
  Complex flat = around_edge({0.25, 1e-300, 0}, {0, -1, 0});
  REQUIRE(check_complex(flat).empty());
  const Complex before = flat;
  const auto turned = flip_delta(flat, Incidence(flat), vertex(0), vertex(1));
  REQUIRE(turned.has_value());
  flat.apply(*turned);
  CHECK(check_complex(flat).empty());
  const Incidence after(flat);
  CHECK(after.adjacent(flat, vertex(2), vertex(3)));
  CHECK_FALSE(after.adjacent(flat, vertex(0), vertex(1)));
  std::size_t zero_facets = 0;
  for (std::size_t t = 0; t < flat.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) zero_facets += flat.on_zero_set(tet(static_cast<int>(t)), k);
  CHECK(zero_facets == 4); // two, from both their sides
  flat.undo(*turned);
  CHECK(flat == before);
  // Beyond an end of the edge nothing would be positive.
  const Complex beside = around_edge({3, 1, 0}, {0, -1, 0});
  REQUIRE(check_complex(beside).empty());
  CHECK_FALSE(flip_delta(beside, Incidence(beside), vertex(0), vertex(1)).has_value());
}
