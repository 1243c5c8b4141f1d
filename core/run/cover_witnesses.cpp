// Finds pieces of the input without samples near them, and holds the fewest points of the way there.
#include "run/cover_witnesses.h"

#include "base/halves.h"
#include "base/parallel.h"
#include "criteria/nearest_sample.h"
#include "run/anchored_samples.h"
#include "run/held_samples.h"
#include "run/kept_points.h"
#include "run/overlap_witnesses.h"
#include "run/thin_skeleton.h"
#include "tolerance/wall_samples.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace isoscope {
namespace {

constexpr std::size_t triangle_grain = 64, wall_grain = 16;
/// Below so many δ no limit can be kept by points alone.
constexpr double least_limit = 2;
/// Points are this much nearer, in δ, than the limit says: Z passes by samples up to δ − δ', and pieces have
/// a size.
constexpr double slack = 0.25;
/// Pieces of a triangle that are judged are no larger than this, in δ.
constexpr double finest_bare_piece = 0.15;
/// Points of the way are not asked for nearer to each other than this, in δ, nor farther apart than that, in
/// δ', where the input lies between them.
constexpr double finest_step = 1.0 / 16, longest_step = 0.95;

/// A piece of the input that no samples of a side keep Z near to.
struct BarePiece {
  Vec3 middle;
  TriangleId triangle;
};

std::vector<Vec3> middles_of(std::span<const BarePiece> pieces) {
  std::vector<Vec3> middles;
  for (const BarePiece& piece : pieces) middles.push_back(piece.middle);
  return middles;
}

/// Those far from all samples of the side, and those whose nearest one nothing holds there.
struct BarePieces {
  std::vector<BarePiece> far, loose;
};

/// The samples of one side and what holds them.
struct SideSamples {
  const NearestSample& nearest;
  const AnchoredSamples& anchored;
  int label;
};

/// The bare pieces of one triangle.
void find_bare(const SideSamples& samples, TriangleId id, const Triangle3& whole, double limit, double finest,
               BarePieces& bare) {
  std::vector<Triangle3> open{whole};
  while (!open.empty()) {
    const Triangle3 t = open.back();
    open.pop_back();
    const Vec3 c = centroid(t);
    const double radius = std::max({distance(c, t[0]), distance(c, t[1]), distance(c, t[2])});
    const SampleId near =
        limit > radius ? samples.nearest.nearest_of(c, samples.label, limit - radius) : SampleId();
    if (near.valid() && samples.anchored.is_anchored(near)) continue;
    if (radius <= finest) {
      (near.valid() ? bare.loose : bare.far).push_back({c, id});
      continue;
    }
    for (const Triangle3& half : halves(t)) open.push_back(half);
  }
}

BarePieces bare_pieces(const ToleranceVolume& volume, const SideSamples& samples, double limit,
                       const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  std::vector<BarePieces> found(index.size());
  parallel_until(index.size(), triangle_grain, control, [&](std::size_t i) {
    const Triangle3& t = index.triangle(TriangleId(i));
    if (area_vector(t) == Vec3{}) return;
    find_bare(samples, TriangleId(i), t, limit, finest_bare_piece * volume.thresholds().delta, found[i]);
  });
  BarePieces all;
  for (const BarePieces& pieces : found) {
    all.far.insert(all.far.end(), pieces.far.begin(), pieces.far.end());
    all.loose.insert(all.loose.end(), pieces.loose.begin(), pieces.loose.end());
  }
  return all;
}

void leave_marked(std::vector<BarePiece>& pieces, std::span<const std::uint8_t> marks) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (marks[i] != 0) pieces[n++] = pieces[i];
  pieces.resize(n);
}

