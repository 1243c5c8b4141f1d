// What is said of OpenVDB's files by a program that was built without their reader.
#include "input/grid_readers.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("OpenVDB's files are known by their first bytes, whatever their name") {
  const TemporaryFolder folder;
  const auto file = folder.file("smoke", std::string(" BDV\0\0\0\0\xe0\0\0\0", 12));
  CHECK(is_grid_file(file));
  const auto grid = read_grid(file, RunControl());
  REQUIRE_FALSE(grid.ok());
  CHECK(grid.error().code == ErrorCode::unsupported);
  CHECK(grid.error().message.find("OpenVDB") != std::string::npos);
  CHECK(grid.error().remedy.find("NRRD") != std::string::npos);
}
