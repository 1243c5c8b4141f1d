// Procedural models that ship with the program, each chosen for what it teaches.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"

#include <span>
#include <string>
#include <string_view>

namespace isoscope {

/// One bundled model.
struct GalleryEntry {
  std::string_view name;    ///< what one types: "torus"
  std::string_view title;   ///< what a card shows: "Torus"
  std::string_view lesson;  ///< one sentence on what it teaches
  double tolerance_percent; ///< the δ it is best opened with, in percent of the longest edge; 0: it gives Ω
  long euler_characteristic;      ///< of the surface, or of what lies in Ω (all components together)
  double low = 0, high = 0;       ///< the levels of a grid
  std::size_t boundary_loops = 0; ///< closed curves of the border of an open surface
  bool opened = false;            ///< its picture shows what is inside

  bool gives_volume() const { return tolerance_percent == 0; }
};

/// What stands before the name of a bundled model where an input is asked for.
constexpr std::string_view gallery_prefix = "gallery:";

/// All bundled models; the first is the one the program opens by default.
std::span<const GalleryEntry> gallery();
/// "gallery:torus".
std::string gallery_input(std::string_view name);
/// The model that such an input names; null for a file and for an unknown name.
const GalleryEntry* gallery_entry(std::string_view input);

/// Makes a bundled model; the same bits on every machine and call. Fails with bad_input on an unknown name
/// (and lists the names).
Result<TriangleSoup> make_gallery_model(std::string_view name);

} // namespace isoscope
