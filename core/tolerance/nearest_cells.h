// Closest points from cells of space that list the few triangles their points can be nearest to: many queries
// of one region, as the improver's, without a walk down the hierarchy (core/README.md, D2).
#pragma once

#include "tolerance/closest_point.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// The distance to the triangles of an index, answered from cubic cells that are made when they are first
/// asked. Answers are the index's to the last bit, of several triangles at the same distance that with the
/// smallest id: they depend on the point alone. Queries are thread-safe.
class NearestCells final : public ToleranceField {
 public:
  /// Cells hold at most this many bytes; points of others are looked up in the index.
  static constexpr std::size_t most_bytes = std::size_t{256} << 20;

  /// `side`: of a cell; cells that would list too many triangles are divided.
  NearestCells(const ClosestPointIndex& index, double side, std::size_t byte_limit = most_bytes);
  ~NearestCells() override;
  NearestCells(const NearestCells&) = delete;
  NearestCells& operator=(const NearestCells&) = delete;

  ClosestPoint closest(Vec3 p) const override { return from_cell(p, ClosestPoint{}); }
  ClosestPoint closest_within(Vec3 p, double radius) const override {
    return index_->closest_within(p, radius);
  }
  ClosestPoint closest_near(Vec3 p, TriangleId guess) const override {
    return from_cell(p, guess.valid() ? at_site(p, guess) : ClosestPoint{});
  }
  ClosestPoint closest_near(Vec3 p, const ClosestPoint& found, double) const override {
    return from_cell(p, found);
  }
  void find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const override {
    index_->find_neighborhood(center, radius, near);
  }
  ClosestPoint closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                            double enough = 0) const override {
    return index_->closest_near(p, guess, near, enough);
  }

  FieldKind kind() const override { return index_->kind(); }
  std::size_t size() const override { return index_->size(); }
  const Box3& bounds() const override { return index_->bounds(); }
  double area() const override { return index_->area(); }
  std::size_t memory_bytes() const override { return bytes_.load(std::memory_order_relaxed); }
  ClosestPoint at_site(Vec3 p, TriangleId site) const override { return index_->at_site(p, site); }
  double convex_bound(const Triangle3& facet, TriangleId site) const override {
    return index_->convex_bound(facet, site);
  }
  Vec3 place_of(TriangleId site) const override { return index_->place_of(site); }
  bool is_distance() const override { return true; }
  VolumeComponents components(double r, const RunControl& control) const override {
    return index_->components(r, control);
  }
  const ClosestPointIndex* surface() const override { return index_; }

 private:
  struct Group;
  struct Cell;
  struct Place;
  /// From what some triangle gives at p, or nothing yet.
  ClosestPoint from_cell(Vec3 p, const ClosestPoint& found) const;
  /// The cell that holds p, with p's offset from its centre; null where there is none.
  const Cell* find(Vec3 p, Vec3& step) const;
  const Cell* made(const Place& place, std::atomic<Cell*>& bucket) const;
  std::vector<Group> triangles_of(Vec3 center, double half_side) const;

  const ClosestPointIndex* index_;
  Vec3 lo_;
  double side_, inverse_side_ = 0, rounding_ = 0;
  Vec3 cells_; ///< by axis: how many
  std::size_t byte_limit_;
  mutable std::atomic<std::size_t> bytes_{0};
  mutable std::vector<std::atomic<Cell*>> buckets_;
};

} // namespace isoscope
