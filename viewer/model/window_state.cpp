// Messages, the window's memory of its look, and what follows from what is selected.
#include "model/window_state.h"

#include "scene/overlay.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::size_t message_limit = 4;

} // namespace

float Message::strength(double clock) const {
  if (error) return 1;
  const double left = since + shown - clock;
  return static_cast<float>(std::clamp(left / fade, 0.0, 1.0));
}

bool WindowState::drag_in_scene(Vec3 point, float dx, float dy) {
  const auto [x, y, width, height] = scene_area;
  const ScreenPoint at = project(camera, point, static_cast<double>(width), static_cast<double>(height));
  if (!at.visible) return false;
  const float from_x = x + static_cast<float>(at.x), from_y = y + static_cast<float>(at.y);
  constexpr int moves = 8;
  for (int i = -2; i <= moves + 1; ++i) {
    const float t = static_cast<float>(std::clamp(i, 0, moves)) / moves;
    requests.mouse.push_back({from_x + t * dx, from_y + t * dy, 0, i >= 0 && i <= moves});
  }
  return true;
}

void WindowState::add(Message message) {
  // The same words again are no second line.
  const auto same = std::find_if(messages.begin(), messages.end(), [&](const Message& m) {
    return m.error == message.error && m.text == message.text && m.remedy == message.remedy;
  });
  if (same != messages.end()) {
    message.times = same->times + 1;
    messages.erase(same);
  }
  messages.push_back(std::move(message));
  while (messages.size() > message_limit) messages.pop_front();
}

void WindowState::report(const Error& error) {
  add({true, error.message, error.remedy, clock});
}

void WindowState::tell(std::string text) {
  add({false, std::move(text), "", clock});
}

void WindowState::toggle(Overlay which) {
  overlay = overlay == which ? Overlay::none : which;
}

void WindowState::open_tab(BottomTab tab) {
  settings.panes.tab = tab;
  settings.panes.show_bottom = true;
}

void WindowState::lend_layout(LayoutGuest guest) {
  if (guests_ == 0) kept_layout_ = settings.panes;
  guests_ |= static_cast<unsigned>(guest);
}

void WindowState::end_loan(LayoutGuest guest) {
  guests_ &= ~static_cast<unsigned>(guest);
  if (guests_ == 0) kept_layout_.reset();
}

void WindowState::reset_layout() {
  settings.panes = {};
  if (kept_layout_) kept_layout_ = settings.panes;
}

std::string_view name(AnswerKind answer) {
  constexpr std::array<std::string_view, 7> words{"none",        "unlock",   "advice", "what-if",
                                                  "certificate", "topology", "check"};
  return words.at(static_cast<std::size_t>(answer));
}

void WindowState::bring_into_sight(AnswerKind which) {
  if (!settings.panes.show_right) {
    // What it told of when it was seen last does not matter: the answer comes first.
    settings.panes.show_right = true;
    inspected = selection.picked;
    inspected_event = selection.event;
  }
  answer.wanted = which;
  answer.awaited = false;
}

void WindowState::center_clip() {
  const Box3 box = scene_bounds();
  if (box.empty()) return;
  view.clip.point = box.center();
  view.clip.radius = 0.15 * box.longest_edge();
}

void WindowState::frame_all() {
  requests.frame_selection = false;
  camera.release();
  section_set = false;
}

ViewMemento WindowState::memento() const {
  ViewMemento m;
  m.view = {camera.goal(), view, section};
  if (blinking) m.view.view.moment = Moment::both;
  m.filter = filter.chosen;
  m.condition = filter.condition;
  m.picked = selection.picked;
  m.kinds = selection.kinds;
  m.event = selection.event;
  m.panes = settings.panes;
  return m;
}

void WindowState::take(const ViewMemento& m) {
  if (!(m.view.camera == camera.goal())) {
    camera.set(m.view.camera, !scripted);
    camera.mark_set();
  }
  const Moment moment = view.moment;
  view = m.view.view;
  if (blinking) view.moment = moment;
  section = m.view.section;
  filter.chosen = m.filter;
  if (m.condition != filter.condition) filter.set_condition(m.condition);
  selection.pick(m.picked);
  selection.kinds = m.kinds;
  selection.event = m.event;
  settings.panes = m.panes;
}

void WindowState::show(const ViewState& state) {
  const ThemeKind theme = view.theme;
  view = state.view;
  view.theme = theme;
  section = state.section;
  section_set = true;
  camera.set(state.camera, !scripted);
  camera.mark_set();
}

ViewSettings WindowState::shown_view() const {
  ViewSettings shown = view;
  if (!other_state) shown.other_zero.visible = false;
  if (input_alone()) shown.input = {true, 1};
  if (preview_delta && run.scene && run.scene->delta > 0)
    shown.level = static_cast<float>(*preview_delta / run.scene->delta);
  const bool heat = settings.panes.tab == BottomTab::work && settings.panes.show_bottom;
  const bool element = selection.picked.kind == Pick::Kind::edge || selection.picked.kind == Pick::Kind::tet;
  if (!view.focus || !(element || heat)) return shown;
  constexpr float step_back = 0.35f;
  shown.samples.visible = false;
  if (selection.picked.kind == Pick::Kind::tet) {
    shown.highlight.visible = shown.tets.violate_3 = false;
    shown.zero_set.opacity *= step_back;
  }
  shown.outer.opacity *= step_back;
  shown.inner.opacity *= step_back;
  shown.tets.changed = false;
  return shown;
}

bool WindowState::input_alone() const {
  if (!run.input) return false;
  const auto shown = state();
  const bool unfilled = grid.working() && !grid.grid() && (view.outer.visible || view.inner.visible);
  return !run.scene || scene_awaited || (unfilled && shown && shown->step == 0);
}

std::optional<std::array<double, 2>> WindowState::preview_range() const {
  const auto shown = grid.grid();
  if (!run.scene || !run.scene->study || run.scene->study->curve.empty() || !shown) return std::nullopt;
  const auto& curve = run.scene->study->curve;
  const double most = std::min(curve.back().delta, static_cast<double>(shown->level) * run.scene->delta);
  if (!(most > curve.front().delta)) return std::nullopt;
  return std::array{curve.front().delta, most};
}

std::optional<std::uint32_t> WindowState::selected_event() const {
  const auto shown = state();
  if (!shown || !run.journal || selection.picked.kind != Pick::Kind::edge) return std::nullopt;
  if (selection.event && *selection.event < run.journal->events().size()) {
    const Event& e = run.journal->events()[*selection.event];
    if (e.step == shown->step || (e.operation && e.step + 1 == shown->step)) return selection.event;
  }
  return edge_event(*run.journal, shown->step, VertexId(selection.picked.id),
                    VertexId(selection.picked.other));
}

} // namespace isoscope
