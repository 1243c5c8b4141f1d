// What comes before the first operation of a run: its input, its δ, Ω and S.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "criteria/nearest_sample.h"
#include "input/input_note.h"
#include "input/triangle_soup.h"
#include "run/asymptotic_count.h"
#include "run/parameters.h"
#include "run/point_field.h"
#include "tolerance/parameter_check.h"
#include "tolerance/point_sheets.h"
#include "tolerance/sample_estimate.h"
#include "tolerance/thin_parts.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// How much there is of a mesh.
struct MeshSize {
  std::size_t vertices = 0, triangles = 0;
};

/// What is known about a run before its first operation; immutable once published. Of a run in tiles, which
/// has neither input nor Ω in memory, what says so below is null.
struct Scene {
  std::shared_ptr<const TriangleSoup> input;   ///< as given, with the parts that the run leaves out; or null
  std::vector<InputNote> notes;                ///< on reading it; `warnings` has them in words
  MeshSize input_size;                         ///< of it
  std::shared_ptr<const ToleranceField> field; ///< of the input without them; or null
  std::shared_ptr<const PointField> points;    ///< where that is a field of points
  std::optional<PointSheets> sheets;           ///< of points and loose triangles that are of an open surface
  std::shared_ptr<const DeltaStudy> study;     ///< of its tolerances: of points, and where δ was found
  double delta = 0;                            ///< absolute
  double longest_edge = 0;
  std::shared_ptr<const ToleranceVolume> volume; ///< without its octree: what evaluations ask; or null
  std::size_t held = 0;                          ///< points in thin parts that Z keeps on their side
  double default_sigma = 0.5;                    ///< σ/δ of this input in certified mode when none is given
  ToleranceThresholds thresholds;
  std::vector<Region> regions;
  std::vector<BoundaryComponent> boundary_components;
  std::vector<ThinPart> left_out; ///< parts of the input that Ω does not hold (RunParameters::drop_thin)
  InputTopology input_topology;   ///< without them
  ExpectedTopology expected;
  std::shared_ptr<const BoundarySamples> samples;
  SampleEstimate sample_estimate;         ///< what other densities would take
  std::optional<AsymptoticCount> optimum; ///< where it can be told
  std::string thickening_note;
  std::vector<ParameterWarning> warnings;
  double input_seconds = 0, volume_seconds = 0, sampling_seconds = 0;
};

/// The genus that Z should have, where χ and the number of components are both asked for.
std::optional<double> expected_genus(const Scene& scene);

/// δ as it was asked for: "0.6%"; of an input that gives Ω the length itself.
std::string tolerance_text(const RunParameters& parameters, const Scene& scene);

/// What becomes of parts that are thinner than 2δ everywhere where the parameters do not leave them out. A
/// recorded run is read as it was.
enum class ThinParts : std::uint8_t { refuse, accept };

/// Reads the input of a run, finds δ, builds Ω and S.
class Preparation {
 public:
  /// Both must outlive it.
  Preparation(const RunParameters& parameters, RunControl& control)
      : parameters_(parameters), control_(control) {}
  /// Is called by make() with the input as soon as it is read.
  using Read = std::function<void(std::shared_ptr<const TriangleSoup>)>;
  void on_read(Read read) { read_ = std::move(read); }
  /// Once. See Pipeline::prepare().
  Result<std::shared_ptr<const Scene>> make(std::shared_ptr<const TriangleSoup> soup,
                                            std::vector<InputNote> notes, ThinParts thin);
  /// See Pipeline::examined().
  std::shared_ptr<const Scene> examined() const { return examined_; }
  /// Ω with its octree; after make().
  ToleranceVolume& volume() { return *volume_; }
  /// S with what finds the nearest of its samples; once after make().
  SearchedSamples take_samples() { return *std::exchange(samples_, std::nullopt); }
  /// S at another density, absolute. Fails with unsupported where that takes more memory than it may, or with
  /// what sample_boundary() says.
  Result<std::shared_ptr<const BoundarySamples>> sample(SampleDensity density);
  /// What is wrong with the input; when it is open, with the tolerance that would close it.
  Error refused(Error error, const Scene& at) const;
  /// What a run found after its refinement, with what a smaller tolerance would come to.
  Error refused_after_refinement(Error error, const Scene& at) const;

 private:
  bool few_samples_do() const;
  double default_sigma(double delta) const;
  double flat_sigma(double sigma) const;
  ToleranceVolume::Options volume_options(double delta) const;
  Status make_field(Scene& made, const std::shared_ptr<const TriangleSoup>& kept,
                    std::optional<double> delta);
  void use_points(Scene& made) const;
  Result<double> find_delta(Scene& made, const std::shared_ptr<const TriangleSoup>& soup);
  std::vector<double> sheet_gammas() const;
  Status build_volume_of_sheets(Scene& made, const std::shared_ptr<const TriangleSoup>& soup);
  Result<double> find_sheet_delta(Scene& made);
  Status settle_points(Scene& made);
  Status open_sheets(Scene& made, ToleranceVolume& volume, const std::vector<std::uint8_t>& sheets) const;
  Status build_volume(Scene& made, std::shared_ptr<const TriangleSoup> kept, ThinParts thin);
  Status build_volume_of_points(Scene& made, const std::shared_ptr<const TriangleSoup>& soup);
  void examine(const Scene& made);
  void count_joined(Scene& made, const CriteriaParameters& criteria) const;
  void hold_thin_parts(const CriteriaParameters& criteria);
  void warn(Scene& made, const CriteriaParameters& criteria) const;

  const RunParameters& parameters_;
  RunControl& control_;
  Read read_;
  std::shared_ptr<const Scene> examined_;
  std::optional<ToleranceVolume> volume_;
  std::optional<SearchedSamples> samples_;
  MadePointField points_; ///< where the field is one of points
  double kept_area_ = 0;  ///< of the input without what is left out
};

} // namespace isoscope
