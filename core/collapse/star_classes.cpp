// A descent through the boxes in the order of ids, with the tetrahedra that can still put a sample wrong.
#include "collapse/star_classes.h"

#include "collapse/star_location.h"
#include "mesh/predicates.h"
#include "mesh/sample_sets.h"
#include "mesh/tet_planes.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace isoscope {

namespace {

/// Samples in a leaf, and boxes in the next larger one.
constexpr std::size_t fan = 8;
/// Of the sizes of the terms of f: what rounding may change.
constexpr double relative_rounding = 1e-14;

double sum_of_products(Vec3 gradient, Vec3 half) {
  return std::abs(gradient.x) * half.x + std::abs(gradient.y) * half.y + std::abs(gradient.z) * half.z;
}

} // namespace

/// A tetrahedron after the collapse that may hold samples of one label on the wrong side.
struct StarClasses::Piece {
  const EdgeStar::StarTet* tet;
  std::array<Vec3, 4> corners;
  TetPlanes planes;
  AffineFunction f; ///< as the label sees it

  Piece(const EdgeStar& star, const EdgeStar::StarTet& t, Vec3 target, Vec3 origin, int label)
      : tet(&t), corners(star.positions_after(t, target)), planes(corners, origin),
        f(interpolate(corners, seen_from(label, values_after(star, t), labels_after(star, t)))) {}

  /// Whether f is at least `least` in a box, whatever is rounded; false where f is no number.
  bool above(double least, Vec3 center, Vec3 half) const {
    const Vec3 away = center - f.origin;
    const double change = sum_of_products(f.gradient, half);
    const double terms = std::abs(f.value0) + 1 + change +
                         sum_of_products(f.gradient, {std::abs(away.x), std::abs(away.y), std::abs(away.z)});
    return f(center) - change - relative_rounding * terms >= least;
  }
};

StarClasses::StarClasses(const EdgeStar& star) : star_(star) {
  for (const auto& v : star.vertices) box_.add(v.position);
  for (std::uint32_t i = 0; i < star.samples.size(); ++i) {
    const std::int8_t label = star.samples[i].label;
    auto side = std::find_if(sides_.begin(), sides_.end(), [&](const Side& s) { return s.label >= label; });
    if (side == sides_.end() || side->label != label) {
      side = sides_.insert(side, Side{});
      side->label = label;
    }
    side->samples.push_back(i);
  }
  for (Side& side : sides_) {
    std::vector<Box3> boxes((side.samples.size() + fan - 1) / fan);
    for (std::size_t i = 0; i < side.samples.size(); ++i)
      boxes[i / fan].add(star.samples[side.samples[i]].position);
    for (;;) {
      std::vector<Node>& level = side.levels.emplace_back();
      level.reserve(boxes.size());
      for (const Box3& b : boxes) {
        // As wide as rounding of the centre asks for.
        const Vec3 c = b.center();
        level.push_back({c,
                         {std::max(b.hi.x - c.x, c.x - b.lo.x), std::max(b.hi.y - c.y, c.y - b.lo.y),
                          std::max(b.hi.z - c.z, c.z - b.lo.z)}});
      }
      if (boxes.size() == 1) break;
      std::vector<Box3> larger((boxes.size() + fan - 1) / fan);
      for (std::size_t i = 0; i < boxes.size(); ++i) larger[i / fan].add(boxes[i]);
      boxes = std::move(larger);
    }
  }
}

