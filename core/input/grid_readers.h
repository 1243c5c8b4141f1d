// Reads grids of numbers: NRRD, raw data under a short header of our own, and OpenVDB where it was built in.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/file_scanner.h"
#include "input/scalar_grid.h"

#include <filesystem>
#include <string_view>

namespace isoscope {

/// Whether a file that begins so is a grid of a format that read_grid() reads.
bool is_grid(std::string_view head);
/// The same of a file; false where it cannot be read.
bool is_grid_file(const std::filesystem::path& file);

/// Reads a grid, by content. Fails with bad_input (file, place, remedy) on anything that is no whole grid of
/// finite numbers, with unsupported on kinds of NRRD and OpenVDB that are not read, with cancelled once the
/// control says so.
Result<ScalarGrid> read_grid(const std::filesystem::path& file, const RunControl& control);

// One reader a format; each throws MeshFileFailure.
ScalarGrid read_nrrd(FileScanner& in);
ScalarGrid read_raw_grid(FileScanner& in);
/// Fails with unsupported where the program was built without OpenVDB (ISOSCOPE_OPENVDB).
ScalarGrid read_vdb(FileScanner& in);

} // namespace isoscope
