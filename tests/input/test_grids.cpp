// Grids in every type, order and packing that is read, their bad files, labels and level surfaces.
#include "input/grid_readers.h"
#include "input/label_grid.h"
#include "input/level_surface.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <map>

using namespace isoscope;

namespace {

/// 0, 1, 2, ... as a type, in either byte order.
template <class T> std::string numbers(std::size_t count, bool big_endian) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<char, sizeof(T)> own{};
    const T value = static_cast<T>(i);
    std::memcpy(own.data(), &value, sizeof(T));
    if (big_endian) std::reverse(own.begin(), own.end());
    bytes.append(own.data(), own.size());
  }
  return bytes;
}

std::string packed(const std::string& bytes) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("isoscope-packed-" + std::to_string(::getpid()));
  gzFile out = gzopen(file.c_str(), "wb");
  REQUIRE(gzwrite(out, bytes.data(), static_cast<unsigned>(bytes.size())) == static_cast<int>(bytes.size()));
  gzclose(out);
  std::string result = bytes_of(file);
  std::filesystem::remove(file);
  return result;
}

ScalarGrid read(const std::filesystem::path& file) {
  auto grid = read_grid(file, RunControl());
  CAPTURE(grid.ok() ? std::string() : grid.error().line());
  REQUIRE(grid.ok());
  return *grid;
}

void check_refused(const std::filesystem::path& file, ErrorCode code, std::string_view words) {
  const auto grid = read_grid(file, RunControl());
  REQUIRE_FALSE(grid.ok());
  const std::string line = grid.error().line();
  CAPTURE(line);
  CHECK(grid.error().code == code);
  CHECK(line.find(file.string()) != std::string::npos);
  CHECK(line.find(words) != std::string::npos);
  CHECK(line.find('\n') == std::string::npos);
  CHECK_FALSE(grid.error().remedy.empty());
}

const std::string nrrd = "NRRD0004\ndimension: 3\nsizes: 2 3 4\n";

bool counts_up(const ScalarGrid& grid) {
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    if (grid.values[i] != static_cast<float>(i)) return false;
  return grid.values.size() == 24;
}

} // namespace

TEST_CASE("NRRD in every type and byte order, plain and packed") {
  const TemporaryFolder folder;
  const auto check_type = [&]<class T>(const std::string& name, T) {
    for (const bool big : {false, true})
      for (const bool gzip : {false, true}) {
        const std::string data = numbers<T>(24, big);
        const auto file = folder.file(
            "a.nrrd", nrrd + "type: " + name + "\nendian: " + (big ? "big" : "little") +
                          "\nencoding: " + (gzip ? "gzip" : "raw") + "\n\n" + (gzip ? packed(data) : data));
        CAPTURE(name);
        const ScalarGrid grid = read(file);
        CHECK(grid.size == std::array<std::size_t, 3>{2, 3, 4});
        CHECK(counts_up(grid));
        CHECK(grid.name == "a");
      }
  };
  check_type("int8", std::int8_t{});
  check_type("unsigned char", std::uint8_t{});
  check_type("signed short int", std::int16_t{});
  check_type("ushort", std::uint16_t{});
  check_type("int", std::int32_t{});
  check_type("uint32_t", std::uint32_t{});
  check_type("long long", std::int64_t{});
  check_type("uint64", std::uint64_t{});
  check_type("float", float{});
  check_type("double", double{});
}

TEST_CASE("where NRRD says that the grid lies") {
  const TemporaryFolder folder;
  const std::string head = nrrd + "type: uint8\nencoding: raw\n",
                    data = "\n" + numbers<std::uint8_t>(24, false);
  ScalarGrid grid = read(folder.file("a", head + data));
  CHECK(grid.origin == Vec3{0, 0, 0});
  CHECK(grid.spacing == Vec3{1, 1, 1});
  grid = read(folder.file("a", head + "spacings: 1 2 0.5\naxis mins: -1 nan 3\n" + data));
  CHECK(grid.spacing == Vec3{1, 2, 0.5});
  CHECK(grid.origin == Vec3{-1, 0, 3});
  grid = read(
      folder.file("a", head + "space directions: (2,0,0) (0,1,0) (0,0,3)\nspace origin: (5,6,7)\n" + data));
  CHECK(grid.spacing == Vec3{2, 1, 3});
  CHECK(grid.origin == Vec3{5, 6, 7});
  CHECK(counts_up(grid));
  // The first axis of the file runs down z, the last one up x.
  grid = read(
      folder.file("a", head + "space directions: (0,0,-2) (0,1,0) (3,0,0)\nspace origin: (5,6,7)\n" + data));
  CHECK(grid.size == std::array<std::size_t, 3>{4, 3, 2});
  CHECK(grid.spacing == Vec3{3, 1, 2});
  CHECK(grid.origin == Vec3{5, 6, 5});
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 2; ++i)
        CHECK(grid.at(k, j, 1 - i) == static_cast<float>(i + 2 * (j + 3 * k)));
}

