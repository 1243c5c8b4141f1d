// A session over a run that loses a part: the places that are left behind are listed, and a click goes there.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

/// A cube and a bar through its face that is thinner than 2 δ and sticks out.
fs::path cube_with_bar() {
  const fs::path file = fs::path(ISOSCOPE_RESULTS) / "bar.off";
  fs::create_directories(file.parent_path());
  std::ofstream out(file);
  out << "OFF\n16 24 0\n";
  const auto corners = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
    for (int i = 0; i < 8; ++i)
      out << (i & 1 ? x1 : x0) << ' ' << (i & 2 ? y1 : y0) << ' ' << (i & 4 ? z1 : z0) << '\n';
  };
  corners(0, 0, 0, 1, 1, 1);
  corners(0.9, 0.49, 0.49, 2, 0.51, 0.51);
  for (const int first : {0, 8})
    for (const auto& t : {"0 2 3", "0 3 1", "4 5 7", "4 7 6", "0 1 5", "0 5 4", "2 6 7", "2 7 3", "0 4 6",
                          "0 6 2", "1 3 7", "1 7 5"})
      out << "3 " << t[0] - '0' + first << ' ' << t[2] - '0' + first << ' ' << t[4] - '0' + first << '\n';
  return file;
}

} // namespace

TEST_CASE("what a run leaves behind is listed with its distance, marked, and the camera goes there") {
  const std::string file = cube_with_bar().string();
  const std::string picture = (fs::path(ISOSCOPE_RESULTS) / "uncovered.png").string();
  CHECK(run_window("uncovered", R"(
wait settled
expect phase == finished and certified == off and covers == off
expect uncovered.places == 1 and uncovered.distance > 10 and uncovered.marked == none
wheel 1100 400 -20
click 990 352
expect uncovered.marked == 0
wait 0.3
screenshot )" + picture + R"(
clear
expect uncovered.marked == none
look-at-place uncovered 0
expect uncovered.marked == 0
set cover off
restart
wait settled
expect certified == on and covers == on and uncovered.places == 0
quit
)",
                   file + " --tolerance 0.06 --effort 0 --cover 1.9") == 0);
  CHECK(fs::exists(picture));
}
