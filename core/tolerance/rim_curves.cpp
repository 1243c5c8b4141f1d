// Marches through tetrahedra of a lattice around what parts the sides, and walks along the curves there.
#include "tolerance/rim_curves.h"

#include "base/parallel.h"
#include "base/place.h"
#include "base/sort_unique.h"
#include "tolerance/sample_grid.h"
#include "tolerance/weighted_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace isoscope {
namespace {

/// The lattice, in units of δ'.
constexpr double lattice_step = 0.25;
/// Over how much of a curve to each side its places are evened out, and by how much it is led back less than
/// to the sites, in units of δ'.
constexpr double evened = 0.5, outwards = 0.1;
/// A corner is so far from the ends of its edge at least, as a share of it.
constexpr double off_node = 0.01;
constexpr std::size_t fewest_corners = 8;
/// What the lattice makes of thin places goes round less than that, in units of δ'.
constexpr double longest_of_lattice = 3;

using Node = std::array<int, 3>;
using Pair = std::array<std::uint32_t, 2>;

/// A curve as corners that follow each other.
using Chain = std::vector<Vec3>;

class RimCurveFinder {
 public:
  RimCurveFinder(const ToleranceVolume& volume, const BoundarySamples& samples,
                 std::span<const std::int8_t> labels)
      : field_(volume.field()), boundary_(volume.thresholds().boundary), step_(lattice_step * boundary_),
        origin_(volume.domain().lo), samples_(samples), labels_(labels) {
    std::vector<WeightedPoint> sites;
    for (const Vec3 p : samples.positions) sites.push_back({p, 0});
    nearest_ = std::make_unique<const WeightedPointIndex>(sites, 0);
  }

  Result<std::vector<RimCurve>> run(const RunControl& control) {
    const std::vector<Node> cubes = cubes_between_sides(control);
    if (!control.cancelled()) find_levels(cubes, control);
    if (control.cancelled()) return std::vector<RimCurve>();
    SparsePoll poll(control, 4096);
    for (const Node& cube : cubes)
      if (!poll.cancelled()) march(cube);
    label_corners(control);
    if (!control.cancelled()) link();
    std::vector<RimCurve> curves;
    while (const auto chain = next_chain()) {
      if (control.cancelled()) break;
      if (!chain->second)
        return Error{ErrorCode::open_surface,
                     "The end of the sheet of points could not be followed near " +
                         place(chain->first.back(), place_digits) + ".",
                     "Another --tolerance or --gamma may show it."};
      if (!is_of_lattice(chain->first)) curves.push_back(led_back(chain->first));
    }
    return curves;
  }