TEST_CASE("data in a file of its own, skipped parts, axes of one sample") {
  const TemporaryFolder folder;
  const std::string data = numbers<std::uint16_t>(24, true);
  folder.file("a.raw", "two\nlines\nxyz" + data);
  const std::string head = nrrd + "type: uint16\nendian: big\nencoding: raw\n";
  CHECK(counts_up(read(folder.file("a.nhdr", head + "line skip: 2\nbyte skip: 3\ndata file: a.raw\n"))));
  CHECK(counts_up(read(folder.file("a.nhdr", head + "byteskip: -1\ndatafile:   a.raw  "))));
  folder.file("a.raw.gz", packed("xyz" + data));
  CHECK(counts_up(
      read(folder.file("a.nhdr", "NRRD0001\r\ntype: uint16\r\ndimension: 3\r\nsizes: 2 3 4\r\nendian: big\r\n"
                                 "encoding: gz\r\nbyte skip: 3\r\ndata file: a.raw.gz\r\n"))));
  CHECK(counts_up(
      read(folder.file("b.nrrd", "NRRD0005\ndimension: 4\nsizes: 1 2 3 4\ntype: uint16\nendian: big\n"
                                 "encoding: raw\nmine:=yes: no\n\n" +
                                     data))));
  CHECK(counts_up(read(folder.file("a.grid", "isoscope-grid 1\n# mine\nsize 2 3 4\ntype uint16\nendian big\n"
                                             "skip 13\nspacing 1 1 2\norigin 0 0 -1\ndata a.raw\n"))));
}

TEST_CASE("bad grids are refused with the place") {
  const TemporaryFolder folder;
  const auto bad = [&](const std::string& text, std::string_view words,
                       ErrorCode code = ErrorCode::bad_input) {
    check_refused(folder.file("a.nrrd", text), code, words);
  };
  const std::string data = "\n" + numbers<std::uint8_t>(24, false);
  bad("hello\n", "format");
  bad("NRRD0004\ntype: uint8\n", "ends within its header");
  bad("NRRD0004\nsizes: 2 3 4\nencoding: raw\n" + data, "no type");
  bad(nrrd + "type: uint8\n" + data, "no encoding");
  bad(nrrd + "type: uint8\nencoding: raw\nwhat is this\n" + data, "line 6");
  bad(nrrd + "type: uint8\nencoding: raw\nspacings: 1 1\n" + data, "2 spacings");
  bad(nrrd + "type: uint8\nencoding: raw\nspacings: 1 0 1\n" + data, "spacing of 0");
  bad(nrrd + "type: uint8\nencoding: raw\nspacings: 1 one 1\n" + data, "one");
  bad(nrrd + "type: uint16\nencoding: raw\n" + data, "byte order");
  bad(nrrd + "type: uint16\nendian: big\nencoding: raw\n" + data, "24 numbers");
  bad(nrrd + "type: uint8\nencoding: gzip\n" + data, "damaged");
  bad(nrrd + "type: uint8\nencoding: gzip\n\n" + packed("abc"), "too few");
  bad(nrrd + "type: uint8\nencoding: raw\ndimension: 2\n" + data, "dimension of 2");
  bad("NRRD0004\nsizes: 1000000 1000000 1000000\ntype: uint8\nencoding: raw\n" + data, "bytes follow");
  bad("NRRD0004\nsizes: 99999999999 2 2\ntype: uint8\nencoding: raw\n" + data, "99999999999");
  bad(nrrd + "type: float\nendian: little\nencoding: raw\n\n" + std::string(92, '\0') +
          std::string("\x00\x00\x80\x7f", 4),
      "not finite at voxel (1, 2, 3)");
  bad(nrrd + "type: uint8\nencoding: raw\ndata file: missing.raw\n", "missing.raw");
  const auto unsupported = [&](const std::string& text, std::string_view words) {
    bad(text, words, ErrorCode::unsupported);
  };
  unsupported(nrrd + "type: uint8\nencoding: bzip2\n" + data, "bzip2");
  unsupported(nrrd + "type: uint8\nencoding: raw\nspace directions: (1,1,0) (0,1,0) (0,0,1)\n" + data,
              "oblique");
  unsupported(nrrd + "type: uint8\nencoding: raw\nspace directions: none (0,1,0) (0,0,1)\n" + data,
              "none of space");
  unsupported("NRRD0004\nsizes: 3 2 3 4\ntype: uint8\nencoding: raw\n" + data, "4 axes");
  unsupported(nrrd + "type: uint8\nencoding: raw\ndata file: LIST\n", "several files");
  const auto bad_header = [&](const std::string& text, std::string_view words) {
    check_refused(folder.file("a.grid", text), ErrorCode::bad_input, words);
  };
  bad_header("isoscope-grid 2\n", "line 1");
  bad_header("isoscope-grid 1\ntype uint8\ndata a\n", "size");
  bad_header("isoscope-grid 1\nsize 2 2 2\ndata a\n", "type");
  bad_header("isoscope-grid 1\nsize 2 2 2\ntype uint8\n", "data");
  bad_header("isoscope-grid 1\nsize 2 2\n", "line 2");
  bad_header("isoscope-grid 1\ncolour red\n", "line 2");
  bad_header("isoscope-grid 1\nsize 2 2 2\ntype uint8\ndata none.raw\n", "none.raw");
  folder.file("b.raw", std::string("\x00\x00\xc0\x7f", 4) + std::string(28, '\0'));
  bad_header("isoscope-grid 1\nsize 2 2 2\ntype float32\nendian little\ndata b.raw\n",
             "not finite at voxel (0, 0, 0)");
}

