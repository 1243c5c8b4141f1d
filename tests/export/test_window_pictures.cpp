// Sessions of the real window that write pictures, figures and films, and what is in those files.
#include "platform/image_file.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;
namespace fs = std::filesystem;

namespace {

const fs::path results = ISOSCOPE_RESULTS;

std::string at(const std::string& name) {
  return (results / name).string();
}

/// Runs the window with a script on a coarse sphere; the exit status.
int run_script(const std::string& name, const std::string& script, const std::string& before = "",
               const std::string& tolerance = "12%") {
  return run_window(name, script, "gallery:sphere --until refinement --tolerance " + tolerance, "", before);
}

Image picture(const std::string& name) {
  auto image = read_png(results / name);
  REQUIRE(image.ok());
  return std::move(*image);
}

int channel(const Image& image, int x, int y, int c) {
  return image.pixels[static_cast<std::size_t>((y * image.width + x) * 4 + c)];
}

/// The mean difference of a column to its right neighbour, all channels.
double step_after(const Image& image, int x) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int c = 0; c < 3; ++c) sum += std::abs(channel(image, x, y, c) - channel(image, x + 1, y, c));
  return sum / image.height;
}

std::string read(const std::string& name) {
  std::ifstream in(results / name);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + part.size())) ++n;
  return n;
}

/// Whether all elements of an XML text close in order and no stray < or & is in it.
bool well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '&') {
      const std::string entity = text.substr(i, text.find(';', i) - i);
      if (entity != "&amp" && entity != "&lt" && entity != "&gt" && entity != "&quot") return false;
    }
    if (text[i] != '<') continue;
    const std::size_t end = text.find('>', i);
    if (end == std::string::npos) return false;
    const std::string tag = text.substr(i + 1, end - i - 1);
    i = end;
    if (tag.find('<') != std::string::npos || count(tag, "\"") % 2 != 0) return false;
    if (tag.front() == '?' || tag.back() == '/') continue;
    const std::string word = tag.substr(0, tag.find_first_of(" \n"));
    if (word.front() != '/') {
      open.push_back(word);
    } else {
      if (open.empty() || "/" + open.back() != word) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

std::size_t frames_in(const std::string& folder) {
  std::size_t n = 0;
  for (const auto& entry : fs::directory_iterator(results / folder))
    if (entry.path().extension() == ".png") ++n;
  return n;
}

/// A program called ffmpeg in a folder of its own, in front of PATH.
std::string with_ffmpeg(const std::string& name, const std::string& body) {
  const fs::path folder = results / name;
  fs::create_directories(folder);
  std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << body << "\n";
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  return "PATH=" + folder.string() + ":$PATH ";
}

} // namespace

TEST_CASE("pictures have the size asked for, no seams, and an alpha that composites to the opaque picture") {
  REQUIRE(run_script("pictures",
                     "wait settled\ntheme paper\nset layer.outer.opacity 0.4\nset tets.all on\n"
                     "set layer.tets.opacity 0.5\npicture " +
                         at("opaque.png") + " 1500x1100\npicture " + at("clear.png") +
                         " 1500x1100 alpha\npicture " + at("small.png") +
                         " 64x48\nexpect export.pictures == 3 and export.error == none\n"
                         "picture /nowhere/at/all.png 64x48\nexpect export.error == io\nquit\n") == 0);
  const Image opaque = picture("opaque.png"), clear = picture("clear.png"), small = picture("small.png");
  CHECK(opaque.width == 1500);
  CHECK(opaque.height == 1100);
  CHECK(small.width == 64);
  CHECK(small.height == 48);
  REQUIRE(clear.pixels.size() == opaque.pixels.size());
  for (const int x : {0, clear.width - 1})
    for (const int y : {0, clear.height - 1}) {
      CHECK(channel(clear, x, y, 3) == 0);
      CHECK(channel(opaque, x, y, 3) == 255);
    }
  std::size_t whole = 0, partial = 0;
  double difference = 0;
  for (int y = 0; y < clear.height; ++y)
    for (int x = 0; x < clear.width; ++x) {
      const int alpha = channel(clear, x, y, 3);
      whole += alpha == 255;
      partial += alpha > 0 && alpha < 255;
      for (int c = 0; c < 3; ++c)
        difference +=
            std::abs(channel(clear, x, y, c) * alpha / 255.0 + 255 - alpha - channel(opaque, x, y, c));
    }
  CHECK(channel(clear, clear.width / 2, clear.height / 2, 3) == 255);
  CHECK(whole > 10000);
  CHECK(partial > 10000);
  CHECK(difference / (3.0 * clear.width * clear.height) < 0.5);
  // The tile ends after column 1023: it must look like its neighbours.
  const double seam = step_after(opaque, 1023);
  CHECK(seam <= 1.5 * (step_after(opaque, 1019) + step_after(opaque, 1027)) / 2 + 0.5);
}

