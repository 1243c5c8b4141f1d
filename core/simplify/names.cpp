// Names of checks and choices, as filters, reports and scripts spell them.
#include "collapse/collapse_attempt.h"
#include "simplify/simplification.h"
#include "collapse/target_search.h"

#include <array>

namespace isoscope {

std::string_view name(TargetStrategy strategy) {
  static constexpr std::array<std::string_view, 4> names{"optimum", "constraints", "sampling", "octree"};
  const auto i = static_cast<std::size_t>(strategy);
  return i < names.size() ? names[i] : "unknown";
}

std::string_view name(ImproverPlace place) {
  return place == ImproverPlace::embedded ? "embedded" : "free";
}

} // namespace isoscope
