// Proof that a triangle lies inside Ω, by branch and bound on the 1-Lipschitz distance (core/README.md, N4).
#pragma once

#include "tolerance/field.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace isoscope {

class FlatParts;

/// The outcome for one triangle and its witness.
struct FacetVerdict {
  enum class Kind { inside, outside, undecided };
  Kind kind = Kind::undecided;
  Vec3 witness; ///< outside: a point of the triangle with d > reject; undecided: the last one looked at
  ClosestPoint closest;    ///< of the witness
  double max_distance = 0; ///< inside: proven upper bound of φ over the triangle
  std::size_t pieces = 0;  ///< pieces looked at
};

/// What a piece of a facet with a point beyond the limit counts for, where not all do.
enum class PieceVerdict {
  violates, ///< the point shows that the facet is outside
  passes,   ///< the piece need not be inside
  divide    ///< its parts may differ
};
/// Judges a piece by its corners, its centre with the closest point there, and a radius around it.
using PieceJudge = std::function<PieceVerdict(const Triangle3& piece, Vec3 center,
                                              const ClosestPoint& closest, double radius)>;

/// How a certificate is made.
struct FacetSearch {
  std::size_t budget = 20000; ///< pieces
  TriangleId guess;           ///< a site close to the facet: makes it faster, max_distance looser
  /// Where given, the search goes on after the first violating point until this has `most_witnesses`; each
  /// comes from a piece of its own.
  std::vector<Vec3>* witnesses = nullptr;
  std::size_t most_witnesses = 6;
  /// Asked now and then; once true the facet stays undecided, unless it was found outside.
  const std::function<bool()>* stop = nullptr;
  const PieceJudge* judge = nullptr; ///< absent: every point beyond the limit violates
  const FlatParts* parts = nullptr;  ///< of the surface that the field is the distance to, where known
};

/// Accepts when d <= accept is proven everywhere (rounded outward), rejects at a point found with d > reject
/// (reject <= accept), undecided when the budget did not suffice. Outside where the field has no sites. Where
/// the field tells which facets meet φ = δ, that decides, `accept` being δ.
FacetVerdict certify_facet(const ToleranceField& field, const Triangle3& facet, double accept, double reject,
                           const FacetSearch& search);
inline FacetVerdict certify_facet(const ToleranceField& field, const Triangle3& facet, double accept,
                                  double reject, std::size_t budget = 20000) {
  return certify_facet(field, facet, accept, reject, FacetSearch{budget, {}, nullptr, 0, nullptr, nullptr});
}

} // namespace isoscope
