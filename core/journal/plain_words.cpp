// One short sentence an event, for captions that are read from the last row.
#include "journal/plain_words.h"

#include <cmath>
#include <cstdio>
#include <string_view>

namespace isoscope {
namespace {

std::string_view stage_words(Stage stage) {
  switch (stage) {
  case Stage::setup:
    return "set-up";
  case Stage::refinement:
    return "refinement";
  case Stage::gamma:
    return "simplifying ∂Γ";
  case Stage::tessellation:
    return "tessellation";
  case Stage::zero_set:
    return "simplifying Z";
  case Stage::all:
    return "simplifying around Z";
  case Stage::improve:
    return "improvement";
  }
  return "";
}

std::string number(double value) {
  if (std::isnan(value)) return "unknown";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", std::abs(value));
  return (value < 0 ? "−" : "") + std::string(text);
}

std::string lengths(double length, double delta) {
  return delta > 0 ? number(length / delta) + " δ" : number(length);
}

std::string whole(double value) {
  if (!std::isfinite(value)) return "unknown";
  const long rounded = std::lround(value);
  return (rounded < 0 ? "−" : "") + std::to_string(std::abs(rounded));
}

std::string counted(std::uint32_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

std::string insertion(const Event& e, double delta) {
  switch (e.condition) {
  case Condition::classification:
    return "the sample with the largest error, " + number(e.value) + ", goes in";
  case Condition::height:
    return "a tetrahedron is too flat, " + lengths(e.value, delta) + " high: a point splits it";
  case Condition::orientation:
    return "a tetrahedron faces the wrong way: a point splits it";
  case Condition::topology:
    return "Z has too many or too few handles: a point goes in to mend it";
  case Condition::containment:
    return "Z may leave the tolerance, d = " + lengths(e.value, delta) + ": a point pulls it back";
  case Condition::witness:
    return "a region lies on the wrong side of Z: its deepest point goes in";
  case Condition::none:
    break;
  }
  return "a point goes in";
}

std::string_view rejection(Reason reason) {
  switch (reason) {
  case Reason::link_condition:
    return "collapsing it would pinch the triangulation";
  case Reason::zero_link_condition:
    return "collapsing it would pinch Z";
  case Reason::kernel_empty:
    return "no place sees its whole surroundings";
  case Reason::no_candidate:
    return "no target was found that sees its surroundings";
  case Reason::misclassified:
    return "a sample would end up on the wrong side";
  case Reason::outside_tolerance:
    return "Z would leave the tolerance";
  case Reason::unproven:
    return "Z could not be proven to stay in the tolerance";
  case Reason::normals:
    return "a facet would turn too far from the surface";
  case Reason::witness_side:
    return "a region would change side";
  case Reason::intersection:
    return "Z would cut itself";
  case Reason::folded:
    return "a facet would fold over";
  case Reason::stays_above:
    return "the repair did not come back into the tolerance";
  default:
    return "the limit of work was reached";
  }
}

std::string exhausted(const Event& e) {
  switch (e.condition) {
  case Condition::classification:
    return "a sample stays on the wrong side: no point is left to try";
  case Condition::height:
    return "a tetrahedron stays too flat: no point is left to try";
  case Condition::orientation:
    return "a tetrahedron keeps facing the wrong way: no point is left to try";
  case Condition::containment:
    return "part of Z stays unproven: no point is left to try";
  default:
    return "no point is left to try here";
  }
}

std::string topology(const Event& e) {
  std::string text = "Z has " + counted(e.count, "component", "components") + " and χ = " + whole(e.value);
  if (!std::isfinite(e.limit)) return text;
  return text + (e.value == e.limit ? ", as it should" : ", but χ = " + whole(e.limit) + " is expected");
}

} // namespace

std::string plain_words(const Journal& journal, const Event& e) {
  const CriteriaParameters criteria = journal.parameters_at(e.step);
  const std::string stage(stage_words(e.stage));
  std::string text;
  switch (e.kind) {
  case EventKind::stage_begin:
    return stage + " begins";
  case EventKind::stage_end:
    return stage + " is done";
  case EventKind::insertion:
    text = insertion(e, criteria.delta);
    break;
  case EventKind::relabel:
    text = counted(e.count, "vertex changes", "vertices change") + " side";
    break;
  case EventKind::exhausted:
    text = exhausted(e);
    break;
  case EventKind::topology_check:
    text = topology(e);
    break;
  case EventKind::parameter_change:
    text = "the parameters change: α = " + number(criteria.alpha) +
           ", σ = " + lengths(criteria.sigma, criteria.delta);
    break;
  case EventKind::warning:
    return e.text != 0 && e.text < journal.texts().size() ? journal.texts()[e.text] : "a warning";
  case EventKind::stopped:
    return stage + " is stopped";
  case EventKind::collapse:
    text = "an edge collapses, one vertex less";
    break;
  case EventKind::rejection:
    text = "an edge stays: " + std::string(rejection(e.reason));
    break;
  case EventKind::tessellation:
    text = "Z becomes part of the triangulation, with " + counted(e.count, "vertex", "vertices");
    break;
  case EventKind::departure:
    text = "Z leaves the triangulation and moves freely inside the tolerance";
    break;
  case EventKind::relaxation:
    text = counted(e.count, "vertex moves", "vertices move") +
           " to better places, farthest d = " + lengths(e.value, criteria.delta);
    break;
  case EventKind::shake:
    text = "edges of Z are turned to make room for further collapses";
    break;
  case EventKind::repair:
    text = "an edge collapses and its neighbours are moved back into the tolerance";
    break;
  }
  return stage + (e.operation ? " " + std::to_string(e.step + 1) : "") + ": " + text;
}

} // namespace isoscope
