// Branch and bound over the pieces of a facet.
#include "tolerance/facet_certificate.h"

#include "tolerance/rounding.h"

#include <array>

namespace isoscope {
namespace {

/// A piece of the facet, with the site that gives φ at its parent's centroid as a guess.
struct Piece {
  Triangle3 corners;
  TriangleId guess;
  int depth;
};

/// Bisections beyond this cannot make a piece of doubles smaller.
constexpr int max_depth = 120;

/// Pieces that wait: depth first, so at most one for each level besides the two newest.
class PieceStack {
 public:
  bool empty() const { return size_ == 0; }
  void push(const Piece& piece) { pieces_[size_++] = piece; }
  Piece pop() { return pieces_[--size_]; }

 private:
  std::array<Piece, max_depth + 2> pieces_;
  std::size_t size_ = 0;
};

constexpr std::size_t pieces_between_questions = 256;

void push_halves(const Piece& piece, TriangleId guess, PieceStack& stack) {
  const Triangle3& t = piece.corners;
  std::size_t longest = 0;
  double l2 = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double e2 = squared_length(t[(i + 1) % 3] - t[i]);
    if (e2 > l2) l2 = e2, longest = i;
  }
  const std::size_t next = (longest + 1) % 3;
  const Vec3 middle = 0.5 * (t[longest] + t[next]);
  Piece first{t, guess, piece.depth + 1}, second = first;
  first.corners[longest] = middle;
  second.corners[next] = middle;
  stack.push(first);
  stack.push(second);
}

} // namespace

FacetVerdict certify_facet(const ToleranceField& field, const Triangle3& facet, double accept, double reject,
                           const FacetSearch& search) {
  using Kind = FacetVerdict::Kind;
  FacetVerdict verdict;
  if (field.empty()) {
    verdict.kind = Kind::outside;
    verdict.witness = facet[0];
    return verdict;
  }
  if (field.meets_boundary(facet) == std::optional(false)) {
    const ClosestPoint closest = field.closest_near(centroid(facet), search.guess);
    if (closest.distance() <= accept) {
      verdict.kind = Kind::inside;
      verdict.max_distance = accept;
      return verdict;
    }
  }
  Box3 box;
  for (const Vec3 p : facet) box.add(p);
  const double rounding = rounding_bound(field.bounds(), box, bound_roundings);
  // Whoever brings a guess asks for speed: then a bound from the guess is good enough, if looser.
  const bool trust_guess = search.guess.valid();
  PieceStack stack;
  stack.push({facet, search.guess, 0});
  while (!stack.empty()) {
    const Piece piece = stack.pop();
    ++verdict.pieces;
    const bool stopped =
        search.stop != nullptr && verdict.pieces % pieces_between_questions == 0 && (*search.stop)();
    if (stopped || verdict.pieces > search.budget || piece.depth > max_depth) {
      if (verdict.kind == Kind::outside) return verdict;
      verdict.kind = Kind::undecided;
      verdict.witness = centroid(piece.corners);
      return verdict;
    }
    if (trust_guess) {
      const double bound = field.convex_bound(piece.corners, piece.guess) + rounding;
      if (bound <= accept) {
        verdict.max_distance = std::max(verdict.max_distance, bound);
        continue;
      }
    }
    const Triangle3& t = piece.corners;
    const Vec3 center = centroid(t);
    const ClosestPoint closest = field.closest_near(center, piece.guess);
    const double d = closest.distance();
    double radius2 = 0;
    for (const Vec3 p : t) radius2 = std::max(radius2, squared_length(p - center));
    if (d - rounding > reject) {
      if (search.judge != nullptr) {
        const PieceVerdict judged = (*search.judge)(t, center, closest, std::sqrt(radius2));
        if (judged == PieceVerdict::passes) continue;
        if (judged == PieceVerdict::divide) {
          push_halves(piece, closest.triangle, stack);
          continue;
        }
      }
      if (verdict.kind != Kind::outside || closest.squared_distance > verdict.closest.squared_distance) {
        verdict.witness = center;
        verdict.closest = closest;
      }
      verdict.kind = Kind::outside;
      if (search.witnesses == nullptr) return verdict;
      search.witnesses->push_back(center);
      if (search.witnesses->size() >= search.most_witnesses) return verdict;
      continue;
    }
    double bound = d + std::sqrt(radius2) + rounding;
    // The convexity bound is the tighter one in flat places; it costs three distances to one triangle.
    bound = std::min(bound, field.convex_bound(t, closest.triangle) + rounding);
    if (bound <= accept) {
      verdict.max_distance = std::max(verdict.max_distance, bound);
      continue;
    }
    push_halves(piece, closest.triangle, stack);
  }
  if (verdict.kind != Kind::outside) verdict.kind = Kind::inside;
  return verdict;
}

} // namespace isoscope
