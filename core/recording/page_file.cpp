// The log's frames are taken up to its last commit, without those whose checksum is wrong.
#include "recording/page_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t usual_page = 4096, log_header = 32, frame_header = 24;
constexpr std::uint32_t log_magic =
    0x377f0682; ///< its lowest bit: the checksum's numbers have the highest byte first

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t v = 0;
  for (std::size_t i = 0; i < 4; ++i) v = v << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return v;
}

/// Two sums over pairs of numbers, as the log's format says.
struct LogChecksum {
  std::uint32_t a = 0, b = 0;
  bool highest_first = false;
  void add(std::string_view bytes) {
    const auto number = [&](std::size_t at) {
      const std::uint32_t v = number_at(bytes, at);
      return highest_first ? v : v << 24 | (v & 0xff00) << 8 | (v >> 8 & 0xff00) | v >> 24;
    };
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
      a += number(at) + b;
      b += number(at + 4) + a;
    }
  }
  bool is(std::string_view bytes, std::size_t at) const {
    return number_at(bytes, at) == a && number_at(bytes, at + 4) == b;
  }
  void set(std::string_view bytes, std::size_t at) {
    a = number_at(bytes, at);
    b = number_at(bytes, at + 4);
  }
};

std::string read_at(std::ifstream& in, std::uint64_t at, std::size_t size) {
  std::string bytes(size, '\0');
  in.clear();
  in.seekg(static_cast<std::streamoff>(at));
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return bytes;
}

} // namespace

bool has_stale_log(const fs::path& file) {
  std::error_code failure;
  if (!fs::exists(file.string() + "-wal", failure)) return false;
  std::ifstream in(file, std::ios::binary);
  constexpr std::uint64_t versions = 18; // for writing and for reading: 1 without a log, 2 with one
  return read_at(in, versions, 2) == "\1\1";
}

Result<PageFile> PageFile::open(const fs::path& file, Log log) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure))
    return Error{ErrorCode::bad_input, file.string() + " is no file.", "Check the name."};
  PageFile pages;
  pages.main_.open(file, std::ios::binary);
  const std::uint64_t bytes = fs::file_size(file, failure);
  if (!pages.main_ || failure)
    return Error{ErrorCode::io, "Cannot read " + file.string() + ".", "Check its permissions."};
  const std::string head = read_at(pages.main_, 16, 2);
  if (head.size() == 2)
    pages.page_size_ = static_cast<std::size_t>(number_at(std::string(2, '\0') + head, 0));
  if (pages.page_size_ == 1) pages.page_size_ = 65536;
  if (!std::has_single_bit(pages.page_size_) || pages.page_size_ < 512) pages.page_size_ = usual_page;
  pages.pages_ = static_cast<std::size_t>((bytes + pages.page_size_ - 1) / pages.page_size_);
  if (log == Log::taken && !has_stale_log(file)) pages.read_log(file);
  return pages;
}

void PageFile::read_log(const fs::path& file) {
  log_.open(file.string() + "-wal", std::ios::binary);
  if (!log_) return;
  const std::string header = read_at(log_, 0, log_header);
  if (header.size() < log_header || (number_at(header, 0) & ~1u) != log_magic ||
      number_at(header, 8) != page_size_)
    return;
  LogChecksum sum;
  sum.highest_first = (number_at(header, 0) & 1) != 0;
  sum.set(header, 24);
  std::map<std::uint32_t, std::uint64_t> transaction;
  for (std::uint64_t at = log_header;; at += frame_header + page_size_) {
    const std::string frame = read_at(log_, at, frame_header + page_size_);
    if (frame.size() < frame_header + page_size_ || frame.compare(8, 8, header, 16, 8) != 0) break;
    sum.add(std::string_view(frame).substr(0, 8));
    sum.add(std::string_view(frame).substr(frame_header));
    const std::uint32_t number = number_at(frame, 0), size_after = number_at(frame, 4);
    if (sum.is(frame, 16)) {
      transaction[number] = at + frame_header;
      if (size_after != 0) {
        for (const auto& [page, place] : transaction) logged_[page] = place;
        pages_ = std::max<std::size_t>(pages_, size_after);
        transaction.clear();
      }
    }
    sum.set(frame, 16); // what follows was summed from what was written there
  }
}

std::string PageFile::page(std::uint32_t number) {
  if (const auto found = logged_.find(number); found != logged_.end())
    return read_at(log_, found->second, page_size_);
  return read_at(main_, std::uint64_t{number - 1} * page_size_, page_size_);
}

} // namespace isoscope
