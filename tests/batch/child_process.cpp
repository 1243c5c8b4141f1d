// Children by fork and exec, with files or a pseudoterminal for what they print.
#include "batch/child_process.h"

#include "input/temporary_folder.h"

#include <array>
#include <cerrno>
#include <cstdlib>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isoscope::test {

namespace {

/// Replaces the process by isoscope-run.
[[noreturn]] void execute(const std::vector<std::string>& arguments) {
  std::vector<std::string> copies{ISOSCOPE_RUN_PROGRAM};
  copies.insert(copies.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& argument : copies) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {}
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void redirect(const std::filesystem::path& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
}

} // namespace

Ended run_batch(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const pid_t process = fork();
  if (process == 0) {
    redirect(folder / "out", STDOUT_FILENO);
    redirect(folder / "error", STDERR_FILENO);
    execute(arguments);
  }
  Ended ended;
  ended.status = wait_for(process);
  ended.out = bytes_of(folder / "out");
  ended.error = bytes_of(folder / "error");
  return ended;
}

TerminalRun::TerminalRun(const std::vector<std::string>& arguments) {
  terminal_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0) return;
  const std::string name = ptsname(terminal_);
  process_ = fork();
  if (process_ == 0) {
    const int other_side = open(name.c_str(), O_RDWR | O_NOCTTY);
    const int nowhere = open("/dev/null", O_WRONLY);
    if (dup2(other_side, STDERR_FILENO) < 0 || dup2(nowhere, STDOUT_FILENO) < 0) _exit(126);
    close(other_side);
    execute(arguments);
  }
}

TerminalRun::~TerminalRun() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    wait_for(process_);
  }
  if (terminal_ >= 0) close(terminal_);
}

bool TerminalRun::read_some() {
  std::array<char, 4096> buffer;
  const ssize_t count = read(terminal_, buffer.data(), buffer.size());
  if (count <= 0) return false; // the last descriptor of the other side is closed
  shown_.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

bool TerminalRun::read_until(const std::string& part) {
  while (shown_.find(part) == std::string::npos) {
    if (!read_some()) return false;
  }
  return true;
}

void TerminalRun::signal(int number) const {
  kill(process_, number);
}

Ended TerminalRun::finish() {
  while (read_some()) {}
  Ended ended;
  ended.status = wait_for(process_);
  process_ = -1;
  ended.error = shown_;
  return ended;
}

} // namespace isoscope::test
