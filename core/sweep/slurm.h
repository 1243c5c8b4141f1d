// A sweep as a job array of Slurm.
#pragma once

#include "sweep/plan.h"

#include <string>
#include <vector>

namespace isoscope::sweep {

/// How the array is made of the runs.
struct ArrayPlan {
  std::vector<std::size_t> runs;    ///< those without a row, ascending
  std::size_t most_tasks = 1000;    ///< Slurm's own limit is 1001 where nobody changed it
  unsigned threads = 1;             ///< of a run
  std::vector<std::string> options; ///< for sbatch: "--partition=long"
};

/// The tasks that have something to do, as --array takes them: "0-3,7". Task K of T does the runs K, K + T, …
std::string array_tasks(const ArrayPlan& array, std::size_t runs);
/// The script; `program`: isoscope-sweep.
std::string array_script(const Folder& folder, const Plan& plan, const ArrayPlan& array,
                         const std::string& program);
/// Writes and submits it, and a job behind it that merges. Gives the array's job number. Fails with io where
/// there is no sbatch or it refuses; the script is there then.
Result<std::string> submit(const Folder& folder, const Plan& plan, const ArrayPlan& array,
                           const std::string& program);

} // namespace isoscope::sweep
