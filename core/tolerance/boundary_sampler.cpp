// Covers ∂Ω' block by block: candidates in parallel, the choice among them in order.
#include "tolerance/boundary_sampler.h"

#include "base/parallel.h"
#include "tolerance/regions.h"
#include "tolerance/sample_candidates.h"
#include "tolerance/sample_grid.h"

#include <algorithm>
#include <array>
#include <span>

namespace isoscope {
namespace {

constexpr std::size_t block_cells = 4096;
/// Cells that one question about a crevice may visit.
constexpr std::size_t crevice_budget = 2000;
constexpr std::uint16_t no_component = 0xffff;

/// A cell without a boundary point of its own, to be covered by its neighbours' samples.
struct OrphanCell {
  Vec3 center;
  double half_side;
};

class Sampler {
 public:
  Sampler(ToleranceVolume& volume, double sigma) : volume_(volume), grid_(volume.domain().lo, sigma) {
    samples_.sigma = sigma;
    samples_.snap_unit = std::ldexp(1.0, std::ilogb(volume.index().bounds().longest_edge()) - 40);
    options_.target_bound = sigma;
    options_.crevice_side = sigma / 4;
    options_.smallest_side = sigma / 8;
    options_.snap_unit = samples_.snap_unit;
    options_.one_region_a_cell = one_region_a_side();
  }

  Status run(const RunControl& control) {
    const Regions& octree = volume_.octree();
    std::vector<Regions::CellIndex> block;
    for (std::size_t i = 0; i < octree.main_size(); ++i) {
      const Regions::Cell& c = octree.cell(static_cast<Regions::CellIndex>(i));
      if (c.kind == Regions::Kind::ambiguous && c.level == octree.main_level())
        block.push_back(static_cast<Regions::CellIndex>(i));
      if (block.size() < block_cells && i + 1 < octree.main_size()) continue;
      if (control.cancelled())
        return Error{ErrorCode::cancelled, "Stopped while sampling the tolerance volume.", ""};
      control.report("sampling", static_cast<double>(i + 1) / static_cast<double>(octree.main_size()));
      sample_block(block);
      block.clear();
    }
    count_undecided();
    return {};
  }

  BoundarySamples take() { return std::move(samples_); }

 private:
  bool one_region_a_side() const {
    const auto inside = std::count_if(volume_.regions().begin(), volume_.regions().end(),
                                      [](const Region& r) { return r.label < 0; });
    const double cell_diagonal = 1.7321 * volume_.octree().side(volume_.octree().main_level());
    return volume_.input().closed_manifold && volume_.regions().size() == 2 && inside == 1 &&
           cell_diagonal < 1.9 * volume_.thresholds().boundary;
  }

  void sample_block(const std::vector<Regions::CellIndex>& block) {
    std::vector<std::vector<SampleCandidate>> candidates(block.size());
    parallel_for(block.size(), 16, [&](std::size_t i) {
      find_candidates(volume_, volume_.octree().cell(block[i]), options_, candidates[i]);
    });
    for (auto& list : candidates) {
      settle_regions(list);
      cover_in_units(list);
      std::vector<SampleCandidate>().swap(list);
    }
  }

  /// Asks the octree about the few candidates in crevices wide enough to have a side.
  void settle_regions(std::span<SampleCandidate> list) {
    for (SampleCandidate& c : list) {
      if (!c.ask_octree) continue;
      c.region = volume_.region_at(c.reached, crevice_budget);
      c.has_point = c.region.valid();
      if (c.has_point) c.label = static_cast<std::int8_t>(volume_.regions()[c.region.index()].label);
    }
  }

  /// Where cells are much larger than σ, the choice among all of a cell's candidates would be slow: it is
  /// made in cubes of about σ, which are runs of the list because it is in Morton order.
  void cover_in_units(std::span<const SampleCandidate> list) {
    const Regions& octree = volume_.octree();
    double unit = octree.side(octree.main_level());
    while (unit > samples_.sigma) unit *= 0.5;
    const auto cube = [&](const SampleCandidate& c) {
      const Vec3 u = (c.center - octree.origin()) / unit;
      return std::array{std::floor(u.x), std::floor(u.y), std::floor(u.z)};
    };
    for (std::size_t begin = 0, end = 0; begin < list.size(); begin = end) {
      while (end < list.size() && cube(list[end]) == cube(list[begin])) ++end;
      cover(list.subspan(begin, end - begin));
    }
  }

