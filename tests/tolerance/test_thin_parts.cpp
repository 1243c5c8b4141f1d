// Parts thinner than 2δ': found, measured, with a tolerance that keeps them, and left out.
#include "tolerance/region_labels.h"
#include "tolerance/shapes.h"
#include "tolerance/thin_parts.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

ToleranceVolume build(const TriangleSoup& soup, double delta, double ratio = 0.95) {
  auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(soup), analyse_input(soup),
                                       {delta, ratio}, RunControl());
  REQUIRE(volume.ok());
  return std::move(*volume);
}

KeepingTolerance keeping(const ToleranceVolume& volume, const std::vector<ThinPart>& parts) {
  const auto found = find_keeping_tolerance(volume, parts, RunControl());
  REQUIRE(found.ok());
  return *found;
}

/// A box whose walls have the thickness t.
TriangleSoup hollow_box(double t) {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  const std::size_t outer = soup.triangles.size();
  testing::add_box(soup, {t, t, t}, {1 - t, 1 - t, 1 - t});
  for (std::size_t i = outer; i < soup.triangles.size(); ++i)
    std::swap(soup.triangles[i][1], soup.triangles[i][2]);
  return soup;
}

} // namespace

TEST_CASE("a plate, a needle and a sphere below 2δ are thin parts of the right thickness") {
  struct Case {
    TriangleSoup soup;
    double thickness;
  };
  std::vector<Case> cases(3);
  testing::add_box(cases[0].soup, {0, 0, 0}, {1, 1, 0.1});
  cases[0].thickness = 0.1;
  testing::add_box(cases[1].soup, {0, 0, 0}, {1, 0.1, 0.1});
  cases[1].thickness = 0.1;
  testing::add_sphere(cases[2].soup, {0, 0, 0}, 0.05, 24);
  cases[2].thickness = 0.1;
  for (const Case& c : cases) {
    const ToleranceVolume volume = build(c.soup, 0.06);
    const std::vector<ThinPart> parts = find_thin_parts(volume);
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].lost == -1);
    CHECK(parts[0].triangles == c.soup.triangles.size());
    CHECK(parts[0].thickness > 0.97 * c.thickness);
    CHECK(parts[0].thickness < 1.001 * c.thickness);
    CHECK(volume.index().inside_by_parity(parts[0].place));
    const KeepingTolerance found = keeping(volume, parts);
    CHECK(found.fits);
    CHECK(found.value <= 0.045);
    CHECK(found.value >= 0.043);
    CHECK(find_thin_parts(build(c.soup, found.value)).empty());
  }
}

TEST_CASE("an inside that only a climb from between the walls finds is found") {
  TriangleSoup needle;
  testing::add_box(needle, {0, 0, 0}, {0.2, 0.02, 0.02});
  for (const double delta : {0.0101, 0.0095, 0.008}) {
    const ToleranceVolume volume = build(needle, delta);
    CHECK(find_thin_parts(volume).empty());
    CHECK(volume.regions().size() > 1);
    CHECK(volume.regions()[1].label == -1);
  }
}

TEST_CASE("a hollow box with thin walls has nothing inside although Ω has two boundaries") {
  const ToleranceVolume volume = build(hollow_box(0.2), 0.12);
  CHECK(volume.boundary_components().size() == 2);
  const std::vector<ThinPart> parts = find_thin_parts(volume);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].thickness == doctest::Approx(0.2).epsilon(0.01));
  CHECK(parts[0].triangles == 24);
  const KeepingTolerance found = keeping(volume, parts);
  CHECK(found.value >= 0.089);
  CHECK(found.value <= 0.09);
  for (const double delta : {found.value, 0.08, 0.07})
    CHECK(find_thin_parts(build(hollow_box(0.2), delta)).empty());
}

