// Parameters with a live preview of what would violate them now; applied to the run, or for a new one.
#include "steering/parameters_panel.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace isoscope::panels {
namespace {

/// A label with a tooltip on the left, the control on the right of it.
void label(const Ui& ui, const char* symbol, const char* tip_title, const char* tip, float units = 22) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float high = ui.px(units), width = ui.px(92);
  ImGui::PushID(tip_title);
  ImGui::InvisibleButton("label", {width, high});
  ImGui::PopID();
  widgets::tip(ui, tip_title, tip);
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                     {at.x, at.y + (high - ui.fonts.small->FontSize) / 2}, to_u32(ui.colors.quiet), symbol);
  ImGui::SameLine(0, 0);
}

void number(const Ui& ui, const char* id, double& value, float low, float high, const char* format,
            bool logarithmic = false) {
  auto shown = static_cast<float>(value);
  if (widgets::slider(ui, id, shown, low, high, format, logarithmic))
    value = std::round(static_cast<double>(shown) * 1e4) / 1e4;
}

void tolerance(Ui& ui, RunParameters& p) {
  constexpr const char* tip =
      "δ, half the thickness of Ω. In percent of the longest edge of the input's bounding box, or as a "
      "length of the input's units. Range: above 0. A change needs a restart. §2.1";
  label(ui, "δ tolerance", "Tolerance δ", tip);
  const float unit = ui.px(52);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - unit - ui.px(6));
  ImGui::PushFont(ui.fonts.mono);
  double value = p.tolerance.value;
  if (ImGui::InputDouble("##delta", &value, 0, 0, "%.6g") && std::isfinite(value) && value > 0)
    p.tolerance.value = value;
  ImGui::PopFont();
  widgets::tip(ui, "Tolerance δ", tip);
  ImGui::SameLine(0, ui.px(6));
  if (widgets::plain_button(ui, p.tolerance.percent ? "%##unit" : "abs##unit", true, unit,
                            ImGui::GetFrameHeight())) {
    const double edge = ui.window.run.scene ? ui.window.run.scene->longest_edge : 0;
    if (edge > 0)
      p.tolerance.value = p.tolerance.percent ? p.tolerance.absolute(edge) : 100 * p.tolerance.value / edge;
    p.tolerance.percent = !p.tolerance.percent;
  }
  widgets::tip(ui, "Unit of δ", "Percent of the longest edge, or a length in the input's units.");
}

void small_parts(Ui& ui, RunParameters& p) {
  constexpr const char* tip = "Connected components of the input whose bounding box is smaller than so many "
                              "δ are left out; 0 leaves out "
                              "none. Needs a restart.";
  label(ui, "drop small", "Small parts of the input", tip);
  ImGui::SetNextItemWidth(-1);
  ImGui::PushFont(ui.fonts.mono);
  double value = p.drop_small;
  if (ImGui::InputDouble("##drop-small", &value, 0, 0, "%.6g") && std::isfinite(value) && value >= 0 &&
      value <= 1e6)
    p.drop_small = value;
  ImGui::PopFont();
  widgets::tip(ui, "Small parts of the input", tip);
}

void cover(Ui& ui, RunParameters& p) {
  constexpr const char* tip =
      "How far from the finished mesh a point of the input may be, in δ. Off: as far as it likes, as in the "
      "paper. Needs a restart.";
  label(ui, "cover", "Cover", tip, 26);
  constexpr std::array<const char*, 2> kinds{"within", "off"};
  int chosen = p.cover ? 0 : 1;
  const float field = ui.px(64);
  if (p.cover) {
    ImGui::SetNextItemWidth(field);
    double value = *p.cover;
    if (ImGui::InputDouble("##cover", &value, 0, 0, "%.4g") && std::isfinite(value) && value > 0)
      p.cover = value;
    widgets::tip(ui, "Cover", tip);
    ImGui::SameLine(0, ui.px(6));
  }
  if (widgets::segmented(ui, "cover", kinds, chosen)) {
    if (chosen == 1)
      p.cover.reset();
    else if (!p.cover)
      p.cover = RunParameters().cover;
  }
}

