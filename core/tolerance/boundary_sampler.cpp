// Covers ∂Ω' block by block: candidates in parallel, the choice among them in order, beside the search for
// the candidates of the next block.
#include "tolerance/boundary_sampler.h"

#include "base/labels.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/place.h"
#include "base/snap.h"
#include "tolerance/contacts.h"
#include "tolerance/region_labels.h"
#include "tolerance/regions.h"
#include "tolerance/sample_candidates.h"
#include "tolerance/sample_estimate.h"
#include "tolerance/sample_grid.h"
#include "tolerance/sample_units.h"
#include "tolerance/side_votes.h"
#include "tolerance/wall_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace isoscope {
namespace {

constexpr std::size_t block_cells = 2048;
/// Where main cells are much larger than σ: parts of one that are sampled at once, and into how many along an
/// axis it is divided at a time.
constexpr std::size_t block_parts = 32;
constexpr double halvings_at_once = 8;
constexpr std::uint32_t cells_between_questions = 65536, units_between_questions = 16;
/// Cells that one question about a crevice may visit.
constexpr std::size_t crevice_budget = 2000;
/// Wall samples this near to another sample of their side, in units of σ, tell nothing new.
constexpr double nearest_wall_sample = 0.1;
constexpr std::uint16_t no_component = 0xffff;
/// How far down, relative to δ', and how finely it is looked for what comes apart.
constexpr double least_parting = 0.01;
constexpr int parting_halvings = 10;
/// Samples that room is left for, by those that are foreseen.
constexpr double most_foreseen = 1.3;

/// A cell without a boundary point of its own, to be covered by its neighbours' samples.
struct OrphanCell {
  Vec3 center;
  double half_side;
};

Error stopped_sampling() {
  return {ErrorCode::cancelled, "Stopped while sampling the tolerance volume.", ""};
}

/// At which tolerance parts of the input come apart that are one in Ω'.
std::string parting_words(const ToleranceVolume& volume, const RunControl& control) {
  const ToleranceThresholds& t = volume.thresholds();
  const auto parts = [&](double r) { return volume.field().components(r, control).count; };
  double apart = least_parting * t.boundary, joined = t.boundary;
  if (parts(apart) <= volume.volume_component_count()) return "A smaller tolerance may keep them apart. ";
  for (int i = 0; i < parting_halvings && !control.cancelled(); ++i) {
    const double middle = 0.5 * (apart + joined);
    (parts(middle) > volume.volume_component_count() ? apart : joined) = middle;
  }
  return "Below δ = " + general(apart * t.delta / t.boundary, 3) + " parts of the input come apart. ";
}

/// What keeps a surface from separating the sides of open sheets near p: sheets that cross, where triangles
/// do, at the nearest such place, else what Ω joins.
Error inseparable_near(const ToleranceVolume& volume, Vec3 p, const RunControl& control) {
  double least = std::numeric_limits<double>::infinity();
  std::optional<Vec3> crossing;
  for (const Contact& contact : find_contacts(volume.index(), control)) {
    if (contact[0] == contact[1]) continue; // holes that meet in a vertex, or parts that touch in one
    const Vec3 middle = 0.5 * (contact[0] + contact[1]);
    if (const double d = distance(middle, p); d < least) least = d, crossing = middle;
  }
  if (crossing)
    return {ErrorCode::joined_sheets,
            "The input is not a manifold surface: sheets cross or branch near " +
                place(*crossing, place_digits) + ".",
            "Cut them apart along that line, and leave out what is not wanted."};
  return {
      ErrorCode::joined_sheets,
      "The sides of the open surface cannot be told apart near " + place(p, place_digits) +
          ": none of its triangles cross there, but Ω joins its parts, so that what lies across from each "
          "other is one side.",
      parting_words(volume, control) +
          "Filling the holes there, or taking out what lies between the parts, helps too."};
}

class Sampler {
 public:
  Sampler(ToleranceVolume& volume, SampleDensity density)
      : volume_(volume), grid_(volume.domain().lo, density.sigma),
        flat_grid_(volume.domain().lo, density.flat_sigma), flat_sigma_(density.flat_sigma) {
    const double sigma = samples_.sigma = density.sigma;
    // Lists that grow would be there twice; what is foreseen and not used takes no memory.
    const double foreseen = most_foreseen * estimate_samples(volume).samples(sigma);
    samples_.positions.reserve(static_cast<std::size_t>(foreseen));
    samples_.labels.reserve(static_cast<std::size_t>(foreseen));
    samples_.components.reserve(static_cast<std::size_t>(foreseen));
    samples_.snap_unit = snap_unit(volume.field().bounds().longest_edge(), volume.domain());
    options_.target_bound = sigma;
    options_.crevice_side = sigma / 4;
    options_.smallest_side = sigma / 8;
    options_.snap_unit = samples_.snap_unit;
    options_.one_region_a_cell = one_region_a_side();
    std::size_t labels = 2;
    for (const Region& r : volume.regions()) labels = std::max(labels, place_of(r.label) + 1);
    coverable_.resize(labels + (volume.open_sides() != nullptr ? 1 : 0));
  }

