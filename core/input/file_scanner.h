// A bounded, line-counting view of a file's bytes and words, on which the mesh readers are built.
//
// The readers are our own and not CGAL's: CGAL's readers do not check all face indices, believe the counts of
// a header, take numbers through streams that depend on the locale, and cannot say on which line a file goes
// wrong. The tests compare the two on good files.
#pragma once

#include "base/pending_file.h"
#include "base/status.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Thrown by the scanner and the readers on it, caught by read_mesh; never leaves core/input.
struct MeshFileFailure {
  Error error;
};

/// Reads a regular file front to back through a fixed buffer. Every function throws MeshFileFailure on a read
/// error.
class FileScanner {
 public:
  static constexpr int end_of_file = -1;

  /// Refuses what is missing, unreadable, empty or no regular file.
  explicit FileScanner(const std::filesystem::path& file);
  ~FileScanner();
  FileScanner(const FileScanner&) = delete;
  FileScanner& operator=(const FileScanner&) = delete;

  const std::filesystem::path& file() const { return file_; }
  std::uint64_t size() const { return size_; }               ///< bytes of the whole file
  std::uint64_t offset() const { return base_ + position_; } ///< bytes consumed so far
  std::uint64_t remaining() const { return size_ > offset() ? size_ - offset() : 0; }
  std::uint64_t line() const { return line_; } ///< 1-based; counts only what was read as text

  /// The first bytes of the file, at most 4 KiB; only before anything was consumed.
  std::string_view head();

  int peek() {
    if (position_ == filled_ && !refill()) return end_of_file;
    return static_cast<unsigned char>(buffer_[position_]);
  }
  int get() {
    const int c = peek();
    if (c != end_of_file) ++position_;
    if (c == '\n') ++line_;
    return c;
  }
  /// Copies the next `count` bytes to `target` (binary data: lines are not counted); false when the file ends
  /// before.
  bool read(void* target, std::size_t count);
  /// Passes over `count` bytes; false when the file ends before.
  bool skip(std::uint64_t count);

  /// Passes blanks of this line; a comment character, when not 0, ends the line.
  void skip_blanks(char comment = '#');
  /// Whether nothing but blanks or a comment is left on this line.
  bool at_line_end(char comment = '#');
  /// Goes to the start of the next line.
  void next_line();
  /// Goes to the next line that has a word on it, or to the end of the file; stays if this line still has
  /// one.
  void skip_empty_lines(char comment = '#');
  /// The next word of this line, empty at its end; valid until the next call. Longer than 200 characters
  /// fails.
  std::string_view word(char comment = '#');
  /// The next word of this file, on whatever line; `what` is missed when the file ends.
  std::string_view word_across_lines(std::string_view what, char comment = '#');

  /// A finite number written with a decimal point.
  double to_number(std::string_view word) const;
  /// A whole number that fits 64 bits.
  std::int64_t to_integer(std::string_view word) const;

  /// Fails with bad_input: "FILE, line N: what" and a remedy.
  [[noreturn]] void fail_here(const std::string& what, const std::string& remedy = {}) const;
  /// Fails: "FILE: what" and a remedy.
  [[noreturn]] void fail(const std::string& what, const std::string& remedy = {},
                         ErrorCode code = ErrorCode::bad_input) const;
  /// Fails when `count` things of at least `bytes_each` bytes cannot follow in this file, or when holding
  /// them
  /// (`memory_each` bytes each) is beyond this machine.
  void check_count(std::uint64_t count, std::string_view things, std::uint64_t bytes_each,
                   std::uint64_t memory_each) const;

 private:
  bool refill();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0, base_ = 0, line_ = 1;
  std::vector<char> buffer_;
  std::size_t position_ = 0, filled_ = 0;
  std::array<char, 200> word_{};
};

} // namespace isoscope