void conditions(Ui& ui, RunParameters& p) {
  struct Row {
    const char* name;
    const char* tip;
    bool RunParameters::*member;
    Condition condition;
  };
  constexpr std::array<Row, 4> rows{{
      {"1  classification", "ε(s) ≤ 1 − α for every sample s: f classifies S with a margin. §2.3",
       &RunParameters::condition_1, Condition::classification},
      {"2  height", "Every tetrahedron that carries Z is at least 2σ/α high. §2.3, Figure 5",
       &RunParameters::condition_2, Condition::height},
      {"3  orientation",
       "The shrunk copy of a tetrahedron that carries Z classifies its nearest samples. §2.3, Figure 4",
       &RunParameters::condition_3, Condition::orientation},
      {"4  topology", "Z has the components and the genus that are expected. §2.3",
       &RunParameters::condition_4, Condition::topology},
  }};
  for (const Row& row : rows) {
    ImGui::PushID(row.name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    widgets::toggle(ui, "on", p.*(row.member));
    widgets::tip(ui, "Condition " + std::string(row.name), row.tip);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled({at.x + ui.px(43), at.y + ui.px(10)}, ui.px(4),
                         to_u32(condition_color(ui.theme, static_cast<int>(row.condition))), 16);
    widgets::draw_text(list, ui.fonts.small,
                       {at.x + ui.px(54), at.y + ui.px(10) - ui.fonts.small->FontSize / 2},
                       to_u32(ui.colors.text), row.name);
    ImGui::PopID();
  }
}

/// A choice that opens as a list.
template <class Visit> void choice(const char* id, std::string_view shown, Visit&& entries) {
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo(id, std::string(shown).c_str())) {
    entries();
    ImGui::EndCombo();
  }
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
  const std::string_view label = stage_title(stage);
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 extent = widgets::text_size(label);
  ImGui::PopFont();
  const ImVec2 text{at.x + (width - extent.x) / 2, at.y + (high - extent.y) / 2};
  widgets::draw_text(list, ui.fonts.small, text, to_u32(skipped ? ui.colors.quiet : ui.colors.text), label);
  if (skipped)
    list.AddLine({text.x - ui.px(2), at.y + high / 2}, {text.x + extent.x + ui.px(2), at.y + high / 2},
                 to_u32(ui.colors.quiet), ui.px(1.2f));
  widgets::tip(ui, "Stage: " + std::string(stage_title(stage)),
               std::string(stage_help(stage)) + " Click to leave it out or to take it in; needs a restart.");
}

void stages(Ui& ui, RunParameters& p) {
  label(ui, "until", "The last stage",
        "Where the run ends: a valid mesh is there after every stage. Needs a restart.", 26);
  choice("##until", stage_title(p.last_stage()), [&] {
    for (int i = static_cast<int>(Stage::refinement); i < stage_count; ++i) {
      const auto stage = static_cast<Stage>(i);
      if (ImGui::Selectable(std::string(stage_title(stage)).c_str(), stage == p.last_stage()))
        p.until = stage;
    }
  });
  label(ui, "stages", "Stages", "Those struck through are left out. Needs a restart.", 26);
  constexpr std::array<Stage, 4> optional{Stage::gamma, Stage::zero_set, Stage::all, Stage::improve};
  const float gap = ui.px(4);
  // As wide as their titles and the same room around each.
  std::array<float, optional.size()> widths{};
  float room = ImGui::GetContentRegionAvail().x - gap * static_cast<float>(optional.size() - 1);
  ImGui::PushFont(ui.fonts.small);
  for (std::size_t i = 0; i < optional.size(); ++i) {
    widths[i] = widgets::text_size(stage_title(optional[i])).x;
    room -= widths[i];
  }
  ImGui::PopFont();
  for (std::size_t i = 0; i < optional.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    skip_chip(ui, optional[i], p.skipped.at(static_cast<std::size_t>(optional[i])),
              widths[i] + room / static_cast<float>(optional.size()));
  }
  label(ui, "target", "Target strategy",
        "How the target of a collapse is looked for in its kernel: the least error alone, again under learnt "
        "half-spaces, also by points drawn in the kernel, or by the paper's octree with invalid regions Ψ. "
        "Needs a restart. §2.4, Figures 9 and 12",
        26);
  constexpr std::array<TargetStrategy, 4> strategies{TargetStrategy::optimum, TargetStrategy::constraints,
                                                     TargetStrategy::sampling, TargetStrategy::octree};
  choice("##target", name(p.target), [&] {
    for (const TargetStrategy s : strategies)
      if (ImGui::Selectable(std::string(name(s)).c_str(), s == p.target)) p.target = s;
  });
  constexpr std::array<const char*, 2> rings{"1-ring", "2-ring"};
  constexpr std::array<const char*, 4> efforts{"0", "1", "2", "3"};
  int ring = static_cast<int>(p.cost_ring), effort = p.effort;
  label(ui, "error over", "Ring of the error",
        "Facets of Z whose planes make the error of a collapse; the paper takes two rings. Needs a restart. "
        "§2.4",
        26);
  if (widgets::segmented(ui, "ring", rings, ring)) p.cost_ring = static_cast<CostRing>(ring);
  label(ui, "effort", "Effort of the improver",
        "0 to 3: more rounds of relocation and repair for fewer vertices. Needs a restart.", 26);
  if (widgets::segmented(ui, "effort", efforts, effort)) p.effort = effort;
  constexpr std::array<const char*, 2> places{"Z alone", "inside T"};
  int place = static_cast<int>(p.improver);
  label(ui, "improver", "Where the improver works",
        "On Z alone it gets by with fewer vertices; inside T every step keeps the embedding, which is the "
        "proof "
        "where Ω is no thickening. Needs a restart.",
        26);
  if (widgets::segmented(ui, "improver", places, place)) p.improver = static_cast<ImproverPlace>(place);
}