  Status run(const RunControl& control) {
    const Regions& octree = volume_.octree();
    const bool flats = options_.one_region_a_cell && volume_.has_surface() && volume_.open_sides() == nullptr;
    const SampleUnitFinder finder(volume_, samples_.sigma, flats ? flat_sigma_ : 0, options_);
    const auto part_side = finder.part_side();
    const std::size_t block_size = part_side ? 1 : block_cells;
    SparsePoll poll(control, cells_between_questions);
    std::vector<Regions::CellIndex> block;
    for (std::size_t i = 0; i < octree.main_size() && !poll.cancelled(); ++i) {
      const Regions::Cell c = octree.cell(static_cast<Regions::CellIndex>(i));
      if (c.kind == Regions::Kind::ambiguous && c.level == octree.main_level())
        block.push_back(static_cast<Regions::CellIndex>(i));
      if (block.empty() || (block.size() < block_size && i + 1 < octree.main_size())) continue;
      if (control.cancelled()) break;
      control.report("sampling", static_cast<double>(i + 1) / static_cast<double>(octree.main_size()));
      if (part_side)
        sample_parts(finder, cube_of(volume_, c), *part_side, control);
      else
        sample_block(finder, block, control);
      block.clear();
    }
    cover_found(control);
    count_undecided(control);
    if (control.cancelled()) return stopped_sampling();
    return {};
  }

  Result<BoundarySamples> take(const RunControl& control) {
    set_boundary_samples_apart();
    if (volume_.open_sides() != nullptr) {
      if (Status settled = settle_open_sides(control); !settled) return settled.error();
      set_boundary_samples_apart();
      add_wall_samples();
    }
    return std::move(samples_);
  }

 private:
  bool one_region_a_side() const {
    const auto inside = std::count_if(volume_.regions().begin(), volume_.regions().end(),
                                      [](const Region& r) { return r.label < 0; });
    const double cell_diagonal = 1.7321 * volume_.octree().side(volume_.octree().main_level());
    return volume_.sides().known() && volume_.regions().size() == 2 && inside == 1 &&
           cell_diagonal < 1.9 * volume_.thresholds().boundary;
  }

