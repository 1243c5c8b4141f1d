// A tile's part of Z and of the input as meshes, and what the improver asks of Ω there.
#pragma once

#include "base/run_control.h"
#include "improve/improver.h"
#include "input/triangle_soup.h"
#include "tiles/tile_folder.h"
#include "tiles/tile_grid.h"
#include "tolerance/closest_point.h"

#include <algorithm>
#include <vector>

namespace isoscope {

/// In δ: repairs look no farther, and what is farther from a tile matters to nothing in it.
constexpr double tile_input_reach = 3;

/// Points in ascending order, facets in the order of their corners: the same for the same facets.
TriangleMesh mesh_of(std::vector<Triangle3> facets);
TriangleSoup soup_of(std::vector<Triangle3> facets);
/// The same triangles in the same order, which is all that distances ask for.
ClosestPointIndex index_of(std::vector<Triangle3> facets, const RunControl& control);
std::vector<Triangle3> facets_of(const TriangleMesh& mesh);
std::vector<Triangle3> facets_of(const TriangleSoup& soup);

/// Leaves those whose boxes meet the box.
void keep_meeting(std::vector<Triangle3>& facets, const Box3& box);
/// Leaves those that a tile writes: whose lowest vertex is in one of its bricks.
void keep_own(std::vector<Triangle3>& facets, const TileGrid& grid, const Tiling& tiling,
              const GridPlace& tile);

/// The points in a tile that Z keeps on their side: a component of {d > δ} that Z could pass by changes in
/// the tile lies in it, and so does its witness.
std::vector<Vec3> kept_points(const TileManifest& manifest, const ChangeBox& box);

/// Ω in a tile, from the input within reach of it.
class TileGround {
 public:
  /// `kept`: points in the box that Z keeps on their side. Of no use once the control is cancelled.
  /// `memory`: bytes that the tile may take in all.
  TileGround(std::vector<Triangle3> input, double delta, std::vector<Vec3> kept, const ChangeBox& box,
             double memory, const RunControl& control)
      : index_(index_of(std::move(input), control)), delta_(delta), kept_(std::move(kept)), box_(box),
        most_cell_bytes_(
            static_cast<std::size_t>(std::min(share_of_cells * memory, double(NearestCells::most_bytes)))) {}
  ImproverGround ground() const { return {index_, delta_, kept_, nullptr, box_, most_cell_bytes_}; }

 private:
  static constexpr double share_of_cells = 0.125; ///< of a tile's memory
  ClosestPointIndex index_;
  double delta_;
  std::vector<Vec3> kept_;
  ChangeBox box_;
  std::size_t most_cell_bytes_;
};

/// What the improver is asked for in a tile: condition 3 asks samples, which tiles have not.
ImproverOptions tile_options(const CriteriaParameters& criteria, int effort);

} // namespace isoscope