/// Leaves the pieces that have no sample of the side within the limit that anything holds.
void drop_anchored(std::vector<BarePiece>& loose, const BoundarySamples& samples,
                   const AnchoredSamples& anchored, int label, double limit, const RunControl& control) {
  if (loose.empty()) return;
  SampleGrid grid(samples.positions.front(), limit);
  for (const Vec3 p : samples.positions) grid.add(p);
  std::vector<std::uint8_t> kept(loose.size());
  parallel_until(loose.size(), wall_grain, control, [&](std::size_t i) {
    const Vec3 c = loose[i].middle;
    std::vector<std::uint32_t> near;
    grid.gather(Box3{c, c}.grown(limit), near);
    kept[i] = std::none_of(near.begin(), near.end(), [&](std::uint32_t s) {
      return samples.labels[s] == label && distance(samples.positions[s], c) <= limit &&
             anchored.is_anchored(SampleId(s));
    });
  });
  leave_marked(loose, kept);
}

/// Leaves those that bound the side and need not be closed by Ω.
void keep_outer(std::vector<BarePiece>& bare, const ToleranceVolume& volume, const InputWalls& walls,
                int label, const RunControl& control) {
  std::vector<std::uint8_t> kept(bare.size());
  parallel_until(bare.size(), wall_grain, control, [&](std::size_t i) {
    const Vec3 normal = normalized(area_vector(volume.index().triangle(bare[i].triangle)));
    kept[i] = walls.judge(bare[i].triangle, bare[i].middle, normal).bounds(label) ? 1 : 0;
  });
  leave_marked(bare, kept);
}

/// Chooses what is held for the pieces, those farthest from a region first: of each that is still bare the
/// node on its way that is nearest to the region and near enough.
class Choice {
 public:
  Choice(const ToleranceVolume& volume, const ThinSkeleton& skeleton, int label, double limit)
      : volume_(volume), nodes_(skeleton.nodes()), label_(label), limit_(limit), on_path_(nodes_.size()),
        held_(volume.index().bounds().lo, limit) {}

  void cover(Vec3 piece, std::uint32_t node, CoverWitnesses& out) {
    if (nodes_[node].way == Box3::inf) return;
    if (held_.has_near(piece)) return;
    const auto near = [&](Vec3 p) { return distance(p, piece) <= limit_; };
    std::uint32_t best = node;
    for (std::uint32_t n = node; n != ThinSkeleton::none && near(nodes_[n].middle); n = nodes_[n].parent)
      if (!nodes_[n].root) best = n;
    held_.add(nodes_[best].middle);
    out.held.push_back(witness(best));
    add_way(best, out);
  }

  /// Leads from the end of a thin part to the one that is the root there.
  void join(std::uint32_t node, CoverWitnesses& out) {
    std::uint32_t root = node;
    while (nodes_[root].parent != ThinSkeleton::none) root = nodes_[root].parent;
    if (nodes_[root].end) add_way(node, out);
  }

 private:
  const ToleranceVolume& volume_;
  std::span<const ThinSkeleton::Node> nodes_;
  int label_;
  double limit_;
  std::vector<bool> on_path_;
  KeptPoints held_;

  void add_way(std::uint32_t from, CoverWitnesses& out) {
    std::vector<std::uint32_t> way;
    for (std::uint32_t n = from; n != ThinSkeleton::none && !on_path_[n]; n = nodes_[n].parent) {
      on_path_[n] = true;
      way.push_back(n);
    }
    for (auto n = way.rbegin(); n != way.rend(); ++n) {
      const std::uint32_t before = nodes_[*n].parent;
      if (before != ThinSkeleton::none)
        add_between(nodes_[before].middle, nodes_[*n].middle, nodes_[*n].straight, out.path);
      out.path.push_back(witness(*n));
    }
  }

  Witness witness(std::uint32_t n) const {
    const Vec3 p = nodes_[n].middle;
    return {p, label_, volume_.field().distance(p), true};
  }

