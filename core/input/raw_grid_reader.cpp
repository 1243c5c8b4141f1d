// Raw numbers in a file of their own, under a short text header that anybody can write: see README.md.
#include "input/grid_readers.h"

#include "base/pending_file.h"
#include "input/grid_data.h"

#include <algorithm>
#include <iterator>

namespace isoscope {
namespace {

constexpr GridScalarName raw_types[] = {{"int8", GridScalar::i8},     {"uint8", GridScalar::u8},
                                        {"int16", GridScalar::i16},   {"uint16", GridScalar::u16},
                                        {"int32", GridScalar::i32},   {"uint32", GridScalar::u32},
                                        {"int64", GridScalar::i64},   {"uint64", GridScalar::u64},
                                        {"float32", GridScalar::f32}, {"float64", GridScalar::f64}};

} // namespace

ScalarGrid read_raw_grid(FileScanner& in) {
  HeaderErrors errors(in);
  ScalarGrid grid;
  grid.name = in.file().stem().string();
  GridData data;
  std::string data_file;
  bool size_known = false, type_known = false, endian_known = false;
  const std::vector<std::string> first = words_of(read_header_line(in).text);
  if (first.size() != 2 || first[1] != "1")
    errors.fail("the header begins with \"isoscope-grid 1\"", "Write that line first.");
  while (in.peek() != FileScanner::end_of_file) {
    errors.next_line();
    const std::string text = read_header_line(in).text;
    const std::vector<std::string> words = words_of(text);
    if (words.empty() || words[0].front() == '#') continue;
    const std::string& key = words[0];
    const auto takes = [&](std::size_t count) {
      if (words.size() != count + 1)
        errors.fail(printable(key) + " takes " + std::to_string(count) + (count == 1 ? " value" : " values"));
    };
    if (key == "size") {
      takes(3);
      for (std::size_t a = 0; a < 3; ++a) data.size[a] = errors.extent(words[a + 1]);
      size_known = true;
    } else if (key == "type") {
      takes(1);
      const auto* known = std::find_if(std::begin(raw_types), std::end(raw_types),
                                       [&](const GridScalarName& t) { return t.name == words[1]; });
      if (known == std::end(raw_types))
        errors.fail(
            "\"" + printable(words[1]) + "\" is no type",
            "Types are int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32 and float64.");
      data.type = known->type;
      type_known = true;
    } else if (key == "endian") {
      takes(1);
      if (words[1] != "little" && words[1] != "big")
        errors.fail("\"" + printable(words[1]) + "\" is neither little nor big");
      data.big_endian = words[1] == "big";
      endian_known = true;
    } else if (key == "spacing" || key == "origin") {
      takes(3);
      Vec3& target = key == "spacing" ? grid.spacing : grid.origin;
      for (int a = 0; a < 3; ++a) target[a] = errors.number(words[static_cast<std::size_t>(a) + 1]);
    } else if (key == "skip") {
      takes(1);
      data.skip = static_cast<std::uint64_t>(errors.whole(words[1], 0, most_skipped));
    } else if (key == "data") {
      if (words.size() < 2) errors.fail("data takes the name of a file");
      data_file = text.substr(text.find(words[1], text.find(key) + key.size()));
    } else {
      errors.fail("\"" + printable(key) + "\" is no key of this header",
                  "Keys are size, type, endian, spacing, origin, skip and data.");
    }
  }
  if (!size_known) in.fail("has no line \"size NX NY NZ\"", "Add it.");
  if (!type_known) in.fail("has no line \"type T\"", "Add it.");
  if (bytes_of(data.type) > 1 && !endian_known)
    in.fail("does not say the byte order of its numbers", "Add a line \"endian little\" or \"endian big\".");
  if (data_file.empty()) in.fail("has no line \"data FILE\"", "Add it.");
  grid.size = data.size;
  grid.values = with_data_file(in, data_file, [&](FileScanner& raw) { return read_grid_data(raw, data); });
  return grid;
}

} // namespace isoscope
