// The view, item by item: Ω is a volume with two sides, cut faces are filled, the clip has a handle, sections
// show what an edge was judged by, Z wears maps, and what is being prepared says so.
#include "platform/image_file.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace isoscope;
using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

std::string file(const std::string& name) {
  return (fs::path(ISOSCOPE_RESULTS) / name).string();
}

std::string text_of(const std::string& name) {
  std::ifstream in(name);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A picture of the view as it is, on no ground.
std::string take(const std::string& name) {
  return "picture " + file(name + ".png") + " 300x300 alpha\n";
}

Image taken(const std::string& name) {
  auto image = read_png(file(name + ".png"));
  REQUIRE(image.ok());
  return std::move(*image);
}

std::array<int, 4> at(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.pixels[static_cast<std::size_t>((y * image.width + x) * 4)];
  return {p[0], p[1], p[2], p[3]};
}

/// What is drawn where `where` says so of a pixel's place.
struct Drawn {
  std::size_t pixels = 0;
  double warmth = 0;  ///< red less blue, the mean, each in [0, 255]
  double opacity = 0; ///< the mean, in [0, 255]
};
template <class Where> Drawn drawn(const Image& image, Where where) {
  Drawn found;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto [red, green, blue, alpha] = at(image, x, y);
      if (alpha == 0 || !where(x, y)) continue;
      ++found.pixels;
      found.warmth += red - blue;
      found.opacity += alpha;
    }
  if (found.pixels > 0) {
    found.warmth /= static_cast<double>(found.pixels);
    found.opacity /= static_cast<double>(found.pixels);
  }
  return found;
}

/// How many pixels are not the same in both.
std::size_t differing(const Image& a, const Image& b) {
  std::size_t n = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) n += at(a, x, y) != at(b, x, y) ? 1 : 0;
  return n;
}

/// Ω alone.
const std::string only_omega = R"(
wait settled
set layer.zero off
set layer.samples off
set layer.tets off
set layer.highlight off
set layer.gamma off
set axes off
set scale-bar off
)";

const std::string sphere = "gallery:sphere --tolerance 12% --until refinement";

} // namespace

TEST_CASE("the outer boundary of Ω is cool, the inner one warm and seen through it, from any side") {
  std::string script = only_omega;
  const std::array<std::string, 3> sides{"x", "-x", "y"};
  for (const std::string& side : sides)
    script += "look " + side + "\nset layer.outer on\nset layer.inner on\n" + take("both" + side) +
              "set layer.inner off\n" + take("outer" + side) + "set layer.outer off\nset layer.inner on\n" +
              take("inner" + side);
  REQUIRE(run_window("boundaries", script + "quit\n", sphere) == 0);
  for (const std::string& side : sides) {
    CAPTURE(side);
    const Image both = taken("both" + side), outer = taken("outer" + side), inner = taken("inner" + side);
    const auto anywhere = [](int, int) { return true; };
    const auto within = [&](int x, int y) { return at(inner, x, y)[3] > 0; };
    const auto beside = [&](int x, int y) { return !within(x, y); };
    const Drawn of_outer = drawn(outer, anywhere), of_inner = drawn(inner, anywhere);
    CHECK(of_outer.warmth < -10);
    CHECK(of_inner.warmth > 10);
    CHECK(of_inner.pixels > 5000);
    CHECK(of_outer.pixels > of_inner.pixels * 11 / 10);
    // The inner one is seen through the outer one, around it there is the outer one alone.
    CHECK(drawn(both, within).warmth > drawn(outer, within).warmth + 10);
    CHECK(drawn(both, beside).warmth < -10);
    CHECK(drawn(both, within).opacity > drawn(both, beside).opacity + 10);
  }
}

TEST_CASE("looks of Ω are chosen by their names, and what is set by hand is a look of its own") {
  const std::string script = only_omega + R"(
expect omega.look == shell
expect-words Shell
click-words Fog
wait 0.2
expect omega.look == fog and haze.middle > haze.outer and haze.middle > haze.inner
)" + take("fog") + R"(
click-words Thick
wait 0.2
expect omega.look == thickness and haze.outer == haze.inner and haze.outer > 0
)" + take("thick") + R"(
set haze.middle 0.9
expect omega.look == own
omega-look
move 640 300
wait 0.2
click-words Inner
move 640 300
wait 0.2
expect omega.look == inner and layer.outer == off
click-words Shell
wait 0.2
expect omega.look == shell and haze.middle == 0
)" + take("shell") + "quit\n";
  REQUIRE(run_window("looks", script, sphere + " --size 1280x800") == 0);
  const Image shell = taken("shell"), fog = taken("fog"), thick = taken("thick");
  CHECK(differing(shell, fog) > 5000);
  CHECK(differing(shell, thick) > 5000);
  CHECK(differing(fog, thick) > 5000);
}

