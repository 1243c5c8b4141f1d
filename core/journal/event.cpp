// Names of stages, kinds, conditions and reasons, as filters, reports and scripts spell them.
#include "journal/event.h"

#include <array>

namespace isoscope {

namespace {

template <std::size_t n, class Enum>
std::string_view name_of(const std::array<std::string_view, n>& names, Enum value) {
  const auto i = static_cast<std::size_t>(value);
  return i < n ? names[i] : "unknown";
}

} // namespace

std::string_view name(Stage stage) {
  static constexpr std::array<std::string_view, stage_count> names{
      "setup", "refinement", "gamma", "tessellation", "zero-set", "all", "improve"};
  return name_of(names, stage);
}

std::string_view name(EventKind kind) {
  static constexpr std::array<std::string_view, event_kind_count> names{
      "stage-begin",      "stage-end",  "insertion", "relabel",  "exhausted", "topology-check",
      "parameter-change", "warning",    "stopped",   "collapse", "rejection", "tessellation",
      "departure",        "relaxation", "repair",    "shake"};
  return name_of(names, kind);
}

std::string_view name(Condition condition) {
  static constexpr std::array<std::string_view, condition_count> names{
      "none", "classification", "height", "orientation", "topology", "containment", "witness"};
  return name_of(names, condition);
}

std::string_view name(Reason reason) {
  static constexpr std::array<std::string_view, reason_count> names{"none",
                                                                    "largest-error",
                                                                    "circumcenter-sample",
                                                                    "projected",
                                                                    "toward-circumcenter",
                                                                    "toward-opposite",
                                                                    "violating-point",
                                                                    "region-witness",
                                                                    "crossing-simplex",
                                                                    "no-sample-inside",
                                                                    "already-vertex",
                                                                    "too-close",
                                                                    "budget",
                                                                    "user",
                                                                    "halfedge",
                                                                    "sample-candidate",
                                                                    "quadric-optimum",
                                                                    "lazy-constraints",
                                                                    "kernel-sampling",
                                                                    "octree-search",
                                                                    "minimax-placement",
                                                                    "link-condition",
                                                                    "zero-link-condition",
                                                                    "kernel-empty",
                                                                    "no-candidate",
                                                                    "misclassified",
                                                                    "outside-tolerance",
                                                                    "unproven",
                                                                    "normals",
                                                                    "witness-side",
                                                                    "intersection",
                                                                    "folded",
                                                                    "stays-above"};
  return name_of(names, reason);
}

} // namespace isoscope
