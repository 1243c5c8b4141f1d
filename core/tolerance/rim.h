// The rim of an open surface: the border of the input where Ω does not bridge it, in loops (§4.1).
#pragma once

#include "base/run_control.h"
#include "base/segment.h"
#include "tolerance/closest_point.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace isoscope {

/// The longest piece of a border, in units of δ'.
constexpr double longest_border_piece = 0.25;
/// Borders face each other where the cosine of their conormals is below this: what they leave between them is
/// a slit that Ω closes, and no corner.
constexpr double facing_conormals = -0.5;

/// A straight part of the border, short against δ.
struct RimPiece {
  Vec3 a, b;     ///< as its triangle runs
  Vec3 conormal; ///< unit, in the plane of its triangle and away from it
  TriangleId triangle;
  bool open = false;       ///< false: bridged, Ω closes what lies before it
  bool meets_wall = false; ///< bridged to a part of the input that runs across: the sheet ends on it
  std::uint32_t loop = 0;  ///< of an open one: the number of its loop
};

/// A loop of the open rim, as Ω leaves it: gaps in it that Ω bridges are passed over.
struct RimLoop {
  std::size_t pieces = 0;
  double length = 0;
  Vec3 center;         ///< the mean of its pieces
  Vec3 normal;         ///< of the plane that fits it; zero where none does
  double diameter = 0; ///< twice the largest distance of a piece from the centre
  /// The largest distance from that plane, relative to the diameter: 0 is flat; 1 where there is no plane.
  double flatness = 1;
};

/// A closed curve that stands for a rim where the input has no edges to tell it.
struct RimCurve {
  std::vector<Vec3> corners; ///< in order; the last is joined to the first
  std::vector<Vec3> away;    ///< by corner: unit, along the sheet and away from it
};

/// The border edges of a surface, cut into pieces, and a hierarchy over the open ones. Const and thread-safe.
class Rim {
 public:
  Rim() = default;
  /// Looks at the borders of the triangles that `wanted` has a 1 for, by id. A point c of the border is open
  /// where nothing of the input is nearer than δ' to c + δ' u, u its conormal, but what lies beside it, or
  /// where it lies on a sheet that runs the other way round: the end of a flap that is folded back.
  /// Triangles without area have no borders. `turns`: how the triangles run, as in PseudoNormals; `boundary`:
  /// δ'. Of no use once the control is cancelled.
  Rim(const ClosestPointIndex& index, std::span<const std::uint8_t> wanted,
      std::span<const std::int8_t> turns, double boundary, const RunControl& control);

  /// Curves that were found otherwise, all of them open. Their pieces have the site of the field that is
  /// nearest for a triangle.
  Rim(std::span<const RimCurve> curves, const ToleranceField& field, double boundary);

  /// The same with more pieces that are open: those with a 1.
  Rim opened(std::span<const std::uint8_t> more) const;

  std::span<const RimPiece> pieces() const { return pieces_; }
  std::span<const RimLoop> loops() const { return loops_; }
  bool empty() const { return loops_.empty(); }
  /// Points of the border in which more than two open pieces end: holes that meet in a vertex are one loop.
  std::size_t meetings() const { return meetings_; }
  /// The distance field of the open pieces.
  const ClosestPointIndex& curve() const { return *curve_; }
  /// Whether a point of the open rim is as near to p as any of the input, which is `d` away.
  bool is_nearest(Vec3 p, double d) const;
  /// The number of the loop that is nearest to p. There must be one.
  std::uint32_t loop_near(Vec3 p) const { return loop_of_[curve_->closest(p).triangle.index()]; }
  std::size_t memory_bytes() const;

 private:
  void cut(const ClosestPointIndex& index, std::span<const std::uint8_t> wanted,
           std::span<const std::int8_t> turns, const RunControl& control);
  /// An end of one open piece alone.
  struct LoneEnd {
    std::uint32_t node, piece;
    Vec3 point;
  };
  std::vector<std::array<std::uint32_t, 2>> bridges(std::span<const LoneEnd> lone) const;
  void find_loops();
  void describe_loops();
  void build_curve();

  double boundary_ = 0;
  std::vector<RimPiece> pieces_;                    ///< those of an edge in a row, edges as they are sorted
  std::vector<std::array<std::uint32_t, 2>> nodes_; ///< by piece: numbers of its ends, shared where they meet
  std::vector<RimLoop> loops_;
  std::size_t meetings_ = 0;
  std::shared_ptr<const ClosestPointIndex> curve_;
  std::vector<std::uint32_t> loop_of_; ///< by site of the curve
};

/// Segments as triangles without area, by the same numbers: what has their distance field.
TriangleSoup flat_triangles(std::span<const Segment3> segments);

} // namespace isoscope
