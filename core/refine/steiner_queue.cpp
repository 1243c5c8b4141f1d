// Sifting in a binary heap of (key, slot), with the place of each slot kept beside it.
#include "refine/steiner_queue.h"

namespace isoscope {

void SteinerQueue::put(std::size_t i, Entry entry) {
  heap_[i] = entry;
  place_[entry.tet.index()] = static_cast<std::uint32_t>(i);
}

void SteinerQueue::sift_up(std::size_t i) {
  const Entry entry = heap_[i];
  while (i > 0) {
    const std::size_t parent = (i - 1) / 2;
    if (!entry.before(heap_[parent])) break;
    put(i, heap_[parent]);
    i = parent;
  }
  put(i, entry);
}

void SteinerQueue::sift_down(std::size_t i) {
  const Entry entry = heap_[i];
  for (;;) {
    std::size_t child = 2 * i + 1;
    if (child >= heap_.size()) break;
    if (child + 1 < heap_.size() && heap_[child + 1].before(heap_[child])) ++child;
    if (!heap_[child].before(entry)) break;
    put(i, heap_[child]);
    i = child;
  }
  put(i, entry);
}

void SteinerQueue::set(TetId t, double key) {
  if (t.index() >= place_.size()) place_.resize(t.index() + 1, absent);
  std::size_t i = place_[t.index()];
  if (i == absent) {
    i = heap_.size();
    heap_.push_back({key, t});
    place_[t.index()] = static_cast<std::uint32_t>(i);
  } else {
    heap_[i].key = key;
  }
  sift_up(i);
  sift_down(place_[t.index()]);
}

void SteinerQueue::erase(TetId t) {
  if (t.index() >= place_.size() || place_[t.index()] == absent) return;
  const std::size_t i = place_[t.index()];
  place_[t.index()] = absent;
  const Entry last = heap_.back();
  heap_.pop_back();
  if (i == heap_.size()) return;
  put(i, last);
  sift_up(i);
  sift_down(place_[last.tet.index()]);
}

void SteinerQueue::clear() {
  heap_.clear();
  place_.clear();
}

} // namespace isoscope
