// NRRD: a text header of fields, then, or in a file of their own, the numbers. Read are grids of three axes
// that run along the axes of space, in any order and direction.
#include "input/grid_readers.h"

#include "base/pending_file.h"
#include "input/grid_data.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace isoscope {
namespace {

constexpr std::uint64_t most_header_bytes = 1 << 20;
constexpr std::size_t most_axes = 16;

constexpr GridScalarName nrrd_types[] = {{"signed char", GridScalar::i8},
                                         {"int8", GridScalar::i8},
                                         {"int8_t", GridScalar::i8},
                                         {"uchar", GridScalar::u8},
                                         {"unsigned char", GridScalar::u8},
                                         {"uint8", GridScalar::u8},
                                         {"uint8_t", GridScalar::u8},
                                         {"short", GridScalar::i16},
                                         {"short int", GridScalar::i16},
                                         {"signed short", GridScalar::i16},
                                         {"signed short int", GridScalar::i16},
                                         {"int16", GridScalar::i16},
                                         {"int16_t", GridScalar::i16},
                                         {"ushort", GridScalar::u16},
                                         {"unsigned short", GridScalar::u16},
                                         {"unsigned short int", GridScalar::u16},
                                         {"uint16", GridScalar::u16},
                                         {"uint16_t", GridScalar::u16},
                                         {"int", GridScalar::i32},
                                         {"signed int", GridScalar::i32},
                                         {"int32", GridScalar::i32},
                                         {"int32_t", GridScalar::i32},
                                         {"uint", GridScalar::u32},
                                         {"unsigned int", GridScalar::u32},
                                         {"uint32", GridScalar::u32},
                                         {"uint32_t", GridScalar::u32},
                                         {"longlong", GridScalar::i64},
                                         {"long long", GridScalar::i64},
                                         {"long long int", GridScalar::i64},
                                         {"signed long long", GridScalar::i64},
                                         {"signed long long int", GridScalar::i64},
                                         {"int64", GridScalar::i64},
                                         {"int64_t", GridScalar::i64},
                                         {"ulonglong", GridScalar::u64},
                                         {"unsigned long long", GridScalar::u64},
                                         {"unsigned long long int", GridScalar::u64},
                                         {"uint64", GridScalar::u64},
                                         {"uint64_t", GridScalar::u64},
                                         {"float", GridScalar::f32},
                                         {"double", GridScalar::f64}};

/// Along which axis of space an axis of the file runs, and how far a step goes: negative against it.
struct AxisStep {
  int axis = 0;
  double step = 1;
};

class NrrdReader {
 public:
  explicit NrrdReader(FileScanner& in) : in_(in), errors_(in) {}

  ScalarGrid read() {
    read_header();
    ScalarGrid grid;
    grid.name = in_.file().stem().string();
    if (sizes_.empty()) in_.fail("has no sizes in its header", export_anew);
    if (!data_.type_known) in_.fail("has no type in its header", export_anew);
    if (!encoding_known_) in_.fail("has no encoding in its header", export_anew);
    if (bytes_of(data_.layout.type) > 1 && !endian_known_)
      in_.fail("does not say the byte order of its numbers",
               "Add a line \"endian: little\" or \"endian: big\".");
    const std::vector<std::size_t> kept = kept_axes();
    for (std::size_t a = 0; a < 3; ++a) data_.layout.size[a] = sizes_[kept[a]];
    const std::array<AxisStep, 3> steps = steps_of(kept);

    std::vector<float> values =
        data_file_.empty()
            ? read_values(in_)
            : with_data_file(in_, data_file_, [&](FileScanner& data) { return read_values(data); });
    arrange(std::move(values), steps, grid);
    return grid;
  }

 private:
  struct Data {
    GridData layout;
    bool type_known = false;
  };