  /// Refinement ignores B: what is over the rim is on no side.
  void set_boundary_samples_apart() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_.labels[i] == 0) {
        samples_.over_rim.push_back(samples_.positions[i]);
        continue;
      }
      samples_.positions[kept] = samples_.positions[i];
      samples_.labels[kept] = samples_.labels[i];
      samples_.components[kept++] = samples_.components[i];
    }
    samples_.positions.resize(kept);
    samples_.labels.resize(kept);
    samples_.components.resize(kept);
  }

  /// Single normals err where the sheet meets itself; all samples that hang together do not.
  Status settle_open_sides(const RunControl& control) {
    if (volume_.open_sides()->by_samples()) return {};
    SideVotes result = vote_on_sides(volume_, samples_, control);
    if (control.cancelled()) return {};
    if (result.inseparable) return inseparable_near(volume_, *result.inseparable, control);
    samples_.labels = std::move(result.labels);
    volume_.settle_open_sides(std::make_shared<const OpenSides>(
        volume_.open_sides()->settled(std::move(result.rim), std::move(result.votes), 2 * samples_.sigma)));
    return {};
  }

  void add_wall_samples() {
    SampleGrid grid(volume_.domain().lo, samples_.sigma);
    for (const Vec3 p : samples_.positions) grid.add(p);
    for (const WallSample& s : wall_samples(volume_)) {
      const Vec3 p = snapped(s.point, samples_.snap_unit);
      const double apart = nearest_wall_sample * samples_.sigma;
      near_.clear();
      grid.gather(Box3{p, p}.grown(samples_.sigma), near_);
      std::uint16_t component = no_component;
      double least = std::numeric_limits<double>::infinity();
      for (const std::uint32_t other : near_)
        if (const double d = distance(samples_.positions[other], p);
            samples_.labels[other] == s.label && d < least)
          least = d, component = samples_.components[other];
      if (least < apart) continue;
      samples_.positions.push_back(p);
      samples_.labels.push_back(s.label);
      samples_.components.push_back(component);
      grid.add(p);
    }
  }

  void sample_block(const SampleUnitFinder& finder, std::span<const Regions::CellIndex> block,
                    const RunControl& control) {
    std::vector<std::span<const Regions::CellIndex>> groups;
    for (std::size_t begin = 0, end = 0; begin < block.size(); begin = end) {
      while (end < block.size() && finder.together(block[begin], block[end])) ++end;
      groups.push_back(block.subspan(begin, end - begin));
    }
    sample_all(
        groups, [&](const auto& group) { return finder.find(group); }, control);
  }

  /// Samples a main cell that is much larger than σ, a few parts at a time.
  void sample_parts(const SampleUnitFinder& finder, const CandidateCube& main_cell, double part_side,
                    const RunControl& control) {
    const double middle_side = std::max(part_side, main_cell.side / halvings_at_once);
    std::vector<CandidateCube> middles, parts;
    split_cube(volume_, main_cell, middle_side, middles);
    for (const CandidateCube& middle : middles) {
      if (control.cancelled()) return;
      if (middle.side > part_side * (1 + 1e-9)) {
        sample_parts(finder, middle, part_side, control);
        continue;
      }
      parts.push_back(middle);
      if (parts.size() < block_parts && &middle != &middles.back()) continue;
      sample_all(
          std::exchange(parts, {}), [&](const CandidateCube& part) { return finder.find(part); }, control);
    }
  }

  /// Finds the units of all items in parallel. They are covered in order, while those of the next items are
  /// found: what that asks of the octree has changed by then as far as it does.
  template <class Item, class Find>
  void sample_all(const std::vector<Item>& items, const Find& find, const RunControl& control) {
    std::vector<std::vector<SampleUnit>> units(items.size());
    parallel_until(items.size() + 1, 1, control, [&](std::size_t i) {
      if (i == 0)
        cover_found(control);
      else
        units[i - 1] = find(items[i - 1]);
    });
    SparsePoll poll(control, units_between_questions);
    for (auto& list : units)
      for (SampleUnit& unit : list) {
        if (poll.cancelled()) return;
        settle_regions(unit.cells, control);
      }
    found_ = std::move(units);
  }

  /// Covers the units that were found last.
  void cover_found(const RunControl& control) {
    SparsePoll poll(control, units_between_questions);
    for (auto& list : std::exchange(found_, {}))
      for (SampleUnit& unit : list) {
        if (poll.cancelled()) return;
        cover(unit);
        unit = {};
      }
  }

  /// Asks the octree about the few candidates in crevices wide enough to have a side.
  void settle_regions(std::span<SampleCandidate> list, const RunControl& control) {
    for (SampleCandidate& c : list) {
      if (!c.ask_octree) continue;
      c.region = volume_.region_at(c.reached, crevice_budget, control);
      c.has_point = c.region.valid();
      if (c.has_point) c.label = static_cast<std::int8_t>(volume_.regions()[c.region.index()].label);
    }
  }

  /// Adds samples until every cell of the unit lies within σ of a sample of its side: always the one next
  /// that covers the most cells not yet covered.
  void cover(const SampleUnit& unit) {
    const std::size_t words = unit.words();
    open_.assign(words, 0);
    row_.resize(words);
    for (auto& side : coverable_) side.assign(words, 0);
    for (std::size_t i = 0; i < unit.cells.size(); ++i) {
      const SampleCandidate& c = unit.cells[i];
      const std::uint64_t bit = std::uint64_t{1} << i % 64;
      open_[i / 64] |= bit;
      for (std::size_t side = 0; side < coverable_.size(); ++side)
        if (!c.has_point || slot_of(c.label) == side) coverable_[side][i / 64] |= bit;
    }
    gather_near(unit);
    for (const std::uint32_t s : near_) {
      const Vec3 p = samples_.positions[s];
      unit.find_row(p, row_);
      close(unit, row_, p, samples_.labels[s]);
    }
    bounds_.assign(unit.offers().size(), unit.cells.size());
    for (;;) {
      const std::size_t best = best_offer(unit);
      if (best == unit.offers().size()) break;
      add_sample(unit, unit.offers()[best], unit.row(best));
    }
    // What no offer covers, another point may: cells with a point of their own first, which cover the others.
    for (const bool own_point : {true, false})
      for (std::size_t i = 0; i < unit.cells.size(); ++i) {
        if (!is_open(i) || unit.cells[i].has_point != own_point) continue;
        const std::size_t by = coverer(unit, i);
        if (by < unit.cells.size()) {
          unit.find_row(unit.cells[by].point, row_);
          add_sample(unit, by, row_);
        } else {
          orphans_.push_back({unit.cells[i].center, unit.cells[i].half_side});
        }
      }
  }

  /// Samples that may cover cells of the unit. In planes those of their borders do not count: their grid is
  /// fine for cells as large.
  void gather_near(const SampleUnit& unit) {
    near_.clear();
    const Box3 box = unit.box().grown(unit.sigma());
    if (unit.sigma() == samples_.sigma) return grid_.gather(box, near_);
    flat_grid_.gather(box, near_);
    for (std::uint32_t& s : near_) s = flat_samples_[s];
  }

  /// A candidate whose point covers cell i, its own if that does; their number when none does. Asks for a
  /// little more than σ, so that rows agree.
  std::size_t coverer(const SampleUnit& unit, std::size_t i) const {
    const SampleCandidate& cell = unit.cells[i];
    const auto does = [&](const SampleCandidate& by) {
      return by.has_point && (!cell.has_point || by.label == cell.label) &&
             farthest_in_cube(by.point, cell.center, cell.half_side) <= unit.sigma() * (1 - 1e-4);
    };
    if (does(cell)) return i;
    const auto found = std::find_if(unit.cells.begin(), unit.cells.end(), does);
    return static_cast<std::size_t>(found - unit.cells.begin());
  }

  /// Where a label has its bits: what is over the rim, on no side, in the last place.
  std::size_t slot_of(int label) const { return label == 0 ? coverable_.size() - 1 : place_of(label); }
  bool is_open(std::size_t cell) const { return open_[cell / 64] >> cell % 64 & 1u; }

  /// The candidate point that covers the most open cells; the number of offers when none covers any.
  std::size_t best_offer(const SampleUnit& unit) {
    std::size_t best = unit.offers().size(), most = 0;
    for (std::size_t i = 0; i < unit.offers().size(); ++i) {
      const SampleCandidate& c = unit.cells[unit.offers()[i]];
      // What a candidate covers gets less only, so that its last count bounds it.
      if (!c.has_point || bounds_[i] <= most) continue;
      const auto row = unit.row(i);
      std::size_t n = 0;
      for (std::size_t w = 0; w < row.size(); ++w)
        n += static_cast<std::size_t>(std::popcount(row[w] & open_[w] & coverable_[slot_of(c.label)][w]));
      bounds_[i] = n;
      if (n > most) most = n, best = i;
    }
    return best;
  }

  void add_sample(const SampleUnit& unit, std::size_t cell, std::span<const std::uint64_t> row) {
    const SampleCandidate& c = unit.cells[cell];
    samples_.positions.push_back(c.point);
    samples_.labels.push_back(c.label);
    samples_.components.push_back(
        volume_.boundary_component(c.region, c.volume_component).value_or(no_component));
    grid_.add(c.point);
    if (unit.sigma() != samples_.sigma) {
      flat_samples_.push_back(static_cast<std::uint32_t>(samples_.size() - 1));
      flat_grid_.add(c.point);
    }
    close(unit, row, c.point, c.label);
  }

  /// Marks the open cells of a sample's row as covered, as far as they are of its side or of none.
  void close(const SampleUnit& unit, std::span<const std::uint64_t> row, Vec3 p, int label) {
    for (std::size_t w = 0; w < row.size(); ++w) {
      const std::uint64_t covered = row[w] & open_[w] & coverable_[slot_of(label)][w];
      open_[w] &= ~covered;
      for (std::uint64_t rest = covered; rest != 0; rest &= rest - 1) {
        const SampleCandidate& cell = unit.cells[64 * w + static_cast<std::size_t>(std::countr_zero(rest))];
        samples_.covering_radius =
            std::max(samples_.covering_radius, farthest_in_cube(p, cell.center, cell.half_side));
      }
    }
  }

  bool covered_by_near(const OrphanCell& cell) {
    for (const std::uint32_t s : near_) {
      const double d = farthest_in_cube(samples_.positions[s], cell.center, cell.half_side);
      if (d > samples_.sigma) continue;
      samples_.covering_radius = std::max(samples_.covering_radius, d);
      return true;
    }
    return false;
  }

  /// Cells without a point of their own are fine where some sample is near all the same.
  void count_undecided(const RunControl& control) {
    SparsePoll poll(control, units_between_questions);
    for (const OrphanCell& cell : orphans_) {
      if (poll.cancelled()) return;
      const Vec3 h{cell.half_side, cell.half_side, cell.half_side};
      near_.clear();
      grid_.gather(Box3{cell.center - h, cell.center + h}.grown(samples_.sigma), near_);
      if (!covered_by_near(cell)) ++samples_.undecided_cells;
    }
  }

  ToleranceVolume& volume_;
  SampleGrid grid_;      ///< of the samples
  SampleGrid flat_grid_; ///< of those in planes
  std::vector<std::uint32_t> flat_samples_;
  BoundarySamples samples_;
  double flat_sigma_;
  CandidateOptions options_;
  std::vector<std::vector<SampleUnit>> found_; ///< not yet covered
  std::vector<OrphanCell> orphans_;
  std::vector<std::uint32_t> near_; ///< samples around the cells at hand
  // Of the unit at hand:
  std::vector<std::uint64_t> open_; ///< bits of the cells that no sample covers yet
  std::vector<std::vector<std::uint64_t>>
      coverable_; ///< bits of the cells that each label's samples may cover
  std::vector<std::uint64_t> row_;
  std::vector<std::size_t> bounds_; ///< by offer: it covers at most so many open cells
};

} // namespace

Result<BoundarySamples> sample_boundary(ToleranceVolume& volume, SampleDensity density,
                                        const RunControl& control) {
  if (!(density.sigma > 0) || !std::isfinite(density.sigma))
    return Error{ErrorCode::usage, "The sampling density must be a positive length.", ""};
  volume.settle_open_sides(volume.open_sides_found());
  Sampler sampler(volume, density);
  if (Status s = sampler.run(control); !s.ok()) return s.error();
  Result<BoundarySamples> samples = sampler.take(control);
  if (control.cancelled()) return stopped_sampling();
  return samples;
}

} // namespace isoscope
