// One pass over the operations.
#include "run/vertex_curve.h"

#include <cmath>

namespace isoscope {
namespace {

constexpr double least_difference = 0.005;

} // namespace

std::vector<CurvePoint> vertex_curve(const Journal& journal) {
  std::vector<CurvePoint> curve;
  CurvePoint last;
  double before = 0; // the stages that are over
  for (std::size_t k = 0, n = journal.operations().size(); k < n; ++k) {
    const Operation& operation = journal.operations()[k];
    const Stage stage = journal.events()[operation.event].stage;
    const auto spent = static_cast<double>(operation.figures.seconds);
    // Seconds are those of a stage; where they begin anew another one has begun.
    if (k > 0 && (stage != last.stage || before + spent < last.seconds)) before = last.seconds;
    const bool begins = curve.empty() || stage != last.stage;
    last = {before + spent, operation.figures.zero_set_vertices, stage};
    if (last.vertices == 0) continue;
    const double kept = curve.empty() ? 0 : static_cast<double>(curve.back().vertices);
    if (begins || std::abs(static_cast<double>(last.vertices) - kept) > least_difference * kept)
      curve.push_back(last);
  }
  if (!curve.empty() && last.vertices > 0 && curve.back() != last) curve.push_back(last);
  return curve;
}

} // namespace isoscope
