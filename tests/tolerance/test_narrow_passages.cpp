// Passages that the main cells are too coarse for, between regions of points: a neck and a hole of known
// width, around what Ω' leaves open.
#include "support/clouds.h"
#include "tolerance/regions.h"
#include "tolerance/tolerance_volume.h"
#include "tolerance/weighted_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

constexpr double delta = 0.3, boundary = 0.95 * delta;

ToleranceVolume volume_of(const std::vector<Vec3>& points) {
  std::vector<WeightedPoint> sites;
  for (const Vec3 p : points) sites.push_back({p, 0});
  InputTopology input;
  input.side_rule = SideRule::depth;
  auto built = ToleranceVolume::build(std::make_shared<const WeightedPointIndex>(sites, 60), input,
                                      {.delta = delta}, RunControl());
  if (!built) FAIL(built.error().line());
  return std::move(built).value();
}

std::ptrdiff_t insides(const ToleranceVolume& volume) {
  const auto regions = volume.regions();
  return std::count_if(regions.begin(), regions.end(), [](const Region& r) { return r.label < 0; });
}

/// Two spheres of radius 2 around (±3, 0, 0) with a tube of this radius between them.
std::vector<Vec3> dumbbell(double neck) {
  Random random(1);
  std::vector<Vec3> points;
  for (const double x : {-3.0, 3.0})
    for (const Vec3 p : sphere_points(random, 12000, 2, 0)) {
      const Vec3 q = p + Vec3{x, 0, 0};
      if (std::hypot(q.y, q.z) > neck || std::abs(q.x) > 3) points.push_back(q);
    }
  const double end = 3 - std::sqrt(4 - neck * neck);
  constexpr double step = 0.03;
  const int around = static_cast<int>(2 * std::numbers::pi * neck / step);
  for (double x = -end; x <= end; x += step)
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      points.push_back({x, neck * std::cos(angle), neck * std::sin(angle)});
    }
  return points;
}

/// A sphere of radius 2 with a round hole of this radius.
std::vector<Vec3> pierced_sphere(double hole) {
  Random random(2);
  std::vector<Vec3> points = sphere_points(random, 16000, 2, 0);
  std::erase_if(points, [&](Vec3 p) { return p.z > 0 && std::hypot(p.x, p.y) < hole; });
  const double z = std::sqrt(4 - hole * hole);
  for (int k = 0; k < 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200;
    points.push_back({hole * std::cos(angle), hole * std::sin(angle), z});
  }
  return points;
}

} // namespace

TEST_CASE("a neck little wider than what Ω closes joins two insides, a narrower one does not") {
  for (const double width : {1.05, 1.1, 1.3}) {
    CAPTURE(width);
    const ToleranceVolume volume = volume_of(dumbbell(width * boundary));
    CHECK(insides(volume) == 1);
    CHECK(volume.octree().passages().empty());
  }
  CHECK(insides(volume_of(dumbbell(0.9 * boundary))) == 2);
}

TEST_CASE("a hole little wider than what Ω closes leaves no inside, a narrower one does") {
  for (const double width : {1.05, 1.1, 1.3}) {
    CAPTURE(width);
    CHECK(insides(volume_of(pierced_sphere(width * boundary))) == 0);
  }
  CHECK(insides(volume_of(pierced_sphere(0.9 * boundary))) == 1);
}