  /// Adds samples until every cell of the list lies within σ of a sample of its side. Of the candidates that
  /// would do, the one that covers the most cells is taken.
  void cover(std::span<const SampleCandidate> list) {
    if (list.empty()) return;
    const double sigma = samples_.sigma;
    Box3 box;
    for (const SampleCandidate& c : list) {
      const Vec3 h{c.half_side, c.half_side, c.half_side};
      box.add(Box3{c.center - h, c.center + h});
    }
    near_.clear();
    grid_.gather(box.grown(sigma), near_);
    covered_.assign(list.size(), 0);
    for (std::size_t i = 0; i < list.size(); ++i) covered_[i] = covered_by_near(list[i]);
    // Cells with a point of their own first: their samples often cover the others.
    for (const bool own_point : {true, false}) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (covered_[i] || list[i].has_point != own_point) continue;
        const std::size_t best = best_for(list, i);
        if (best < list.size())
          add_sample(list[best], list);
        else
          orphans_.push_back({list[i].center, list[i].half_side});
      }
    }
  }

  bool covered_by_near(const SampleCandidate& cell) {
    for (const std::uint32_t s : near_) {
      if (cell.has_point && samples_.labels[s] != cell.label) continue;
      const double d = farthest_in_cube(samples_.positions[s], cell.center, cell.half_side);
      if (d > samples_.sigma) continue;
      samples_.covering_radius = std::max(samples_.covering_radius, d);
      return true;
    }
    return false;
  }

  /// Whether the point of `by` is near enough to all of the cell, and of its side where that is known.
  bool covers(const SampleCandidate& by, const SampleCandidate& cell) const {
    return (by.label == cell.label || !cell.has_point) &&
           farthest_in_cube(by.point, cell.center, cell.half_side) <= samples_.sigma;
  }

  /// The candidate that covers cell i and most others of the list; its size when none covers it.
  std::size_t best_for(std::span<const SampleCandidate> list, std::size_t i) const {
    std::size_t best = list.size(), most = 0;
    for (std::size_t j = 0; j < list.size(); ++j) {
      if (!list[j].has_point || !covers(list[j], list[i])) continue;
      std::size_t n = 0;
      for (std::size_t k = 0; k < list.size(); ++k) n += !covered_[k] && covers(list[j], list[k]);
      if (n > most) most = n, best = j;
    }
    return best;
  }

  void add_sample(const SampleCandidate& c, std::span<const SampleCandidate> list) {
    samples_.positions.push_back(c.point);
    samples_.labels.push_back(c.label);
    samples_.components.push_back(
        volume_.boundary_component(c.region, c.volume_component).value_or(no_component));
    grid_.add(c.point);
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (covered_[k] || !covers(c, list[k])) continue;
      covered_[k] = 1;
      samples_.covering_radius =
          std::max(samples_.covering_radius, farthest_in_cube(c.point, list[k].center, list[k].half_side));
    }
  }

  /// Cells without a point of their own are fine where some sample is near all the same.
  void count_undecided() {
    for (const OrphanCell& cell : orphans_) {
      const Vec3 h{cell.half_side, cell.half_side, cell.half_side};
      near_.clear();
      grid_.gather(Box3{cell.center - h, cell.center + h}.grown(samples_.sigma), near_);
      SampleCandidate as_candidate;
      as_candidate.center = cell.center;
      as_candidate.half_side = cell.half_side;
      if (!covered_by_near(as_candidate)) ++samples_.undecided_cells;
    }
  }

  ToleranceVolume& volume_;
  SampleGrid grid_;
  CandidateOptions options_;
  BoundarySamples samples_;
  std::vector<OrphanCell> orphans_;
  std::vector<std::uint32_t> near_;   ///< samples around the list at hand
  std::vector<std::uint8_t> covered_; ///< by cell of the list at hand
};

} // namespace

Result<BoundarySamples> sample_boundary(ToleranceVolume& volume, double sigma, const RunControl& control) {
  if (!(sigma > 0) || !std::isfinite(sigma))
    return Error{ErrorCode::usage, "The sampling density must be a positive length.", ""};
  Sampler sampler(volume, sigma);
  if (Status s = sampler.run(control); !s.ok()) return s.error();
  return sampler.take();
}

} // namespace isoscope
