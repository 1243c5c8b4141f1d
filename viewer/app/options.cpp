// Reading the command line.
#include "app/options.h"

#include "cli/options.h"
#include "export/exports.h"
#include "lesson/lesson.h"
#include "recording/recording_reader.h"
#include "run/report.h"

#include <cstdio>

namespace isoscope {
namespace {

Error bad(const std::string& what) {
  return {ErrorCode::usage, what, "isoscope --help lists the options."};
}

Result<PixelSize> parse_size(const std::string& text, bool plain) {
  const int least_width = plain ? picture_least : 640, least_height = plain ? picture_least : 400;
  PictureFormat size;
  if (!read_size(text, size) || size.width < least_width || size.height < least_height ||
      size.width > picture_most || size.height > picture_most)
    return bad("--size takes WIDTHxHEIGHT from " + std::to_string(least_width) + "x" +
               std::to_string(least_height) + " to 16384x16384, not \"" + text + "\".");
  return PixelSize{size.width, size.height};
}

} // namespace

std::vector<CommandCall> picture_calls(const ProgramOptions& o) {
  std::vector<CommandCall> calls;
  if (!o.view.empty()) calls.push_back({"open", {o.view}});
  if (!o.step.empty())
    calls.push_back(o.step == "end" ? CommandCall{"end", {}} : CommandCall{"seek", {o.step}});
  if (!o.plain) {
    calls.push_back({"screenshot", {o.screenshot}});
  } else {
    Arguments words{o.screenshot, std::to_string(o.size.width) + "x" + std::to_string(o.size.height)};
    if (o.alpha) words.push_back("alpha");
    calls.push_back({"picture", words});
    calls.push_back({"expect", {"export.error == none"}});
  }
  return calls;
}

Result<ParsedOptions> parse_options(int argc, char** argv) {
  ParsedOptions parsed;
  ProgramOptions& o = parsed.options;
  std::string size, theme;
  double ui_scale = 0;
  bool show_version = false, list_lessons = false;
  CommandLine app{"Isoscope: watch and debug isotopic approximation within a tolerance volume.", "isoscope"};
  const RunOptions run_options(app);
  app.flag("--paused", o.paused, "hold the run before its first operation");
  app.flag("--follow", o.follow,
           "INPUT is a copy of a recording that grows on another machine: show what there is of it, and more "
           "as it "
           "comes");
  app.option("--script", o.script, "run the commands of a file, one a line, then quit");
  app.option("--screenshot", o.screenshot, "run to the end, write a picture, quit");
  app.flag("--plain", o.plain, "the screenshot shows the view without panels, at any --size");
  app.flag("--transparent", o.alpha, "the same without ground");
  app.option("--step", o.step, "the screenshot shows this step: a number or end");
  app.option("--view", o.view, "the screenshot shows this view: a JSON file");
  app.option("--history-limit", o.history_limit, "of journal and keyframes together, MiB", 1, 1048576);
  app.option("--ui-scale", ui_scale, "size of text and controls", 0.5, 4);
  app.option("--size", size, "of the window, or of a plain screenshot: WIDTHxHEIGHT");
  app.choice("--theme", theme, {"dark", "light", "paper"}, "colours of the window");
  app.flag("--list-lessons", list_lessons, "list the lessons: isoscope lesson:NAME begins one");
  app.flag("--version", show_version, "say the version");
  app.exit_status("0 closed, or the script or the picture is done; 1 a command of the script failed, or the "
                  "picture cannot be written; 2 usage, or no display; 3 bad input; 4 ended by a signal.");
  app.see_also("isoscope-run");
  const auto asked = app.read(argc, argv);
  if (!asked) return bad(asked.error().message + (asked.error().message.ends_with('.') ? "" : "."));
  parsed.print = *asked;
  if (parsed.print) return parsed;
  if (show_version) {
    parsed.print = "isoscope " + std::string(version()) + "\n";
    return parsed;
  }
  if (list_lessons) {
    const auto& all = bundled_lessons();
    if (!all) return all.error();
    std::string list;
    for (const Lesson& l : *all)
      list += "lesson:" + l.name + std::string(l.name.size() < 20 ? 20 - l.name.size() : 1, ' ') + l.title +
              (l.figure.empty() ? "" : " (" + l.figure + ")") + "\n";
    parsed.print = std::move(list);
    return parsed;
  }
  const auto run = run_options.finish();
  if (!run) return run.error();
  o.run = *run;
  o.recording = run_options.recording();
  o.tolerance_given = app.given("--tolerance");
  if (o.follow && !is_recording_name(o.run.input))
    return bad("--follow is for a recording, RUN.isorun" +
               (o.run.input.empty() ? std::string(".") : ", not \"" + o.run.input + "\"."));
  o.ui_scale = static_cast<float>(ui_scale);
  o.plain = o.plain || o.alpha;
  if (o.screenshot.empty() && (o.plain || !o.step.empty() || !o.view.empty()))
    return bad("--plain, --transparent, --step and --view say how --screenshot looks, which is missing.");
  if (!o.step.empty() && o.step != "end" && o.step.find_first_not_of("0123456789") != std::string::npos)
    return bad("--step takes a number or end, not \"" + o.step + "\".");
  if (!size.empty()) {
    const auto s = parse_size(size, o.plain);
    if (!s) return s.error();
    o.size = *s;
  }
  if (theme == "dark") o.theme = ThemeKind::dark;
  if (theme == "light") o.theme = ThemeKind::light;
  if (theme == "paper") o.theme = ThemeKind::paper;
  return parsed;
}

} // namespace isoscope
