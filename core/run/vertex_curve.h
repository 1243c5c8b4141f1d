// The vertices of Z over the seconds of a run.
#pragma once

#include "journal/journal.h"

#include <cstddef>
#include <vector>

namespace isoscope {

struct CurvePoint {
  double seconds = 0; ///< since the refinement began, pauses included, what is between stages not
  std::size_t vertices = 0;
  Stage stage = Stage::refinement;
  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// From the journal alone: the first count of each stage, each one that differs from the last point by more
/// than half a percent, and the last one.
std::vector<CurvePoint> vertex_curve(const Journal& journal);

} // namespace isoscope
