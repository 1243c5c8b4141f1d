// isoscope-run replay: what a recording holds, and the proof that it replays.
#pragma once

namespace isoscope {

/// `argv[0]` is "replay". The exit status: that of the recorded run (0, 1, 4; 4 also for one that was cut
/// short), with --check 0 when it replays and 1 when it does not; 2 usage, 3 a file that cannot be read.
int replay(int argc, char** argv);

} // namespace isoscope
