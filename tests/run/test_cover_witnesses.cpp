// Points that are held in thin parts: with the samples they are near to every point of the input, on both
// sides, there are few of them, and none where nothing is thin.
#include "run/cover_witnesses.h"

#include "base/parallel.h"
#include "run/complete_run.h"
#include "run/cube_with_bar.h"
#include "run/voxel_soup.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

/// Ω and S of a soup, without anything held.
struct Bare : CompleteRun {
  Bare(TriangleSoup input, double delta) : CompleteRun(std::move(input), delta) {
    parameters.cover.reset();
    REQUIRE(prepare());
  }
  CoverWitnesses found(double limit) const {
    return find_cover_witnesses(*scene->volume, SearchedSamples(scene->samples), limit, RunControl());
  }
  /// The distance from p to the nearest sample or held point of a side.
  double bareness(Vec3 p, int label, const CoverWitnesses& cover) const {
    double least = Box3::inf;
    for (std::size_t i = 0; i < scene->samples->size(); ++i)
      if (scene->samples->labels[i] == label)
        least = std::min(least, distance(p, scene->samples->positions[i]));
    for (const Witness& w : cover.held)
      if (w.label == label) least = std::min(least, distance(p, w.point));
    return least;
  }
};

std::size_t held_on(int label, const CoverWitnesses& cover) {
  return static_cast<std::size_t>(std::count_if(cover.held.begin(), cover.held.end(),
                                                [&](const Witness& w) { return w.label == label; }));
}

/// A cube with a slot of some width from its upper face down.
TriangleSoup slotted(double width) {
  TriangleSoup soup = voxel_surface({3, 3, 3}, [](int x, int, int z) { return x != 1 || z == 0; });
  for (Vec3& p : soup.points)
    if (p.x >= 2) p.x += width - 1;
  return soup;
}

} // namespace

TEST_CASE("Every point of a thin bar or fin has a sample or a held point of both sides within the limit") {
  constexpr double delta = 0.06, limit = 3 * delta;
  for (const double width : {0.3, 0.01})
    for (const double thickness : {0.05, 0.001})
      for (const double length : {0.3, 0.9}) {
        CAPTURE(width);
        CAPTURE(thickness);
        CAPTURE(length);
        const Bare bare(cube_with_bar(0.5 - width, 0.5 + width, 0.5 - thickness, 0.5 + thickness, length),
                        delta);
        const CoverWitnesses cover = bare.found(limit);
        for (double x = 1; x <= 1 + length; x += delta / 3)
          for (const double y : {0.5 - width, 0.5, 0.5 + width})
            for (const int label : {-1, +1})
              CHECK(bare.bareness({x, y, 0.5 + thickness}, label, cover) <= limit);
        // Inside of the bar, on a way that begins in the cube, and no more than a net of the fin asks for.
        for (const auto& points : {cover.held, cover.path})
          for (const Witness& w : points) {
            CHECK(w.cover);
            CHECK(w.label == -1);
            CHECK(bare.scene->volume->sides().label(w.point) == -1);
            CHECK(w.depth < delta);
          }
        const double area = 2 * width * length / (limit * limit);
        REQUIRE(cover.held.size() >= 1);
        CHECK(static_cast<double>(cover.held.size()) <= 4 + 4 * area + 2 * length / limit);
        CHECK(cover.path.front().depth > 0.9 * 0.95 * delta);
      }
}

TEST_CASE("A gap that the tolerance volume closes is held open from outside") {
  const Bare narrow(slotted(0.1), 0.15);
  const CoverWitnesses cover = narrow.found(0.45);
  CHECK(held_on(+1, cover) > 0);
  CHECK(held_on(-1, cover) == 0);
  for (const Witness& w : cover.held) {
    CHECK(w.point.x > 1);
    CHECK(w.point.x < 1.1);
  }
  for (double z = 1; z <= 3; z += 0.05) CHECK(narrow.bareness({1, 1.5, z}, +1, cover) <= 0.45);
  const Bare wide(slotted(0.4), 0.15);
  CHECK(wide.found(0.45).held.empty());
}