TEST_CASE("thick parts beside a thin one are none, and the thin one can be left out") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  testing::add_box(soup, {2, 0, 0}, {3, 1, 0.1});
  testing::add_sphere(soup, {0.5, 0.5, 3}, 0.5, 16);
  const ToleranceVolume volume = build(soup, 0.06);
  const std::vector<ThinPart> parts = find_thin_parts(volume);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].triangles == 12);
  CHECK(parts[0].box.lo == Vec3{2, 0, 0});
  CHECK(parts[0].box.hi == Vec3{3, 1, 0.1});
  const TriangleSoup rest = without_parts(soup, volume, parts);
  CHECK(rest.triangles.size() == soup.triangles.size() - 12);
  CHECK(find_thin_parts(build(rest, 0.06)).empty());
  CHECK(left_out_words(parts).find("1 part of the input") == 0);
  const Error error = thin_parts_error(volume, parts, keeping(volume, parts));
  CHECK(error.code == ErrorCode::unsupported);
  CHECK(error.message.find("thinner than twice the tolerance") != std::string::npos);
  CHECK(error.message.find("0.1 (1.67 δ)") != std::string::npos);
  CHECK(error.remedy.find("at most 0.045 (1.2%") != std::string::npos);
  CHECK(error.remedy.find("--drop-thin") != std::string::npos);
}

TEST_CASE("a gap inside of a body that Ω closes is a thin part too") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  testing::add_box(soup, {0.3, 0.3, 0.5}, {0.7, 0.7, 0.53});
  const ToleranceVolume volume = build(soup, 0.03);
  const std::vector<ThinPart> parts = find_thin_parts(volume);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].lost == +1);
  CHECK(parts[0].thickness == doctest::Approx(0.03).epsilon(0.01));
  CHECK(thin_parts_error(volume, parts, {0.013, true}).message.find("A gap inside") == 0);
}

TEST_CASE("what keeps parts that come apart at a smaller tolerance keeps each of them") {
  // At 0.06 the first two are one part; at what keeps the third they come apart, and the second has nothing.
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 0.3});
  testing::add_box(soup, {0, 0, 0.4}, {1, 1, 0.46});
  testing::add_box(soup, {2, 0, 0}, {3, 1, 0.1});
  const ToleranceVolume volume = build(soup, 0.06);
  const std::vector<ThinPart> parts = find_thin_parts(volume);
  REQUIRE(parts.size() == 1);
  const KeepingTolerance found = keeping(volume, parts);
  CHECK(found.value <= 0.027);
  CHECK(found.value >= 0.026);
}

TEST_CASE("parts that intersect each other have thin parts too, and so have those with gaps") {
  TriangleSoup crossing;
  testing::add_box(crossing, {0, 0, 0}, {1, 1, 0.1});
  testing::add_box(crossing, {0.5, 0.5, 0.02}, {1.5, 1.5, 0.12});
  CHECK(find_thin_parts(build(crossing, 0.08)).size() == 1);
  TriangleSoup gaps;
  testing::add_box(gaps, {0, 0, 0}, {1, 1, 1});
  TriangleSoup plate;
  testing::add_box(plate, {2, 0, 0}, {3, 1, 0.02});
  for (const auto& t : testing::exploded(plate, 0.98).triangles) {
    const TriangleSoup apart = testing::exploded(plate, 0.98);
    const auto base = static_cast<std::uint32_t>(gaps.points.size());
    for (const auto v : t) gaps.points.push_back(apart.points[v]);
    gaps.triangles.push_back({base, base + 1, base + 2});
  }
  REQUIRE_FALSE(analyse_input(gaps).closed_manifold);
  const auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(gaps),
                                             analyse_input(gaps), {0.05, 0.95}, RunControl());
  REQUIRE(volume.ok());
  CHECK(volume->sides().by_solid_angles());
  CHECK(find_thin_parts(*volume).size() == 1);
}

TEST_CASE("walls without a distance are kept by no tolerance") {
  TriangleSoup pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  const ToleranceVolume volume = build(pillow, 0.02);
  const std::vector<ThinPart> parts = find_thin_parts(volume);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].thickness < 1e-6);
  const Error error = thin_parts_error(volume, parts, keeping(volume, parts));
  CHECK(error.remedy == "No tolerance keeps what has no thickness.");
}

TEST_CASE("a part so thin that no memory holds the volume that keeps it is said to be") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {1, 1, 1});
  testing::add_box(soup, {2, 0, 0}, {3, 1, 1e-4});
  const ToleranceVolume volume = build(soup, 0.05);
  const std::vector<ThinPart> parts = find_thin_parts(volume);
  REQUIRE(parts.size() == 1);
  const KeepingTolerance found = keeping(volume, parts);
  CHECK(!found.fits);
  const std::string remedy = thin_parts_error(volume, parts, found).remedy;
  CHECK(remedy.find("needs more memory than there is") != std::string::npos);
  CHECK(remedy.find("leave it out with --drop-thin") != std::string::npos);
}
