// The commands' actions on run, selection, view and window.
#include "app/command_actions.h"

#include "command/named_values.h"
#include "command/usage.h"
#include "model/view_state.h"
#include "model/words.h"
#include "input/mesh_io.h"
#include "mesh/zero_set.h"
#include "scene/pick_geometry.h"
#include "scene/picking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace isoscope::actions {
namespace {

/// The first argument as a count >= 1, or 1.
Result<long> count_of(const std::string& name, const Arguments& a) {
  if (a.empty()) return 1L;
  const auto n = parse_number(a[0]);
  if (!n || *n < 1 || *n > 1e9 || *n != std::floor(*n))
    return usage(name, "\"" + a[0] + "\" is not a count of operations.");
  return static_cast<long>(*n);
}

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

Status open_view_file(AppModel& model, const std::string& file) {
  std::ifstream in(file);
  if (!in) return Error{ErrorCode::io, "The view " + file + " cannot be read.", ""};
  return set_view(model, {std::string{std::istreambuf_iterator<char>(in), {}}});
}

/// A breakpoint that speaks when another condition or stage than at the beginning asks for an operation.
Breakpoint at_change() {
  struct Seen {
    bool any = false;
    Condition condition = Condition::none;
    Stage stage = Stage::refinement;
  };
  auto seen = std::make_shared<Seen>();
  return [seen](const Journal&, const Event& event) -> std::string {
    if (!event.operation) return {};
    const bool change = seen->any && (event.condition != seen->condition || event.stage != seen->stage);
    *seen = {true, event.condition, event.stage};
    return change ? "another condition or stage" : "";
  };
}

} // namespace

Status toggle_overlay(AppModel& model, Overlay overlay) {
  model.overlay = model.overlay == overlay ? Overlay::none : overlay;
  return {};
}

Status open_model(AppModel& model, const Arguments& a) {
  if (a.empty()) {
    model.files_beside = false;
    return toggle_overlay(model, Overlay::files);
  }
  if (has_extension(a[0], ".json")) return open_view_file(model, a[0]);
  if (a.size() > 1 && a[1] != "paused") return usage("open", "\"" + a[1] + "\" is not understood.");
  model.open(a[0], a.size() > 1);
  return {};
}

Status export_mesh(AppModel& model, const Arguments& a) {
  const auto state = model.state();
  if (!state) return usage("export", "There is no zero set yet.");
  std::string file = a.empty() ? "" : a[0];
  if (file.empty()) {
    const std::string name =
        model.run.scene && model.run.scene->input ? model.run.scene->input->name : "model";
    file = name + "-step-" + std::to_string(state->step) + ".off";
  }
  const TriangleMesh mesh = triangulate(state->zero_set);
  if (Status s = write_mesh(file, mesh); !s) return s;
  model.tell("Z of step " + grouped(state->step) + " is written to " +
             std::filesystem::absolute(file).string() + ".");
  return {};
}

Status screenshot(AppModel& model, const Arguments& a) {
  ScreenshotRequest request;
  for (const std::string& word : a) {
    if (word == "view")
      request.view_only = true;
    else
      request.file = word;
  }
  if (request.file.empty()) request.file = "isoscope-" + time_stamp() + ".png";
  model.requests.screenshots.push_back(request);
  return {};
}

Status play_or_pause(AppModel& model, const Arguments&) {
  if (model.playing()) {
    model.transport.pause();
  } else if (model.transport.at_live_end(model.live_step())) {
    if (model.run.phase == SessionPhase::paused) model.session.resume();
    if (model.running() || model.run.phase == SessionPhase::paused) {
      model.transport.follow();
    } else {
      model.transport.jump(0);
      model.transport.play();
    }
  } else {
    model.transport.play();
  }
  return {};
}

Status step_forward(AppModel& model, const Arguments& a) {
  const auto n = count_of("step", a);
  if (!n) return n.error();
  const Step live = model.live_step();
  const long ahead = static_cast<long>(live) - static_cast<long>(model.transport.step());
  if (*n > ahead && model.run.phase == SessionPhase::paused) {
    model.session.step(static_cast<std::uint32_t>(*n - ahead));
    model.transport.follow();
  } else {
    model.transport.step_by(*n, live);
  }
  return {};
}

Status step_back(AppModel& model, const Arguments& a) {
  const auto n = count_of("back", a);
  if (!n) return n.error();
  model.transport.step_by(-*n, model.live_step());
  return {};
}