  void read_header() {
    const std::uint64_t whole = in_.remaining();
    read_header_line(in_); // the magic, by which this reader was chosen
    for (;;) {
      errors_.next_line();
      const HeaderLine line = read_header_line(in_);
      if (whole - in_.remaining() > most_header_bytes)
        in_.fail("has a header of more than a megabyte", "Is this the right file?");
      if (line.text.empty()) {
        if (!line.ended && data_file_.empty())
          in_.fail("ends within its header", "It seems cut off: get it again or export it anew.");
        return;
      }
      if (line.text.front() == '#') continue;
      const std::size_t colon = line.text.find(':');
      if (colon == std::string::npos)
        errors_.fail("\"" + printable(line.text) + "\" is no field of a NRRD header");
      if (colon + 1 < line.text.size() && line.text[colon + 1] == '=') continue; // a key and its value
      read_field(line.text.substr(0, colon), line.text.substr(colon + 1));
      if (!line.ended && data_file_.empty())
        in_.fail("ends within its header", "It seems cut off: get it again or export it anew.");
      if (!line.ended) return;
    }
  }

  void read_field(const std::string& name, const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    const auto is = [&](std::string_view a, std::string_view b = {}) {
      return same_word(name, a) || (!b.empty() && same_word(name, b));
    };
    const auto word = [&]() -> const std::string& {
      if (words.size() != 1) errors_.fail(printable(name) + " takes one word");
      return words[0];
    };
    if (is("dimension")) {
      dimension_ = static_cast<std::size_t>(errors_.whole(word(), 1, most_axes));
    } else if (is("sizes")) {
      sizes_.clear();
      for (const std::string& w : words) sizes_.push_back(errors_.extent(w));
    } else if (is("type")) {
      read_type(words);
    } else if (is("encoding")) {
      read_encoding(word());
    } else if (is("endian")) {
      endian_known_ = true;
      data_.layout.big_endian = same_word(word(), "big");
      if (!data_.layout.big_endian && !same_word(word(), "little"))
        errors_.fail("\"" + printable(word()) + "\" is neither little nor big");
    } else if (is("spacings")) {
      spacings_.clear();
      for (const std::string& w : words) spacings_.push_back(same_word(w, "nan") ? 1 : errors_.number(w));
    } else if (is("axis mins", "axismins")) {
      mins_.clear();
      for (const std::string& w : words) mins_.push_back(same_word(w, "nan") ? 0 : errors_.number(w));
    } else if (is("space directions")) {
      read_directions(text);
    } else if (is("space origin")) {
      const auto origin = vector_of(text);
      if (!origin) errors_.fail("an origin of space is a vector, as (0,0,0)");
      origin_ = *origin;
    } else if (is("line skip", "lineskip")) {
      line_skip_ = errors_.whole(word(), 0, most_skipped);
    } else if (is("byte skip", "byteskip")) {
      byte_skip_ = errors_.whole(word(), -1, most_skipped);
    } else if (is("data file", "datafile")) {
      read_data_file(text, words);
    }
  }

  void read_type(const std::vector<std::string>& words) {
    std::string type;
    for (const std::string& w : words) type += (type.empty() ? "" : " ") + w;
    const auto* known = std::find_if(std::begin(nrrd_types), std::end(nrrd_types),
                                     [&](const GridScalarName& t) { return same_word(t.name, type); });
    if (known == std::end(nrrd_types)) {
      if (same_word(type, "block"))
        errors_.fail("blocks of bytes are no numbers", "Export it with a type of numbers.",
                     ErrorCode::unsupported);
      errors_.fail("\"" + printable(type) + "\" is no NRRD type");
    }
    data_.layout.type = known->type;
    data_.type_known = true;
  }

