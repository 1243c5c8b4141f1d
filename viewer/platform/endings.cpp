// Handlers of signals and of Xlib's errors: neither is given any data, so that what they reach is global.
#include "platform/endings.h"

#include <X11/Xlib.h>

#include <atomic>
#include <csignal>
#include <utility>

#include <unistd.h>

namespace isoscope {
namespace {

constexpr int stopped_status = 4, device_status = 2;
constexpr unsigned patience_seconds = 10;

std::atomic<int> noted{0};
std::atomic<bool> insisted{false}, lost{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

/// What is left to be done without a display.
std::function<void()>& last_act() {
  static std::function<void()> act;
  return act;
}

extern "C" void on_end_signal(int signal) {
  // Shell and system may both tell that the terminal is gone: that is no insisting.
  if (signal != SIGHUP && insisted.exchange(true)) _exit(stopped_status);
  int none = 0;
  noted.compare_exchange_strong(none, signal);
}

extern "C" void on_patience_over(int) {
  _exit(device_status);
}

extern "C" int on_display_error(Display*) {
  if (lost.exchange(true)) _exit(device_status);
  std::signal(SIGALRM, on_patience_over);
  alarm(patience_seconds);
  if (last_act()) last_act()();
  _exit(device_status); // Xlib would call exit(), which destroys statics under threads that still run
}

} // namespace

void note_signals() {
  std::signal(SIGINT, on_end_signal);
  std::signal(SIGTERM, on_end_signal);
  if (std::signal(SIGHUP, on_end_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN); // as under nohup
}

int noted_signal() {
  return noted.load();
}

std::string_view signal_name(int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}

void on_display_lost(std::function<void()> act) {
  last_act() = std::move(act);
  XSetIOErrorHandler(on_display_error);
}

bool display_lost() {
  return lost.load();
}

} // namespace isoscope
