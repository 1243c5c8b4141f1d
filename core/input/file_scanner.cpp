// Buffered reading, words and numbers without locale.
#include "input/file_scanner.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isoscope {

namespace {

constexpr std::size_t buffer_size = 1 << 18;
constexpr std::size_t head_size = 1 << 12;
constexpr std::size_t byte_order_mark = 2; ///< bytes in front of UTF-16

bool is_blank(int c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_line_end(int c) {
  return c == '\n' || c == '\r';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool begins_with_word(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && same_word(text.substr(0, word.size()), word);
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

std::uint64_t physical_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page)
                               : ~std::uint64_t{0};
}

} // namespace

FileScanner::FileScanner(const std::filesystem::path& file, const RunControl& control)
    : file_(file), control_(&control) {
  struct stat info {};
  const std::string give = "Give the path of an OFF, OBJ, PLY, STL or XYZ file.";
  // Asked before opening, since opening a pipe or a device may wait or have effects.
  if (::stat(file.c_str(), &info) != 0) fail("cannot be opened (" + reason(errno) + ")", give);
  if (!S_ISREG(info.st_mode)) fail(std::string("is ") + kind_of(info.st_mode) + ", not a file", give);
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) {
    const int error = errno;
    fail("cannot be read (" + reason(error) + ")", error == EACCES ? "Check its permissions." : give);
  }
  size_ = static_cast<std::uint64_t>(std::max<off_t>(0, info.st_size));
  if (size_ == 0) {
    ::close(descriptor_);
    fail("is empty", give);
  }
  unread_ = size_;
  buffer_.resize(buffer_size);
}

FileScanner::~FileScanner() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool FileScanner::refill() {
  if (control_->cancelled()) fail("was left while it was read", {}, ErrorCode::cancelled);
  block_ += block_bytes_;
  position_ = filled_ = 0;
  block_bytes_ = 0;
  // Whole blocks, so that no character of two bytes is cut in half.
  while (block_bytes_ < buffer_.size()) {
    const ssize_t got = ::read(descriptor_, buffer_.data() + block_bytes_, buffer_.size() - block_bytes_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot be read on (" + reason(errno) + ")", "Check the disk or the network share.");
    if (got == 0) break;
    block_bytes_ += static_cast<std::size_t>(got);
  }
  unread_ -= std::min(unread_, block_bytes_);
  filled_ = static_cast<std::size_t>(block_bytes_);
  if (encoding_ != Encoding::bytes) {
    if (block_ == 0) position_ = std::min(byte_order_mark, filled_);
    decode_buffer(position_);
  }
  return filled_ > position_;
}

void FileScanner::decode_buffer(std::size_t from) {
  const std::size_t high = encoding_ == Encoding::utf16_big_endian ? 0 : 1;
  std::size_t to = from;
  for (std::size_t i = from; i + 1 < filled_; i += 2) {
    const char letter = buffer_[i + 1 - high];
    const bool ascii = buffer_[i + high] == 0 && static_cast<unsigned char>(letter) < 0x80;
    buffer_[to++] = ascii ? letter : '?';
  }
  filled_ = to;
}

std::string_view FileScanner::head() {
  peek();
  const std::string_view bytes(buffer_.data() + position_, std::min(filled_ - position_, head_size));
  const std::size_t end = bytes.find_first_of("\r\n");
  lone_cr_ =
      end != std::string_view::npos && bytes[end] == '\r' && end + 1 < bytes.size() && bytes[end + 1] != '\n';
  return bytes;
}

void FileScanner::decode_utf16(bool big_endian) {
  peek();
  encoding_ = big_endian ? Encoding::utf16_big_endian : Encoding::utf16_little_endian;
  position_ = std::min(byte_order_mark, filled_);
  decode_buffer(position_);
}

void FileScanner::return_to(const Mark& mark) {
  if (mark.block != block_) {
    if (::lseek(descriptor_, static_cast<off_t>(mark.block), SEEK_SET) < 0)
      fail("cannot be read again (" + reason(errno) + ")", "Check the disk or the network share.");
    unread_ = size_ - std::min(size_, mark.block);
    block_ = mark.block;
    block_bytes_ = 0;
    refill();
  }
  position_ = std::min(mark.position, filled_);
  line_ = mark.line;
}

bool FileScanner::read(void* target, std::size_t count) {
  char* out = static_cast<char*>(target);
  while (count > 0) {
    if (position_ == filled_ && !refill()) return false;
    const std::size_t n = std::min(count, filled_ - position_);
    std::memcpy(out, buffer_.data() + position_, n);
    position_ += n;
    out += n;
    count -= n;
  }
  return true;
}

bool FileScanner::skip(std::uint64_t count) {
  while (count > 0) {
    if (position_ == filled_ && !refill()) return false;
    const std::uint64_t n = std::min<std::uint64_t>(count, filled_ - position_);
    position_ += n;
    count -= n;
  }
  return true;
}

void FileScanner::skip_blanks(char comment) {
  while (is_blank(peek())) ++position_;
  if (comment != 0 && peek() == comment)
    while (!is_line_end(peek()) && peek() != end_of_file) ++position_;
}

bool FileScanner::at_line_end(char comment) {
  skip_blanks(comment);
  return is_line_end(peek()) || peek() == end_of_file;
}

bool FileScanner::at_word_end() {
  const int c = peek();
  return c == end_of_file || is_line_end(c) || is_blank(c);
}

void FileScanner::next_line() {
  while (!is_line_end(peek()) && peek() != end_of_file) ++position_;
  if (peek() == end_of_file) return;
  const bool cr = peek() == '\r';
  ++position_;
  ++line_;
  if (cr && !lone_cr_ && peek() == '\n') ++position_;
}

void FileScanner::skip_empty_lines(char comment) {
  while (at_line_end(comment) && peek() != end_of_file) next_line();
}

std::string_view FileScanner::word(char comment) {
  skip_blanks(comment);
  std::size_t length = 0;
  for (int c = peek(); c != end_of_file && !is_line_end(c) && !is_blank(c) && !(comment != 0 && c == comment);
       c = peek()) {
    if (length == word_.size())
      fail_here("a word of more than 200 characters stands where a number or keyword is expected",
                "Is this the right file?");
    word_[length++] = static_cast<char>(c);
    ++position_;
  }
  return {word_.data(), length};
}

std::string_view FileScanner::rest_of_line() {
  constexpr std::size_t longest = 10000;
  line_text_.clear();
  for (;;) {
    std::size_t end = position_;
    while (end < filled_ && !is_line_end(buffer_[end])) ++end;
    const std::string_view part(buffer_.data() + position_, end - position_);
    position_ = end;
    if (line_text_.size() + part.size() > longest)
      fail_here("a line of more than " + std::to_string(longest) + " characters", "Is this the right file?");
    if (end < filled_ && line_text_.empty()) return part;
    line_text_ += part;
    if (end < filled_ || peek() == end_of_file) return line_text_;
  }
}

std::string_view FileScanner::word_across_lines(std::string_view what, char comment) {
  skip_empty_lines(comment);
  const std::string_view w = word(comment);
  if (w.empty())
    fail_here("the file ends before " + std::string(what),
              "It seems cut off: get it again or export it anew.");
  return w;
}

double FileScanner::to_number(std::string_view text) const {
  std::string_view digits = text;
  if (!digits.empty() && digits[0] == '+') digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range && digits.find_first_of("eE") != std::string_view::npos &&
      digits.find("-", digits.find_first_of("eE")) != std::string_view::npos)
    return 0; // too small for a double
  if (error == std::errc::result_out_of_range)
    fail_here("the number " + printable(text) + " is too large", "Rescale the model.");
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    const bool comma = text.find(',') != std::string_view::npos;
    fail_here("\"" + printable(text) + "\" is not a number",
              comma ? "Write numbers with a decimal point and separate them by blanks." : export_anew);
  }
  if (!std::isfinite(value))
    fail_here("the coordinate " + printable(text) + " is not finite",
              "Remove such vertices or export it anew.");
  return value;
}

