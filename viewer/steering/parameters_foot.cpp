// The foot of the left pane: the sliders of a run that goes on, what would violate, and the buttons.
#include "steering/parameter_rows.h"
#include "steering/steering.h"

#include "model/words.h"
#include "ui/widgets.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace isoscope::panels {
namespace {

using P = RunParameters;

constexpr float foot_row = 26, foot_gap = 4, foot_counts = 34, foot_line = 18, foot_buttons = 28;
constexpr std::array<double P::*, 3> foot_sliders{&P::alpha, &P::sigma, &P::shrink};

/// What is said of a slider where the mouse rests on it: σ as a length too.
std::string slider_tip(const Ui& ui, const Field<P, double>& f, double value) {
  std::string tip = std::string(f.tip) + " Ctrl and a click types a number.";
  const auto& scene = ui.window.run.scene;
  if (f.member == &P::sigma && scene && std::isfinite(value))
    tip += " Here " + short_number(value * scene->delta) + " long.";
  return tip;
}

/// What a slider offers: the field's range, one digit inside where an end is not part of it. A number that is
/// typed may be any: what is out of range is told.
void parameter_slider(const Ui& ui, const Field<P, double>& f, double& value) {
  const int digits = f.format[2] - '0'; // "%.2f"
  const double step = std::pow(10.0, -digits);
  const double low = f.slider_from > 0 ? f.slider_from : f.range.low + (f.range.low_included ? 0 : step);
  const double high = f.range.high - (f.range.high_included ? 0 : step);
  auto shown = static_cast<float>(value);
  if (widgets::numbered_slider(
          ui, unlabelled(f).c_str(), shown, static_cast<float>(low), static_cast<float>(high),
          (std::string(f.format) + std::string(f.counted_in.empty() ? f.unit : f.counted_in)).c_str(),
          f.logarithmic))
    value = std::round(static_cast<double>(shown) * 1e4) / 1e4;
}

void parameter_slider_row(Ui& ui, const Field<P, double>& f, const P& used) {
  P& p = ui.window.draft;
  const double by_default = ui.window.run.scene ? ui.window.run.scene->default_sigma : 0.5;
  FieldState state = field_state(f, p, used);
  double value = p.*(f.member);
  const bool sigma = f.member == &P::sigma;
  if (sigma) {
    const double now = used.sigma_ratio(by_default);
    value = p.sigma_ratio(by_default);
    if (!state.error.empty()) value = p.sigma;
    state.differs = value != now;
    if (state.differs) state.used = general(now, 4) + std::string(f.counted_in);
  }
  const double before = value;
  parameter_label(ui, f, state, foot_row - foot_gap);
  parameter_slider(ui, f, value);
  widgets::tip(ui, f.title, slider_tip(ui, f, value));
  if (value != before) p.*(f.member) = value;
  if (!state.error.empty()) wrong_value_frame(ui);
}

/// A count with its name above: what violates now, nothing where that is not judged, and what would.
void violation_count(const Ui& ui, const char* name, const char* help, std::optional<std::size_t> now,
                     std::optional<std::size_t> then, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(name);
  ImGui::InvisibleButton("count", {width, ui.px(foot_counts)});
  ImGui::PopID();
  widgets::tip(ui, name, help);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  {
    const widgets::Font font(ui.fonts.small);
    widgets::draw_text(list, ui.fonts.small, at, to_u32(ui.colors.quiet),
                       widgets::fitted(name, width - ui.px(6)));
  }
  const bool known = then && *then != now;
  const std::string before = now ? grouped(*now) : "–",
                    text = known ? before + " → " + grouped(*then) : before;
  const Rgb color = !known                    ? ui.colors.text
                    : *then > now.value_or(0) ? ui.colors.bad_text
                                              : ui.colors.good_text;
  const widgets::Font font(ui.fonts.mono);
  widgets::draw_text(list, ui.fonts.mono, {at.x, at.y + ui.px(15)}, to_u32(color),
                     widgets::fitted(text, width - ui.px(4)));
}

void violation_counts(const Ui& ui) {
  const WindowState& m = ui.window;
  const auto state = m.state();
  const auto& next = m.would_violate;
  const float each = std::floor(ImGui::GetContentRegionAvail().x / 3);
  // Before T is there and once f is no more that of the refinement nothing is judged, which is not 0.
  const bool judged = state && state->classifies() && state->complex.form == ZeroForm::interpolated;
  const auto now = [&](std::size_t StateSnapshot::*member) {
    return judged ? std::optional((*state).*member) : std::nullopt;
  };
  const auto then = [&](std::size_t ViolationPreview::*member) {
    return next && judged ? std::optional((*next).*member) : std::nullopt;
  };
  violation_count(ui, "beyond 1 − α",
                  "Samples with ε above 1 − α at this step, and with these parameters. §2.3",
                  now(&StateSnapshot::beyond_margin), then(&ViolationPreview::beyond_margin), each);
  ImGui::SameLine(0, 0);
  violation_count(ui, "too flat", "Tetrahedra that carry Z and are less than 2σ/α high. §2.3, Figure 5",
                  now(&StateSnapshot::violating_2), then(&ViolationPreview::too_flat), each);
  ImGui::SameLine(0, 0);
  violation_count(ui, "misoriented",
                  "Tetrahedra whose shrunk copy misclassifies its nearest samples. §2.3, Figure 4",
                  judged && state->orientation_judged ? std::optional(state->violating_3) : std::nullopt,
                  then(&ViolationPreview::misoriented), each);
}

/// What Apply would do, in one line.
void plan_line(const Ui& ui, const ApplyPlan& plan) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton("plan", {width, ui.px(foot_line)});
  std::string more;
  for (const LiveChange& c : plan.changes)
    more += c.symbol + ": the run has " + c.was + ", the panel " + c.is + ". ";
  if (plan.error) more += plan.error->remedy;
  widgets::tip(ui, plan.words, more);
  const Rgb color = plan.way == ApplyWay::wrong                                       ? ui.colors.bad_text
                    : plan.way == ApplyWay::too_late || plan.way == ApplyWay::restart ? ui.colors.warning_text
                                                                                      : ui.colors.quiet;
  const widgets::Font font(ui.fonts.small);
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small, at, to_u32(color),
                     widgets::fitted(plan.words, width));
}

