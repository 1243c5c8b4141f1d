// Runs the real window with a script.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>

namespace isoscope::test {

/// The window's exit status; 0 where every expectation of the script held.
inline int run_window(const std::string& name, const std::string& script, const std::string& arguments) {
  namespace fs = std::filesystem;
  const fs::path results = ISOSCOPE_RESULTS;
  fs::create_directories(results);
  const fs::path file = results / (name + ".txt");
  std::ofstream(file) << script;
  const std::string command = std::string(ISOSCOPE_PROGRAM) + " " + arguments + " --script " + file.string();
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace isoscope::test
