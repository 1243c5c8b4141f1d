// A run with the state of it that its play head shows: the window steers one, and may show another beside it.
#pragma once

#include "base/stopwatch.h"
#include "model/grid_loader.h"
#include "model/journal_index.h"
#include "model/playhead.h"
#include "model/preparation_progress.h"
#include "model/transport.h"
#include "run/session.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// Two of them can be swapped: each keeps its threads, its keyframes and its place.
class ShownRun {
 public:
  /// `notify` is called from workers when something new is ready.
  explicit ShownRun(const std::function<void()>& notify) : playhead(notify), grid(notify) {}

  Session session;
  SessionSnapshot run; ///< taken once a frame
  Playhead playhead;
  GridLoader grid;
  JournalIndex index;
  Transport transport;

  /// The state shown; may be null.
  std::shared_ptr<const StateSnapshot> state() const { return result_ ? result_->state : nullptr; }
  std::shared_ptr<const SampleIndex> sample_index() const { return result_ ? result_->index : nullptr; }
  Step live_step() const { return run.journal ? run.journal->steps() : 0; }
  /// Something is being computed, or a recording grows.
  bool running() const {
    return run.phase == SessionPhase::preparing || run.phase == SessionPhase::running ||
           run.phase == SessionPhase::following;
  }
  /// The run has ended, and its improver can try for fewer vertices.
  bool can_go_on_improving() const {
    return run.phase == SessionPhase::finished && run.result && run.result->can_go_on;
  }
  /// More steps may come.
  bool growing() const { return running() || !index.complete(); }
  /// What is shown was read from a file.
  bool shows_recording() const { return run.recording && run.recording->opened; }
  /// The play head moves, or will as soon as the run makes a step.
  bool playing() const { return transport.moving() && (running() || !transport.at_live_end(live_step())); }
  /// Of the input, and δ around it once that is known.
  const Box3& scene_bounds() const { return bounds_; }
  /// What of it has to be in sight where all of it is to be; see scene/outline.h.
  const std::vector<Vec3>& scene_outline() const { return outline_; }
  /// How far the preparation is, while the run is in it.
  const PreparationProgress& preparation() const { return preparation_; }
  /// The labels of the regions around Ω, descending: the outside first. More than two where there are rooms.
  std::vector<std::int8_t> side_labels() const;
  bool has_rooms() const { return side_labels().size() > 2; }
  /// The rim of an open input; null where there is none.
  const Rim* rim() const;
  /// What the user should know of the scene, in sentences; that Ω is no thickening comes first.
  std::vector<std::string> warnings() const;
  /// Why bad samples are no fault at the step shown: Z is held by proofs there. Empty where they are asked.
  std::string why_bad_may_stay() const;
  bool no_thickening() const { return run.scene && !run.scene->thickening_note.empty(); }

  // Once a frame, in this order.
  /// Takes what the session has; true when it is another run than before.
  bool take_snapshot();
  /// Asks for the state at the play head's step. `recent`: operations back that count as changed;
  /// `history_limit`: bytes of journal and keyframes; `moving`: condition 3, which costs more than all the
  /// rest, need not be judged yet, and each state that was begun is to be seen.
  void request_state(Step recent, std::size_t history_limit, bool moving);
  /// Takes the newest answer; true when there was one.
  bool take_result();
  /// The state shown is the one that the play head asks for, and nothing under way would change it.
  bool is_current() const;
  /// Bytes of the play head's keyframes.
  std::size_t keyframe_bytes() const { return result_ ? result_->keyframe_bytes : 0; }
  /// The play head rests and its answer was made under this limit of the history.
  bool kept_within(std::size_t history_limit) const {
    return playhead.idle() && result_ && result_->request.history_limit == history_limit;
  }
  /// The answer that is shown is the newest, and no other is being made.
  bool result_taken() const { return playhead.idle() && playhead.result() == result_; }

 private:
  std::shared_ptr<const PlayheadResult> result_;
  std::optional<PlayheadRequest> asked_;
  void measure_input();

  std::shared_ptr<const Scene> scene_seen_;
  std::shared_ptr<const TriangleSoup> measured_;
  double margin_ = 0; ///< around it
  Box3 bounds_;
  std::vector<Vec3> outline_;
  PreparationProgress preparation_;
  Stopwatch since_began_;
  std::uint64_t generation_ = 0;
};

} // namespace isoscope
