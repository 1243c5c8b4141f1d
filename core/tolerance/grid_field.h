// Ω given by a grid: where its trilinear function g lies between two levels (§1.1: "a tolerance volume ...
// given as input").
#pragma once

#include "base/status.h"
#include "tolerance/field.h"
#include "tolerance/value_range.h"

#include <memory>

namespace isoscope {

/// φ = max(0, max(g - hi, lo - g)/L + δ), where L is the steepest slope of g in and near Ω and δ = (hi -
/// lo)/2L: so φ is 1-Lipschitz, 0 halfway between the levels and δ on both. Farther than half the band from
/// Ω, g counts as flat. Sites are the cells of the band; points elsewhere have the site of a cell near them.
class GridField final : public ToleranceField {
 public:
  /// Fails with usage where the levels are in no order, with bad_input where no voxel lies beyond one of them
  /// or the band reaches the border of the grid, which it names.
  static Result<std::shared_ptr<const GridField>> make(std::shared_ptr<const ScalarGrid> grid, double low,
                                                       double high, const RunControl& control);

  double delta() const { return delta_; }
  /// L, in units of the values a unit of length.
  double slope() const { return slope_; }
  const ScalarGrid& grid() const { return *grid_; }

  FieldKind kind() const override { return FieldKind::grid; }
  std::size_t size() const override { return cell_of_site_.size(); }
  const Box3& bounds() const override { return bounds_; }
  double area() const override { return area_; }
  std::size_t memory_bytes() const override;
  ClosestPoint closest(Vec3 p) const override;
  ClosestPoint closest_near(Vec3 p, TriangleId guess) const override {
    static_cast<void>(guess);
    return closest(p);
  }
  ClosestPoint at_site(Vec3 p, TriangleId site) const override {
    static_cast<void>(site);
    return closest(p);
  }
  Vec3 place_of(TriangleId site) const override;
  Vec3 gradient(Vec3 p, const ClosestPoint& at) const override;
  std::optional<Range> range_in_cube(Vec3 center, double half_side) const override;
  std::optional<bool> meets_boundary(const Triangle3& facet) const override;
  int side(Vec3 p) const override;
  std::vector<Vec3> region_seeds() const override { return seeds_; }
  VolumeComponents components(double r, const RunControl& control) const override;

 private:
  GridField(std::shared_ptr<const ScalarGrid> grid, double low, double high, const RunControl& control);
  Status check_values() const;
  Status check_border();
  void measure(const RunControl& control);
  void collect_sites(const RunControl& control);
  void find_seeds(const RunControl& control);

  double phi(double g) const;
  /// ∇φ where g is not flat, else zero.
  Vec3 gradient(Vec3 p, const CellPosition& at, double g) const;
  std::size_t cell_index(const GridCell& c) const { return (c[2] * cells_[1] + c[1]) * cells_[0] + c[0]; }
  GridCell cell_at(std::size_t index) const {
    return {index % cells_[0], index / cells_[0] % cells_[1], index / (cells_[0] * cells_[1])};
  }
  template <class Visit> void for_each_cell(const RunControl& control, const Visit& visit) const;
  ValueRange range_on_piece(const Triangle3& piece, const Vec3& values) const;

  std::shared_ptr<const ScalarGrid> grid_;
  TrilinearFunction function_;
  ValuePyramid pyramid_;
  double low_, high_;
  double slope_ = 0, delta_ = 0, area_ = 0;
  double value_rounding_ = 0; ///< what a computed value may be off by
  int high_side_ = +1;        ///< F where g > hi: outside is what the border of the grid is
  std::array<std::size_t, 3> cells_{};
  std::vector<std::uint32_t> site_of_cell_, cell_of_site_;
  std::vector<Vec3> seeds_;
  Box3 bounds_;
};

} // namespace isoscope
