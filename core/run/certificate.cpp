// Proves a finished mesh: connectivity, exact intersections, containment by branch and bound, sides by
// winding numbers.
#include "run/certificate.h"

#include "base/disjoint_sets.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/place.h"
#include "base/solid_angle.h"
#include "run/certificate_verdicts.h"
#include "run/exposed_input.h"
#include "run/mesh_connectivity.h"
#include "run/proof_budget.h"
#include "run/topology_places.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/self_intersections.h"
#include "tolerance/wall_neighbours.h"

#include <cmath>
#include <functional>
#include <utility>

namespace isoscope {

namespace {

/// Asked by what may take long; true once a stopped run has no time left to prove anything.
using Stop = std::function<bool()>;

constexpr double input_distance_precision = 0.01; ///< in units of δ
constexpr double finest_piece = 0.05;             ///< of the input along crossings, in units of δ
constexpr double fin_step = 0.1;                  ///< from a rim onto its sheet, in units of δ

Triangle3 corners(const TriangleMesh& mesh, std::size_t f) {
  const auto& t = mesh.triangles[f];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

/// False when it was stopped, as with those below.
bool check_intersections(const TriangleMesh& mesh, Certificate& c, const Stop& stop) {
  if (!c.manifold || !c.oriented) {
    tell_intersections_untested(c);
    return true;
  }
  const auto pairs = self_intersections(mesh.points, mesh.triangles, stop);
  if (!pairs) return false;
  tell_intersections(pairs->size(), pairs->empty() ? Vec3() : corners(mesh, pairs->front().first)[0], c);
  return true;
}

/// Facets that cross no wall keep a component of the mesh on one side of all: one vertex of each tells, where
/// the field can be asked exactly.
void check_sides_exactly(const TriangleMesh& mesh, const ToleranceField& field, Certificate& c) {
  DisjointSets pieces(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    pieces.unite(t[0], t[1]);
    pieces.unite(t[0], t[2]);
  }
  std::vector<char> asked(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles) {
    const std::uint32_t piece = pieces.find(t[0]);
    if (std::exchange(asked[piece], 1) != 0) continue;
    const Vec3 p = mesh.points[t[0]];
    if (field.holds_exactly(p).value_or(true)) continue;
    c.within_tolerance = false;
    c.failures.push_back("The component of the mesh at " + place(p, proof_digits) +
                         " lies outside of the tolerance volume.");
  }
}

bool check_containment(const TriangleMesh& mesh, const ToleranceVolume& volume, const FilledHoles& holes,
                       Certificate& c, const Stop& stop) {
  const double delta = volume.thresholds().delta;
  std::vector<FacetVerdict> verdicts(mesh.triangles.size());
  const FacetSearch search{proof_budget, {}, nullptr, 0, &stop};
  const bool complete =
      parallel_until(mesh.triangles.size(), 64, stop,
                     [&](std::size_t f) {
                       verdicts[f].kind = FacetVerdict::Kind::inside;
                       if (!holes.fills(f))
                         verdicts[f] = certify_facet(volume.field(), corners(mesh, f), delta, delta, search);
                     }) &&
      !stop();
  ContainmentFigures figures;
  for (const FacetVerdict& v : verdicts) add_verdict(v, figures);
  c.within_tolerance = complete && !mesh.triangles.empty();
  tell_containment(figures, complete, delta, c);
  if (!complete) return false;
  check_sides_exactly(mesh, volume.field(), c);
  return true;
}

/// The place that is left behind where a wall of the input has one region on both sides, though Z is closed.
std::optional<Vec3> uncovered_fin(const ToleranceVolume& volume, const std::vector<UncoveredPlace>& places) {
  if (volume.open_sides() != nullptr) return std::nullopt;
  const ClosestPointIndex& index = volume.index();
  for (const UncoveredPlace& p : places) {
    const TriangleId t = index.closest(p.point).triangle;
    // On the rim itself no segment would cross the wall.
    const Vec3 inwards = centroid(index.triangle(t)) - p.point;
    const double step = std::min(fin_step * volume.thresholds().delta, 0.5 * length(inwards));
    if (neighbours_of_wall(volume, {t, p.point + step * normalized(inwards)}).ends_in_the_open())
      return p.point;
  }
  return std::nullopt;
}

bool check_coverage(const TriangleMesh& mesh, const ToleranceVolume& volume, const CoverTest& test,
                    Certificate& c, const RunControl& control) {
  if (!volume.has_surface()) { // there are no walls to cover
    c.covers = true;
    return true;
  }
  c.cover_limit = test.limit;
  c.covers = !test.measure || !test.limit;
  if (!test.measure) return true;
  if (control.out_of_grace()) return !test.limit;
  const double delta = volume.thresholds().delta;
  const ClosestPointIndex index({mesh.points, mesh.triangles, {}});
  const ExposedInput input = exposed_input(volume, finest_piece * delta, control);
  if (input.closed_gap)
    c.gap_note = "Ω closes gaps between parts, as near " + place(*input.closed_gap, proof_digits) +
                 ": the walls there need not be near to the mesh.";
  c.input_distance = bound_distance(*input.walls, index, input_distance_precision * delta, control);
  if (!test.limit) return true;
  if (control.out_of_grace()) return false;
  const Coverage coverage =
      judge_coverage(*input.walls, index, c.input_distance, *test.limit * delta, delta, control);
  if (coverage.verdict == Coverage::Verdict::undecided && control.out_of_grace()) return false;
  tell_coverage(coverage, test, delta, c);
  if (!c.covers)
    if (const auto fin = uncovered_fin(volume, c.uncovered)) tell_fin(*fin, c);
  return true;
}

/// Winding number of the mesh around p.
double winding_number(const TriangleMesh& mesh, Vec3 p) {
  SolidAngleSum sum;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) sum.add(p, corners(mesh, f));
  return sum.winding();
}

bool check_separation(const TriangleMesh& mesh, const ToleranceVolume& volume, Certificate& c,
                      const Stop& stop) {
  const auto witnesses = volume.witnesses();
  std::vector<double> winding(witnesses.size(), 0);
  // A witness is a sum over the whole mesh: each is worth the question.
  const bool complete =
      parallel_until(witnesses.size(), 1, stop,
                     [&](std::size_t i) { winding[i] = winding_number(mesh, witnesses[i].point); }) &&
      !stop();
  if (!complete) return false;
  tell_separation(witnesses, winding, c);
  return true;
}

/// Every witness lies inside the boundary of its own room and outside of all others.
bool check_room_separation(const TriangleMesh& mesh, const ToleranceVolume& volume, Certificate& c,
                           const Stop& stop) {
  const auto witnesses = volume.witnesses();
  std::vector<std::vector<double>> winding(witnesses.size());
  const bool complete = parallel_until(witnesses.size(), 1, stop,
                                       [&](std::size_t i) {
                                         winding[i] = winding_numbers(mesh, c.regions, witnesses[i].point);
                                       }) &&
                        !stop();
  if (!complete) return false;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    bool found = witnesses[i].label > 0;
    const RegionCertificate* odd = nullptr;
    double times = 0;
    for (std::size_t r = 0; r < c.regions.size(); ++r) {
      if (c.regions[r].label > 0) continue; // around the outside nothing winds
      const bool own = c.regions[r].label == witnesses[i].label;
      found = found || own;
      if (std::abs(winding[i][r] - (own ? 1 : 0)) < 0.01) continue;
      odd = &c.regions[r];
      times = winding[i][r];
    }
    if ((found && odd == nullptr) || wrong++ > 0) continue;
    const std::string there =
        "the point " + place(witnesses[i].point, proof_digits) + " of " + name_of_region(witnesses[i].label);
    c.failures.push_back(odd == nullptr ? "The mesh has no boundary around " + there + '.'
                                        : "The boundary of " + name_of_region(odd->label) + " winds " +
                                              general(times, 3) + " times around " + there + '.');
  }
  if (wrong > 1) c.failures.push_back("So it is with " + std::to_string(wrong - 1) + " other points.");
  c.separates = wrong == 0;
  return true;
}

/// Winding numbers tell closed parts, segments open ones.
bool check_all_sides(const TriangleMesh& mesh, const ToleranceVolume& volume, const FilledHoles& holes,
                     Certificate& c, const Stop& stop) {
  if (volume.open_sides() == nullptr) return check_separation(mesh, volume, c, stop);
  if (!check_separation(closed_parts(mesh, holes), volume, c, stop)) return false;
  const auto failure = unseparated_sheet(mesh, volume, stop);
  if (!failure) return c.separates = false;
  if (!failure->empty()) {
    c.separates = false;
    c.failures.push_back(*failure);
  }
  return true;
}

bool check_border(const TriangleMesh& mesh, const ToleranceVolume& volume, const FilledHoles& holes,
                  Certificate& c, const Stop& stop) {
  if (volume.open_sides() == nullptr) return true;
  c.border = prove_border(mesh, volume, holes, stop);
  if (!c.border) {
    c.border.emplace().failures.emplace_back("The distance of the border to the rim was not found out.");
    return false;
  }
  c.failures.insert(c.failures.end(), c.border->failures.begin(), c.border->failures.end());
  return true;
}

void check_expectation(const TriangleMesh& mesh, const ExpectedTopology& expected, Certificate& c,
                       const RunControl& control) {
  tell_topology(expected, c);
  if (c.topology != Certificate::Topology::wrong) return;
  if (!c.closed_manifold || !c.oriented) return;
  const std::string places =
      c.regions.empty() ? topology_places(mesh, control) : topology_places(mesh, c.regions, control);
  if (!places.empty()) c.failures.back() += " " + places;
}

} // namespace

