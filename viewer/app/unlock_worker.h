// A worker that looks for neighbouring collapses that would make one possible: it takes seconds, and a newer
// question ends it.
#pragma once

#include "app/probe.h"
#include "run/unlock_search.h"

namespace isoscope {

/// The newest answer; `search` is null where the state has no such edge.
struct UnlockResult {
  ProbeRequest request;
  std::shared_ptr<const UnlockSearch> search;
};

/// Methods are for one thread, the window's; the work happens on the worker's.
class UnlockWorker {
 public:
  /// `notify` is called from the worker whenever there is more to show.
  explicit UnlockWorker(std::function<void()> notify);
  ~UnlockWorker();
  UnlockWorker(const UnlockWorker&) = delete;
  UnlockWorker& operator=(const UnlockWorker&) = delete;

  /// Ends what is under way.
  void request(ProbeRequest request);
  void cancel();
  /// The newest answer, null before the first.
  std::shared_ptr<const UnlockResult> result() const;
  bool idle() const;
  /// Of the question under way, in [0, 1].
  double fraction() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
