// Adds up what was proven tile by tile to the certificate of the whole.
#pragma once

#include "input/small_components.h"
#include "tiles/tile_proof.h"
#include "tolerance/ray_winding.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// In memory are, besides sums, the links between tiles, the witnesses and the measured normals.
class ProofSum {
 public:
  explicit ProofSum(ProofPlan plan) : plan_(std::move(plan)) {}
  /// In the order of the plan's tiles.
  void add(TileProof&& proof);

  /// Once all are there: counts on which sides of Z and of the input, which stands for the sides, the
  /// witnesses are. Reads both once. Fails with io, bad_input, cancelled.
  Status count_sides(const TileFolder& folder, const RunControl& control);

  /// Then: what all of it comes to.
  Certificate certificate(const ExpectedTopology& expected, double delta);
  NormalDeviation normals();
  /// Components of Z whose box is smaller than `size`.
  SmallParts small_parts(double size) const;
  std::uint64_t vertices() const { return vertices_; }
  std::uint64_t facets() const { return facets_; }

 private:
  ProofPlan plan_;
  bool closed_manifold_ = true, oriented_ = true;
  std::vector<std::string> failures_; ///< of the first tile that has some
  long euler_characteristic_ = 0;
  std::uint64_t vertices_ = 0, facets_ = 0;
  PartUnion parts_;
  std::size_t intersections_ = 0;
  std::optional<Vec3> intersection_;
  ContainmentFigures containment_;
  std::vector<Triangle3> outside_, undecided_;
  DistanceBounds input_distance_{0, 0, {}};
  Coverage coverage_{Coverage::Verdict::covered, {}, 0};
  std::vector<Vec3> points_; ///< that are to be witnesses
  std::vector<Witness> witnesses_;
  std::vector<double> winding_; ///< of Z, by witness
  std::vector<NormalMeasurement> normals_;
};

} // namespace isoscope
