// Commands that question a picked edge: targets that are tried, candidates, unlocking, branches.
#include "edge/probe.h"

#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace isoscope {
namespace {

constexpr double nudge_length = 0.02; ///< of δ

Error no_xray() {
  return {ErrorCode::usage, "There is no X-ray.", "Select an edge of T first."};
}

constexpr std::array<std::pair<std::string_view, TargetSnap>, 7> snaps{{{"optimum", TargetSnap::optimum},
                                                                        {"best", TargetSnap::best},
                                                                        {"found", TargetSnap::found},
                                                                        {"vertex", TargetSnap::vertex},
                                                                        {"center", TargetSnap::center},
                                                                        {"kept", TargetSnap::kept},
                                                                        {"removed", TargetSnap::removed}}};

/// What a what-if begins with: the target found, else the least error in the kernel, else where it misses
/// least.
Vec3 first_target(const EdgeXray& xray) {
  if (xray.attempt.possible()) return xray.attempt.target;
  for (const TargetSnap snap : {TargetSnap::best, TargetSnap::center})
    if (const auto point = snapped(xray, {}, snap)) return *point;
  return 0.5 * (xray.star.vertices[0].position + xray.star.vertices[1].position);
}

Status try_target(EdgeProbe& m, const Arguments& a) {
  if (a.size() == 1 && a[0] == "off") {
    m.window.selection.try_target({});
    return {};
  }
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const Vec3 from = m.window.selection.what_if.value_or(first_target(*xray));
  m.window.bring_into_sight(AnswerKind::what_if);
  if (a.empty()) {
    m.window.selection.try_target(from);
    return {};
  }
  if (a.size() == 3) {
    const auto target = vector_of(a);
    if (!target) return wrong_arguments("Three numbers are needed.");
    m.window.selection.try_target(*target);
    return {};
  }
  for (const auto& [word, snap] : snaps) {
    if (a[0] != word || a.size() != 1) continue;
    const auto target = snapped(*xray, from, snap);
    if (!target)
      return Error{ErrorCode::usage, "The kernel is empty: it has no such point.", "Try \"what-if center\"."};
    m.window.selection.try_target(target);
    return {};
  }
  return Error{ErrorCode::usage, "There is no such target.",
               "It is used so: what-if X Y Z, or one of optimum, best, found, vertex, center, kept, removed, "
               "off"};
}

/// In the camera's plane, or along its depth.
Status nudge(EdgeProbe& m, Vec3 direction) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const double length = nudge_length * xray->criteria.unit();
  const Vec3 from = m.window.selection.what_if.value_or(first_target(*xray));
  m.window.selection.try_target(from + length * m.window.camera.to_world(direction));
  return {};
}

Status next_candidate(EdgeProbe& m, int direction) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const auto n = static_cast<int>(xray->attempt.candidates.size());
  if (n == 0) return usage("No candidate was judged.");
  const int from = m.window.selection.candidate ? static_cast<int>(*m.window.selection.candidate)
                   : direction > 0              ? -1
                                                : n;
  const auto to = static_cast<std::uint32_t>(((from + direction) % n + n) % n);
  m.window.selection.try_target(xray->attempt.candidates[to].point, to);
  return {};
}

Status go_to_candidate(EdgeProbe& m, const Arguments& a) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const auto number = whole_argument(a, 0, 0);
  if (!number || a.size() != 1 || *number >= xray->attempt.candidates.size())
    return Error{ErrorCode::usage, "There is no such candidate.", "It is used so: candidate NUMBER"};
  const auto i = static_cast<std::uint32_t>(*number);
  m.window.selection.try_target(xray->attempt.candidates[i].point, i);
  return {};
}

/// As the mouse does it; scripts know no place on the screen.
Status drag_target(EdgeProbe& m, const Arguments& a) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const auto by = pixels_of(a);
  if (!by) return Error{ErrorCode::usage, "By how many pixels?", "It is used so: drag-target DX DY"};
  if (!m.window.drag_in_scene(m.window.selection.what_if.value_or(first_target(*xray)), (*by)[0], (*by)[1]))
    return usage("The target is not in sight.");
  return {};
}

struct Nudge {
  const char *word, *help;
  int key;
  Vec3 direction;
};
constexpr std::array<Nudge, 4> nudges{
    {{"left",
      "Moves the target that is tried by a fiftieth of δ in the plane of the view.",
      GLFW_KEY_LEFT,
      {-1, 0, 0}},
     {"right", "The same to the right.", GLFW_KEY_RIGHT, {1, 0, 0}},
     {"up", "The same upwards.", GLFW_KEY_UP, {0, 1, 0}},
     {"down", "The same downwards.", GLFW_KEY_DOWN, {0, -1, 0}}}};

} // namespace

void EdgeProbe::add_commands(CommandTable& table) {
  const auto has_xray = [this] { return xray() != nullptr; };
  table.add({{.name = "what-if",
              .title = "Try a target",
              .usage = "[X Y Z | optimum | best | found | vertex | center | kept | removed | off]",
              .help = "Judges the collapse of the picked edge to a point; drag it in the view, or nudge it.",
              .menu = "Select",
              .icon = icon::bolt,
              .keys = {{'M'}},
              .run = on(*this, try_target),
              .enabled = has_xray}});
  for (const Nudge& n : nudges)
    table.add({{.name = std::string("nudge-") + n.word,
                .title = std::string("Nudge the target ") + n.word,
                .help = n.help,
                .keys = {{n.key, false, true}},
                .run = [this, to = n.direction](const Arguments&) { return nudge(*this, to); },
                .enabled = has_xray}});
  table.add(
      {{.name = "drag-target",
        .title = "Drag the target",
        .usage = "DX DY",
        .help = "Drags the target that is tried with the mouse, by pixels.",
        .run = on(*this, drag_target),
        .enabled = has_xray,
        .for_scripts = true},
       {.name = "next-candidate",
        .title = "Next candidate",
        .help = "Shows the next point that was judged as a target, with what went wrong there.",
        .menu = "Select",
        .keys = {{'I'}},
        .run = [this](const Arguments&) { return next_candidate(*this, 1); },
        .enabled = has_xray},
       {.name = "previous-candidate",
        .title = "Previous candidate",
        .help = "Shows the one before.",
        .menu = "Select",
        .keys = {{'I', false, true}},
        .run = [this](const Arguments&) { return next_candidate(*this, -1); },
        .enabled = has_xray},
       {.name = "candidate",
        .title = "Candidate…",
        .usage = "NUMBER",
        .help = "Shows a point that was judged as a target.",
        .run = on(*this, go_to_candidate),
        .enabled = has_xray},
       {.name = "unlock",
        .title = "What would unlock this edge?",
        .help = "Tries the collapses of neighbouring edges on a copy and tells which make this one possible.",
        .menu = "Select",
        .icon = icon::bolt,
        .keys = {{'U'}},
        .run = [this](const Arguments&) { return search_unlocks(); },
        .enabled = has_xray}});
}

} // namespace isoscope
