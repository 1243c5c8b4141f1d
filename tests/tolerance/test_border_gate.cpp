// The border's branch and bound against known answers and dense sampling.
#include "tolerance/border_gate.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

constexpr double delta = 0.1;

/// A regular polygon of n edges on the unit circle.
std::vector<Segment3> circle(int n) {
  const auto corner = [n](int i) {
    const double angle = 2 * std::numbers::pi * i / n;
    return Vec3{std::cos(angle), std::sin(angle), 0};
  };
  std::vector<Segment3> edges;
  for (int i = 0; i < n; ++i) edges.push_back({corner(i), corner((i + 1) % n)});
  return edges;
}

double sampled_distance(const Segment3& from, std::span<const Segment3> to) {
  double largest = 0;
  for (int i = 0; i <= 400; ++i) {
    double least = Box3::inf;
    for (const Segment3& s : to) least = std::min(least, distance_to(s, point_on(from, i / 400.)));
    largest = std::max(largest, least);
  }
  return largest;
}

} // namespace

TEST_CASE("closest points on segments agree with a search through all of them") {
  Random random(5);
  std::vector<Segment3> segments;
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random.in_box(box);
    segments.push_back({p, i % 10 == 0 ? p : p + 0.2 * random.direction()});
  }
  const SegmentIndex index(segments);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 1.5 * random.in_box(box);
    double least = Box3::inf;
    for (const Segment3& s : segments) least = std::min(least, distance_to(s, p));
    const ClosestOnSegments found = index.closest(p);
    CHECK(found.distance == doctest::Approx(least));
    CHECK(distance(found.point, p) == doctest::Approx(least));
    const auto near = index.near(p, 0.3);
    for (std::uint32_t s = 0; s < segments.size(); ++s)
      if (distance_to(segments[s], p) <= 0.3) CHECK(std::binary_search(near.begin(), near.end(), s));
  }
  CHECK(SegmentIndex({}).closest({}).segment == ClosestOnSegments::none);
}

TEST_CASE("an edge keeps to the rim up to δ, and not beyond") {
  const BorderGate gate({{Vec3{0, 0, 0}, Vec3{1, 0, 0}}, {Vec3{1, 0, 0}, Vec3{1, 1, 0}}}, delta);
  CHECK(gate.keeps_to_rim({Vec3{0, 0.099, 0}, Vec3{0.9, 0.099, 0}}).proven);
  CHECK_FALSE(gate.keeps_to_rim({Vec3{0, 0.101, 0}, Vec3{0.9, 0, 0}}).proven);
  // Across the corner: δ is met where both legs are equally far.
  CHECK(gate.keeps_to_rim({Vec3{0.81, 0, 0}, Vec3{1, 0.19, 0}}).proven);
  const BorderVerdict across = gate.keeps_to_rim({Vec3{0.7, 0, 0}, Vec3{1, 0.3, 0}});
  CHECK_FALSE(across.proven);
  CHECK(across.distance > delta);
  CHECK(gate.rim().closest(across.witness).distance == doctest::Approx(across.distance));
  CHECK_FALSE(BorderGate({}, delta).keeps_to_rim({Vec3{}, Vec3{}}).proven);
}

TEST_CASE("what the border covers of the rim has to stay covered") {
  const BorderGate gate({{Vec3{0, 0, 0}, Vec3{4, 0, 0}}}, delta);
  const std::vector<Segment3> before{{Vec3{0, 0, 0}, Vec3{1, 0.05, 0}}, {Vec3{1, 0.05, 0}, Vec3{2, 0, 0}}};
  const std::vector<Segment3> straight{{Vec3{0, 0.09, 0}, Vec3{2, 0.09, 0}}};
  // The sausage of the straight edge ends a little earlier than theirs.
  CHECK_FALSE(gate.covers_rim(before, straight).proven);
  std::vector<Segment3> with_next = straight;
  with_next.push_back({Vec3{2, 0.09, 0}, Vec3{4, 0, 0}});
  CHECK(gate.covers_rim(before, with_next).proven);
  const std::vector<Segment3> gap{{Vec3{0, 0, 0}, Vec3{0.8, 0, 0}}, {Vec3{1.2, 0, 0}, Vec3{4, 0, 0}}};
  const BorderVerdict bare = gate.covers_rim(before, gap);
  CHECK_FALSE(bare.proven);
  CHECK(bare.witness.x > 0.9);
  CHECK(bare.witness.x < 1.1);
  CHECK(bare.distance > delta);
  // What nothing covered before is nobody's duty, and nothing is asked where nothing goes.
  const std::vector<Segment3> far{{Vec3{0, 1, 0}, Vec3{4, 1, 0}}};
  CHECK(gate.covers_rim(far, {}).proven);
  CHECK(gate.covers_rim({}, {}).proven);
}

TEST_CASE("both proofs agree with dense sampling around a circle") {
  const std::vector<Segment3> rim = circle(60);
  const BorderGate gate(rim, delta);
  Random random(9);
  int kept = 0, left = 0;
  for (int i = 0; i < 300; ++i) {
    const double from = random.between(0, 6), to = from + random.between(0.1, 1.2);
    const auto at = [&](double angle) {
      const double r = random.between(0.93, 1.07);
      return Vec3{r * std::cos(angle), r * std::sin(angle), random.between(-0.05, 0.05)};
    };
    const Segment3 edge{at(from), at(to)};
    const double d = sampled_distance(edge, rim);
    if (std::abs(d - delta) < 1e-3 * delta) continue;
    CHECK(gate.keeps_to_rim(edge).proven == (d < delta));
    ++(d < delta ? kept : left);
  }
  CHECK(kept > 50);
  CHECK(left > 50);
  // Polygons of few edges in place of the rim itself: an edge of n sinks by 1 - cos(π/n).
  for (const int n : {5, 6, 7, 8, 12}) {
    const double sink = 1 - std::cos(std::numbers::pi / n);
    CHECK(gate.covers_rim(rim, circle(n)).proven == (sink < delta));
  }
}

TEST_CASE("samples of the rim are dense, and few where its segments are short") {
  const BorderGate gate(circle(1000), delta);
  const std::vector<Vec3> samples = gate.rim_samples();
  CHECK(samples.size() < 600);
  for (int i = 0; i < 500; ++i) {
    const double angle = 2 * std::numbers::pi * i / 500;
    const Vec3 p{std::cos(angle), std::sin(angle), 0};
    double least = Box3::inf;
    for (const Vec3 s : samples) least = std::min(least, distance(s, p));
    CHECK(least <= 0.5 * delta);
  }
}
