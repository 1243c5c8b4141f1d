// Counts vertices, edges and faces of the marching-tetrahedra surface without making it.
#include "tolerance/boundary_topology.h"

#include "base/parallel.h"
#include "base/scramble.h"
#include "tolerance/kuhn_simplices.h"
#include "tolerance/regions.h"
#include "tolerance/rounding.h"
#include "tolerance/surface_pieces.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <span>

namespace isoscope {
namespace {

/// Cells that share their corners, and how many such blocks are counted at once.
constexpr std::size_t counted_block = 32768, blocks_at_once = 4;
/// Cells of the octree that are looked at at once, and by one thread.
constexpr std::size_t roots_at_once = 16384, roots_grain = 64;
/// Cells whose pieces are counted at most: some 100 bytes each. Noise leaves pockets in Ω that finer cells
/// break into pieces as well, so that of points fewer are worth it.
constexpr std::size_t most_careful_cells = 6'000'000, most_careful_cells_of_points = 1'000'000;
/// The same of cells that the one surface that is counted may pass through: its vertices alone are kept.
constexpr std::size_t most_offset_cells = 20'000'000;

/// A lattice point: on which side it lies, and of what.
struct Corner {
  bool outside = false;
  RegionId region;                    ///< when outside; of nested sets the first one that it belongs to
  std::uint32_t volume_component = 0; ///< of the site that gives φ, or below it
};

struct LatticeCell {
  std::uint32_t x, y, z;
  TriangleId triangle;
};

constexpr unsigned key_bits = 21;
constexpr std::uint64_t corner_key(const LatticeCell& c, unsigned k) {
  return (std::uint64_t{c.z} + (k >> 2)) << (2 * key_bits) |
         (std::uint64_t{c.y} + ((k >> 1) & 1u)) << key_bits | (std::uint64_t{c.x} + (k & 1u));
}

/// The corners of some cells, each once, by number in the order in which they come first.
class CornerNumbers {
 public:
  struct Entry {
    std::uint64_t key;
    TriangleId guess; ///< the first of those that it comes with
  };

  explicit CornerNumbers(std::size_t expected) { grow(std::bit_ceil(2 * expected + 2)); }

