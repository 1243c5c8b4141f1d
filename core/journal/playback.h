// The state at any step, moved forwards and backwards by deltas, from keyframes when far (core/README.md,
// D4).
#pragma once

#include "journal/journal.h"
#include "mesh/sample_sets.h"

#include <map>
#include <memory>
#include <vector>

namespace isoscope {

/// A cursor over a journal that may still be growing. Not thread-safe: each watcher owns one. Memory: one
/// Complex, one SampleSets, keyframes up to `keyframe_limit` bytes (thinned beyond: every second one is
/// dropped).
class Playback {
 public:
  explicit Playback(std::shared_ptr<const Journal> journal,
                    std::size_t keyframe_limit = std::size_t{256} << 20);

  /// Goes to `step`, clamped to what the journal has; returns where it is.
  Step seek(Step step);
  Step step() const { return step_; }

  const Complex& complex() const { return complex_; }
  const Journal& journal() const { return *journal_; }
  /// The sample set in force, null before the first one.
  std::shared_ptr<const BoundarySamples> samples() const;
  /// Brings the samples' tetrahedra up to the current step (lazily, since far seeks need not place samples in
  /// between).
  const SampleSets& sample_sets();
  CriteriaParameters parameters() const { return journal_->parameters_at(step_); }

  /// Tetrahedra added by the last `n` operations up to the current step and still alive, ascending.
  std::vector<TetId> changed_in_last(Step n) const;
  std::size_t memory_bytes() const;

  /// Bytes that keyframes may take from now on; those beyond are thinned at once.
  void set_keyframe_limit(std::size_t bytes);
  std::size_t keyframe_bytes() const { return keyframe_bytes_; }

 private:
  struct Keyframe {
    Complex complex;
    std::uint16_t sample_set = 0;
    std::size_t bytes = 0;
  };
  std::shared_ptr<const Journal> journal_;
  std::size_t keyframe_limit_;
  std::map<Step, Keyframe> keyframes_;
  Complex complex_;
  std::uint16_t sample_set_ = 0;
  Step step_ = 0;
  std::unique_ptr<SampleSets> sets_;
  Step sets_step_ = 0;                             ///< the step `sets_` is right for
  std::shared_ptr<const BoundarySamples> sets_of_; ///< what it was made of; null before there are samples

  std::size_t keyframe_bytes_ = 0;
  std::size_t work_since_keyframe_ = 0; ///< tetrahedra touched going forward beyond the last keyframe

  Delta delta_; ///< the one read last

  const Delta& read(Step operation);
  void forward_one();
  void backward_one();
  void restore(const Keyframe& keyframe, Step at);
  void keep_keyframe();
  void thin_keyframes();
};

} // namespace isoscope
