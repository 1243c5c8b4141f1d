// Samples lie on the boundary, cover it, have the label of their side, and do not depend on threads.
#include "base/parallel.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/regions.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

ToleranceVolume volume_of(const TriangleSoup& soup, double delta, double ratio = 0.95) {
  auto v = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(soup), analyse_input(soup),
                                  {delta, ratio}, RunControl());
  REQUIRE(v.ok());
  return std::move(v).value();
}

/// Random points of ∂Ω': outside ones projected along the direction to their closest point, which is exact.
std::vector<Vec3> random_boundary_points(const ToleranceVolume& v, std::size_t n) {
  Random random(9);
  const double boundary = v.thresholds().boundary;
  std::vector<Vec3> points;
  while (points.size() < n) {
    const Triangle3& t = v.index().triangle(TriangleId(random.below(v.index().size())));
    const double a = random.unit(), b = random.unit() * (1 - a);
    const Vec3 p =
        t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]) + random.between(1, 1.6) * boundary * random.direction();
    const ClosestPoint c = v.index().closest(p);
    if (c.distance() <= boundary) continue;
    points.push_back(c.point + (boundary / c.distance()) * (p - c.point));
  }
  return points;
}

/// The samples, checked.
BoundarySamples check_samples(ToleranceVolume& v, SampleDensity density) {
  auto result = sample_boundary(v, density, RunControl());
  REQUIRE(result.ok());
  BoundarySamples& s = *result;
  REQUIRE(s.labels.size() == s.size());
  REQUIRE(s.components.size() == s.size());
  CHECK(s.undecided_cells == 0);
  CHECK(s.covering_radius <= std::max(density.sigma, density.flat_sigma));
  const ToleranceThresholds t = v.thresholds();
  bool snapped = true;
  double error = 0;
  std::size_t wrong_labels = 0, wrong_components = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3 p = s.positions[i];
    const ClosestPoint c = v.index().closest(p);
    error = std::max(error, std::abs(c.distance() - t.boundary));
    for (int a = 0; a < 3; ++a) snapped = snapped && std::fmod(p[a], s.snap_unit) == 0;
    const Vec3 behind = c.point + 1.04 * (p - c.point);
    wrong_labels += s.labels[i] != (v.index().inside_by_parity(behind) ? -1 : 1) ? 1u : 0u;
    wrong_components +=
        s.components[i] == 0xffff || v.boundary_components()[s.components[i]].label != s.labels[i] ? 1u : 0u;
  }
  CHECK(snapped);
  CHECK(error <= 1e-9 * t.delta);
  CHECK(wrong_labels == 0);
  CHECK(wrong_components == 0);
  for (const Vec3 p : random_boundary_points(v, 150)) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3 q : s.positions) nearest = std::min(nearest, squared_length(p - q));
    CHECK(std::sqrt(nearest) <= s.covering_radius * (1 + 1e-9));
  }
  return std::move(s);
}

} // namespace

TEST_CASE("samples of a sphere, a torus and a box cover their boundaries within sigma") {
  TriangleSoup sphere, torus, box;
  testing::add_sphere(sphere, {1, 2, 3}, 1, 32);
  testing::add_torus(torus, {0, 0, 0}, 1, 0.4, 24);
  testing::add_box(box, {0, 0, 0}, {1, 0.8, 0.5});
  const double delta = 0.1;
  for (const TriangleSoup* soup : {&sphere, &torus, &box})
    for (const double sigma : {delta, delta / 2, delta / 3}) {
      CAPTURE(sigma);
      ToleranceVolume v = volume_of(*soup, delta);
      check_samples(v, sigma);
    }
}

TEST_CASE("samples on the tolerance itself, as the sampled mode uses them") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 24);
  ToleranceVolume v = volume_of(soup, 0.1, 1.0);
  check_samples(v, 0.0125 * 2);
}

