// The verbs of isoscope-sweep; argv[0] is the verb. Each gives the exit status.
#pragma once

#include "base/status.h"
#include "sweep/work.h"

#include <filesystem>

namespace isoscope {

/// One run, or every so many, into a part of its own: what a task of an array does.
int sweep_step(int argc, char** argv);
/// The numbers of runs that have no row.
int sweep_missing(int argc, char** argv);
/// Parts into the table, the table into the page.
int sweep_merge(int argc, char** argv);
/// What differs between two sweeps: 0 nothing is worse, 1 something is.
int sweep_compare(int argc, char** argv);

/// The program itself and isoscope-run beside it; the other's bare name where it is not.
std::filesystem::path own_program();
std::filesystem::path run_program();
/// Fails with usage where it is no program, before all runs do.
Status check_program(const std::filesystem::path& program);
/// What came of all runs, as an exit status: 0 all are certified, 1 some are not, 4 some are missing.
int sweep_status(const sweep::Plan& plan, const std::map<std::size_t, sweep::Row>& rows);
/// Merges, writes the page and says what came of it.
int finish_sweep(const sweep::Folder& folder, const sweep::Plan& plan, bool quiet);

} // namespace isoscope
