// One plain sentence an event, written once for captions, lists and logs.
#include "journal/describe.h"

#include <cmath>
#include <cstdio>
#include <string_view>

namespace isoscope {

namespace {

std::string number(double value, int digits = 3) {
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (std::isnan(value)) return "unknown";
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string whole(double value) {
  const auto rounded = static_cast<long>(std::llround(value));
  return rounded < 0 ? "−" + std::to_string(-rounded) : std::to_string(rounded);
}

std::string id(const char* what, std::uint32_t value) {
  return std::string(what) + " " + (value == 0xffffffffu ? std::string("unknown") : std::to_string(value));
}

std::string in_delta(double length, double delta) {
  return delta > 0 ? number(length / delta) + " δ" : number(length, 6);
}

/// How the place of a new vertex was found.
std::string_view placed(Reason reason) {
  switch (reason) {
  case Reason::projected:
    return "the violating point, projected to d = δ′, goes in";
  case Reason::toward_circumcenter:
    return "the first point with d = δ′ towards the circumcentre goes in";
  case Reason::toward_opposite:
    return "a point traced from a vertex of the other side goes in";
  case Reason::violating_point:
    return "the violating point itself goes in, as every place at d = δ′ is taken";
  case Reason::crossing_simplex:
    return "a point where an element of one side crosses the input goes in";
  case Reason::region_witness:
    return "the region's deepest point goes in";
  case Reason::circumcenter_sample:
    return "the sample nearest to the circumcentre goes in";
  default:
    return "a point goes in";
  }
}

std::string_view why_exhausted(Reason reason) {
  switch (reason) {
  case Reason::no_sample_inside:
    return "no sample lies strictly inside its circumscribed ball";
  case Reason::already_vertex:
    return "the candidate is a vertex already";
  case Reason::too_close:
    return "the candidate is too close to a vertex";
  case Reason::budget:
    return "a limit of work was reached";
  default:
    return "no candidate is left";
  }
}

std::string describe_insertion(const Event& e, double delta) {
  switch (e.condition) {
  case Condition::classification:
    return "condition 1: " + id("sample", e.sample.value) + " with ε = " + number(e.value, 2) + " (limit " +
           number(e.limit, 2) + ") goes in";
  case Condition::height:
    return "condition 2: " + id("tetrahedron", e.tet.value) + " is " + in_delta(e.value, delta) +
           " high (at least " + in_delta(e.limit, delta) + "); " + std::string(placed(e.reason));
  case Condition::orientation:
    return "condition 3: " + id("tetrahedron", e.tet.value) + " is misoriented (f·F = " + number(e.value, 2) +
           " at a nearest sample, must be above 0); " + std::string(placed(e.reason));
  case Condition::topology:
    return "condition 4: Z has not the expected topology; " + std::string(placed(e.reason));
  case Condition::containment:
    return "containment: Z reaches d = " + in_delta(e.value, delta) + " (limit " + in_delta(e.limit, delta) +
           ") in " + id("tetrahedron", e.tet.value) + "; " + std::string(placed(e.reason));
  case Condition::witness:
    return "witness: a region's deepest point lies on the wrong side of Z; it goes in";
  case Condition::none:
    break;
  }
  return "a point goes in";
}

std::string describe_exhausted(const Event& e, double delta) {
  std::string what;
  switch (e.condition) {
  case Condition::height:
    what = "condition 2 stays violated: height " + in_delta(e.value, delta) + " (at least " +
           in_delta(e.limit, delta) + ")";
    break;
  case Condition::orientation:
    what = "condition 3 stays violated: misoriented";
    break;
  case Condition::containment:
    what = "containment stays unproven: d = " + in_delta(e.value, delta) + " (limit " +
           in_delta(e.limit, delta) + ")";
    break;
  case Condition::classification:
    what = "condition 1 stays violated: ε = " + number(e.value, 2) + " (limit " + number(e.limit, 2) + ")";
    break;
  default:
    what = "condition 4: nothing left to try here";
  }
  if (e.tet.valid()) what += " in " + id("tetrahedron", e.tet.value);
  return what + "; " + std::string(why_exhausted(e.reason));
}

/// "facet 5–17–40", or "a facet" where none is named.
std::string facet_words(const Event& e) {
  if (!e.facet[0].valid()) return "a facet";
  return "facet " + std::to_string(e.facet[0].value) + "–" + std::to_string(e.facet[1].value) + "–" +
         std::to_string(e.facet[2].value);
}

/// Why an edge was not collapsed, with the number that decided.
std::string describe_rejection(const Event& e, double delta) {
  const std::string reached = "d = " + in_delta(e.value, delta) + " (limit " + in_delta(e.limit, delta) + ")";
  switch (e.reason) {
  case Reason::link_condition:
    return "the link condition fails in T";
  case Reason::zero_link_condition:
    return "the link condition fails in Z";
  case Reason::kernel_empty:
    return "its kernel is empty: no point sees the whole one-ring";
  case Reason::no_candidate:
    return "no candidate point lies in its kernel";
  case Reason::misclassified:
    return "a sample would change class, ε = " + number(e.value, 2) + " (limit " + number(e.limit, 2) + ")";
  case Reason::outside_tolerance:
    return "Z would leave Ω" + (e.facet[0].valid() ? " at " + facet_words(e) : std::string()) + ", " +
           reached;
  case Reason::unproven:
    return "a facet could be proven neither inside nor outside of Ω";
  case Reason::normals:
    return "a normal would turn from the samples around it (condition 3)";
  case Reason::witness_side:
    return "the deepest point of a region would change side";
  case Reason::intersection:
    return "Z would intersect itself";
  case Reason::folded:
    return facet_words(e) + " would turn over";
  case Reason::stays_above:
    return "the repair was rolled back, " + facet_words(e) + " stays at " + reached + ", " +
           in_delta(e.value - e.limit, delta) + " too far";
  default:
    return "a limit of work was reached";
  }
}

/// How the target of a collapse was found.
std::string_view target_found(Reason reason) {
  switch (reason) {
  case Reason::halfedge:
    return "one of its ends";
  case Reason::sample_candidate:
    return "a sample of S in its kernel";
  case Reason::quadric_optimum:
    return "the least error in its kernel";
  case Reason::lazy_constraints:
    return "the least error under learnt half-spaces";
  case Reason::kernel_sampling:
    return "a point drawn in its kernel";
  case Reason::octree_search:
    return "a point of the octree over its kernel";
  case Reason::minimax_placement:
    return "the least largest distance";
  default:
    return "a point";
  }
}

std::string edge_words(const Event& e) {
  return "edge " + std::to_string(e.vertex.value) + "–" + std::to_string(e.other.value);
}

} // namespace

std::string describe_event(const Journal& journal, const Event& e) {
  const CriteriaParameters criteria = journal.parameters_at(e.step);
  const std::string note = e.text < journal.texts().size() ? journal.texts()[e.text] : std::string();
  std::string sentence;
  switch (e.kind) {
  case EventKind::stage_begin:
    sentence = std::string(name(e.stage)) + " begins";
    break;
  case EventKind::stage_end:
    sentence = std::string(name(e.stage)) + " ends";
    break;
  case EventKind::insertion:
    sentence = describe_insertion(e, criteria.delta);
    break;
  case EventKind::relabel:
    sentence = "labels of " + std::to_string(e.count) + " vertices change side";
    break;
  case EventKind::exhausted:
    sentence = describe_exhausted(e, criteria.delta);
    break;
  case EventKind::topology_check:
    sentence = "topology: Z has χ = " + whole(e.value) + " in " + std::to_string(e.count) +
               (e.count == 1 ? " component" : " components") +
               (std::isfinite(e.limit) ? ", expected χ = " + whole(e.limit) : std::string());
    break;
  case EventKind::parameter_change:
    sentence = "parameters: α = " + number(criteria.alpha, 2) +
               ", σ = " + in_delta(criteria.sigma, criteria.delta) + ", shrink " + number(criteria.shrink, 2);
    break;
  case EventKind::warning:
    return note.empty() ? "warning" : note;
  case EventKind::stopped:
    sentence = "stopped";
    break;
  case EventKind::collapse:
    sentence = edge_words(e) + " collapses to " + std::string(target_found(e.reason));
    break;
  case EventKind::rejection:
    sentence = edge_words(e) + " stays: " + describe_rejection(e, criteria.delta);
    break;
  case EventKind::tessellation:
    sentence = "mutual tessellation: " + std::to_string(e.count) + " vertices of Z go into T";
    break;
  case EventKind::departure:
    sentence = "Z leaves T: from here on its own facets are kept inside Ω";
    break;
  case EventKind::relaxation:
    sentence = std::to_string(e.count) +
               " vertices relocated in a sweep over Z, largest d = " + in_delta(e.value, criteria.delta);
    break;
  case EventKind::shake:
    sentence = "Z shaken: edges flipped against the energy and " + std::to_string(e.count) +
               " vertices relocated around them, largest d = " + in_delta(e.value, criteria.delta);
    break;
  case EventKind::repair:
    sentence = edge_words(e) + " collapses, repaired in " +
               std::to_string(e.detail < journal.repairs().size() ? journal.repairs()[e.detail].size() : 0) +
               " sweeps, largest d = " + in_delta(e.value, criteria.delta);
    break;
  }
  if (!note.empty()) sentence += ": " + note;
  return sentence;
}

std::string describe(const Journal& journal, const Event& e) {
  return (e.operation ? std::to_string(e.step + 1) + " · " : std::string()) + describe_event(journal, e);
}

} // namespace isoscope
