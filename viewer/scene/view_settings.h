// What is shown and how, as plain data: panels and scripts edit it, the renderer reads it, view files store
// it.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "questions/zero_map_kind.h"

#include <array>
#include <cstdint>

namespace isoscope {

/// One layer's visibility and opacity in [0, 1].
struct LayerSettings {
  bool visible = true;
  float opacity = 1.0f;
  bool shown() const { return visible && opacity > 0; }
  friend bool operator==(const LayerSettings&, const LayerSettings&) = default;
};

/// Which tetrahedra are drawn.
struct TetFilter {
  bool carry_zero_set = false, violate_1 = false, violate_2 = false, violate_3 = true, changed = true;
  bool all = false;
  bool box = false;         ///< also those with a corner of the bounding box
  std::uint32_t recent = 1; ///< operations back for `changed`
  /// Once Z is embedded: tetrahedra of both sides, or of one.
  enum class Sides : std::uint8_t { both, outer, inner };
  Sides sides = Sides::both;
  float shrink = 0.85f; ///< display shrink about the centroid in (0, 1]; not condition 3's factor
  friend bool operator==(const TetFilter&, const TetFilter&) = default;
};

/// How the scene is clipped.
struct ClipSettings {
  enum class Shape : std::uint8_t { none, plane, slab, ball };
  enum class Mode : std::uint8_t { cut, whole_cells, straddle };
  Shape shape = Shape::none;
  Mode mode = Mode::cut;
  Vec3 point;           ///< on the plane, middle of the slab, centre of the ball
  Vec3 normal{1, 0, 0}; ///< unit; what lies on its positive side is cut away (plane)
  double radius = 0.1;  ///< ball's radius or half the slab's thickness, scene units
  bool flipped = false;
  friend bool operator==(const ClipSettings&, const ClipSettings&) = default;
};

enum class ThemeKind : std::uint8_t { dark, light, paper };
enum class ViewMode : std::uint8_t { scene, section, split };

/// Which side of the current operation is drawn.
enum class Moment : std::uint8_t {
  both,   ///< what it left, over a ghost of what it took away
  before, ///< Z as it was
  after   ///< Z as it is, without ghost
};

struct ViewSettings {
  LayerSettings input{false, 1.0f}; ///< the input triangles
  LayerSettings points{true, 1.0f}; ///< the points that the field is made of, where it is
  LayerSettings outer{true, 0.22f}; ///< outer boundary surface of Ω
  LayerSettings inner{true, 0.35f}; ///< inner boundary surface of Ω
  LayerSettings samples{true, 1.0f};
  LayerSettings good_samples{true, 1.0f}, bad_samples{true, 1.0f};
  bool near_samples = true;           ///< good samples only around the current operation
  LayerSettings over_rim{true, 1.0f}; ///< the boundary samples B
  LayerSettings tetrahedra{true, 1.0f};
  LayerSettings zero_set{true, 1.0f};
  LayerSettings curves{true, 1.0f};   ///< the border of Z, where sheets meet, and where these curves do
  LayerSettings rim{true, 1.0f};      ///< the border of the input
  LayerSettings dropped{false, 0.4f}; ///< what was cut off Z along the rim
  LayerSettings gamma{false, 1.0f};
  LayerSettings other_zero{false, 1.0f}; ///< Z of the run beside this one
  LayerSettings highlight{true, 1.0f};   ///< what the current operation touched
  LayerSettings xray{true, 1.0f};        ///< kernel, candidates and offenders of the selected edge
  bool invalid_regions = true;           ///< Ψ of the X-ray
  bool octree_cells = true;              ///< cells of the X-ray's octree search
  bool cost_ellipsoid = true;            ///< points of the same error as the target of the X-ray
  float kernel_push = 0;                 ///< planes of an empty kernel, of what they miss by, in [0, 1]
  Moment moment = Moment::both;
  bool zero_set_edges = true;
  ZeroMapKind zero_map = ZeroMapKind::none; ///< what Z is coloured by
  bool legend = false;                      ///< what colours mean, in the view and in pictures
  bool focus = true;        ///< with an edge selected samples, Ω and changed tetrahedra step back
  bool side_tint = true;    ///< tetrahedra in the colour of their side once Z is embedded
  float sample_size = 5.0f; ///< pixels at the orbit distance
  float level = 1;          ///< Ω is drawn as {φ <= level δ}
  /// Optical depth of a way of δ through Ω, at its outer boundary, at the input and at its inner boundary.
  float haze_outer = 0, haze_middle = 0, haze_inner = 0;
  TetFilter tets;
  ClipSettings clip;
  ViewMode mode = ViewMode::scene;
  ThemeKind theme = ThemeKind::dark;
  bool axes = true, scale_bar = true;
  bool clip_handle = true; ///< the clip's plane can be dragged in 3D
  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

/// Which kinds of elements a pick may hit, as a set. Facets of a free Z count as its cells: they come with
/// the tetrahedra.
enum class PickKinds : std::uint8_t {
  vertices = 1,
  tetrahedra = 2,
  samples = 4,
  edges = 8,
  points = 16, ///< of the input
  all = vertices | tetrahedra | samples | edges | points
};
constexpr PickKinds operator|(PickKinds a, PickKinds b) {
  return static_cast<PickKinds>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(PickKinds set, PickKinds kind) {
  return (static_cast<unsigned>(set) & static_cast<unsigned>(kind)) != 0;
}

/// What is picked or selected.
struct Pick {
  enum class Kind : std::uint8_t { none, vertex, edge, tet, sample, facet, point, over_rim };
  Kind kind = Kind::none;
  std::uint32_t id = 0xffffffffu;    ///< of the element; of an edge: of one end
  Vec3 point;                        ///< where the ray met it
  std::uint32_t other = 0xffffffffu; ///< the other end of an edge
  friend bool operator==(const Pick& a, const Pick& b) {
    return a.kind == b.kind && a.id == b.id && a.other == b.other;
  }
};

} // namespace isoscope
