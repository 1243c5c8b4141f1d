// What is expected of Z, and verdicts on hand-made zero sets.
#include "criteria/topology.h"

#include "input/gallery.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

ZeroSet zero_set_of(std::initializer_list<ZeroSet::Component> components) {
  ZeroSet z;
  z.components = components;
  return z;
}

ToleranceVolume volume_of(const char* model, double percent) {
  const auto soup = make_gallery_model(model);
  REQUIRE(soup.ok());
  auto index = std::make_shared<const ClosestPointIndex>(*soup);
  const double delta = percent / 100 * index->bounds().longest_edge();
  auto volume = ToleranceVolume::build(index, analyse_input(*soup), {delta, 0.95}, RunControl());
  REQUIRE(volume.ok());
  return std::move(*volume);
}

} // namespace

TEST_CASE("a verdict judges the numbers that are expected and no others") {
  const ZeroSet sphere = zero_set_of({{4, 6, 4}});
  const ZeroSet two = zero_set_of({{4, 6, 4}, {9, 27, 18}});
  ExpectedTopology expected;
  CHECK(check_topology(sphere, expected).as_expected);
  expected.euler_characteristic = 2;
  CHECK(check_topology(sphere, expected).as_expected);
  CHECK(check_topology(two, expected).as_expected);
  expected.components = 1;
  CHECK(check_topology(sphere, expected).as_expected);
  CHECK_FALSE(check_topology(two, expected).as_expected);
  CHECK(check_topology(two, expected).components == 2);
  expected.euler_characteristic = 0;
  CHECK_FALSE(check_topology(sphere, expected).as_expected);
}

TEST_CASE("closed input without intersections is to be kept") {
  const ExpectedTopology expected = expected_topology(volume_of("torus", 3), TopologyMode::keep);
  CHECK(expected.euler_characteristic == 0);
  CHECK(expected.components == 1);
  CHECK(expected.source == "the input");
}

TEST_CASE("mere separation expects nothing") {
  const ExpectedTopology expected = expected_topology(volume_of("torus", 3), TopologyMode::separate);
  CHECK_FALSE(expected.euler_characteristic);
  CHECK_FALSE(expected.components);
}

TEST_CASE(
    "the topology of parts that overlap is that of the outer boundary of Ω, unless parity is asked for") {
  // Copies that cross: Ω touches more than two regions, and the input is no embedded surface.
  TriangleSoup soup = *make_gallery_model("sphere");
  const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
  for (std::size_t i = 0; i < points; ++i) soup.points.push_back(soup.points[i] + Vec3{0.9, 0, 0});
  for (std::size_t i = 0; i < triangles; ++i) {
    auto t = soup.triangles[i];
    for (auto& v : t) v += static_cast<std::uint32_t>(points);
    soup.triangles.push_back(t);
  }
  auto index = std::make_shared<const ClosestPointIndex>(soup);
  const double delta = 0.02 * index->bounds().longest_edge();
  for (const SidesMode mode : {SidesMode::automatic, SidesMode::parity}) {
    const InputTopology input = analyse_input(soup, mode);
    REQUIRE(input.closed_manifold);
    REQUIRE_FALSE(input.self_intersection_free);
    CHECK(input.sides_known() == (mode == SidesMode::automatic));
    const auto volume = ToleranceVolume::build(index, input, {delta, 0.95}, RunControl());
    REQUIRE(volume.ok());
    CHECK_FALSE(volume->thickening());
    const ExpectedTopology expected = expected_topology(*volume, TopologyMode::keep);
    CHECK(expected.source != "the input");
    CHECK(expected.required == (mode == SidesMode::automatic));
    CHECK(expected.joined == (mode == SidesMode::automatic));
    if (mode == SidesMode::parity) continue;
    CHECK(expected.source == "the outer boundary of Ω");
    CHECK(expected.euler_characteristic == 2);
    CHECK(expected.components == 1);
  }
}

TEST_CASE("parts that nearly touch are joined, at a wider gap they are kept apart") {
  for (const double gap : {0.01, 0.1}) {
    TriangleSoup soup = *make_gallery_model("sphere");
    const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
    const Box3 box = soup.bounds();
    const double delta = 0.02 * box.longest_edge();
    for (std::size_t i = 0; i < points; ++i)
      soup.points.push_back(soup.points[i] + Vec3{box.extent().x + gap * delta, 0, 0});
    for (std::size_t i = 0; i < triangles; ++i) {
      auto t = soup.triangles[i];
      for (auto& v : t) v += static_cast<std::uint32_t>(points);
      soup.triangles.push_back(t);
    }
    auto index = std::make_shared<const ClosestPointIndex>(soup);
    const auto volume = ToleranceVolume::build(index, analyse_input(soup), {delta, 0.95}, RunControl());
    REQUIRE(volume.ok());
    const ExpectedTopology expected = expected_topology(*volume, TopologyMode::keep);
    CHECK(expected.joined == (gap < 0.02));
    CHECK(expected.components == (gap < 0.02 ? std::size_t{1} : std::size_t{2}));
    CHECK(expected.euler_characteristic == (gap < 0.02 ? 2L : 4L));
  }
}
