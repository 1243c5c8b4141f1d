// The second run: which of the two is A, how their cameras and play heads are linked, and what differs
// between them.
#pragma once

#include "compare/compare_runs.h"
#include "debug/debugger.h"
#include "model/worker.h"

#include <functional>
#include <future>
#include <memory>
#include <optional>

namespace isoscope {

struct Ui;

/// What the worker compares.
struct CompareQuestion {
  RunParameters a, b;
  std::shared_ptr<const Journal> journal_a, journal_b;
  std::size_t events = 0; ///< of both, when it was asked
};

/// What the history of the runs takes: bytes of the journals and of the play heads' keyframes in memory, what
/// they may take together, and the bytes of the journals that are on the disk.
struct HistoryMemory {
  std::size_t journal = 0, keyframes = 0, limit = 0, disk = 0;
  std::size_t bytes() const { return journal + keyframes; }
};

/// One run is active: the window's own, which all panels and commands speak of. The other one is kept here;
/// it is hidden, or drawn beside the active one. A is the one that was there first, and stays A when the
/// other is made active.
class Comparison {
 public:
  /// `notify` is called from workers; `changed` once another run has become the active one.
  Comparison(Debugger& debugger, std::function<void()> notify, std::function<void()> changed);

  WindowState& window;
  Debugger& debug;

  bool linked_cameras = true;
  bool linked_steps = true;
  Camera camera;                  ///< of the other run's view while cameras are not linked
  Pick picked;                    ///< in the other run: the edge of its differing event
  std::optional<std::size_t> row; ///< of the table of decisions that is shown

  /// The run that is not active; null where there is none.
  ShownRun* other() { return other_.get(); }
  const ShownRun* other() const { return other_.get(); }
  bool active_is_b() const { return active_is_b_; }
  /// How often the other run has become the active one.
  std::size_t exchanges() const { return exchanges_; }
  /// Both are drawn.
  bool beside() const { return other_ && beside_; }
  void set_beside(bool beside);
  /// The other one is, beside the active one or over it.
  bool drawn() const { return other_ && (beside_ || window.view.other_zero.shown()); }

  /// The run that is called A, or B; B may be null.
  const ShownRun* run(bool b) const { return b == active_is_b_ ? &window : other_.get(); }

  /// Begins a run of the same input with the draft's parameters beside the active one; the draft is the
  /// active run's again.
  Status run_beside();
  /// Opens a model with the draft's parameters, or a recording, beside the active run.
  Status open_beside(const std::string& input);
  /// Begins a run at the state shown with the edge collapsed to the target that is tried.
  Status branch_here();
  /// Begins a run that goes on from a step of the active one with the draft's parameters; the active run
  /// becomes A, hidden unless two are drawn.
  Status branch_with_draft(Step step);
  /// Makes the other run the active one; play heads and cameras stay with their runs.
  Status change_run();
  /// Ends the run that is not active; one view is left.
  void close_other();
  /// Tells everything that runs to end, and waits for nothing.
  void abandon();

  /// Once a frame, after the active run's play head has moved: takes what is new, links, asks. True when
  /// something changed.
  bool update(double seconds);
  /// Of the present two runs; null while it is made. It may be of fewer events than there are now.
  std::shared_ptr<const RunComparison> found() const;
  /// The play heads stay where they are although the active one moved there just now.
  void keep_steps();
  bool running() const { return beside() && other_->running(); }
  /// Nothing is under way that would change what is drawn of the second run.
  bool at_rest() const;
  /// The same, and the second run has come to its end and was compared to it.
  bool is_current() const;

  HistoryMemory history_memory() const;
  /// Bytes that one run may take of the limit.
  std::size_t history_share() const;

  void add_commands(CommandTable& table);
  /// The collapse that is tried, in a run of its own.
  void add_branch_command(CommandTable& table);
  void add_values(NamedValues& values);
  /// How many runs there are, and whether the active one left another.
  void add_run_values(NamedValues& values);
  void add_history_values(NamedValues& values);

 private:
  /// Takes a second run in; an earlier one ends.
  void take(std::unique_ptr<ShownRun> other, bool active_is_b, bool beside);
  /// The same beside the active run, which is A.
  void show_second(std::unique_ptr<ShownRun> second);
  /// Lets the second run go; it ends on a thread of its own.
  void drop();
  void exchange();
  bool ask();
  void link(double seconds);
  CompareQuestion question() const;
  std::function<void()> notify_, changed_;
  std::future<void> ending_; ///< of a run that was let go: it may take a while to notice
  std::unique_ptr<ShownRun> other_;
  bool active_is_b_ = false, beside_ = false;
  std::size_t exchanges_ = 0;
  Worker<CompareQuestion, RunComparison> worker_;
  std::optional<CompareQuestion> asked_;
  /// What the other play head's place was made of.
  struct Linked {
    Step step = 0;
    std::shared_ptr<const RunComparison> found;
    friend bool operator==(const Linked&, const Linked&) = default;
  };
  std::optional<Linked> linked_;
  std::string error_seen_;
};

namespace panels {

/// The bottom tab that tells what differs between two runs.
void compare_tab(Ui& ui, const Comparison& comparison);

} // namespace panels

} // namespace isoscope
