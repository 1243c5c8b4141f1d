// The field between two surfaces: signs, separation, nesting, exact tests, and what is refused.
#include "input/gallery_shapes.h"
#include "shapes.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/exact_position.h"
#include "tolerance/separation.h"
#include "tolerance/surface_pair_field.h"
#include "tolerance/tolerance_volume.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

TriangleSoup scaled(TriangleSoup soup, double by, Vec3 to = {}) {
  for (Vec3& p : soup.points) p = by * p + to;
  return soup;
}

TriangleSoup cube(double half) {
  TriangleSoup soup;
  for (unsigned k = 0; k < 8; ++k)
    soup.points.push_back({k & 1u ? half : -half, k & 2u ? half : -half, k & 4u ? half : -half});
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return soup;
}

TriangleSoup both(TriangleSoup a, const TriangleSoup& b) {
  append(a, b);
  return a;
}

std::shared_ptr<const SurfacePairField> field_of(const TriangleSoup& outer, const TriangleSoup& inner) {
  auto pair = join_surfaces(outer, inner, RunControl());
  CAPTURE(pair.ok() ? std::string() : pair.error().line());
  REQUIRE(pair.ok());
  auto field = SurfacePairField::make(std::move(*pair), RunControl());
  REQUIRE(field.ok());
  return *field;
}

ToleranceVolume volume_of(std::shared_ptr<const SurfacePairField> field) {
  InputTopology topology;
  topology.side_rule = SideRule::given;
  auto volume = ToleranceVolume::build(field, topology, {field->delta()}, RunControl());
  CAPTURE(volume.ok() ? std::string() : volume.error().line());
  REQUIRE(volume.ok());
  return std::move(*volume);
}

void check_refused(const TriangleSoup& outer, const TriangleSoup& inner, std::string_view words) {
  const auto pair = join_surfaces(outer, inner, RunControl());
  REQUIRE_FALSE(pair.ok());
  const std::string line = pair.error().line();
  CAPTURE(line);
  CHECK(pair.error().code == ErrorCode::bad_input);
  CHECK(line.find(words) != std::string::npos);
  CHECK(pair.error().message.find("near (") != std::string::npos);
  CHECK_FALSE(pair.error().remedy.empty());
}

} // namespace

TEST_CASE("δ is half the least distance of the walls") {
  CHECK(field_of(cube(1), cube(0.75))->delta() == doctest::Approx(0.125).epsilon(1e-12));
  const TriangleSoup sphere = make_sphere(2);
  const auto a = std::make_shared<ClosestPointIndex>(sphere);
  const TriangleSoup other = scaled(make_torus(1, 0.3, 24, 12), 0.5, {1.9, 0.7, 0.3});
  const auto b = std::make_shared<ClosestPointIndex>(other);
  double least = Box3::inf;
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i)
    for (std::size_t j = 0; j < other.triangles.size(); ++j)
      least = std::min(least, disjoint_triangle_distance(sphere.triangle(i), other.triangle(j)));
  CHECK(find_separation(*a, *b, RunControl()).distance == least);
  CHECK(find_separation(*b, *a, RunControl()).distance == doctest::Approx(least).epsilon(1e-14));
}

TEST_CASE("signs are those of parity everywhere, at edges and vertices too") {
  // A spike and a dent, at which neither faces nor edges alone tell the side.
  TriangleSoup outer = scaled(make_sphere(1), 2);
  outer.points[0] = 3 * outer.points[0];
  outer.points[1] = 0.6 * outer.points[1];
  const TriangleSoup inner = scaled(make_sphere(1), 0.5);
  const auto field = field_of(outer, inner);
  const ClosestPointIndex o(outer), i(inner);
  Random random(11);
  const Box3 box = o.bounds().grown(0.5);
  std::size_t beyond = 0;
  for (int k = 0; k < 30000; ++k) {
    Vec3 p = random.in_box(box);
    if (k % 3 == 0) p = outer.points[random.below(2)] + random.between(0, 0.2) * random.direction();
    const bool in_volume = o.inside_by_parity(p) && !i.inside_by_parity(p);
    const double d = std::min(o.distance(p), i.distance(p));
    const double expected = in_volume ? std::max(0.0, field->delta() - d) : field->delta() + d;
    const ClosestPoint at = field->closest(p);
    REQUIRE(at.distance() == doctest::Approx(expected).epsilon(1e-12).scale(1));
    REQUIRE(field->holds_exactly(p) == std::optional(in_volume));
    if (!in_volume) ++beyond;
    if (at.distance() > 0.9 * field->delta())
      CHECK(field->side(p) == (o.distance(p) < i.distance(p) ? +1 : -1));
    const auto range = field->range_in_cube(p, 0.1);
    REQUIRE(range.has_value());
    const double near = field->distance(random.in_box(Box3{p, p}.grown(0.1)));
    REQUIRE(near >= range->least - 1e-9);
    REQUIRE(near <= range->most + 1e-9);
    TriangleNeighborhood list;
    field->find_neighborhood(p, at.distance() + 0.2, list);
    const Vec3 q = p + random.between(0, 0.2) * random.direction();
    REQUIRE(field->closest_near(q, at.triangle, list).squared_distance == field->closest(q).squared_distance);
  }
  CHECK(beyond > 5000);
}

