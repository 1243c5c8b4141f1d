// From a topologically right Z to a coarse one: the stages of §2.4 in the paper's order, then the improver.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "collapse/target_search.h"
#include "criteria/nearest_sample.h"
#include "journal/recorder.h"
#include "mesh/incidence.h"
#include "simplify/first_surface.h"
#include "simplify/hole_filling.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <memory>

namespace isoscope {

/// Where the improver works (core/README.md, N6).
enum class ImproverPlace : std::uint8_t {
  free,    ///< on Z alone: it leaves T first
  embedded ///< inside T: what keeps the embedding where Ω is no thickening
};

/// What to do after refinement, and how hard to try.
struct SimplificationParameters {
  Stage until = Stage::improve;            ///< the last stage
  std::array<bool, stage_count> skipped{}; ///< by Stage; tessellation cannot be skipped by later ones
  TargetStrategy target = TargetStrategy::constraints; ///< how targets are looked for in kernels
  CostRing ring = CostRing::one;                       ///< whose planes make the error
  int effort = 2;                                      ///< of the improver, 0 to 3; 3 never ends
  ImproverPlace improver = ImproverPlace::free;
  HoleChoice fill; ///< of open surfaces: what is filled, once the last stage inside T is done
  friend bool operator==(const SimplificationParameters&, const SimplificationParameters&) = default;
};

/// One simplification of one T. Everything it does goes to the recorder; after every operation from the
/// tessellation on the state holds a valid Z.
class Simplification {
 public:
  /// `volume` must outlive it; `complex` is T as refinement left it. With `first`, which makes the first Z,
  /// there is no T, and the improver alone runs on Z alone.
  Simplification(const ToleranceVolume& volume, SearchedSamples samples, const CriteriaParameters& criteria,
                 const SimplificationParameters& parameters, Recorder& recorder, const RunControl& control,
                 Complex complex, FirstSurfaceMaker first = {});
  ~Simplification();

  /// Before the first run(): collapses an edge as a person asked for, in a stage that the journal has begun,
  /// and goes on from there. `open`: that stage has not ended. Fails with usage where the check on the target
  /// that says no is named, or T has no such edge.
  Status begin_with(Stage stage, bool open, double seconds, VertexId a, VertexId b, Vec3 target);
  /// Before the first run(): begins with this stage, on T as it was when the stage began.
  void begin_at(Stage stage);
  /// Whether further rounds of the improver are possible: its stage has begun, and no holes are filled.
  bool can_go_on() const;
  /// Whether the next run() goes on with further rounds of the improver, without end, whatever the effort;
  /// can_go_on() must hold then.
  void go_on(bool further);
  /// Whether the run has come to what never ends: to be stopped there is its end.
  bool without_end() const;
  /// Once a run without end was stopped: what comes after the last stage.
  void finish();
  /// Runs the stages that are left; when told to stop it may be called again and goes on where it was. False
  /// when it was stopped. Fails with internal where the tessellation is impossible, else as `first`.
  Result<bool> run();
  const Complex& complex() const;
  const CriteriaParameters& criteria() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