TEST_CASE("where the boundary is nearly a plane few samples cover it, elsewhere as many as ever") {
  TriangleSoup box, lentil, sphere;
  testing::add_box(box, {0, 0, 0}, {1, 0.8, 0.5});
  testing::add_sphere(lentil, {0, 0, 0}, 1, 64);
  for (Vec3& p : lentil.points) p.z *= 0.15;
  testing::add_sphere(sphere, {1, 2, 3}, 1, 32);
  const double delta = 0.02;
  for (const TriangleSoup* soup : {&box, &lentil}) {
    ToleranceVolume v = volume_of(*soup, delta);
    const BoundarySamples dense = check_samples(v, delta / 2);
    const BoundarySamples sparse = check_samples(v, {delta / 2, 2 * delta});
    CHECK(sparse.covering_radius > delta);
    CHECK(sparse.size() < 0.9 * static_cast<double>(dense.size()));
    const ThreadLimit limit(1);
    CHECK(sample_boundary(v, {delta / 2, 2 * delta}, RunControl())->positions == sparse.positions);
  }
  // Along the edges of the box nothing is a plane.
  ToleranceVolume v = volume_of(box, delta);
  const BoundarySamples of_box = check_samples(v, {delta / 2, 2 * delta});
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{random.unit(), random.between(-1, -0.01) * delta, random.between(-1, -0.01) * delta};
    const ClosestPoint c = v.index().closest(p);
    const Vec3 q = c.point + v.thresholds().boundary / c.distance() * (p - c.point);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3 sample : of_box.positions) nearest = std::min(nearest, distance(sample, q));
    CHECK(nearest <= delta / 2);
  }
  // Nor on a sphere.
  ToleranceVolume round = volume_of(sphere, 0.1);
  CHECK(check_samples(round, {0.05, 0.2}).positions == check_samples(round, 0.05).positions);
}

TEST_CASE("a soup is sampled on both sides") {
  TriangleSoup sphere;
  testing::add_sphere(sphere, {0, 0, 0}, 1, 16);
  ToleranceVolume v = volume_of(testing::exploded(sphere, 0.9), 0.08);
  auto s = sample_boundary(v, 0.04, RunControl());
  REQUIRE(s.ok());
  for (std::size_t i = 0; i < s->size(); ++i)
    REQUIRE(s->labels[i] == (length(s->positions[i]) > 1 ? +1 : -1));
}

TEST_CASE("the samples are the same bits on any number of threads") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 1, 0.4, 24);
  testing::add_sphere(soup, {0, 0, 0}, 0.25, 16);
  std::vector<BoundarySamples> runs;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    ToleranceVolume v = volume_of(soup, 0.1);
    auto s = sample_boundary(v, 0.04, RunControl());
    REQUIRE(s.ok());
    runs.push_back(std::move(s).value());
  }
  for (std::size_t k = 1; k < runs.size(); ++k) {
    CHECK(runs[k].positions == runs[0].positions);
    CHECK(runs[k].labels == runs[0].labels);
    CHECK(runs[k].components == runs[0].components);
    CHECK(runs[k].covering_radius == runs[0].covering_radius);
  }
}

TEST_CASE("samples follow each other closely") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 24);
  ToleranceVolume v = volume_of(soup, 0.05);
  auto s = sample_boundary(v, 0.025, RunControl());
  REQUIRE(s.ok());
  double mean = 0;
  for (std::size_t i = 1; i < s->size(); ++i) mean += distance(s->positions[i], s->positions[i - 1]);
  mean /= static_cast<double>(s->size() - 1);
  CHECK(mean < 8 * s->sigma);
}

TEST_CASE("sampling stops when told to, and refuses a density of zero") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 16);
  ToleranceVolume v = volume_of(soup, 0.1);
  CHECK(sample_boundary(v, 0, RunControl()).error().code == ErrorCode::usage);
  RunControl control;
  control.cancel();
  CHECK(sample_boundary(v, 0.05, control).error().code == ErrorCode::cancelled);
}