void preview_line(const Ui& ui, const char* name, std::size_t now, std::size_t then, bool known) {
  std::string value = grouped(now);
  if (known) value += "  →  " + grouped(then);
  const Rgb color = !known || then == now ? ui.colors.text
                    : then > now          ? ui.colors.bad_text
                                          : ui.colors.good_text;
  widgets::value_row(ui, name, value, color);
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

void preview(Ui& ui, const Steering& steering) {
  const WindowState& m = ui.window;
  const auto state = m.state();
  if (!state || state->complex.form == ZeroForm::free) return;
  const bool differs = steering.draft_differs();
  const auto next = steering.draft_preview();
  const bool known = differs && next.has_value();
  const ViolationPreview then = known ? *next : ViolationPreview{};
  widgets::quiet_text(ui, differs ? "Would violate at this step" : "Violate at this step");
  preview_line(ui, "samples beyond 1 − α", state->beyond_margin, then.beyond_margin, known);
  preview_line(ui, "tetrahedra too flat", state->violating_2, then.too_flat, known);
  preview_line(ui, "tetrahedra misoriented", state->violating_3, then.misoriented, known);
}

void warnings(const Ui& ui) {
  if (!ui.window.run.scene) return;
  for (const ParameterWarning& warning : ui.window.run.scene->warnings) {
    ImGui::PushFont(ui.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.warning_text));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted((std::string(icon::warning) + "  " + warning.message).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
  }
}

void buttons(Ui& ui, const Steering& steering) {
  const WindowState& m = ui.window;
  const bool differs = steering.draft_differs(), restart_only = steering.draft_needs_restart();
  const float each = (ImGui::GetContentRegionAvail().x - 2 * ui.px(8)) / 3;
  const bool can_apply = m.run.journal != nullptr && differs && !restart_only;
  if (can_apply ? widgets::primary_button(ui, "Apply", true, each)
                : widgets::plain_button(ui, "Apply", false, each))
    ui.commands.post("apply");
  widgets::tip(ui, "Apply   Ctrl+Enter",
               restart_only ? "δ, the modes and the stages belong to the whole run: they need a restart."
                            : "Goes on with these parameters from the present state of the run.");
  ImGui::SameLine(0, ui.px(8));
  const bool restart = !m.draft.input.empty();
  if (differs && restart_only ? widgets::primary_button(ui, "Restart", restart, each)
                              : widgets::plain_button(ui, "Restart", restart, each))
    ui.commands.post("restart");
  widgets::tip(ui, "Restart   Ctrl+R", "Runs again from the beginning with these parameters.");
  ImGui::SameLine(0, ui.px(8));
  if (widgets::plain_button(ui, "Beside", m.run.scene != nullptr, each)) ui.commands.post("run-beside");
  widgets::tip(ui, "Run beside   Ctrl+Shift+Enter",
               "Runs the same input with these parameters beside this run; Compare tells what differs.");
}

} // namespace

