// All stages of a run in one object: input, Ω, S, refinement, simplification, certificate. Both programs and
// the tests run this.
#pragma once

#include "journal/recorder.h"
#include "refine/refinement.h"
#include "run/branch.h"
#include "run/certificate.h"
#include "run/crumbs.h"
#include "run/normal_deviation.h"
#include "run/preparation.h"
#include "run/vertex_curve.h"

#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// How a run ended.
struct RunResult {
  enum class End { finished, stopped, limit };
  End end = End::finished;
  std::optional<Error>
      failure; ///< why the stages ended before the last one: then the mesh is what was reached
  RefinementOutcome refinement;
  TriangleMesh mesh;                      ///< Z
  std::optional<MeshSize> streamed;       ///< of a Z that went to its file piece by piece: then mesh is empty
  Stage last_stage = Stage::refinement;   ///< the stage that was reached
  ZeroForm form = ZeroForm::interpolated; ///< free: the last stage ran on Z alone
  FilledHoles holes;                      ///< of the mesh
  Certificate certificate;
  NormalDeviation normals;
  SmallParts crumbs;                    ///< of Z, smaller than crumb_size δ
  std::optional<PointDistances> points; ///< to Z, where the input is points
  std::vector<CurvePoint> curve;        ///< its vertices over the seconds
  double seconds = 0;
  std::size_t peak_memory_bytes = 0;
  bool without_end = false; ///< the improver does not end by itself: to be stopped there is how it ends
  bool can_go_on = false;   ///< Pipeline::go_on() is possible
  std::string branch;       ///< where it left another run and how; empty: it began at the beginning
  MeshSize size() const { return streamed.value_or(MeshSize{mesh.points.size(), mesh.triangles.size()}); }
  /// Whether the cut at the rim found out that this input is not worked on at this tolerance: the mesh is no
  /// result. What another stage fails at leaves what there is of Z.
  bool refused() const { return failure && last_stage == Stage::rim && refuses_input(failure->code); }
  /// 0 finished, or stopped where it never ends, and certified; 1 not certified or not finished; 3 refused;
  /// 4 stopped.
  int exit_status() const;
};

class Pipeline {
 public:
  /// The journal starts empty and is filled by run().
  Pipeline(RunParameters parameters, std::shared_ptr<Journal> journal, Gate& gate, RunControl& control);
  ~Pipeline();

  /// Before prepare(): is called from it with the input as soon as it is read.
  void on_read(Preparation::Read read);
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
  /// The next run() goes on with further rounds of the improver until it is stopped. Fails with usage where
  /// its stage was not reached, or where holes were filled after it.
  Status go_on();
  const RunParameters& parameters() const { return parameters_; }

 private:
  struct Impl;
  RunParameters parameters_;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
