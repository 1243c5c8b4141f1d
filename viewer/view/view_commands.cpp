// What the commands on the view do, and their table.
#include "view/view.h"

#include "command/commands.h"
#include "scene/volume_look.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

Status look_along(WindowState& m, const Arguments& a) {
  if (a.size() == 3) {
    const auto from = vector_of(a);
    if (!from) return wrong_arguments("Three numbers are needed.");
    if (squared_length(*from) == 0) return wrong_arguments("From nowhere nothing is seen.");
    m.camera.look_from(*from, !m.scripted);
    m.camera.mark_set();
    return {};
  }
  const std::string axis = a.empty() ? "" : a[0];
  const bool negative = axis.starts_with("-");
  const std::string name = negative ? axis.substr(1) : axis;
  const std::size_t index = std::string_view("xyz").find(name);
  if (name.size() != 1 || index == std::string_view::npos)
    return wrong_arguments("\"" + axis + "\" is not an axis.");
  m.camera.look_along(static_cast<int>(index), negative ? -1 : 1, !m.scripted);
  m.camera.mark_set();
  return {};
}

Status toggle_orthographic(WindowState& m, const Arguments&) {
  CameraPose pose = m.camera.pose();
  pose.orthographic = !pose.orthographic;
  m.camera.set(pose);
  return {};
}

/// Takes the next of so many values, the first after the last.
template <class Choice> auto cycles(Choice& place, int count) {
  return does([&place, count] { place = static_cast<Choice>((static_cast<int>(place) + 1) % count); });
}

Status change_shrink(WindowState& m, float by) {
  m.view.tets.shrink = std::clamp(m.view.tets.shrink + by, 0.1f, 1.0f);
  return {};
}

struct ModeCommand {
  const char *name, *title, *help, *icon;
  int key;
  ViewMode mode;
};
constexpr std::array<ModeCommand, 3> mode_commands{
    {{"scene", "3D view", "Shows the scene in space.", icon::cube, '6', ViewMode::scene},
     {"section", "2D section", "Shows the section by the clip's plane, drawn like the paper's figures.",
      icon::square, '7', ViewMode::section},
     {"split", "3D and section", "Shows both beside each other.", icon::split, '8', ViewMode::split}}};

struct AxisCommand {
  const char *name, *title, *axis;
  int key;
};
constexpr std::array<AxisCommand, 3> axis_commands{{{"front", "Front view", "z", GLFW_KEY_KP_1},
                                                    {"right", "Right view", "x", GLFW_KEY_KP_3},
                                                    {"top", "Top view", "y", GLFW_KEY_KP_7}}};

/// The look after the present one; the first after what is none.
Status next_look(WindowState& m, const Arguments&) {
  const VolumeLook* now = look_of(m.view);
  const std::size_t next = now ? static_cast<std::size_t>(now - volume_looks.data() + 1) : 0;
  apply(volume_looks[next % volume_looks.size()], m.view);
  return {};
}

Status set_view(WindowState& m, const Arguments& a) {
  return a.size() == 1 ? show_view(m, a[0]) : Status(wrong_arguments("The view's JSON is missing."));
}

Status copy_view(WindowState& m, const Arguments&) {
  m.requests.copy = to_json(ViewState{m.camera.pose(), m.view, m.section});
  m.tell("The view is copied; Ctrl+V pastes it, here or in another window.");
  return {};
}

Status toggle_blink(WindowState& m, const Arguments&) {
  m.blinking = !m.blinking;
  if (!m.blinking) m.view.moment = Moment::both;
  return {};
}

Status undo_view(WindowState& m, const Arguments&) {
  if (const auto before = m.history.undo()) m.take(*before);
  return {};
}

Status redo_view(WindowState& m, const Arguments&) {
  if (const auto after = m.history.redo()) m.take(*after);
  return {};
}

} // namespace

Status show_view(WindowState& m, const std::string& json) {
  const auto state = view_from_json(json, {m.camera.pose(), m.view, m.section});
  if (!state)
    return Error{ErrorCode::usage, "This text is no view.",
                 "Copy one with Ctrl+C in the window, then paste that."};
  m.show(*state);
  return {};
}

