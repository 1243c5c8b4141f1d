// A list that one thread appends to while others read what is already there, without locks.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace isoscope {

/// Blocks double in size, so elements never move. One writer; any number of readers of indices below size().
template <class T> class AppendOnly {
 public:
  AppendOnly() = default;
  AppendOnly(const AppendOnly&) = delete;
  AppendOnly& operator=(const AppendOnly&) = delete;

  std::size_t size() const { return size_.load(std::memory_order_acquire); }
  bool empty() const { return size() == 0; }
  const T& operator[](std::size_t i) const {
    const auto [block, offset] = place(i);
    return blocks_[block][offset];
  }
  const T& back() const { return (*this)[size() - 1]; }

  /// Writer only.
  void push_back(T value) {
    const std::size_t i = size_.load(std::memory_order_relaxed);
    const auto [block, offset] = place(i);
    if (!blocks_[block]) blocks_[block] = std::make_unique<T[]>(first_block << block);
    blocks_[block][offset] = std::move(value);
    size_.store(i + 1, std::memory_order_release);
  }

 private:
  static constexpr std::size_t first_block = 1024;
  static std::pair<std::size_t, std::size_t> place(std::size_t i) {
    std::size_t block = 0, begin = 0;
    for (std::size_t length = first_block; i >= begin + length; length <<= 1) {
      begin += length;
      ++block;
    }
    return {block, i - begin};
  }
  std::array<std::unique_ptr<T[]>, 32> blocks_;
  std::atomic<std::size_t> size_{0};
};

} // namespace isoscope
