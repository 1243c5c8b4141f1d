// A model cut into tiles, for tests.
#pragma once

#include "tiles/tile_work.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

namespace isoscope::test {

inline constexpr double mebibyte = 1 << 20;

inline RunParameters parameters_of(const std::string& input, double percent, int effort = 1) {
  RunParameters p;
  p.input = input;
  p.tolerance = {percent, true};
  p.effort = effort;
  return p;
}

inline TileFolder cut(const std::filesystem::path& folder, const RunParameters& p, double mebibytes = 1) {
  RunControl control;
  auto made = cut_into_tiles(p, folder, mebibytes * mebibyte, control);
  REQUIRE(made.ok());
  return *made;
}

} // namespace isoscope::test