TEST_CASE("a view file is drawn from without moving the window's camera") {
  REQUIRE(run_script("view", "wait settled\nlook z\npicture " + at("front.png") + " 300x300\nquit\n") == 0);
  std::ofstream(at("side.json")) << R"({"mode": 1})";
  REQUIRE(run_script("view-file", "wait settled\nlook z\npicture " + at("section.png") + " 300x300 " +
                                      at("side.json") + "\npicture " + at("again.png") +
                                      " 300x300\nexpect export.pictures == 2\nquit\n") == 0);
  CHECK(picture("front.png").pixels == picture("again.png").pixels);
  CHECK(picture("front.png").pixels != picture("section.png").pixels);
}

TEST_CASE("the section as SVG is well-formed, in millimetres, with every class in its shape") {
  REQUIRE(run_script("figure", "wait settled\nset layer.gamma on\nsvg " + at("good.svg") +
                                   "\nseek 3\nexpect bad_samples > 0\nsvg " + at("bad.svg") +
                                   "\nexpect export.figures == 2 and export.error == none\nquit\n") == 0);
  const std::string good = read("good.svg"), bad = read("bad.svg");
  for (const std::string& text : {good, bad}) {
    CHECK(well_formed(text));
    CHECK(text.find("width=\"160mm\"") != std::string::npos);
    for (const char* id : {"tolerance", "outer-half", "inner-half", "triangulation", "zero-set", "gamma",
                           "samples-good-outer", "samples-good-inner", "samples-bad", "scale-bar", "caption"})
      CHECK(count(text, "id=\"" + std::string(id) + "\"") == 1);
    CHECK(count(text, "class=\"good-outer\"") > 10);
    CHECK(text.find("α = 0.2") != std::string::npos);
    // Two closed curves a half of Ω: both boundaries of the band.
    const std::size_t from = text.find("id=\"outer-half\"");
    CHECK(count(text.substr(from, text.find("/>", from) - from), "Z") == 2);
  }
  CHECK(count(good, "class=\"bad\"") == 0);
  CHECK(count(bad, "class=\"bad\"") > 0);
  CHECK(bad.find("step 3") != std::string::npos);
}

TEST_CASE("turntables and steps become frames and, through ffmpeg, films") {
  for (const char* folder : {"turn", "steps"}) fs::remove_all(results / folder);
  const std::string path = with_ffmpeg("fake", R"(for last; do :; done; echo "$@" > "$last")");
  REQUIRE(run_script("films",
                     "wait settled\nseek 3\nturntable " + at("turn") + " 4 160x120 " + at("turn.mp4") +
                         " 30fps\nexpect export.frames == 4 and export.films == 1\nstep-frames " +
                         at("steps") +
                         " 2 11 4 161x121 alpha\nexpect export.frames == 8 and "
                         "export.films == 1 and step == 3 and state_step == 3\nquit\n",
                     path) == 0);
  CHECK(frames_in("turn") == 4);
  CHECK(frames_in("steps") == 4);
  CHECK_FALSE(fs::exists(results / "turn" / "ffmpeg.log"));
  const std::string film = read("turn.mp4");
  CHECK(film.find("-framerate 30") != std::string::npos);
  CHECK(film.find("-frames:v 4") != std::string::npos);
  CHECK(film.find("turn/frame_%04d.png") != std::string::npos);
  const Image first = picture("steps/frame_0001.png"), last = picture("steps/frame_0004.png");
  CHECK(first.width == 161);
  CHECK(first.pixels != last.pixels);
  CHECK(picture("turn/frame_0001.png").pixels != picture("turn/frame_0002.png").pixels);
}

