// The study of tolerances: Ω shown at another δ, and a run with it; what scripts can expect of it.
#include "steering/steering.h"

#include "command/commands.h"
#include "model/tolerance_step.h"
#include "model/words.h"
#include "ui/icons.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// To so many digits that a run with it is the one that was looked at.
double rounded(double value) {
  constexpr int digits = 4;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - (digits - 1));
  return unit * std::round(value / unit);
}

Result<double> read_delta(const WindowState& m, const std::string& text) {
  const DeltaStudy& study = *m.run.scene->study;
  if (study.found()) {
    if (text == "least") return study.least;
    if (text == "proposed") return study.proposed;
    if (text == "most") return study.most;
  }
  const auto tolerance = Tolerance::read(text);
  if (!tolerance || tolerance->automatic)
    return wrong_value(text, "a length, a percentage, least, proposed, most or off");
  return tolerance->absolute(m.run.scene->longest_edge);
}

Status preview(WindowState& m, const std::string& text) {
  if (text == "off") {
    m.preview_delta.reset();
    return {};
  }
  const auto range = m.preview_range();
  if (!range) return usage("No other tolerances were studied: the input is a closed surface, or Ω is given.");
  const auto delta = read_delta(m, text);
  if (!delta) return delta.error();
  if (*delta < (*range)[0] || *delta > (*range)[1])
    return wrong_value(text, "between " + short_number((*range)[0]) + " and " + short_number((*range)[1]));
  m.preview_delta = *delta;
  return {};
}

Status take_delta(Steering& m, const Arguments&) {
  WindowState& w = m.window;
  w.draft.tolerance = {rounded(100 * *w.preview_delta / w.run.scene->longest_edge), true, false};
  w.preview_delta.reset();
  return m.restart();
}

} // namespace

void Steering::add_tolerance_commands(CommandTable& table) {
  add_group(table, {.menu = "Run"},
            {{.name = "tolerances",
              .title = "Which tolerance?",
              .help = "Shows what Ω consists of over δ; a slider shows Ω at any of them at once.",
              .icon = icon::sliders,
              .run = does([this] { window.open_tab(BottomTab::tolerance); }),
              .enabled = [this] { return window.run.scene && window.run.scene->study; }},
             {.name = "take-delta",
              .title = "Run with the tolerance shown",
              .help = "Runs again with the δ at which Ω is shown.",
              .icon = icon::check,
              .run = on(*this, take_delta),
              .enabled = [this] {
                return window.preview_delta && window.run.scene && !window.draft.input.empty();
              }}});
}

void Steering::add_tolerance_values(NamedValues& t) {
  t.add(
      "preview_delta", "δ at which Ω is shown: a length, a percentage, least, proposed, most or off",
      [this] { return window.preview_delta ? text_of(*window.preview_delta) : std::string("off"); },
      [this](const std::string& text) { return preview(window, text); });
  const auto scene = [this] { return window.run.scene; };
  t.readings("", scene, "nan")("delta", "δ of the run, a length", &Scene::delta);
  const auto points = t.readings(
      "points", [this] { return window.run.scene ? window.run.scene->points : nullptr; }, "0");
  points("", "points that φ is made of", [](const PointField& f) { return f.points->points.size(); });
  points(".dropped", "those of them that were dropped", &PointField::dropped_points);
  points(".k", "neighbours that each is averaged with", &PointField::neighbors);
  using S = DeltaStudy;
  const auto study = t.readings(
      "study.", [this] { return window.run.scene ? window.run.scene->study : nullptr; }, "nan");
  study("least", "δ below which the inside opens", &S::least);
  study("most", "δ beyond which an inside is closed up", &S::most);
  study("proposed", "the δ that the study proposes", &S::proposed);
  const auto shown = t.readings(
      "study.",
      [this]() -> const S::Step* {
        const auto& now = window.run.scene;
        return now && now->study ? step_at(*now->study, window.preview_delta.value_or(now->delta)) : nullptr;
      },
      "nan");
  shown("components", "components of Ω at the δ shown", &S::Step::components);
  shown("regions", "regions around it", &S::Step::regions);
  shown("deep", "those that are deep and bounded", &S::Step::deep);
}

} // namespace isoscope
