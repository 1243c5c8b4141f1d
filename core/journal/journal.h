// The spine: every event of a run in order, every operation's delta, the figures after each operation
// (core/README.md, D1).
#pragma once

#include "base/append_only.h"
#include "base/spill_list.h"
#include "journal/event.h"
#include "journal/stored_delta.h"
#include "mesh/complex.h"
#include "tolerance/boundary_sampler.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace isoscope {

/// Parameters that conditions are judged by; they may change during a run (parameter_change events).
struct CriteriaParameters {
  double delta = 0;      ///< δ, absolute
  double sigma = 0;      ///< σ, absolute: the density asked of S
  double alpha = 0.2;    ///< α in (0, 1): margin of condition 1
  double shrink = 0.7;   ///< factor of the shrunk copy in condition 3, in (0, 1]
  bool certified = true; ///< containment by certificate instead of condition 2
  bool condition_1 = true, condition_2 = true, condition_3 = true, condition_4 = true;
  double error_limit() const { return 1.0 - alpha; }          ///< ε(s) must not exceed it
  double height_limit() const { return 2.0 * sigma / alpha; } ///< heights must not fall below it
  double unit() const { return delta > 0 ? delta : 1; }       ///< lengths are told in δ, where there is one
  friend bool operator==(const CriteriaParameters&, const CriteriaParameters&) = default;
};

/// Figures after an operation: what the plots draw. NaN or 0 where not known.
struct StepFigures {
  std::uint32_t bad_samples = 0; ///< ε >= 1
  std::uint32_t zero_set_vertices = 0;
  std::uint32_t tets = 0;
  float largest_error = 0;   ///< max ε over S
  float smallest_height = 0; ///< over tetrahedra that carry Z, in units of δ; infinite when none does
  float seconds = 0;         ///< since the stage began; not part of what replay compares
};

/// One operation: the event that decided it and the delta it applied.
struct Operation {
  std::uint32_t event = 0; ///< index into events
  StoredDelta stored;
  StepFigures figures; ///< after it
  /// Valid only as long as the journal is.
  Delta delta() const { return stored.read(); }
};

/// Append-only; written by the run's thread through Recorder, read by anyone at any time. Beyond a limit its
/// older events and deltas go to the disk, from where they are read as if they were in memory.
class Journal {
 public:
  const SpillList<Event>& events() const { return events_; }
  const SpillList<Operation>& operations() const { return operations_; }
  /// Sample sets in the order they came; set k of a state is Complex-independent: see
  /// PlaybackState::sample_set.
  const AppendOnly<std::shared_ptr<const BoundarySamples>>& sample_sets() const { return sample_sets_; }
  /// Parameters in force from `step` on, ascending by step.
  struct ParameterRecord {
    Step step = 0;
    CriteriaParameters criteria;
  };
  const AppendOnly<ParameterRecord>& parameters() const { return parameters_; }
  /// The parameters in force at a step.
  CriteriaParameters parameters_at(Step step) const;
  /// When stages began, ended or were stopped; the digest leaves it out, as all times.
  struct StageMark {
    std::uint32_t event = 0; ///< index into events
    double seconds = 0;      ///< since the journal was made
  };
  const AppendOnly<StageMark>& stage_marks() const { return stage_marks_; }
  /// Text 0 is empty.
  const AppendOnly<std::string>& texts() const { return texts_; }
  /// The sweeps of repairs, committed or rolled back; entry 0 is empty.
  const AppendOnly<RepairDetail>& repairs() const { return repairs_; }
  Step steps() const { return static_cast<Step>(operations_.size()); }
  /// Bytes that are in memory; those on the disk besides.
  std::size_t memory_bytes() const;
  std::size_t disk_bytes() const { return pool_->disk_bytes(); }
  /// What may be in memory from now on; at any time, by anyone: nothing changes that could be read. Samples
  /// and texts stay in memory.
  void keep_within(std::size_t bytes) const;
  /// Gives back the memory that reading from the disk has taken.
  void release_read_back() const { pool_->release_read_back(); }
  /// Why it takes more memory than it may; nothing while it does not.
  std::optional<Error> spill_error() const { return pool_->error(); }

  /// `spill_folder`: where the part on the disk is kept.
  explicit Journal(std::filesystem::path spill_folder = SpillPool::default_folder());

  // Writer's side: one thread only.
  /// Takes over what `from` says up to `step`: all events before the operation that leads on, at most
  /// `events` of them, and what they speak of; samples are shared. Only into an empty journal.
  void take_prefix(const Journal& from, Step step,
                   std::size_t events = std::numeric_limits<std::size_t>::max());
  std::uint32_t add_text(std::string text);
  std::uint32_t add_repair(RepairDetail sweeps);
  std::uint16_t add_sample_set(std::shared_ptr<const BoundarySamples> samples);
  void add_parameters(const CriteriaParameters& criteria);
  /// Sets event.step; returns the event's index. `seconds`: when it happened, for journals read from a file.
  std::uint32_t add_event(Event event, std::optional<double> seconds = std::nullopt);
  void add_operation(Event event, const Delta& delta, const StepFigures& figures);

 private:
  std::unique_ptr<SpillPool> pool_;
  SpillList<Event> events_;
  SpillList<Operation> operations_;
  DeltaStore deltas_;
  AppendOnly<std::shared_ptr<const BoundarySamples>> sample_sets_;
  AppendOnly<ParameterRecord> parameters_;
  AppendOnly<StageMark> stage_marks_;
  AppendOnly<std::string> texts_;
  AppendOnly<RepairDetail> repairs_;
  std::atomic<std::size_t> bytes_{0};       ///< of what may go to the disk, wherever it is
  std::atomic<std::size_t> fixed_bytes_{0}; ///< of what stays in memory
  double age() const;                       ///< seconds
  std::chrono::steady_clock::time_point made_ = std::chrono::steady_clock::now();
};

/// How many events a reader may look at: a growing journal has the last one before its operation.
std::size_t complete_events(const Journal& journal);
/// A journal of the first events alone, with the operations among them.
std::shared_ptr<Journal> first_events(const Journal& journal, std::size_t events);
/// A digest (FNV-1a, 64 bit) of events, deltas and texts, without times: equal digests mean the same journal.
std::uint64_t digest(const Journal& journal);

} // namespace isoscope
