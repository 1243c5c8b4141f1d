// The pages of an SQLite file and of the write-ahead log beside it, read only.
#pragma once

#include "base/status.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace isoscope {

/// Whether a log lies beside a file whose head says that it has none: a copy's, of an earlier state. SQLite
/// itself would take it for the newer one.
bool has_stale_log(const std::filesystem::path& file);

/// A file that may be damaged or cut short anywhere.
class PageFile {
 public:
  enum class Log { taken, ignored };
  /// Fails with bad_input where no file is, and with io when it cannot be read.
  static Result<PageFile> open(const std::filesystem::path& file, Log log = Log::taken);

  std::size_t page_size() const { return page_size_; }
  /// Also the last one, which may be cut off.
  std::size_t pages() const { return pages_; }
  /// The newest bytes of a page, from 1 on; fewer than page_size() where the file is cut off.
  std::string page(std::uint32_t number);

 private:
  void read_log(const std::filesystem::path& file);
  std::ifstream main_, log_;
  std::size_t page_size_ = 0, pages_ = 0;
  std::map<std::uint32_t, std::uint64_t>
      logged_; ///< where in the log the newest committed bytes of a page are
};

} // namespace isoscope
