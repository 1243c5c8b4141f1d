// The command line of the window program.
#pragma once

#include "base/status.h"
#include "platform/window.h"
#include "run/parameters.h"
#include "scene/view_settings.h"

#include <optional>
#include <string>

namespace isoscope {

struct ProgramOptions {
  RunParameters run;
  bool tolerance_given = false;
  bool paused = false;                       ///< hold the run before its first operation
  std::string script, screenshot, recording; ///< empty: none
  float ui_scale = 0;                        ///< 0: as remembered
  PixelSize size{1280, 800};
  std::optional<ThemeKind> theme;
};

/// What the command line asks for: options, a text to print (help, version) or a usage error.
struct ParsedOptions {
  ProgramOptions options;
  std::optional<std::string> print;
};
Result<ParsedOptions> parse_options(int argc, char** argv);

} // namespace isoscope