void add_view_commands(CommandTable& table, WindowState& m) {
  for (const ModeCommand& mode : mode_commands)
    table.add({{.name = mode.name,
                .title = mode.title,
                .help = mode.help,
                .menu = "View",
                .icon = mode.icon,
                .keys = {{mode.key}},
                .run = does([&m, to = mode.mode] { m.view.mode = to; }),
                .checked = [&m, to = mode.mode] { return m.view.mode == to; }}});
  table.add({{.name = "frame-all",
              .title = "Frame everything",
              .help = "Shows the whole model, also as panes come and go, until the camera is moved.",
              .menu = "View",
              .icon = icon::home,
              .keys = {{'A'}},
              .run = does([&m] { m.frame_all(); })},
             {.name = "look",
              .title = "Look along an axis",
              .usage = "x | y | z | -x | -y | -z | X Y Z",
              .help = "Looks along an axis, or from a direction.",
              .run = on(m, look_along)}});
  for (const AxisCommand& axis : axis_commands)
    table.add({{.name = axis.name,
                .title = axis.title,
                .help = std::string("Looks along ") + axis.axis + ".",
                .menu = "View",
                .keys = {{axis.key}},
                .run = [&m, along = axis.axis](const Arguments&) { return look_along(m, {along}); }}});
  table.add({{.name = "orthographic",
              .title = "Orthographic",
              .help = "Switches between perspective and parallel projection.",
              .menu = "View",
              .keys = {{GLFW_KEY_KP_5}, {'5'}},
              .run = on(m, toggle_orthographic),
              .checked = [&m] { return m.camera.pose().orthographic; }}});
  add_group(table, {.menu = "View"},
            {{.name = "clip-next",
              .title = "Next clip shape",
              .help = "Cuts by nothing, plane, slab or ball in turn.",
              .icon = icon::scissors,
              .keys = {{'X'}},
              .run = cycles(m.view.clip.shape, 4)},
             {.name = "clip-mode",
              .title = "Next clip mode",
              .help = "Cuts cells, keeps them whole, or shows those that straddle the cut.",
              .keys = {{'C'}},
              .run = cycles(m.view.clip.mode, 3)},
             {.name = "clip-flip",
              .title = "Flip the clip",
              .help = "Cuts the other side away.",
              .icon = icon::flip,
              .keys = {{'X', false, true}},
              .run = flips(m.view.clip.flipped),
              .checked = is_on(m.view.clip.flipped)}});
  add_group(table, {.menu = "View"},
            {{.name = "blink",
              .title = "Blink before and after",
              .help = "Shows Z before and after the operation in turn.",
              .keys = {{'V'}},
              .run = on(m, toggle_blink),
              .checked = is_on(m.blinking)},
             {.name = "focus",
              .title = "Focus on the selected edge",
              .help = "With an edge selected samples, Ω and changed tetrahedra step back, or stay.",
              .keys = {{'Z'}},
              .run = flips(m.view.focus),
              .checked = is_on(m.view.focus)},
             {.name = "psi",
              .title = "Ψ of the edge",
              .help = "Shows or hides Ψ in the X-ray: where targets are known to fail.",
              .run = flips(m.view.invalid_regions),
              .checked = is_on(m.view.invalid_regions)},
             {.name = "octree-cells",
              .title = "Octree of the edge",
              .help = "Shows or hides the cells of the octree search in the X-ray.",
              .run = flips(m.view.octree_cells),
              .checked = is_on(m.view.octree_cells)}});
  add_group(table, {.menu = "View"},
            {{.name = "omega-look",
              .title = "Next look of Ω",
              .help = "Draws Ω as shell, fog, inner boundary or thickness in turn.",
              .run = on(m, next_look)},
             {.name = "near-samples",
              .title = "Good samples near the operation only",
              .help = "In 3D shows good samples around the current operation alone, or all of them.",
              .run = flips(m.view.near_samples),
              .checked = is_on(m.view.near_samples)},
             {.name = "warnings",
              .title = "Warnings",
              .help = "Shows in full what the user should know of this run, or folds it to its chip.",
              .icon = icon::warning,
              .run = flips(m.warnings_open),
              .enabled = [&m] { return !m.warnings().empty(); },
              .checked = is_on(m.warnings_open)}});
  table.add({{.name = "shrink-less",
              .title = "Grow tetrahedra",
              .help = "Shows tetrahedra larger.",
              .keys = {{GLFW_KEY_RIGHT_BRACKET}},
              .run = [&m](const Arguments&) { return change_shrink(m, 0.05f); }},
             {.name = "shrink-more",
              .title = "Shrink tetrahedra",
              .help = "Shows tetrahedra smaller.",
              .keys = {{GLFW_KEY_LEFT_BRACKET}},
              .run = [&m](const Arguments&) { return change_shrink(m, -0.05f); }},
             {.name = "view",
              .title = "Set the view",
              .usage = "JSON",
              .help = "Takes camera, layers, filter and clip from JSON.",
              .run = on(m, set_view),
              .raw = true}});
  add_group(table, {.menu = "View"},
            {{.name = "copy-view",
              .title = "Copy the view",
              .help = "Copies camera, layers, filter and clip as JSON.",
              .keys = {{'C', true}},
              .run = on(m, copy_view)},
             {.name = "paste-view",
              .title = "Paste a view",
              .help = "Takes the view from the clipboard.",
              .keys = {{'V', true}},
              .run = does([&m] { m.requests.paste = true; })},
             {.name = "undo",
              .title = "Undo the view",
              .help = "Takes back the last change of view, filter, selection or layout; never of the run.",
              .keys = {{'Z', true}},
              .run = on(m, undo_view),
              .enabled = [&m] { return m.history.undo_depth() > 0; }},
             {.name = "redo",
              .title = "Redo the view",
              .help = "Brings again what was undone.",
              .keys = {{'Y', true}, {'Z', true, true}},
              .run = on(m, redo_view),
              .enabled = [&m] { return m.history.redo_depth() > 0; }}});
}

} // namespace isoscope
