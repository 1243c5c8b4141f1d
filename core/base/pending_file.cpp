// Temporary file, fsync, rename.
#include "base/pending_file.h"

#include <atomic>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isoscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t buffer_size = std::size_t{1} << 18;
constexpr std::size_t path_limit = 1000;

Error io_error(const fs::path& file, const std::string& what, int error) {
  const std::string remedy = error == ENOSPC || error == EDQUOT ? "Free some space or write elsewhere."
                             : error == ENOENT                  ? "Make the folder first."
                                                                : "Write to another place.";
  return {ErrorCode::io,
          printable(file.native(), path_limit) + ": " + what + " (" +
              std::error_code(error, std::generic_category()).message() + ").",
          remedy};
}

} // namespace

fs::path behind_links(const fs::path& file) {
  constexpr int most = 40; // as the system itself follows
  fs::path at = file;
  std::error_code failure;
  for (int i = 0; i < most && fs::is_symlink(at, failure); ++i) {
    const fs::path next = fs::read_symlink(at, failure);
    if (failure) break;
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at;
}

std::string printable(std::string_view text, std::size_t limit) {
  std::string shown;
  for (const char c : text.substr(0, limit)) shown += (c >= ' ' && c <= '~') ? c : '?';
  return text.size() > limit ? shown + "..." : shown;
}

Status PendingFile::open(const fs::path& target, WriteTarget allowed) {
  static std::atomic<unsigned> serial{0};
  std::error_code ignored;
  named_ = target;
  target_ = behind_links(target);
  if (fs::is_symlink(target_, ignored)) return io_error(named_, "cannot be written", ELOOP);
  if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) {
    if (allowed == WriteTarget::file || fs::is_directory(target_, ignored))
      return Error{ErrorCode::io, printable(target.native(), path_limit) + ": exists and is not a file.",
                   "Choose another name."};
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) return io_error(named_, "cannot be written", errno);
    return {};
  }
  for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
    // Short, so that a target with the longest possible name can still be written.
    temporary_ = target_.parent_path() /
                 (".isoscope-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp");
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) return io_error(named_, "cannot be written", errno);
  // What takes a file's place is read and written by those who could before.
  struct stat before {};
  if (::stat(target_.c_str(), &before) == 0) ::fchmod(descriptor_, before.st_mode & 0777);
  return {};
}

PendingFile::~PendingFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::append(const void* data, std::size_t size) {
  buffer_.append(static_cast<const char*>(data), size);
  if (buffer_.size() >= buffer_size) flush();
}

Status PendingFile::commit() {
  flush();
  const bool in_place = temporary_.empty();
  if (error_ == 0 && !in_place && ::fsync(descriptor_) != 0) error_ = errno;
  if (error_ == 0) {
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    if (result != 0) error_ = errno;
    if (error_ == 0 && !in_place && ::rename(temporary_.c_str(), target_.c_str()) != 0) error_ = errno;
    if (error_ != 0 && !in_place) ::unlink(temporary_.c_str());
  }
  if (error_ != 0) return io_error(named_, "cannot be written to its end", error_);
  return {};
}

void PendingFile::flush() {
  std::size_t done = 0;
  while (error_ == 0 && done < buffer_.size()) {
    const ssize_t n = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (n < 0 && errno != EINTR) error_ = errno;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  buffer_.clear();
}

} // namespace isoscope