TEST_CASE("the real ffmpeg makes a film of as many frames, where it is there" *
          doctest::test_suite("ffmpeg")) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) {
    MESSAGE("SKIPPED: no ffmpeg on PATH.");
    return;
  }
  REQUIRE(run_script("real-film", "wait settled\nturntable " + at("real") + " 6 161x120 " + at("real.mp4") +
                                      " 25fps\nexpect export.films == 1 and export.error == none\nquit\n") ==
          0);
  // Read back as raw frames: six of 162 x 120, the width made even.
  REQUIRE(std::system(
              ("ffmpeg -v error -y -i " + at("real.mp4") + " -f rawvideo -pix_fmt rgb24 " + at("real.rgb"))
                  .c_str()) == 0);
  CHECK(fs::file_size(results / "real.rgb") == 6u * 162u * 120u * 3u);
}

TEST_CASE("a failing ffmpeg is quoted, a missing one is said, a cancelled film leaves the step") {
  const std::string failing = with_ffmpeg("failing", "echo no such codec >&2; exit 3");
  const std::string log = at("failing.log");
  REQUIRE(run_script("failing",
                     "wait settled\nturntable " + at("turn") + " 2 64x48 " + at("no.mp4") +
                         "\nexpect export.error == io and export.films == 0\nstep-frames " + at("steps") +
                         " 0 end 1 64x48\ncancel-export\nexpect export.frames < 15\nquit\n",
                     failing + "2>" + log + " ") == 0);
  CHECK(read("failing.log").find("no such codec") != std::string::npos);
  const fs::path empty = results / "empty";
  fs::create_directories(empty);
  REQUIRE(run_script("missing",
                     "wait settled\nturntable " + at("turn") + " 2 64x48 " + at("no.mp4") +
                         "\nexpect export.error == io and export.frames == 0\nquit\n",
                     "PATH=" + empty.string() + " 2>" + log + " ") == 0);
  CHECK(read("failing.log").find("not on PATH") != std::string::npos);
}

TEST_CASE("beyond the history's limit the older steps are read from the disk") {
  CHECK(run_window("history-disk", R"(
wait settled
seek 100
expect history.disk == 0 and history.journal > 11600000
set history.limit 22
seek 5
wait settled
expect history.disk > 200000 and history.journal < 11600000
seek 700
wait settled
expect state_step == 700 and messages == 0
quit
)",
                   "gallery:sphere --tolerance 1% --sigma 0.5") == 0);
}

TEST_CASE("the history's limit is kept by keyframes and missed aloud by samples alone") {
  CHECK(run_script("history", R"(
wait settled
expect history.journal > 1048576 and messages == 0
expect history.limit == 2048
set history.limit 1
wait settled
expect history.keyframes == 0 and messages == 1
seek 5
expect history.keyframes == 0 and messages == 1
quit
)",
                   "", "2.5%") == 0);
}

TEST_CASE("the command line takes a plain screenshot of a step") {
  fs::create_directories(results);
  const std::string common =
      std::string(ISOSCOPE_PROGRAM) + " gallery:sphere --tolerance 12% --until refinement ";
  CHECK(exit_of(common + "--step 4 --transparent --size 320x200 --screenshot " + at("plain.png")) == 0);
  const Image plain = picture("plain.png");
  CHECK(plain.width == 320);
  CHECK(plain.height == 200);
  CHECK(channel(plain, 0, 0, 3) == 0);
  CHECK(exit_of(common + "--plain --screenshot /nowhere/at/all.png 2>/dev/null") == 1);
  CHECK(exit_of(common + "--plain 2>/dev/null") == 2);
}
