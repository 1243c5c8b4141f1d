// A modifiable priority queue over tetrahedra: the largest key on top, ties to the smallest slot (§2.3).
#pragma once

#include "base/ids.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// A binary heap that knows where each slot lies, so that keys can change and slots can leave.
class SteinerQueue {
 public:
  /// Enters t or changes its key (not NaN).
  void set(TetId t, double key);
  /// Takes t out; nothing happens when it is not there.
  void erase(TetId t);
  void clear();
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  TetId top() const { return heap_.front().tet; }
  double top_key() const { return heap_.front().key; }

 private:
  struct Entry {
    double key = 0;
    TetId tet;
    bool before(const Entry& other) const { return key > other.key || (key == other.key && tet < other.tet); }
  };
  static constexpr std::uint32_t absent = 0xffffffffu;
  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_; ///< by slot: index into heap_, or absent

  void put(std::size_t i, Entry entry);
  void sift_up(std::size_t i);
  void sift_down(std::size_t i);
};

} // namespace isoscope
