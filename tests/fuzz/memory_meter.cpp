// A counting operator new.
#include "fuzz/memory_meter.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace isoscope::fuzz {

namespace {

std::atomic<std::size_t> held{0}, peak{0};

} // namespace

std::size_t bytes_held() {
  return held;
}

std::size_t peak_bytes() {
  return peak;
}

void restart_peak() {
  peak = held.load();
}

} // namespace isoscope::fuzz

#ifndef ISOSCOPE_SANITIZED

namespace {

using namespace isoscope::fuzz;

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t now = held += malloc_usable_size(memory);
  std::size_t most = peak;
  while (most < now && !peak.compare_exchange_weak(most, now)) {}
  return memory;
}

void release(void* memory) {
  if (memory != nullptr) held -= malloc_usable_size(memory);
  std::free(memory);
}

} // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(size > 0 ? size : 1));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step) / step * step));
}

void operator delete(void* memory) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

#endif
