// The distance from an input to a mesh against a limit: proven both ways, with the places that are left
// behind.
#include "run/coverage.h"

#include "base/parallel.h"
#include "run/certificate.h"
#include "run/exposed_input.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

using Verdict = Coverage::Verdict;

Coverage judge(const TriangleSoup& input, const TriangleSoup& mesh, double limit, double resolution = 0.05) {
  const ClosestPointIndex from(input), to(mesh);
  const DistanceBounds bounds = bound_distance(from, to, 0.01 * limit, RunControl());
  return judge_coverage(from, to, bounds, limit, resolution, RunControl());
}

/// A needle from p along x.
void add_needle(TriangleSoup& soup, Vec3 p, double length) {
  add_box(soup, p, p + Vec3{length, 1e-3, 1e-3});
}

} // namespace

TEST_CASE("A limit just above the farthest corner covers, one just below does not") {
  TriangleSoup inner, outer;
  add_box(inner, {0, 0, 0}, {1, 1, 1});
  add_box(outer, {-1, -1, -1}, {2, 2, 3});
  const double farthest = std::sqrt(6.0);
  CHECK(judge(outer, inner, farthest * (1 + 1e-6)).verdict == Verdict::covered);
  const Coverage beyond = judge(outer, inner, farthest * (1 - 1e-6));
  CHECK(beyond.verdict == Verdict::uncovered);
  // Four corners of the far face.
  CHECK(beyond.count == 4);
  for (const UncoveredPlace& p : beyond.places) {
    CHECK(p.distance == doctest::Approx(farthest).epsilon(1e-4));
    CHECK(p.point.z == doctest::Approx(3).epsilon(1e-4));
    CHECK(p.size < 0.01);
  }
  CHECK(judge(inner, inner, 1e-9).verdict == Verdict::covered);
}

TEST_CASE("Needles that a mesh leaves behind are told one by one, the farthest first") {
  TriangleSoup input, mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 1});
  input = mesh;
  add_needle(input, {1, 0.1, 0.5}, 0.4);
  add_needle(input, {1, 0.5, 0.5}, 2);
  add_needle(input, {1, 0.9, 0.5}, 1);
  const Coverage coverage = judge(input, mesh, 0.15);
  REQUIRE(coverage.verdict == Verdict::uncovered);
  REQUIRE(coverage.count == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = std::array{2.0, 1.0, 0.4}[i];
    CHECK(coverage.places[i].distance == doctest::Approx(length).epsilon(0.03));
    CHECK(coverage.places[i].point.x == doctest::Approx(1 + length).epsilon(0.03));
    CHECK(coverage.places[i].size == doctest::Approx(length - 0.15).epsilon(0.2));
  }
  CHECK(judge(input, mesh, 2.01).verdict == Verdict::covered);
  CHECK(judge(input, mesh, 1.5).count == 1);
}

TEST_CASE("Of many places ten are told and all counted, the same on any number of threads") {
  TriangleSoup input, mesh;
  add_box(mesh, {0, 0, 0}, {1, 4, 1});
  input = mesh;
  for (int i = 0; i < 14; ++i) add_needle(input, {1, 0.1 + 0.27 * i, 0.5}, 0.5 + 0.01 * ((5 * i) % 14));
  Coverage coverage[2];
  for (const unsigned threads : {1u, 3u}) {
    const ThreadLimit limit(threads);
    coverage[threads == 1 ? 0 : 1] = judge(input, mesh, 0.2);
  }
  CHECK(coverage[0].count == 14);
  REQUIRE(coverage[0].places.size() == most_uncovered_places);
  REQUIRE(coverage[1].places.size() == most_uncovered_places);
  for (std::size_t i = 0; i < most_uncovered_places; ++i) {
    CHECK(coverage[0].places[i].point == coverage[1].places[i].point);
    CHECK(coverage[0].places[i].distance == coverage[1].places[i].distance);
    if (i > 0) CHECK(coverage[0].places[i].distance <= coverage[0].places[i - 1].distance);
  }
  CHECK(coverage[0].places[0].distance == doctest::Approx(0.63).epsilon(0.05));
}

TEST_CASE("An abandoned judgement is undecided") {
  TriangleSoup input, mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 1});
  add_box(input, {0, 0, 0}, {1, 1, 2});
  RunControl control;
  control.abandon();
  const ClosestPointIndex from(input), to(mesh);
  CHECK(judge_coverage(from, to, {}, 0.1, 0.1, control).verdict == Verdict::undecided);
}

