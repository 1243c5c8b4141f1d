// What the conditions of the refinement share: Ω, S, T, the parameters in force, and the one way to change T.
#pragma once

#include "base/run_control.h"
#include "criteria/nearest_sample.h"
#include "journal/recorder.h"
#include "refine/checklist.h"
#include "refine/live_triangulation.h"
#include "refine/refinement.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <chrono>
#include <optional>

namespace isoscope {

/// What a condition made of its turn.
enum class Turn {
  satisfied, ///< nothing (more) to do for it
  acted      ///< T changed or an event was recorded: the conditions are to be looked at in order again
};

/// Shared by all conditions of one refinement; every change of T goes through it into the journal.
class RefinementContext {
 public:
  RefinementContext(ToleranceVolume& volume, SearchedSamples samples, const CriteriaParameters& criteria,
                    Recorder& recorder, const RunControl& control);

  ToleranceVolume& volume() { return volume_; }
  const ToleranceVolume& volume() const { return volume_; }
  LiveTriangulation& live() { return live_; }
  const LiveTriangulation& live() const { return live_; }
  const SearchedSamples& samples() const { return samples_; }
  const NearestSample& nearest() const { return *samples_.nearest; }
  const CriteriaParameters& criteria() const { return criteria_; }
  void set_criteria(const CriteriaParameters& criteria);
  Recorder& recorder() { return recorder_; }
  bool cancelled() const { return control_.cancelled(); }
  const RunControl& control() const { return control_; }

  /// A vertex of this label with |F| = 1 on the grid of S, of a kind other than sample.
  Vertex free_vertex(Vec3 p, int label, VertexKind kind) const;
  Vertex sample_vertex(SampleId s) const;
  /// Rounded to the grid on which zeros of f are representable.
  Vec3 snapped(Vec3 p) const;
  /// Distance from p to the nearest vertex of T.
  double spacing(Vec3 p, TetId hint) const;
  /// A vertex may not come nearer to another one than this (absolute).
  double smallest_spacing() const;

  /// Inserts and records; false when the vertex is there already or lies outside the box (nothing is recorded
  /// then).
  bool insert(const Vertex& vertex, TetId hint, Event event);
  void relabel(std::span<const VertexId> vertices, Event event);
  void replace_samples(std::shared_ptr<const BoundarySamples> samples);
  void start();
  void note(Event event);
  void warn(std::string text, EventKind kind = EventKind::warning);

  /// Checklists that follow every change of T: tetrahedra that died are forgotten, those that carry Z are
  /// pending.
  void follow(Checklist& checklist) { checklists_.push_back(&checklist); }
  /// Everything to be judged anew.
  void requeue_all();

  /// What the gate said since last asked; stop outweighs changed parameters.
  Gate::Verdict take_verdict();
  std::size_t insertions(Condition condition) const {
    return insertions_[static_cast<std::size_t>(condition)];
  }
  /// A living tetrahedron near the last change, to start walks from.
  TetId hint() const { return hint_; }

 private:
  void hear(Gate::Verdict verdict);
  void update_checklists();
  StepFigures figures();

  ToleranceVolume& volume_;
  LiveTriangulation live_;
  SearchedSamples samples_;
  CriteriaParameters criteria_;
  Recorder& recorder_;
  const RunControl& control_;
  std::vector<Checklist*> checklists_;
  std::array<std::size_t, condition_count> insertions_{};
  Gate::Verdict verdict_ = Gate::Verdict::go_on;
  TetId hint_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

} // namespace isoscope
