// Cuts triangles until nothing crosses a piece, and asks for the sides beside it.
#include "run/exposed_input.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <cstdint>
#include <limits>
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

/// The parts of the input by triangle, joined across edges: those that only touch or cross are two, and Ω
/// closes the wedges between them.
std::vector<std::uint32_t> parts_of(const ClosestPointIndex& index) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(weld(index).triangles);
  DisjointSets sets(index.size());
  for (std::size_t i = 1; i < uses.size(); ++i)
    if (uses[i].low == uses[i - 1].low && uses[i].high == uses[i - 1].high)
      sets.unite(uses[i].triangle, uses[i - 1].triangle);
  std::vector<std::uint32_t> parts(index.size());
  for (std::uint32_t t = 0; t < parts.size(); ++t) parts[t] = sets.find(t);
  return parts;
}

/// A wall that is met from a point.
struct Sight {
  int side = +1; ///< of the place midway to it; outside where there is none
  double way = std::numeric_limits<double>::infinity();
  Vec3 wall;
};

/// What one comes to from p, a point of the input, along a direction.
Sight sight(const ToleranceVolume& volume, Vec3 p, Vec3 direction) {
  const ClosestPointIndex& index = volume.index();
  const double reach = 2 * (distance(index.bounds().lo, index.bounds().hi) + volume.thresholds().delta);
  const Vec3 start = p + (1e-9 * reach) * direction, end = p + reach * direction;
  const std::vector<double> hits = index.crossings(start, end);
  if (hits.empty()) return {};
  const Vec3 way = hits.front() * (end - start);
  return {volume.sides().label(start + 0.5 * way), length(way), start + way};
}

enum class Wall : std::uint8_t { outer, inner, of_closed_gap };

/// Judges the walls of one input.
class Walls {
 public:
  Walls(const ToleranceVolume& volume, double finest)
      : volume_(volume), finest_(finest), gap_(2 * volume.thresholds().boundary),
        may_cross_(volume.has_inner_walls() || !volume.input().embedded()) {
    if (volume.input().components > 1) part_ = parts_of(volume.index());
  }

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
      const std::size_t longest = longest_edge(piece);
      const Vec3 a = piece[longest], b = piece[(longest + 1) % 3];
      const double size = distance(a, b);
      const bool near = near_another_part(t, piece);
      const bool cut = (near && size > volume_.thresholds().delta / 2) ||
                       (may_cross_ && size > finest_ && is_crossed(volume_.index(), t, piece));
      if (!cut || cuts >= most_cuts) {
        const bool sure = cut || (!near && !may_cross_);
        const Wall wall = sure ? Wall::outer : judge(t, centroid(piece), normal);
        if (wall == Wall::outer) pieces.kept.push_back(piece);
        if (wall == Wall::of_closed_gap) pieces.closed_gap = centroid(piece);
        continue;
      }
      Triangle3 first = piece, second = piece;
      first[longest] = second[(longest + 1) % 3] = 0.5 * (a + b);
      open.push_back(first);
      open.push_back(second);
    }
    return pieces;
  }

 private:
  static std::size_t longest_edge(const Triangle3& t) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (distance(t[i], t[(i + 1) % 3]) > distance(t[longest], t[(longest + 1) % 3])) longest = i;
    return longest;
  }

  bool near_another_part(TriangleId own, const Triangle3& piece) const {
    if (part_.empty()) return false;
    Box3 box;
    for (const Vec3 p : piece) box.add(p);
    const auto near = volume_.index().triangles_in(box.grown(gap_));
    return std::any_of(near.begin(), near.end(), [&](TriangleId other) {
      return part_[other.index()] != part_[own.index()] &&
             triangles_within(piece, volume_.index().triangle(other), gap_);
    });
  }

  Wall judge(TriangleId own, Vec3 p, Vec3 normal) const {
    const Sight front = sight(volume_, p, normal), back = sight(volume_, p, -normal);
    if (front.side == back.side) return Wall::inner;
    const Sight& outside = front.side > 0 ? front : back;
    if (part_.empty() || outside.way > gap_) return Wall::outer;
    const TriangleId before = volume_.index().closest(outside.wall).triangle;
    return part_[before.index()] == part_[own.index()] ? Wall::outer : Wall::of_closed_gap;
  }

  const ToleranceVolume& volume_;
  double finest_, gap_;
  bool may_cross_;
  std::vector<std::uint32_t> part_; ///< by triangle; none where there is one
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
  const Walls walls(volume, finest);
  std::vector<Walls::Pieces> pieces(index.size());
  parallel_for(index.size(), 16, [&](std::size_t i) {
    if (!control.out_of_grace()) pieces[i] = walls.exposed(TriangleId(i));
  });
  ExposedInput out;
  TriangleSoup exposed;
  for (const Walls::Pieces& of_one : pieces) {
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
