// isoscope-run diff: what differs between two recorded runs.
#pragma once

namespace isoscope {

/// `argv[0]` is "diff". The exit status, as that of diff(1): 0 when the runs are the same, 1 when they
/// differ, 2 for wrong usage and files that cannot be read.
int diff(int argc, char** argv);

} // namespace isoscope
