// Steps over, into and out of the tree of stages, operations and gates.
#include "debug/debugger.h"
#include "model/words.h"
#include "ui/icons.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

bool is_attempt(const Event& e) {
  return e.operation || e.kind == EventKind::rejection || e.kind == EventKind::exhausted;
}
bool is_stage(const Event& e) {
  return e.kind == EventKind::stage_begin;
}

/// The n-th event from `at` on in that direction for which `wanted` holds; -1 none. `left` tells how many
/// there were too few.
std::ptrdiff_t find_event(const Journal& journal, std::ptrdiff_t at, int direction, long n,
                          bool (*wanted)(const Event&), long& left) {
  const auto end = static_cast<std::ptrdiff_t>(complete_events(journal));
  std::ptrdiff_t found = -1;
  left = n;
  for (at += direction; at >= 0 && at < end && left > 0; at += direction)
    if (wanted(journal.events()[static_cast<std::size_t>(at)])) {
      found = at;
      --left;
    }
  return left == 0 ? found : -1;
}

std::vector<GateView> sweeps_of(const Journal& journal, const Event& e) {
  std::vector<GateView> gates;
  const double delta = journal.parameters_at(e.step).delta;
  const RepairDetail& sweeps = journal.repairs()[e.detail];
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const RepairSweep& s = sweeps[i];
    GateView gate;
    gate.title = "sweep " + std::to_string(i + 1) + " of " + std::to_string(sweeps.size());
    gate.failed = s.distance_left > delta;
    gate.state = gate.failed ? "above δ" : "below δ";
    gate.numbers = "largest d " + number_beside(s.largest_distance / delta, 1) + " → " +
                   number_beside(s.distance_left / delta, 1) + " δ, moved " + std::to_string(s.moved) +
                   ", flipped " + std::to_string(s.flipped);
    gates.push_back(std::move(gate));
  }
  GateView end;
  end.failed = e.kind == EventKind::rejection;
  end.title = end.failed ? "rolled back" : "committed";
  end.state = std::string(end.failed ? name(e.reason) : "all facets below δ");
  end.numbers =
      number_beside(e.value / delta, e.limit / delta) + " δ against " + short_number(e.limit / delta) + " δ";
  if (end.failed && e.value > e.limit)
    end.numbers += ", too much by " + short_number((e.value - e.limit) / delta) + " δ";
  if (squared_length(e.witness) > 0) end.witness = e.witness;
  gates.push_back(std::move(end));
  return gates;
}

std::vector<GateView> checks_of(const EdgeXray& x) {
  std::vector<GateView> gates;
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    const auto check = static_cast<CollapseCheck>(i);
    const CheckVerdict& v = x.attempt.check(check);
    GateView gate;
    gate.title = words(check).title;
    gate.failed = v.state == CheckVerdict::State::failed;
    gate.state = v.state == CheckVerdict::State::passed ? "passed" : gate.failed ? "failed" : "not asked";
    if (v.state != CheckVerdict::State::skipped && (v.value != 0 || v.limit != 0)) {
      // Lengths are told in δ.
      const bool length = check == CollapseCheck::kernel || check == CollapseCheck::containment;
      const double unit = length ? x.criteria.unit() : 1;
      gate.numbers = number_beside(v.value / unit, v.limit / unit) + (length ? " δ against " : " against ") +
                     short_number(v.limit / unit) + (length ? " δ" : "");
    }
    if (gate.failed && squared_length(v.witness) > 0) gate.witness = v.witness;
    gates.push_back(std::move(gate));
  }
  GateView cost;
  cost.title = "cost";
  cost.state = x.attempt.possible() ? "possible" : "stays";
  if (x.attempt.possible()) {
    cost.numbers = short_number(x.attempt.cost) + ", " + short_number(x.attempt.unconstrained_cost) +
                   " without constraints";
    cost.witness = x.attempt.target;
  }
  gates.push_back(std::move(cost));
  return gates;
}

} // namespace

std::optional<std::uint32_t> Debugger::event_here() const {
  const std::ptrdiff_t at = current_event();
  return at < 0 ? std::nullopt : std::optional<std::uint32_t>(static_cast<std::uint32_t>(at));
}

