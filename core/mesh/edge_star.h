// An edge of T with its whole neighbourhood as a value: what the evaluation of a collapse looks at, and
// nothing else (core/README.md, D2).
#pragma once

#include "base/ids.h"
#include "base/segment.h"
#include "mesh/complex.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Which stage an edge belongs to (§2.4).
enum class EdgeKind : std::uint8_t {
  gamma, ///< an edge of ∂Γ: both ends of one label, on a facet between Γ and the rest (§2.4.1)
  zero,  ///< an edge of Z (§2.4.3)
  mixed, ///< between a vertex of Z and one of Γ (§2.4.4)
  other  ///< any other edge: never collapsed
};

/// A copy of the tetrahedra at the ends of an edge. Vertices are numbered locally: 0 is the end that stays, 1
/// the end that goes, the others follow by ascending id.
struct EdgeStar {
  struct StarVertex {
    VertexId id;
    Vec3 position;
    double value = 0;
    VertexKind kind = VertexKind::sample;
    std::int8_t room = 1;
    std::int8_t label() const { return label_of(value, room); }
  };
  struct StarTet {
    TetId id;
    std::array<std::uint16_t, 4> v; ///< local numbers, positively oriented
    std::int8_t side = 0;           ///< its label once Z is embedded, 0 before
    bool at_a = false, at_b = false;
    std::uint8_t dropped = 0;                  ///< as in Tet, by the local vertices
    bool ring() const { return at_a && at_b; } ///< vanishes with the edge
  };
  /// A sample that lies in the star, with its label; filled in sampled mode only.
  struct StarSample {
    SampleId id;
    Vec3 position;
    std::int8_t label = 0;
  };

  ZeroForm form = ZeroForm::interpolated;
  std::vector<StarVertex> vertices;
  std::vector<StarTet> tets; ///< ascending by slot
  std::vector<StarSample> samples;
  /// Facets of Z in the 1-ring or 2-ring of the edge, whose planes make the error (§2.4).
  std::vector<Triangle3> cost_facets;
  std::vector<Segment3> cost_borders; ///< edges of the border of Z as near, whose lines are in the error too
  /// Of an edge of the border: others along it that stay as they are, as far as they may be near the rim that
  /// its ends are near to.
  std::vector<Segment3> border_beyond;

  VertexId a() const { return vertices[0].id; }
  VertexId b() const { return vertices[1].id; }
  std::array<Vec3, 4> positions(const StarTet& t) const;
  std::array<double, 4> values(const StarTet& t) const;
  TetLabels labels(const StarTet& t) const;
  std::array<VertexId, 4> ids(const StarTet& t) const;
  /// The corners of a tetrahedron once both ends lie at `target`.
  std::array<Vec3, 4> positions_after(const StarTet& t, Vec3 target) const;
  EdgeKind kind() const;

 private:
  EdgeKind embedded_kind() const;
};

/// Which sheet a facet between two sides belongs to.
struct FacetKind {
  std::int8_t low = 0, high = 0; ///< the labels of its sides, low < high
  bool dropped = false;          ///< it is no part of Z
  friend bool operator==(const FacetKind&, const FacetKind&) = default;
};

/// A facet between two sides in an embedded star that has an end of the edge, counter-clockwise seen from the
/// larger of its labels; local numbers.
struct StarFacet {
  std::array<std::uint16_t, 3> v;
  LabelPair labels;
  bool at_a = false, at_b = false;
  bool dropped = false; ///< it is no part of Z
  FacetKind kind() const { return {labels.back, labels.front, dropped}; }
  bool ring() const { return at_a && at_b; } ///< vanishes with the edge
};
/// The facets between two sides at the ends of the edge; empty unless Z is embedded.
std::vector<StarFacet> side_facets(const EdgeStar& star);
/// Those of them that are of Z.
std::vector<StarFacet> zero_facets(const EdgeStar& star);

} // namespace isoscope
