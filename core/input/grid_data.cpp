// Plain bytes through the scanner, compressed ones through zlib: it is on every system and used as C, where
// Boost's streams would add a library that calls the same zlib.
#include "input/grid_data.h"

#include "base/numbers.h"
#include "base/pending_file.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace isoscope {
namespace {

const std::string cut_off = "It seems cut off or damaged: get it again or export it anew.";
constexpr std::size_t longest_line = 10000;
constexpr std::size_t block_bytes = 1 << 16;
/// Numbers between two questions whether to go on.
constexpr std::size_t block_numbers = 1 << 13;
/// Deflate makes no more than so many bytes of one.
constexpr std::uint64_t most_expansion = 1032;
constexpr std::size_t largest_extent = 1 << 20;

/// The bytes of a file's data, as they are.
class PlainBytes {
 public:
  explicit PlainBytes(FileScanner& in) : in_(in) {}
  void read(void* target, std::size_t count) {
    if (!in_.read(target, count)) in_.fail("ends within its numbers", cut_off);
  }
  void skip(std::uint64_t count) {
    if (!in_.skip(count)) in_.fail("ends before its numbers", cut_off);
  }

 private:
  FileScanner& in_;
};

/// The bytes that gzip has packed.
class UnpackedBytes {
 public:
  explicit UnpackedBytes(FileScanner& in) : in_(in), packed_(block_bytes) {
    constexpr int gzip_header = 16;
    if (inflateInit2(&stream_, MAX_WBITS + gzip_header) != Z_OK) throw std::bad_alloc();
  }
  ~UnpackedBytes() { inflateEnd(&stream_); }
  UnpackedBytes(const UnpackedBytes&) = delete;
  UnpackedBytes& operator=(const UnpackedBytes&) = delete;

  void read(void* target, std::size_t count) {
    stream_.next_out = static_cast<Bytef*>(target);
    stream_.avail_out = static_cast<uInt>(count);
    while (stream_.avail_out > 0) {
      if (stream_.avail_in == 0) fill();
      const int told = inflate(&stream_, Z_NO_FLUSH);
      if (told == Z_STREAM_END && stream_.avail_out > 0) in_.fail("holds too few numbers", cut_off);
      if (told != Z_OK && told != Z_STREAM_END) in_.fail("holds compressed data that is damaged", cut_off);
    }
  }
  void skip(std::uint64_t count) {
    std::vector<char> passed(block_bytes);
    while (count > 0) {
      const auto n = static_cast<std::size_t>(std::min<std::uint64_t>(count, block_bytes));
      read(passed.data(), n);
      count -= n;
    }
  }

 private:
  void fill() {
    const auto n = static_cast<std::size_t>(std::min<std::uint64_t>(in_.remaining(), block_bytes));
    if (n == 0 || !in_.read(packed_.data(), n)) in_.fail("ends within its numbers", cut_off);
    stream_.next_in = packed_.data();
    stream_.avail_in = static_cast<uInt>(n);
  }

