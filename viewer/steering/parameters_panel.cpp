// The parameters that belong to a whole run, and the conditions; α, σ, shrink and the buttons are in the
// foot.
#include "steering/parameter_rows.h"
#include "steering/steering.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <span>
#include <type_traits>
#include <vector>

namespace isoscope::panels {
namespace {

using P = RunParameters;

/// Where groups of rows begin, by FieldFacts::place; those before the first are in the foot.
constexpr int first_number = 4, first_word = 11, first_condition = 31;

/// A number that is typed, with its unit behind it; what the field cannot be is told once it is there.
/// `takes`: what the value can hold at all. True when changed.
template <class Takes> bool typed(const FieldFacts& f, double& value, const char* format, Takes&& takes) {
  double wanted = value;
  const std::string with_unit = format + std::string(f.unit);
  if (!ImGui::InputDouble(unlabelled(f).c_str(), &wanted, 0, 0, with_unit.c_str()) || !takes(wanted))
    return false;
  value = wanted;
  return true;
}

/// What whole numbers of every kind hold.
bool fits_whole(double value) {
  constexpr double most = 1e9;
  return std::abs(value) < most;
}

void control(Ui& ui, P& p, const Field<P, double>& f) {
  ImGui::SetNextItemWidth(-1);
  const widgets::Font font(ui.fonts.mono);
  typed(f, p.*(f.member), "%.6g", [](double v) { return std::isfinite(v); });
  widgets::tip(ui, f.title, f.tip);
}

/// Percent, length, automatic in turn; the value stays what it is.
void next_unit(const Scene* scene, Tolerance& tolerance) {
  const double edge = scene ? scene->longest_edge : 0;
  if (tolerance.automatic) {
    const double delta = scene ? scene->delta : 0;
    tolerance = delta > 0 ? Tolerance{std::round(1e4 * 100 * delta / edge) / 1e4} : Tolerance{};
  } else if (tolerance.percent) {
    if (edge > 0) tolerance.value = tolerance.absolute(edge);
    tolerance.percent = false;
  } else {
    tolerance.automatic = true;
  }
}

void control(Ui& ui, P& p, const Field<P, Tolerance>& f) {
  Tolerance& tolerance = p.*(f.member);
  const auto& scene = ui.window.run.scene;
  // What is shown may be another input than the draft's.
  const bool same = scene && ui.window.run.parameters.input == p.input;
  if (same && scene->input && scene->input->gives_volume()) {
    ImGui::AlignTextToFramePadding();
    return widgets::quiet_text(ui, short_number(scene->delta) + ", given with Ω");
  }
  const float unit = ui.px(52);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - unit - ui.px(6));
  ImGui::PushFont(ui.fonts.mono);
  if (tolerance.automatic) {
    double found = same ? scene->delta : 0;
    ImGui::BeginDisabled();
    ImGui::InputDouble(unlabelled(f).c_str(), &found, 0, 0, same ? "%.6g" : "found");
    ImGui::EndDisabled();
  } else {
    typed(f, tolerance.value, "%.6g", [](double v) { return std::isfinite(v); });
  }
  ImGui::PopFont();
  widgets::tip(ui, f.title, f.tip);
  ImGui::SameLine(0, ui.px(6));
  const char* label = tolerance.automatic ? "auto##unit" : tolerance.percent ? "%##unit" : "abs##unit";
  if (widgets::plain_button(ui, label, true, unit, ImGui::GetFrameHeight()))
    next_unit(scene.get(), tolerance);
  widgets::tip(ui, "Unit of δ",
               "Percent of the longest edge, a length in the input's units, or auto: found from the input.");
  const double edge = same ? scene->longest_edge : 0;
  if (edge <= 0) return;
  // The same the other way round.
  const double delta = tolerance.automatic ? scene->delta : tolerance.absolute(edge);
  const std::string also = tolerance.percent && !tolerance.automatic
                               ? "= " + short_number(delta)
                               : "= " + short_number(100 * delta / edge) + " %";
  const widgets::Font small(ui.fonts.small);
  widgets::quiet_text(ui, also + ", longest edge " + short_number(edge));
}

/// A number, or the word for none: off, or found by the run. `kind` is the type that has these two as values.
template <class Kind, class T, class Fits>
void number_or_word(Ui& ui, const Field<P, Kind>& f, T& value, const char* letter, const char* format,
                    T usual, Fits&& fits) {
  const std::array<const char*, 3> kinds{"auto", "off", letter};
  int chosen = value == Kind::automatic ? 0 : value == Kind::off ? 1 : 2;
  if (chosen == 2) {
    auto typed_value = static_cast<double>(value);
    ImGui::SetNextItemWidth(ui.px(46));
    if (typed(f, typed_value, format, fits))
      value = static_cast<T>(std::is_integral_v<T> ? std::round(typed_value) : typed_value);
    ImGui::SameLine(0, ui.px(6));
  }
  if (!widgets::segmented(ui, f.name.data(), kinds, chosen)) return;
  value = chosen == 0 ? Kind::automatic : chosen == 1 ? Kind::off : usual;
}

void control(Ui& ui, P& p, const Field<P, Robust>& f) {
  // 0 and 1 stand for the two words.
  number_or_word(ui, f, (p.*(f.member)).neighbors, "k", "%.0f", 12,
                 [](double v) { return fits_whole(v) && (v < 0 || v >= 2); });
}

void control(Ui& ui, P& p, const Field<P, BallTestFactor>& f) {
  number_or_word(ui, f, (p.*(f.member)).gamma, "γ", "%.2g", BallTestFactor::usual.front(),
                 [](double) { return true; });
}

void control(Ui& ui, P& p, const Field<P, Levels>& f) {
  Levels& levels = p.*(f.member);
  const float each = (ImGui::GetContentRegionAvail().x - ui.px(6)) / 2;
  const auto number = [&](const char* id, double& value) {
    ImGui::SetNextItemWidth(each);
    double wanted = value;
    if (ImGui::InputDouble(id, &wanted, 0, 0, "%.6g") && std::isfinite(wanted)) value = wanted;
    widgets::tip(ui, f.title, f.tip);
  };
  ImGui::PushFont(ui.fonts.mono);
  number("##low", levels.low);
  ImGui::SameLine(0, ui.px(6));
  number("##high", levels.high);
  ImGui::PopFont();
}

/// None, all, flat, or numbers of loops.
void control(Ui& ui, P& p, const Field<P, Fill>& f) {
  Fill& fill = p.*(f.member);
  std::array<char, 64> typed{};
  std::snprintf(typed.data(), typed.size(), "%s", fill.holes.c_str());
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##fill", typed.data(), typed.size())) fill.holes = typed.data();
  widgets::tip(ui, f.title, f.tip);
}

void control(Ui& ui, P& p, const Field<P, std::optional<int>>& f) {
  std::optional<int>& value = p.*(f.member);
  constexpr std::array<const char*, 2> kinds{"label", "none"};
  int chosen = value ? 0 : 1;
  if (value) {
    double wanted = *value;
    ImGui::SetNextItemWidth(ui.px(64));
    if (typed(f, wanted, "%.0f", fits_whole)) value = static_cast<int>(std::round(wanted));
    widgets::tip(ui, f.title, f.tip);
    ImGui::SameLine(0, ui.px(6));
  }
  if (!widgets::segmented(ui, f.name.data(), kinds, chosen)) return;
  if (chosen == 1)
    value.reset();
  else
    value = 1;
}

/// Whether a field says something of the input: levels and labels are of grids, the robust distance of what
/// is no volume.
bool speaks_of(const FieldFacts& f, const WindowState& m) {
  const RunParameters& p = m.draft;
  const bool known = m.run.scene && m.run.scene->input && m.run.parameters.input == p.input;
  // One that could not be read, as its levels are missing, goes by its name.
  const bool grid = known ? m.run.scene->input->grid != nullptr
                          : p.levels.given() || p.label || p.input.ends_with(".nrrd") ||
                                p.input.ends_with(".nhdr") || p.input.ends_with(".grid");
  const bool given = grid || !p.inside.empty() || (known && m.run.scene->input->gives_volume());
  const auto is = [&](auto member) { return f.name == field_of(member).name; };
  if (is(&P::levels) || is(&P::label)) return grid;
  if (is(&P::robust) || is(&P::drop_small) || is(&P::drop_thin)) return !given;
  if (is(&P::sides) && grid) return true; // all labels, not one
  if (is(&P::cover) || is(&P::sides)) return !given && (!known || m.run.scene->field->surface() != nullptr);
  return true;
}

void control(Ui& ui, P& p, const Field<P, std::optional<double>>& f) {
  std::optional<double>& value = p.*(f.member);
  constexpr std::array<const char*, 2> kinds{"within", "off"};
  int chosen = value ? 0 : 1;
  if (value) {
    ImGui::SetNextItemWidth(ui.px(64));
    typed(f, *value, "%.4g", [](double v) { return std::isfinite(v); });
    widgets::tip(ui, f.title, f.tip);
    ImGui::SameLine(0, ui.px(6));
  }
  if (!widgets::segmented(ui, f.name.data(), kinds, chosen)) return;
  if (chosen == 1)
    value.reset();
  else
    value = P().*(f.member);
}

/// One of the field's words: side by side where they fit, else in a list.
bool word(const Ui& ui, const FieldFacts& f, int& chosen) {
  constexpr std::size_t letters_beside = 24;
  static constexpr std::array<Choice, 2> switched{{{"off"}, {"on"}}};
  std::vector<const char*> shown;
  std::size_t letters = 0;
  for (const Choice& c : f.choices.empty() ? std::span<const Choice>(switched) : f.choices) {
    shown.push_back((c.shown.empty() ? c.name : c.shown).data());
    letters += std::string_view(shown.back()).size();
  }
  if (letters <= letters_beside) return widgets::segmented(ui, f.name.data(), shown, chosen);
  bool changed = false;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo(unlabelled(f).c_str(), shown[static_cast<std::size_t>(chosen)])) {
    for (std::size_t i = 0; i < shown.size(); ++i)
      if (f.choices[i].offered && ImGui::Selectable(shown[i], static_cast<int>(i) == chosen)) {
        chosen = static_cast<int>(i);
        changed = true;
      }
    ImGui::EndCombo();
  }
  return changed;
}

