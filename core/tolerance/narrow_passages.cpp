// Basins of OUT cells, then a look at each face between two of them.
#include "tolerance/narrow_passages.h"

#include "base/disjoint_sets.h"
#include "tolerance/cell_links.h"
#include "tolerance/rounding.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_set>

namespace isoscope {
namespace {

/// A face is looked at down to squares of this half side, in units of δ'.
constexpr double smallest_square = 0.018;
/// Cells that one flood may visit, and how many all of them may create.
constexpr std::size_t passage_budget = 5000, most_passage_cells = 2'000'000;
constexpr std::uint32_t links_between_questions = 256;

/// A square across an axis.
struct Square {
  Vec3 center;
  int axis;
  double half;
};

/// The face that two leaves have in common, which is that of the smaller one.
Square common_face(const Regions& octree, CellLink link) {
  Regions::Cell small = octree.cell(link.a), large = octree.cell(link.b);
  if (small.level < large.level) std::swap(small, large);
  const Vec3 at = octree.center(small), other = octree.center(large);
  const double half = 0.5 * octree.side(small.level), apart = half + 0.5 * octree.side(large.level);
  Square face{at, 0, half};
  for (int a = 1; a < 3; ++a)
    if (std::abs(std::abs(other[a] - at[a]) - apart) <
        std::abs(std::abs(other[face.axis] - at[face.axis]) - apart))
      face.axis = a;
  face.center[face.axis] += other[face.axis] > at[face.axis] ? half : -half;
  return face;
}

class PassageSearch {
 public:
  PassageSearch(Regions& octree, const ToleranceField& field, double boundary, double reject,
                const RunControl& control)
      : octree_(octree), field_(field), boundary_(boundary), reject_(reject), control_(control),
        built_(octree.size()), basins_(octree.size()), owners_(octree.size(), Regions::none) {}

  void run() {
    SparsePoll poll(control_, links_between_questions);
    std::vector<CellLink> links = octree_.leaf_links(control_);
    // On both sides of a face that a passage goes through φ is at most half a diagonal less.
    const double floor = reject_ - half_diagonal * octree_.side(octree_.main_level());
    std::erase_if(links, [&](const CellLink& link) { return level(link) < floor; });
    sort_by_level(links, [&](const CellLink& link) { return level(link); });
    const auto is_out = [&](Regions::CellIndex i) { return octree_.kind(i) == Regions::Kind::out; };
    for (Regions::CellIndex i = 0; i < built_; ++i)
      if (is_out(i)) basins_.unite(i, octree_.root(i));
    for (Regions::CellIndex i = 0; i < built_; ++i)
      if (is_out(i)) owners_[basins_.find(i)] = i;
    for (std::size_t i = links.size(); i-- > 0 && !poll.cancelled();) look_at(links[i]);
  }

 private:
  double level(const CellLink& link) const {
    return static_cast<double>(std::min(octree_.distance(link.a), octree_.distance(link.b)));
  }

  /// Joins basins as {φ > r} does as r shrinks, but those of components that are apart.
  void look_at(const CellLink& link) {
    const std::uint32_t a = basins_.find(link.a), b = basins_.find(link.b);
    if (a == b) return;
    const bool apart = owners_[a] != Regions::none && owners_[b] != Regions::none;
    if (apart && !are_one(a, b) && octree_.size() < built_ + most_passage_cells)
      search(common_face(octree_, link), a, b);
    if (apart && !are_one(a, b)) return;
    const Regions::CellIndex owner = owners_[a] != Regions::none ? owners_[a] : owners_[b];
    basins_.unite(a, b);
    owners_[basins_.find(a)] = owner;
  }

  bool are_one(std::uint32_t a, std::uint32_t b) const {
    return octree_.root(owners_[a]) == octree_.root(owners_[b]);
  }

  /// From a point of the face outside of Ω' a way up in each of the two basins.
  void search(const Square& face, std::uint32_t a, std::uint32_t b) {
    const std::optional<Vec3> p = outside_on(face);
    if (!p) return;
    const Regions::CellIndex start = octree_.locate_refining(*p);
    if (start == Regions::none || octree_.kind(start) != Regions::Kind::out) return;
    if (!seen_.insert(start).second) return;
    for (const std::uint32_t basin : {a, b}) {
      if (octree_.root(start) == octree_.root(owners_[basin])) continue;
      const auto enters = [&](Regions::CellIndex i) { return basin_of(i) == basin; };
      octree_.flood_through(start, passage_budget, enters, control_);
    }
  }

  std::uint32_t basin_of(Regions::CellIndex i) {
    return basins_.find(i < built_ ? i : octree_.locate_among(octree_.center(octree_.cell(i)), built_));
  }

  /// A point of a square with φ > δ_r, where there is one.
  std::optional<Vec3> outside_on(const Square& square) const {
    const double d = field_.distance(square.center);
    if (d > reject_) return square.center;
    if (d + std::numbers::sqrt2 * square.half <= reject_ || square.half < smallest_square * boundary_)
      return std::nullopt;
    for (unsigned k = 0; k < 4; ++k) {
      Square part{square.center, square.axis, 0.5 * square.half};
      part.center[(square.axis + 1) % 3] += k & 1u ? part.half : -part.half;
      part.center[(square.axis + 2) % 3] += k & 2u ? part.half : -part.half;
      if (auto found = outside_on(part)) return found;
    }
    return std::nullopt;
  }

  Regions& octree_;
  const ToleranceField& field_;
  double boundary_, reject_;
  const RunControl& control_;
  std::size_t built_;
  DisjointSets basins_;                         ///< of leaves
  std::vector<Regions::CellIndex> owners_;      ///< by basin: one of its OUT cells
  std::unordered_set<Regions::CellIndex> seen_; ///< asked for membership only
};

} // namespace

void join_narrow_passages(Regions& octree, const ToleranceField& field, double boundary, double reject,
                          const RunControl& control) {
  PassageSearch(octree, field, boundary, reject, control).run();
}

} // namespace isoscope
