// Commands on files, recordings and the run.
#include "steering/steering.h"

#include "command/commands.h"
#include "input/mesh_io.h"
#include "mesh/zero_set.h"
#include "model/words.h"
#include "recording/recording_reader.h"
#include "ui/icons.h"
#include "view/view.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace isoscope {
namespace {

namespace fs = std::filesystem;

std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local);
  return text.data();
}

bool has_extension(const std::string& name, std::string_view extension) {
  std::string end = std::filesystem::path(name).extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == extension;
}

Status open_view_file(WindowState& m, const std::string& file) {
  std::ifstream in(file);
  if (!in) return Error{ErrorCode::io, "The view " + file + " cannot be read.", ""};
  return show_view(m, std::string{std::istreambuf_iterator<char>(in), {}});
}

Status open_model(Steering& m, const Arguments& a) {
  if (a.empty()) {
    m.window.files_for = FilesFor::open;
    m.window.toggle(Overlay::files);
    return {};
  }
  if (has_extension(a[0], ".json")) return open_view_file(m.window, a[0]);
  bool paused = false;
  std::string inside, second;
  for (std::size_t i = 1; i < a.size(); ++i) {
    if (a[i] == "paused")
      paused = true;
    else if (a[i] == "inside" && i + 1 < a.size() && inside.empty())
      inside = a[++i];
    else if (second.empty())
      second = a[i];
    else
      return wrong_arguments("\"" + a[i] + "\" is one file too many.");
  }
  if (second.empty()) return m.open(a[0], paused, inside);
  if (inside.empty())
    m.open_between(a[0], second, paused);
  else
    return wrong_arguments("Two files, or one inside the other, not both.");
  return {};
}

/// Views, recordings and folders of tiles are no surfaces.
bool opens_by_itself(const std::string& file) {
  return has_extension(file, ".json") || is_recording_name(file) || TileFolder::exists(file);
}

Status drop(Steering& m, const Arguments& files) {
  // Two at once are the walls of a volume; of more the last one stays, as each of them is opened.
  if (files.size() == 2 && std::none_of(files.begin(), files.end(), opens_by_itself))
    return open_model(m, files);
  for (const std::string& file : files)
    if (Status opened = open_model(m, {file}); !opened) return opened;
  return {};
}

Status open_walls(Steering& m, const Arguments& a) {
  if (a.size() == 1 || a.size() > 2) return wrong_arguments("Two surfaces are needed.");
  if (a.size() == 2) {
    m.open_between(a[0], a[1]);
    return {};
  }
  m.window.files_for = FilesFor::between;
  m.window.first_wall.clear();
  m.window.toggle(Overlay::files);
  return {};
}

Status export_mesh(WindowState& m, const Arguments& a) {
  const auto state = m.state();
  if (!state) return wrong_arguments("There is no zero set yet.");
  std::string file = a.empty() ? "" : a[0];
  if (file.empty()) {
    const std::string name = m.run.scene && m.run.scene->input ? m.run.scene->input->name : "model";
    file = name + "-step-" + std::to_string(state->step) + ".off";
  }
  const TriangleMesh mesh = triangulate(state->zero_set);
  if (Status s = write_mesh(file, mesh); !s) return s;
  m.tell("Z of step " + grouped(state->step) + " is written to " + std::filesystem::absolute(file).string() +
         ".");
  return {};
}

Status screenshot(WindowState& m, const Arguments& a) {
  ScreenshotRequest request;
  for (const std::string& word : a) {
    if (word == "view")
      request.view_only = true;
    else
      request.file = word;
  }
  if (request.file.empty()) request.file = "isoscope-" + time_stamp() + ".png";
  m.requests.screenshots.push_back(request);
  return {};
}

/// The model's name in the present folder, numbered where that is taken.
fs::path free_name(const WindowState& m) {
  const std::string name =
      m.run.scene && !m.run.scene->input->name.empty() ? m.run.scene->input->name : "run";
  fs::path file = name + ".isorun";
  for (int i = 2; fs::exists(file); ++i) file = name + "-" + std::to_string(i) + ".isorun";
  return file;
}

Status record(WindowState& m, const Arguments& a) {
  if (a.size() > 1) return Error{ErrorCode::usage, "record takes one file.", "Usage: record [FILE]"};
  const fs::path file = a.empty() ? free_name(m) : fs::path(a[0]);
  if (Status s = m.session.record(file); !s) return s;
  m.tell("The run is recorded to " + fs::absolute(file).string() + ".");
  return {};
}

Status follow_copy(Steering& m, const Arguments& a) {
  if (a.size() > 1) return wrong_arguments("One copy is followed at a time.");
  const auto& shown = m.window.run.recording;
  const std::string file = !a.empty() ? a[0] : m.window.shows_recording() ? shown->file.string() : "";
  if (!is_recording_name(file))
    return Error{ErrorCode::usage, "What is followed is a recording, RUN.isorun.",
                 "Give its name; without one the recording that is shown is followed."};
  m.follow(file);
  return {};
}

