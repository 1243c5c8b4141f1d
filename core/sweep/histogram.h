// Histograms as SVG that stands in a page and takes its colours from it.
#pragma once

#include <string>
#include <vector>

namespace isoscope::sweep {

struct Histogram {
  std::string title; ///< "vertices"
  std::string unit;  ///< behind numbers: "s"
  /// Of each series, all above 0; stacked in this order, with the classes s0, s1, … of the page's style.
  std::vector<std::vector<double>> series;
  bool logarithmic = true; ///< bins grow by a factor
};

/// Empty where there are no values.
std::string svg(const Histogram& histogram);

} // namespace isoscope::sweep
