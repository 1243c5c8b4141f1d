// Everything a person can see of one step, computed once and immutable: T, Z, Γ, sample classes, conditions,
// what was touched.
#pragma once

#include "criteria/nearest_sample.h"
#include "journal/playback.h"
#include "mesh/zero_set.h"
#include "run/pipeline.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// Bits per tetrahedron slot.
enum TetFlag : std::uint8_t {
  tet_alive = 1,
  tet_box = 2,           ///< has a corner of the bounding box
  tet_heterogeneous = 4, ///< part of Γ: carries Z, or has a vertex on it
  tet_violates_1 = 8,    ///< holds a sample with ε > 1 − α
  tet_violates_2 = 16,   ///< carries Z and its height is below 2σ/α
  tet_violates_3 = 32,   ///< carries Z and is misoriented (only when SnapshotOptions::orientation)
  tet_changed = 64,      ///< made by one of the last `recent` operations
  tet_negative = 128     ///< on the negative side once Z is embedded (§2.4.2)
};

struct SnapshotOptions {
  bool orientation = false; ///< also judge condition 3 (costs eight nearest-sample queries a tetrahedron)
  Step recent = 1;          ///< how many operations back counts as changed
  std::optional<CriteriaParameters> criteria; ///< judge by these instead of those in force (live preview)
};

/// The state at one step. Indices: `tet_flags`, `heights` by tetrahedron slot; `errors` by sample.
struct StateSnapshot {
  Step step = 0;
  Complex complex;
  ZeroSet zero_set;
  std::vector<GammaFacet> gamma;
  std::shared_ptr<const BoundarySamples> samples; ///< may be null before the first set
  /// ε(s); bad when >= 1. Empty once Z has left T: the samples are no longer asked then.
  std::vector<float> errors;
  std::vector<TetId> sample_tets; ///< which tetrahedron holds each sample
  std::vector<std::uint8_t> tet_flags;
  std::vector<float> heights;      ///< of tetrahedra that carry Z, absolute; infinite for others
  CriteriaParameters criteria;     ///< what it was judged by
  bool orientation_judged = false; ///< by condition 3 too
  /// Whether there is an f that tells good samples from bad ones: not before T is there, nor once Z has left
  /// it.
  bool classifies() const { return complex.form != ZeroForm::free && !complex.tets.empty(); }
  std::size_t bad_samples = 0;   ///< ε >= 1
  std::size_t beyond_margin = 0; ///< ε > 1 − α
  std::size_t violating_2 = 0, violating_3 = 0;
  float largest_error = 0;
  SampleId worst_sample;
  /// The operation that led here (step − 1 -> step), absent at step 0.
  std::optional<Event> event;
  VertexId inserted;                             ///< the vertex it made
  std::vector<std::array<Vec3, 4>> removed_tets; ///< the conflict zone as it was
  std::vector<TetId> added_tets;
  /// Facets of Z that the operation took away and put there: tessellated Z, embedded or free.
  std::vector<Triangle3> removed_facets, added_facets;
  /// Vertices that it moved, from and to; a collapse moves its edge's ends to the target.
  struct Move {
    VertexId vertex;
    Vec3 before, after;
  };
  std::vector<Move> moves;
  std::optional<std::array<Vec3, 4>> violated_tet; ///< the tetrahedron the event names, as it was before
};

/// Moves the playback to `step` and describes it. `nearest` is needed for condition 3 only and may be null
/// otherwise. `previous`, a snapshot of the same journal, makes a near step cheap: only what lies between is
/// judged anew. The result does not depend on it.
std::shared_ptr<const StateSnapshot> make_snapshot(Playback& playback, Step step,
                                                   const SnapshotOptions& options,
                                                   const NearestSample* nearest,
                                                   const StateSnapshot* previous = nullptr);

/// How many samples or tetrahedra would violate each condition under other parameters, on a given state
/// (cheap: no journal), and which ones, ascending; those that are bad whatever the margin is are among the
/// ones beyond it.
struct ViolationPreview {
  std::size_t bad_samples = 0, beyond_margin = 0, too_flat = 0, misoriented = 0;
  std::vector<SampleId> samples;
  std::vector<TetId> flat_tets, misoriented_tets;
};
ViolationPreview preview_violations(const StateSnapshot& state, const CriteriaParameters& criteria,
                                    const NearestSample* nearest);

} // namespace isoscope
