// Signs by pseudonormals, and what is over the rim.
#include "tolerance/open_sides.h"

#include <algorithm>

namespace isoscope {
namespace {

/// What is by the wall, in units of δ'.
constexpr double by_wall = 0.002;
/// Pieces up to the first size, in units of δ, are over the rim where their corners and their centre are; up
/// to the second where their centre is.
constexpr double judged_by_corners = 0.25, judged_by_center = 0.02;

std::vector<std::uint8_t> by_triangle(const std::vector<std::uint32_t>& component,
                                      const std::vector<std::uint8_t>& open) {
  std::vector<std::uint8_t> wanted(component.size());
  for (std::size_t t = 0; t < component.size(); ++t) wanted[t] = open[component[t]];
  return wanted;
}

PseudoNormals normals_of(const ClosestPointIndex& index, std::span<const std::int8_t> turns) {
  const WeldedMesh mesh = weld(index);
  return PseudoNormals(mesh.points, mesh.triangles, turns);
}

} // namespace

OpenSides::OpenSides(std::shared_ptr<const ClosestPointIndex> index, std::vector<std::uint32_t> component,
                     std::vector<std::uint8_t> open, std::span<const std::int8_t> turns, double boundary,
                     const RunControl& control)
    : field_(index), index_(std::move(index)), component_(std::move(component)), open_(std::move(open)),
      boundary_(boundary), wall_margin_(by_wall * boundary), normals_(normals_of(*index_, turns)),
      rim_(*index_, by_triangle(component_, open_), turns, boundary, control) {}

OpenSides::OpenSides(std::shared_ptr<const ToleranceField> field, std::vector<std::uint32_t> component,
                     std::vector<std::uint8_t> open, const std::array<std::vector<Vec3>, 2>& samples, Rim rim,
                     double rim_margin, double boundary)
    : field_(std::move(field)), component_(std::move(component)), open_(std::move(open)), boundary_(boundary),
      wall_margin_(by_wall * boundary), rim_margin_(rim_margin), rim_(std::move(rim)) {
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<WeightedPoint> points;
    for (const Vec3 p : samples[k]) points.push_back({p, 0});
    samples_[k] = std::make_shared<const WeightedPointIndex>(points, 0);
  }
}

bool OpenSides::all_open() const {
  return std::all_of(open_.begin(), open_.end(), [](std::uint8_t open) { return open != 0; });
}

int OpenSides::side(Vec3 p, const ClosestPoint& closest) const {
  if (is_over_rim(p, closest)) return 0;
  if (!index_) return side_by_samples(p, closest);
  const Vec3 n = normals_.at(closest.triangle, index_->triangle(closest.triangle), closest.point);
  const double rise = dot(n, p - closest.point);
  if (!votes_.empty())
    if (const int side = vote_near(closest.point + boundary_ * normalized(p - closest.point)); side != 0)
      return side;
  return rise > 0 ? +1 : rise < 0 ? -1 : 0;
}

int OpenSides::side_by_samples(Vec3 p, const ClosestPoint& closest) const {
  // Beyond Ω' the side is that of the wall before it; within, a site may be on the other side of p than the
  // rest of the sheet.
  const double beyond = closest.distance() - boundary_;
  if (beyond > 0) p = p - beyond * field_->gradient(p, closest);
  const double behind = samples_[0]->distance(p), before = samples_[1]->distance(p);
  return before < behind ? +1 : behind < before ? -1 : 0;
}

/// How near a point of the rim is to p that is as near as the input. Weights make points farther away than
/// their places are.
double OpenSides::rim_reach(Vec3 p, const ClosestPoint& closest) const {
  if (field_->is_distance()) return closest.distance() + rim_margin_;
  return distance(p, field_->place_of(closest.triangle)) + rim_margin_;
}

std::array<Vec3, 2> OpenSides::places_beside(Vec3 p) const {
  return {samples_[0]->closest(p).point, samples_[1]->closest(p).point};
}

/// The side of the nearest vote within reach, 0 where there is none.
int OpenSides::vote_near(Vec3 p) const {
  std::vector<std::uint32_t> near;
  vote_grid_->gather(Box3{p, p}.grown(vote_reach_), near);
  const SideVote* nearest = nullptr;
  for (const std::uint32_t i : near) {
    const SideVote& vote = votes_[i];
    if (distance(vote.point, p) <= vote_reach_ &&
        (nearest == nullptr || distance(vote.point, p) < distance(nearest->point, p)))
      nearest = &vote;
  }
  return nearest == nullptr ? 0 : nearest->side;
}

OpenSides OpenSides::settled(Rim rim, std::vector<SideVote> votes, double vote_reach) const {
  OpenSides settled = *this;
  settled.rim_ = std::move(rim);
  settled.votes_ = std::move(votes);
  settled.vote_reach_ = vote_reach;
  if (settled.votes_.empty()) return settled;
  SampleGrid grid(index_->bounds().lo, vote_reach);
  for (const SideVote& vote : settled.votes_) grid.add(vote.point);
  settled.vote_grid_ = std::make_shared<const SampleGrid>(std::move(grid));
  return settled;
}

PieceVerdict OpenSides::judge_outside(const Triangle3& piece, Vec3 center, const ClosestPoint& closest,
                                      double radius, double delta) const {
  if (!is_open(closest.triangle)) return PieceVerdict::violates;
  const double d = closest.distance(), far = reach * delta;
  if (d > far) return d - radius > far ? PieceVerdict::passes : PieceVerdict::divide;
  if (!is_by_wall(center, closest)) return PieceVerdict::violates;
  if (radius <= judged_by_center * delta) return PieceVerdict::passes;
  if (radius > judged_by_corners * delta) return PieceVerdict::divide;
  const bool all = std::all_of(piece.begin(), piece.end(), [&](Vec3 p) {
    return is_by_wall(p, field_->closest_near(p, closest.triangle));
  });
  return all ? PieceVerdict::passes : PieceVerdict::divide;
}

std::size_t OpenSides::memory_bytes() const {
  return component_.capacity() * sizeof(std::uint32_t) + open_.capacity() + normals_.memory_bytes() +
         rim_.memory_bytes() + (samples_[0] ? samples_[0]->memory_bytes() + samples_[1]->memory_bytes() : 0) +
         votes_.capacity() * sizeof(SideVote) + (vote_grid_ ? vote_grid_->memory_bytes() : 0);
}

} // namespace isoscope
