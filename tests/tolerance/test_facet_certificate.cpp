// Facets known to be inside and outside, small planted violations, and the proven bound.
#include "tolerance/closest_point.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/sampled_distance.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::Random;
using isoscope::testing::sampled_maximum;
using Kind = FacetVerdict::Kind;

namespace {

TriangleSoup big_square() {
  TriangleSoup soup;
  soup.points = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  return soup;
}

} // namespace

TEST_CASE("a facet is accepted up to the tolerance and rejected just above it") {
  const ClosestPointIndex index(big_square());
  const auto facet = [](double z) { return Triangle3{Vec3{-3, -2, z}, Vec3{4, -1, z}, Vec3{1, 3, z}}; };
  CHECK(certify_facet(index, facet(0.5), 1, 0.98).kind == Kind::inside);
  CHECK(certify_facet(index, facet(1 - 1e-9), 1, 0.98).kind != Kind::undecided);
  const FacetVerdict inside = certify_facet(index, facet(0.97), 1, 0.98);
  CHECK(inside.kind == Kind::inside);
  CHECK(inside.max_distance >= 0.97);
  CHECK(inside.max_distance <= 1);
  const FacetVerdict outside = certify_facet(index, facet(1 + 1e-6), 1, 0.98);
  REQUIRE(outside.kind == Kind::outside);
  CHECK(index.distance(outside.witness) > 0.98);
  CHECK(outside.closest.distance() == doctest::Approx(index.distance(outside.witness)));
}

TEST_CASE("a violation of one part in a million is never accepted") {
  const ClosestPointIndex index(big_square());
  for (const double lift : {1e-6, 1e-7, 1e-9}) {
    const Triangle3 corner_out{Vec3{-3, -2, 0}, Vec3{4, -1, 0}, Vec3{1, 3, 1 + lift}};
    CHECK(certify_facet(index, corner_out, 1, 1).kind != Kind::inside);
    CHECK(certify_facet(index, corner_out, 1, 0.975).kind == Kind::outside);
  }
}

TEST_CASE("the bound of an accepted facet is at least every sampled distance, and random facets are decided "
          "rightly") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 24);
  testing::add_torus(soup, {3, 0, 0}, 1, 0.4, 20);
  const ClosestPointIndex index(soup);
  Random random(5);
  const double accept = 0.1, reject = 0.0975;
  std::size_t inside = 0, outside = 0;
  for (int i = 0; i < 1500; ++i) {
    const Triangle3 base = soup.triangle(random.below(soup.triangles.size()));
    const Vec3 center = (base[0] + base[1] + base[2]) / 3.0;
    const double size = random.between(0.05, 0.4);
    const Triangle3 facet{center + size * random.direction(), center + size * random.direction(),
                          center + size * random.direction()};
    const FacetVerdict verdict = certify_facet(index, facet, accept, reject);
    REQUIRE(verdict.kind != Kind::undecided);
    const double largest = sampled_maximum(index, facet, 40);
    if (verdict.kind == Kind::inside) {
      ++inside;
      CHECK(largest <= verdict.max_distance);
      CHECK(verdict.max_distance <= accept);
    } else {
      ++outside;
      CHECK(index.distance(verdict.witness) > reject);
    }
  }
  CHECK(inside > 100);
  CHECK(outside > 100);
}

TEST_CASE("degenerate facets and exhausted budgets are handled") {
  const ClosestPointIndex index(big_square());
  const Triangle3 point{Vec3{1, 1, 0.5}, Vec3{1, 1, 0.5}, Vec3{1, 1, 0.5}};
  CHECK(certify_facet(index, point, 1, 0.98).kind == Kind::inside);
  CHECK(certify_facet(index, point, 0.4, 0.39).kind == Kind::outside);
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 24);
  const Triangle3 wide{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const FacetVerdict verdict = certify_facet(ClosestPointIndex(soup), wide, 0.43, 0.43, 3);
  CHECK(verdict.kind == Kind::undecided);
  CHECK(verdict.pieces == 4);
}

TEST_CASE("Nothing is inside of a volume around no triangles") {
  const ClosestPointIndex index(TriangleSoup{});
  const FacetVerdict verdict = certify_facet(index, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 1e9, 1e9);
  CHECK(verdict.kind == Kind::outside);
}
