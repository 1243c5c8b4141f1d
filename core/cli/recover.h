// isoscope-run recover: what is sound in a damaged recording becomes a recording of its own.
#pragma once

namespace isoscope {

/// The verb with its arguments, argv[0] being "recover"; returns the exit status.
int recover(int argc, char** argv);

} // namespace isoscope
