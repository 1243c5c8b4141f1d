// Cuts triangles until nothing crosses a piece, and asks for the sides beside it.
#include "run/exposed_input.h"

#include "base/halves.h"
#include "base/parallel.h"
#include "run/input_walls.h"
#include "tolerance/wall_neighbours.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isoscope {
namespace {

/// Bisections of one triangle; what would be cut beyond them is kept.
constexpr std::size_t most_cuts = 200000;
/// A piece is shrunk by this share before others are looked for: its neighbours touch it at its border alone.
constexpr double border = 1e-6;
/// Triangles nearer than this share of a piece touch it.
constexpr double contact = 1e-9;

/// What lies on another triangle altogether, as where faces touch, is not crossed by it.
bool is_crossed(const ClosestPointIndex& index, TriangleId own, const Triangle3& piece) {
  const Vec3 c = centroid(piece);
  Triangle3 inner;
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    inner[i] = piece[i] + border * (c - piece[i]);
    box.add(inner[i]);
  }
  const double touching = contact * box.longest_edge();
  for (const TriangleId id : index.triangles_in(box.grown(touching))) {
    const Triangle3& other = index.triangle(id);
    if (id == own || !triangles_within(inner, other, touching)) continue;
    const auto on_other = [&](Vec3 p) {
      return distance(p, closest_point_on_triangle(p, other)) <= touching;
    };
    if (!std::all_of(inner.begin(), inner.end(), on_other)) return true;
  }
  return false;
}

/// Cuts the walls of one input into pieces that are judged.
class WallPieces {
 public:
  WallPieces(const ToleranceVolume& volume, double finest)
      : volume_(volume), walls_(volume), finest_(finest),
        may_cross_(volume.has_inner_walls() || !volume.input().embedded()),
        may_end_(volume.input().border.has_value()) {}

  struct Pieces {
    std::vector<Triangle3> kept;
    std::optional<Vec3> closed_gap;
  };
  Pieces exposed(TriangleId t) const {
    const Triangle3& whole = volume_.index().triangle(t);
    const Vec3 normal = normalized(cross(whole[1] - whole[0], whole[2] - whole[0]));
    if (normal == Vec3{}) return {{whole}, {}};
    Pieces pieces;
    std::vector<Triangle3> open{whole};
    for (std::size_t cuts = 0; !open.empty(); ++cuts) {
      const Triangle3 piece = open.back();
      open.pop_back();
      const std::size_t longest = longest_edge_of(piece);
      const double size = distance(piece[longest], piece[(longest + 1) % 3]);
      const bool near = walls_.near_another_part(t, piece);
      const bool cut = (near && size > volume_.thresholds().delta / 2) ||
                       (may_cross_ && size > finest_ && is_crossed(volume_.index(), t, piece));
      if (!cut || cuts >= most_cuts) {
        const bool sure = cut || (!near && !may_cross_);
        const Wall wall = sure ? Wall::outer : walls_.judge(t, centroid(piece), normal).kind;
        if (wall == Wall::outer || (wall == Wall::inner && is_fin(t, centroid(piece))))
          pieces.kept.push_back(piece);
        if (wall == Wall::of_closed_gap) pieces.closed_gap = centroid(piece);
        continue;
      }
      for (const Triangle3& half : halves(piece)) open.push_back(half);
    }
    return pieces;
  }

 private:
  /// A fin has one side on both sides, as an inner wall does, but parts no regions. One that is in the input
  /// twice, once each way, counts where it stands in the outside: within a body such walls are those of parts
  /// that touch.
  bool is_fin(TriangleId t, Vec3 p) const {
    const WallNeighbours around = neighbours_of_wall(volume_, {t, p});
    if (!around.told() || around.regions[0] != around.regions[1]) return false;
    return around.parted ? may_end_ : volume_.regions()[around.regions[0].index()].label > 0;
  }

  const ToleranceVolume& volume_;
  InputWalls walls_;
  double finest_;
  bool may_cross_, may_end_;
};

/// Whether parts of the input may lie inside of others or in front of them.
bool may_have_inner_walls(const ToleranceVolume& volume) {
  const InputTopology& input = volume.input();
  const bool one_surface = input.closed_manifold && input.components == 1;
  return volume.has_inner_walls() || (volume.sides().known() && !one_surface);
}

} // namespace

ExposedInput exposed_input(const ToleranceVolume& volume, double finest, const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  if (!may_have_inner_walls(volume)) return {volume.shared_index(), {}};
  const WallPieces walls(volume, finest);
  std::vector<WallPieces::Pieces> pieces(index.size());
  parallel_for(index.size(), 16, [&](std::size_t i) {
    if (!control.out_of_grace()) pieces[i] = walls.exposed(TriangleId(i));
  });
  ExposedInput out;
  TriangleSoup exposed;
  for (const WallPieces::Pieces& of_one : pieces) {
    if (!out.closed_gap) out.closed_gap = of_one.closed_gap;
    for (const Triangle3& t : of_one.kept) {
      const auto first = static_cast<std::uint32_t>(exposed.points.size());
      exposed.points.insert(exposed.points.end(), t.begin(), t.end());
      exposed.triangles.push_back({first, first + 1, first + 2});
    }
  }
  out.walls =
      exposed.triangles.empty() ? volume.shared_index() : std::make_shared<const ClosestPointIndex>(exposed);
  return out;
}

} // namespace isoscope
