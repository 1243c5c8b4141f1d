// Children by fork and exec, with files or a pseudoterminal for what they print.
#include "support/run_program.h"

#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <utility>

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

/// Runs what never returns in a child of ours.
template <class Act> Ended run_child(const Act& act) {
  const TemporaryFolder folder;
  const pid_t process = fork();
  if (process == 0) {
    redirect(folder / "out", STDOUT_FILENO);
    redirect(folder / "error", STDERR_FILENO);
    act();
    _exit(127);
  }
  Ended ended;
  ended.status = wait_for(process);
  ended.out = bytes_of(folder / "out");
  ended.error = bytes_of(folder / "error");
  return ended;
}

} // namespace

Ended run_batch(const std::vector<std::string>& arguments) {
  return run_child([&] { execute(arguments); });
}

Ended run_shell(const std::string& line) {
  return run_child([&] {
    setenv("PROGRAM", ISOSCOPE_RUN_PROGRAM, 1);
    execl("/bin/bash", "bash", "-c", line.c_str(), nullptr);
  });
}

bool TerminalRun::possible() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  const char* name =
      terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0 ? ptsname(terminal) : nullptr;
  const int other_side = name != nullptr ? open(name, O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
  if (other_side >= 0) close(other_side);
  if (terminal >= 0) close(terminal);
  if (other_side < 0) MESSAGE("SKIPPED: no pseudoterminal can be opened here.");
  return other_side >= 0;
}

TerminalRun::TerminalRun(const std::vector<std::string>& arguments) {
  terminal_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0) return;
  const std::string name = ptsname(terminal_);
  process_ = fork();
  if (process_ == 0) {
    setsid(); // so that the terminal opened next is the one that it has
    const int other_side = open(name.c_str(), O_RDWR);
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
  if (terminal_ < 0) return false;
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
  if (process_ > 0) kill(process_, number);
}

Ended TerminalRun::hang_up() {
  close(std::exchange(terminal_, -1));
  return finish();
}

Ended TerminalRun::finish() {
  while (read_some()) {}
  Ended ended;
  if (process_ > 0) ended.status = wait_for(process_);
  process_ = -1;
  ended.error = shown_;
  return ended;
}

} // namespace isoscope::test
