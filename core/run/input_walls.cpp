// Looks from a wall both ways to what is met first.
#include "run/input_walls.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"
#include "run/touching_ball.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace isoscope {
namespace {

/// In δ': across cracks of this width the borders of a soup are those of one part.
constexpr double widest_crack = 0.5;

/// Cosine between two borders along a crack, and the share of a piece's border that has to run along
/// another's: those of parts that cross come close by chance.
constexpr double along_crack = 0.8, share_of_border = 0.1;

/// Joins pieces whose borders run along each other.
void join_across_cracks(const WeldedMesh& mesh, double width, DisjointSets& sets) {
  const std::vector<EdgeUse> borders = border_uses(mesh.triangles);
  std::vector<Triangle3> segments;
  std::vector<Vec3> edges;
  std::map<std::uint32_t, double> length_of; // of the border, by piece
  for (const EdgeUse& e : borders) {
    segments.push_back({mesh.points[e.low], mesh.points[e.high], mesh.points[e.high]});
    edges.push_back(mesh.points[e.high] - mesh.points[e.low]);
    length_of[sets.find(e.triangle)] += length(edges.back());
  }
  const ClosestPointIndex index(segments, {});
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> along; // of the first piece's border, by pieces
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const std::uint32_t own = sets.find(borders[i].triangle);
    Box3 box;
    for (const Vec3 p : segments[i]) box.add(p);
    std::vector<std::uint32_t> pieces;
    for (const TriangleId near : index.triangles_in(box.grown(width))) {
      const std::size_t j = near.index();
      const std::uint32_t other = sets.find(borders[j].triangle);
      const double parallel = std::abs(dot(normalized(edges[i]), normalized(edges[j])));
      if (other != own && parallel >= along_crack && triangles_within(segments[i], segments[j], width))
        pieces.push_back(other);
    }
    sort_unique(pieces);
    for (const std::uint32_t other : pieces) along[{own, other}] += length(edges[i]);
  }
  for (const auto& [pair, common] : along)
    if (common >= share_of_border * length_of[pair.first]) sets.unite(pair.first, pair.second);
}

/// The parts of the input by triangle, joined across edges and cracks: those that only touch or cross are
/// two, and Ω closes the wedges between them.
std::vector<std::uint32_t> parts_of(const ClosestPointIndex& index, double widest) {
  const WeldedMesh mesh = weld(index);
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  DisjointSets sets(index.size());
  for (std::size_t i = 1; i < uses.size(); ++i)
    if (uses[i].low == uses[i - 1].low && uses[i].high == uses[i - 1].high)
      sets.unite(uses[i].triangle, uses[i - 1].triangle);
  if (widest > 0) join_across_cracks(mesh, widest, sets);
  std::vector<std::uint32_t> parts(index.size());
  for (std::uint32_t t = 0; t < parts.size(); ++t) parts[t] = sets.find(t);
  return parts;
}

/// A ball lies on a wall where nothing is nearer to its centre than this share of its radius.
constexpr double fits = 1 - 1e-6;
/// Radius of a ball that has room, in δ': pockets with room for less are none that cells of Ω's octree show.
constexpr double seen_room = 1.1;
/// Moves of a ball's centre, of its radius.
constexpr double within_ball = 0.9;
/// So much farther than is wanted, in δ', so that moves along a wedge do not come to rest before.
constexpr double smallest_move = 0.05;
/// Cosine between the outward normals of a wall and of one that leans over it: some 75° between the walls or
/// less.
constexpr double leaning = -0.25;

/// A wall that is met from a point.
struct Sight {
  int side = +1; ///< of the place midway to it; outside where there is none, 0 where it is not sure
  double way = std::numeric_limits<double>::infinity();
  Vec3 wall;
};

int sure_side(const ToleranceVolume& volume, Vec3 p) {
  if (const OpenSides* open = volume.open_sides()) return open->side(p, volume.field().closest(p));
  if (volume.sides().known()) return volume.sides().label(p);
  const std::optional<bool> inside = volume.sides().unanimous_parity(p);
  return !inside ? 0 : (*inside ? -1 : +1);
}

/// What one comes to from p, a point of the input, along a direction; farther away than gaps that Ω closes
/// nothing is looked for.
Sight sight(const ToleranceVolume& volume, Vec3 p, Vec3 direction) {
  const ClosestPointIndex& index = volume.index();
  const double boundary = volume.thresholds().boundary, reach = 4 * boundary;
  const Vec3 start = p + (1e-9 * index.bounds().longest_edge()) * direction, end = p + reach * direction;
  const std::vector<double> hits = index.crossings(start, end);
  const Vec3 way = (hits.empty() ? 1.0 : hits.front()) * (end - start);
  // Beside an open surface its own side is asked for.
  const double asked_at = std::min(length(way), volume.open_sides() != nullptr ? boundary : reach) / 2;
  return {sure_side(volume, start + asked_at * direction),
          hits.empty() ? std::numeric_limits<double>::infinity() : length(way), start + way};
}

} // namespace

InputWalls::InputWalls(const ToleranceVolume& volume)
    : volume_(volume), gap_(2 * volume.thresholds().boundary) {
  if (volume.input().components <= 1) return;
  const bool may_crack = volume.sides().by_solid_angles();
  part_ = parts_of(volume.index(), may_crack ? widest_crack * volume.thresholds().boundary : 0);
}