/// Switches, numbers with words and enumerations; a number without words is typed.
template <class T> void control(Ui& ui, P& p, const Field<P, T>& f) {
  if constexpr (FieldNumber<T>)
    if (f.choices.empty()) {
      auto value = static_cast<double>(p.*(f.member));
      ImGui::SetNextItemWidth(-1);
      if (typed(f, value, "%.0f", fits_whole)) p.*(f.member) = static_cast<T>(std::round(value));
      return;
    }
  int chosen = static_cast<int>(p.*(f.member));
  if (word(ui, f, chosen)) p.*(f.member) = static_cast<T>(chosen);
}
template <class T> void control(Ui& ui, P& p, const Field<P, std::optional<T>>& f) {
  int chosen = static_cast<int>(*f.value(p));
  if (word(ui, f, chosen)) p.*(f.member) = static_cast<T>(chosen);
}

/// A chip of a stage that can be left out.
void skip_chip(const Ui& ui, Stage stage, bool& skipped, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float high = ui.px(24);
  ImGui::PushID(static_cast<int>(stage));
  if (ImGui::InvisibleButton("skip", {width, high})) skipped = !skipped;
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high},
                     skipped ? to_u32(ui.colors.panel) : to_u32(stage_color(ui.theme, stage), 0.25f),
                     ui.px(5));
  list.AddRect(at, {at.x + width, at.y + high}, to_u32(ui.colors.line), ui.px(5));
  const std::string_view label = words(stage).title;
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 extent = widgets::text_size(label);
  ImGui::PopFont();
  const ImVec2 text{at.x + (width - extent.x) / 2, at.y + (high - extent.y) / 2};
  widgets::draw_text(list, ui.fonts.small, text, to_u32(skipped ? ui.colors.quiet : ui.colors.text), label);
  if (skipped)
    list.AddLine({text.x - ui.px(2), at.y + high / 2}, {text.x + extent.x + ui.px(2), at.y + high / 2},
                 to_u32(ui.colors.quiet), ui.px(1.2f));
  widgets::tip(ui, "Stage: " + std::string(words(stage).title),
               std::string(words(stage).help) + " Click to leave it out or to take it in; needs a restart.");
}

