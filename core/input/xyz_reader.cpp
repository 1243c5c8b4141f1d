// Points as rows of numbers (XYZ, ASC, TXT, PTS, CSV): what separates the columns and what they mean is
// found, and told.
#include "base/numbers.h"
#include "input/mesh_readers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace isoscope {

namespace {

/// Lines above the first row that may be anything.
constexpr std::size_t most_header_lines = 100;
/// Rows from which the meaning of the columns is found.
constexpr std::size_t rows_to_judge = 1000;
constexpr std::size_t most_columns = 200;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

using Words = std::vector<std::string_view>;

/// Splits a line at blanks and, unless they are decimal points, at commas; always at semicolons. Two of these
/// with nothing between them have an empty word there.
void split(std::string_view line, bool decimal_commas, Words& words) {
  words.clear();
  std::size_t at = 0;
  bool wanted = false; // a comma or semicolon asks for one more word
  while (words.size() < most_columns) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at == line.size()) break;
    const auto separates = [&](char c) { return c == ';' || (c == ',' && !decimal_commas); };
    const std::size_t begin = at;
    while (at < line.size() && !is_blank(line[at]) && !separates(line[at])) ++at;
    if (at > begin || wanted || words.empty()) words.push_back(line.substr(begin, at - begin));
    while (at < line.size() && is_blank(line[at])) ++at;
    wanted = at < line.size() && separates(line[at]);
    if (wanted) ++at;
  }
}

/// Whether the commas of a row are decimal points: where semicolons or blanks stand between its words and no
/// word has two commas, or one at its end.
bool has_decimal_commas(std::string_view line) {
  if (line.find(',') == std::string_view::npos || line.find('.') != std::string_view::npos) return false;
  Words words;
  split(line, true, words);
  if (words.size() < 3) return false;
  return std::all_of(words.begin(), words.end(), [](std::string_view w) {
    const std::size_t comma = w.find(',');
    if (comma == std::string_view::npos) return true;
    return comma > 0 && comma + 1 < w.size() && is_digit(w[comma - 1]) && is_digit(w[comma + 1]) &&
           w.find(',', comma + 1) == std::string_view::npos;
  });
}

/// A number, not finite where it says so; nothing where it is none.
std::optional<double> number(std::string_view word, bool decimal_commas) {
  if (word.starts_with('+')) word.remove_prefix(1);
  std::array<char, 64> with_point{};
  if (decimal_commas && word.find(',') != std::string_view::npos && word.size() < with_point.size()) {
    std::replace_copy(word.begin(), word.end(), with_point.begin(), ',', '.');
    word = {with_point.data(), word.size()};
  }
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  if (stop == end && failure == std::errc{}) return value;
  if (stop == end && failure == std::errc::result_out_of_range) {
    const std::size_t exponent = word.find_first_of("eE");
    const bool tiny =
        exponent != std::string_view::npos && word.substr(exponent).find('-') != std::string_view::npos;
    return tiny ? 0 : HUGE_VAL;
  }
  if (word.starts_with('-')) word.remove_prefix(1);
  for (const std::string_view spelling : {"nan", "inf", "1.#ind", "1.#qnan", "1.#snan", "1.#inf", "null"})
    if (word.size() >= spelling.size() && same_word(word.substr(0, spelling.size()), spelling))
      return std::nan("");
  return std::nullopt;
}

std::string_view without_comment(std::string_view line) {
  for (const std::string_view mark : {"#", "//", "%", "!"})
    for (std::size_t at = line.find(mark); at != std::string_view::npos; at = line.find(mark, at + 1))
      if (at == 0 || is_blank(line[at - 1])) { // within a word it is a part of that: 1.#IND
        line = line.substr(0, at);
        break;
      }
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  return line;
}

class XyzReader {
 public:
  explicit XyzReader(FileScanner& in) : in_(in) {}

  PolygonFile read() {
    for (; in_.peek() != FileScanner::end_of_file; in_.next_line()) {
      const std::string_view text = in_.rest_of_line();
      const std::string_view line = without_comment(text);
      if (columns_ == 0) names_from(text);
      if (line.empty()) continue;
      if (columns_ == 0) {
        read_head(line);
      } else {
        split(line, decimal_commas_, words_);
        read_row();
      }
    }
    if (columns_ == 0)
      in_.fail("holds no row of three numbers", "Give points as rows of x, y and z, or a mesh file.");
    add_notes();
    return std::move(file_);
  }