bool InputWalls::near_another_part(TriangleId own, const Triangle3& piece, double within) const {
  if (part_.empty()) return false;
  Box3 box;
  for (const Vec3 p : piece) box.add(p);
  const auto near = volume_.index().triangles_in(box.grown(within));
  return std::any_of(near.begin(), near.end(), [&](TriangleId other) {
    return part_[other.index()] != part_[own.index()] &&
           triangles_within(piece, volume_.index().triangle(other), within);
  });
}

/// Loose triangles that cross are one part. The pockets that are left between them are cracks, and nobody's
/// slots.
bool InputWalls::is_of_pocket(Vec3 p, Vec3 out, double width) const {
  return volume_.index().distance(p + width * out) < width / 2;
}

/// Whether a ball of more than δ' has room where a smaller one has, after moves away from what is nearest.
bool InputWalls::has_room_near(Vec3 center, const Nearest& nearest) const {
  constexpr int most_moves = 16;
  const double boundary = volume_.thresholds().boundary;
  const double wanted = seen_room * boundary;
  for (int i = 0; i < most_moves; ++i) {
    const Vec3 away = center - nearest(center);
    const double room = length(away);
    if (room >= wanted) return true;
    if (room == 0) return false;
    center += (std::min(wanted + smallest_move * boundary - room, within_ball * room) / room) * away;
  }
  return false;
}

InputWalls::Nearest InputWalls::nearest() const {
  return [this](Vec3 q) { return volume_.index().closest(q).point; };
}

/// Whether there would be room near a point before a wall, were there none but its own part.
bool InputWalls::is_plugged(TriangleId own, Vec3 before) const {
  const ClosestPointIndex& index = volume_.index();
  const double far = 2 * volume_.thresholds().boundary;
  const auto nearest_of_own = [&](Vec3 q) {
    Vec3 at = q + Vec3{far, 0, 0};
    for (const TriangleId id : index.triangles_in(Box3{q, q}.grown(far))) {
      if (part_[id.index()] != part_[own.index()]) continue;
      const Vec3 x = closest_point_on_triangle(q, index.triangle(id));
      if (distance(x, q) < distance(at, q)) at = x;
    }
    return at;
  };
  return !has_room_near(before, nearest()) && has_room_near(before, nearest_of_own);
}

/// Whether another part leaves no room for a ball of radius δ' on a wall. Where none of the own part leaves
/// less, it leans over the wall, as at the foot of a fin, or there is none beside it either, as at the bottom
/// of a gap. In the own part's corners and hollows there would be room beside them, but for other parts.
/// Borders at cracks stand out and do not count. Nothing is in `way` along `out`.
bool InputWalls::is_closed_by_another(TriangleId own, Vec3 p, Vec3 out, double way) const {
  const ClosestPointIndex& index = volume_.index();
  const double boundary = volume_.thresholds().boundary;
  const Vec3 center = p + boundary * out;
  if (index.distance(center) >= fits * boundary) return false;
  const double standing_out = volume_.sides().by_solid_angles() ? widest_crack * boundary / 2 : 0;
  double of_own = boundary, of_others = boundary;
  TriangleId other;
  for (const TriangleId id : index.triangles_in(Box3{center, center}.grown(boundary))) {
    const double radius = touching_radius(
        p, out, boundary, [&](Vec3 q) { return closest_point_on_triangle(q, index.triangle(id)); });
    if (part_[id.index()] == part_[own.index()]) {
      if (radius >= standing_out) of_own = std::min(of_own, radius);
    } else if (radius < of_others) {
      of_others = radius;
      other = id;
    }
  }
  if (!other.valid() || of_others > of_own) return is_plugged(own, p + (std::min(way, boundary) / 2) * out);
  const Vec3 touching = p + of_others * out;
  const Vec3 away = touching - closest_point_on_triangle(touching, index.triangle(other));
  return dot(away, out) <= leaning * length(away) || !has_room_near(touching, nearest());
}

WallVerdict InputWalls::judge(TriangleId own, Vec3 p, Vec3 normal) const {
  const Sight front = sight(volume_, p, normal), back = sight(volume_, p, -normal);
  if (front.side == back.side || front.side == 0 || back.side == 0) return {Wall::inner, +1};
  const int outward = front.side > 0 ? +1 : -1;
  const Sight& outside = outward > 0 ? front : back;
  if (part_.empty()) return {Wall::outer, outward};
  const Vec3 out = static_cast<double>(outward) * normal;
  const double boundary = volume_.thresholds().boundary, crack = widest_crack * boundary;
  if (volume_.sides().by_solid_angles() && (outside.way <= crack || is_of_pocket(p, out, crack / 2)))
    return {Wall::of_closed_gap, outward};
  const bool another_in_front =
      outside.way <= gap_ &&
      part_[volume_.index().closest(outside.wall).triangle.index()] != part_[own.index()];
  const bool closed = another_in_front || is_closed_by_another(own, p, out, outside.way);
  return {closed ? Wall::of_closed_gap : Wall::outer, outward};
}

} // namespace isoscope
