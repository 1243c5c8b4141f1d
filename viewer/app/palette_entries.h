// What the palette finds: commands, and by the words on screen settings, lessons, models, events and
// elements.
#pragma once

#include "app/app_model.h"

#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

struct PaletteEntry {
  std::string title, help, key;
  const char* icon = nullptr;
  bool enabled = true;
  CommandCall call;
  std::string complete{}; ///< typed instead of running: a value is still missing
};

/// The best first. What is typed after a command's name are its arguments.
std::vector<PaletteEntry> palette_entries(const AppModel& model, const std::string& typed);

} // namespace isoscope
