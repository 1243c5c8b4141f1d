// Tells the formats of grids apart and judges what their readers give.
#include "input/grid_readers.h"

#include "base/pending_file.h"
#include "input/grid_data.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr std::string_view raw_magic = "isoscope-grid", nrrd_magic = "NRRD", vdb_magic{" BDV\0\0\0\0", 8};

/// Refuses what no field can be made of, whatever the format.
void check(const FileScanner& in, const ScalarGrid& grid) {
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (grid.size[axis] < 2) in.fail("has only one sample along an axis", "Give a volume.");
    if (!(grid.spacing[a] > 0)) in.fail("has a spacing that is not positive", "Correct its spacings.");
  }
  const Box3 box = grid.box();
  const Vec3 e = box.extent();
  double largest = 0;
  for (int a = 0; a < 3; ++a) largest = std::max({largest, std::abs(box.lo[a]), std::abs(box.hi[a])});
  if (!(largest <= 1e60) || !(std::min({e.x, e.y, e.z}) >= 1e-60))
    in.fail("has coordinates too large or too small to compute with", "Rescale its spacings and its origin.");
  if (!(std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}) > 1e-9 * largest))
    in.fail("lies so far from the origin that its voxels are lost in rounding",
            "Move its origin nearer to 0.");
}

} // namespace

bool is_grid(std::string_view head) {
  return head.starts_with(raw_magic) || head.starts_with(nrrd_magic) || head.starts_with(vdb_magic);
}

bool is_grid_file(const std::filesystem::path& file) {
  try {
    const RunControl control;
    FileScanner in(file, control);
    return is_grid(in.head());
  } catch (const MeshFileFailure&) {
    return false; // whoever reads it says why
  }
}

Result<ScalarGrid> read_grid(const std::filesystem::path& file, const RunControl& control) {
  return scan_file(file, control, "Crop or resample the grid.", [](FileScanner& in) {
    const std::string_view head = in.head();
    if (!is_grid(head))
      in.fail("is in no format of grids that we know",
              "Give a NRRD file, or raw data with a header: README.md tells how.");
    ScalarGrid grid = head.starts_with(nrrd_magic)  ? read_nrrd(in)
                      : head.starts_with(vdb_magic) ? read_vdb(in)
                                                    : read_raw_grid(in);
    check(in, grid);
    return grid;
  });
}

} // namespace isoscope
