// First the bytes, then the pragmas.
#include "recording/file_checks.h"

#include "recording/database.h"
#include "recording/layout.h"
#include "recording/recording_reader.h"

#include <fstream>
#include <string_view>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

Error not_a_recording(const fs::path& file, const std::string& why) {
  return {ErrorCode::bad_input, file.string() + " is not a recording: " + why + ".",
          "Give a file that --record has written."};
}

} // namespace

Error damaged(const fs::path& file, const std::string& what) {
  return {ErrorCode::bad_input, file.string() + " is damaged: " + what + ".", recover_hint(file.string())};
}

Status check_head(const fs::path& file) {
  std::error_code failure;
  const auto status = fs::status(file, failure);
  if (!fs::exists(status))
    return Error{ErrorCode::bad_input, file.string() + " does not exist.", "Check the name."};
  if (!fs::is_regular_file(status)) return not_a_recording(file, "it is no plain file");
  std::ifstream in(file, std::ios::binary);
  if (!in) return Error{ErrorCode::io, "Cannot read " + file.string() + ".", "Check its permissions."};
  constexpr std::string_view magic("SQLite format 3\0", 16);
  std::string head(magic.size(), '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (in.gcount() == 0)
    return not_a_recording(file, "it is empty; perhaps the program was killed before the run began");
  if (head != magic) {
    Error foreign = not_a_recording(file, "it begins with other bytes");
    if (is_recording_name(file))
      foreign.remedy += " If it is one that was damaged: " + recover_hint(file.string());
    return foreign;
  }
  return {};
}

Status check_version(Database& database, const fs::path& file) {
  const auto application = database.number("PRAGMA application_id");
  if (!application) return application.error();
  if (*application != recording_application_id)
    return not_a_recording(file, "it is a database of another program");
  const auto version = database.number("PRAGMA user_version");
  if (!version) return version.error();
  if (*version == recording_version) return {};
  if (*version < 1) return damaged(file, "it has no version");
  const bool newer = *version > recording_version;
  return Error{ErrorCode::unsupported,
               file.string() + " was written by " + (newer ? "a newer" : "an older") + " version (format " +
                   std::to_string(*version) + "; this one reads format " + std::to_string(recording_version) +
                   ").",
               newer ? "Open it with a newer Isoscope." : "Record the run again."};
}

Result<Database> recording_over_pages(const fs::path& file, PageFile::Log log) {
  if (Status head = check_head(file); !head) return head.error();
  auto pages = PageFile::open(file, log);
  if (!pages) return pages.error();
  auto database = Database::over(std::move(*pages), file);
  if (!database) return database.error();
  if (Status version = check_version(*database, file); !version) return version.error();
  return database;
}

} // namespace isoscope
