// Looks from a wall both ways to what is met first.
#include "run/input_walls.h"

#include "base/disjoint_sets.h"
#include "tolerance/volume_components.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace isoscope {
namespace {

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

/// In δ': triangles of a soup belong to one part across cracks of twice that.
constexpr double widest_crack = 0.25;
/// A ball lies on a wall where nothing is nearer to its centre than this share of its radius.
constexpr double fits = 1 - 1e-6;
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
  if (volume.sides().by_solid_angles())
    part_ = find_volume_components(volume.index(), widest_crack * volume.thresholds().boundary).of_triangle;
  else
    part_ = parts_of(volume.index());
}

bool InputWalls::near_another_part(TriangleId own, const Triangle3& piece) const {
  if (part_.empty()) return false;
  Box3 box;
  for (const Vec3 p : piece) box.add(p);
  const auto near = volume_.index().triangles_in(box.grown(gap_));
  return std::any_of(near.begin(), near.end(), [&](TriangleId other) {
    return part_[other.index()] != part_[own.index()] &&
           triangles_within(piece, volume_.index().triangle(other), gap_);
  });
}

WallVerdict InputWalls::judge(TriangleId own, Vec3 p, Vec3 normal) const {
  const Sight front = sight(volume_, p, normal), back = sight(volume_, p, -normal);
  if (front.side == back.side || front.side == 0 || back.side == 0) return {Wall::inner, +1};
  const int outward = front.side > 0 ? +1 : -1;
  const Sight& outside = outward > 0 ? front : back;
  if (part_.empty()) return {Wall::outer, outward};
  // In the way is what stands in front, or what leans over the wall and keeps a ball of radius δ' from lying
  // on it, as in wedges and pits where parts cross.
  TriangleId before;
  if (outside.way <= gap_) {
    before = volume_.index().closest(outside.wall).triangle;
  } else {
    const double boundary = volume_.thresholds().boundary;
    const Vec3 out = static_cast<double>(outward) * normal, center = p + boundary * out;
    const ClosestPoint beside = volume_.index().closest(center);
    if (beside.distance() >= fits * boundary || dot(center - beside.point, out) > leaning * beside.distance())
      return {Wall::outer, outward};
    before = beside.triangle;
  }
  return {part_[before.index()] == part_[own.index()] ? Wall::outer : Wall::of_closed_gap, outward};
}

} // namespace isoscope
