// What the figures of a proof come to, in the certificate's words, whoever has found them: of a mesh as a
// whole or summed over its parts.
#pragma once

#include "run/certificate.h"
#include "tolerance/facet_certificate.h"

#include <span>

namespace isoscope {

/// Facets by what was proven of them.
struct ContainmentFigures {
  double max_distance = 0; ///< proven upper bound over those that are inside
  std::size_t outside = 0, undecided = 0;
  double worst = 0; ///< the largest d that was found outside
  Vec3 where;       ///< and its place
};
void add_verdict(const FacetVerdict& verdict, ContainmentFigures& figures);
/// `complete`: all of them; false: it was stopped.
void tell_containment(const ContainmentFigures& figures, bool complete, double delta, Certificate& c);

/// What separates: how often the mesh winds around each witness.
void tell_separation(std::span<const Witness> witnesses, std::span<const double> winding, Certificate& c);

/// Of what was judged by `test`, which has a limit.
void tell_coverage(const Coverage& coverage, const CoverTest& test, double delta, Certificate& c);
/// Why p is left behind: a sheet parts no regions there, and a closed mesh has none.
void tell_fin(Vec3 p, Certificate& c);

/// Components, χ and loops of the certificate against what is expected.
void tell_topology(const ExpectedTopology& expected, Certificate& c);

/// That `pairs` of facets meet, one of them at p; or that none do.
void tell_intersections(std::size_t pairs, Vec3 p, Certificate& c);
/// That nobody looked.
void tell_intersections_untested(Certificate& c);

/// What was not found out as the run was stopped; nothing where the list is empty.
void tell_left_open(const std::string& list, Certificate& c);

} // namespace isoscope
