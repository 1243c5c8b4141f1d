// Each look opens the pages anew, with the log and without it: a log that is older than the file would bring
// old pages back.
#include "recording/copy_reader.h"

#include "recording/database.h"
#include "recording/file_checks.h"
#include "recording/page_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <sys/stat.h>

namespace isoscope {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

/// Where somebody may still be writing, the same bytes are looked at again.
constexpr std::chrono::seconds at_rest{3};

/// What tells that a file is another one than before.
struct FileState {
  bool there = false;
  ino_t node = 0;
  off_t size = 0;
  Clock::time_point written;
  friend bool operator==(const FileState&, const FileState&) = default;
};

FileState state_of(const fs::path& file) {
  struct stat state {};
  if (::stat(file.c_str(), &state) != 0) return {};
  const auto since =
      std::chrono::seconds(state.st_mtim.tv_sec) + std::chrono::nanoseconds(state.st_mtim.tv_nsec);
  return {true, state.st_ino, state.st_size,
          Clock::time_point(std::chrono::duration_cast<Clock::duration>(since))};
}

/// Of the copy and the log beside it.
using CopyState = std::array<FileState, 2>;

} // namespace

bool lies_elsewhere(const fs::path& file) {
  std::error_code failure;
  const std::string place = fs::weakly_canonical(fs::absolute(file), failure).string();
  std::ifstream mounts("/proc/self/mounts");
  std::string kind, longest;
  for (std::string line; std::getline(mounts, line);) {
    std::istringstream words(line);
    std::string device, folder, type;
    words >> device >> folder >> type;
    const bool within = folder == "/" || place == folder || place.starts_with(folder + "/");
    if (!within || folder.size() < longest.size()) continue;
    longest = folder;
    kind = type;
  }
  constexpr std::array<std::string_view, 6> far{"nfs", "nfs4", "cifs", "smb3", "fuse.sshfs", "fuse.rclone"};
  return std::find(far.begin(), far.end(), kind) != far.end();
}

struct CopyReader::Impl {
  fs::path file;
  CopyState seen{};
  bool looked = false;
  std::unique_ptr<RecordingReader> reader;
  std::optional<RecordingEnd> end;
  std::optional<Error> torn, another;

  CopyState state() const { return {state_of(file), state_of(file.string() + "-wal")}; }

  std::optional<Clock::time_point> written() const {
    if (!seen[0].there) return std::nullopt;
    return seen[1].there ? std::max(seen[0].written, seen[1].written) : seen[0].written;
  }

  /// Whether there may be something that the last look has not seen.
  bool worth_a_look(const CopyState& now) const {
    return !looked || now != seen || (torn && Clock::now() - written().value_or(Clock::now()) < at_rest);
  }

  /// The pages as they are now, behind a reader that goes on where it was. False where they end before that.
  Result<bool> open(PageFile::Log log) {
    auto database = recording_over_pages(file, log);
    if (!database) return database.error();
    if (reader) return reader->go_on_in(std::move(*database));
    auto opened = RecordingReader::over(std::move(*database), file);
    if (!opened) return opened.error();
    reader = std::move(*opened);
    return true;
  }

  /// Reads on in one state of the pages; what ends it.
  Status read(PageFile::Log log, Journal& journal, const RunControl& control) {
    const auto opened = open(log);
    if (!opened) return opened.error();
    if (!*opened)
      return Error{ErrorCode::bad_input, file.string() + " ends before what was read of it already.", ""};
    while (!control.cancelled()) {
      const auto more = reader->read_commit(journal);
      if (!more) return more.error();
      if (!*more) break;
    }
    auto found = reader->end();
    if (!found) return found.error();
    if (*found) end = std::move(*found);
    return {};
  }

  Result<bool> look(Journal& journal, const RunControl& control) {
    if (another) return *another;
    const CopyState now = state();
    if (!worth_a_look(now)) return false;
    const std::size_t before = journal.events().size();
    const bool began = reader != nullptr, ended = end.has_value();
    seen = now;
    looked = true;
    torn.reset();
    for (const PageFile::Log log : {PageFile::Log::taken, PageFile::Log::ignored}) {
      if (end || (log == PageFile::Log::ignored && !now[1].there)) break;
      const std::size_t events = journal.events().size();
      const Status read_on = read(log, journal, control);
      if (!read_on &&
          (read_on.error().code == ErrorCode::usage || read_on.error().code == ErrorCode::unsupported)) {
        another = read_on.error();
        return *another;
      }
      // Of two views that which leads further tells what is missing.
      if (read_on)
        torn.reset();
      else if (log == PageFile::Log::taken || journal.events().size() > events)
        torn = read_on.error();
    }
    return journal.events().size() != before || (reader != nullptr) != began || end.has_value() != ended;
  }
};

CopyReader::CopyReader(fs::path file) : impl_(std::make_unique<Impl>()) {
  impl_->file = std::move(file);
}

CopyReader::~CopyReader() = default;

Result<bool> CopyReader::look(Journal& journal, const RunControl& control) {
  return impl_->look(journal, control);
}

const RecordingHeader* CopyReader::header() const {
  return impl_->reader ? &impl_->reader->header() : nullptr;
}

const std::optional<RecordingEnd>& CopyReader::end() const {
  return impl_->end;
}

const std::optional<Error>& CopyReader::torn() const {
  return impl_->torn;
}

std::uint64_t CopyReader::bytes() const {
  std::uint64_t bytes = 0;
  for (const FileState& state : impl_->seen) bytes += static_cast<std::uint64_t>(state.size);
  return bytes;
}

std::optional<Clock::time_point> CopyReader::written() const {
  return impl_->written();
}

} // namespace isoscope
