// Hits, answers and lists, frame by frame.
#include "debug/debugger.h"

#include "base/numbers.h"

namespace isoscope {
namespace {

/// The match, null where there is none.
std::shared_ptr<const QueryMatch> search_of(const QueryRequest& request, const RunControl& control) {
  const auto match = find(request.journal, request.search, control);
  return match ? std::make_shared<const QueryMatch>(*match) : nullptr;
}

} // namespace

Debugger::Debugger(WindowState& shared, const EdgeProbe& edge, std::function<void()> notify)
    : window(shared), probe(edge), worker_(search_of, std::move(notify)) {}

void Debugger::disarm() {
  window.session.set_breakpoint({});
  armed_ = false;
  breakpoints->forget_hits();
}

void Debugger::take_pause_as_told() {
  held_generation_ = window.run.generation;
  held_events_ = window.run.journal ? window.run.journal->events().size() : 0;
}

Pick pick_of(const Event& event) {
  Pick pick;
  if (event.vertex.valid() && event.other.valid()) {
    pick.kind = Pick::Kind::edge;
    pick.id = event.vertex.value;
    pick.other = event.other.value;
    pick.point = event.point;
  } else if (event.sample.valid()) {
    pick.kind = Pick::Kind::sample;
    pick.id = event.sample.value;
    pick.point = event.point;
  }
  return pick;
}

void Debugger::show_event(std::uint32_t index) {
  const Event& event = window.run.journal->events()[index];
  window.transport.jump(step_showing(event));
  const Pick pick = pick_of(event);
  window.selection.pick(pick);
  window.selection.event = index;
  if (pick.kind != Pick::Kind::none) window.requests.frame_selection = true;
}

void Debugger::gather_listed() {
  listed.update(window.run.journal, {window.filter.expression, window.filter.chosen, window.range, &loops});
}

// Goes to where the run paused, once a pause, and says why.
bool Debugger::tell_pause() {
  if (window.run.phase != SessionPhase::paused || window.run.pause_note.empty() || !window.run.journal)
    return false;
  const std::size_t events = window.run.journal->events().size();
  if (held_generation_ == window.run.generation && held_events_ == events) return false;
  held_generation_ = window.run.generation;
  held_events_ = events;
  const auto hit = breakpoints->last_hit();
  if (hit && hit->note() == window.run.pause_note && hit->event < events) {
    show_event(hit->event);
    std::string number;
    for (const BreakpointState& b : breakpoints->list())
      if (b.id == hit->id) number = ", hit " + grouped(b.hits);
    window.tell("Stopped at " + hit->note() + number + ".");
    return true;
  }
  if (window.run.pause_note == stepping_note && events > 0) {
    show_event(static_cast<std::uint32_t>(events - 1));
    return true;
  }
  return false;
}

bool Debugger::take_answer() {
  const auto answer = worker_.answered();
  if (!answer || answer->question.number == told_) return false;
  told_ = answer->question.number;
  if (answer->question.number != searches_ || answer->question.journal != window.run.journal) return false;
  const bool forward = answer->question.search.direction == Direction::forward;
  if (answer->answer) {
    show_event(answer->answer->event);
    window.tell("Event " + std::to_string(answer->answer->event) + " matches " +
                answer->question.search.expressions[answer->answer->expression]->text() + ".");
  } else if (!forward || !answer->question.goes_on) {
    window.tell(forward ? "No later event matches." : "No earlier event matches.");
  } else if (window.run.phase == SessionPhase::paused) {
    window.session.resume();
    window.transport.follow();
  } else if (window.running()) {
    window.transport.follow();
  } else {
    window.tell("No later event matches a breakpoint.");
  }
  return true;
}

void Debugger::gather() {
  loops.update(window.run.journal, window.run.scene);
  gather_listed();
  lanes.resize(window.settings.filters.size());
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    EventQuery query = lanes[i].query();
    if (!query.expression || query.expression->text() != window.settings.filters[i]) {
      ParsedQuery parsed = parse_query(window.settings.filters[i]);
      const auto* expression = std::get_if<std::shared_ptr<const Expression>>(&parsed);
      if (expression == nullptr) continue; // a settings file that somebody has edited
      query.expression = *expression;
    }
    lanes[i].update(window.run.journal, query);
  }
}

// Gates belong to one event: where another is shown, one steps over operations again.
void Debugger::leave_gates() {
  if (window.place.level != DebugLevel::gate) return;
  if (current_event() != static_cast<std::ptrdiff_t>(window.place.gate_event.value_or(0))) {
    window.place.level = DebugLevel::operation;
    return;
  }
  const auto all = gates();
  if (window.place.gate < all.size()) window.selection.mark = all[window.place.gate].witness;
}

bool Debugger::update() {
  const bool wanted = breakpoints->any_enabled();
  if (wanted != armed_) {
    armed_ = wanted;
    window.session.set_breakpoint(!wanted ? Breakpoint()
                                          : [set = breakpoints](const Journal& journal, const Event&) {
                                              const auto hit = set->ask(journal);
                                              return hit ? hit->note() : std::string();
                                            });
  }
  bool changed = tell_pause();
  changed |= take_answer();
  gather();
  leave_gates();
  return changed || !is_current();
}

bool Debugger::is_current() const {
  const auto answer = worker_.answered();
  const bool waits = answer && answer->question.number != told_;
  return worker_.idle() && !waits && (window.running() || (listed.complete() && loops.complete()));
}

std::ptrdiff_t Debugger::current_event() const {
  if (!window.run.journal) return -1;
  const Journal& journal = *window.run.journal;
  const Step step = window.transport.step();
  if (window.selection.event && *window.selection.event < journal.events().size()) {
    const Event& e = journal.events()[*window.selection.event];
    if (step_showing(e) == step) return *window.selection.event;
  }
  return step > 0 && step <= journal.steps()
             ? static_cast<std::ptrdiff_t>(journal.operations()[step - 1].event)
             : -1;
}

void Debugger::search(std::vector<std::shared_ptr<const Expression>> expressions, Direction direction,
                      bool goes_on) {
  QueryRequest request;
  request.number = ++searches_;
  request.journal = window.run.journal;
  request.goes_on = goes_on;
  request.search.expressions = std::move(expressions);
  request.search.from = current_event();
  request.search.direction = direction;
  if (const auto scene = window.run.scene)
    request.search.expected = [scene] { return expected_genus(*scene); };
  window.transport.jump(window.transport.step());
  worker_.ask(std::move(request));
}

} // namespace isoscope
