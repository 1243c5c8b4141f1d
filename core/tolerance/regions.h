// A lazily refined octree of the complement of Ω' = {φ <= δ'}: which points outside of Ω' are connected
// (core/README.md, N1).
#pragma once

#include "base/growing_array.h"
#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/cell_links.h"
#include "tolerance/field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace isoscope {

/// The octree with a union-find over its OUT cells. An OUT cell has φ > δ' everywhere, so face-adjacent OUT
/// cells are in one component of the complement: what the union-find joins is joined. Cells are refined where
/// someone asks.
class Regions {
 public:
  using CellIndex = std::uint32_t;
  static constexpr CellIndex none = 0xffffffffu;

  enum class Kind : std::int8_t { in = -1, ambiguous = 0, out = 1 };

  /// A cube: position (x, y, z) in units of its side, which is the domain's divided by 2^level.
  struct Cell {
    std::uint32_t x = 0, y = 0, z = 0;
    CellIndex child = none; ///< first of eight consecutive children
    TriangleId triangle;    ///< the site that gives φ at the centre
    float distance = 0;     ///< φ at the centre
    std::uint8_t level = 0;
    Kind kind = Kind::ambiguous; ///< out: φ > δ' in the whole cell; in: φ <= δ' in the whole cell
  };

  struct Options {
    double boundary = 0;  ///< δ'
    double main_side = 0; ///< ambiguous cells are split at once down to this side
    double min_side = 0;  ///< and on demand down to this one
    double margin = 0;    ///< between the field's box and the domain's
    double most_bytes = std::numeric_limits<double>::infinity(); ///< that the main cells may take
    /// How many main cells are expected, as far as is known: where coarse ones tell the same, and that does
    /// not fit, the fine ones are not made.
    double expected_cells = 0;
  };

  /// Builds the main cells. Fails with unsupported when the tolerance is so small that their number would
  /// exceed 2^31 or their memory the limit, with cancelled when told to.
  static Result<Regions> build(const ToleranceField& field, const Options& options,
                               const RunControl& control);

  Cell cell(CellIndex i) const;
  Kind kind(CellIndex i) const { return at(i).kind[place(i)]; }
  float distance(CellIndex i) const { return at(i).distance[place(i)]; }
  CellIndex child(CellIndex i) const { return kind(i) == Kind::ambiguous ? at(i).link[place(i)] : none; }
  std::size_t size() const { return 8 * siblings_.size() - 7; }
  /// Cells before this one came from build(); later ones from refinement.
  std::size_t main_size() const { return main_size_; }
  unsigned main_level() const { return main_level_; }
  double side(unsigned level) const { return domain_side_ / static_cast<double>(std::uint64_t{1} << level); }
  Vec3 center(const Cell& c) const;
  Box3 domain() const;
  Vec3 origin() const { return origin_; }

  /// The deepest existing cell that holds p; none outside of the domain.
  CellIndex locate(Vec3 p) const;
  /// The same, splitting ambiguous cells on the way.
  CellIndex locate_refining(Vec3 p);

  /// The same among the first `count` cells, which include the main ones.
  CellIndex locate_among(Vec3 p, std::size_t count) const;
  /// Of the existing cells that hold the cell at this place of a level the deepest, which may be that one.
  CellIndex cell_at(unsigned level, const std::array<std::uint32_t, 3>& place) const;
  /// The cell of the same or a coarser level across a face; none at the domain's border. Face 2a + s is the
  /// side s of axis a.
  CellIndex neighbor(const Cell& c, int face) const;
  /// Each two leaves with a common face. Fewer once the control is cancelled.
  std::vector<CellLink> leaf_links(const RunControl& control) const;

  /// Representative of the component that holds an OUT cell.
  CellIndex root(CellIndex i) const;
  /// Makes root() a single step for all cells there are.
  void flatten(const RunControl& control);
  /// Joins the components of two OUT cells that are known to be one.
  void join(CellIndex a, CellIndex b) { unite(a, b); }
  /// Marks the component of an OUT cell as known by a number; floods stop there.
  void set_number(CellIndex i, std::uint32_t number) { numbers_[root(i)] = number; }
  std::optional<std::uint32_t> number(CellIndex i) const;

  /// Explores from an OUT cell, farthest from the input first, splitting ambiguous cells on its way, until it
  /// meets another main or numbered component (true), nothing is left, `budget` cells were visited or the
  /// control was cancelled (false).
  bool flood(CellIndex start, std::size_t budget, const RunControl& control);
  /// The same through those cells only for which enters(cell) holds, which may also be parts of known ones.
  bool flood_through(CellIndex start, std::size_t budget, const std::function<bool(CellIndex)>& enters,
                     const RunControl& control);

  /// Two numbered components that turned out to be one, at a passage that the main cells did not show.
  struct Passage {
    CellIndex cell = none;
    std::array<std::uint32_t, 2> numbers{};
  };
  const std::vector<Passage>& passages() const { return passages_; }

  std::size_t memory_bytes() const;

 private:
  /// Eight cells of one parent. There are millions: what all of them have in common is told once, and no cell
  /// needs both children and a place in the union-find.
  struct Siblings {
    std::array<std::uint32_t, 3> first{}; ///< position of the first
    std::uint8_t level = 0;
    std::array<Kind, 8> kind{};
    /// Of an OUT cell its parent in the union-find (numbered, then main, then older cells are roots), of a
    /// split one the first of its children; else none.
    std::array<CellIndex, 8> link;
    std::array<TriangleId, 8> triangle;
    std::array<float, 8> distance{};
  };

  Regions(const ToleranceField& field, const Options& options);
  /// The root is the last of eight of which the others do not exist.
  static std::size_t group(CellIndex i) { return (std::size_t{i} + 7) >> 3; }
  static unsigned place(CellIndex i) { return (i + 7) & 7u; }
  const Siblings& at(CellIndex i) const { return siblings_[group(i)]; }
  CellIndex& link(CellIndex i) { return siblings_[group(i)].link[place(i)]; }
  /// Makes room for the children of a cell; the first of them.
  CellIndex add_children(CellIndex i);
  void classify(CellIndex i, TriangleId guess, const TriangleNeighborhood& near);
  void classify_children(CellIndex parent);
  void split(CellIndex i);
  void unite_main(const RunControl& control);
  void fill_entries();
  /// The cell that the way from the root to this place leads to in the entries' level, or where it ends
  /// above.
  CellIndex entry(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return entries_[(std::size_t{z} << entry_level_ | y) << entry_level_ | x];
  }
  template <class EndsAt> CellIndex descend(Vec3 p, const EndsAt& ends_at) const;
  bool touches(const Cell& a, const Cell& b, int face) const;
  CellIndex compress(CellIndex i);
  bool is_goal(CellIndex root) const { return root < main_size_ || numbers_.contains(root); }
  void unite(CellIndex a, CellIndex b);

  const ToleranceField* field_;
  double boundary_;
  Vec3 origin_;
  double domain_side_;
  unsigned main_level_ = 0, max_level_ = 0;
  std::size_t main_size_ = 0;
  GrowingArray<Siblings> siblings_;
  std::vector<CellIndex> entries_{0}; ///< of all places of a level: ways down begin there
  unsigned entry_level_ = 0;
  std::vector<Passage> passages_;
  std::unordered_map<CellIndex, std::uint32_t> numbers_; ///< by root; looked up only, never iterated

 public:
  /// What a cell takes.
  static constexpr double bytes_of_cell = sizeof(Siblings) / 8.0;
};

} // namespace isoscope
