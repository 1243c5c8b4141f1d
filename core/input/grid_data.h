// The numbers of a grid as files hold them: of any type and byte order, plain or compressed by gzip.
#pragma once

#include "input/file_scanner.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isoscope {

enum class GridScalar : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

std::size_t bytes_of(GridScalar type);

/// What a file calls a type.
struct GridScalarName {
  std::string_view name;
  GridScalar type;
};
/// Bytes, or lines, that a header may have skipped.
inline constexpr std::int64_t most_skipped = std::int64_t{1} << 50;

/// How the numbers follow each other in a file, the first axis fastest.
struct GridData {
  std::array<std::size_t, 3> size{};
  GridScalar type = GridScalar::u8;
  bool big_endian = false;
  bool gzip = false;
  std::uint64_t skip = 0; ///< bytes in front of the numbers, after decompression
  bool at_end = false;    ///< the numbers are the last bytes of the file, whatever is in front
};

/// Reads them from where the scanner stands. Fails on missing bytes, on numbers that are not finite or too
/// large for a float, and where they do not fit the memory.
std::vector<float> read_grid_data(FileScanner& in, const GridData& data);

/// What errors call a file.
std::string name_of(const FileScanner& in);

/// Calls read(scanner) with the file that a header names, beside it unless its path is absolute; errors name
/// both files.
template <class Read> auto with_data_file(const FileScanner& header, const std::string& name, Read&& read) {
  bool opened = false;
  try {
    FileScanner in(header.file().parent_path() / name, header.control());
    opened = true;
    return read(in);
  } catch (MeshFileFailure& failure) {
    failure.error.message = name_of(header) + ": its data: " + failure.error.message;
    if (!opened) failure.error.remedy = "Correct the name of the data file in the header.";
    throw;
  }
}

/// One line of a grid's header; empty at the end of the file too. Lines of more than 10,000 characters fail.
struct HeaderLine {
  std::string text;
  bool ended = false; ///< by a line feed
};
HeaderLine read_header_line(FileScanner& in);

/// The blank-separated words of a line.
std::vector<std::string> words_of(std::string_view text);

/// What header readers share: fails with the number of the header's line, and reads what stands there.
class HeaderErrors {
 public:
  explicit HeaderErrors(FileScanner& in) : in_(&in) {}
  void next_line() { ++line_; }
  [[noreturn]] void fail(const std::string& what, const std::string& remedy = export_anew,
                         ErrorCode code = ErrorCode::bad_input) const;
  double number(const std::string& word) const; ///< finite
  /// In [least, most].
  std::int64_t whole(const std::string& word, std::int64_t least, std::int64_t most) const;
  /// The size of an axis.
  std::size_t extent(const std::string& word) const;

 private:
  FileScanner* in_;
  std::uint64_t line_ = 1;
};

} // namespace isoscope