 private:
  /// A line before the first row: a count, a title, or the first row itself.
  void read_head(std::string_view line) {
    const bool decimal_commas = has_decimal_commas(line);
    split(line, decimal_commas, words_);
    std::size_t numbers = 0;
    while (numbers < words_.size() && number(words_[numbers], decimal_commas)) ++numbers;
    if (numbers >= 3) {
      decimal_commas_ = decimal_commas;
      columns_ = words_.size();
      if (names_.size() != columns_) { // they are of something else
        names_.clear();
        coordinates_ = {0, 1, 2};
      }
      read_row();
      return;
    }
    if (numbers == 1 && words_.size() == 1) {
      has_counts_ = add_count(words_[0]);
      if (has_counts_) return;
    }
    if (numbers > 0) bad_row(words_.size() == numbers ? std::string_view() : words_[numbers]);
    if (++header_lines_ > most_header_lines)
      in_.fail("holds no row of three numbers in its first lines",
               "Give points as rows of x, y and z, or a mesh file.");
  }

  /// Columns by the names above them, where x, y and z are among these.
  void names_from(std::string_view text) {
    const std::size_t begin = text.find_first_not_of("#/%! \t");
    if (begin == std::string_view::npos) return;
    Words words;
    split(text.substr(begin), false, words);
    std::vector<std::string> names;
    for (std::string_view w : words) {
      while (!w.empty() && (w.front() == '"' || w.front() == '\'')) w.remove_prefix(1);
      while (!w.empty() && (w.back() == '"' || w.back() == '\'')) w.remove_suffix(1);
      names.emplace_back(w);
    }
    std::array<std::size_t, 3> at{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::string_view name = std::string_view("xyz").substr(a, 1);
      const auto is = [&](const std::string& n) { return same_word(n, name); };
      const auto found = std::find_if(names.begin(), names.end(), is);
      if (found == names.end()) return;
      at[a] = static_cast<std::size_t>(found - names.begin());
    }
    names_ = std::move(names);
    coordinates_ = at;
  }

  /// A line with nothing but the number of the points that follow, as PTS files have.
  bool add_count(std::string_view word) {
    std::uint64_t count = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (failure != std::errc{} || end != word.data() + word.size()) return false;
    announced_ += std::min<std::uint64_t>(count, std::uint64_t{1} << 40);
    return true;
  }

  void read_row() {
    if (words_.size() == 1 && has_counts_ && add_count(words_[0])) return; // another scan begins
    Vec3 p;
    for (std::size_t a = 0; a < 3; ++a) {
      if (coordinates_[a] >= words_.size()) bad_row({});
      const auto value = number(words_[coordinates_[a]], decimal_commas_);
      if (!value) bad_row(words_[coordinates_[a]]);
      p[static_cast<int>(a)] = *value;
    }
    ++rows_;
    if (words_.size() != columns_ && ragged_++ == 0) first_ragged_ = in_.line();
    if (!is_finite(p)) {
      if (dropped_++ == 0) first_dropped_ = in_.line();
      return;
    }
    file_.points.push_back(p);
    if (names_.empty() && rows_ <= rows_to_judge && words_.size() == columns_) keep_others();
  }

  /// The numbers beyond x, y and z, for find_meaning().
  void keep_others() {
    for (std::size_t c = 3; c < columns_; ++c)
      others_.push_back(number(words_[c], decimal_commas_).value_or(std::nan("")));
  }

  [[noreturn]] void bad_row(std::string_view word) const {
    if (word.empty() && words_.size() <= *std::max_element(coordinates_.begin(), coordinates_.end()))
      in_.fail_here("a point has fewer than three coordinates: " + counted(words_.size(), "number"),
                    "Complete or remove such rows.");
    in_.fail_here("\"" + printable(word) + "\" is no coordinate", "Correct or remove such rows.");
  }

  /// Whether all rows looked at, but a few, have three numbers there for which `is` holds.
  template <class Is> bool most_are(std::size_t column, const Is& is) const {
    const std::size_t others = columns_ - 3, n = others_.size() / others;
    std::size_t good = 0;
    for (std::size_t row = 0; row < n; ++row) {
      const double* v = others_.data() + row * others + (column - 3);
      good += is(Vec3{v[0], v[1], v[2]}) ? 1u : 0u;
    }
    return n > 0 && 10 * good >= 9 * n;
  }

