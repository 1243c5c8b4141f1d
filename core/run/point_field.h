// The field of points: robust distance, the study of its tolerances, and what is left out of it.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "run/parameters.h"
#include "tolerance/delta_study.h"
#include "tolerance/tolerance_volume.h"
#include "tolerance/weighted_points.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// Points that no site stands for, as they are not of the surface.
struct DroppedPoints {
  enum class Why : std::uint8_t {
    outliers, ///< far from others: φ at them exceeds δ
    blob      ///< a part of Ω' of their own that encloses nothing
  };
  Why why = Why::outliers;
  std::size_t points = 0;
  Vec3 place;            ///< of one of them
  double size = 0;       ///< longest edge of their box, or of that of the largest part
  std::size_t parts = 1; ///< small blobs are told together
};

/// What a run knows of points. Immutable once the scene is published.
struct PointField {
  /// Those of the input, or drawn from its triangles.
  std::shared_ptr<const TriangleSoup> points;
  bool drawn = false;
  std::size_t neighbors = 0;        ///< k; 1: the plain distance
  bool automatic = false;           ///< k was chosen by the share of outlying points
  double outlying = 0;              ///< that share
  DeltaStudy study;                 ///< of all sites
  std::vector<std::uint32_t> point; ///< by site of the field, ascending; empty: site i is of point i
  std::vector<DroppedPoints> dropped;

  std::size_t dropped_points() const;
  /// "Robust distance with k = 12 ...": what was found, a sentence each.
  /// `open`: the points are taken for an open surface.
  std::vector<std::string> notes(double delta, double longest_edge, bool open) const;
  /// By point: whether some site stands for it.
  std::vector<bool> kept() const;
};

/// Sites that stand for nothing any more.
struct LeftOutSites {
  std::vector<std::uint32_t> points; ///< by site
  std::vector<WeightedPoint> sites;
  double area = 0; ///< of all, with those that are kept
};

/// Points with the index of their sites.
struct MadePointField {
  std::shared_ptr<PointField> points;
  std::shared_ptr<const WeightedPointIndex> index;
  LeftOutSites left_out;
};

/// Whether the field of this input is one of points.
bool is_field_of_points(const TriangleSoup& input, const RunParameters& parameters);

/// Finds the sites and studies them. `delta`, where it is given, is how fine triangles are sampled. Of no use
/// once the control is cancelled.
MadePointField make_point_field(const std::shared_ptr<const TriangleSoup>& input,
                                const RunParameters& parameters, std::optional<double> delta,
                                const RunControl& control);

/// Without the sites that give no point with φ < δ, and without the parts of {φ <= boundary} that are of a
/// few balls, too few to enclose anything deep: told apart before Ω is built, as there may be hundreds around
/// noisy points.
MadePointField without_strays(const MadePointField& from, double delta, double boundary,
                              const RunControl& control);

/// With all that was left out of it, for another δ.
MadePointField with_all_sites(const MadePointField& from, const RunControl& control);

/// Without the parts of Ω' that have regions of one side only and less than a twentieth of the sites; the
/// same index where there are none. Where larger ones are no sheets, fails with open_surface, naming the
/// place, and where nothing is inside.
Result<MadePointField> without_blobs(const MadePointField& from, const ToleranceVolume& volume,
                                     bool may_be_sheets, const RunControl& control);

/// Where the study saw Ω enclose something: what is advised where it does not.
std::string enclosing_remedy(const DeltaStudy& study);
/// What is said where it does at none of the δ that were tried.
Error nothing_inside_between(double least, double most);

/// A 1 by component of Ω' for those that have regions of one side only.
std::vector<std::uint8_t> sheets_among(const ToleranceVolume& volume);

/// δ by the study, with its own words where there is none that suits.
Result<double> proposed_tolerance(const DeltaStudy& study);

/// The distances of points to a mesh.
struct PointDistances {
  struct Quantiles {
    double median = 0, percentile_90 = 0, percentile_99 = 0, most = 0;
  };
  Quantiles all, kept; ///< with and without those that no site stands for
  std::size_t far = 0; ///< kept ones farther than the limit
  Vec3 farthest;       ///< the kept one with the largest distance
};
/// `limit`: how far a point may be; beyond it it is counted. Nothing where there is no mesh, and once the
/// control is cancelled.
std::optional<PointDistances> measure_points(const PointField& points, const TriangleMesh& mesh, double limit,
                                             const RunControl& control);

} // namespace isoscope
