// What two tables of runs differ in.
#pragma once

#include "sweep/run_table.h"

#include <string>
#include <vector>

namespace isoscope::sweep {

struct Comparison {
  std::vector<std::string> worse, better, notes; ///< sentences that begin with model and tolerance
  std::size_t compared = 0;
  std::vector<double> vertices, seconds; ///< new over old, of runs that have both
  double speed = 1; ///< median of new seconds over old: how this machine compares with the table's
};

/// Runs that both tables have: another outcome, lost lines of the certificate, a fifth more time than the
/// median would have it, a fifth more vertices or distance.
Comparison compare(const std::vector<Row>& old_rows, const std::vector<Row>& new_rows);

} // namespace isoscope::sweep
