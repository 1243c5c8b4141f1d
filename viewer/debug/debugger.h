// The window's debugger: breakpoints, saved filters with their lanes, going on and back to events, stepping
// on three levels.
#pragma once

#include "debug/event_order.h"
#include "debug/filtered_events.h"
#include "edge/probe.h"
#include "model/worker.h"
#include "query/breakpoints.h"
#include "query/search.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

struct Ui;

/// A gate of the event shown: a check of its edge, or a sweep of its repair.
struct GateView {
  std::string title, state, numbers; ///< "link condition in T", "failed", "0.2 against 1"
  bool failed = false;
  std::optional<Vec3> witness;
};

/// What is asked of a journal: the next or the previous event that matches.
struct QueryRequest {
  std::uint64_t number = 0; ///< of the search
  std::shared_ptr<const Journal> journal;
  QuerySearch search;
  bool goes_on = false; ///< where no later event matches, the run goes on
};

/// The pause note of a step on one of the levels.
inline constexpr std::string_view stepping_note = "stepped";

/// The edge or the sample that an event names; none where it names neither.
Pick pick_of(const Event& event);

class Debugger {
 public:
  Debugger(WindowState& shared, const EdgeProbe& edge, std::function<void()> notify);

  WindowState& window;
  const EdgeProbe& probe;

  /// Shared with the run's thread.
  std::shared_ptr<BreakpointSet> breakpoints = std::make_shared<BreakpointSet>();
  FilteredEvents listed;             ///< what the event list shows
  std::vector<FilteredEvents> lanes; ///< one a saved filter of the settings
  LoopEvents loops;                  ///< of an open surface

  /// Once a frame: arms the session, tells hits, takes answers, gathers lists. True when something changed.
  bool update();
  /// Whether searches and lists are as far as the journal is.
  bool is_current() const;
  /// Begins the end of what is asked, and waits for nothing.
  void abandon() { worker_.abandon(); }
  /// Of the run that was active; breakpoints stop the active run alone.
  void disarm();
  /// Why the run that is active now paused was told when it did.
  void take_pause_as_told();

  /// The event at which one stands: the selected one where it belongs to the step shown, else the operation
  /// that led there; -1 before both.
  std::ptrdiff_t current_event() const;
  /// Goes to an event, selects and frames what it names.
  void show_event(std::uint32_t index);
  /// Lets the worker look for the next event; the window goes there when it has the answer.
  void search(std::vector<std::shared_ptr<const Expression>> expressions, Direction direction, bool goes_on);
  /// Gathers what the event list shows.
  void gather_listed();
  /// What it shows, in its order.
  const std::vector<std::uint32_t>& listed_rows() const {
    return order_.of(listed, window.index, window.event_sort);
  }

  /// The gates of the event at which one stands, in their order; empty where it has none, or while the X-ray
  /// is made.
  std::vector<GateView> gates() const;
  /// "Z, rejection 123, 4 kernel: failed, 0.2 against 1", with arrows between.
  std::string breadcrumb() const;
  Status step_over(const Arguments& arguments, Direction direction);
  Status step_into();
  Status step_out();

  void add_commands(CommandTable& table);
  /// To stages and events, and the filter of their list.
  void add_event_commands(CommandTable& table);
  /// What the event shown names, and its witness.
  void add_select_commands(CommandTable& table);
  void add_values(NamedValues& values);

 private:
  bool tell_pause();
  bool take_answer();
  void gather();
  void leave_gates();
  std::optional<std::uint32_t> event_here() const;
  bool has_gates() const;
  Status run_to(long n, bool (*wanted)(const Event&));
  Status advance(long n, int direction, bool (*wanted)(const Event&));

  Worker<QueryRequest, QueryMatch> worker_;
  mutable EventOrder order_;   ///< kept from frame to frame
  bool armed_ = false;         ///< the session asks the breakpoints
  std::uint64_t searches_ = 0; ///< number of the search asked for last
  std::uint64_t told_ = 0;     ///< number of the last one whose answer was told or dropped
  std::uint64_t held_generation_ = 0;
  std::size_t held_events_ = 0; ///< events there were at the pause that was told last
};

/// A condition worth stopping at, made from what is selected and where one stands.
struct SuggestedBreak {
  std::string condition; ///< in the language of breakpoints
  std::string words;     ///< "this edge, for this reason"
};

/// The first is what F9 breaks on; empty where nothing is selected and no event led here.
std::vector<SuggestedBreak> suggested_breaks(const Debugger& debugger);
/// Whether there is a breakpoint with just this condition.
bool breaks_on(const Debugger& debugger, const std::string& condition);

namespace panels {

/// Breakpoints that the inspector offers: on the selection, the gate or the event shown.
void break_rows(Ui& ui, const Debugger& debugger);

} // namespace panels

} // namespace isoscope
