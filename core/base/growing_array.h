// A list of plain values that grows in place: its pages are moved, and what is not used yet takes none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace isoscope {

/// A std::vector holds its values twice while it grows; of a list that fills the memory that is too much.
template <class T> class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  GrowingArray() = default;
  GrowingArray(GrowingArray&& other) noexcept
      : data_(std::move(other.data_)), size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  GrowingArray& operator=(GrowingArray&& other) noexcept {
    data_ = std::move(other.data_);
    size_ = std::exchange(other.size_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    return *this;
  }

  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }

  void push_back(T value) {
    if (size_ == capacity_) reserve(std::max<std::size_t>(2 * capacity_, 64));
    data_.get()[size_++] = value;
  }
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    void* moved = std::realloc(data_.get(), count * sizeof(T));
    if (moved == nullptr) throw std::bad_alloc();
    static_cast<void>(data_.release());
    data_.reset(static_cast<T*>(moved));
    capacity_ = count;
  }

 private:
  struct Release {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T, Release> data_;
  std::size_t size_ = 0, capacity_ = 0;
};

} // namespace isoscope
