// fork, setrlimit, exec, wait4.
#include "sweep/child_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isoscope::sweep {

namespace {

/// Elapsed seconds for each CPU second of the limit, after which a process that computes nothing is a hang
/// too.
constexpr double idle_factor = 20;
constexpr std::size_t longest_message = 300;

/// The last line of what was written to a file without a name.
std::string last_line(int descriptor) {
  constexpr off_t enough = 4096;
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  if (size <= 0) return {};
  std::string text(static_cast<std::size_t>(std::min(size, enough)), '\0');
  const ssize_t read = ::pread(descriptor, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(read, 0)));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::size_t at = text.find_last_of("\n\r");
  if (at != std::string::npos) text.erase(0, at + 1);
  return text.substr(0, longest_message);
}

/// Becomes the program; never returns. Between fork and exec nothing may allocate: other threads may hold the
/// lock.
[[noreturn]] void become(char* const* argv, const Limits& limits, int error, pid_t parent) {
  const auto cpu = static_cast<rlim_t>(std::ceil(limits.cpu_seconds));
  const auto bytes = static_cast<rlim_t>(limits.memory_mib * 1024 * 1024);
  const rlimit cpu_limit{cpu, cpu + 5}, memory_limit{bytes, bytes}, no_core{0, 0};
  ::setrlimit(RLIMIT_CPU, &cpu_limit);
  if (bytes > 0) ::setrlimit(RLIMIT_AS, &memory_limit);
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::setpgid(0, 0); // Ctrl-C is for the sweep, which then ends this
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  const int nowhere = ::open("/dev/null", O_RDWR);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(error, STDERR_FILENO);
  ::execv(argv[0], argv);
  ::_exit(127);
}

/// Waits, and kills what takes far longer than its CPU time could, and what nobody wants.
void wait_for(pid_t process, const Limits& limits, const RunControl& control, ChildEnd& end) {
  const auto start = std::chrono::steady_clock::now();
  rusage usage{};
  for (;;) {
    int status = 0;
    const pid_t ended = ::wait4(process, &status, WNOHANG, &usage);
    if (ended == process) {
      end.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      break;
    }
    if (ended < 0) {
      end.exit = 127;
      break;
    }
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    end.timed_out = end.timed_out || elapsed > idle_factor * limits.cpu_seconds;
    end.abandoned = end.abandoned || control.cancelled();
    if (end.timed_out || end.abandoned) ::kill(process, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(elapsed < 1 ? 5 : 20));
  }
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  end.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.memory_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  end.timed_out = end.timed_out || end.exit == 128 + SIGXCPU ||
                  (end.exit == 128 + SIGKILL && end.seconds >= limits.cpu_seconds);
}

} // namespace

ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits, const RunControl& control) {
  std::vector<std::string> words = command;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ChildEnd end;
  const int error = ::memfd_create("stderr", MFD_CLOEXEC);
  const pid_t parent = ::getpid(), process = ::fork();
  if (process == 0) become(argv.data(), limits, error, parent);
  if (process < 0)
    end.exit = 127;
  else
    wait_for(process, limits, control, end);
  if (end.exit != 0) end.last_words = last_line(error);
  if (error >= 0) ::close(error);
  return end;
}

} // namespace isoscope::sweep
