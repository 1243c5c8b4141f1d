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

/// An octahedron whose corners are so far from its centre, which lies on the x axis; or some of its
/// triangles.
fs::path octahedron(const std::string& name, double radius, double center = 0, std::size_t count = 8) {
  const fs::path file = made(name);
  std::ofstream out(file);
  out << "OFF\n6 " << count << " 0\n";
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      std::array<double, 3> p{};
      p[static_cast<std::size_t>(axis)] = sign * radius;
      p[0] += center;
      out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
  constexpr std::array triangles{"0 2 4", "2 1 4", "1 3 4", "3 0 4", "2 0 5", "1 2 5", "3 1 5", "0 3 5"};
  for (std::size_t t = 0; t < count; ++t) out << "3 " << triangles[t] << '\n';
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

TEST_CASE("two surfaces open in any order: named, dropped, chosen among the files or said at the start") {
  const std::string outer = octahedron("pair/outer.off", 1).string(),
                    inner = octahedron("pair/inner.off", 0.7).string();
  const std::string as_expected = "wait settled\nexpect phase == finished and certified == on and euler == 2 "
                                  "and model == " +
                                  outer + "\nexpect inside == " + inner + "\n";
  const std::string first = made("files-first.png").string(), between = made("between.png").string();
  CHECK(run_window("between",
                   as_expected + "expect points == 0 and layer.points == on\n" +      // the start
                       "open gallery:sphere\nwait settled\nexpect inside == \"\"\n" + //
                       "open " + inner + " " + outer + " paused\nwait settled\nexpect phase == paused\n" +
                       "hold\n" + as_expected +                                    //
                       "open " + outer + " inside " + inner + "\n" + as_expected + //
                       "drop " + inner + " " + outer + "\n" + as_expected +        //
                       "drop " + outer + "\nwait settled\nexpect inside == \"\"\n" +
                       // Ctrl takes the first of the two, what is chosen next is the second.
                       "open\nframe\nframe\nclick 560 226 control\nframe\nscreenshot " + first +
                       "\nclick 560 252\n" + as_expected + "screenshot " + between + "\nquit\n",
                   "--inside " + inner + " --outside " + outer + " --size 1280x800", "",
                   "cd " + fs::path(outer).parent_path().string() + " && ") == 0);
}

TEST_CASE("what is wrong with a pair of surfaces is said in the window, and δ is not theirs to be set") {
  const std::string outer = octahedron("outer.off", 1).string(),
                    inner = octahedron("inner.off", 0.7).string(),
                    crossing = octahedron("crossing.off", 0.7, 0.4).string(),
                    touching = octahedron("touching.off", 0.5, 0.5).string(),
                    beside = octahedron("beside.off", 0.7, 3).string(),
                    open_inside = octahedron("open.off", 0.7, 0, 7).string(),
                    points = noisy_sphere().string();
  const auto refused = [&](const std::string& one, const std::string& other, const std::string& words) {
    return "open " + one + " " + other +
           "\nwait settled\nexpect phase == failed and messages == 1 and message == \"" + words +
           "\"\ndismiss\n";
  };
  const std::string picture = made("crossing.png").string();
  CHECK(run_window(
            "pairs",
            refused(crossing, outer,
                    "The inner and the outer surface touch or cross near (0.166667, 0.233333, 0.233333).") +
                refused(
                    touching, outer,
                    "The inner and the outer surface touch or cross near (0.333333, 0.166667, -0.166667).") +
                refused(outer, beside, "The inner surface is not inside the outer one near (3.7, 0, 0).") +
                refused(open_inside, outer, "The inner surface is open near (0, -0.35, -0.35).") +
                refused(points, outer, "The outer surface, " + points + ", has points and no triangles.") +
                "open " + outer + " inside " + points +
                "\nwait settled\nexpect message == \"The inner surface, " + points +
                ", has points and no triangles.\"\ndismiss\n" + "open " + outer + " " + crossing +
                "\nwait settled\nscreenshot " + picture + "\ndismiss\nopen " + outer +
                " nowhere.off\nwait answers\nexpect messages == 1\nopen gallery:sphere\nwait settled\n"
                "expect certified == on and phase == finished\nset tolerance 9%\nquit\n") == 0);
  CHECK(run_window("pair-with-delta", "wait settled\nexpect certified == on\nset tolerance 3%\nquit\n",
                   "--inside " + inner + " --outside " + outer) == 1);
  CHECK(run_window("pair-with-typed-delta", "wait settled\nexpect certified == on\ntype tolerance 3\nquit\n",
                   "--inside " + inner + " --outside " + outer) == 1);
  CHECK(run_window("pair-and-tolerance", "quit\n",
                   "--inside " + inner + " --outside " + outer + " --tolerance 3%") == 2);
}