Status next_change(AppModel& model, const Arguments&) {
  if (const auto step = model.index.next_change(model.transport.step())) {
    model.transport.jump(*step);
  } else if (model.run.phase == SessionPhase::paused) {
    model.session.run_until(at_change());
    model.transport.follow();
  } else {
    model.transport.follow();
  }
  return {};
}

Status previous_change(AppModel& model, const Arguments&) {
  const Step at = std::min(model.transport.step(), model.index.steps());
  if (at == 0) return {};
  Step k = at - 1;
  while (k > 0 && model.index.condition(k - 1) == model.index.condition(at - 1)) --k;
  model.transport.jump(k);
  return {};
}

Status seek(AppModel& model, const Arguments& a) {
  if (a.size() != 1) return usage("seek", "A step is missing.");
  const auto step = parse_number(a[0]);
  if (!step || *step < 0 || *step > 4e9) return usage("seek", "\"" + a[0] + "\" is not a step.");
  model.transport.jump(std::min(static_cast<Step>(*step), model.live_step()));
  return {};
}

Status set_speed(AppModel& model, const Arguments& a) {
  if (a.size() != 1) return usage("speed", "A speed is missing.");
  if (a[0] == "automatic") {
    model.transport.set_speed(Transport::automatic);
  } else if (a[0] == "unlimited") {
    model.transport.set_speed(Transport::unlimited);
  } else {
    const auto speed = parse_number(a[0]);
    if (!speed || *speed <= 0) return usage("speed", "\"" + a[0] + "\" is not a speed.");
    model.transport.set_speed(*speed);
  }
  return {};
}

Status change_speed(AppModel& model, int direction) {
  const auto offered = Transport::speeds();
  const auto at = std::lower_bound(offered.begin(), offered.end(), model.transport.speed());
  const auto place = std::clamp<std::ptrdiff_t>(at - offered.begin() + direction, 0, std::ssize(offered) - 1);
  model.transport.set_speed(offered[static_cast<std::size_t>(place)]);
  return {};
}

Status hold_or_resume(AppModel& model, const Arguments&) {
  if (model.run.phase == SessionPhase::paused)
    model.session.resume();
  else
    model.session.pause();
  return {};
}

Status apply_parameters(AppModel& model, const Arguments&) {
  if (model.shows_recording())
    return Error{ErrorCode::usage, "A recording cannot go on with other parameters.",
                 "Restart (Ctrl+R) runs its input anew with those of the panel."};
  if (model.draft_needs_restart())
    return Error{ErrorCode::usage, "These parameters belong to the whole run: they need a new one.",
                 "Use Restart (Ctrl+R)."};
  if (Status s = check(model.draft); !s) return s;
  return model.apply();
}

Status pick_element(AppModel& model, const Arguments& a) {
  const auto state = model.state();
  const bool edge = !a.empty() && a[0] == "edge";
  if (a.size() != (edge ? 3 : 2) || !state) return usage("pick", "A kind and a number are needed.");
  std::array<std::uint32_t, 2> ids{Pick().id, Pick().id};
  for (std::size_t i = 1; i < a.size(); ++i) {
    const auto id = parse_number(a[i]);
    if (!id || *id < 0 || *id > 4e9) return usage("pick", "\"" + a[i] + "\" is not a number of an element.");
    ids.at(i - 1) = static_cast<std::uint32_t>(*id);
  }
  Pick pick;
  pick.id = ids[0];
  pick.other = ids[1];
  const Complex& t = state->complex;
  const Error absent{ErrorCode::usage, "There is no " + a[0] + " " + a[1] + " at this step.", ""};
  if (a[0] == "vertex") {
    if (pick.id >= t.vertices.size()) return absent;
    pick.kind = Pick::Kind::vertex;
    pick.point = t.vertices[pick.id].position;
  } else if (edge) {
    pick.kind = Pick::Kind::edge;
    const auto ends = edge_positions(*state, pick);
    if (!ends || pick.id == pick.other) return absent;
    pick.point = 0.5 * ((*ends)[0] + (*ends)[1]);
  } else if (a[0] == "facet") {
    pick.kind = Pick::Kind::facet;
    const Box3 box = pick_bounds(*state, pick);
    if (box.empty()) return absent;
    pick.point = box.center();
  } else if (a[0] == "tet") {
    if (pick.id >= t.tets.size() || !t.tets[pick.id].alive()) return absent;
    pick.kind = Pick::Kind::tet;
    const auto p = t.positions(TetId(pick.id));
    pick.point = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  } else if (a[0] == "sample") {
    if (!state->samples || pick.id >= state->samples->size()) return absent;
    pick.kind = Pick::Kind::sample;
    pick.point = state->samples->positions[pick.id];
  } else {
    return usage("pick", "\"" + a[0] + "\" is not a kind of element.");
  }
  model.selection.pick(pick);
  return {};
}

