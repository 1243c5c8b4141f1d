// A thread that ends the program unless it is told in time that nothing is left to wait for.
#include "app/last_wait.h"

#include <cstdio>
#include <cstdlib>

namespace isoscope {

LastWait::LastWait(int status, std::chrono::milliseconds patience)
    : thread_([this, status, patience] {
        std::unique_lock lock(mutex_);
        if (changed_.wait_for(lock, patience, [this] { return ended_; })) return;
        std::fputs("isoscope: A computation did not end in time and is left behind; recordings are kept.\n",
                   stderr);
        // Destructors would wait for it.
        std::_Exit(status);
      }) {}

LastWait::~LastWait() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

} // namespace isoscope