void control(Ui& ui, P& p, const Field<P, std::array<bool, stage_count>>& f) {
  std::vector<Stage> optional;
  for (std::size_t i = 0; i < f.choices.size(); ++i)
    if (f.choices[i].offered) optional.push_back(static_cast<Stage>(i));
  const float gap = ui.px(4);
  // As wide as their titles and the same room around each.
  std::vector<float> widths(optional.size());
  float room = ImGui::GetContentRegionAvail().x - gap * static_cast<float>(optional.size() - 1);
  ImGui::PushFont(ui.fonts.small);
  for (std::size_t i = 0; i < optional.size(); ++i) {
    widths[i] = widgets::text_size(words(optional[i]).title).x;
    room -= widths[i];
  }
  ImGui::PopFont();
  for (std::size_t i = 0; i < optional.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    skip_chip(ui, optional[i], (p.*(f.member)).at(static_cast<std::size_t>(optional[i])),
              widths[i] + room / static_cast<float>(optional.size()));
  }
}

void conditions(Ui& ui, P& p, const P& used) {
  const auto& f = field_of(&P::conditions);
  for (std::size_t i = 0; i < p.conditions.size(); ++i) {
    const Choice& row = f.choices[i];
    ImGui::PushID(row.name.data());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    widgets::toggle(ui, "on", p.conditions[i]);
    const bool differs = p.conditions[i] != used.conditions[i];
    widgets::tip(ui, std::string(f.title) + std::string(row.shown),
                 std::string(row.tip) + " It matters until " +
                     (row.until == "refinement" ? "the refinement ends." : "the improver begins.") +
                     (!differs             ? ""
                      : used.conditions[i] ? " In the run it is on."
                                           : " In the run it is off."));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (differs)
      list.AddCircleFilled({at.x - ui.px(7), at.y + ui.px(10)}, ui.px(2.5f), to_u32(ui.colors.accent), 12);
    list.AddCircleFilled({at.x + ui.px(43), at.y + ui.px(10)}, ui.px(4),
                         to_u32(condition_color(ui.theme, static_cast<int>(i) + 1)), 16);
    widgets::draw_text(list, ui.fonts.small,
                       {at.x + ui.px(54), at.y + ui.px(10) - ui.fonts.small->FontSize / 2},
                       to_u32(ui.colors.text), row.shown);
    ImGui::PopID();
  }
}