TEST_CASE("shells, cavities and parts of a volume") {
  const TriangleSoup sphere = make_sphere(1);
  CHECK(volume_of(field_of(scaled(sphere, 1), scaled(sphere, 0.7))).thickening());
  // A thick shell with a cavity, and in it a thinner one: two layers.
  const auto layers =
      field_of(both(scaled(sphere, 2), scaled(sphere, 0.5)), both(scaled(sphere, 1.6), scaled(sphere, 0.9)));
  CHECK(layers->components(0, RunControl()).count == 2);
  const ToleranceVolume volume = volume_of(layers);
  CHECK(volume.regions().size() == 3);
  CHECK(volume.boundary_components().size() == 4);
  std::size_t inside = 0;
  for (const Region& r : volume.regions()) inside += r.label < 0 ? 1 : 0;
  CHECK(inside == 1);
  // Two balls in one, and one beside it in one of its own.
  const auto several =
      field_of(both(scaled(sphere, 2), scaled(sphere, 1, {4, 0, 0})),
               both(both(scaled(sphere, 0.5, {0.9, 0, 0}), scaled(sphere, 0.5, {-0.9, 0, 0})),
                    scaled(sphere, 0.6, {4, 0, 0})));
  CHECK(several->components(0, RunControl()).count == 2);
  CHECK(volume_of(several).regions().size() == 4);
  // However they are turned.
  TriangleSoup turned = scaled(sphere, 1);
  turn_inside_out(turned);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  CHECK(field_of(turned, scaled(sphere, 0.7))->distance({0, 0, 0}) ==
        doctest::Approx(0.15 + 0.7).epsilon(0.1));
}

TEST_CASE("where there is no surface of the input, planes are sampled like all else") {
  const auto field = field_of(cube(1), cube(0.75));
  ToleranceVolume alike = volume_of(field), flat = volume_of(field);
  const double sigma = 0.5 * field->delta();
  const auto of_sigma = sample_boundary(alike, sigma, RunControl());
  const auto sparse_in_planes = sample_boundary(flat, {sigma, 4 * sigma}, RunControl());
  REQUIRE(of_sigma.ok());
  REQUIRE(sparse_in_planes.ok());
  CHECK(of_sigma->size() > 100);
  CHECK(sparse_in_planes->positions == of_sigma->positions);
}

TEST_CASE("exact tests: touching is meeting") {
  const Triangle3 wall{Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(triangles_meet({Vec3{0.25, 0.25, 0}, {0, 0, 1}, {1, 0, 1}}, wall));
  CHECK(triangles_meet({Vec3{0.25, 0.25, -1e-300}, {0, 0, 1}, {1, 0, 1}}, wall));
  CHECK_FALSE(triangles_meet({Vec3{0.25, 0.25, 1e-300}, {0, 0, 1}, {1, 0, 1}}, wall));
  CHECK(triangles_meet({Vec3{0.25, 0.25, 1}, {0.25, 0.25, -1}, {0.25, 0.25, 0.5}}, wall)); // without an area
  CHECK_FALSE(triangles_meet({Vec3{0.25, 0.25, 1}, {0.25, 0.25, 2}, {0.25, 0.25, 0.5}}, wall));
  const ClosestPointIndex index(cube(1));
  CHECK(crossed_on_the_way_out({0, 0, 0}, index)->size() == 1);
  CHECK(crossed_on_the_way_out({0.999999, 0.3, -0.999999}, index)->size() == 1);
  CHECK(crossed_on_the_way_out({3, 0, 0}, index)->size() % 2 == 0);
  CHECK_FALSE(crossed_on_the_way_out({1, 0.25, 0.5}, index).has_value()); // on a face
  const auto field = field_of(cube(1), cube(0.5));
  const Triangle3 between{Vec3{-0.9, -0.9, 0.75}, {0.9, -0.9, 0.75}, {0, 0.9, 0.75}};
  CHECK(field->meets_boundary(between) == std::optional(false));
  CHECK(field->meets_boundary({between[0], between[1], Vec3{0, 1, 0.75}}) == std::optional(true));
}

TEST_CASE("what is no volume is refused with the place") {
  const TriangleSoup sphere = make_sphere(2);
  TriangleSoup open = sphere;
  open.triangles.pop_back();
  check_refused(open, scaled(sphere, 0.5), "outer surface is open");
  check_refused(scaled(sphere, 2), open, "inner surface is open");
  check_refused(sphere, scaled(sphere, 1, {0.5, 0, 0}), "touch or cross");
  check_refused(cube(1), scaled(cube(0.5), 1, {0.5, 0, 0}), "touch or cross"); // faces in one plane
  check_refused(sphere, sphere, "touch or cross");
  check_refused(sphere, scaled(sphere, 0.5, {3, 0, 0}), "not inside the outer one");
  check_refused(scaled(sphere, 0.5), sphere, "larger surface is the outer one");
  check_refused(both(sphere, scaled(sphere, 0.9, {0.3, 0, 0})), scaled(sphere, 0.2),
                "outer surface meets itself");
  check_refused(both(sphere, scaled(sphere, 1, {4, 0, 0})), scaled(sphere, 0.5), "nothing of the inner one");
  check_refused(sphere, both(scaled(sphere, 0.8), scaled(sphere, 0.5)), "nothing of the outer one");
  TriangleSoup flat = sphere;
  flat.triangles.push_back({0, 1, 1});
  check_refused(flat, scaled(sphere, 0.5), "without an area");
}