void parameters(Ui& ui, const Steering& steering) {
  if (!widgets::section(ui, "Parameters")) return;
  RunParameters& p = ui.window.draft;
  label(ui, "α margin", "Margin α",
        "How far f must be on the right side at every sample: ε(s) ≤ 1 − α. No unit, in (0, 1). Larger is "
        "safer and asks for more Steiner points. §2.3");
  number(ui, "##alpha", p.alpha, 0.02f, 0.95f, "%.2f");
  widgets::tip(ui, "Margin α", "No unit, in (0, 1); 0.2 in the paper. §2.3");
  label(ui, "σ/δ density", "Sampling density σ",
        "Radius within which every point of ∂Ω has a sample, as a fraction of δ, in (0, 1]. Smaller means "
        "more samples. §2.2");
  const double by_default = ui.window.run.scene ? ui.window.run.scene->default_sigma : 0.5;
  double sigma = p.sigma_ratio(by_default);
  number(ui, "##sigma", sigma, 0.05f, 1.0f, "%.3f", true);
  if (sigma != p.sigma_ratio(by_default)) p.sigma = sigma;
  widgets::tip(ui, "Sampling density σ/δ", "Fraction of δ, in (0, 1]. §2.2");
  label(ui, "shrink", "Shrink factor",
        "Size of the shrunk copy about its centroid by which condition 3 judges a tetrahedron, in (0, 1]. "
        "§2.3, Figure 4");
  number(ui, "##shrink", p.shrink, 0.05f, 1.0f, "%.2f");
  widgets::tip(ui, "Shrink factor of condition 3", "No unit, in (0, 1]; 0.7 in the paper. §2.3");
  tolerance(ui, p);
  small_parts(ui, p);
  ImGui::Dummy({0, ui.px(2)});
  ImGui::PushFont(ui.fonts.small);
  constexpr std::array<const char*, 2> containment{"certified", "sampled"}, topology{"keep", "separate"};
  int chosen = static_cast<int>(p.containment);
  label(ui, "containment", "Containment of Z in Ω",
        "Certified: every facet of Z is proven inside Ω; a coarse S suffices. Sampled: the paper to the "
        "letter, dense S and condition 2. Needs a restart.",
        26);
  if (widgets::segmented(ui, "containment", containment, chosen))
    p.containment = static_cast<Containment>(chosen);
  chosen = static_cast<int>(p.topology);
  label(ui, "topology", "Topology mode",
        "What is asked of Z where Ω is no thickening of a surface: keep the input's topology, or only "
        "separate the two sides. Needs a restart. §1.2",
        26);
  if (widgets::segmented(ui, "topology", topology, chosen)) p.topology = static_cast<TopologyMode>(chosen);
  constexpr std::array<const char*, 2> thin{"refuse", "leave out"};
  chosen = p.drop_thin ? 1 : 0;
  label(ui, "thin parts", "Parts thinner than 2δ",
        "Of a part that is thinner than 2δ everywhere Ω leaves no inside that Z could enclose: the input is "
        "refused, or the part is left out and named. Needs a restart.",
        26);
  if (widgets::segmented(ui, "thin", thin, chosen)) p.drop_thin = chosen == 1;
  cover(ui, p);
  chosen = static_cast<int>(p.sides);
  label(ui, "sides", "What tells inside from outside",
        "Auto: parity where closed parts do not meet, and the winding number where they overlap or touch, so "
        "that what lies in several parts is inside. Needs a restart.",
        26);
  constexpr std::array<const char*, 3> sides{"auto", "winding", "parity"};
  if (widgets::segmented(ui, "sides", sides, chosen)) p.sides = static_cast<SidesMode>(chosen);
  stages(ui, p);
  ImGui::PopFont();
  ImGui::Dummy({0, ui.px(2)});
  conditions(ui, p);
  ImGui::Dummy({0, ui.px(2)});
  foreseen(ui);
  preview(ui, steering);
  warnings(ui);
  ImGui::Dummy({0, ui.px(2)});
  buttons(ui, steering);
  ImGui::Dummy({0, ui.px(6)});
}

} // namespace isoscope::panels
