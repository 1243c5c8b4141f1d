// One sweep over neighbouring samples for contested pieces, one for what hangs together.
#include "tolerance/side_votes.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "tolerance/sample_grid.h"

#include <algorithm>
#include <span>
#include <utility>

namespace isoscope {
namespace {

/// What joins samples of both sides of a sheet crosses it, and each is δ' from there: neighbours, up to 2σ
/// apart, are on one side as long as σ is at most this share of δ'.
constexpr double largest_sigma = 0.98;
/// What is joined is on both sides where its smaller part is more than this share, unless it is a pocket:
/// less than that share of all samples.
constexpr double largest_minority = 0.2, largest_pocket = 0.05;
/// Both sides meet over the rim, not so many δ' from it.
constexpr double far_from_rim = 3;
/// A place of the input with so many δ' around it on one side is farther from Z than results may be.
constexpr double far_from_other_side = 4;
/// A sample whose distance to the border is d up to this share is over it.
constexpr double over_border = 1e-5;
constexpr std::size_t samples_between_questions = 4096;

class Vote {
 public:
  Vote(const ToleranceVolume& volume, const BoundarySamples& samples)
      : volume_(volume), samples_(samples), grid_(volume.domain().lo, 2 * samples.sigma) {
    result_.labels = samples.labels;
    for (const Vec3 p : samples.positions) grid_.add(p);
    open_.resize(samples.size());
    for (std::size_t i = 0; i < open_.size(); ++i) open_[i] = is_at_open_surface(i) ? 1 : 0;
  }

  SideVotes run(const RunControl& control) {
    const double boundary = volume_.thresholds().boundary;
    result_.rim = volume_.open_sides()->rim();
    if (samples_.sigma > largest_sigma * boundary) return std::move(result_);
    find_contested(control);
    if (!control.cancelled()) elect(control);
    return std::move(result_);
  }

 private:
  bool is_at_open_surface(std::size_t i) const {
    const std::uint16_t c = samples_.components[i];
    if (c < volume_.boundary_components().size())
      return volume_.open_sides()->is_open_component(volume_.boundary_components()[c].volume_component);
    return volume_.open_sides()->is_open(volume_.index().closest(samples_.positions[i]).triangle);
  }

  /// Calls visit(j) for the samples j of open surfaces within 2σ of sample i.
  template <class Visit> void for_each_near(std::uint32_t i, std::vector<std::uint32_t>& near, Visit visit) {
    const Vec3 p = samples_.positions[i];
    near.clear();
    grid_.gather(Box3{p, p}.grown(2 * samples_.sigma), near);
    for (const std::uint32_t j : near)
      if (open_[j] != 0 && distance(samples_.positions[j], p) <= 2 * samples_.sigma) visit(j);
  }

