// The triangulation T as plain arrays: vertices with F, tetrahedra with neighbours and sides, Z once it has
// left T, and the reversible delta of an operation.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/labels.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// Where a vertex of T comes from.
enum class VertexKind : std::uint8_t {
  box,         ///< one of the eight corners of the loose bounding box (§2.2)
  sample,      ///< a sample of S (§2.3)
  containment, ///< placed where the facet certificate failed (core/README.md, N2)
  witness,     ///< the deepest point of a region that Z had on the wrong side
  topology,    ///< placed to mend a handle or a component (condition 4)
  zero         ///< a vertex of Z, F = 0 (§2.4.2)
};

/// A vertex of T. `value` is F at the vertex: + outside and - in any inside, scaled by the distance at box
/// corners (§5).
struct Vertex {
  Vec3 position;
  double value = 0;
  VertexKind kind = VertexKind::sample;
  bool alive = true;
  std::uint16_t sample_set = 0; ///< which sample set `sample` belongs to
  SampleId sample;              ///< valid when kind is sample
  std::int8_t room = 1;         ///< which inside it is in, where value < 0 (§4.2)
  /// +1 outside, -1, -2, … in the insides, 0 on Z.
  constexpr std::int8_t label() const { return label_of(value, room); }
  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Local vertices of the facet opposite each vertex of a positively oriented tetrahedron, counter-clockwise
/// seen from outside.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> outward_facets{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// How Z is held by the state.
enum class ZeroForm : std::uint8_t {
  interpolated, ///< the zeros of f inside tetrahedra (§2.3)
  embedded,     ///< facets of T between tetrahedra of different sides (§2.4.2)
  free          ///< facets of their own: T is gone (the last stage, on Z alone)
};

/// A tetrahedron: positively oriented, vertex ids ascending but for the last two (swapped where orientation
/// asks for it), neighbour i opposite vertex i, invalid on the hull. A dead slot has invalid vertices.
struct Tet {
  std::array<VertexId, 4> v;
  std::array<TetId, 4> neighbor;
  std::int8_t side = 0; ///< the label of its side once Z is embedded (§2.4.2), 0 before
  /// Bit i: the facet opposite vertex i lies between two sides but is no part of Z (§4.1). Both tetrahedra of
  /// a facet say the same.
  std::uint8_t dropped = 0;
  bool alive() const { return v[0].valid(); }
  /// The facet opposite vertex i, counter-clockwise seen from outside.
  std::array<VertexId, 3> facet(std::size_t i) const {
    const auto& f = outward_facets[i];
    return {v[f[0]], v[f[1]], v[f[2]]};
  }
  friend bool operator==(const Tet&, const Tet&) = default;
};

/// The same tetrahedron with its vertices in the order of Tet.
std::array<VertexId, 4> canonical_order(std::array<VertexId, 4> v);
/// Bits of the facets opposite vertices in one order, for the same vertices in another.
std::uint8_t reordered_bits(std::uint8_t bits, const std::array<VertexId, 4>& from,
                            const std::array<VertexId, 4>& to);

/// A facet of Z that has left T, counter-clockwise seen from the positive side. A dead slot has invalid
/// vertices.
struct ZeroFacet {
  std::array<VertexId, 3> v;
  bool alive() const { return v[0].valid(); }
  friend bool operator==(const ZeroFacet&, const ZeroFacet&) = default;
};

/// A facet of a delta: its slot and vertices.
struct FacetRecord {
  FacetId id;
  std::array<VertexId, 3> v;
  friend bool operator==(const FacetRecord&, const FacetRecord&) = default;
};

/// A tetrahedron of a delta: its slot, vertices, side and dropped facets.
struct TetRecord {
  TetId id;
  std::array<VertexId, 4> v;
  std::int8_t side = 0;
  std::uint8_t dropped = 0;
  friend bool operator==(const TetRecord&, const TetRecord&) = default;
};

/// What one operation changes; apply and undo are exact inverses. Slots of removed tetrahedra may be reused
/// by added ones.
struct Delta {
  struct ValueChange {
    VertexId vertex;
    double before = 0, after = 0;
  };
  /// All tetrahedra at a vertex that moves are among `removed` and `added`, so that whoever follows a delta
  /// learns from them what changed.
  struct Move {
    VertexId vertex;
    Vec3 before, after;
  };
  struct SampleSetChange {
    std::uint16_t before = 0, after = 0;
  };
  struct SideChange {
    TetId tet;
    std::int8_t before = 0, after = 0;
  };
  struct DroppedChange {
    TetId tet;
    std::uint8_t before = 0, after = 0;
  };
  struct FormChange {
    ZeroForm before = ZeroForm::interpolated, after = ZeroForm::interpolated;
  };
  std::vector<Vertex> added_vertices;    ///< appended: their ids follow the last vertex
  std::vector<VertexId> killed_vertices; ///< alive -> dead (collapses)
  std::vector<ValueChange> values;
  std::vector<Move> moves;
  std::vector<TetRecord> removed, added;
  /// Length of the slot array before a delta with `removed` or `added`: what undo restores. Slots added
  /// beyond it are new.
  std::uint32_t slots_before = 0;
  std::vector<SideChange> sides;      ///< of tetrahedra that are neither removed nor added
  std::vector<DroppedChange> dropped; ///< the same for their dropped facets
  std::vector<FacetRecord> removed_facets, added_facets;
  std::uint32_t facet_slots_before = 0; ///< the same for facets
  std::vector<LabelPair> facet_labels;  ///< what Complex::facet_labels becomes as Z leaves T
  std::optional<SampleSetChange> sample_set;
  std::optional<FormChange> form;

