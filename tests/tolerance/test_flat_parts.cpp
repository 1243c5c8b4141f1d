// Flat parts of plates: what they hold, how near their points are to the surface, and facets proven with
// them.
#include "tolerance/facet_certificate.h"
#include "tolerance/flat_parts.h"
#include "tolerance/sampled_distance.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <set>

using namespace isoscope;
using isoscope::testing::Random;
using isoscope::testing::sampled_maximum;
using Kind = FacetVerdict::Kind;

namespace {

/// Squares of side 1 in the plane, each of two triangles, where `has` says so.
template <class Has> TriangleSoup plate(std::uint32_t n, double tilt, const Has& has) {
  TriangleSoup soup;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      soup.points.push_back({std::cos(tilt) * i, double(j), std::sin(tilt) * i});
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      if (!has(i, j)) continue;
      soup.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      soup.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return soup;
}

TriangleSoup ring() {
  return plate(9, 0.3, [](std::uint32_t i, std::uint32_t j) {
    return !(i >= 3 && i < 6 && j >= 2 && j < 7) && !(i == 8 && j == 0);
  });
}

} // namespace

TEST_CASE("a square plate is one part, and points lie above it, beside it or off its corner") {
  const ClosestPointIndex index(plate(10, 0, [](auto, auto) { return true; }));
  const FlatParts parts(index, RunControl());
  REQUIRE(parts.size() == 1);
  for (std::uint32_t t = 0; t < index.size(); ++t) CHECK(parts.part_of(TriangleId(t)) == 0);
  const auto away = [&](Vec3 p) { return parts.away_from(0, p).value_or(Vec3{9, 9, 9}); };
  CHECK(distance(away({5.3, 4.1, 2}), {0, 0, 2}) < 1e-9);
  CHECK(distance(away({12, 4.1, -1}), {2, 0, -1}) < 1e-9);
  CHECK(distance(away({-3, 14, 0}), {-3, 4, 0}) < 1e-9);
}

TEST_CASE("parts keep out of holes and notches, and few cover a plate") {
  const ClosestPointIndex index(ring());
  const FlatParts parts(index, RunControl());
  std::set<std::uint32_t> used;
  for (std::uint32_t t = 0; t < index.size(); ++t) used.insert(parts.part_of(TriangleId(t)));
  CHECK_FALSE(used.contains(FlatParts::none));
  CHECK(used.size() <= 8);
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = random.in_box(index.bounds().grown(2));
    const auto part = static_cast<std::uint32_t>(random.below(parts.size()));
    const std::optional<Vec3> away = parts.away_from(part, p);
    REQUIRE(away);
    CHECK(index.distance(p - *away) <= parts.roughness());
    CHECK(length(*away) >= index.distance(p) - parts.roughness());
  }
}

TEST_CASE("a ball has no parts but those of two triangles, a soup of none has none") {
  TriangleSoup soup;
  testing::add_sphere(soup, {0, 0, 0}, 1, 12);
  const ClosestPointIndex index(soup);
  const FlatParts parts(index, RunControl());
  std::vector<std::size_t> held(parts.size(), 0);
  for (std::uint32_t t = 0; t < index.size(); ++t)
    if (const std::uint32_t part = parts.part_of(TriangleId(t)); part != FlatParts::none) ++held[part];
  for (const std::size_t n : held) CHECK(n == 2);
  CHECK(FlatParts(ClosestPointIndex(TriangleSoup{}), RunControl()).size() == 0);
}

TEST_CASE("facets are proven with parts in fewer pieces, and none that is outside") {
  const ClosestPointIndex index(ring());
  const FlatParts parts(index, RunControl());
  Random random(7);
  std::size_t inside = 0, outside = 0, pieces = 0, pieces_without = 0;
  for (int i = 0; i < 600; ++i) {
    Triangle3 facet;
    for (Vec3& p : facet) p = random.in_box(index.bounds().grown(0.3));
    const Triangle3 near = index.triangle(TriangleId(random.below(index.size())));
    for (Vec3& p : facet) p = 0.6 * near[0] + 0.4 * p;
    const double accept = 0.8, reject = 0.79;
    FacetSearch search;
    std::vector<Vec3> witnesses;
    search.witnesses = &witnesses;
    const FacetVerdict without = certify_facet(index, facet, accept, reject, search);
    search.parts = &parts;
    const FacetVerdict with = certify_facet(index, facet, accept, reject, search);
    REQUIRE(with.kind != Kind::undecided);
    if (with.kind == Kind::inside) {
      ++inside;
      pieces += with.pieces;
      pieces_without += without.pieces;
      CHECK(sampled_maximum(index, facet, 24) <= with.max_distance);
      CHECK(with.max_distance <= accept);
    } else {
      ++outside;
      CHECK(index.distance(with.witness) > reject);
      REQUIRE_FALSE(witnesses.empty());
      for (const Vec3 w : witnesses) CHECK(index.distance(w) > reject);
    }
  }
  CHECK(inside > 100);
  CHECK(outside > 100);
  CHECK(2 * pieces < pieces_without);
}

TEST_CASE("a facet over two slits is not proven by the narrower one where parts cannot tell") {
  // Three rectangles in a plane. Half of the narrow slit is more than parts may prove and within the limit;
  // where the slits meet it is farther.
  const auto plates = [](double narrow, double wide) {
    TriangleSoup soup;
    const auto add = [&](double x0, double x1, double y0, double y1) {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      for (const double y : {y0, y1})
        for (const double x : {x0, x1}) soup.points.push_back({x, y, 0});
      soup.triangles.push_back({first, first + 1, first + 3});
      soup.triangles.push_back({first, first + 3, first + 2});
    };
    add(-1, 0, 0, 1);
    add(narrow, 1, 0, 1);
    add(-1, 1, 1 + wide, 2);
    return soup;
  };
  const double roughness = FlatParts(ClosestPointIndex(plates(0.001, 0.001)), RunControl()).roughness();
  const double accept = 5 * roughness, narrow = 2 * accept - roughness, wide = 2 * accept + roughness;
  const ClosestPointIndex index(plates(narrow, wide));
  const FlatParts parts(index, RunControl());
  REQUIRE(parts.size() == 3);
  const double beside = 0.02 * narrow;
  const Triangle3 corners{Vec3{-beside, 1 - beside, 0}, Vec3{narrow + beside, 1 - beside, 0},
                          Vec3{narrow / 2, 1 + wide + beside, 0}};
  REQUIRE(index.distance({narrow / 2, 1 + wide / 2, 0}) > accept);
  for (const bool turned : {false, true})
    for (std::size_t first = 0; first < 3; ++first) {
      Triangle3 facet{corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
      if (turned) std::swap(facet[1], facet[2]);
      FacetSearch search;
      std::vector<Vec3> witnesses;
      search.witnesses = &witnesses;
      search.parts = &parts;
      CHECK(certify_facet(index, facet, accept, accept, search).kind != Kind::inside);
      CHECK(certify_facet(index, facet, 3 * accept, 3 * accept, search).kind == Kind::inside);
    }
}
