// Edges by ascending error, lazily brought up to date: an entry knows when its neighbourhood was looked at.
#pragma once

#include "base/ids.h"

#include <cstdint>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace isoscope {

/// An edge with its error at some time; a < b.
struct QueuedEdge {
  double error = 0;
  VertexId a, b;
  std::uint32_t time = 0;
};

/// Ascending by error, then by ids, so that ties do not depend on history.
class CollapseQueue {
 public:
  void push(const QueuedEdge& edge) { heap_.push(edge); }
  bool empty() const { return heap_.empty(); }
  QueuedEdge pop() {
    const QueuedEdge top = heap_.top();
    heap_.pop();
    return top;
  }

 private:
  struct Later {
    bool operator()(const QueuedEdge& x, const QueuedEdge& y) const {
      if (x.error != y.error) return x.error > y.error;
      return x.a != y.a ? x.a > y.a : x.b > y.b;
    }
  };
  std::priority_queue<QueuedEdge, std::vector<QueuedEdge>, Later> heap_;
};

/// Failed edges are tried again only after a change reached their stars.
class FailedCollapses {
 public:
  void add(VertexId a, VertexId b, std::uint32_t time) { times_[{a, b}] = time; }
  bool failed_since(VertexId a, VertexId b, std::uint32_t changed) const {
    const auto at = times_.find({a, b});
    return at != times_.end() && at->second >= changed;
  }
  void clear() { times_.clear(); }

 private:
  std::map<std::pair<VertexId, VertexId>, std::uint32_t> times_;
};

} // namespace isoscope
