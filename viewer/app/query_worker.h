// A worker that looks through a journal for the next or the previous event that matches; newer requests
// replace older.
#pragma once

#include "query/search.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace isoscope {

struct QueryRequest {
  std::uint64_t number = 0; ///< the asker's own
  std::shared_ptr<const Journal> journal;
  QuerySearch search;
  bool goes_on = false; ///< where no later event matches, the run goes on
};

struct QueryAnswer {
  QueryRequest request;
  std::optional<QueryMatch> match;
};

/// Methods are for one thread, the window's; the work happens on the worker's.
class QueryWorker {
 public:
  /// `notify` is called from the worker whenever an answer is ready.
  explicit QueryWorker(std::function<void()> notify);
  ~QueryWorker();
  QueryWorker(const QueryWorker&) = delete;
  QueryWorker& operator=(const QueryWorker&) = delete;

  /// Replaces any request before, also one that is being answered.
  void request(QueryRequest request);
  /// The newest answer, once.
  std::optional<QueryAnswer> take();
  /// Whether nothing is asked and no answer waits to be taken.
  bool idle() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
