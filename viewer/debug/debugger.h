// What the window's debugger holds beside the run: breakpoints, filters with their lanes, a chosen range of
// steps, and the place in the tree of stages, operations and gates.
#pragma once

#include "debug/filtered_events.h"
#include "model/worker.h"
#include "query/breakpoints.h"
#include "query/search.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// How deep one steps.
enum class DebugLevel : std::uint8_t {
  stage,
  operation, ///< attempts: operations, and edges or tetrahedra that could not be served
  gate       ///< the checks of a collapse, or the sweeps of a repair
};

/// A gate of the event shown: a check of its edge, or a sweep of its repair.
struct GateView {
  std::string title, state, numbers; ///< "link condition in T", "failed", "0.2 against 1"
  bool failed = false;
  std::optional<Vec3> witness;
};

/// The pause note of a step on one of the levels.
inline constexpr std::string_view stepping_note = "stepped";

/// What is asked of a journal: the next or the previous event that matches.
struct QueryRequest {
  std::uint64_t number = 0; ///< of the search, see Debugger::searches
  std::shared_ptr<const Journal> journal;
  QuerySearch search;
  bool goes_on = false; ///< where no later event matches, the run goes on
};

struct Debugger {
  explicit Debugger(std::function<void()> notify)
      : worker([](const QueryRequest& r, RunControl& control) { return search_of(r, control); },
               std::move(notify)) {}
  /// The match, null where there is none.
  static std::shared_ptr<const QueryMatch> search_of(const QueryRequest& request, const RunControl& control) {
    const auto match = find(request.journal, request.search, control);
    return match ? std::make_shared<const QueryMatch>(*match) : nullptr;
  }

  /// Shared with the run's thread.
  std::shared_ptr<BreakpointSet> breakpoints = std::make_shared<BreakpointSet>();
  Worker<QueryRequest, QueryMatch> worker;
  std::string filter_text; ///< of the event list
  std::shared_ptr<const Expression> filter;
  FilteredEvents listed;             ///< what the event list shows
  std::vector<FilteredEvents> lanes; ///< one a saved filter of the settings
  std::optional<StepSpan> range;     ///< limits list and plots

  DebugLevel level = DebugLevel::operation;
  std::size_t gate = 0;
  std::optional<std::uint32_t> gate_event; ///< whose gates are stepped through

  // Bookkeeping of update_debugger().
  bool armed = false;         ///< the session asks the breakpoints
  std::uint64_t searches = 0; ///< number of the search asked for last
  std::uint64_t told = 0;     ///< number of the last one whose answer was told or dropped
  std::uint64_t held_generation = 0;
  std::size_t held_events = 0; ///< events there were at the pause that was told last
};

} // namespace isoscope
