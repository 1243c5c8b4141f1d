// From the narrowest condition to the widest.

#include "base/numbers.h"
#include "debug/debugger.h"
#include "journal/vocabulary.h"
#include "scene/pick_geometry.h"

#include <algorithm>

namespace isoscope {
namespace {

std::string place_of(Vec3 p) {
  return general(p.x, 6) + "," + general(p.y, 6) + "," + general(p.z, 6);
}

SuggestedBreak rejected(Reason reason) {
  return {"rejection && reason == " + std::string(name(reason)),
          "any edge that stays: " + std::string(words(reason).title)};
}

class Suggestions {
 public:
  explicit Suggestions(const Debugger& debugger) : debugger_(debugger), window_(debugger.window) {}

  std::vector<SuggestedBreak> made() {
    gate();
    const Pick& p = window_.selection.picked;
    const std::string id = std::to_string(p.id);
    switch (p.kind) {
    case Pick::Kind::edge:
      edge("edge(" + id + "," + std::to_string(p.other) + ")");
      near("edge near (", ") ", "any edge within δ of its middle");
      break;
    case Pick::Kind::sample:
      add("sample(" + id + ").class changes", "it becomes good or bad");
      add("sample(" + id + ")", "an event names it");
      near("near(", ",", "anything within δ of it", ")");
      break;
    case Pick::Kind::vertex:
      add("vertex(" + id + ")", "an event names it");
      near("near(", ",", "anything within δ of it", ")");
      break;
    case Pick::Kind::tet:
      add("tet(" + id + ")", "an event names it");
      near("near(", ",", "anything within δ of its middle", ")");
      break;
    case Pick::Kind::facet:
      near("near(", ",", "anything within δ of its middle", ")");
      break;
    case Pick::Kind::point:
    case Pick::Kind::over_rim:
      near("near(", ",", "anything within δ of it", ")");
      break;
    case Pick::Kind::none:
      event();
      break;
    }
    return std::move(found_);
  }

 private:
  void add(std::string condition, std::string words) {
    const auto same = [&](const SuggestedBreak& s) { return s.condition == condition; };
    if (std::none_of(found_.begin(), found_.end(), same))
      found_.push_back({std::move(condition), std::move(words)});
  }

  /// Stepping through gates: the gate shown, where it stopped the edge.
  void gate() {
    if (window_.place.level != DebugLevel::gate) return;
    const auto gates = debugger_.gates();
    const std::size_t i = window_.place.gate;
    if (i >= collapse_check_count || gates.size() != collapse_check_count + 1 || !gates[i].failed) return;
    found_.push_back(rejected(words(static_cast<CollapseCheck>(i)).reason));
  }

  void edge(const std::string& which) {
    if (const auto index = window_.selected_event()) {
      const Event& e = window_.run.journal->events()[*index];
      std::string text = which + " && " + std::string(name(e.kind));
      if (e.reason != Reason::none) text += " && reason == " + std::string(name(e.reason));
      add(text, "this edge, decided so again");
    }
    add(which, "any attempt on this edge");
    if (const auto xray = debugger_.probe.xray(); xray && xray->attempt.rejected != Reason::none) {
      const SuggestedBreak any = rejected(xray->attempt.rejected);
      add(any.condition, any.words);
    }
  }

  void near(const std::string& before, const std::string& between, const std::string& words,
            const std::string& after = "") {
    const auto state = window_.state();
    if (!state || state->criteria.delta <= 0) return;
    const Box3 box = pick_bounds(*state, window_.selection.picked);
    if (box.empty()) return;
    add(before + place_of(box.center()) + between + general(state->criteria.delta, 6) + after, words);
  }

  /// Nothing is selected: events like the one that led here.
  void event() {
    const std::ptrdiff_t here = debugger_.current_event();
    if (here < 0) return;
    const Event& e = window_.run.journal->events()[static_cast<std::size_t>(here)];
    std::string text(name(e.kind));
    if (e.reason != Reason::none) text += " && reason == " + std::string(name(e.reason));
    add(text, "events like this one");
  }

  const Debugger& debugger_;
  const WindowState& window_;
  std::vector<SuggestedBreak> found_;
};

} // namespace

std::vector<SuggestedBreak> suggested_breaks(const Debugger& debugger) {
  if (!debugger.window.run.journal) return {};
  return Suggestions(debugger).made();
}

bool breaks_on(const Debugger& debugger, const std::string& condition) {
  const auto list = debugger.breakpoints->list();
  return std::any_of(list.begin(), list.end(), [&](const BreakpointState& b) { return b.text == condition; });
}

} // namespace isoscope
