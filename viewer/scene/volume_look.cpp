// Ways to look at Ω.
#include "scene/volume_look.h"

namespace isoscope {

void apply(const VolumeLook& look, ViewSettings& view) {
  view.outer = look.outer;
  view.inner = look.inner;
  view.haze_outer = look.haze[0];
  view.haze_middle = look.haze[1];
  view.haze_inner = look.haze[2];
}

const VolumeLook* look_of(const ViewSettings& view) {
  for (const VolumeLook& look : volume_looks) {
    ViewSettings with = view;
    apply(look, with);
    if (with == view) return &look;
  }
  return nullptr;
}

} // namespace isoscope