  bool are_normals(std::size_t column) const {
    return most_are(column, [](Vec3 n) { return std::abs(squared_length(n) - 1) < 0.02; });
  }
  bool are_colours(std::size_t column) const {
    const auto within = [&](double most, bool whole) {
      return most_are(column, [&](Vec3 c) {
        for (int a = 0; a < 3; ++a)
          if (!(c[a] >= 0 && c[a] <= most) || (whole && c[a] != std::floor(c[a]))) return false;
        return true;
      });
    };
    return within(255, true) || within(1, false);
  }

  /// "normals and colours": what the columns beyond the first three look like.
  std::string find_meaning() const {
    std::vector<std::string> found;
    const auto triple = [&](std::size_t c) -> const char* {
      if (c + 3 > columns_) return nullptr;
      return are_normals(c) ? "normals" : are_colours(c) ? "colours" : nullptr;
    };
    for (std::size_t c = 3; c < columns_;) {
      // One number before three is an intensity, as in PTS files, not the first of the three.
      const bool single_first = columns_ - c == 4 && !are_normals(c) && triple(c + 1) != nullptr;
      if (const char* meaning = single_first ? nullptr : triple(c)) {
        found.emplace_back(meaning);
        c += 3;
        continue;
      }
      const std::string one = c == 3 ? "intensities" : "other values";
      if (found.empty() || found.back() != one) found.push_back(one);
      ++c;
    }
    std::string words;
    for (std::size_t i = 0; i < found.size(); ++i)
      words += (i == 0 ? "" : i + 1 == found.size() ? " and " : ", ") + found[i];
    return words;
  }

  void add_notes() {
    const auto note = [&](std::string text) { file_.notes.push_back({std::move(text)}); };
    if (!names_.empty() && columns_ > 3)
      note("Of its " + std::to_string(columns_) + " columns those named x, y and z are taken.");
    else if (columns_ > 3)
      note("Of its " + std::to_string(columns_) +
           " columns the first three are taken for x, y and z; the others look like " + find_meaning() +
           " and are passed over.");
    if (decimal_commas_) note("Its commas are read as decimal points.");
    if (dropped_ > 0) file_.notes.push_back(dropped_points_note(dropped_, first_dropped_));
    if (ragged_ > 0)
      note(counted(ragged_, "row") + (ragged_ == 1 ? " has" : " have") + " other than " +
           std::to_string(columns_) + " columns, the first on line " + std::to_string(first_ragged_) +
           ": coordinates are taken all the same.");
    if (has_counts_ && announced_ != rows_)
      note("It announces " + counted(announced_, "point") + " and holds " + grouped(rows_) + ".");
  }

  FileScanner& in_;
  PolygonFile file_;
  Words words_;
  std::vector<std::string> names_; ///< of the columns, where a line above tells x, y and z
  std::array<std::size_t, 3> coordinates_{0, 1, 2};
  std::vector<double> others_; ///< columns beyond the third of the first rows
  std::size_t columns_ = 0;    ///< of the first row; 0 before it
  std::size_t header_lines_ = 0;
  bool decimal_commas_ = false, has_counts_ = false;
  std::uint64_t rows_ = 0, announced_ = 0;
  std::uint64_t dropped_ = 0, first_dropped_ = 0; ///< points that are not finite, and the first one's line
  std::uint64_t ragged_ = 0, first_ragged_ = 0;
};

} // namespace

bool looks_like_points(std::string_view line) {
  return !line.empty() && line.find_first_not_of("0123456789+-.,;eE \t") == std::string_view::npos;
}

InputNote dropped_points_note(std::uint64_t dropped, std::uint64_t first_line) {
  const std::string where = first_line > 0 ? ", the first on line " + std::to_string(first_line) : "";
  return {counted(dropped, "point") +
          (dropped == 1 ? " has a coordinate that is" : " have coordinates that are") + " no number" + where +
          ": left out."};
}

PolygonFile read_xyz(FileScanner& in) {
  return XyzReader(in).read();
}

} // namespace isoscope
