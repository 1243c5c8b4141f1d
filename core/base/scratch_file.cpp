// A nameless file behind a buffer.
#include "base/scratch_file.h"

#include "base/nameless_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace isoscope {
namespace {

constexpr std::size_t bytes_at_once = 1 << 18;

} // namespace

ScratchFile::ScratchFile(const std::filesystem::path& folder)
    : folder_(folder), descriptor_(open_nameless(folder)), error_(descriptor_ < 0 ? errno : 0) {}

ScratchFile::~ScratchFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

ScratchFile::ScratchFile(ScratchFile&& other) noexcept
    : folder_(std::move(other.folder_)), descriptor_(std::exchange(other.descriptor_, -1)),
      error_(other.error_), written_(other.written_), buffer_(std::move(other.buffer_)) {}

void ScratchFile::append(const void* data, std::size_t bytes) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) { // much at once is not to be there twice
    const std::size_t some = std::min(bytes, bytes_at_once - buffer_.size());
    buffer_.insert(buffer_.end(), from, from + some);
    from += some, bytes -= some;
    if (buffer_.size() >= bytes_at_once) flush();
  }
}

void ScratchFile::flush() const {
  if (error_ == 0) error_ = write_all(descriptor_, buffer_.data(), buffer_.size(), written_);
  written_ += buffer_.size();
  buffer_.clear();
}

void ScratchFile::read(std::uint64_t at, void* data, std::size_t bytes) const {
  if (!buffer_.empty()) flush();
  char* to = static_cast<char*>(data);
  std::size_t done = 0;
  while (error_ == 0 && done < bytes) {
    const ssize_t n = ::pread(descriptor_, to + done, bytes - done, static_cast<off_t>(at + done));
    if (n < 0 && errno != EINTR) error_ = errno;
    if (n == 0) error_ = EIO;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  if (error_ != 0) std::memset(to + done, 0, bytes - done);
}

Status ScratchFile::status() const {
  if (!buffer_.empty()) flush();
  if (error_ == 0) return {};
  return Error{ErrorCode::io,
               folder_.string() + ": what does not fit into memory cannot be kept there (" +
                   std::error_code(error_, std::generic_category()).message() + ").",
               error_ == ENOSPC ? "Free some space." : "Take a folder that can be written."};
}

BlockReader::BlockReader(const ScratchFile& file, std::size_t most_bytes)
    : file_(file), slots_(std::max<std::size_t>(1, most_bytes / block_bytes)) {}

const std::vector<char>& BlockReader::block(std::uint64_t number) {
  Slot& slot = slots_[number % slots_.size()];
  if (slot.block == number) return slot.bytes;
  const std::uint64_t at = number * block_bytes;
  slot.bytes.resize(std::min(block_bytes, file_.size() - at));
  file_.read(at, slot.bytes.data(), slot.bytes.size());
  slot.block = number;
  return slot.bytes;
}

void BlockReader::read(std::uint64_t at, void* data, std::size_t bytes) {
  char* to = static_cast<char*>(data);
  while (bytes > 0) {
    const std::vector<char>& from = block(at / block_bytes);
    const std::size_t offset = at % block_bytes, n = std::min(bytes, from.size() - offset);
    std::memcpy(to, from.data() + offset, n);
    to += n, at += n, bytes -= n;
  }
}

} // namespace isoscope