  void find_contested(const RunControl& control) {
    const auto pieces = result_.rim.pieces();
    std::vector<Segment3> bridged;
    std::vector<std::uint32_t> piece;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].open) continue;
      bridged.push_back({pieces[i].a, pieces[i].b});
      piece.push_back(i);
    }
    if (bridged.empty()) return;
    const ClosestPointIndex border(flat_triangles(bridged));
    const double reach = volume_.thresholds().boundary * (1 + over_border);
    std::vector<TriangleId> over(samples_.size());
    parallel_until(over.size(), 64, control, [&](std::size_t i) {
      if (open_[i] != 0) over[i] = border.closest_within(samples_.positions[i], reach).triangle;
    });
    SparsePoll poll(control, samples_between_questions);
    std::vector<std::uint32_t> near;
    std::vector<std::uint8_t> contested(pieces.size(), 0);
    for (std::uint32_t i = 0; i < over.size() && !poll.cancelled(); ++i) {
      if (!over[i].valid()) continue;
      bool both = false;
      for_each_near(i, near, [&](std::uint32_t j) { both |= result_.labels[j] == -result_.labels[i]; });
      if (both) contested[piece[over[i].index()]] = 1;
    }
    if (std::find(contested.begin(), contested.end(), 1) != contested.end())
      result_.rim = result_.rim.opened(contested);
    parallel_until(over.size(), 64, control, [&](std::size_t i) {
      if (over[i].valid() && result_.rim.is_nearest(samples_.positions[i], reach)) result_.labels[i] = 0;
    });
  }

  void elect(const RunControl& control) {
    DisjointSets sets(samples_.size());
    SparsePoll poll(control, samples_between_questions);
    std::vector<std::uint32_t> near;
    const auto votes = [&](std::uint32_t i) { return open_[i] != 0 && result_.labels[i] != 0; };
    for (std::uint32_t i = 0; i < samples_.size() && !poll.cancelled(); ++i)
      if (votes(i))
        for_each_near(i, near, [&](std::uint32_t j) {
          if (votes(j)) sets.unite(i, j);
        });
    std::vector<std::size_t> all(samples_.size(), 0), positive(samples_.size(), 0);
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
      if (!votes(i)) continue;
      ++all[sets.find(i)];
      positive[sets.find(i)] += result_.labels[i] > 0;
    }
    std::vector<std::uint32_t> turned, on_both;
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
      if (!votes(i)) continue;
      const std::size_t total = all[sets.find(i)], plus = positive[sets.find(i)];
      const auto exceeds = [](std::size_t part, double share, std::size_t whole) {
        return static_cast<double>(part) > share * static_cast<double>(whole);
      };
      if (exceeds(std::min(plus, total - plus), largest_minority, total) &&
          exceeds(total, largest_pocket, samples_.size())) {
        on_both.push_back(i);
        continue;
      }
      const auto elected = static_cast<std::int8_t>(2 * plus > total ? +1 : -1);
      if (std::exchange(result_.labels[i], elected) != elected) turned.push_back(i);
    }
    find_joined_sides(on_both, control);
    if (!result_.inseparable) find_lost_part(turned, control);
    std::vector<std::uint8_t> told(samples_.size(), 0);
    for (const std::uint32_t i : turned)
      for_each_near(i, near, [&](std::uint32_t j) { told[j] = result_.labels[j] != 0 ? 1 : 0; });
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (told[i] != 0) result_.votes.push_back({samples_.positions[i], result_.labels[i]});
  }

  /// Of places where both sides meet the farthest from the rim, where it is far enough that the rim is not to
  /// blame.
  void find_joined_sides(std::span<const std::uint32_t> on_both, const RunControl& control) {
    double farthest = far_from_rim * volume_.thresholds().boundary;
    SparsePoll poll(control, samples_between_questions);
    std::vector<std::uint32_t> near;
    for (const std::uint32_t i : on_both) {
      if (poll.cancelled()) return;
      if (result_.labels[i] < 0) continue;
      bool both = false;
      for_each_near(i, near, [&](std::uint32_t j) { both |= result_.labels[j] < 0; });
      if (!both) continue;
      const Vec3 p = volume_.index().closest(samples_.positions[i]).point;
      const double d = result_.rim.curve().closest(p).distance();
      if (d > farthest) farthest = d, result_.inseparable = p;
    }
  }

  /// Of places near to samples that were turned the farthest from the rim of those around which all samples
  /// are on one side.
  void find_lost_part(std::span<const std::uint32_t> turned, const RunControl& control) {
    const double boundary = volume_.thresholds().boundary, reach = far_from_other_side * boundary;
    std::vector<double> from_rim(turned.size(), 0);
    std::vector<Vec3> places(turned.size());
    parallel_until(turned.size(), 16, control, [&](std::size_t k) {
      const Vec3 p = volume_.index().closest(samples_.positions[turned[k]]).point;
      const double d = result_.rim.curve().closest(p).distance();
      if (d <= far_from_rim * boundary) return;
      std::vector<std::uint32_t> near;
      grid_.gather(Box3{p, p}.grown(reach), near);
      for (const std::uint32_t j : near)
        if (result_.labels[j] == -result_.labels[turned[k]] && distance(samples_.positions[j], p) <= reach)
          return;
      from_rim[k] = d;
      places[k] = p;
    });
    const auto farthest = std::max_element(from_rim.begin(), from_rim.end());
    if (farthest != from_rim.end() && *farthest > 0)
      result_.inseparable = places[static_cast<std::size_t>(farthest - from_rim.begin())];
  }

  const ToleranceVolume& volume_;
  const BoundarySamples& samples_;
  SampleGrid grid_;
  std::vector<std::uint8_t> open_; ///< by sample: at an open surface
  SideVotes result_;
};

} // namespace

SideVotes vote_on_sides(const ToleranceVolume& volume, const BoundarySamples& samples,
                        const RunControl& control) {
  return Vote(volume, samples).run(control);
}

} // namespace isoscope
