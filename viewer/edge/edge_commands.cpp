// Commands that question a picked edge: targets that are tried, candidates, unlocking, branches.
#include "command/command_groups.h"
#include "ui/icons.h"
#include "command/named_values.h"
#include "questions/target_study.h"
#include "scene/overlay.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

using M = AppModel;
using A = Arguments;

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

Status try_target(M& m, const A& a) {
  if (a.size() == 1 && a[0] == "off") {
    m.selection.try_target({});
    return {};
  }
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const Vec3 from = m.selection.what_if.value_or(first_target(*xray));
  if (a.empty()) {
    m.selection.try_target(from);
    return {};
  }
  if (a.size() == 3) {
    Vec3 target;
    for (int i = 0; i < 3; ++i) {
      const auto number = parse_number(a[static_cast<std::size_t>(i)]);
      if (!number) return number.error();
      target[i] = *number;
    }
    m.selection.try_target(target);
    return {};
  }
  for (const auto& [word, snap] : snaps) {
    if (a[0] != word || a.size() != 1) continue;
    const auto target = snapped(*xray, from, snap);
    if (!target)
      return Error{ErrorCode::usage, "The kernel is empty: it has no such point.", "Try \"what-if center\"."};
    m.selection.try_target(target);
    return {};
  }
  return Error{ErrorCode::usage, "There is no such target.",
               "It is used so: what-if X Y Z, or one of optimum, best, found, vertex, center, kept, removed, "
               "off"};
}

/// In the camera's plane, or along its depth.
Status nudge(M& m, Vec3 direction) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const double length = nudge_length * (xray->criteria.delta > 0 ? xray->criteria.delta : 1);
  const Vec3 from = m.selection.what_if.value_or(first_target(*xray));
  m.selection.try_target(from + length * m.camera.to_world(direction));
  return {};
}

Status next_candidate(M& m, int direction) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const auto n = static_cast<int>(xray->attempt.candidates.size());
  if (n == 0) return Error{ErrorCode::usage, "No candidate was judged.", ""};
  const int from = m.selection.candidate ? static_cast<int>(*m.selection.candidate) : direction > 0 ? -1 : n;
  const auto to = static_cast<std::uint32_t>(((from + direction) % n + n) % n);
  m.selection.try_target(xray->attempt.candidates[to].point, to);
  return {};
}

Status go_to_candidate(M& m, const A& a) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  const auto number = a.size() == 1 ? parse_number(a[0]) : Result<double>(-1.0);
  if (!number || *number < 0 || *number >= static_cast<double>(xray->attempt.candidates.size()))
    return Error{ErrorCode::usage, "There is no such candidate.", "It is used so: candidate NUMBER"};
  const auto i = static_cast<std::uint32_t>(*number);
  m.selection.try_target(xray->attempt.candidates[i].point, i);
  return {};
}

/// As the mouse does it; scripts know no place on the screen.
Status drag_target(M& m, const A& a) {
  const auto xray = m.xray();
  if (!xray) return no_xray();
  std::array<float, 2> by{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto number = a.size() == 2 ? parse_number(a[i]) : Result<double>(Error{});
    if (!number) return Error{ErrorCode::usage, "By how many pixels?", "It is used so: drag-target DX DY"};
    by.at(i) = static_cast<float>(*number);
  }
  const auto [x, y, width, height] = m.scene_area;
  const ScreenPoint at = project(m.camera, m.selection.what_if.value_or(first_target(*xray)),
                                 static_cast<double>(width), static_cast<double>(height));
  if (!at.visible) return Error{ErrorCode::usage, "The target is not in sight.", ""};
  const float from_x = x + static_cast<float>(at.x), from_y = y + static_cast<float>(at.y);
  constexpr int moves = 8;
  for (int i = -2; i <= moves + 1; ++i) {
    const float t = static_cast<float>(std::clamp(i, 0, moves)) / moves;
    m.requests.mouse.push_back({from_x + t * by[0], from_y + t * by[1], 0, i >= 0 && i <= moves});
  }
  return {};
}

bool has_xray(const M& m) {
  return m.xray() != nullptr;
}

} // namespace

std::vector<Command> edge_commands() {
  return {
      {"what-if",
       "Try a target",
       "[X Y Z | optimum | best | found | vertex | center | kept | removed | off]",
       "Judges the collapse of the picked edge to a point; drag it in the view, or nudge it.",
       "Select",
       icon::bolt,
       {{'M'}},
       try_target,
       has_xray},
      {"nudge-left",
       "Nudge the target left",
       "",
       "Moves the target that is tried by a fiftieth of δ in the plane of the view.",
       "",
       nullptr,
       {{GLFW_KEY_LEFT, false, true}},
       [](M& m, const A&) {
         return nudge(m, {-1, 0, 0});
       },
       has_xray},
      {"nudge-right",
       "Nudge the target right",
       "",
       "The same to the right.",
       "",
       nullptr,
       {{GLFW_KEY_RIGHT, false, true}},
       [](M& m, const A&) {
         return nudge(m, {1, 0, 0});
       },
       has_xray},
      {"nudge-up",
       "Nudge the target up",
       "",
       "The same upwards.",
       "",
       nullptr,
       {{GLFW_KEY_UP, false, true}},
       [](M& m, const A&) {
         return nudge(m, {0, 1, 0});
       },
       has_xray},
      {"nudge-down",
       "Nudge the target down",
       "",
       "The same downwards.",
       "",
       nullptr,
       {{GLFW_KEY_DOWN, false, true}},
       [](M& m, const A&) {
         return nudge(m, {0, -1, 0});
       },
       has_xray},
      {.name = "drag-target",
       .title = "Drag the target",
       .usage = "DX DY",
       .help = "Drags the target that is tried with the mouse, by pixels.",
       .menu = "",
       .icon = nullptr,
       .keys = {},
       .run = drag_target,
       .enabled = has_xray,
       .checked = nullptr,
       .for_scripts = true},
      {"next-candidate",
       "Next candidate",
       "",
       "Shows the next point that was judged as a target, with what went wrong there.",
       "Select",
       nullptr,
       {{'I'}},
       [](M& m, const A&) { return next_candidate(m, 1); },
       has_xray},
      {"previous-candidate",
       "Previous candidate",
       "",
       "Shows the one before.",
       "Select",
       nullptr,
       {{'I', false, true}},
       [](M& m, const A&) { return next_candidate(m, -1); },
       has_xray},
      {"candidate",
       "Candidate…",
       "NUMBER",
       "Shows a point that was judged as a target.",
       "",
       nullptr,
       {},
       go_to_candidate,
       has_xray},
      {"unlock",
       "What would unlock this edge?",
       "",
       "Tries the collapses of neighbouring edges on a copy and tells which make this one possible.",
       "Select",
       icon::bolt,
       {{'U'}},
       [](M& m, const A&) { return m.search_unlocks(); },
       has_xray},
      {"do-it",
       "Do it: branch the run",
       "",
       "Collapses the edge to the target that is tried in a run of its own that goes on from this step.",
       "Select",
       icon::check,
       {{'D', true}},
       [](M& m, const A&) { return m.branch_here(); },
       [](const M& m) { return m.study() != nullptr && m.study()->attempt.possible(); }},
  };
}

} // namespace isoscope