Status go_on_improving(WindowState& m, const Arguments&) {
  if (Status s = m.session.go_on_improving(); !s) return s;
  m.transport.follow();
  return {};
}

} // namespace

void Steering::add_file_commands(CommandTable& table) {
  add_group(
      table, {.menu = "File"},
      {{.name = "open",
        .title = "Open…",
        .usage = "[FILE [FILE] | gallery:NAME | FOLDER] [paused] [inside FILE]",
        .help = "Opens a model and starts refining it; with two closed surfaces, in any order, what lies "
                "between them; with a surface inside, what lies between both, as said; a folder of "
                "tiles is shown; without a name it shows the files.",
        .icon = icon::folder_open,
        .keys = {{'O', true}},
        .run = on(*this, open_model)},
       {.name = "open-between",
        .title = "Ω between two surfaces…",
        .usage = "[FILE FILE]",
        .help = "Opens two closed surfaces, one inside the other, in any order: Ω is what lies between them.",
        .icon = icon::layers,
        .run = on(*this, open_walls)},
       {.name = "gallery",
        .title = "Gallery",
        .help = "Shows the bundled models and what each teaches.",
        .icon = icon::gallery,
        .keys = {{'G', true}},
        .run = does([this] { window.toggle(Overlay::gallery); })},
       {.name = "export",
        .title = "Export Z…",
        .usage = "[FILE]",
        .help = "Writes the zero set shown as OFF, OBJ, PLY or STL.",
        .icon = icon::disk,
        .keys = {{'E', true}},
        .run = on(window, export_mesh),
        .enabled = [this] { return window.has_state(); }},
       {.name = "screenshot",
        .title = "Screenshot",
        .usage = "[FILE] [view]",
        .help = "Writes a picture of the window, or of the view alone, as PNG.",
        .icon = icon::camera,
        .keys = {{GLFW_KEY_F12}},
        .run = on(window, screenshot)},
       {.name = "quit",
        .title = "Quit",
        .help = "Ends the program.",
        .keys = {{'Q', true}},
        .run = does([this] { window.requests.close = true; })}});
  table.add({{.name = "drop",
              .title = "Drop…",
              .usage = "FILE…",
              .help = "Does what dropping files on the window does: opens each, or what lies between two "
                      "surfaces.",
              .run = on(*this, drop),
              .for_scripts = true}});
}

void Steering::add_recording_commands(CommandTable& table) {
  table.add(
      {{.name = "record",
        .title = "Record the run…",
        .usage = "[FILE]",
        .help = "Keeps the run from its first event on in a file that opens anywhere, also while it grows.",
        .menu = "File",
        .icon = icon::record,
        .keys = {{'R', true, true}},
        .run = on(window, record),
        .enabled = [this] { return window.has_run() && !window.shows_recording(); },
        .checked = [this] { return window.run.recording && !window.run.recording->opened; }},
       {.name = "follow-copy",
        .title = "Follow as a copy",
        .usage = "[FILE]",
        .help =
            "Shows a copy of a recording that grows on another machine, by rsync or on its file system, and "
            "goes on as more of it comes; without a name the recording that is shown.",
        .menu = "File",
        .run = on(*this, follow_copy)}});
}

void Steering::add_run_commands(CommandTable& table) {
  const auto has_run = [this] { return window.has_run(); };
  add_group(
      table, {.menu = "Run"},
      {{.name = "apply",
        .title = "Apply parameters",
        .help = "Goes on with the parameters of the panel from the step that is shown: the run itself at "
                "its live end, else a branch, and the run that it left is one key away.",
        .icon = icon::check,
        .keys = {{GLFW_KEY_ENTER, true}},
        .run = [this](const Arguments&) { return apply(); },
        .enabled = has_run},
       {.name = "apply-earlier",
        .title = "Branch where it matters",
        .help = "Branches with the parameters of the panel at the last step at which those that were "
                "changed matter: at the end of the refinement for α, σ and most conditions.",
        .run = [this](const Arguments&) { return apply_earlier(); },
        .enabled = has_run},
       {.name = "restart",
        .title = "Restart",
        .help = "Runs again from the beginning with the parameters of the panel.",
        .icon = icon::restart,
        .keys = {{'R', true}},
        .run = [this](const Arguments&) { return restart(); },
        .enabled = [this] { return !window.draft.input.empty(); }},
       {.name = "go-on-improving",
        .title = "Go on improving",
        .help = "Once the run has ended: tries for ever fewer vertices, as further steps of the same run, "
                "until it is stopped; the mesh is valid all the time.",
        .icon = icon::forward,
        .run = on(window, go_on_improving),
        .enabled = [this] { return window.can_go_on_improving(); }},
       {.name = "stop",
        .title = "Stop",
        .help = "Ends the run; what is there is kept and certified.",
        .icon = icon::stop,
        .run = does([this] { window.session.stop(); }),
        .enabled = [this] { return window.running() || window.run.phase == SessionPhase::paused; }}});
}

} // namespace isoscope
