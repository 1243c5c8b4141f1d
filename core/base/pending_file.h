// Writes a file beside its target and renames it when every byte is on the disk.
#pragma once

#include "base/status.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace isoscope {

/// What may stand where a file is to be written.
enum class WriteTarget {
  file,          ///< nothing or a file
  file_or_device ///< also a device or a pipe, which is then written itself: nothing may take its place
};

/// What a chain of symbolic links points to in the end, also where nothing is there yet; what is no link, or
/// links in a circle, as far as they go.
std::filesystem::path behind_links(const std::filesystem::path& file);

/// A new file beside the target that takes its place on commit and vanishes otherwise.
class PendingFile {
 public:
  PendingFile() = default;
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Fails with io when nothing can be created beside `target`; links are followed, so that what they point
  /// to is replaced, keeping its permissions, or made.
  Status open(const std::filesystem::path& target, WriteTarget allowed = WriteTarget::file);
  void append(const void* data, std::size_t size);
  void append(std::string_view text) { append(text.data(), text.size()); }
  /// Fails with io when not every byte could be written, now or before.
  Status commit();

 private:
  void flush();

  std::filesystem::path named_, target_, temporary_; ///< no temporary when the target is written in place
  int descriptor_ = -1;
  int error_ = 0;
  std::string buffer_;
};

/// `text` with control and non-ASCII bytes replaced and cut to `limit` characters: safe to show on one line.
std::string printable(std::string_view text, std::size_t limit = 40);

} // namespace isoscope