  bool empty() const;
  std::size_t memory_bytes() const;
};

/// T and Z at one step. Equality is bitwise: replay and undo(apply) are tested with it.
struct Complex {
  std::vector<Vertex> vertices;
  std::vector<Tet> tets;         ///< slots; dead ones are on no list, the free list is the refiner's business
  std::vector<ZeroFacet> facets; ///< slots of Z once it is free
  /// What the facets of a free Z between rooms lie between, by slot, which no later change of a facet alters
  /// (§4.2). Empty where there is one inside.
  std::vector<LabelPair> facet_labels;
  ZeroForm form = ZeroForm::interpolated;

  const Vec3& position(VertexId v) const { return vertices[v.index()].position; }
  double value(VertexId v) const { return vertices[v.index()].value; }
  std::int8_t label(VertexId v) const { return vertices[v.index()].label(); }
  /// The two sides of a facet of a free Z.
  LabelPair labels(FacetId f) const {
    return f.index() < facet_labels.size() ? facet_labels[f.index()] : LabelPair{+1, -1};
  }
  const Tet& tet(TetId t) const { return tets[t.index()]; }
  std::array<Vec3, 4> positions(TetId t) const;
  std::array<double, 4> values(TetId t) const;
  TetLabels labels(TetId t) const;
  /// Whether t carries Z: it has vertices of several labels (those on Z count as none).
  bool heterogeneous(TetId t) const;
  /// Whether the facet opposite vertex i of t is part of an embedded Z: it lies between two sides and is not
  /// dropped.
  bool on_zero_set(TetId t, std::size_t i) const;
  /// Whether t is part of Γ: it carries Z, or has a vertex on it.
  bool in_gamma(TetId t) const;
  std::size_t alive_tets() const;
  std::size_t memory_bytes() const;

  /// Applies the delta and rewires neighbours across the hole's boundary. Trailing dead slots stay; undo
  /// restores the array length that the delta recorded, so that undo(apply) is the identity. Takes time
  /// proportional to the delta, and to T only where facets are laid bare or hull facets are covered.
  void apply(const Delta& delta);
  void undo(const Delta& delta);

  friend bool operator==(const Complex&, const Complex&) = default;
};

/// f on a tetrahedron as an affine function: f(x) = value0 + gradient·(x − origin). Pure; degenerate input
/// gives non-finite values.
struct AffineFunction {
  Vec3 origin, gradient;
  double value0 = 0;
  double operator()(Vec3 x) const { return value0 + dot(gradient, x - origin); }
};
AffineFunction interpolate(const std::array<Vec3, 4>& p, const std::array<double, 4>& f);

} // namespace isoscope
