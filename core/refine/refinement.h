// Refines T until Z separates the boundaries of Ω and has the right topology (§2.3), as journalled
// operations.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "criteria/nearest_sample.h"
#include "criteria/topology.h"
#include "journal/recorder.h"
#include "tolerance/tolerance_volume.h"

#include <functional>
#include <memory>

namespace isoscope {

/// How far refinement may go before it reports what it could not do.
struct RefinementLimits {
  std::size_t insertions = 0;              ///< 0: derived from the number of samples and the spacing bounds
  std::size_t topology_insertions = 20000; ///< for mending handles and components (condition 4)
};

/// What came out.
struct RefinementOutcome {
  enum class End { finished, stopped, limit, open_input };
  End end = End::finished;
  Vec3 open_at;            ///< open_input: a place outside of Ω' that is on both sides
  bool classified = false; ///< condition 1 holds
  bool contained = false;  ///< certified mode: every zero polygon proven inside Ω
  bool witnessed = false;  ///< f has the right sign at every region's deepest point
  TopologyVerdict topology;
  std::size_t unmet_height = 0;      ///< exhausted tetrahedra that still violate condition 2 (sampled mode)
  std::size_t unmet_orientation = 0; ///< the same for condition 3
  std::size_t uncertified = 0;       ///< zero polygons that could not be proven inside Ω
  std::size_t sample_moves = 0;      ///< how often a sample changed its tetrahedron
};

/// What Z in T would have, were it cut along the rim of an open surface.
using TrialCut = std::function<TopologyVerdict(const Complex&)>;

/// One refinement of one Ω. Owns T; everything it does goes to the recorder. run() may be called again after
/// it ended, with changed parameters (the gate's): it goes on from the present T. During the recorder's
/// rehearsal run() first does what the journal says, without judging anything, and so comes to the state that
/// the followed run had there: T to the last slot, what was given up, how far the mending of the topology is.
class Refinement {
 public:
  /// `volume` must outlive the refinement. `samples` is set 0 of the journal. `trial`: by which an open
  /// surface is held against what is expected.
  Refinement(ToleranceVolume& volume, SearchedSamples samples, const CriteriaParameters& criteria,
             const ExpectedTopology& expected, const RefinementLimits& limits, Recorder& recorder,
             const RunControl& control, TrialCut trial = {});
  ~Refinement();

  /// Runs until the conditions hold, nothing more can be done, the gate stops it, or the control is
  /// cancelled.
  RefinementOutcome run();
  /// Replaces S (σ changed); T stays. Recorded as an operation.
  void replace_samples(std::shared_ptr<const BoundarySamples> samples);

  const Complex& complex() const;
  /// S as it is now.
  const SearchedSamples& samples() const;
  const CriteriaParameters& criteria() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
