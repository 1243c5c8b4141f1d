// A bounded, line-counting view of a file's bytes and words, on which the mesh readers are built.
//
// The readers are our own and not CGAL's: CGAL's readers do not check all face indices, believe the counts of
// a header, take numbers through streams that depend on the locale, and cannot say on which line a file goes
// wrong. The tests compare the two on good files.
#pragma once

#include "base/pending_file.h"
#include "base/run_control.h"
#include "base/status.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace isoscope {

/// What to do with a file that is wrong where only its program can mend it.
inline constexpr const char* export_anew = "Repair or export it anew.";

/// Thrown by the scanner and the readers on it, caught by read_mesh; never leaves core/input.
struct MeshFileFailure {
  Error error;
};

/// Reads a regular file front to back through a fixed buffer. Lines end with LF, CR or CR LF. Every function
/// throws MeshFileFailure on a read error, and with ErrorCode::cancelled once the control says so.
class FileScanner {
 public:
  static constexpr int end_of_file = -1;

  /// Refuses what is missing, unreadable, empty or no regular file. `control` outlives the scanner.
  FileScanner(const std::filesystem::path& file, const RunControl& control);
  ~FileScanner();
  FileScanner(const FileScanner&) = delete;
  FileScanner& operator=(const FileScanner&) = delete;

  const std::filesystem::path& file() const { return file_; }
  const RunControl& control() const { return *control_; }
  std::uint64_t size() const { return size_; } ///< bytes of the whole file
  /// Bytes not yet consumed; of text in UTF-16 no less than its characters.
  std::uint64_t remaining() const { return unread_ + (filled_ - position_); }
  std::uint64_t line() const { return line_; } ///< 1-based; counts only what was read as text

  /// The first bytes of the file, at most 4 KiB; only before anything was consumed.
  std::string_view head();
  /// From now on the file is UTF-16 behind its mark of two bytes; whatever is not ASCII reads as '?'. Only
  /// before anything was consumed.
  void decode_utf16(bool big_endian);

  int peek() {
    if (position_ == filled_ && !refill()) return end_of_file;
    return static_cast<unsigned char>(buffer_[position_]);
  }
  /// Copies the next `count` bytes to `target` (binary data: lines are not counted); false when the file ends
  /// before.
  bool read(void* target, std::size_t count);
  /// Passes over `count` bytes; false when the file ends before.
  bool skip(std::uint64_t count);

  /// Where the scanner is, to come back to.
  struct Mark {
    std::uint64_t block = 0; ///< bytes of the file before the buffer
    std::size_t position = 0;
    std::uint64_t line = 1;
  };
  Mark mark() const { return {block_, position_, line_}; }
  void return_to(const Mark& mark);

  /// Passes blanks of this line; a comment character, when not 0, ends the line.
  void skip_blanks(char comment = '#');
  /// Whether nothing but blanks or a comment is left on this line.
  bool at_line_end(char comment = '#');
  /// Whether a word ends here.
  bool at_word_end();
  /// Goes to the start of the next line. LF behind CR belongs to it unless the first line of the file ends
  /// with CR alone: the data behind a binary header may begin with the byte of an LF.
  void next_line();
  /// Goes to the next line that has a word on it, or to the end of the file; stays if this line still has
  /// one.
  void skip_empty_lines(char comment = '#');
  /// The next word of this line, empty at its end; valid until the next call. Longer than 200 characters
  /// fails.
  std::string_view word(char comment = '#');
  /// What is left of this line, without its end; valid until the next call. Longer than 10,000 characters
  /// fails.
  std::string_view rest_of_line();
  /// The next word of this file, on whatever line; `what` is missed when the file ends.
  std::string_view word_across_lines(std::string_view what, char comment = '#');

  /// A finite number written with a decimal point.
  double to_number(std::string_view word) const;
  /// A number that nothing depends on, as of a colour or a normal: it may be "nan" or "inf" too, in the
  /// spellings of all compilers.
  double to_attribute(std::string_view word) const;
  /// A whole number that fits 64 bits.
  std::int64_t to_integer(std::string_view word) const;

  /// Fails with bad_input: "FILE, line N: what" and a remedy.
  [[noreturn]] void fail_here(const std::string& what, const std::string& remedy = {}) const {
    fail_at(line_, what, remedy);
  }
  [[noreturn]] void fail_at(std::uint64_t line, const std::string& what, const std::string& remedy) const;
  /// Fails: "FILE: what" and a remedy.
  [[noreturn]] void fail(const std::string& what, const std::string& remedy = {},
                         ErrorCode code = ErrorCode::bad_input) const;
  /// Fails when `count` things of at least `bytes_each` bytes cannot follow in this file, or when holding
  /// them (`memory_each` bytes each) is beyond this machine.
  void check_count(std::uint64_t count, std::string_view things, std::uint64_t bytes_each,
                   std::uint64_t memory_each) const;

 private:
  enum class Encoding : std::uint8_t { bytes, utf16_little_endian, utf16_big_endian };

  bool refill();
  void decode_buffer(std::size_t from);

  std::filesystem::path file_;
  const RunControl* control_;
  int descriptor_ = -1;
  Encoding encoding_ = Encoding::bytes;
  bool lone_cr_ = false; ///< the first line ends with CR alone
  std::uint64_t size_ = 0, unread_ = 0, block_ = 0, block_bytes_ = 0, line_ = 1;
  std::vector<char> buffer_;
  std::size_t position_ = 0, filled_ = 0;
  std::array<char, 200> word_{};
  std::string line_text_; ///< of a line that crosses the buffer's end
};

/// What read(scanner) makes of a file, or why that cannot be. `remedy`: where it needs more memory than there
/// is.
template <class Read>
auto scan_file(const std::filesystem::path& file, const RunControl& control, const char* remedy,
               const Read& read) -> Result<std::invoke_result_t<const Read&, FileScanner&>> {
  const auto too_large = [&] {
    return Error{ErrorCode::bad_input,
                 printable(file.native(), 1000) + ": needs more memory than this machine has.", remedy};
  };
  try {
    FileScanner in(file, control);
    return read(in);
  } catch (const MeshFileFailure& failure) {
    return failure.error;
  } catch (const std::bad_alloc&) {
    return too_large();
  } catch (const std::length_error&) {
    return too_large();
  }
}

/// Whether two words are the same but for upper and lower case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

} // namespace isoscope
