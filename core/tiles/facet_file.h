// Files of facets by brick: what tiles read and write.
#pragma once

#include "base/geometry.h"
#include "base/status.h"
#include "tiles/tile_grid.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace isoscope {

/// A box that meets everything.
constexpr Box3 all_of_space{{-Box3::inf, -Box3::inf, -Box3::inf}, {Box3::inf, Box3::inf, Box3::inf}};

/// The facets of one brick in a file: those whose lowest vertex, by x, then y, then z, lies in it.
struct BrickEntry {
  GridPlace brick{};
  std::uint32_t count = 0;
  std::uint64_t first = 0; ///< of them among the file's facets
  Box3 box;                ///< of all of them
};

/// A facet with its lowest vertex first, the way round it had.
Triangle3 canonical(const Triangle3& facet);
/// The order of their corners, for facets in canonical form.
bool comes_before(const Triangle3& a, const Triangle3& b);
/// Puts facets in canonical form and in that order.
void make_canonical(std::vector<Triangle3>& facets);

/// Writes facets, which become canonical, by brick; the same bytes for the same facets, whatever their order.
/// What stands at the place is replaced at once, when all is on the disk. Fails with io.
Status write_facets(const std::filesystem::path& file, const TileGrid& grid, std::vector<Triangle3> facets);
/// The bricks of a file, ascending. Fails with io, or bad_input where the file is no such file or damaged.
Result<std::vector<BrickEntry>> read_bricks(const std::filesystem::path& file);
/// All facets of a file, brick by brick, some at a time in memory. Fails as read_bricks().
Status each_facet(const std::filesystem::path& file, const std::function<void(const Triangle3&)>& take);
/// Adds the facets of those bricks whose box meets `box`. Fails as read_bricks().
Status read_facets(const std::filesystem::path& file, const Box3& box, std::vector<Triangle3>& facets);

} // namespace isoscope