  void read_encoding(const std::string& name) {
    encoding_known_ = true;
    data_.layout.gzip = same_word(name, "gzip") || same_word(name, "gz");
    if (data_.layout.gzip || same_word(name, "raw")) return;
    for (const std::string_view other : {"txt", "text", "ascii", "hex", "bz2", "bzip2"})
      if (same_word(name, other))
        errors_.fail("the encoding " + std::string(other) + " is not read",
                     "Export it with the encoding raw or gzip.", ErrorCode::unsupported);
    errors_.fail("\"" + printable(name) + "\" is no NRRD encoding");
  }

  void read_data_file(const std::string& text, const std::vector<std::string>& words) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    data_file_ = text.substr(begin);
    while (!data_file_.empty() && (data_file_.back() == ' ' || data_file_.back() == '\t'))
      data_file_.pop_back();
    if (data_file_.empty()) errors_.fail("the name of the data file is missing");
    if (words[0] == "LIST" || data_file_.find('%') != std::string::npos)
      errors_.fail("data in several files are not read", "Join them into one, as unu does.",
                   ErrorCode::unsupported);
  }

  /// "(x,y,z)"; nothing where it is none.
  std::optional<Vec3> vector_of(std::string_view text) const {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return std::nullopt;
    std::string inner(text.substr(open + 1, close - open - 1));
    std::replace(inner.begin(), inner.end(), ',', ' ');
    const std::vector<std::string> parts = words_of(inner);
    if (parts.size() != 3)
      errors_.fail("a vector of " + std::to_string(parts.size()) + " numbers, where space has three axes");
    return Vec3{errors_.number(parts[0]), errors_.number(parts[1]), errors_.number(parts[2])};
  }

  void read_directions(const std::string& text) {
    directions_.clear();
    std::string_view rest = text;
    for (;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
      if (rest.empty()) return;
      if (rest.starts_with("none")) {
        directions_.emplace_back(std::nullopt);
        rest.remove_prefix(4);
        continue;
      }
      const std::size_t close = rest.find(')');
      const auto direction = vector_of(rest);
      if (!direction || rest.front() != '(')
        errors_.fail("a direction of space is a vector, as (1,0,0), or none");
      directions_.push_back(direction);
      rest.remove_prefix(close + 1);
    }
  }

  /// The three axes of space: all, or all those of more than one sample.
  std::vector<std::size_t> kept_axes() const {
    if (dimension_ != 0 && dimension_ != sizes_.size())
      in_.fail("has " + std::to_string(sizes_.size()) + " sizes for a dimension of " +
                   std::to_string(dimension_),
               export_anew);
    std::vector<std::size_t> kept;
    for (std::size_t a = 0; a < sizes_.size(); ++a)
      if (sizes_.size() == 3 || sizes_[a] > 1) kept.push_back(a);
    if (kept.size() != 3)
      in_.fail("has " + std::to_string(sizes_.size()) + " axes, " + std::to_string(kept.size()) +
                   " of them with more than one sample, where a volume has three",
               "Give one volume of one number a voxel.", ErrorCode::unsupported);
    for (const std::size_t a : kept)
      if (sizes_[a] < 2) in_.fail("has only one sample along an axis", "Give a volume.");
    return kept;
  }

  std::array<AxisStep, 3> steps_of(const std::vector<std::size_t>& kept) const {
    std::array<AxisStep, 3> steps;
    for (const auto& [given, what] : {std::pair{spacings_.size(), "spacings"},
                                      {directions_.size(), "space directions"},
                                      {mins_.size(), "axis mins"}})
      if (given != 0 && given != sizes_.size())
        in_.fail("has " + std::to_string(given) + " " + what + " for " + std::to_string(sizes_.size()) +
                     " axes",
                 export_anew);
    std::array<bool, 3> taken{};
    for (std::size_t a = 0; a < 3; ++a) {
      steps[a] = {static_cast<int>(a), spacings_.empty() ? 1 : spacings_[kept[a]]};
      if (!directions_.empty()) steps[a] = step_along(directions_[kept[a]]);
      if (steps[a].step == 0 || !std::isfinite(1 / steps[a].step))
        in_.fail("has a spacing of 0 along an axis", "Correct its spacings.");
      if (std::exchange(taken[static_cast<std::size_t>(steps[a].axis)], true))
        in_.fail("has two axes in one direction of space", "Correct its space directions.");
    }
    return steps;
  }

