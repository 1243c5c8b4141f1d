// What every panel is given: colours, fonts, scale and where its commands go.
#pragma once

#include "command/commands.h"
#include "ui/theme.h"

#include <cmath>

namespace isoscope {

/// Lives for one frame. Panels read the model through it and post commands; plain view settings they change
/// in place.
struct Ui {
  AppModel& model;
  CommandSink& commands;
  const Palette& colors;
  ThemeKind theme;
  const Fonts& fonts;
  float scale = 1;

  /// Units of the interface to pixels.
  float px(float units) const { return std::round(units * scale); }
};

} // namespace isoscope
