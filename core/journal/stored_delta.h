// Deltas as flat bytes in memory that may go to the disk.
#pragma once

#include "base/spill_pool.h"
#include "mesh/complex.h"

#include <cstddef>
#include <cstdint>

namespace isoscope {

/// Where a delta's bytes are; valid as long as its store's pool.
struct StoredDelta {
  const std::byte* at = nullptr;
  std::uint32_t size = 0;

  Delta read() const;
  /// The same into a delta whose memory is used again: for loops over many.
  void read(Delta& into) const;
};

/// Puts deltas one behind the other; one thread.
class DeltaStore {
 public:
  /// The pool must outlive the store.
  explicit DeltaStore(SpillPool& pool) : pool_(&pool) {}
  StoredDelta add(const Delta& delta);
  /// A copy of another store's.
  StoredDelta add(const StoredDelta& delta);

 private:
  SpillPool* pool_;
  std::byte* segment_ = nullptr;
  std::size_t used_ = 0, size_ = 0;

  std::byte* room(std::size_t bytes);
};

} // namespace isoscope
