// Waiting in tests for what another thread brings about.
#pragma once

#include <chrono>
#include <thread>

namespace isoscope::test {

/// Whether the condition holds within half a minute.
template <class Condition> bool eventually(Condition condition) {
  for (int i = 0; i < 3000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

} // namespace isoscope::test