/// The two files where Ω lies between surfaces.
void walls(const Ui& ui, const P& p) {
  if (p.inside.empty()) return;
  widgets::value_row(ui, "outer surface", std::filesystem::path(p.input).filename().string());
  widgets::value_row(ui, "inner surface", std::filesystem::path(p.inside).filename().string());
}

/// The rows of places from `first` up to `end`, each `units` high.
void rows(Ui& ui, P& p, const P& used, int first, int end, float units) {
  for (int place = first; place < end; ++place)
    for_each_field<P>([&]<class T>(const Field<P, T>& f) {
      if constexpr (!std::is_same_v<T, std::string> && !std::is_same_v<T, std::array<bool, 4>>) {
        if (f.place != place || !speaks_of(f, ui.window)) return;
        const FieldState state = field_state(f, p, used);
        parameter_label(ui, f, state, units);
        ImGui::BeginGroup();
        control(ui, p, f);
        ImGui::EndGroup();
        parameter_verdict(ui, state);
      }
    });
}

/// What S takes at the σ of the sliders.
void foreseen(const Ui& ui) {
  const auto& scene = ui.window.run.scene;
  if (!scene || !(scene->sample_estimate.boundary_area > 0)) return;
  const RunParameters& draft = ui.window.draft;
  const double sigma = draft.sigma_ratio(scene->default_sigma) * scene->delta;
  const double bytes = scene->sample_estimate.bytes(sigma);
  char words[64];
  std::snprintf(words, sizeof words, "about %.2g, %.3g MB", scene->sample_estimate.samples(sigma),
                bytes / 1e6);
  const bool fits = bytes <= draft.most_bytes();
  widgets::value_row(ui, "samples at this σ", words, fits ? ui.colors.text : ui.colors.bad_text);
}

