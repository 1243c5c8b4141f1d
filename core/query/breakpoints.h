// Conditions at which a run pauses: a set that one thread edits while the run's thread asks it.
#pragma once

#include "query/watch.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace isoscope {

/// One breakpoint as it stands.
struct BreakpointState {
  unsigned id = 0; ///< from 1, never used again within a set
  std::string text;
  bool enabled = true;
  std::size_t hits = 0;   ///< events that passed, also those ignored
  std::size_t ignore = 0; ///< hits to let go by before it speaks
  std::optional<std::uint32_t> last_event;
  friend bool operator==(const BreakpointState&, const BreakpointState&) = default;
};

/// What made a run pause.
struct BreakpointHit {
  unsigned id = 0;
  std::string text;
  std::uint32_t event = 0;
  Step step = 0; ///< of the event
  /// "breakpoint 2 (reject && genus != 0) at event 1,234, step 17"
  std::string note() const;
};

/// All methods may be called from any thread; ask() from the run's.
class BreakpointSet {
 public:
  /// What tells a run's expected genus; called on the run's thread, once a journal.
  void set_expected(ExpectedGenus expected);
  /// The new breakpoint's number, or what is wrong with its text.
  std::variant<unsigned, QueryError> add(std::string_view text);
  /// False where there is none of that number.
  bool remove(unsigned id);
  bool enable(unsigned id, bool on);
  bool ignore(unsigned id, std::size_t hits);
  void remove_all();
  /// Sets the counts to 0: another run begins.
  void forget_hits();

  std::vector<BreakpointState> list() const;
  bool any_enabled() const;
  /// The expressions of those that are enabled.
  std::vector<std::shared_ptr<const Expression>> enabled() const;
  /// The hit that was told last; stays until forget_hits().
  std::optional<BreakpointHit> last_hit() const;

  /// Judges the journal's newest event; counts every breakpoint that holds and tells the first that speaks.
  /// A journal other than before is followed from its beginning.
  std::optional<BreakpointHit> ask(const Journal& journal);

 private:
  struct Entry {
    BreakpointState state;
    std::shared_ptr<const Expression> expression;
  };
  Entry* find(unsigned id);
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  unsigned next_id_ = 1;
  std::optional<BreakpointHit> last_hit_;
  ExpectedGenus expected_;
  std::unique_ptr<JournalWatch> watch_;
};

} // namespace isoscope