/// The search for one target and label.
class StarClasses::Search {
 public:
  Search(const StarClasses& classes, const Side& side, Vec3 target, const CriteriaParameters& criteria)
      : star_(classes.star_), side_(side), origin_(classes.box_.center()), limit_(criteria.error_limit()),
        alpha_(criteria.alpha), embedded_(star_.form == ZeroForm::embedded) {
    Box3 box = classes.box_;
    box.add(target);
    margin_ = plane_margin(box);
    pieces_.reserve(star_.tets.size());
    for (const EdgeStar::StarTet& t : star_.tets) {
      if (t.ring() || (embedded_ && t.side == side.label)) continue;
      pieces_.emplace_back(star_, t, target, origin_, side.label);
    }
    order_.resize(pieces_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  }

  /// The place of the first sample before `end` that goes wrong; `end` where none does.
  std::uint32_t run(std::uint32_t end, TargetVerdict& verdict) {
    descend(side_.levels.size() - 1, 0, 0, order_.size(), end, verdict);
    return end;
  }

 private:
  /// Pieces are those at [first, last) of the list; what is left of them for the box is appended to it.
  bool descend(std::size_t level, std::size_t box, std::size_t first, std::size_t last, std::uint32_t& end,
               TargetVerdict& verdict) {
    const Node& node = side_.levels[level][box];
    const Vec3 local = node.center - origin_;
    const std::size_t begin = order_.size();
    for (std::size_t i = first; i < last; ++i) {
      const Piece& piece = pieces_[order_[i]];
      if (!embedded_ && piece.above(1 - limit_ + 1e-15, node.center, node.half)) continue;
      if (piece.planes.miss(local, node.half, margin_)) continue;
      order_.push_back(order_[i]);
    }
    const std::size_t left = order_.size();
    bool found = false;
    if (left > begin) {
      const std::size_t children = level == 0 ? side_.samples.size() : side_.levels[level - 1].size();
      for (std::size_t i = fan * box; i < std::min(fan * (box + 1), children) && !found; ++i)
        found = level == 0 ? judge(side_.samples[i], begin, left, end, verdict)
                           : descend(level - 1, i, begin, left, end, verdict);
    }
    order_.resize(begin);
    return found;
  }

  bool holds(const Piece& piece, Vec3 x) const {
    const double low = piece.planes.lowest(x - origin_).first;
    if (std::abs(low) > margin_) return low > 0;
    return holds_perturbed(piece.corners, x);
  }

  /// True where the search ends: the sample goes wrong, or others before it did.
  bool judge(std::uint32_t place, std::size_t first, std::size_t last, std::uint32_t& end,
             TargetVerdict& verdict) const {
    if (place >= end) return true;
    const EdgeStar::StarSample& s = star_.samples[place];
    for (std::size_t i = first; i < last; ++i) {
      const Piece& piece = pieces_[order_[i]];
      if (!holds(piece, s.position)) continue;
      if (!goes_wrong(piece, s, verdict)) return false;
      end = place;
      return true;
    }
    return false; // in another tetrahedron, or on the star's boundary: there nothing changes
  }

  bool goes_wrong(const Piece& piece, const EdgeStar::StarSample& s, TargetVerdict& verdict) const {
    double error = sample_error(piece.f(s.position), 1);
    if (embedded_) error = embedded_sample_error(error, false);
    if (embedded_ ? !is_bad(error) : error <= limit_) return false;
    const StarLocation before = locate_before(star_, s.position);
    // What was violated before, as refinement may leave it, must not get worse.
    double margin = alpha_;
    if (before.tet != nullptr) {
      const double error_before = sample_error_at(star_, before, s.position, s.label);
      if (error <= error_before) return false;
      margin = std::min(margin, 1 - error_before);
    }
    verdict = Refusal{Reason::misclassified, error, embedded_ ? 1.0 : limit_, s.position};
    verdict.invalid = invalid_region(star_, *piece.tet, s, star_.vertices[0].value, margin);
    return true;
  }

  const EdgeStar& star_;
  const Side& side_;
  Vec3 origin_;
  double limit_, alpha_, margin_ = 0;
  bool embedded_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> order_; ///< a stack of lists of pieces
};

TargetVerdict StarClasses::check(Vec3 target, const CriteriaParameters& criteria) const {
  TargetVerdict verdict;
  auto end = static_cast<std::uint32_t>(star_.samples.size());
  for (const Side& side : sides_) end = Search(*this, side, target, criteria).run(end, verdict);
  return verdict;
}

} // namespace isoscope
