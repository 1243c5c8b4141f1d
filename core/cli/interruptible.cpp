// What a signal handler can reach.
#include "cli/interruptible.h"

#include <atomic>
#include <csignal>

#include <unistd.h>

namespace isoscope {

namespace {

/// The control of the run under way: a signal handler can reach nothing but a global. Null before and after
/// the run.
std::atomic<RunControl*> interruptible{nullptr};
/// Somebody has asked for the end already.
std::atomic<bool> asked_to_end{false};
static_assert(std::atomic<RunControl*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int) {
  if (asked_to_end.exchange(true)) _exit(4);
  if (RunControl* control = interruptible.load()) control->cancel();
}

/// The terminal is gone. The shell and the system may both tell it, so that being told twice means no more.
extern "C" void on_hangup(int) {
  if (RunControl* control = interruptible.load()) control->cancel();
}

} // namespace

Interruptible::Interruptible(RunControl& control) {
  interruptible = &control;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (std::signal(SIGHUP, on_hangup) == SIG_IGN) std::signal(SIGHUP, SIG_IGN); // as under nohup
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

Interruptible::~Interruptible() {
  interruptible = nullptr;
}

} // namespace isoscope