Status pick_worst(AppModel& model, const Arguments&) {
  const auto state = model.state();
  if (!state || !state->worst_sample.valid()) return Error{ErrorCode::usage, "There is no sample yet.", ""};
  return pick_element(model, {"sample", std::to_string(state->worst_sample.value)});
}

Status clear_selection(AppModel& model, const Arguments&) {
  if (model.overlay != Overlay::none)
    model.overlay = Overlay::none;
  else if (model.debug.range)
    model.debug.range.reset();
  else if (model.presenter.on)
    model.presenter.on = false;
  else
    model.selection.pick({});
  return {};
}

Status restrict_kind(AppModel& model, unsigned kind) {
  model.selection.kinds = model.selection.kinds == kind ? pick_all : kind;
  return {};
}

Status look_along(AppModel& model, const Arguments& a) {
  const std::string axis = a.empty() ? "" : a[0];
  const bool negative = axis.starts_with("-");
  const std::string name = negative ? axis.substr(1) : axis;
  const std::size_t index = std::string_view("xyz").find(name);
  if (name.size() != 1 || index == std::string_view::npos)
    return usage("look", "\"" + axis + "\" is not an axis.");
  model.camera.look_along(static_cast<int>(index), negative ? -1 : 1, !model.scripted);
  model.camera.mark_set();
  return {};
}

Status toggle_orthographic(AppModel& model, const Arguments&) {
  CameraPose pose = model.camera.pose();
  pose.orthographic = !pose.orthographic;
  model.camera.set(pose);
  return {};
}

Status next_clip_shape(AppModel& model, const Arguments&) {
  ClipSettings& clip = model.view.clip;
  clip.shape = static_cast<ClipSettings::Shape>((static_cast<int>(clip.shape) + 1) % 4);
  return {};
}

Status next_clip_mode(AppModel& model, const Arguments&) {
  ClipSettings& clip = model.view.clip;
  clip.mode = static_cast<ClipSettings::Mode>((static_cast<int>(clip.mode) + 1) % 3);
  return {};
}

Status change_shrink(AppModel& model, float by) {
  model.view.tets.shrink = std::clamp(model.view.tets.shrink + by, 0.1f, 1.0f);
  return {};
}

Status set_view(AppModel& model, const Arguments& a) {
  if (a.size() != 1) return usage("view", "The view's JSON is missing.");
  const auto state = view_from_json(a[0], {model.camera.pose(), model.view, model.section});
  if (!state)
    return Error{ErrorCode::usage, "This text is no view.",
                 "Copy one with Ctrl+C in the window, then paste that."};
  const ThemeKind theme = model.view.theme;
  model.view = state->view;
  model.view.theme = theme;
  model.section = state->section;
  model.section_set = true;
  model.camera.set(state->camera, !model.scripted);
  model.camera.mark_set();
  return {};
}

Status copy_view(AppModel& model, const Arguments&) {
  model.requests.copy = to_json(ViewState{model.camera.pose(), model.view, model.section});
  model.tell("The view is copied; Ctrl+V pastes it, here or in another window.");
  return {};
}

Status toggle_panes(AppModel& model, const Arguments&) {
  PaneLayout& p = model.settings.panes;
  const bool any = p.show_left || p.show_right || p.show_bottom;
  p.show_left = p.show_right = p.show_bottom = !any;
  return {};
}

Status choose_tab(AppModel& model, const Arguments& a) {
  constexpr std::array<std::string_view, 7> names{"timeline", "plots", "events", "breakpoints",
                                                  "history",  "work",  "compare"};
  const auto found = a.empty() ? names.end() : std::find(names.begin(), names.end(), a[0]);
  if (found == names.end()) return usage("tab", "Which tab?");
  model.settings.panes.tab = static_cast<int>(found - names.begin());
  model.settings.panes.show_bottom = true;
  return {};
}

Status choose_theme(AppModel& model, const Arguments& a) {
  if (!a.empty()) return find_value("theme")->set(model, a[0]);
  model.view.theme = static_cast<ThemeKind>((static_cast<int>(model.view.theme) + 1) % 3);
  return {};
}

Status change_scale(AppModel& model, int direction) {
  float& scale = model.settings.ui_scale;
  scale = direction == 0
              ? 1.0f
              : std::clamp(std::round((scale + 0.1f * static_cast<float>(direction)) * 10) / 10, 0.5f, 4.0f);
  return {};
}

} // namespace isoscope::actions
