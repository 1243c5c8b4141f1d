// The sentences of certificates.
#include "run/certificate_verdicts.h"

#include "base/numbers.h"
#include "base/place.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace isoscope {
namespace {

/// "the input is farther than 3 δ from the mesh in 2 places, the farthest 33.2 δ at (0, 1, 2)"
std::string uncovered_words(const Certificate& c, double delta) {
  return "the input is farther than " + general(*c.cover_limit, 4) + " δ from the mesh in " +
         (c.uncovered_count == 1 ? "one place, "
                                 : std::to_string(c.uncovered_count) + " places, the farthest ") +
         general(c.uncovered.front().distance / delta, 4) + " δ at " +
         place(c.uncovered.front().point, proof_digits);
}

} // namespace

std::string_view name(Certificate::Topology topology) {
  constexpr std::array<std::string_view, 4> names{"as expected", "wrong", "missed", "not asked"};
  return names[static_cast<std::size_t>(topology)];
}

void add_verdict(const FacetVerdict& v, ContainmentFigures& figures) {
  switch (v.kind) {
  case FacetVerdict::Kind::inside:
    figures.max_distance = std::max(figures.max_distance, v.max_distance);
    return;
  case FacetVerdict::Kind::undecided:
    ++figures.undecided;
    return;
  case FacetVerdict::Kind::outside:
    ++figures.outside;
    if (v.closest.distance() <= figures.worst) return;
    figures.worst = v.closest.distance();
    figures.where = v.witness;
  }
}

void tell_containment(const ContainmentFigures& figures, bool complete, double delta, Certificate& c) {
  if (figures.outside + figures.undecided > 0) c.within_tolerance = false;
  c.max_distance = std::max({c.max_distance, figures.max_distance, figures.worst});
  if (figures.outside > 0) {
    c.failures.push_back(counted(figures.outside, "facet leaves", "facets leave") +
                         " the tolerance volume, the worst by d = " + general(figures.worst / delta, 4) +
                         " δ at " + place(figures.where, proof_digits) + ".");
  }
  if (!complete) {
    if (figures.outside == 0) c.max_distance = std::numeric_limits<double>::infinity();
    return;
  }
  if (figures.undecided > 0) {
    c.failures.push_back(counted(figures.undecided, "facet") +
                         " could be proven neither inside nor outside.");
  }
}

void tell_separation(std::span<const Witness> witnesses, std::span<const double> winding, Certificate& c) {
  std::size_t more = 0;
  c.separates = true;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    const Witness& w = witnesses[i];
    const double expected = w.label < 0 ? 1 : 0;
    if (w.cover) continue; // what comes of those is told by the distances
    if (std::abs(winding[i] - expected) < 0.01) continue;
    if (!c.separates) {
      ++more;
      continue;
    }
    c.separates = false;
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", winding[i]);
    c.failures.push_back("The mesh winds " + std::string(text) + " times around the region at " +
                         place(w.point, proof_digits) + " instead of " +
                         (w.label < 0 ? "once." : "not at all."));
  }
  if (more > 0) c.failures.push_back("So it does with " + std::to_string(more) + " other regions.");
}

void tell_coverage(const Coverage& coverage, const CoverTest& test, double delta, Certificate& c) {
  c.uncovered = coverage.places;
  c.uncovered_count = coverage.count;
  switch (coverage.verdict) {
  case Coverage::Verdict::covered:
    c.covers = true;
    return;
  case Coverage::Verdict::undecided:
    c.failures.emplace_back("Whether the mesh covers the input could not be decided.");
    return;
  case Coverage::Verdict::uncovered:
    break;
  }
  if (c.uncovered.empty()) return;
  std::string words = uncovered_words(c, delta);
  if (test.thin_may_go) {
    c.covers = true;
    c.cover_note = "Only the sides had to be separated: " + words +
                   ", where something thinner than 2 δ was closed over or cut.";
  } else {
    words.front() = 'T';
    c.failures.push_back(words + ".");
  }
}

void tell_fin(Vec3 p, Certificate& c) {
  c.failures.push_back("A sheet has one region on both sides at " + place(p, proof_digits) +
                       ": a mesh that parts regions has none there. Remove what stands out, or ask for no "
                       "cover (--cover off).");
}

void tell_topology(const ExpectedTopology& expected, Certificate& c) {
  using Topology = Certificate::Topology;
  const bool asked = expected.euler_characteristic || expected.components;
  const bool met = expected.euler_characteristic.value_or(c.euler_characteristic) == c.euler_characteristic &&
                   expected.components.value_or(c.components) == c.components &&
                   expected.boundary_loops.value_or(c.boundary_loops) == c.boundary_loops;
  c.topology = !asked              ? Topology::not_asked
               : met               ? Topology::as_expected
               : expected.required ? Topology::wrong
                                   : Topology::missed;
  switch (c.topology) {
  case Topology::as_expected:
    return;
  case Topology::not_asked:
    c.topology_note = !expected.nothing.empty()
                          ? "Nothing is expected of the topology: " + expected.nothing + "."
                          : "Asked for was the " + expected.source + ": any topology will do.";
    return;
  case Topology::missed:
    c.topology_note = "The topology is not guaranteed, as Ω is no thickening: the output has χ = " +
                      std::to_string(c.euler_characteristic) + " in " + std::to_string(c.components) +
                      (c.components == 1 ? " component" : " components") +
                      (expected.loops_untold.empty() ? "" : " with " + counted(c.boundary_loops, "loop")) +
                      ", ";
    if (expected.euler_characteristic)
      c.topology_note += "χ = " + std::to_string(*expected.euler_characteristic) + " in ";
    c.topology_note += std::to_string(expected.components.value_or(c.components)) +
                       (expected.boundary_loops ? " with " + counted(*expected.boundary_loops, "loop") +
                                                      " (" + std::to_string(c.boundary_loops) + " found)"
                                                : std::string()) +
                       " from " + expected.source + " was aimed at.";
    if (!expected.loops_untold.empty())
      c.topology_note += " No number of loops was: " + expected.loops_untold + ".";
    return;
  case Topology::wrong:
    break;
  }
  if (expected.euler_characteristic && *expected.euler_characteristic != c.euler_characteristic)
    c.failures.push_back("The Euler characteristic is " + std::to_string(c.euler_characteristic) +
                         " instead of " + std::to_string(*expected.euler_characteristic) + ", that of " +
                         expected.source + ".");
  if (expected.components && *expected.components != c.components)
    c.failures.push_back((c.components == 1 ? "There is " : "There are ") +
                         counted(c.components, "component") + " instead of " +
                         std::to_string(*expected.components) + ".");
  if (expected.boundary_loops && *expected.boundary_loops != c.boundary_loops)
    c.failures.push_back("Its border has " + counted(c.boundary_loops, "loop") + " instead of " +
                         std::to_string(*expected.boundary_loops) + ".");
}

void tell_intersections(std::size_t pairs, Vec3 p, Certificate& c) {
  c.intersection_free = pairs == 0;
  if (pairs > 0)
    c.failures.push_back(std::to_string(pairs) + " pairs of facets intersect, one at " +
                         place(p, proof_digits) + ".");
}

void tell_intersections_untested(Certificate& c) {
  c.failures.emplace_back(
      c.regions.empty() ? "Intersections were not tested because the mesh is no closed oriented 2-manifold."
                        : "Intersections were not tested because a region's boundary is no closed oriented "
                          "2-manifold.");
}

void tell_left_open(const std::string& list, Certificate& c) {
  if (!list.empty()) c.failures.push_back("The run was stopped before this was found out: " + list + ".");
}

} // namespace isoscope
