// The second run: which of the two is A, how their cameras and play heads are linked, and what differs
// between them.
#pragma once

#include "model/shown_run.h"
#include "model/worker.h"
#include "compare/compare_runs.h"
#include "scene/camera.h"
#include "scene/view_settings.h"

#include <functional>
#include <future>
#include <memory>
#include <optional>

namespace isoscope {

class AppModel;

/// The bottom pane's tab that tells what differs.
constexpr int comparison_tab = 6;

/// What the worker compares.
struct CompareQuestion {
  RunParameters a, b;
  std::shared_ptr<const Journal> journal_a, journal_b;
  std::size_t events = 0; ///< of both, when it was asked
};

/// One run is active: the model's own, which all panels and commands speak of. The other one is kept here; it
/// is hidden, or drawn beside the active one. A is the one that was there first, and stays A when the other
/// is made active.
class Comparison {
 public:
  explicit Comparison(const std::function<void()>& notify);

  bool linked_cameras = true;
  bool linked_steps = true;
  Camera camera;                  ///< of the other run's view while cameras are not linked
  Pick picked;                    ///< in the other run: the edge of its differing event
  std::optional<std::size_t> row; ///< of the table of decisions that is shown

  /// The run that is not active; null where there is none.
  ShownRun* other() { return other_.get(); }
  const ShownRun* other() const { return other_.get(); }
  bool active_is_b() const { return active_is_b_; }
  /// Both are drawn.
  bool beside() const { return other_ && beside_; }
  void set_beside(bool beside);

  /// Takes a second run in; an earlier one ends.
  void take(std::unique_ptr<ShownRun> other, bool active_is_b, bool beside);
  /// Lets the second run go; it ends on a thread of its own.
  void drop();
  /// Makes the other run the active one; play heads and cameras stay with their runs.
  void exchange(AppModel& model);

  /// Once a frame, after the active run's play head has moved: takes what is new, links, asks. True when
  /// something changed.
  bool update(AppModel& model, double seconds);
  /// Of the present two runs; null while it is made. It may be of fewer events than there are now.
  std::shared_ptr<const RunComparison> found() const;
  /// The play heads stay where they are although the active one moved there just now.
  void keep_steps(const AppModel& model);
  bool running() const { return beside() && other_->running(); }
  /// Nothing is under way that would change what is drawn of the second run.
  bool at_rest() const;
  /// The same, and the second run has come to its end and was compared to it.
  bool is_current(const AppModel& model) const;

 private:
  bool ask(const AppModel& model);
  void link(const AppModel& model, double seconds);
  CompareQuestion question(const AppModel& model) const;
  std::future<void> ending_; ///< of a run that was let go: it may take a while to notice
  std::unique_ptr<ShownRun> other_;
  bool active_is_b_ = false, beside_ = false;
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

/// The event from a difference on that shows what was decided: an operation, a refusal or an exhausted
/// tetrahedron; null where the journal ends before.
std::optional<std::uint32_t> telling_event(const Journal& journal, std::uint32_t from);
/// The run that is called A, or B; B may be null.
const ShownRun* compared_run(const AppModel& model, bool b);

} // namespace isoscope
