// A list that one thread appends to while others read it, in segments that may go to the disk.
#pragma once

#include "base/append_only.h"
#include "base/spill_pool.h"

#include <atomic>
#include <cstddef>
#include <new>
#include <type_traits>

namespace isoscope {

/// Elements never move. One writer; any number of readers of indices below size().
template <class T> class SpillList {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  /// The pool must outlive the list.
  explicit SpillList(SpillPool& pool) : pool_(&pool) {}

  std::size_t size() const { return size_.load(std::memory_order_acquire); }
  bool empty() const { return size() == 0; }
  const T& operator[](std::size_t i) const { return segments_[i / per_segment][i % per_segment]; }
  const T& back() const { return (*this)[size() - 1]; }

  /// Writer only.
  void push_back(const T& value) {
    const std::size_t i = size_.load(std::memory_order_relaxed);
    if (i % per_segment == 0) begin_segment();
    ::new (next_) T(value);
    next_ += sizeof(T);
    size_.store(i + 1, std::memory_order_release);
  }

 private:
  static constexpr std::size_t per_segment = 2048;
  SpillPool* pool_;
  AppendOnly<const T*> segments_;
  std::byte* segment_ = nullptr; ///< the one being filled
  std::byte* next_ = nullptr;
  std::atomic<std::size_t> size_{0};

  void begin_segment() {
    if (segment_ != nullptr) pool_->seal(segment_, per_segment * sizeof(T));
    segment_ = next_ = pool_->take(per_segment * sizeof(T));
    segments_.push_back(reinterpret_cast<const T*>(segment_));
  }
};

} // namespace isoscope
