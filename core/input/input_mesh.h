// A mesh file read for a run: obeys the control, and tells what it had to decide.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/input_note.h"
#include "input/triangle_soup.h"

#include <filesystem>
#include <vector>

namespace isoscope {

/// What read_mesh gives, with the notes for the user.
struct InputMesh {
  TriangleSoup soup;
  std::vector<InputNote> notes;
};

/// The same as read_mesh; fails with cancelled too, once the control says so.
Result<InputMesh> read_input_mesh(const std::filesystem::path& file, const RunControl& control);

} // namespace isoscope
