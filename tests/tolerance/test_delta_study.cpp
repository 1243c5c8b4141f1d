// Tolerances that suit: known intervals of spheres, with holes, nested, and of what encloses nothing.
#include "tolerance/delta_study.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "support/clouds.h"
#include "tolerance/field_octree.h"
#include "tolerance/level_histories.h"
#include "tolerance/witnessed_distance.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

DeltaStudy study(const std::vector<Vec3>& points, std::size_t k = 12) {
  const WitnessedDistance found = witness_distance(points, k, RunControl());
  const WeightedPointIndex index(found.sites, found.area);
  return study_delta(index, found.finest(), RunControl());
}

const DeltaStudy::Step& step_at(const DeltaStudy& s, double delta) {
  const auto after = std::lower_bound(s.curve.begin(), s.curve.end(), delta,
                                      [](const auto& step, double d) { return step.delta < d; });
  return after == s.curve.end() ? s.curve.back() : *after;
}

} // namespace

TEST_CASE("a sphere of points encloses its inside from some distances between them up to its radius") {
  Random random(1);
  const DeltaStudy s = study(sphere_points(random, 3000, 1, 0.01));
  REQUIRE(s.found());
  REQUIRE(s.insides.size() == 1);
  CHECK(s.least > 0.08);
  CHECK(s.least < 0.25);
  CHECK(s.most == doctest::Approx(1 / deep_enough).epsilon(0.1));
  CHECK(s.proposed > s.least);
  CHECK(s.proposed < 0.35);
  CHECK(length(s.saddle()) == doctest::Approx(1).epsilon(0.15));
  CHECK(length(s.closing()) < 0.2);
  const DeltaStudy::Step& at = step_at(s, s.proposed);
  CHECK(at.components == 1);
  CHECK(at.deep == 1);
  CHECK(s.curve.back().regions == 1);
  for (std::size_t i = 1; i < s.curve.size(); ++i) CHECK(s.curve[i].delta > s.curve[i - 1].delta);
}

TEST_CASE("a gap is closed by the tolerance, and the place of the opening is told") {
  Random random(2);
  std::vector<Vec3> points = sphere_points(random, 6000, 1, 0);
  std::erase_if(points, [](Vec3 p) { return distance(p, {0, 0, 1}) < 0.3; });
  const DeltaStudy s = study(points);
  REQUIRE(s.found());
  CHECK(s.least == doctest::Approx(0.3).epsilon(0.2));
  CHECK(distance(s.saddle(), {0, 0, 0.95}) < 0.2);
}

TEST_CASE("nested spheres have two insides, and parts apart have one each") {
  Random random(3);
  std::vector<Vec3> points = sphere_points(random, 8000, 1, 0);
  for (const Vec3 p : sphere_points(random, 2000, 0.5, 0)) points.push_back(p);
  const DeltaStudy nested = study(points);
  REQUIRE(nested.found());
  CHECK(nested.insides.size() == 2);
  CHECK(nested.most == doctest::Approx(0.25 / deep_enough).epsilon(0.15));

  std::vector<Vec3> apart = sphere_points(random, 3000, 1, 0);
  for (const Vec3 p : sphere_points(random, 3000, 1, 0)) apart.push_back(p + Vec3{3, 0, 0});
  const DeltaStudy two = study(apart);
  REQUIRE(two.found());
  CHECK(two.insides.size() == 2);
  CHECK(step_at(two, two.proposed).components == 2);
}

TEST_CASE("a flat sheet encloses nothing at any tolerance") {
  Random random(4);
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) points.push_back({random.unit(), random.unit(), 0.002 * random.unit()});
  const DeltaStudy s = study(points);
  CHECK_FALSE(s.found());
  CHECK(s.insides.empty());
  CHECK(s.curve.size() > 10);
}

TEST_CASE("a study is the same on any number of threads, and can be stopped") {
  Random random(5);
  const std::vector<Vec3> points = sphere_points(random, 1500, 1, 0.01);
  std::vector<double> proposed;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    proposed.push_back(study(points).proposed);
  }
  CHECK(proposed[0] == proposed[1]);
  CHECK(proposed[0] == proposed[2]);
  const WitnessedDistance found = witness_distance(points, 12, RunControl());
  const WeightedPointIndex index(found.sites, found.area);
  RunControl control;
  control.cancel();
  CHECK_FALSE(study_delta(index, found.finest(), control).found());
}

TEST_CASE("levels at which components come and join are those of all leaves, one after the other") {
  Random random(6);
  std::vector<Vec3> points = sphere_points(random, 300, 1, 0.03);
  for (int i = 0; i < 20; ++i)
    points.push_back({4 * random.unit() - 2, 4 * random.unit() - 2, random.unit()});
  const WitnessedDistance found = witness_distance(points, 4, RunControl());
  const WeightedPointIndex index(found.sites, found.area);
  const FieldOctree octree(index, found.finest(), RunControl());
  const LevelHistories histories = find_histories(octree, RunControl());
  REQUIRE(histories.components.size() > 10);

  const auto check = [&](const std::vector<LevelPair>& ended, bool above) {
    double least = 1e300, most = 0;
    for (std::uint32_t leaf = 0; leaf < octree.leaves(); ++leaf)
      least = std::min(least, octree.value(leaf)), most = std::max(most, octree.value(leaf));
    for (int step = 1; step < 12; ++step) {
      const double level = least * std::pow(most / least, step / 12.0) * (1 + 1e-6);
      // Components of the leaves beyond the level, outside of the octree as the last one.
      const auto n = static_cast<std::uint32_t>(octree.leaves());
      const auto has = [&](std::uint32_t leaf) { return (octree.value(leaf) > level) == above; };
      DisjointSets sets(n + 1);
      for (std::uint32_t leaf = 0; leaf < n; ++leaf) {
        if (!has(leaf)) continue;
        const bool at_border = octree.for_each_neighbor(leaf, [&](std::uint32_t other) {
          if (has(other)) sets.unite(leaf, other);
        });
        if (at_border && above) sets.unite(leaf, n);
      }
      // Of those the ones that are known to last: with a leaf a good deal beyond the level.
      const double beyond = above ? 1.1 * level : level / 1.1;
      std::set<std::uint32_t> lasting;
      if (above) lasting.insert(sets.find(n));
      for (std::uint32_t leaf = 0; leaf < n; ++leaf)
        if (above ? octree.value(leaf) > beyond : octree.value(leaf) < beyond)
          lasting.insert(sets.find(leaf));
      std::size_t told = 1;
      for (const LevelPair& p : ended)
        if (above ? p.birth > beyond && p.death <= level * 1.001
                  : p.birth < beyond && p.death >= level / 1.001)
          ++told;
      CHECK(told == lasting.size());
    }
  };
  check(histories.regions, true);
  check(histories.components, false);
}