double FileScanner::to_attribute(std::string_view text) const {
  std::string_view name = text;
  if (!name.empty() && (name[0] == '+' || name[0] == '-')) name.remove_prefix(1);
  for (const std::string_view spelling : {"nan", "1.#ind", "1.#qnan", "1.#snan"})
    if (begins_with_word(name, spelling)) return std::nan("");
  for (const std::string_view spelling : {"inf", "1.#inf"})
    if (begins_with_word(name, spelling)) return text[0] == '-' ? -HUGE_VAL : HUGE_VAL;
  return to_number(text);
}

std::int64_t FileScanner::to_integer(std::string_view text) const {
  std::string_view digits = text;
  if (!digits.empty() && digits[0] == '+') digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size())
    fail_here("\"" + printable(text) + "\" is not a whole number", export_anew);
  return value;
}

void FileScanner::fail_at(std::uint64_t line, const std::string& what, const std::string& remedy) const {
  const std::string place = printable(file_.native(), 1000) + ", line " + std::to_string(line);
  throw MeshFileFailure{Error{ErrorCode::bad_input, place + ": " + what + ".", remedy}};
}

void FileScanner::fail(const std::string& what, const std::string& remedy, ErrorCode code) const {
  throw MeshFileFailure{Error{code, printable(file_.native(), 1000) + ": " + what + ".", remedy}};
}

void FileScanner::check_count(std::uint64_t count, std::string_view things, std::uint64_t bytes_each,
                              std::uint64_t memory_each) const {
  const std::string announced = "announces " + std::to_string(count) + " " + std::string(things);
  // One byte of grace: the last line needs no line feed.
  if (bytes_each > 0 && count > (remaining() + 1) / bytes_each)
    fail(announced + ", but only " + std::to_string(remaining()) + " bytes follow",
         "It seems cut off or damaged: get it again or export it anew.");
  if (memory_each > 0 && count > physical_memory() / 2 / memory_each)
    fail(announced + ", more than this machine's memory can hold", "Simplify or split the model.");
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

} // namespace isoscope
