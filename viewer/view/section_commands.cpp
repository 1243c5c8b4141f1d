// What the section's commands do, and their table.
#include "view/view.h"

#include "command/commands.h"
#include "edge/probe.h"
#include "ui/icons.h"
#include "view/section_through.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

Status cut_through_selection(WindowState& m, const EdgeProbe& probe) {
  const auto state = m.state();
  const Pick& pick = m.selection.picked;
  if (!state || pick.kind == Pick::Kind::none)
    return Error{ErrorCode::usage, "Nothing is selected.", "Click an element first."};
  const auto xray = probe.xray();
  const Vec3 eye = normalized(m.camera.eye() - m.camera.pose().target);
  const auto through = section_through(*state, pick, xray.get(), eye);
  if (!through) return usage("What is selected is not there at this step.");
  ClipSettings& clip = m.view.clip;
  clip.point = through->point;
  clip.normal = through->normal;
  clip.flipped = false;
  if (clip.shape == ClipSettings::Shape::none) clip.shape = ClipSettings::Shape::plane;
  if (m.view.mode == ViewMode::scene) m.view.mode = ViewMode::split;
  const double margin = m.run.scene ? 3 * m.run.scene->delta : 0;
  const Box3 box = through->shown.grown(margin + 0.1 * through->shown.longest_edge());
  m.section = {0, 0, 1.15 * box.longest_edge()};
  m.section_set = true;
  m.camera.frame(box, !m.scripted);
  m.camera.mark_set();
  return {};
}

/// As the mouse does it; scripts know no place on the screen.
Status drag_clip(WindowState& m, const Arguments& a) {
  const auto by = pixels_of(a);
  if (!by) return wrong_arguments("By how many pixels?");
  if (!m.drag_in_scene(clip_anchor(m.view.clip, m.scene_bounds()), (*by)[0], (*by)[1]))
    return usage("The handle is not in sight.");
  return {};
}

} // namespace

void add_section_commands(CommandTable& table, WindowState& m, const EdgeProbe& probe) {
  table.add({{.name = "drag-clip",
              .title = "Drag the clip",
              .usage = "DX DY",
              .help = "Drags the disc of the clip's handle with the mouse, by pixels.",
              .run = on(m, drag_clip),
              .for_scripts = true}});
  add_group(
      table, {.menu = "View"},
      {{.name = "section-selection",
        .title = "Section through the selection",
        .help = "Cuts by the plane that shows what is selected, and centres section and view on it: of an "
                "edge through its kernel, else across Z.",
        .icon = icon::split,
        .keys = {{'S'}},
        .run = [&m, &probe](const Arguments&) { return cut_through_selection(m, probe); },
        .enabled = [&m] { return m.has_state() && m.selection.picked.kind != Pick::Kind::none; }},
       {.name = "clip-handle",
        .title = "Handle of the clip",
        .help = "Shows or hides the handle of the clip's plane in 3D: its disc moves the plane, the tip of "
                "its arrow turns it.",
        .run = flips(m.view.clip_handle),
        .checked = is_on(m.view.clip_handle)}});
}

} // namespace isoscope
