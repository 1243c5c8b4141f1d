// The command line of the window program.
#pragma once

#include "base/status.h"
#include "command/commands.h"
#include "platform/window.h"
#include "run/parameters.h"
#include "scene/view_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace isoscope {

struct ProgramOptions {
  RunParameters run;
  bool tolerance_given = false;
  bool paused = false;                       ///< hold the run before its first operation
  bool follow = false;                       ///< the input is a copy of a recording that grows elsewhere
  std::string script, screenshot, recording; ///< empty: none
  float ui_scale = 0;                        ///< 0: as remembered
  PixelSize size{1280, 800};
  bool plain = false, alpha = false; ///< the screenshot shows the view alone, without ground
  std::string step, view;            ///< shown before the screenshot: a number or "end"; a view file
  double history_limit = 0;          ///< MiB; 0: as remembered
  std::optional<ThemeKind> theme;
  /// A picture of the view alone has a size of its own.
  PixelSize window_size() const { return plain ? PixelSize{1280, 800} : size; }
};

/// What the program does for --screenshot once the run has settled.
std::vector<CommandCall> picture_calls(const ProgramOptions& options);

/// What the command line asks for: options, a text to print (help, version) or a usage error.
struct ParsedOptions {
  ProgramOptions options;
  std::optional<std::string> print;
};
Result<ParsedOptions> parse_options(int argc, char** argv);

} // namespace isoscope
