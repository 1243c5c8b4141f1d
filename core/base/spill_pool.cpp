// Anonymous mappings that are replaced by mappings of a file, in place and at once.
#include "base/spill_pool.h"

#include "base/nameless_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace isoscope {

namespace {

std::size_t whole_pages(std::size_t bytes) {
  static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return (std::max<std::size_t>(bytes, 1) + page - 1) / page * page;
}

} // namespace

SpillPool::SpillPool(std::filesystem::path folder) : folder_(std::move(folder)) {}

SpillPool::~SpillPool() {
  for (const Segment& s : segments_) ::munmap(s.at, s.bytes);
  if (file_ >= 0) ::close(file_);
}

std::filesystem::path SpillPool::default_folder() {
  const char* wanted = std::getenv("TMPDIR");
  if (wanted != nullptr && *wanted != 0) return wanted;
  std::error_code none;
  return std::filesystem::is_directory("/var/tmp", none) ? "/var/tmp" : "/tmp";
}

std::byte* SpillPool::take(std::size_t bytes) {
  bytes = whole_pages(bytes);
  void* at = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (at == MAP_FAILED) throw std::bad_alloc();
  const std::lock_guard lock(mutex_);
  segments_.push_back({static_cast<std::byte*>(at), bytes, 0, false});
  memory_ += bytes;
  spill();
  return segments_.back().at;
}

void SpillPool::seal(const std::byte* segment, std::size_t used) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(segments_.rbegin(), segments_.rend(), [&](const Segment& s) { return s.at == segment; });
  if (found == segments_.rend()) return;
  found->used = used;
  sealed_.push_back(static_cast<std::size_t>(segments_.rend() - found) - 1);
  spill();
}

void SpillPool::keep_within(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  limit_ = bytes;
  spill();
}

void SpillPool::spill() {
  while (memory_ > limit_ && !sealed_.empty() && !error_) {
    if (!move_to_disk(segments_[sealed_.front()])) return;
    sealed_.pop_front();
  }
}

bool SpillPool::move_to_disk(Segment& segment) {
  if (file_ < 0 && (file_ = open_nameless(folder_)) < 0) return fail("no file can be made in ", errno);
  // The room is there before anything is mapped: a page without room on the disk would be a crash later.
  if (const int code =
          ::posix_fallocate(file_, static_cast<off_t>(file_end_), static_cast<off_t>(segment.bytes)))
    return fail("there is no room in ", code);
  if (const int code = write_all(file_, segment.at, segment.used, file_end_))
    return fail("nothing can be written in ", code);
  void* copy = ::mmap(nullptr, segment.bytes, PROT_READ, MAP_SHARED, file_, static_cast<off_t>(file_end_));
  if (copy == MAP_FAILED) return fail("memory cannot be mapped to ", errno);
  // In one step for whoever reads there now: before it the old pages, after it the same bytes in the file.
  if (::mremap(copy, segment.bytes, segment.bytes, MREMAP_MAYMOVE | MREMAP_FIXED, segment.at) == MAP_FAILED) {
    const int code = errno;
    ::munmap(copy, segment.bytes);
    return fail("memory cannot be mapped to ", code);
  }
  file_end_ += segment.bytes;
  segment.on_disk = true;
  memory_ -= segment.bytes;
  disk_ += segment.used;
  return true;
}

bool SpillPool::fail(const char* what, int code) {
  error_ = Error{ErrorCode::io,
                 "The history stays in memory beyond its limit: " + std::string(what) + folder_.string() +
                     " (" + std::strerror(code) + ").",
                 "Free room there, set TMPDIR to another folder, or raise the limit."};
  return false;
}

void SpillPool::release_read_back() {
  const std::lock_guard lock(mutex_);
  for (const Segment& s : segments_)
    if (s.on_disk) ::madvise(s.at, s.bytes, MADV_DONTNEED);
}

std::size_t SpillPool::memory_bytes() const {
  const std::lock_guard lock(mutex_);
  return memory_;
}

std::size_t SpillPool::disk_bytes() const {
  const std::lock_guard lock(mutex_);
  return disk_;
}

std::optional<Error> SpillPool::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

} // namespace isoscope