TEST_CASE("Nothing is held where nothing is thin, where the limit is below 2 δ, and between parts") {
  TriangleSoup cube;
  add_box(cube, {0, 0, 0}, {1, 1, 1});
  CHECK(Bare(cube, 0.05).found(0.15).path.empty());
  const Bare bar(cube_with_bar(0.45, 0.55, 0.45, 0.55, 1), 0.06);
  CHECK(!bar.found(0.18).held.empty());
  CHECK(bar.found(0.119).held.empty());
  CHECK(bar.found(1.5).held.empty());
  // Ω joins two boxes: their gap is closed on purpose.
  TriangleSoup boxes = cube;
  add_box(boxes, {1.02, 0, 0}, {2, 1, 1});
  CHECK(held_on(+1, Bare(boxes, 0.05).found(0.15)) == 0);
}

TEST_CASE("What is held is the same on any number of threads") {
  const TriangleSoup soup = cube_with_bar(0.2, 0.8, 0.499, 0.501, 1);
  std::vector<Witness> found[2];
  for (const unsigned threads : {1u, 3u}) {
    const ThreadLimit limit(threads);
    const CoverWitnesses cover = Bare(soup, 0.05).found(0.15);
    auto& all = found[threads == 1 ? 0 : 1];
    all = cover.held;
    all.insert(all.end(), cover.path.begin(), cover.path.end());
  }
  REQUIRE(found[0].size() == found[1].size());
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    CHECK(found[0][i].point == found[1][i].point);
    CHECK(found[0][i].depth == found[1][i].depth);
  }
}

TEST_CASE("Two thin fins beside each other with a thin gap between them are both kept, and the gap") {
  // A comb: its teeth and gaps are 0.05 wide and 0.6 long.
  TriangleSoup comb = voxel_surface({5, 1, 2}, [](int x, int, int z) { return z == 0 || x % 2 == 0; });
  for (Vec3& p : comb.points) p = {0.05 * p.x, p.y, p.z >= 2 ? 1.6 : p.z};
  for (Vec3& p : comb.points)
    if (p.z == 0) p.x = 2 * p.x - 0.125; // the base is wider
  CompleteRun run(comb, 0.04);
  run.parameters.effort = 1;
  REQUIRE(run.run());
  const Certificate& c = run.result->certificate;
  CHECK(c.covers);
  CHECK(c.topology_as_expected());
  CHECK(run.result->exit_status() == 0);
  CHECK(run.scene->volume->held() > 0);
}

TEST_CASE("Where a part lies in another, samples keep Z at the outside and not at the walls within") {
  constexpr double delta = 0.06, limit = 3 * delta;
  // A bar through a cube, beside one of its edges.
  TriangleSoup crossing;
  add_box(crossing, {0, 0, 0}, {1, 1, 1});
  add_box(crossing, {0.3, 0.4, 0.4}, {1.4, 0.9, 0.9});
  const Bare bare(crossing, delta);
  const CoverWitnesses cover = bare.found(limit);
  const auto is_sample = [&](const Witness& w) {
    const auto& positions = bare.scene->samples->positions;
    const auto at = std::find(positions.begin(), positions.end(), w.point);
    return at != positions.end() &&
           bare.scene->samples->labels[static_cast<std::size_t>(at - positions.begin())] == w.label;
  };
  CHECK(held_on(-1, cover) > 0);
  CHECK(held_on(-1, cover) < 60);
  CHECK(std::count_if(cover.held.begin(), cover.held.end(), is_sample) > 10);
  const auto nearest = [&](Vec3 p, int label) {
    double least = Box3::inf;
    for (const Witness& w : cover.held)
      if (w.label == label) least = std::min(least, distance(p, w.point));
    return least;
  };
  for (const int label : {-1, +1})
    for (double x = 0.35; x <= 1; x += delta) {
      CAPTURE(x);
      CHECK(nearest({x, 1, 0.95}, label) <= limit);
      CHECK(nearest({x, 1, 1}, label) <= limit + delta);
    }
  // Far from the bar nothing is kept.
  CHECK(nearest({0, 0, 0}, -1) > limit);

  TriangleSoup apart;
  add_box(apart, {0, 0, 0}, {1, 1, 1});
  add_box(apart, {1.3, 0, 0}, {2, 1, 1});
  CHECK(Bare(apart, delta).found(limit).held.empty());
}

