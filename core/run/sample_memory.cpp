// Says which density fits, and which tolerance where none does.
#include "run/sample_memory.h"

#include "tolerance/parameter_check.h"

#include <cmath>
#include <cstdio>

namespace isoscope {

Status check_memory(const SampleEstimate& estimate, double sigma, double delta, double most_bytes) {
  if (estimate.bytes(sigma) <= most_bytes) return {};
  constexpr double gigabyte = 1e9, sparsest = sparsest_sigma_ratio, margin = 1.01;
  char message[240], remedy[200];
  std::snprintf(
      message, sizeof message,
      "A density of %.3g δ takes about %.2g samples and %.2g GB of memory, more than the %.2g GB that may "
      "be used.",
      sigma / delta, estimate.samples(sigma), estimate.bytes(sigma) / gigabyte, most_bytes / gigabyte);
  const double least = margin * estimate.smallest_sigma(most_bytes) / delta;
  if (least <= sparsest) {
    const double step = std::pow(10.0, std::floor(std::log10(least)) - 1);
    std::snprintf(remedy, sizeof remedy, "Take --sigma %.3g or more, or give more with --memory-limit.",
                  step * std::ceil(least / step));
  } else {
    // Cells and samples go with 1/δ².
    std::snprintf(remedy, sizeof remedy,
                  "Choose a tolerance about %.2g times as large, or give more with --memory-limit.",
                  margin * std::sqrt(estimate.bytes(sparsest * delta) / most_bytes));
  }
  return Error{ErrorCode::unsupported, message, remedy};
}

} // namespace isoscope