  /// Points between two of the way, so near to each other that a ball over two of them stays on their side:
  /// then no vertex of the other side parts them. Where the input lies between them, as in thin shells that
  /// are curved, so near that it holds no sample.
  void add_between(Vec3 a, Vec3 b, bool straight, std::vector<Witness>& path) const {
    const ToleranceThresholds& limits = volume_.thresholds();
    const Vec3 middle = 0.5 * (a + b);
    const double depth = volume_.field().distance(middle), apart = distance(a, b);
    const double enough =
        straight ? std::max(2 * depth, finest_step * limits.delta) : longest_step * limits.boundary;
    if (apart <= enough) return;
    add_between(a, middle, straight, path);
    path.push_back({middle, label_, depth, true});
    add_between(middle, b, straight, path);
  }
};

/// Places of the input at its rim, between walls, with a sample of this side before them.
std::vector<Vec3> thin_ends(const ToleranceVolume& volume, int label) {
  std::vector<Vec3> ends;
  for (const WallSample& s : wall_samples(volume))
    if (s.label == label && s.in_gap) ends.push_back(volume.field().closest(s.point).point);
  return ends;
}

/// Points for pieces that bound one side, and for ends of thin parts.
void hold_side(const ToleranceVolume& volume, const InputWalls& walls, int label,
               std::span<const BarePiece> bare, std::span<const Vec3> ends, double limit, CoverWitnesses& out,
               const RunControl& control) {
  const ThinSkeleton skeleton(volume, walls, label, middles_of(bare), ends, control);
  if (control.cancelled()) return;
  std::vector<std::pair<double, std::size_t>> order; // minus the way, so that far ones come first
  std::vector<std::uint32_t> node(bare.size());
  for (std::size_t i = 0; i < bare.size(); ++i) {
    node[i] = skeleton.node_at(bare[i].middle);
    if (node[i] != ThinSkeleton::none) order.emplace_back(-skeleton.nodes()[node[i]].way, i);
  }
  std::sort(order.begin(), order.end());
  Choice choice(volume, skeleton, label, limit);
  SparsePoll poll(control, 64);
  for (const auto& [way, i] : order) {
    if (poll.cancelled()) return;
    choice.cover(bare[i].middle, node[i], out);
  }
  for (const Vec3 p : ends)
    if (const std::uint32_t n = skeleton.node_at(p); n != ThinSkeleton::none) choice.join(n, out);
}

} // namespace

CoverWitnesses find_cover_witnesses(const ToleranceVolume& volume, const SearchedSamples& searched,
                                    double limit, const RunControl& control) {
  CoverWitnesses out;
  const double delta = volume.thresholds().delta;
  if (!volume.has_surface() || volume.has_rooms()) return out;
  if (!(limit >= least_limit * delta)) return out;
  const double reach = limit - slack * delta;
  const BoundarySamples& samples = *searched.samples;
  const NearestSample& nearest = *searched.nearest;
  const AnchoredSamples anchored(volume, samples, control);
  std::optional<InputWalls> walls;
  for (const int label : {-1, +1}) {
    if (!nearest.has(label)) continue;
    auto [bare, loose] = bare_pieces(volume, {nearest, anchored, label}, reach, control);
    drop_anchored(loose, samples, anchored, label, reach, control);
    const std::vector<Vec3> ends = thin_ends(volume, label);
    if ((bare.empty() && loose.empty() && ends.empty()) || control.cancelled()) continue;
    if (!walls) walls.emplace(volume);
    keep_outer(bare, volume, *walls, label, control);
    keep_outer(loose, volume, *walls, label, control);
    if ((!bare.empty() || !ends.empty()) && !control.cancelled())
      hold_side(volume, *walls, label, bare, ends, reach, out, control);
    hold_samples(volume, nearest, label, middles_of(loose), reach, out.held, control);
  }
  if (volume.has_inner_walls() && !control.cancelled()) {
    if (!walls) walls.emplace(volume);
    hold_overlaps(volume, nearest, *walls, reach, out.held, control);
  }
  return out;
}

} // namespace isoscope
