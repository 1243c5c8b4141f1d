// What the parameters of one input become for another one.
#include "model/chosen_input.h"

#include "input/gallery.h"
#include "input/point_files.h"

namespace isoscope {

RunParameters for_input(RunParameters p, const std::string& input) {
  p.input = input;
  p.inside.clear();
  p.label.reset();
  p.levels = {};
  if (p.tolerance.automatic) p.tolerance = {};
  if (const GalleryEntry* entry = gallery_entry(input)) {
    if (!entry->gives_volume()) p.tolerance = {entry->tolerance_percent, true};
    p.levels = {entry->low, entry->high};
  } else if (holds_points_alone(input)) {
    p.tolerance.automatic = true;
  }
  return p;
}

} // namespace isoscope