  std::uint32_t number(std::uint64_t key, TriangleId guess) {
    if (2 * list_.size() >= slots_.size()) grow(2 * slots_.size());
    std::uint32_t& slot = slots_[slot_of(key)];
    if (slot == none) {
      slot = static_cast<std::uint32_t>(list_.size());
      list_.push_back({key, guess});
    } else if (guess < list_[slot].guess) {
      list_[slot].guess = guess;
    }
    return slot;
  }
  const std::vector<Entry>& list() const { return list_; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Where a key is, or would be.
  std::size_t slot_of(std::uint64_t key) const {
    std::size_t i = scrambled(key) & (slots_.size() - 1);
    while (slots_[i] != none && list_[slots_[i]].key != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void grow(std::size_t size) {
    slots_.assign(size, none);
    for (std::uint32_t i = 0; i < list_.size(); ++i) slots_[slot_of(list_[i].key)] = i;
  }

  std::vector<Entry> list_;
  std::vector<std::uint32_t> slots_; ///< numbers; a power of two of them, at most half of which are taken
};

class Counter {
 public:
  Counter(const ToleranceVolume& volume, const BoundaryCounting& counting)
      : volume_(volume), careful_(counting.careful), level_(volume.octree().main_level() + counting.halvings),
        simplices_(kuhn::simplices_at_corner()), counts_(volume.boundary_components().size()), pieces_(1) {}
  Counter(const ToleranceVolume& volume, const OffsetCounting& counting)
      : volume_(volume), careful_(true), offset_(&counting),
        level_(volume.octree().main_level() + counting.halvings), simplices_(kuhn::simplices_at_corner()),
        counts_(counting.sets), pieces_(counting.sets) {}

  Status run(const RunControl& control) {
    const Regions& octree = volume_.octree();
    const std::size_t most = offset_ != nullptr                            ? most_offset_cells
                             : volume_.field().kind() == FieldKind::points ? most_careful_cells_of_points
                                                                           : most_careful_cells;
    const Error too_large{ErrorCode::unsupported, "The boundaries of Ω are too large to count their pieces.",
                          ""};
    const Error stopped{ErrorCode::cancelled, "Stopped while building the tolerance volume.", ""};
    if (careful_ && (!SurfacePieces::fits(level_) || (offset_ == nullptr && lattice_cells() > most)))
      return too_large;
    std::size_t counted = 0;
    std::vector<Regions::Cell> roots;
    std::vector<LatticeCell> cells;
    for (std::size_t i = 0; i < octree.main_size(); ++i) {
      const bool is_last = i + 1 == octree.main_size();
      const auto index = static_cast<Regions::CellIndex>(i);
      if (offset_ != nullptr || octree.kind(index) == Regions::Kind::ambiguous)
        if (const Regions::Cell c = octree.cell(index); is_counted(c)) roots.push_back(c);
      if (roots.size() < roots_at_once && !is_last) continue;
      add_lattice_cells(roots, cells, control);
      roots.clear();
      if (careful_ && counted + cells.size() > most) return too_large;
      if (cells.size() < blocks_at_once * counted_block && !is_last) continue;
      control.report("boundary", static_cast<double>(i) / static_cast<double>(octree.main_size()));
      if (control.cancelled()) return stopped;
      count_blocks(cells, control);
      counted += cells.size();
      cells.clear();
    }
    if (control.cancelled()) return stopped;
    return {};
  }
  std::vector<BoundaryCount> take(const RunControl& control) {
    if (offset_ != nullptr) {
      for (std::size_t j = 0; j < counts_.size(); ++j)
        counts_[j].pieces = pieces_[j].count(1, control).front();
    } else if (careful_) {
      const std::vector<std::size_t> pieces = pieces_.front().count(counts_.size(), control);
      for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i].pieces = pieces[i];
    }
    return std::move(counts_);
  }

 private:
  std::size_t lattice_cells() const {
    const Regions& octree = volume_.octree();
    std::size_t cells = 0;
    for (std::size_t i = 0; i < octree.main_size(); ++i) {
      const Regions::Cell c = octree.cell(static_cast<Regions::CellIndex>(i));
      if (is_counted(c)) cells += std::size_t{1} << (3 * (level_ - c.level));
    }
    return cells;
  }

  /// Whether the surface that is counted may pass through a cell.
  bool is_counted(const Regions::Cell& c) const {
    const Regions& octree = volume_.octree();
    if (offset_ == nullptr) return c.kind == Regions::Kind::ambiguous && c.level == octree.main_level();
    const bool is_leaf = c.child == Regions::none || c.child >= octree.main_size();
    return is_leaf && c.kind != Regions::Kind::out &&
           static_cast<double>(c.distance) >=
               volume_.thresholds().boundary - offset_->reach - half_diagonal * octree.side(c.level);
  }

  static std::array<std::uint32_t, 3> place(std::uint64_t key) {
    constexpr std::uint64_t mask = (std::uint64_t{1} << key_bits) - 1;
    return {static_cast<std::uint32_t>(key & mask), static_cast<std::uint32_t>(key >> key_bits & mask),
            static_cast<std::uint32_t>(key >> (2 * key_bits))};
  }
  Vec3 position(std::uint64_t key) const {
    const auto [x, y, z] = place(key);
    const Vec3 u{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    return volume_.octree().origin() + volume_.octree().side(level_) * u;
  }

  /// What the octree's cells around a corner tell. All of an OUT cell is in its region, all of an IN cell in
  /// the component of Ω' of the site that gives φ at its centre. OUT cells are not counted, so all their
  /// corners must be known.
  struct Surroundings {
    std::optional<Corner> corner; ///< when a cell that has it on its border decides
    RegionId finer_region;        ///< of a cell close by that may be too small to reach it
  };
  Surroundings surroundings(Vec3 p, const std::array<std::uint32_t, 3>& place) const {
    const Regions& octree = volume_.octree();
    const double offset = 0.25 * octree.side(level_);
    const std::uint32_t cells = 1u << level_;
    Surroundings result;
    for (unsigned k = 0; k < 8; ++k) {
      // Below 0 they wrap around.
      const std::array<std::uint32_t, 3> beside{place[0] - (k & 1u ? 0 : 1), place[1] - (k & 2u ? 0 : 1),
                                                place[2] - (k & 4u ? 0 : 1)};
      const bool is_inside = beside[0] < cells && beside[1] < cells && beside[2] < cells;
      Regions::CellIndex i = is_inside ? octree.cell_at(level_, beside) : Regions::none;
      if (i != Regions::none && octree.child(i) != Regions::none)
        i = octree.locate(
            p + Vec3{k & 1u ? offset : -offset, k & 2u ? offset : -offset, k & 4u ? offset : -offset});
      if (i == Regions::none) {
        result.corner = Corner{true, RegionId(0), 0};
        return result;
      }
      const Regions::Kind kind = octree.kind(i);
      if (kind == Regions::Kind::ambiguous) continue;
      const Regions::Cell c = octree.cell(i);
      const bool reaches = c.level <= level_;
      if (kind == Regions::Kind::in && reaches) {
        result.corner = Corner{false, RegionId(), volume_.volume_component(c.triangle)};
        return result;
      }
      if (kind != Regions::Kind::out) continue;
      const auto number = octree.number(i);
      if (number && reaches) {
        result.corner = Corner{true, RegionId(*number), 0};
        return result;
      }
      if (number && !result.finer_region.valid()) result.finer_region = RegionId(*number);
    }
    return result;
  }

  /// Which of the sets a corner is in whose boundaries are counted.
  Corner examine_offset(Vec3 p, TriangleId guess) const {
    const std::optional<unsigned> set = offset_->first_set(p, guess);
    return set ? Corner{true, RegionId(*set), 0} : Corner{};
  }

  Corner examine(std::uint64_t key, TriangleId guess) const {
    const Vec3 p = position(key);
    if (offset_ != nullptr) return examine_offset(p, guess);
    const auto [told, finer_region] = surroundings(p, place(key));
    const bool one_component = volume_.volume_component_count() == 1;
    if (told && (one_component || !told->outside)) return *told;
    const ClosestPoint closest = volume_.field().closest_near(p, guess);
    Corner corner = told.value_or(Corner{});
    corner.volume_component = volume_.component_below(p, closest);
    if (!told && closest.distance() > volume_.thresholds().boundary) {
      corner.region = finer_region.valid() ? finer_region : volume_.escape(p, closest).region;
      if (careful_ && !corner.region.valid()) corner.region = only_region(p, corner.volume_component);
      corner.outside = corner.region.valid();
    }
    return corner;
  }

  /// The region on the side of a point outside of Ω', where there is but one on that side of what is below.
  RegionId only_region(Vec3 p, std::uint32_t volume_component) const {
    if (!volume_.sides().known()) return {};
    const int label = volume_.sides().label(p);
    RegionId region;
    for (const BoundaryComponent& c : volume_.boundary_components()) {
      if (c.volume_component != volume_component || c.label != label) continue;
      if (region.valid()) return {};
      region = c.region;
    }
    return region;
  }

  /// The corners of a cell, and their numbers in its block.
  struct CellCorners {
    std::array<const Corner*, 8> corners{};
    std::span<const std::uint32_t, 8> numbers;
  };

  /// What some cells add to the counts.
  struct Part {
    std::vector<long> euler_characteristics; ///< by boundary component, or by set
    std::vector<SurfacePieces> pieces;       ///< of all components; by set
  };

  /// The lattice's cells in cells of the octree through which the surface may pass.
  void add_lattice_cells(const std::vector<Regions::Cell>& roots, std::vector<LatticeCell>& cells,
                         const RunControl& control) const {
    std::vector<std::vector<LatticeCell>> found(roots.size());
    parallel_until(roots.size(), roots_grain, control, [&](std::size_t i) {
      const Regions::Cell& c = roots[i];
      if (offset_ != nullptr) return descend({c.x, c.y, c.z, c.triangle}, c.level, found[i]);
      const std::uint32_t n = 1u << (level_ - c.level);
      for (std::uint32_t k = 0; k < n * n * n; ++k)
        found[i].push_back({c.x * n + k % n, c.y * n + k / n % n, c.z * n + k / (n * n), c.triangle});
    });
    for (const auto& list : found) cells.insert(cells.end(), list.begin(), list.end());
  }

  /// Halves a cell as long as the surface may pass through it.
  void descend(const LatticeCell& c, unsigned level, std::vector<LatticeCell>& cells) const {
    if (level == level_) return cells.push_back(c);
    const double side = volume_.octree().side(level);
    const Vec3 center = volume_.octree().origin() + side * Vec3{c.x + 0.5, c.y + 0.5, c.z + 0.5};
    if (!offset_->near(center, half_diagonal * side)) return;
    for (std::uint32_t k = 0; k < 8; ++k)
      descend({2 * c.x + (k & 1u), 2 * c.y + (k >> 1 & 1u), 2 * c.z + (k >> 2), c.triangle}, level + 1,
              cells);
  }

  void count_blocks(const std::vector<LatticeCell>& cells, const RunControl& control) {
    std::vector<Part> parts((cells.size() + counted_block - 1) / counted_block);
    if (!parallel_until(parts.size(), 1, control, [&](std::size_t b) {
          const auto block = std::span(cells).subspan(b * counted_block);
          parts[b].euler_characteristics.assign(counts_.size(), 0);
          count(block.first(std::min(counted_block, block.size())), parts[b], control);
        }))
      return;
    for (const Part& part : parts) {
      for (std::size_t i = 0; i < counts_.size(); ++i)
        counts_[i].euler_characteristic += part.euler_characteristics[i];
      for (std::size_t j = 0; j < part.pieces.size(); ++j) pieces_[j].add(part.pieces[j]);
    }
  }

  void count(std::span<const LatticeCell> cells, Part& part, const RunControl& control) const {
    CornerNumbers numbers(2 * cells.size());
    std::vector<std::uint32_t> corner_of(8 * cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (unsigned k = 0; k < 8; ++k)
        corner_of[8 * i + k] = numbers.number(corner_key(cells[i], k), cells[i].triangle);
    std::vector<Corner> corners(numbers.list().size());
    const bool complete = parallel_until(corners.size(), 256, control, [&](std::size_t i) {
      corners[i] = examine(numbers.list()[i].key, numbers.list()[i].guess);
    });
    if (!complete) return;

    std::vector<PiecesOfBlock> pieces;
    for (std::size_t j = 0; careful_ && j < pieces_.size(); ++j) pieces.emplace_back(corners.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      CellCorners at{{}, std::span(corner_of).subspan(8 * i).first<8>()};
      for (unsigned k = 0; k < 8; ++k) at.corners[k] = &corners[at.numbers[k]];
      for (PiecesOfBlock& p : pieces)
        for (const std::uint32_t corner : at.numbers) p.see(corner);
      if (offset_ != nullptr)
        count_sets(at, part, pieces);
      else
        count_cell(at, part, pieces);
    }
    for (const PiecesOfBlock& p : pieces)
      part.pieces.push_back(
          p.settled([&](std::uint32_t corner) { return place(numbers.list()[corner].key); }));
  }

  /// A cell whose corners are in nested sets.
  void count_sets(const CellCorners& at, Part& part, std::vector<PiecesOfBlock>& pieces) const {
    for (std::size_t set = 0; set < pieces.size(); ++set) {
      unsigned outer = 0;
      for (unsigned k = 0; k < 8; ++k)
        outer |= (at.corners[k]->outside && at.corners[k]->region.index() <= set ? 1u : 0u) << k;
      part.euler_characteristics[set] += euler_[outer];
      add_pieces(
          at, outer, [](const Corner&) { return std::optional(std::uint16_t{0}); }, pieces[set]);
    }
  }

  /// Regions that come close to each other are counted one at a time, each against all that is not in it: so
  /// every count is that of a closed surface.
  void count_cell(const CellCorners& at, Part& part, std::vector<PiecesOfBlock>& pieces) const {
    if (careful_ ? is_uniform(at.corners) : count_plain_cell(at.corners, part)) return;
    for (unsigned k = 0; k < 8; ++k) {
      if (!at.corners[k]->outside) continue;
      const RegionId region = at.corners[k]->region;
      const auto is_in_region = [&](const Corner* c) { return c->outside && c->region == region; };
      if (std::any_of(at.corners.begin(), at.corners.begin() + k, is_in_region)) continue;
      unsigned outer = 0;
      for (unsigned j = k; j < 8; ++j) outer |= (is_in_region(at.corners[j]) ? 1u : 0u) << j;
      if (outer == 0xff) return;
      count_region(at.corners, region, outer, part);
      const auto component = [&](const Corner& inner) { return component_between(region, inner); };
      for (PiecesOfBlock& p : pieces) add_pieces(at, outer, component, p);
    }
  }

  /// No surface passes through a cell whose corners are in one region, or in none.
  static bool is_uniform(const std::array<const Corner*, 8>& at) {
    return std::all_of(at.begin() + 1, at.end(), [&](const Corner* c) {
      return c->outside == at[0]->outside && (!c->outside || c->region == at[0]->region);
    });
  }

  /// A cell with one region and one component of Ω' at its corners, at once; false where there are more.
  bool count_plain_cell(const std::array<const Corner*, 8>& at, Part& part) const {
    unsigned outer = 0;
    const Corner *out = nullptr, *in = nullptr;
    for (unsigned k = 0; k < 8; ++k) {
      const Corner*& first = at[k]->outside ? out : in;
      if (first == nullptr) first = at[k];
      if (at[k]->outside ? at[k]->region != out->region : at[k]->volume_component != in->volume_component)
        return false;
      outer |= (at[k]->outside ? 1u : 0u) << k;
    }
    if (out == nullptr || in == nullptr) return true;
    if (const auto component = component_between(out->region, *in))
      part.euler_characteristics[*component] += euler_[outer];
    return true;
  }

  std::optional<std::uint16_t> component_between(RegionId outer, const Corner& inner) const {
    return volume_.boundary_component(outer, inner.volume_component);
  }

  /// What a cell adds to χ of the boundaries of a region that has some of its corners.
  void count_region(const std::array<const Corner*, 8>& at, RegionId region, unsigned outer,
                    Part& part) const {
    const auto is_outer = [&](unsigned k) { return (outer >> k & 1u) != 0; };
    for (const kuhn::Simplex& s : simplices_) {
      if ((s.mask & outer) == 0 || (s.mask & ~outer) == 0) continue;
      const auto inner = std::find_if_not(s.corners.begin(), s.corners.begin() + s.size, is_outer);
      if (const auto component = component_between(region, *at[*inner]))
        part.euler_characteristics[*component] += s.sign;
    }
  }

  /// The vertices and links of a surface that has some of a cell's corners behind it; a vertex is of the
  /// boundary component that `component` tells by the other corner of its edge, if of any.
  template <class Component>
  void add_pieces(const CellCorners& at, unsigned outer, const Component& component,
                  PiecesOfBlock& pieces) const {
    const auto vertex = [&](const kuhn::CrossedEdge& e) {
      return PiecesOfBlock::vertex(at.numbers[e.low], e.direction, e.low_is_outer);
    };
    const kuhn::Crossings& crossings = crossings_[outer];
    for (const kuhn::CrossedEdge& e : crossings.vertices)
      if (const std::optional<std::uint16_t> c = component(*at.corners[e.inner()])) pieces.add(vertex(e), *c);
    for (const auto& [a, b] : crossings.links) pieces.join(vertex(a), vertex(b));
  }

  const ToleranceVolume& volume_;
  bool careful_;
  const OffsetCounting* offset_ = nullptr; ///< null where all boundaries of Ω' are counted
  unsigned level_;
  std::vector<kuhn::Simplex> simplices_;
  std::array<std::int8_t, 256> euler_ = kuhn::euler_by_outer_corners(simplices_);
  std::vector<kuhn::Crossings> crossings_ = kuhn::crossings_by_outer_corners(simplices_);
  std::vector<BoundaryCount> counts_;
  std::vector<SurfacePieces> pieces_; ///< of all components; by set
};

} // namespace

Result<std::vector<BoundaryCount>>
count_boundaries(const ToleranceVolume& volume, const BoundaryCounting& counting, const RunControl& control) {
  Counter counter(volume, counting);
  if (Status status = counter.run(control); !status.ok()) return status.error();
  return counter.take(control);
}

Result<std::vector<BoundaryCount>> count_offsets(const ToleranceVolume& volume,
                                                 const OffsetCounting& counting, const RunControl& control) {
  Counter counter(volume, counting);
  if (Status status = counter.run(control); !status.ok()) return status.error();
  return counter.take(control);
}

} // namespace isoscope