void plan_buttons(Ui& ui, const ApplyPlan& plan) {
  const WindowState& m = ui.window;
  const float between = ui.px(8), each = (ImGui::GetContentRegionAvail().x - 2 * between) / 3;
  const auto button = [&](const char* label, bool first, bool enabled, const char* command) {
    if (first && enabled ? widgets::primary_button(ui, label, true, each)
                         : widgets::plain_button(ui, label, enabled, each))
      ui.commands.post(command);
  };
  const bool right = plan.way != ApplyWay::wrong;
  if (plan.way == ApplyWay::too_late && plan.step_known) {
    button(("At step " + grouped(plan.step)).c_str(), true, true, "apply-earlier");
    widgets::tip(ui, "Branch where it matters",
                 plan.words +
                     " A branch goes on from there with these parameters; Tab changes to the run that "
                     "it left.");
  } else if (m.run.improving) {
    button("Stop", true, true, "stop");
    widgets::tip(ui, "Stop", "Ends the further rounds of the improver; the mesh that is there is certified.");
  } else if (m.can_go_on_improving() && plan.way == ApplyWay::nothing) {
    button("Improve", true, true, "go-on-improving");
    widgets::tip(ui, "Go on improving",
                 "Tries for ever fewer vertices, as further steps of this run, until it is stopped.");
  } else {
    const bool can = plan.way == ApplyWay::go_on || plan.way == ApplyWay::branch;
    button("Apply", true, can, "apply");
    widgets::tip(
        ui, "Apply   Ctrl+Enter",
        can ? "Goes on with these parameters from the step that is shown: at the run's end in the run "
              "itself, else in a branch. Tab changes to the run that it left, B shows both."
            : plan.words);
  }
  ImGui::SameLine(0, between);
  button("Restart", plan.way == ApplyWay::restart, right && !m.draft.input.empty(), "restart");
  widgets::tip(ui, "Restart   Ctrl+R",
               right ? "Runs again from the beginning with these parameters." : plan.words);
  ImGui::SameLine(0, between);
  button("Beside", false, right && m.run.scene != nullptr, "run-beside");
  widgets::tip(ui, "Run beside   Ctrl+Shift+Enter",
               "Runs the same input with these parameters beside this run; Compare tells what differs.");
}

} // namespace

float parameters_foot_height(const Ui& ui) {
  return ui.px(16) + 3 * ui.px(foot_row) + ui.px(foot_counts) + ui.px(foot_line) + ui.px(foot_buttons) +
         3 * ui.px(foot_gap);
}

void parameters_foot(Ui& ui, const Steering& steering) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(foot_gap)});
  const P used = used_parameters(ui.window);
  for (double P::*member : foot_sliders) parameter_slider_row(ui, field_of(member), used);
  violation_counts(ui);
  const ApplyPlan plan = steering.plan();
  plan_line(ui, plan);
  plan_buttons(ui, plan);
  ImGui::PopStyleVar();
}

} // namespace isoscope::panels
