// Leaves go uphill to where their component was born, in parallel; what is left to be joined in the order of
// levels are these few, and the links between them.
#include "tolerance/level_histories.h"

#include "base/parallel.h"
#include "tolerance/cell_links.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

namespace isoscope {
namespace {

/// What lasts over less than this factor of δ is an effect of the cells.
constexpr double least_factor = 1.06;
constexpr std::size_t leaves_by_task = 8192;

/// The components of the leaves that were added in the order of their levels. `Before(a, b)`: a level that
/// comes before b. With `outside` what lies around the octree is one leaf more, the first of all.
template <class Before> class MergeTree {
 public:
  MergeTree(const FieldOctree& octree, bool outside)
      : octree_(octree), leaves_(static_cast<std::uint32_t>(octree.leaves())), has_outside_(outside),
        parent_(octree.leaves() + 1, leaves_) {}

  std::vector<LevelPair> find(const RunControl& control) {
    parallel_until(leaves_, leaves_by_task, control,
                   [&](std::size_t leaf) { parent_[leaf] = oldest_near(static_cast<std::uint32_t>(leaf)); });
    SparsePoll poll(control);
    for (std::uint32_t leaf = 0; leaf < leaves_ && !poll.cancelled(); ++leaf) parent_[leaf] = root(leaf);
    std::vector<Link> links = find_links(control);
    if (control.cancelled()) return {};
    sort_by_level(links, [&](const Link& link) { return value(link.saddle); });
    if (Before()(1.0, 0.0)) std::reverse(links.begin(), links.end());
    std::vector<LevelPair> ended;
    for (const Link& link : links) {
      if (poll.cancelled()) break;
      join(link, ended);
    }
    return ended;
  }

 private:
  /// Two births whose components join where `saddle` is added, which is next to the other one.
  struct Link {
    std::uint32_t a, b, saddle;
  };

  double value(std::uint32_t leaf) const {
    return leaf < leaves_ ? octree_.value(leaf) : std::numeric_limits<double>::infinity();
  }
  bool is_older(std::uint32_t a, std::uint32_t b) const {
    const double of_a = value(a), of_b = value(b);
    return of_a != of_b ? Before()(of_a, of_b) : a < b;
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::uint32_t oldest_near(std::uint32_t leaf) const {
    std::uint32_t oldest = leaf;
    const bool at_border = octree_.for_each_neighbor(leaf, [&](std::uint32_t other) {
      if (is_older(other, oldest)) oldest = other;
    });
    return at_border && has_outside_ ? leaves_ : oldest;
  }

  /// Of the links between two births those that come first, in every part of the octree; each link of leaves
  /// is asked for at its later one.
  std::vector<Link> find_links(const RunControl& control) const {
    std::vector<std::vector<Link>> parts((leaves_ + leaves_by_task - 1) / leaves_by_task);
    parallel_until(parts.size(), 1, control, [&](std::size_t part) {
      std::vector<Link>& links = parts[part];
      const std::size_t begin = part * leaves_by_task,
                        end = std::min<std::size_t>(begin + leaves_by_task, leaves_);
      for (auto leaf = static_cast<std::uint32_t>(begin); leaf < end; ++leaf)
        octree_.for_each_neighbor(leaf, [&](std::uint32_t other) {
          const auto [a, b] = std::minmax(parent_[leaf], parent_[other]);
          if (a != b && is_older(other, leaf)) links.push_back({a, b, leaf});
        });
      std::sort(links.begin(), links.end(), [&](const Link& p, const Link& q) {
        return std::tie(p.a, p.b) != std::tie(q.a, q.b) ? std::tie(p.a, p.b) < std::tie(q.a, q.b)
                                                        : is_older(p.saddle, q.saddle);
      });
      const auto same = [](const Link& p, const Link& q) { return p.a == q.a && p.b == q.b; };
      links.erase(std::unique(links.begin(), links.end(), same), links.end());
      links.shrink_to_fit();
    });
    std::vector<Link> links;
    links.reserve(std::transform_reduce(parts.begin(), parts.end(), std::size_t{0}, std::plus<>(),
                                        [](const auto& part) { return part.size(); }));
    for (std::vector<Link>& part : parts) {
      links.insert(links.end(), part.begin(), part.end());
      part = {};
    }
    return links;
  }

  /// The younger of the two components ends, if they are not one yet.
  void join(const Link& link, std::vector<LevelPair>& ended) {
    std::uint32_t old = root(link.a), young = root(link.b);
    if (old == young) return;
    if (is_older(young, old)) std::swap(old, young);
    parent_[young] = old;
    const double birth = value(young), level = value(link.saddle);
    if (std::max(birth, level) >= least_factor * std::min(birth, level))
      ended.push_back({birth, level, young, link.saddle});
  }

  const FieldOctree& octree_;
  std::uint32_t leaves_;
  bool has_outside_;
  std::vector<std::uint32_t> parent_; ///< roots are where components were born
};

} // namespace

LevelHistories find_histories(const FieldOctree& octree, const RunControl& control) {
  LevelHistories found;
  found.regions = MergeTree<std::greater<>>(octree, true).find(control);
  found.components = MergeTree<std::less<>>(octree, false).find(control);
  return found;
}

} // namespace isoscope