  AxisStep step_along(const std::optional<Vec3>& direction) const {
    if (!direction)
      in_.fail("has an axis that is none of space", "Give one volume of one number a voxel.",
               ErrorCode::unsupported);
    constexpr double straight = 1e-6;
    const Vec3 d = *direction;
    int along = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(d[k]) > std::abs(d[along])) along = k;
    for (int k = 0; k < 3; ++k)
      if (k != along && std::abs(d[k]) > straight * std::abs(d[along]))
        in_.fail("has axes that are oblique in space", "Resample it along the axes, as Slicer or unu does.",
                 ErrorCode::unsupported);
    return {along, d[along]};
  }

  std::vector<float> read_values(FileScanner& in) {
    for (std::int64_t i = 0; i < line_skip_; ++i) {
      char c = 0;
      while (in.read(&c, 1) && c != '\n') {}
      if (c != '\n') in.fail("ends within the lines to skip", export_anew);
    }
    data_.layout.at_end = byte_skip_ < 0;
    data_.layout.skip = static_cast<std::uint64_t>(std::max<std::int64_t>(0, byte_skip_));
    if (data_.layout.at_end && data_.layout.gzip)
      in.fail("is compressed, so that its numbers cannot be found from the end", "Correct its byte skip.");
    return read_grid_data(in, data_.layout);
  }

  /// Turns the file's order of axes and directions into those of space.
  void arrange(std::vector<float>&& values, const std::array<AxisStep, 3>& steps, ScalarGrid& grid) const {
    std::array<std::size_t, 3> strides{}; // in the grid, of the file's axes
    bool same = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(steps[a].axis);
      grid.size[axis] = data_.layout.size[a];
      grid.spacing[steps[a].axis] = std::abs(steps[a].step);
      const double first = directions_.empty() ? (mins_.empty() ? 0 : mins_[a]) : origin_[steps[a].axis];
      const double last = first + static_cast<double>(data_.layout.size[a] - 1) * steps[a].step;
      grid.origin[steps[a].axis] = std::min(first, last);
      same = same && axis == a && steps[a].step > 0;
    }
    if (directions_.empty() && mins_.empty()) grid.origin = origin_;
    if (same) {
      grid.values = std::move(values);
      return;
    }
    for (std::size_t a = 0; a < 3; ++a)
      strides[a] = steps[a].axis == 0 ? 1 : (steps[a].axis == 1 ? grid.size[0] : grid.size[0] * grid.size[1]);
    grid.values.resize(values.size());
    const auto& n = data_.layout.size;
    const auto place = [&](std::size_t a, std::size_t i) {
      return strides[a] * (steps[a].step > 0 ? i : n[a] - 1 - i);
    };
    std::size_t from = 0;
    for (std::size_t k = 0; k < n[2]; ++k)
      for (std::size_t j = 0; j < n[1]; ++j)
        for (std::size_t i = 0; i < n[0]; ++i)
          grid.values[place(0, i) + place(1, j) + place(2, k)] = values[from++];
  }

  FileScanner& in_;
  HeaderErrors errors_;
  Data data_;
  bool encoding_known_ = false, endian_known_ = false;
  std::size_t dimension_ = 0;
  std::vector<std::size_t> sizes_;
  std::vector<double> spacings_, mins_;
  std::vector<std::optional<Vec3>> directions_;
  Vec3 origin_;
  std::int64_t line_skip_ = 0, byte_skip_ = 0;
  std::string data_file_;
};

} // namespace

ScalarGrid read_nrrd(FileScanner& in) {
  return NrrdReader(in).read();
}

} // namespace isoscope