bool Debugger::has_gates() const {
  const auto here = event_here();
  if (!here) return false;
  const Event& e = window.run.journal->events()[*here];
  return e.detail != 0 || (e.vertex.valid() && e.other.valid() && e.stage != Stage::improve);
}

// Lets a held run go on to the n-th such event.
Status Debugger::run_to(long n, bool (*wanted)(const Event&)) {
  if (window.run.phase != SessionPhase::paused) return usage("There is no such step in that direction.");
  auto left = std::make_shared<long>(n);
  window.session.run_until([left, wanted](const Journal&, const Event& event) {
    return wanted(event) && --*left == 0 ? std::string(stepping_note) : std::string();
  });
  window.transport.follow();
  return {};
}

Status Debugger::advance(long n, int direction, bool (*wanted)(const Event&)) {
  long left = 0;
  const std::ptrdiff_t found = find_event(*window.run.journal, current_event(), direction, n, wanted, left);
  if (found >= 0) {
    show_event(static_cast<std::uint32_t>(found));
    return {};
  }
  if (direction > 0) return run_to(left, wanted);
  return usage("There is no such step in that direction.");
}

std::vector<GateView> Debugger::gates() const {
  const auto here = event_here();
  if (!here) return {};
  const Event& e = window.run.journal->events()[*here];
  if (e.detail != 0) return sweeps_of(*window.run.journal, e);
  const auto xray = probe.xray();
  return xray ? checks_of(*xray) : std::vector<GateView>();
}

std::string Debugger::breadcrumb() const {
  const std::string between = std::string("  ") + icon::right + "  ";
  const auto here = event_here();
  if (!here) return "setup";
  const Event& e = window.run.journal->events()[*here];
  std::string text(words(e.stage).title);
  if (window.place.level == DebugLevel::stage) return text;
  text += between + std::string(name(e.kind)) + " " + grouped(*here);
  if (window.place.level == DebugLevel::operation) return text;
  const auto all = gates();
  if (window.place.gate >= all.size()) return text + between + "…";
  const GateView& gate = all[window.place.gate];
  return text + between + std::to_string(window.place.gate + 1) + " " + gate.title + ": " + gate.state +
         (gate.numbers.empty() ? "" : ", " + gate.numbers);
}

Status Debugger::step_over(const Arguments& a, Direction direction) {
  const auto n = count_argument(a, "steps");
  if (!n) return n.error();
  const int sign = direction == Direction::forward ? 1 : -1;
  switch (window.place.level) {
  case DebugLevel::stage:
    return advance(*n, sign, is_stage);
  case DebugLevel::operation:
    return advance(*n, sign, is_attempt);
  case DebugLevel::gate:
    break;
  }
  const auto count = static_cast<long>(gates().size());
  const long wanted = static_cast<long>(window.place.gate) + sign * *n;
  if (wanted >= 0 && wanted < count) {
    window.place.gate = static_cast<std::size_t>(wanted);
    return {};
  }
  // Past the last gate one is at the next operation, before the first one at the operation itself.
  window.place.level = DebugLevel::operation;
  return wanted < 0 ? Status() : advance(1, 1, is_attempt);
}

Status Debugger::step_into() {
  switch (window.place.level) {
  case DebugLevel::stage: {
    window.place.level = DebugLevel::operation;
    const auto here = event_here();
    return here && is_attempt(window.run.journal->events()[*here]) ? Status() : advance(1, 1, is_attempt);
  }
  case DebugLevel::operation: {
    if (!has_gates())
      return Error{ErrorCode::usage, "This event has no steps inside.",
                   "Collapses, edges that stay and repairs have."};
    const auto here = event_here();
    if (window.selection.event != here) show_event(*here);
    window.place.level = DebugLevel::gate;
    window.place.gate = 0;
    window.place.gate_event = here;
    return {};
  }
  case DebugLevel::gate:
    break;
  }
  return Error{ErrorCode::usage, "A gate is the innermost level.", "Shift+F11 leaves it."};
}

Status Debugger::step_out() {
  if (window.place.level == DebugLevel::stage)
    return Error{ErrorCode::usage, "Stages are the outermost level.", "F11 goes into one."};
  window.place.level = window.place.level == DebugLevel::gate ? DebugLevel::operation : DebugLevel::stage;
  return {};
}

} // namespace isoscope
