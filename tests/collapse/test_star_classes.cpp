// The boxes of a star's samples against each sample by itself.
#include "collapse/star_classes.h"

#include "collapse/star_location.h"
#include "criteria/kernel.h"
#include "criteria/stars.h"
#include "mesh/sample_sets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// The first sample that goes wrong, by the definition.
TargetVerdict one_by_one(const EdgeStar& star, Vec3 target, const CriteriaParameters& criteria) {
  const bool embedded = star.form == ZeroForm::embedded;
  const double limit = embedded ? 1.0 : criteria.error_limit();
  for (const EdgeStar::StarSample& s : star.samples) {
    const StarLocation after = locate_after(star, target, s.position);
    if (after.tet == nullptr) continue;
    const double error = sample_error_at(star, after, s.position, s.label);
    if (embedded ? !is_bad(error) : error <= limit) continue;
    const StarLocation before = locate_before(star, s.position);
    double margin = criteria.alpha;
    if (before.tet != nullptr) {
      const double error_before = sample_error_at(star, before, s.position, s.label);
      if (error <= error_before) continue;
      margin = std::min(margin, 1 - error_before);
    }
    TargetVerdict verdict = Refusal{Reason::misclassified, error, limit, s.position};
    verdict.invalid = invalid_region(star, *after.tet, s, star.vertices[0].value, margin);
    return verdict;
  }
  return {};
}

void check_same(const EdgeStar& star, Vec3 target, const CriteriaParameters& criteria, std::size_t& refused) {
  const TargetVerdict expected = one_by_one(star, target, criteria);
  const TargetVerdict found = StarClasses(star).check(target, criteria);
  REQUIRE(found.reason == expected.reason);
  REQUIRE(found.value == expected.value);
  REQUIRE(found.limit == expected.limit);
  REQUIRE(found.witness == expected.witness);
  REQUIRE(found.invalid.has_value() == expected.invalid.has_value());
  if (!found.invalid) return;
  ++refused;
  REQUIRE(found.invalid->tet == expected.invalid->tet);
  REQUIRE(found.invalid->sample == expected.invalid->sample);
  REQUIRE(found.invalid->half_spaces.size() == expected.invalid->half_spaces.size());
}

/// Samples along a random way, some of them on vertices and in the middles of edges, which several tetrahedra
/// share.
void scatter(EdgeStar& star, std::size_t n, std::mt19937_64& random, const std::vector<std::int8_t>& labels) {
  std::uniform_real_distribution<double> u(0, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const EdgeStar::StarTet& t = star.tets[i * star.tets.size() / n];
    const std::array<Vec3, 4> p = star.positions(t);
    std::array<double, 4> w{};
    double sum = 0;
    for (double& x : w) sum += x = u(random);
    Vec3 x = (w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3] * p[3]) / sum;
    if (i % 17 == 0) x = 0.5 * (p[i % 4] + p[(i + 1) % 4]);
    if (i % 41 == 0) x = p[i % 4];
    const StarLocation at = locate_before(star, x);
    std::int8_t label = labels[random() % labels.size()];
    // Most are right before the collapse.
    for (const std::int8_t l : labels)
      if (at.tet != nullptr && i % 29 != 0 && side_at(star, at, x, l) > 0) label = l;
    star.samples.push_back({SampleId(3 * i), x, label});
  }
}

std::size_t compare(EdgeStar star, std::mt19937_64& random, const std::vector<std::int8_t>& labels,
                    std::size_t samples) {
  scatter(star, samples, random, labels);
  const Kernel kernel = compute_kernel(star);
  std::size_t refused = 0;
  if (kernel.empty) return refused;
  std::uniform_real_distribution<double> u(-1, 1);
  for (const double alpha : {0.01, 0.2, 0.6}) {
    CriteriaParameters criteria;
    criteria.alpha = alpha;
    for (int k = 0; k < 6; ++k) {
      const Vec3 target =
          kernel.center + 1.5 * kernel.inscribed_radius * Vec3{u(random), u(random), u(random)};
      if (kernel.contains(target)) check_same(star, target, criteria, refused);
    }
  }
  return refused;
}

} // namespace

TEST_CASE("boxes of samples name the sample that goes wrong first, as one by one") {
  std::mt19937_64 random(5);
  std::size_t refused = 0;
  for (EdgeStar star : random_stars(120, 7, 3)) {
    for (std::size_t i = 2; i < star.vertices.size(); ++i)
      if (random() % 3 == 0) star.vertices[i].value = -1;
    for (const std::size_t n : {0u, 1u, 8u, 9u, 700u}) refused += compare(star, random, {+1, -1}, n);
  }
  CHECK(refused > 200);
}

TEST_CASE("the same between rooms") {
  std::mt19937_64 random(6);
  std::size_t refused = 0;
  for (EdgeStar star : random_stars(120, 11, 4)) {
    for (std::size_t i = 2; i < star.vertices.size(); ++i) {
      const auto kind = random() % 4;
      if (kind < 2) star.vertices[i].value = -1;
      if (kind == 1) star.vertices[i].room = 2;
    }
    refused += compare(star, random, {+1, -1, -2}, 600);
  }
  CHECK(refused > 100);
}

TEST_CASE("the same once Z is embedded, where sides alone count") {
  std::mt19937_64 random(7);
  std::size_t refused = 0;
  for (EdgeStar star : random_stars(120, 11, 8)) {
    std::vector<int> sides;
    for (const EdgeStar::StarTet& t : star.tets)
      sides.push_back(star.vertices[t.v[2]].position.x + star.vertices[t.v[3]].position.x > 0 ? 1 : -1);
    embed(star, sides, {});
    refused += compare(star, random, {+1, -1}, 600);
  }
  CHECK(refused > 100);
}

TEST_CASE("far from the origin and very small the boxes decide the same") {
  std::mt19937_64 random(8);
  std::size_t refused = 0;
  for (EdgeStar star : random_stars(80, 13, 9)) {
    for (std::size_t i = 2; i < star.vertices.size(); ++i)
      if (random() % 3 == 0) star.vertices[i].value = -1;
    EdgeStar far = star;
    transform(far, 1, 1e-3, {1e3, -2e3, 5e3});
    transform(star, 1e-4, 1e-6, {});
    refused += compare(far, random, {+1, -1}, 300) + compare(star, random, {+1, -1}, 300);
  }
  CHECK(refused > 50);
}
