// Reading the command line.
#include "app/options.h"

#include "cli/options.h"
#include "run/report.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace isoscope {
namespace {

Error bad(const std::string& what) {
  return {ErrorCode::usage, what, "isoscope --help lists the options."};
}

Result<PixelSize> parse_size(const std::string& text) {
  PixelSize size;
  int used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &used) != 2 ||
      static_cast<std::size_t>(used) != text.size() || size.width < 640 || size.height < 400 ||
      size.width > 16384 || size.height > 16384)
    return bad("--size takes WIDTHxHEIGHT from 640x400 to 16384x16384, not \"" + text + "\".");
  return size;
}

} // namespace

Result<ParsedOptions> parse_options(int argc, char** argv) {
  ParsedOptions parsed;
  ProgramOptions& o = parsed.options;
  std::string size, theme;
  bool show_version = false;
  CLI::App app{"Isoscope: watch and debug isotopic approximation within a tolerance volume.", "isoscope"};
  const RunOptions run_options(app, false);
  app.add_flag("--paused", o.paused, "hold the run before its first operation");
  app.add_option("--script", o.script, "run the commands of a file, one a line, then quit");
  app.add_option("--screenshot", o.screenshot, "run to the end, write a picture, quit");
  app.add_option("--ui-scale", o.ui_scale, "size of text and controls, 0.5 to 4")
      ->check(CLI::Range(0.5, 4.0));
  app.add_option("--size", size, "of the window: WIDTHxHEIGHT");
  app.add_option("--theme", theme)->check(CLI::IsMember({"dark", "light", "paper"}));
  app.add_flag("--version", show_version, "say the version");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    parsed.print = app.help();
    return parsed;
  } catch (const CLI::ParseError& error) {
    return bad(std::string(error.what()) + (std::string(error.what()).ends_with('.') ? "" : "."));
  }
  if (show_version) {
    parsed.print = "isoscope " + std::string(version()) + "\n";
    return parsed;
  }
  const auto run = run_options.finish();
  if (!run) return run.error();
  o.run = *run;
  o.recording = run_options.recording();
  o.tolerance_given = app.get_option("--tolerance")->count() > 0;
  if (!size.empty()) {
    const auto s = parse_size(size);
    if (!s) return s.error();
    o.size = *s;
  }
  if (theme == "dark") o.theme = ThemeKind::dark;
  if (theme == "light") o.theme = ThemeKind::light;
  if (theme == "paper") o.theme = ThemeKind::paper;
  return parsed;
}

} // namespace isoscope
