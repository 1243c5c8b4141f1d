// A worker that owns a playback of the journal and describes the state at the step asked for; newer requests
// replace older.
#pragma once

#include "criteria/nearest_sample.h"
#include "model/worker.h"
#include "questions/snapshot.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace isoscope {

/// A sample set with its search trees, kept alive together.
struct SampleIndex {
  explicit SampleIndex(std::shared_ptr<const BoundarySamples> samples)
      : set(std::move(samples)), nearest(set->positions, set->labels) {}
  std::shared_ptr<const BoundarySamples> set;
  NearestSample nearest;
};

/// What is wanted of the play head.
struct PlayheadRequest {
  std::uint64_t generation = 0; ///< of the session's run: another value means another journal
  std::shared_ptr<const Journal> journal;
  Step step = 0;
  bool sampled = false; ///< the journal has samples: step 0 is there before them, and looks otherwise then
  SnapshotOptions options;
  /// What the journal and the keyframes may take together in memory, bytes. Half of it is the journal's: what
  /// is older goes to the disk; keyframes get the rest.
  std::size_t history_limit = std::size_t{2048} << 20;
  friend bool operator==(const PlayheadRequest& a, const PlayheadRequest& b) {
    return a.generation == b.generation && a.journal == b.journal && a.step == b.step &&
           a.sampled == b.sampled && a.history_limit == b.history_limit &&
           a.options.orientation == b.options.orientation && a.options.recent == b.options.recent &&
           a.options.criteria == b.options.criteria;
  }
};

/// The newest answer. Everything in it is immutable.
struct PlayheadResult {
  PlayheadRequest request;
  std::shared_ptr<const StateSnapshot> state;
  std::size_t keyframe_bytes = 0;           ///< of the play head's keyframes
  std::shared_ptr<const SampleIndex> index; ///< null until a request asked for orientation
};

/// A live preview: which samples and tetrahedra would violate under these parameters, at the state shown.
struct Preview {
  CriteriaParameters criteria;
  std::shared_ptr<const StateSnapshot> state; ///< whose ids are told
  std::shared_ptr<const ViolationPreview> violations;
};

/// Methods are for one thread, the window's; the work happens on the worker's.
class Playhead {
 public:
  /// `notify` is called from the worker whenever an answer is ready.
  explicit Playhead(std::function<void()> notify);

  /// Replaces any request that was not begun yet.
  void request(PlayheadRequest request);
  /// Of the state that was asked for last.
  void request_preview(const CriteriaParameters& criteria);
  /// Drops everything: the next request starts from nothing.
  void clear();

  /// The newest state, null before the first.
  std::shared_ptr<const PlayheadResult> result() const;
  std::optional<Preview> preview() const;
  /// Whether every request has been answered.
  bool idle() const { return worker_->idle(); }
  /// Blocks until idle; for tests.
  void wait() const { worker_->wait(); }

 private:
  struct Question {
    PlayheadRequest request;
    std::optional<CriteriaParameters> preview;
    std::uint64_t epoch = 0; ///< grows with clear(): an answer to a question from before is dropped
  };
  struct Answer {
    std::shared_ptr<const PlayheadResult> result;
    std::optional<Preview> preview; ///< the newest of this epoch
  };
  class Answerer;
  using PlayheadWorker = Worker<Question, Answer>;
  std::shared_ptr<const Answer> newest() const;

  std::unique_ptr<PlayheadWorker> worker_;
  std::optional<PlayheadRequest> asked_;
  std::uint64_t epoch_ = 0;
};

} // namespace isoscope
