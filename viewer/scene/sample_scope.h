// Which good samples the 3D view shows: those around the current operation, or all.
#pragma once

#include "questions/snapshot.h"
#include "scene/view_settings.h"

namespace isoscope {

/// Drawing and picking agree through this. All are shown before the first operation, as then there is nothing
/// but S to be seen; none where an operation is all over Z.
class SampleScope {
 public:
  SampleScope(const StateSnapshot& state, const ViewSettings& view);
  bool shows_good(Vec3 p) const { return all_ || squared_length(p - center_) <= squared_radius_; }

 private:
  bool all_ = true;
  Vec3 center_;
  double squared_radius_ = -1;
};

} // namespace isoscope
