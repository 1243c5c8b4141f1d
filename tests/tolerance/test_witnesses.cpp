// Every part of {d > δ} has a witness of its side, also where parts are joined beyond δ' only.
#include "tolerance/shapes.h"
#include "tolerance/tolerance_volume.h"

#include "input/gallery.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

ToleranceVolume build(const TriangleSoup& soup, double delta, double ratio = 0.95) {
  const auto index = std::make_shared<const ClosestPointIndex>(soup);
  auto built = ToleranceVolume::build(index, analyse_input(soup), {delta, ratio}, RunControl());
  REQUIRE(built.ok());
  return std::move(*built);
}

/// Two balls of radius 0.3 about (0, 0, 0) and (0, 0, 1), joined by a neck of the radius given.
TriangleSoup dumbbell(double neck) {
  constexpr unsigned rows = 64, columns = 32;
  constexpr double ball = 0.3, end = 0.999 * ball;
  TriangleSoup soup;
  testing::add_tube(soup, rows, columns, false, [&](unsigned i, unsigned j) {
    const double z = -end + (1 + 2 * end) * i / rows, nearest = std::min(std::abs(z), std::abs(z - 1));
    const double around = nearest < ball ? std::sqrt(ball * ball - nearest * nearest) : 0;
    const double r = z < 0 || z > 1 ? around : std::max(around, neck);
    const double angle = 2 * std::numbers::pi * j / columns;
    return Vec3{r * std::cos(angle), r * std::sin(angle), z};
  });
  const auto south = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back({0, 0, -ball});
  soup.points.push_back({0, 0, 1 + ball});
  for (std::uint32_t j = 0; j < columns; ++j) {
    const std::uint32_t next = (j + 1) % columns, last = rows * columns;
    soup.triangles.push_back({south, next, j});
    soup.triangles.push_back({south + 1, last + j, last + next});
  }
  return soup;
}

/// Witnesses of a side above or below the plane z = 0.5.
std::size_t count(const ToleranceVolume& volume, int label, bool above) {
  std::size_t n = 0;
  for (const Witness& w : volume.witnesses()) n += w.label == label && (w.point.z > 0.5) == above ? 1u : 0u;
  return n;
}

void check_sides(const ToleranceVolume& volume) {
  for (const Witness& w : volume.witnesses()) {
    CHECK(w.depth > volume.thresholds().delta);
    CHECK(w.depth == doctest::Approx(volume.index().distance(w.point)));
    CHECK(w.label == (volume.index().inside_by_parity(w.point) ? -1 : +1));
  }
}

} // namespace

TEST_CASE("both bulbs of a dumbbell have a witness when its neck lies between the two thresholds") {
  constexpr double delta = 0.08;
  const ToleranceVolume volume = build(dumbbell(0.07), delta, 0.5);
  REQUIRE(volume.input().closed_manifold);
  REQUIRE(volume.regions().size() == 2); // {d > δ'} passes through the neck, {d > δ} does not
  check_sides(volume);
  CHECK(count(volume, -1, false) >= 1);
  CHECK(count(volume, -1, true) >= 1);
  CHECK(count(volume, +1, false) + count(volume, +1, true) >= 1);
}

TEST_CASE("a ball has witnesses of both sides, the unbounded one first") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 16);
  const ToleranceVolume volume = build(soup, 0.1);
  check_sides(volume);
  std::size_t inside = 0;
  for (const Witness& w : volume.witnesses()) inside += w.label < 0 ? 1u : 0u;
  CHECK(inside >= 1);
  CHECK(volume.witnesses().front().label == +1);
}

TEST_CASE("witnesses of the bundled closed models lie beyond the tolerance on the side they name") {
  for (const GalleryEntry& entry : gallery()) {
    if (entry.gives_volume()) continue;
    CAPTURE(std::string(entry.name));
    const auto soup = make_gallery_model(entry.name);
    REQUIRE(soup.ok());
    if (soup->is_point_set() || !analyse_input(*soup).sides_known()) continue;
    const auto index = std::make_shared<const ClosestPointIndex>(*soup);
    const ToleranceVolume volume =
        build(*soup, 2 * entry.tolerance_percent / 100 * index->bounds().longest_edge());
    CHECK(!volume.witnesses().empty());
    check_sides(volume);
  }
}
