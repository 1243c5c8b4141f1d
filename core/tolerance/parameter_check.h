// Says before a run where σ, α and δ cannot satisfy condition 2 (§2.3, §3).
#pragma once

#include <string>
#include <vector>

namespace isoscope {

/// One thing the user should know before the run, with the value that would help.
struct ParameterWarning {
  std::string message;
  double largest_sigma =
      0; ///< the largest σ (absolute) for which the warned-of condition can hold; 0 when none applies
};

/// `sigma` and `delta` absolute, alpha in (0, 1). In flat places heterogeneous tetrahedra are about 2 δ'
/// high, so condition 2 (height >= 2σ/α) needs σ <= α δ'; σ >= δ voids §3 altogether.
std::vector<ParameterWarning> check_parameters(double sigma, double alpha, double delta,
                                               bool condition_2_used);

/// σ/δ that certified mode takes when none is given: 1/2, and where that would be more than about two million
/// samples so much more that it is not, up to 0.95. Containment is proven facet by facet there, so samples
/// need not be dense. `area` of the input and `delta` absolute.
double default_sigma_ratio(double area, double delta);
/// The largest of those.
constexpr double sparsest_sigma_ratio = 0.95;

} // namespace isoscope