 private:
  /// Those that the curves pass through: a place as near to a sample of either side is no farther than σ from
  /// both, and so from the middle between them.
  std::vector<Node> cubes_between_sides(const RunControl& control) const {
    SampleGrid grid(origin_, 2 * samples_.sigma);
    for (const Vec3 p : samples_.positions) grid.add(p);
    SparsePoll poll(control, 4096);
    std::vector<std::uint32_t> near;
    std::vector<Node> middles, cubes;
    for (std::uint32_t i = 0; i < samples_.size() && !poll.cancelled(); ++i) {
      if (labels_[i] <= 0) continue;
      const Vec3 p = samples_.positions[i];
      near.clear();
      grid.gather(Box3{p, p}.grown(2 * samples_.sigma), near);
      for (const std::uint32_t j : near) {
        if (labels_[j] >= 0 || distance(samples_.positions[j], p) > 2 * samples_.sigma) continue;
        const Vec3 at = (0.5 * (p + samples_.positions[j]) - origin_) / step_;
        middles.push_back({static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)),
                           static_cast<int>(std::floor(at.z))});
      }
    }
    sort_unique(middles);
    const int reach = static_cast<int>(std::ceil(samples_.sigma / step_)) + 1;
    for (const Node& m : middles)
      for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
          for (int z = -reach; z <= reach; ++z) cubes.push_back({m[0] + x, m[1] + y, m[2] + z});
    sort_unique(cubes);
    return cubes;
  }

  Vec3 position(const Node& n) const {
    return origin_ +
           step_ * Vec3{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
  }

  void find_levels(const std::vector<Node>& cubes, const RunControl& control) {
    for (const Node& cube : cubes)
      for (int k = 0; k < 8; ++k)
        nodes_.push_back({cube[0] + (k & 1), cube[1] + (k >> 1 & 1), cube[2] + (k >> 2)});
    sort_unique(nodes_);
    levels_.resize(nodes_.size());
    parallel_until(nodes_.size(), 256, control,
                   [&](std::size_t i) { levels_[i] = field_.distance(position(nodes_[i])) - boundary_; });
  }

  /// The facets of the level in the six tetrahedra of a cube around its diagonal.
  void march(const Node& cube) {
    static constexpr std::array<std::array<int, 3>, 6> ways{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (const auto& way : ways) {
      std::array<std::uint32_t, 4> v{};
      Node at = cube;
      for (std::size_t k = 0; k < 4; ++k) {
        v[k] =
            static_cast<std::uint32_t>(std::lower_bound(nodes_.begin(), nodes_.end(), at) - nodes_.begin());
        if (k < 3) ++at[static_cast<std::size_t>(way[k])];
      }
      const auto rest =
          std::stable_partition(v.begin(), v.end(), [&](std::uint32_t n) { return levels_[n] <= 0; });
      const auto inner = rest - v.begin();
      if (inner == 1)
        facets_.push_back({corner(v[0], v[1]), corner(v[0], v[2]), corner(v[0], v[3])});
      else if (inner == 3)
        facets_.push_back({corner(v[0], v[3]), corner(v[1], v[3]), corner(v[2], v[3])});
      else if (inner == 2) {
        const std::array quad{corner(v[0], v[2]), corner(v[0], v[3]), corner(v[1], v[3]), corner(v[1], v[2])};
        facets_.push_back({quad[0], quad[1], quad[2]});
        facets_.push_back({quad[0], quad[2], quad[3]});
      }
    }
  }

  /// The corner on the edge between a node in Ω' and one beyond.
  std::uint32_t corner(std::uint32_t in, std::uint32_t out) {
    const auto [at, fresh] =
        corner_of_.emplace(std::minmax(in, out), static_cast<std::uint32_t>(corners_.size()));
    if (fresh) {
      const double t = std::clamp(-levels_[in] / (levels_[out] - levels_[in]), off_node, 1 - off_node);
      corners_.push_back(position(nodes_[in]) + t * (position(nodes_[out]) - position(nodes_[in])));
    }
    return at->second;
  }

  void label_corners(const RunControl& control) {
    corner_labels_.resize(corners_.size());
    parallel_until(corners_.size(), 256, control, [&](std::size_t i) {
      corner_labels_[i] = labels_[nearest_->closest(corners_[i]).triangle.index()];
    });
  }

  /// Middles of edges between both sides, joined across facets.
  void link() {
    std::map<Pair, std::uint32_t> middle_of;
    for (const auto& f : facets_) {
      std::vector<std::uint32_t> ends;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = std::min(f[k], f[(k + 1) % 3]), b = std::max(f[k], f[(k + 1) % 3]);
        if (corner_labels_[a] * corner_labels_[b] >= 0) continue;
        const auto [at, fresh] = middle_of.emplace(Pair{a, b}, static_cast<std::uint32_t>(middles_.size()));
        if (fresh) middles_.push_back(0.5 * (corners_[a] + corners_[b]));
        ends.push_back(at->second);
      }
      if (ends.size() != 2) continue;
      linked_.resize(middles_.size());
      linked_[ends[0]].push_back(ends[1]);
      linked_[ends[1]].push_back(ends[0]);
    }
    linked_.resize(middles_.size());
    walked_.assign(middles_.size(), 0);
  }

  /// The next curve, and whether it is closed.
  std::optional<std::pair<Chain, bool>> next_chain() {
    while (first_ < middles_.size() && walked_[first_] != 0) ++first_;
    if (first_ == middles_.size()) return std::nullopt;
    Chain chain;
    std::uint32_t at = first_;
    for (;;) {
      walked_[at] = 1;
      chain.push_back(middles_[at]);
      const auto next = std::find_if(linked_[at].begin(), linked_[at].end(),
                                     [&](std::uint32_t m) { return walked_[m] == 0; });
      if (next != linked_[at].end()) {
        at = *next;
        continue;
      }
      const bool closed = std::find(linked_[at].begin(), linked_[at].end(), first_) != linked_[at].end();
      return std::pair{std::move(chain), closed};
    }
  }

  /// Whether a curve goes round a place of Ω' that is thinner than the lattice shows: one through a hole is
  /// never this short with Ω' in its middle.
  bool is_of_lattice(const Chain& chain) const {
    Vec3 sum;
    double length = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      sum += chain[i];
      length += distance(chain[i], chain[(i + 1) % chain.size()]);
    }
    return length < longest_of_lattice * boundary_ &&
           field_.distance(sum / static_cast<double>(chain.size())) <= boundary_;
  }

  RimCurve led_back(const Chain& chain) const {
    const std::size_t n = chain.size();
    std::vector<Vec3> site(n), away(n);
    std::vector<double> from(n + 1, 0); // along the curve
    for (std::size_t i = 0; i < n; ++i) {
      const ClosestPoint closest = field_.closest(chain[i]);
      site[i] = field_.is_distance() ? closest.point : field_.place_of(closest.triangle);
      away[i] = normalized(chain[i] - site[i]);
      from[i + 1] = from[i] + distance(chain[i], chain[(i + 1) % n]);
    }
    const double length = from[n], window = std::min(evened * boundary_, length / 4);
    const auto count = std::max(fewest_corners, static_cast<std::size_t>(std::ceil(length / step_)));
    RimCurve curve;
    std::size_t first = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double at = length * static_cast<double>(k) / static_cast<double>(count);
      while (from[first + 1] < at) ++first;
      Vec3 sum, direction;
      double weights = 0;
      const auto take = [&](std::size_t i) {
        const double off = std::abs(from[i] - at), way = std::min(off, length - off);
        const double weight = (1 - way / window) * (from[i + 1] - from[i]);
        if (!(way < window)) return false;
        sum += weight * site[i];
        direction += weight * away[i];
        weights += weight;
        return true;
      };
      for (std::size_t i = 0; i < n; ++i)
        if (!take((first + n - i) % n) && i > 0) break;
      for (std::size_t i = 1; i < n; ++i)
        if (!take((first + i) % n) && i > 1) break;
      if (!(weights > 0)) continue;
      curve.away.push_back(normalized(direction));
      curve.corners.push_back(sum / weights + outwards * boundary_ * curve.away.back());
    }
    return curve;
  }

  const ToleranceField& field_;
  double boundary_, step_;
  Vec3 origin_;
  const BoundarySamples& samples_;
  std::span<const std::int8_t> labels_;
  std::unique_ptr<const WeightedPointIndex> nearest_; ///< of the samples
  std::vector<Node> nodes_;                           ///< of the lattice, ascending
  std::vector<double> levels_;                        ///< by node: φ - δ'
  std::vector<Vec3> corners_;                         ///< where edges cross the level
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> corner_of_; ///< by nodes of the edge
  std::vector<std::int8_t> corner_labels_;
  std::vector<std::array<std::uint32_t, 3>> facets_; ///< by corners
  std::vector<Vec3> middles_;
  std::vector<std::vector<std::uint32_t>> linked_; ///< by middle
  std::vector<std::uint8_t> walked_;
  std::size_t first_ = 0;
};

} // namespace

Result<std::vector<RimCurve>> find_rim_curves(const ToleranceVolume& volume, const BoundarySamples& samples,
                                              std::span<const std::int8_t> labels,
                                              const RunControl& control) {
  return RimCurveFinder(volume, samples, labels).run(control);
}

} // namespace isoscope