  FileScanner& in_;
  std::vector<Bytef> packed_;
  z_stream stream_{};
};

template <class T> T number_at(const char* bytes, bool swapped) {
  std::array<char, sizeof(T)> own{};
  std::memcpy(own.data(), bytes, own.size());
  if (swapped) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

double number_at(const char* bytes, GridScalar type, bool swapped) {
  switch (type) {
  case GridScalar::i8:
    return number_at<std::int8_t>(bytes, swapped);
  case GridScalar::u8:
    return number_at<std::uint8_t>(bytes, swapped);
  case GridScalar::i16:
    return number_at<std::int16_t>(bytes, swapped);
  case GridScalar::u16:
    return number_at<std::uint16_t>(bytes, swapped);
  case GridScalar::i32:
    return number_at<std::int32_t>(bytes, swapped);
  case GridScalar::u32:
    return number_at<std::uint32_t>(bytes, swapped);
  case GridScalar::i64:
    return static_cast<double>(number_at<std::int64_t>(bytes, swapped));
  case GridScalar::u64:
    return static_cast<double>(number_at<std::uint64_t>(bytes, swapped));
  case GridScalar::f32:
    return static_cast<double>(number_at<float>(bytes, swapped));
  case GridScalar::f64:
    return number_at<double>(bytes, swapped);
  }
  return 0;
}

std::string voxel_name(std::size_t i, const std::array<std::size_t, 3>& size) {
  return "(" + std::to_string(i % size[0]) + ", " + std::to_string(i / size[0] % size[1]) + ", " +
         std::to_string(i / (size[0] * size[1])) + ")";
}

template <class Bytes> std::vector<float> read_numbers(FileScanner& in, Bytes&& bytes, const GridData& data) {
  bytes.skip(data.skip);
  const std::size_t count = data.size[0] * data.size[1] * data.size[2], each = bytes_of(data.type);
  const bool swapped = data.big_endian == (std::endian::native == std::endian::little);
  std::vector<float> values(count);
  std::vector<char> block(block_numbers * each);
  for (std::size_t begin = 0; begin < count; begin += block_numbers) {
    if (in.control().cancelled()) in.fail("was left while it was read", {}, ErrorCode::cancelled);
    const std::size_t n = std::min(block_numbers, count - begin);
    bytes.read(block.data(), n * each);
    for (std::size_t i = 0; i < n; ++i) {
      const double value = number_at(block.data() + i * each, data.type, swapped);
      if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
        in.fail("holds " +
                    std::string(std::isfinite(value) ? "a number too large for a float"
                                                     : "a value that is not finite") +
                    " at voxel " + voxel_name(begin + i, data.size),
                "Replace such values, as by the least one.");
      values[begin + i] = static_cast<float>(value);
    }
  }
  return values;
}

} // namespace

std::size_t bytes_of(GridScalar type) {
  switch (type) {
  case GridScalar::i8:
  case GridScalar::u8:
    return 1;
  case GridScalar::i16:
  case GridScalar::u16:
    return 2;
  case GridScalar::i32:
  case GridScalar::u32:
  case GridScalar::f32:
    return 4;
  case GridScalar::i64:
  case GridScalar::u64:
  case GridScalar::f64:
    return 8;
  }
  return 8;
}

std::vector<float> read_grid_data(FileScanner& in, const GridData& data) {
  const std::uint64_t count = std::uint64_t{data.size[0]} * data.size[1] * data.size[2];
  const std::uint64_t each = bytes_of(data.type);
  if (data.gzip) {
    in.check_count((count * each + most_expansion - 1) / most_expansion, "compressed bytes", 1, 0);
    in.check_count(count, "numbers", 0, sizeof(float));
    return read_numbers(in, UnpackedBytes(in), data);
  }
  in.check_count(count, "numbers", each, sizeof(float));
  if (data.at_end) {
    if (in.remaining() < count * each) in.fail("ends within its numbers", cut_off);
    if (!in.skip(in.remaining() - count * each)) in.fail("ends before its numbers", cut_off);
  }
  return read_numbers(in, PlainBytes(in), data);
}

std::string name_of(const FileScanner& in) {
  return printable(in.file().native(), 1000);
}

HeaderLine read_header_line(FileScanner& in) {
  HeaderLine line;
  char c = 0;
  while (!line.ended && in.peek() != FileScanner::end_of_file && in.read(&c, 1)) {
    line.ended = c == '\n';
    if (!line.ended) line.text += c;
    if (line.text.size() > longest_line)
      in.fail("has a line of more than " + grouped(longest_line) + " characters in its header",
              "Is this the right file?");
  }
  if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
  return line;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0;;) {
    begin = text.find_first_not_of(" \t", begin);
    if (begin == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
    words.emplace_back(text.substr(begin, end - begin));
    begin = end;
  }
}

void HeaderErrors::fail(const std::string& what, const std::string& remedy, ErrorCode code) const {
  throw MeshFileFailure{
      Error{code, name_of(*in_) + ", line " + std::to_string(line_) + ": " + what + ".", remedy}};
}

double HeaderErrors::number(const std::string& word) const {
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
    fail("\"" + printable(word) + "\" is no finite number");
  return value;
}

std::int64_t HeaderErrors::whole(const std::string& word, std::int64_t least, std::int64_t most) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || value < least || value > most)
    fail("\"" + printable(word) + "\" is no whole number from " + std::to_string(least) + " to " +
         std::to_string(most));
  return value;
}

std::size_t HeaderErrors::extent(const std::string& word) const {
  return static_cast<std::size_t>(whole(word, 1, largest_extent));
}

} // namespace isoscope
