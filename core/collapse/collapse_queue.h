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

/// When an edge failed, and whether it came close.
struct Failure {
  std::uint32_t time = 0;
  bool close = false; ///< relocations in the neighbourhood may be enough for a second attempt
};

/// Edges that failed, by their ends in the order given. They are tried again only after a change near them.
template <class Vertex> class FailedCollapses {
 public:
  void add(Vertex a, Vertex b, Failure failure) { failures_[{a, b}] = failure; }
  void erase(Vertex a, Vertex b) { failures_.erase({a, b}); }
  void clear() { failures_.clear(); }
  /// Null when the edge has not failed.
  const Failure* find(Vertex a, Vertex b) const {
    const auto at = failures_.find({a, b});
    return at == failures_.end() ? nullptr : &at->second;
  }
  bool failed_since(Vertex a, Vertex b, std::uint32_t changed) const {
    const Failure* failure = find(a, b);
    return failure != nullptr && failure->time >= changed;
  }

 private:
  std::map<std::pair<Vertex, Vertex>, Failure> failures_;
};

} // namespace isoscope
