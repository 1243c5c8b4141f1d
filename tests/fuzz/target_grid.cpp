// The readers of grids: NRRD with its numbers, plain and packed, and headers of raw data beside them.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"
#include "input/grid_readers.h"
#include "input/temporary_folder.h"

#include <zlib.h>

#include <cmath>

namespace isoscope::fuzz {

namespace {

/// With the numbers that headers of raw data name.
struct Folder : TemporaryFolder {
  Folder() { file("numbers.raw", std::string(130, '\7')); }
};

const TemporaryFolder& folder() {
  static const Folder made;
  return made;
}

std::string packed(const std::string& bytes) {
  std::string out(bytes.size() + 100, '\0');
  z_stream stream{};
  constexpr int gzip_header = 16;
  require(deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + gzip_header, 8, Z_DEFAULT_STRATEGY) == Z_OK,
          "the seed could not be packed");
  std::string in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  require(deflate(&stream, Z_FINISH) == Z_STREAM_END, "the seed could not be packed");
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

std::string bytes(std::size_t count) {
  std::string all(count, '\0');
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<char>(37 * i % 61);
  return all;
}

std::vector<std::string> seeds() {
  const std::string nrrd = "NRRD0004\n# a comment\ndimension: 3\n";
  return {nrrd + "type: uint8\nsizes: 3 4 5\nencoding: raw\nspacings: 1 1 2.5\naxis mins: 0 -1 nan\n\n" +
              bytes(60),
          nrrd +
              "type: signed short int\nsizes: 3 2 4\nendian: big\nencoding: gzip\nspace: "
              "left-posterior-superior\n"
              "space directions: (0,0,2) (0,-1,0) (0.5,0,0)\nspace origin: (1,2,3)\n\n" +
              packed(bytes(48)),
          "NRRD0005\ntype: float\ndimension: 4\nsizes: 1 2 3 2\nencoding: raw\nendian: little\nkey:=value: "
          "of mine\n"
          "byte skip: -1\n\nsome other bytes" +
              std::string(48, '\0'),
          nrrd +
              "type: double\nsizes: 2 2 2\nencoding: raw\nendian: little\nline skip: 1\nbyte skip: "
              "3\n\nline\nxxx" +
              std::string(64, '\0'),
          nrrd + "type: int16\r\nsizes: 3 4 5\r\nendian: big\r\nencoding: raw\r\ndata file: numbers.raw\r\n",
          "isoscope-grid 1\nsize 3 4 5\ntype int16\nendian big\nspacing 1 1 0.5\norigin 0 0 7e1\n# "
          "comment\nskip 1\n"
          "data numbers.raw\n",
          "isoscope-grid 1\r\nsize 5 4 3\r\ntype uint8\r\ndata numbers.raw"};
}

bool accepts(std::string_view input) {
  const auto file = folder().file("grid", input);
  const RunControl control;
  const auto grid = read_grid(file, control);
  if (!grid) {
    const Error& error = grid.error();
    require(error.code != ErrorCode::internal, "the reader blames itself");
    require(error.message.find(file.string()) != std::string::npos, "an error does not name the file");
    require(error.line().find('\n') == std::string::npos, "an error has two lines");
    return false;
  }
  require(grid->size[0] >= 2 && grid->size[1] >= 2 && grid->size[2] >= 2, "a grid without a volume");
  require(grid->values.size() == grid->size[0] * grid->size[1] * grid->size[2], "numbers are missing");
  for (const float v : grid->values) require(std::isfinite(v), "a number that is not finite");
  for (int a = 0; a < 3; ++a) require(grid->spacing[a] > 0, "a spacing that is not positive");
  require(is_finite(grid->box().lo) && is_finite(grid->box().hi), "a box without bounds");
  return true;
}

} // namespace

const Target& target() {
  static const Target made = [] {
    // One packed byte may hold a thousand numbers, each a float.
    Target t{"grid", seeds, number_words(), accepts, 800 << 10, 6000};
    t.words.insert(t.words.end(), {"NRRD", "raw", "gzip", "none", "(0,0,1)", "sizes: ", "data file: ", "LIST",
                                   ":=", "double", "uint8", "size ", "\n\n", "-1"});
    return t;
  }();
  return made;
}

} // namespace isoscope::fuzz