TEST_CASE("distances to a label are those of all pairs of voxels") {
  ScalarGrid labels;
  labels.size = {7, 6, 5};
  labels.spacing = {1, 2, 1.5};
  labels.values.assign(7 * 6 * 5, 1);
  for (const std::size_t i : {0, 57, 101, 102, 109, 150}) labels.values[i] = 3;
  const auto distances = label_distance(labels, 3, RunControl());
  REQUIRE(distances.ok());
  const auto point = [&](std::size_t i) { return labels.point(i % 7, i / 7 % 6, i / 42); };
  for (std::size_t i = 0; i < labels.values.size(); ++i) {
    double nearest = Box3::inf;
    for (std::size_t j = 0; j < labels.values.size(); ++j)
      if (labels.values[i] != labels.values[j]) nearest = std::min(nearest, distance(point(i), point(j)));
    const double expected = labels.values[i] == 3 ? 0.5 - nearest : nearest - 0.5;
    CHECK(static_cast<double>(distances->values[i]) == doctest::Approx(expected).epsilon(1e-6));
  }
  CHECK_FALSE(label_distance(labels, 2, RunControl()).ok());
  labels.values.assign(labels.values.size(), 3);
  CHECK_FALSE(label_distance(labels, 3, RunControl()).ok());
}

TEST_CASE("level surfaces are closed, oriented upwards and where the values say") {
  ScalarGrid grid;
  grid.size = {14, 15, 16};
  grid.spacing = Vec3{1, 1, 1} * 0.2;
  grid.origin = {-1.3, -1.4, -1.5};
  for (std::size_t z = 0; z < 16; ++z)
    for (std::size_t y = 0; y < 15; ++y)
      for (std::size_t x = 0; x < 14; ++x)
        grid.values.push_back(static_cast<float>(length(grid.point(x, y, z))));
  TriangleSoup soup;
  add_level_surface(grid, 1, soup, RunControl());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    REQUIRE(count == 1);
    REQUIRE(edges.contains({edge.second, edge.first}));
  }
  CHECK(static_cast<long>(soup.points.size()) - static_cast<long>(edges.size() / 2) +
            static_cast<long>(soup.triangles.size()) ==
        2);
  double volume = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle3 t = soup.triangle(i);
    volume += dot(t[0], cross(t[1], t[2])) / 6;
  }
  CHECK(volume == doctest::Approx(4.18879).epsilon(0.03));
  for (const Vec3 p : soup.points) CHECK(length(p) == doctest::Approx(1).epsilon(0.02));
}
