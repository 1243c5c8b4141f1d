// OpenVDB: sparse grids. The first one of floats becomes a dense grid around its active voxels, in the units
// of the world that its transform leads to.
#include "base/pending_file.h"
#include "input/grid_data.h"
#include "input/grid_readers.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <cmath>

namespace isoscope {
namespace {

/// Voxels of the background around the active ones: what Ω must not reach.
constexpr int background_voxels = 2;
constexpr int longest_axis = 1 << 20;
/// What an axis may lean by, relatively.
constexpr double straight_axis = 1e-6;

[[noreturn]] void fail_without_floats(const FileScanner& in, const std::string& others) {
  in.fail("holds no grid of floats" + (others.empty() ? std::string() : ": its grids are " + others),
          "Export a level set or a fog volume.", ErrorCode::unsupported);
}

openvdb::FloatGrid::Ptr first_floats(const FileScanner& in, openvdb::io::File& file) {
  std::string others;
  for (auto name = file.beginName(); name != file.endName(); ++name) {
    const auto about = file.readGridMetadata(name.gridName());
    if (about->isType<openvdb::FloatGrid>())
      return openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(name.gridName()));
    others += (others.empty() ? "" : ", ") + printable(name.gridName()) + " (" + about->valueType() + ")";
  }
  fail_without_floats(in, others);
}

Vec3 to_vec3(const openvdb::Vec3d& v) {
  return {v.x(), v.y(), v.z()};
}

ScalarGrid densely(const FileScanner& in, const openvdb::FloatGrid& floats) {
  openvdb::CoordBBox box = floats.evalActiveVoxelBoundingBox();
  if (box.empty()) in.fail("holds a grid without an active voxel", export_anew);
  box.expand(background_voxels);
  ScalarGrid grid;
  for (int a = 0; a < 3; ++a) {
    const double extent = static_cast<double>(box.max()[a]) - box.min()[a] + 1;
    if (!(extent <= longest_axis))
      in.fail("has active voxels too far apart for a dense grid", "Crop or resample the grid.");
    grid.size[static_cast<std::size_t>(a)] = static_cast<std::size_t>(extent);
  }
  const std::uint64_t count = std::uint64_t{grid.size[0]} * grid.size[1] * grid.size[2];
  in.check_count(count, "numbers", 0, sizeof(float));

  const openvdb::math::Transform& transform = floats.transform();
  grid.origin = to_vec3(transform.indexToWorld(box.min()));
  for (int a = 0; a < 3; ++a) {
    openvdb::Coord next = box.min();
    ++next[a];
    const Vec3 step = to_vec3(transform.indexToWorld(next)) - grid.origin;
    grid.spacing[a] = step[a];
    for (int other = 0; other < 3; ++other)
      if (other != a && !(std::abs(step[other]) <= straight_axis * std::abs(step[a])))
        in.fail("has axes that are oblique in space", "Resample it along the axes.", ErrorCode::unsupported);
    if (!transform.isLinear() || step[a] < 0)
      in.fail("has a transform that is more than a scale and a shift", "Resample it along the axes.",
              ErrorCode::unsupported);
  }

  grid.values.resize(count);
  openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, grid.values.data());
  openvdb::tools::copyToDense(floats, dense);
  for (const float v : grid.values)
    if (!std::isfinite(v)) in.fail("holds a value that is not finite", "Replace such values.");
  return grid;
}

} // namespace

ScalarGrid read_vdb(FileScanner& in) {
  try {
    openvdb::initialize();
    openvdb::io::File file(in.file().string());
    file.open(false);
    const auto floats = first_floats(in, file);
    if (in.control().cancelled()) in.fail("was left while it was read", {}, ErrorCode::cancelled);
    ScalarGrid grid = densely(in, *floats);
    grid.name = in.file().stem().string();
    if (!floats->getName().empty()) grid.name += " " + printable(floats->getName());
    return grid;
  } catch (const openvdb::Exception& e) {
    in.fail("cannot be read by OpenVDB: " + printable(e.what(), 200), export_anew);
  }
}

} // namespace isoscope
