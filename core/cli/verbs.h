// The verbs of the batch program; argv[0] is the verb. Each gives the exit status.
#pragma once

namespace isoscope {

/// What a recording holds, and the proof that it replays. The exit status is that of the recorded run (0, 1,
/// 4; 4 also for one that was cut short), with --check 0 when it replays and 1 when it does not; 2 usage, 3 a
/// file that cannot be read.
int replay(int argc, char** argv);
/// What differs between two recorded runs. As diff(1): 0 when they are the same, 1 when they differ, 2 for
/// wrong usage and files that cannot be read.
int diff(int argc, char** argv);
/// A run in tiles, in parts: cut, step, rerun, join, status.
int tiles(int argc, char** argv);
/// What is sound in a damaged recording becomes a recording of its own.
int recover(int argc, char** argv);

} // namespace isoscope