TEST_CASE("The certificate judges coverage by the limit, tells it where thin parts may go, or leaves it") {
  TriangleSoup input;
  add_box(input, {0, 0, 0}, {1, 1, 1});
  const TriangleMesh mesh{input.points, input.triangles};
  add_needle(input, {1.0005, 0.5, 0.5}, 1);
  auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(input), analyse_input(input),
                                       {0.05, 0.95}, RunControl());
  REQUIRE(volume.ok());
  ExpectedTopology expected;
  expected.euler_characteristic = 2;
  expected.components = 1;
  expected.source = "the box";
  const auto certified = [&](const CoverTest& test) {
    return certify(mesh, *volume, expected, RunControl(), test);
  };
  const Certificate fails = certified({});
  CHECK(!fails.covers);
  CHECK(!fails.holds());
  REQUIRE(fails.failures.size() == 1);
  CHECK(fails.failures[0].find("The input is farther than 3 δ from the mesh in one place, 20.01 δ at") == 0);
  REQUIRE(fails.uncovered.size() == 1);
  CHECK(fails.uncovered[0].point.x == doctest::Approx(2).epsilon(0.01));
  CHECK(certified({25.0}).holds());
  CHECK(certified({25.0}).covers);
  const Certificate off = certified({std::nullopt});
  CHECK(off.holds());
  CHECK(!off.cover_limit);
  CHECK(off.input_distance.lower > 0.9);
  const Certificate may_go = certified({3.0, true});
  CHECK(may_go.holds());
  CHECK(may_go.uncovered_count == 1);
  CHECK(may_go.cover_note.find("Only the sides had to be separated") == 0);
}

TEST_CASE("A sheet that stands out of a closed body and is left behind is told as what it is") {
  TriangleSoup input;
  add_sphere(input, {0, 0.5, 0.5}, 1, 24);
  const TriangleMesh mesh{input.points, input.triangles};
  const auto first = static_cast<std::uint32_t>(input.points.size());
  const auto certified = [&](double from, double to, bool twice = false) {
    TriangleSoup with = input;
    for (const Vec3 p : {Vec3{from, 0.3, 0.5}, {to, 0.3, 0.5}, {to, 0.7, 0.5}, {from, 0.7, 0.5}})
      with.points.push_back(p);
    with.triangles.push_back({first, first + 1, first + 2});
    with.triangles.push_back({first, first + 2, first + 3});
    if (twice) {
      with.triangles.push_back({first + 2, first + 1, first});
      with.triangles.push_back({first + 3, first + 2, first});
    }
    const auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(with),
                                               analyse_input(with), {0.05, 0.95}, RunControl());
    REQUIRE(volume.ok());
    return certify(mesh, *volume, {}, RunControl());
  };
  for (const double end : {1.6, 0.3}) { // outside and inside
    const Certificate c = certified(0.9, end);
    CAPTURE(end);
    CHECK(!c.covers);
    const auto told = std::find_if(c.failures.begin(), c.failures.end(), [](const std::string& words) {
      return words.find("A sheet has one region on both sides at ") == 0;
    });
    REQUIRE(told != c.failures.end());
    CHECK(told->find("Remove what stands out, or ask for no cover") != std::string::npos);
  }
  CHECK(certified(0.9, 1.05).covers); // not far out
  CHECK(!certified(0.9, 1.6, true).covers);
}

TEST_CASE("Walls inside of where parts overlap or touch need not be covered") {
  TriangleSoup crossing;
  add_box(crossing, {0, 0, 0}, {1, 1, 1});
  add_box(crossing, {0.5, 0.25, 0.25}, {1.5, 0.75, 0.75});
  const auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(crossing),
                                             analyse_input(crossing), {0.02, 0.95}, RunControl());
  REQUIRE(volume.ok());
  const ExposedInput all = exposed_input(*volume, 0.01, RunControl());
  CHECK(!all.closed_gap);
  const ClosestPointIndex* exposed = all.walls.get();
  double area = 0;
  for (std::size_t i = 0; i < exposed->size(); ++i) {
    const Triangle3& t = exposed->triangle(TriangleId(i));
    area += 0.5 * length(cross(t[1] - t[0], t[2] - t[0]));
  }
  // The union has 8.5 less the walls inside: a quarter of a square where the bar leaves, and what is in the
  // box.
  CHECK(area == doctest::Approx(7.0).epsilon(0.01));
}

TEST_CASE("Walls in a gap between parts that Ω closes need not be covered, those of a wider one do") {
  const auto walls = [](const TriangleSoup& soup) {
    const auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(soup),
                                               analyse_input(soup), {0.05, 0.95}, RunControl());
    REQUIRE(volume.ok());
    return exposed_input(*volume, 0.01, RunControl());
  };
  const auto area = [](const ClosestPointIndex& index) {
    double sum = 0;
    for (std::size_t i = 0; i < index.size(); ++i) {
      const Triangle3& t = index.triangle(TriangleId(i));
      sum += 0.5 * length(cross(t[1] - t[0], t[2] - t[0]));
    }
    return sum;
  };
  for (const double gap : {0.04, 0.2}) {
    TriangleSoup boxes; // a small one over a large one
    add_box(boxes, {0, 0, 0}, {2, 2, 1});
    add_box(boxes, {0.5, 0.5, 1 + gap}, {1.5, 1.5, 2});
    const ExposedInput exposed = walls(boxes);
    const double all = 2 * 4 + 4 * 2 + 2 + 4 * (1 - gap);
    REQUIRE(exposed.closed_gap.has_value() == (gap < 0.095));
    // A square of each wall, but for a seam.
    CHECK(area(*exposed.walls) == doctest::Approx(exposed.closed_gap ? all - 2 : all).epsilon(0.01));
    if (exposed.closed_gap) CHECK(std::abs(exposed.closed_gap->z - 1) <= 0.04 + 1e-9);
  }
}
