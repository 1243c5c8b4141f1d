// Sessions over inputs without a surface of their own: noisy points and what lies between two surfaces.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

fs::path made(const std::string& name) {
  const fs::path file = fs::path(ISOSCOPE_RESULTS) / name;
  fs::create_directories(file.parent_path());
  return file;
}

/// Even draws from [-1, 1).
class Draws {
 public:
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_ = 12345;
};

/// Points of the unit sphere with noise, and some far from it.
fs::path noisy_sphere() {
  const fs::path file = made("noisy-sphere.xyz");
  std::ofstream out(file);
  Draws draws;
  for (int i = 0; i < 4000;) {
    const double x = draws.next(), y = draws.next(), z = draws.next();
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length < 0.1 || length > 1) continue;
    const bool outlier = i % 40 == 0;
    const double at = outlier ? 2 : (1 + 0.02 * draws.next()) / length;
    out << at * x << ' ' << at * y << ' ' << at * z << '\n';
    ++i;
  }
  return file;
}

/// An octahedron whose corners are so far from the origin.
fs::path octahedron(const std::string& name, double radius) {
  const fs::path file = made(name);
  std::ofstream out(file);
  out << "OFF\n6 8 0\n";
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      std::array<double, 3> p{};
      p[static_cast<std::size_t>(axis)] = sign * radius;
      out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
  for (const char* t : {"0 2 4", "2 1 4", "1 3 4", "3 0 4", "2 0 5", "1 2 5", "3 1 5", "0 3 5"})
    out << "3 " << t << '\n';
  return file;
}

} // namespace

TEST_CASE("noisy points: sprites by weight, the inspector of one, Ω at other tolerances, a run with one") {
  const std::string picture = made("points.png").string(), tab = made("tolerance.png").string(),
                    refused = made("refused.png").string();
  CHECK(run_window("points", R"(
wait settled
expect phase == finished and certified == on and euler == 2 and components == 1
expect points == 4000 and points.dropped > 50 and points.dropped < 400 and points.k >= 12
expect layer.points == on
pick point 5
wait answers
expect selection == point and selected_id == 5
expect point.neighbours == points.k and point.weight > 0 and point.weight < 1 and point.radius > 0
pick point 0
wait answers
expect point.dropped == outlier and point.radius == 0
frame
seek 0
frame-all
kind-point
click 700 330
expect selection == point
screenshot )" + picture + R"(
clear
tab tolerance
expect study.least > 0 and study.most > study.least and study.proposed >= study.least
expect preview_delta == off and study.deep == 1
set preview_delta proposed
expect study.deep >= 1 and study.components >= 1
look-at-place opening
set preview_delta 3%
screenshot )" + tab + R"(
drag 500 700 560 700
expect preview_delta != off
clear
clear
expect preview_delta == off
set preview_delta 8%
take-delta
wait settled
expect preview_delta == off and tolerance == 8% and certified == on
# too small to enclose anything: the diagram shows which would do
set tolerance 1%
restart
wait settled
expect phase == failed and study.least > 0
set preview_delta proposed
expect study.deep >= 1
screenshot )" + refused + R"(
take-delta
wait settled
expect phase == finished and certified == on
section
wait settled
set mode split
quit
)",
                   noisy_sphere().string() + " --size 1440x900") == 0);
}

TEST_CASE("two surfaces open in any order; what is wrong with a pair is said in the window") {
  const std::string outer = octahedron("outer.off", 1).string(),
                    inner = octahedron("inner.off", 0.7).string();
  const std::string crossing = octahedron("crossing.off", 1.0).string();
  CHECK(run_window("between", R"(
wait settled
open-between )" + inner + " " + outer +
                                  R"(
wait settled
expect phase == finished and certified == on and euler == 2 and model == )" +
                                  outer + R"(
expect inside == )" + inner + R"(
expect points == 0 and layer.points == on
open-between )" + outer + " " + crossing +
                                  R"(
wait settled
expect phase == failed and messages > 0
dismiss
open-between )" + outer + R"( nowhere.off
wait answers
expect messages > 0
open gallery:sphere
wait settled
expect certified == on and phase == finished
quit
)") == 0);
}
