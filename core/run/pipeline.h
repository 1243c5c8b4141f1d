// All stages of a run in one object: input, Ω, S, refinement, simplification, certificate. Both programs and
// the tests run this.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/input_note.h"
#include "input/triangle_soup.h"
#include "journal/recorder.h"
#include "refine/refinement.h"
#include "run/branch.h"
#include "run/certificate.h"
#include "run/crumbs.h"
#include "run/normal_deviation.h"
#include "run/parameters.h"
#include "run/point_field.h"
#include "tolerance/parameter_check.h"
#include "tolerance/sample_estimate.h"
#include "tolerance/thin_parts.h"
#include "tolerance/tolerance_volume.h"

#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// What is known about a run before its first operation; immutable once published.
struct Scene {
  std::shared_ptr<const TriangleSoup> input;   ///< as given, with the parts that the run leaves out
  std::vector<InputNote> notes;                ///< on reading it; `warnings` has them in words
  std::shared_ptr<const ToleranceField> field; ///< of the input without them
  std::shared_ptr<const PointField> points;    ///< where that is a field of points
  std::shared_ptr<const DeltaStudy> study;     ///< of its tolerances: of points, and where δ was found
  double delta = 0;                            ///< absolute
  double longest_edge = 0;
  std::shared_ptr<const ToleranceVolume> volume; ///< without its octree: what evaluations ask
  double default_sigma = 0.5;                    ///< σ/δ of this input in certified mode when none is given
  ToleranceThresholds thresholds;
  std::vector<Region> regions;
  std::vector<BoundaryComponent> boundary_components;
  std::vector<ThinPart> left_out; ///< parts of the input that Ω does not hold (RunParameters::drop_thin)
  InputTopology input_topology;   ///< without them
  ExpectedTopology expected;
  std::shared_ptr<const BoundarySamples> samples;
  SampleEstimate sample_estimate; ///< what other densities would take
  std::string thickening_note;
  std::vector<ParameterWarning> warnings;
  double input_seconds = 0, volume_seconds = 0, sampling_seconds = 0;
};

/// The genus that Z should have, where χ and the number of components are both asked for.
std::optional<double> expected_genus(const Scene& scene);

/// δ as it was asked for: "0.6%"; of an input that gives Ω the length itself.
std::string tolerance_text(const RunParameters& parameters, const Scene& scene);

/// How a run ended.
struct RunResult {
  enum class End { finished, stopped, limit };
  End end = End::finished;
  std::optional<Error>
      failure; ///< why the stages ended before the last one: then the mesh is what was reached
  RefinementOutcome refinement;
  TriangleMesh mesh;                      ///< Z
  Stage last_stage = Stage::refinement;   ///< the stage that was reached
  ZeroForm form = ZeroForm::interpolated; ///< free: the last stage ran on Z alone
  FilledHoles holes;                      ///< of the mesh
  Certificate certificate;
  NormalDeviation normals;
  SmallParts crumbs;                    ///< of Z, smaller than crumb_size δ
  std::optional<PointDistances> points; ///< to Z, where the input is points
  double seconds = 0;
  std::size_t peak_memory_bytes = 0;
  std::string branch;      ///< where it left another run and how; empty: it began at the beginning
  int exit_status() const; ///< 0 finished and certified, 1 not certified or not finished, 4 stopped
};

/// What becomes of parts that are thinner than 2δ everywhere where the parameters do not leave them out. A
/// recorded run is read as it was.
enum class ThinParts : std::uint8_t { refuse, accept };

class Pipeline {
 public:
  /// The journal starts empty and is filled by run().
  Pipeline(RunParameters parameters, std::shared_ptr<Journal> journal, Gate& gate, RunControl& control);
  ~Pipeline();

  /// Reads (or takes `soup` and the notes on it), builds Ω and S. Fails with bad_input, unsupported (also
  /// where Ω or S would take more memory than the limit, naming the σ that fits) or cancelled.
  Result<std::shared_ptr<const Scene>> prepare(std::shared_ptr<const TriangleSoup> soup = nullptr,
                                               std::vector<InputNote> notes = {},
                                               ThinParts thin = ThinParts::refuse);
  /// Where prepare() failed after the tolerances had been studied: what is known then, without volume and
  /// samples, so that another δ can be chosen, and with the proposed one; null otherwise.
  std::shared_ptr<const Scene> examined() const;
  /// After prepare() and instead of the refinement: writes to `journal`, which holds what the runs have in
  /// common (common_events), and collapses the branch's edge; run() goes on from there. A branch with
  /// parameters of its own is prepared with those of the journal's beginning (parameters_at_start); its run()
  /// first makes the journal's end once more, up to the decisions, which it takes from there, and then asks
  /// the gate for the new ones. With the old ones it goes on as the run that it left did, to the last bit.
  /// Fails with usage where that cannot be.
  Status branch(const BranchPoint& branch, std::shared_ptr<Journal> journal);
  /// Refines, simplifies, extracts Z, certifies. May be called again after the gate's parameters changed: it
  /// goes on where it was. Once the simplification has begun, σ and conditions 1, 2 and 4 are what they were.
  Result<RunResult> run();
  const RunParameters& parameters() const { return parameters_; }

 private:
  struct Impl;
  RunParameters parameters_;
  std::unique_ptr<Impl> impl_;
};

/// Fails with unsupported where so many samples take more than so many bytes, naming the σ that fits.
/// `sigma` and `delta` are absolute.
Status check_memory(const SampleEstimate& estimate, double sigma, double delta, double most_bytes);

} // namespace isoscope
