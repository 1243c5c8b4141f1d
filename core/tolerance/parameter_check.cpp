// Compares σ with what the heights of tetrahedra in Ω allow.
#include "tolerance/parameter_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isoscope {
namespace {

std::string format(const char* pattern, double a, double b) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

} // namespace

double default_sigma_ratio(double area, double delta) {
  constexpr double densest = 0.5, affordable_samples = 2e6;
  // Measured: 1.3 to 1.5 samples for each σ² of the input's area and side.
  constexpr double samples_by_area = 3;
  const double ratio = std::sqrt(samples_by_area * area / affordable_samples) / delta;
  return std::clamp(ratio, densest, sparsest_sigma_ratio);
}

std::vector<ParameterWarning> check_parameters(double sigma, double alpha, double delta,
                                               bool condition_2_used) {
  std::vector<ParameterWarning> warnings;
  if (sigma >= delta)
    warnings.push_back(
        {format("The sampling density is %.3g times the tolerance: the guarantees of the method (§3) need a "
                "density below the tolerance. Choose a smaller one than %.3g.",
                sigma / delta, delta),
         delta});
  const double largest = alpha * delta;
  if (condition_2_used && sigma > largest * (1 + 1e-12))
    warnings.push_back(
        {format("Where the input is flat, condition 2 (§2.3) cannot hold: tetrahedra across the tolerance "
                "volume are about twice the tolerance high, so the density may be at most the tolerance "
                "divided by %.3g, which is %.3g. Refinement will leave some tetrahedra as they are.",
                1 / alpha, largest),
         largest});
  return warnings;
}

} // namespace isoscope
