// Doing the runs of a plan: those that have no row yet, here, or a part of them anywhere.
#pragma once

#include "sweep/plan.h"

#include <functional>

namespace isoscope::sweep {

/// Of the table and of all parts, one row a run, by the number of the run. Rows that the plan does not ask
/// for are left out.
Result<std::map<std::size_t, Row>> gather_rows(const Folder& folder, const Plan& plan);
/// Those of the table and of one part alone.
Result<std::map<std::size_t, Row>> rows_with_part(const Folder& folder, const Plan& plan, std::size_t part);
/// Runs without a row, ascending.
std::vector<std::size_t> missing_runs(const Plan& plan, const std::map<std::size_t, Row>& rows);

struct Doing {
  std::filesystem::path program; ///< isoscope-run
  unsigned jobs = 1;             ///< runs at a time
  /// Called one at a time once a run has its line.
  std::function<void(std::size_t run, const Row& row)> done;
};
/// Does these runs, appending each to the table as soon as it has ended, with its mesh and its picture. Ends
/// early, with all processes, where the control is cancelled. Fails with io.
Status do_runs(const Folder& folder, const Plan& plan, const std::vector<std::size_t>& runs,
               const std::filesystem::path& table, const Doing& doing, const RunControl& control);

/// Brings all rows into the table, in the order of the runs, and takes the parts away. Nothing may be
/// running.
Result<std::map<std::size_t, Row>> merge(const Folder& folder, const Plan& plan);

} // namespace isoscope::sweep
