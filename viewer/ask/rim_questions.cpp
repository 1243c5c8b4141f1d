// Questions about an open surface: asked when the selection or the state changes, commands that keep and fill
// holes, what scripts can expect.
#include "ask/investigation.h"

#include "command/commands.h"
#include "mesh/zero_curves.h"
#include "ui/icons.h"

#include <algorithm>
#include <string>

namespace isoscope {
namespace {

/// The parameter that fills the marked loops and no others.
std::string fill_text(const std::vector<std::uint8_t>& fills) {
  const auto filled = std::count(fills.begin(), fills.end(), 1);
  if (filled == 0) return "none";
  if (filled == std::ssize(fills)) return "all";
  std::string text;
  for (std::size_t i = 0; i < fills.size(); ++i)
    if (fills[i] != 0) text += (text.empty() ? "" : ",") + std::to_string(i + 1);
  return text;
}

Status choose_hole(Investigation& m, const Arguments& a) {
  const auto& report = m.rim_report();
  if (!report) return usage("The input has no border that Ω leaves open.");
  if (a.size() != 2) return wrong_arguments("Which hole, and keep or fill?");
  std::string& holes = m.window.draft.fill.holes;
  if (a[0] == "all") {
    if (a[1] != "keep" && a[1] != "fill" && a[1] != "flat")
      return wrong_arguments("All holes: keep, fill or flat?");
    holes = a[1] == "keep" ? "none" : a[1] == "fill" ? "all" : "flat";
    return {};
  }
  const auto number = whole_argument(a, 0, 1, report->loops.size());
  if (!number) return usage("There are only " + std::to_string(report->loops.size()) + " holes.");
  if (a[1] != "keep" && a[1] != "fill") return wrong_arguments("Keep or fill?");
  const HoleChoice choice = m.window.draft.fill.choice();
  std::vector<std::uint8_t> fills;
  for (std::uint32_t i = 0; i < report->loops.size(); ++i)
    fills.push_back(choice.wants(i, report->loops[i].loop) ? 1 : 0);
  fills[*number - 1] = a[1] == "fill" ? 1 : 0;
  holes = fill_text(fills);
  return {};
}

Status look_at_hole(Investigation& m, const Arguments& a) {
  const auto& report = m.rim_report();
  if (!report) return usage("The input has no border that Ω leaves open.");
  const bool bridged = !a.empty() && a[0] == "bridged";
  const std::size_t count = bridged ? report->bridged.size() : report->loops.size();
  const auto number = a.empty() ? std::optional<std::size_t>(1) : whole_argument(a, a.size() - 1, 1, count);
  if (!number) return usage("There are only " + std::to_string(count) + ".");
  const auto& pieces = bridged ? report->bridged[*number - 1].pieces : report->loops[*number - 1].pieces;
  Box3 box;
  for (const Segment3& s : pieces)
    for (const Vec3& end : s) box.add(end);
  m.window.selection.pick({});
  m.loop_shown = pieces;
  m.window.camera.frame(box.grown(m.window.run.scene->delta), !m.window.scripted);
  m.window.camera.mark_set();
  return {};
}

} // namespace

void Investigation::update_rim() {
  const Pick& picked = window.selection.picked;
  if (rim_scene_ != window.run.scene) loop_shown.clear();
  const auto state = window.state();
  std::optional<Vec3> place;
  if (state && state->samples && window.rim() != nullptr) {
    const BoundarySamples& s = *state->samples;
    if (picked.kind == Pick::Kind::sample && picked.id < s.size()) place = s.positions[picked.id];
    if (picked.kind == Pick::Kind::over_rim && picked.id < s.over_rim.size()) place = s.over_rim[picked.id];
  }
  if (rim_scene_ == window.run.scene && rim_place_ == place) return;
  rim_scene_ = window.run.scene;
  rim_place_ = place;
  beside_rim_ = place ? inspect_rim(*rim_scene_, *place) : std::nullopt;
}

const std::optional<RimReport>& Investigation::rim_report() {
  const auto state = window.state();
  if (state == reported_state_ && state) return rim_report_;
  reported_state_ = state;
  rim_report_ = state && window.run.scene ? report_rim(*state, *window.run.scene) : std::nullopt;
  return rim_report_;
}

void Investigation::add_rim_commands(CommandTable& table) {
  const auto has_rim = [this] { return window.rim() != nullptr; };
  table.add({{.name = "holes",
              .title = "Holes of the input",
              .help = "Lists the loops of an open input: length, flatness, whether each is kept, filled or "
                      "bridged.",
              .menu = "Ask",
              .icon = icon::hole,
              .run = does([this] { window.open_tab(BottomTab::loops); }),
              .enabled = has_rim}});
  table.add({{.name = "hole",
              .title = "Keep or fill a hole",
              .usage = "N keep | N fill | all keep | all fill | all flat",
              .help = "Sets which holes the next run fills; holes are numbered from 1 on.",
              .run = on(*this, choose_hole),
              .enabled = has_rim},
             {.name = "look-at-hole",
              .title = "Look at a hole",
              .usage = "[bridged] [N]",
              .help = "Moves the camera to a loop of the rim, or to a stretch of the border that Ω bridges, "
                      "and marks it.",
              .run = on(*this, look_at_hole),
              .enabled = has_rim}});
}

void Investigation::add_rim_values(NamedValues& t) {
  const auto sample = t.readings("rim.", [this] { return beside_rim_; });
  using X = RimInspection;
  const auto delta = [this] { return window.run.scene ? window.run.scene->delta : 1.0; };
  sample("over", "whether the closest point of the selected sample lies on the open rim", &X::over_rim);
  sample("distance", "from the selected sample to the open rim, in δ",
         [delta](const X& x) { return x.to_rim / delta(); });
  sample("on", "what of the input's border is nearest to it: edge or vertex; balls, where these found it",
         [](const X& x) { return !x.edge         ? "balls"
                                 : x.at_vertex() ? "vertex"
                                                 : "edge"; });
  sample("hole", "the number of the hole that it is nearest to", [](const X& x) { return x.loop + 1; });

  const auto report = t.readings(
      "holes", [this] { return rim_report(); }, "0");
  using R = RimReport;
  report("", "loops of the open rim of the input", [](const R& r) { return r.loops.size(); });
  report(".kept", "those along which the border of Z runs",
         [](const R& r) { return r.count(HoleState::kept); });
  report(".filled", "those that Z closes", [](const R& r) { return r.count(HoleState::filled); });
  report(".bridged", "stretches of its border that Ω bridges", [](const R& r) { return r.bridged.size(); });

  const auto state = [this] { return window.state(); };
  t.readings("samples.", state,
             "0")("over_rim", "boundary samples B, over the open rim",
                  [](const StateSnapshot& s) { return s.samples ? s.samples->over_rim.size() : 0; });
  const auto strata = t.readings("curves.", state, "0");
  strata("border", "edges of the border of Z",
         [](const StateSnapshot& s) { return zero_curves(s.zero_set).border.size(); });
  strata("triple", "edges of Z with three facets or more",
         [](const StateSnapshot& s) { return zero_curves(s.zero_set).triple.size(); });
  strata("points", "where such edges end, branch or cross",
         [](const StateSnapshot& s) { return zero_curves(s.zero_set).points.size(); });
  strata("dropped", "facets that were cut off Z along the rim",
         [](const StateSnapshot& s) { return dropped_facets(s.complex).size(); });
  t.add("rooms", "insides of Ω", [this] {
    const auto labels = window.side_labels();
    return std::count_if(labels.begin(), labels.end(), [](std::int8_t label) { return label < 0; });
  });
}

} // namespace isoscope