TEST_CASE("Ω that is drawn coarser than four voxels across says so, where it is set and below") {
  CHECK(run_window("coarse", R"(
wait settled
expect omega.coarse == off and omega.voxels >= 4 and omega.memory == 256
expect-no-words coarser than wanted
set omega.memory 1
wait settled
wait 0.2
expect omega.coarse == on and omega.voxels < 4 and omega.megabytes <= 1
expect-words Ω is drawn coarser than wanted
expect-words voxels across it, not 4
set omega.memory 256
wait settled
wait 0.2
expect omega.coarse == off
expect-no-words coarser than wanted
quit
)",
                   "gallery:sphere --tolerance 1.5% --sigma 0.95 --until refinement --paused --size "
                   "1600x900") == 0);
}

TEST_CASE("cut faces are filled with the band of Ω, and Z runs through it") {
  const std::string script = only_omega + R"(
look x
set clip plane
set clip.normal x
set clip.x 0
)" + take("cut") + "set layer.outer off\nset layer.inner off\n" +
                             take("cut-empty") +
                             "set layer.zero on\nset layer.outer on\nset layer.inner on\n" +
                             take("cut-zero") + "quit\n";
  REQUIRE(run_window("cut-faces", script, sphere) == 0);
  const Image cut = taken("cut"), zero = taken("cut-zero");
  CHECK(drawn(taken("cut-empty"), [](int, int) { return true; }).pixels == 0);
  // Along the middle row from the left: nothing, the band, what lies behind the plane.
  const int row = cut.height / 2, middle = cut.width / 2;
  int begin = 0;
  while (begin < middle && at(cut, begin, row)[3] == 0) ++begin;
  REQUIRE(begin < middle / 2);
  // δ is 12 % of the diameter: Ω reaches from 0.76 to 1.24 radii.
  const int radius = static_cast<int>((middle - begin) / 1.24), half = static_cast<int>(0.15 * radius);
  const auto in_band = [&](int x, int y) { return y == row && std::abs(x - (middle - radius)) < half; };
  const auto in_hollow = [&](int x, int y) { return y == row && std::abs(x - middle) < half; };
  const Drawn band = drawn(cut, in_band), hollow = drawn(cut, in_hollow);
  CHECK(band.pixels > static_cast<std::size_t>(half));
  CHECK(band.opacity > hollow.opacity + 20);
  // Z crosses the row there and nowhere in the hollow before the surface behind it.
  int crossings = 0;
  for (int x = begin; x < middle - static_cast<int>(0.7 * radius); ++x)
    crossings += at(cut, x, row) != at(zero, x, row) ? 1 : 0;
  CHECK(crossings >= 1);
}

TEST_CASE("a real mouse drags the clip's plane by its disc and turns it by the tip of its arrow") {
  CHECK(run_window("clip-handle", R"(
wait settled
look z
set clip plane
set clip.normal x
set clip.x 0
wait 0.2
expect heading == 0 and clip.normal == "1,0,0"
drag 620 292 660 292
expect clip.x > 0.01 and heading == 0 and selection == none
set clip.x 0
drag 678 292 660 240
expect clip.normal != "1,0,0" and heading == 0
quit
)",
                   sphere + " --size 1280x800") == 0);
}

