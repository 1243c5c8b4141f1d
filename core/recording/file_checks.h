// Whether a file can be a recording of ours, and what is said where it is none.
#pragma once

#include "base/status.h"
#include "recording/page_file.h"

#include <filesystem>
#include <string>

namespace isoscope {

class Database;

/// "x.isorun is damaged: ...", with how to save what is sound.
Error damaged(const std::filesystem::path& file, const std::string& what);
/// What can be told without SQLite: that it is there, a plain file, and a database.
Status check_head(const std::filesystem::path& file);
/// The database that the pages of a file are, with its log or without it, once it is known to be a recording.
Result<Database> recording_over_pages(const std::filesystem::path& file, PageFile::Log log);
/// Whether the database is a recording of a version that this program reads.
Status check_version(Database& database, const std::filesystem::path& file);

} // namespace isoscope
