// Bounds how long the program waits for its threads when the window has closed.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace isoscope {

/// While it lives the program has so much time to end what is under way; what does not end by then is left
/// behind with a line on standard error, and the program exits with `status` from wherever it is. Files that
/// matter must have been closed before.
class LastWait {
 public:
  explicit LastWait(int status, std::chrono::milliseconds patience = std::chrono::milliseconds(900));
  /// Everything has ended in time.
  ~LastWait();
  LastWait(const LastWait&) = delete;
  LastWait& operator=(const LastWait&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false; ///< under the mutex
  std::thread thread_;
};

} // namespace isoscope
