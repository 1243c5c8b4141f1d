// What every panel is given: what the window shows, colours, fonts, scale and where its commands go.
#pragma once

#include "command/commands.h"
#include "model/window_state.h"
#include "ui/theme.h"

#include <cmath>

namespace isoscope {

/// Lives for one frame. Panels post commands; plain settings of the window they change in place. What they
/// show of a feature they are given beside it.
struct Ui {
  WindowState& window;
  const CommandTable& table;
  CommandSink& commands;
  const Palette& colors;
  ThemeKind theme;
  const Fonts& fonts;
  float scale = 1;

  /// Units of the interface to pixels.
  float px(float units) const { return std::round(units * scale); }
};

} // namespace isoscope
