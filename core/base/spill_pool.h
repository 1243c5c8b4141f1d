// Memory that is written once and read for long: beyond a limit its older segments go to a file, and whoever
// reads them finds them at the same addresses.
#pragma once

#include "base/status.h"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

namespace isoscope {

/// Segments of memory. One thread takes and seals them; any thread reads what was written, asks and sets the
/// limit at any time. A segment on the disk is read back page by page when somebody touches it, and the
/// system drops such pages again when memory is short or release_read_back() says so. The file has no name:
/// it is gone when the pool is, or when the program is killed.
class SpillPool {
 public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

  /// `folder`: where the file is made once it is needed.
  explicit SpillPool(std::filesystem::path folder = default_folder());
  ~SpillPool();
  SpillPool(const SpillPool&) = delete;
  SpillPool& operator=(const SpillPool&) = delete;

  /// A new segment, zero, aligned to a page. Throws std::bad_alloc.
  std::byte* take(std::size_t bytes);
  /// The segment's first `used` bytes are what they will always be: it may go to the disk.
  void seal(const std::byte* segment, std::size_t used);

  /// Sealed segments leave memory, the oldest first, as long as all of them take more than `bytes`; so from
  /// now on. What cannot leave stays, and error() tells why.
  void keep_within(std::size_t bytes);
  /// Gives the memory of pages that were read back from the disk to whoever needs it.
  void release_read_back();

  /// Bytes of segments that are in memory, whole.
  std::size_t memory_bytes() const;
  /// Used bytes of segments that are on the disk.
  std::size_t disk_bytes() const;
  /// Why nothing more goes to the disk: it is full, or the file cannot be made.
  std::optional<Error> error() const;

  /// $TMPDIR, else /var/tmp, which unlike /tmp is never memory itself.
  static std::filesystem::path default_folder();

 private:
  struct Segment {
    std::byte* at = nullptr;
    std::size_t bytes = 0, used = 0;
    bool on_disk = false;
  };
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  std::vector<Segment> segments_;
  std::deque<std::size_t> sealed_; ///< indices of segments that are in memory still, in the order of sealing
  std::size_t limit_ = unlimited, memory_ = 0, disk_ = 0;
  int file_ = -1;
  std::size_t file_end_ = 0;
  std::optional<Error> error_;

  void spill();
  bool move_to_disk(Segment& segment);
  bool fail(const char* what, int code);
};

} // namespace isoscope
