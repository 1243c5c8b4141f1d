// Runs the real window with a script.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>

namespace isoscope::test {

/// The exit status of a shell command; -1 where it ended otherwise.
inline int exit_of(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The window's exit status; 0 where every expectation of the script held. `meanwhile`: a shell command that
/// acts beside the window, whose process is $program, and ends with it; `environment`: assignments before it.
inline int run_window(const std::string& name, const std::string& script,
                      const std::string& arguments = "gallery:sphere --tolerance 12%",
                      const std::string& meanwhile = "", const std::string& environment = "") {
  namespace fs = std::filesystem;
  const fs::path results = ISOSCOPE_RESULTS;
  fs::create_directories(results);
  const fs::path file = results / (name + ".txt");
  // One frame a picture: what is averaged where a view rests is not what they are about.
  std::ofstream(file) << "set stills 1\n" << script;
  std::string command = environment + ISOSCOPE_PROGRAM + " " + arguments + " --script " + file.string();
  // A window that failed leaves nobody waiting for what it will not do.
  if (!meanwhile.empty())
    command += " & program=$!; (" + meanwhile +
               ") & beside=$!; wait $program; status=$?; kill $beside 2>/dev/null; exit $status";
  return exit_of(command);
}

} // namespace isoscope::test
