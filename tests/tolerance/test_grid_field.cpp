// The field of a grid against closed formulas and against dense looks.
#include "shapes.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/grid_field.h"
#include "tolerance/tolerance_volume.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

template <class Function>
std::shared_ptr<const ScalarGrid> sampled(std::size_t n, double half, Function&& f) {
  auto grid = std::make_shared<ScalarGrid>();
  grid->size = {n, n, n};
  grid->spacing = Vec3{1, 1, 1} * (2 * half / static_cast<double>(n - 1));
  grid->origin = {-half, -half, -half};
  for (std::size_t z = 0; z < n; ++z)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x) grid->values.push_back(static_cast<float>(f(grid->point(x, y, z))));
  return grid;
}

std::shared_ptr<const GridField> field_of(std::shared_ptr<const ScalarGrid> grid, double low, double high) {
  auto field = GridField::make(std::move(grid), low, high, RunControl());
  CAPTURE(field.ok() ? std::string() : field.error().line());
  REQUIRE(field.ok());
  return *field;
}

std::shared_ptr<const GridField> balls() {
  return field_of(sampled(32, 1.5, [](Vec3 p) { return length(p); }), 0.8, 1.0);
}

} // namespace

TEST_CASE("the field of nested spheres is the distance to the middle one, nearly") {
  const auto field = balls();
  CHECK(field->delta() < 0.1);
  CHECK(field->delta() > 0.05); // L is 1 in a smooth field, and at most √3 in any
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.between(0.82, 0.98) * random.direction();
    CHECK(field->distance(p) ==
          doctest::Approx(std::abs(length(p) - 0.9) / field->slope() + field->delta() - 0.1 / field->slope())
              .epsilon(0.05)
              .scale(field->delta()));
    CHECK(field->side(1.2 * normalized(p)) == +1);
    CHECK(field->side(0.6 * normalized(p)) == -1);
  }
  CHECK(field->area() == doctest::Approx(4 * std::numbers::pi * 0.81).epsilon(0.05));
}

TEST_CASE("the field of any grid is 1-Lipschitz, its ranges hold and its gradient is one") {
  Random values(7);
  auto grid = std::make_shared<ScalarGrid>();
  grid->size = {9, 8, 7};
  grid->spacing = {1, 0.5, 2};
  for (std::size_t i = 0; i < 9 * 8 * 7; ++i) {
    const std::size_t x = i % 9, y = i / 9 % 8, z = i / 72;
    const bool border = x == 0 || x == 8 || y == 0 || y == 7 || z == 0 || z == 6;
    grid->values.push_back(border ? 2.0F : static_cast<float>(values.between(-1, 2)));
  }
  const auto field = field_of(grid, 0, 1);
  Random random(3);
  const Box3 box = grid->box().grown(1);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = random.in_box(box), q = p + random.between(0, 1) * random.direction();
    const ClosestPoint at = field->closest(p);
    REQUIRE(std::abs(at.distance() - field->distance(q)) <= distance(p, q) * (1 + 1e-9));
    REQUIRE(at.triangle.index() < field->size());
    const double half = random.between(0, 0.8);
    const auto range = field->range_in_cube(p, half);
    REQUIRE(range.has_value());
    const Vec3 in_cube = random.in_box(Box3{p, p}.grown(half));
    REQUIRE(field->distance(in_cube) >= range->least - 1e-9);
    REQUIRE(field->distance(in_cube) <= range->most + 1e-9);
    const Vec3 slope = field->gradient(p, at), step = 1e-6 * random.direction();
    REQUIRE(length(slope) <= 1 + 1e-9);
    const double rise = field->distance(p + step) - field->distance(p - step);
    if (std::abs(rise - 2 * dot(slope, step)) > 1e-9) { // at a bend, which has little room
      CHECK(std::abs(field->distance(p + step) + field->distance(p - step) - 2 * at.distance()) > 1e-10);
    }
  }
}

TEST_CASE("facets meet the boundary where a dense look says so") {
  const auto field = balls();
  const TrilinearFunction g(field->grid());
  Random random(5);
  int inside = 0, crossing = 0, open = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random.between(0.78, 1.02) * random.direction();
    const double size = i % 3 == 0 ? 0.4 : 0.1;
    const Triangle3 facet{p, p + size * random.direction(), p + size * random.direction()};
    bool below = false, within = false, above = false;
    for (int u = 0; u <= 40; ++u)
      for (int v = 0; u + v <= 40; ++v) {
        const double value =
            g.value(facet[0] + (u / 40.0) * (facet[1] - facet[0]) + (v / 40.0) * (facet[2] - facet[0]));
        (value < 0.8 ? below : value > 1 ? above : within) = true;
      }
    const auto told = field->meets_boundary(facet);
    if (!told) {
      ++open;
      CHECK((below || above));
    } else if (*told) {
      ++crossing;
      CHECK((below || above));
    } else {
      ++inside;
      CHECK_FALSE((below || above));
    }
  }
  CHECK(inside > 200);
  CHECK(crossing > 200);
  // A facet along the wall, nearer to it than a bound by the slope alone could see.
  const Triangle3 near{Vec3{0.05, 0.05, 0.985}, {-0.05, 0.05, 0.985}, {0, -0.05, 0.985}};
  CHECK(field->meets_boundary(near) == std::optional(false));
  CHECK(certify_facet(*field, near, field->delta(), field->delta()).kind == FacetVerdict::Kind::inside);
}

TEST_CASE("parts of a grid's volume are told apart, and thin regions are known") {
  // Two balls of radius 0.5 around ±0.8.
  const auto two =
      field_of(sampled(40, 1.6,
                       [](Vec3 p) {
                         return std::min(length(p - Vec3{0.8, 0, 0}), length(p + Vec3{0.8, 0, 0}));
                       }),
               0.4, 0.6);
  CHECK(two->components(0.95 * two->delta(), RunControl()).count == 2);
  CHECK(two->region_seeds().size() == 3);
  InputTopology topology;
  topology.side_rule = SideRule::given;
  auto volume = ToleranceVolume::build(two, topology, {two->delta()}, RunControl());
  CAPTURE(volume.ok() ? std::string() : volume.error().line());
  REQUIRE(volume.ok());
  CHECK(volume->regions().size() == 3);
  REQUIRE(volume->boundary_components().size() == 4);
  for (const BoundaryComponent& c : volume->boundary_components()) CHECK(c.euler_characteristic == 2);
  CHECK(volume->thickening());
}

TEST_CASE("grids that hold no volume are refused with the place") {
  const auto refused = [](std::shared_ptr<const ScalarGrid> grid, double low, double high, ErrorCode code,
                          std::string_view words) {
    const auto field = GridField::make(std::move(grid), low, high, RunControl());
    REQUIRE_FALSE(field.ok());
    const std::string line = field.error().line();
    CAPTURE(line);
    CHECK(field.error().code == code);
    CHECK(line.find(words) != std::string::npos);
  };
  const auto ball = sampled(20, 1.5, [](Vec3 p) { return length(p); });
  refused(ball, 1, 1, ErrorCode::usage, "nothing between");
  refused(ball, 0.01, 1, ErrorCode::bad_input, "below the level 0.01");
  refused(ball, 1, 3, ErrorCode::bad_input, "above the level 3");
  refused(ball, 1, 1.6, ErrorCode::bad_input, "border of the grid, near (");
  refused(sampled(20, 1.5, [](Vec3 p) { return p.x; }), -0.5, 0.5, ErrorCode::bad_input, "border");
}