Certificate certify(const TriangleMesh& given, const ToleranceVolume& volume,
                    const ExpectedTopology& expected, const RunControl& control, const CoverTest& cover,
                    const FilledHoles& holes) {
  // Of rooms a mesh between two sides may be left where all others were lost.
  const bool rooms = volume.has_rooms() || !given.labels.empty();
  TriangleMesh labelled;
  if (rooms && given.labels.empty()) {
    labelled = given;
    labelled.labels.assign(given.triangles.size(), {+1, -1});
  }
  const TriangleMesh& mesh = labelled.labels.empty() ? given : labelled;
  const Stop stop = [&control] { return control.out_of_grace(); };
  Certificate c;
  control.report("certificate", 0);
  if (rooms && !mesh.triangles.empty())
    check_regions(mesh, c);
  else
    check_connectivity(mesh, volume.open_sides() != nullptr, c);
  if (mesh.triangles.empty()) {
    if (volume.open_sides() != nullptr && !control.cancelled())
      c.failures.back() +=
          " All of the open surface is nearer to its border, or to another part of itself, than Ω "
          "is thick: choose a smaller tolerance.";
    return c;
  }
  std::string open;
  const auto note = [&](bool found_out, const char* what) {
    if (!found_out) open += (open.empty() ? "" : ", ") + std::string(what);
  };
  note(check_intersections(mesh, c, stop), "freedom from intersections");
  note(rooms ? check_room_separation(mesh, volume, c, stop) : check_all_sides(mesh, volume, holes, c, stop),
       "separation of the sides");
  control.report("certificate", 0.3);
  note(check_containment(mesh, volume, holes, c, stop), "containment");
  note(check_border(mesh, volume, holes, c, stop), "distance of the border");
  control.report("certificate", 0.7);
  note(check_coverage(mesh, volume, cover, c, control), "coverage of the input");
  check_expectation(mesh, expected, c, control);
  tell_left_open(open, c);
  control.report("certificate", 1);
  return c;
}

} // namespace isoscope