TEST_CASE("the section through an edge shows kernel, Ψ, octree cells and candidates, in figures too") {
  const std::string figure = file("attempt.svg"), bare = file("attempt-bare.svg");
  CHECK(run_window("attempt-section", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
next-event rejection outside-tolerance zero-set
wait answers
expect xray.kernel_faces > 3 and xray.psi_count >= 1 and xray.recorded >= 1
set xray.target octree
wait answers
expect xray.cells_visited > 20
section-selection
wait answers
expect mode == split and clip == plane
expect-words section, normal
section
legend
wait 0.2
expect-words kernel
expect-words Ψ
expect-words octree
expect-words candidate
svg )" + figure + R"(
psi
octree-cells
expect xray.psi == off and xray.cells == off
svg )" + bare + R"(
quit
)",
                   "gallery:bracket --effort 0 --until zero-set --size 1280x800") == 0);
  const std::string with = text_of(figure), without = text_of(bare);
  for (const char* id : {"id=\"edge-kernel\"", "id=\"edge-psi\"", "id=\"edge-cells\"", "id=\"edge-marks\""})
    CHECK_MESSAGE(with.find(id) != std::string::npos, std::string(id));
  CHECK(without.find("id=\"edge-kernel\"") != std::string::npos);
  CHECK(without.find("id=\"edge-psi\"") == std::string::npos);
  CHECK(without.find("id=\"edge-cells\"") == std::string::npos);
}

TEST_CASE("maps of Z have a bar with their name, ends and mean in sight") {
  CHECK(run_window("map-bars", R"(
wait settled
colour-by distance
wait answers
wait 0.2
expect-words Z by distance
expect-words mean
expect-words largest
colour-by normals
wait answers
wait 0.2
expect-words Z by deviation
expect-words °
colour-by valence
wait answers
wait 0.2
expect-words Z by valence
colour-by age
wait answers
wait 0.2
expect-words Z by age
expect map.largest <= steps
colour-by none
legend
wait 0.2
expect-no-words Z by
expect-words outer boundary of Ω
expect-words inner boundary of Ω
expect-words Z, the mesh
legend
wait 0.2
expect-no-words outer boundary of Ω
quit
)",
                   sphere + " --size 1280x800") == 0);
}

TEST_CASE("at first good samples are drawn around the operation alone, bad ones everywhere") {
  const std::string script = R"(
wait settled
seek 100
wait settled
expect samples.near == on and tets.zero == off and tets.all == off and layer.input == off
expect bad_samples > 0
set axes off
set layer.good off
)" + take("no-dots") + "set layer.good on\n" +
                             take("few-dots") + "near-samples\nexpect samples.near == off\n" +
                             take("carpet") + "set layer.bad off\n" + take("no-crosses") +
                             "set layer.bad on\nseek 1\nwait settled\n" + take("all-bad") +
                             "set layer.bad off\n" + take("all-bad-hidden") + "quit\n";
  REQUIRE(run_window("default-scene", script, "gallery:bracket --until refinement") == 0);
  const Image none = taken("no-dots"), few = taken("few-dots"), carpet = taken("carpet"),
              no_bad = taken("no-crosses");
  const std::size_t of_few = differing(none, few), of_carpet = differing(none, carpet);
  CHECK(of_few > 0);
  CHECK(of_carpet > 5 * of_few);
  CHECK(differing(carpet, no_bad) > 20);
  // Before Z is there every sample of a boundary is bad: they do not hide what they lie on.
  const Image all_bad = taken("all-bad"), hidden = taken("all-bad-hidden");
  const std::size_t of_all = differing(all_bad, hidden);
  CHECK(of_all > 1000);
  CHECK(of_all < 4 *
                     drawn(
                         hidden, [](int, int) { return true; })
                         .pixels /
                     10);
}

TEST_CASE("while a run is prepared its input is seen, one bar tells how far it is, and nothing is judged") {
  const std::string preparing = file("preparing.png");
  CHECK(run_window("preparing", R"(
wait until preparation.share > 0.3
expect phase == preparing and bad_samples == nan and violating_2 == nan and violating_3 == nan
expect step == 0 and steps == 0 and certified == off
expect-words Preparing
expect-no-words 0 bad
wait until preparation.seconds > 1.2
wait 0.1
expect-words s, about
expect-words left
expect-words Cancel
screenshot )" + preparing + R"( view
open gallery:sphere
wait settled
expect preparation.share == none
expect-no-words Preparing
quit
)",
                   "gallery:knot --tolerance 0.6% --sigma 0.2 --paused --size 1280x800") == 0);
  const Image image = *read_png(preparing);
  std::size_t green = 0, bright = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b, a] = at(image, x, y);
      bright += r > 110 && g > 110 && b > 110 ? 1 : 0;
      green += g > 90 && r < g / 2 && b < g ? 1 : 0; // as good samples are
    }
  CHECK(bright > 5000);
  CHECK(green == 0);
}
