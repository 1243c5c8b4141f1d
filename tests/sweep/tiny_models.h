// Models with known answers, programs in place of isoscope-run, and the sweep's program itself, for tests.
#pragma once

#include "input/temporary_folder.h"
#include "sweep/run_table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace isoscope::test {

/// A box as OFF, its corners at 0 and these.
std::string box(double x, double y, double z);
/// A square ring, a torus: χ = 0.
std::string ring();
/// A folder models with a box, a ring in a folder, a file that is no mesh, and others that are no models.
std::filesystem::path make_models(const TemporaryFolder& folder);
/// A program for the shell.
std::filesystem::path script(const TemporaryFolder& folder, const std::string& name, const std::string& text);

struct Said {
  int status = -1;
  std::string text; ///< standard output and error
};
/// Runs a line of the shell, in which $SWEEP is isoscope-sweep.
Said shell(const std::string& line);
std::string quoted(const std::filesystem::path& path);

/// The rows without what differs from run to run: time and memory.
std::string steady_table(const std::filesystem::path& table);

} // namespace isoscope::test