TEST_CASE("In walls between 2 δ' and 2 δ thick samples are held, and Z goes on to their end") {
  constexpr double delta = 0.06, limit = 3 * delta;
  const auto bar = [](double thickness_in_delta) {
    const double half = 0.5 * thickness_in_delta * delta;
    return cube_with_bar(0.2, 0.8, 0.5 - half, 0.5 + half, 0.9);
  };
  const Bare plate(bar(1.97), delta);
  const CoverWitnesses cover = plate.found(limit);
  CHECK(held_on(+1, cover) == 0);
  REQUIRE(held_on(-1, cover) > 0);
  for (const Witness& w : cover.held) {
    CHECK(w.point.x > 1);
    CHECK(w.depth == doctest::Approx(0.95 * delta).epsilon(1e-6));
  }
  for (double x = 1 + limit; x <= 1.9; x += delta / 3)
    for (const double y : {0.2, 0.5, 0.8}) {
      const Vec3 p{x, y, 0.5 + 0.985 * delta};
      CHECK(std::any_of(cover.held.begin(), cover.held.end(),
                        [&](const Witness& w) { return distance(w.point, p) <= limit; }));
    }
  // Thicker ones have a witness beyond δ.
  CHECK(Bare(bar(2.1), delta).found(limit).held.empty());

  CompleteRun run(bar(1.97), delta);
  REQUIRE(run.run());
  CHECK(run.result->exit_status() == 0);
  CHECK(run.result->certificate.input_distance.upper < 2 * delta);
}

TEST_CASE("On one side of an open surface samples are held in what is cut off from the rest beyond δ") {
  constexpr double delta = 0.06;
  // A hollow cube without its face x = 0; the hollow goes on into a plate that becomes thicker than 2 δ.
  const auto hollow = [](double at_foot, double at_end) {
    TriangleSoup soup =
        cube_with_bar(0.2, 0.8, 0.5 - 0.5 * at_foot * delta, 0.5 + 0.5 * at_foot * delta, 0.9);
    for (Vec3& p : soup.points)
      if (p.x > 1.5) p.z = 0.5 + (p.z < 0.5 ? -0.5 : 0.5) * at_end * delta;
    std::erase_if(soup.triangles, [&](const auto& t) {
      return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return soup.points[v].x == 0; });
    });
    return soup;
  };
  const auto held = [](const CompleteRun& run) {
    std::vector<Witness> held;
    for (const Witness& w : run.scene->volume->witnesses())
      if (w.cover) held.push_back(w);
    return held;
  };
  for (const auto& [at_foot, at_end] : {std::pair{1.95, 2.15}, std::pair{1.97, 1.97}}) {
    CAPTURE(at_end);
    CompleteRun run(hollow(at_foot, at_end), delta);
    REQUIRE(run.run());
    CHECK(!held(run).empty());
    for (const Witness& w : held(run)) {
      CHECK(w.label == -1);
      CHECK(w.point.x > 1);
    }
    CHECK(run.result->exit_status() == 0);
    CHECK(run.result->certificate.input_distance.upper < 2 * delta);
  }
  CompleteRun thick(hollow(4, 4), delta);
  REQUIRE(thick.prepare());
  CHECK(held(thick).empty());
}