void warnings(const Ui& ui) {
  if (!ui.window.run.scene) return;
  for (const ParameterWarning& warning : ui.window.run.scene->warnings) {
    const widgets::Font font(ui.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.warning_text));
    widgets::wrapped_text(std::string(icon::warning) + "  " + warning.message);
    ImGui::PopStyleColor();
  }
}

} // namespace

std::string unlabelled(const FieldFacts& f) {
  return "##" + std::string(f.name);
}

void parameter_label(const Ui& ui, const FieldFacts& f, const FieldState& state, float units) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float high = ui.px(units), width = ui.px(92);
  ImGui::PushID(f.title.data());
  ImGui::InvisibleButton("label", {width, high});
  ImGui::PopID();
  std::string tip(f.tip);
  if (state.differs) tip += " The run has " + state.used + ".";
  widgets::tip(ui, f.title, tip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool right = state.error.empty();
  widgets::draw_text(list, ui.fonts.small, {at.x, at.y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(!right          ? ui.colors.bad_text
                            : state.differs ? ui.colors.text
                                            : ui.colors.quiet),
                     f.label.empty() ? f.symbol : f.label);
  if (state.differs)
    list.AddCircleFilled({at.x - ui.px(7), at.y + high / 2}, ui.px(2.5f),
                         to_u32(right ? ui.colors.accent : ui.colors.bad), 12);
  ImGui::SameLine(0, 0);
}

void wrong_value_frame(const Ui& ui) {
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), to_u32(ui.colors.bad),
                                      ui.px(4), 0, ui.px(1.5f));
}

void parameter_verdict(const Ui& ui, const FieldState& state) {
  if (state.error.empty()) return;
  wrong_value_frame(ui);
  const widgets::Font font(ui.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.bad_text));
  widgets::wrapped_text(state.error);
  ImGui::PopStyleColor();
}

void parameters(Ui& ui) {
  if (!widgets::section(ui, "Parameters")) return;
  RunParameters& p = ui.window.draft;
  const P used = used_parameters(ui.window);
  walls(ui, p);
  rows(ui, p, used, first_number, first_word, 22);
  ImGui::Dummy({0, ui.px(2)});
  ImGui::PushFont(ui.fonts.small);
  rows(ui, p, used, first_word, first_condition, 26);
  ImGui::PopFont();
  ImGui::Dummy({0, ui.px(2)});
  conditions(ui, p, used);
  ImGui::Dummy({0, ui.px(2)});
  foreseen(ui);
  warnings(ui);
  ImGui::Dummy({0, ui.px(6)});
}

} // namespace isoscope::panels
