// Branch and bound over the pieces of a facet.
#include "tolerance/facet_certificate.h"

#include "tolerance/rounding.h"
#include "tolerance/surface_certificate.h"

#include <array>
#include <vector>

namespace isoscope {
namespace {

/// What one site gives at the corners of a piece, squared; corners are asked when they are needed.
struct CornerDistances {
  static constexpr double unknown = -1;
  TriangleId site;
  std::array<double, 3> squared{unknown, unknown, unknown};

  double at(const ToleranceField& field, const Triangle3& corners, std::size_t k) {
    if (squared[k] == unknown) squared[k] = field.at_site(corners[k], site).squared_distance;
    return squared[k];
  }
};

/// A piece of the facet, with the site that gives φ at its parent's centroid as a guess.
struct Piece {
  Triangle3 corners;
  CornerDistances guess;
  int depth;
};

/// Bisections beyond this cannot make a piece of doubles smaller.
constexpr int max_depth = 120;

/// Pieces that wait: depth first, so at most one for each level besides the two newest. Most facets are
/// decided by few levels.
class PieceStack {
 public:
  PieceStack() { pieces_.reserve(usual_levels); }
  bool empty() const { return pieces_.empty(); }
  void push(const Piece& piece) { pieces_.push_back(piece); }
  Piece pop() {
    const Piece last = pieces_.back();
    pieces_.pop_back();
    return last;
  }

 private:
  static constexpr std::size_t usual_levels = 16;
  std::vector<Piece> pieces_;
};

constexpr std::size_t pieces_between_questions = 256;

/// Both halves get the same guess, and what that gives at their corners as far as it is known.
void push_halves(const Piece& piece, const CornerDistances& guess, PieceStack& stack) {
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
  first.guess.squared[longest] = CornerDistances::unknown;
  second.corners[next] = middle;
  second.guess.squared[next] = CornerDistances::unknown;
  stack.push(first);
  stack.push(second);
}

/// Whether what sites of a field give is convex, so that a triangle's corners tell of all of it.
bool has_convex_sites(const ToleranceField& field) {
  return field.kind() == FieldKind::triangles || field.kind() == FieldKind::points;
}

/// The largest of what a site gives at the corners and so anywhere on the piece, where that is at most
/// `limit`; else more than that.
double convex_bound(const ToleranceField& field, const Triangle3& corners, CornerDistances& distances,
                    double limit) {
  double largest = 0;
  // Known ones first: they cost nothing.
  for (const bool known : {true, false})
    for (std::size_t k = 0; k < 3; ++k) {
      if ((distances.squared[k] != CornerDistances::unknown) != known) continue;
      largest = std::max(largest, std::sqrt(distances.at(field, corners, k)));
      if (largest > limit) return largest;
    }
  return largest;
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
  // Who learns from one witness needs it inside of a piece, as the middle of what is wrong there; who gathers
  // them takes those at corners, which cost less.
  if (const ClosestPointIndex* surface = field.surface();
      surface != nullptr && search.witnesses != nullptr && search.judge == nullptr)
    return certify_on_surface(field, *surface, facet, accept, reject, search);
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
  const bool trust_guess = search.guess.valid() && has_convex_sites(field);
  const double limit = accept - rounding;
  PieceStack stack;
  stack.push({facet, {search.guess}, 0});
  while (!stack.empty()) {
    Piece piece = stack.pop();
    ++verdict.pieces;
    const bool stopped =
        search.stop != nullptr && verdict.pieces % pieces_between_questions == 0 && (*search.stop)();
    if (stopped || verdict.pieces > search.budget || piece.depth > max_depth) {
      if (verdict.kind == Kind::outside) return verdict;
      verdict.kind = Kind::undecided;
      verdict.witness = centroid(piece.corners);
      return verdict;
    }
    const Triangle3& t = piece.corners;
    if (trust_guess) {
      const double bound = convex_bound(field, t, piece.guess, limit);
      if (bound <= limit) {
        verdict.max_distance = std::max(verdict.max_distance, bound + rounding);
        continue;
      }
    }
    const Vec3 center = centroid(t);
    const ClosestPoint closest = field.closest_near(center, piece.guess.site);
    CornerDistances nearest{closest.triangle};
    if (closest.triangle == piece.guess.site) nearest = piece.guess;
    const double d = closest.distance();
    double radius2 = 0;
    for (const Vec3 p : t) radius2 = std::max(radius2, squared_length(p - center));
    if (d - rounding > reject) {
      if (search.judge != nullptr) {
        const PieceVerdict judged = (*search.judge)(t, center, closest, std::sqrt(radius2));
        if (judged == PieceVerdict::passes) continue;
        if (judged == PieceVerdict::divide) {
          push_halves(piece, nearest, stack);
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
    if (has_convex_sites(field))
      bound = std::min(bound, convex_bound(field, t, nearest, std::min(limit, bound)) + rounding);
    if (bound <= accept) {
      verdict.max_distance = std::max(verdict.max_distance, bound);
      continue;
    }
    push_halves(piece, nearest, stack);
  }
  if (verdict.kind != Kind::outside) verdict.kind = Kind::inside;
  return verdict;
}

} // namespace isoscope
