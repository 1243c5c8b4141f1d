// The target search with judges whose valid set is known.
#include "collapse/target_search.h"

#include "collapse/kernel_walk.h"
#include "criteria/stars.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// The octahedron with an error that is least at (0.2, 0, 0): the squared distance to that point.
struct Fixture {
  EdgeStar star = octahedron_star();
  Kernel kernel;
  CollapseCost cost{star};

  Fixture() {
    const Vec3 c{0.2, 0, 0};
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    star.cost_facets = {{c, c + y, c + z}, {c, c + z, c + x}, {c, c + x, c + y}};
    kernel = compute_kernel(star);
    cost = CollapseCost(star);
  }
  TargetSearchResult search(TargetStrategy strategy, const TargetJudge& judge) const {
    TargetSearchOptions options;
    options.strategy = strategy;
    options.record = true;
    return search_kernel(star, kernel, cost, judge, options);
  }
};

TargetVerdict rejection(Reason reason, Vec3 witness = {}) {
  TargetVerdict verdict;
  verdict.reason = reason;
  verdict.value = 2;
  verdict.limit = 1;
  verdict.witness = witness;
  return verdict;
}

/// Accepts the ball, teaches nothing.
TargetJudge only_in_ball(Vec3 center, double radius) {
  return [=](Vec3 x) {
    return distance(x, center) < radius ? TargetVerdict{} : rejection(Reason::outside_tolerance, x);
  };
}

/// The same; each rejection names the ball of targets that certainly fail.
TargetJudge ball_with_region(Vec3 center, double radius) {
  return [=](Vec3 x) {
    const double excess = distance(x, center) - radius;
    if (excess < 0) return TargetVerdict{};
    TargetVerdict verdict = rejection(Reason::outside_tolerance, x);
    verdict.invalid = invalid_region(x, 1, excess);
    return verdict;
  };
}

constexpr std::array<TargetStrategy, 4> strategies{TargetStrategy::optimum, TargetStrategy::constraints,
                                                   TargetStrategy::sampling, TargetStrategy::octree};

} // namespace

TEST_CASE("the optimum is taken at once where it passes") {
  const Fixture f;
  for (const TargetStrategy s :
       {TargetStrategy::optimum, TargetStrategy::constraints, TargetStrategy::sampling}) {
    const TargetSearchResult r = f.search(s, [](Vec3) { return TargetVerdict{}; });
    REQUIRE(r.target);
    CHECK(distance(*r.target, {0.2, 0, 0}) < 1e-5);
    CHECK(r.found_by == Reason::quadric_optimum);
    CHECK(r.tried == 1);
    CHECK(r.last_rejection.reason == Reason::none);
    REQUIRE(r.candidates.size() == 1);
    CHECK(r.candidates[0].rejected == Reason::none);
    CHECK(r.cost == r.candidates[0].cost);
  }
}

TEST_CASE("a learnt half-space moves the optimum onto it") {
  const Fixture f;
  const TargetJudge judge = [](Vec3 x) {
    if (x.z >= 0.3 && x.y >= 0.1) return TargetVerdict{};
    TargetVerdict verdict = rejection(Reason::outside_tolerance, x);
    verdict.learnt = x.z < 0.3 ? HalfSpace{{0, 0, 1}, 0.3} : HalfSpace{{0, 1, 0}, 0.1};
    return verdict;
  };
  const TargetSearchResult r = f.search(TargetStrategy::constraints, judge);
  REQUIRE(r.target);
  CHECK(distance(*r.target, {0.2, 0.1, 0.3}) < 2e-3);
  CHECK(r.found_by == Reason::lazy_constraints);
  CHECK(r.tried == 3);
  CHECK(r.candidates[0].found_by == Reason::quadric_optimum);
  CHECK(r.candidates[1].found_by == Reason::lazy_constraints);
  CHECK_FALSE(f.search(TargetStrategy::optimum, judge).target);
}

TEST_CASE("constraints end where they leave no point or do not cut") {
  const Fixture f;
  const TargetJudge beyond = [](Vec3 x) {
    TargetVerdict verdict = rejection(Reason::outside_tolerance, x);
    verdict.learnt = HalfSpace{{0, 0, 1}, 5};
    return verdict;
  };
  TargetSearchResult r = f.search(TargetStrategy::constraints, beyond);
  CHECK_FALSE(r.target);
  CHECK(r.tried == 1);
  CHECK(r.last_rejection.reason == Reason::outside_tolerance);
  const TargetJudge idle = [](Vec3 x) {
    TargetVerdict verdict = rejection(Reason::misclassified, x);
    verdict.learnt = HalfSpace{{0, 0, 1}, -5};
    return verdict;
  };
  r = f.search(TargetStrategy::constraints, idle);
  CHECK(r.tried == 1);
  CHECK(r.last_rejection.reason == Reason::misclassified);
  // A little more each time: as many rounds as allowed.
  const TargetJudge nagging = [](Vec3 x) {
    TargetVerdict verdict = rejection(Reason::normals, x);
    verdict.learnt = HalfSpace{{0, 0, 1}, x.z + 0.01};
    return verdict;
  };
  CHECK(f.search(TargetStrategy::constraints, nagging).tried == 11);
}

TEST_CASE("points drawn in the kernel find what the optimum misses, cheapest first") {
  const Fixture f;
  const TargetSearchResult r = f.search(TargetStrategy::sampling, only_in_ball({-0.3, 0.2, 0.1}, 0.25));
  REQUIRE(r.target);
  CHECK(r.found_by == Reason::kernel_sampling);
  CHECK(distance(*r.target, {-0.3, 0.2, 0.1}) < 0.25);
  REQUIRE(r.candidates.size() == r.tried);
  for (std::size_t i = 2; i < r.candidates.size(); ++i)
    CHECK(r.candidates[i - 1].cost <= r.candidates[i].cost);
  CHECK_FALSE(f.search(TargetStrategy::constraints, only_in_ball({-0.3, 0.2, 0.1}, 0.25)).target);
}

TEST_CASE("regions known to fail save most of the judge's work and none of the result") {
  const Fixture f;
  const Vec3 center{-0.3, 0.2, 0.1};
  const TargetSearchResult blind = f.search(TargetStrategy::sampling, only_in_ball(center, 0.25));
  const TargetSearchResult pruned = f.search(TargetStrategy::sampling, ball_with_region(center, 0.25));
  CHECK(pruned.target == blind.target);
  CHECK(pruned.tried < blind.tried / 2);
  REQUIRE(pruned.invalid_regions.size() + 1 == pruned.tried);
  for (std::size_t i = 0; i < pruned.candidates.size(); ++i) {
    for (std::size_t k = 0; k < std::min(i, pruned.invalid_regions.size()); ++k)
      CHECK_FALSE(pruned.invalid_regions[k].contains(pruned.candidates[i].point));
  }
}

TEST_CASE("the octree comes near the least error of a valid set") {
  const Fixture f;
  const Vec3 center{-0.3, 0.2, 0.1};
  const double radius = 0.25, best = distance(center, {0.2, 0, 0}) - radius;
  TargetSearchOptions options;
  options.strategy = TargetStrategy::octree;
  options.octree_samples = 100000;
  options.record = true;
  const TargetSearchResult r =
      search_kernel(f.star, f.kernel, f.cost, ball_with_region(center, radius), options);
  REQUIRE(r.target);
  CHECK(r.found_by == Reason::octree_search);
  CHECK(distance(*r.target, center) < radius);
  // Cells of the last level have a side of 1/16.
  CHECK(std::sqrt(r.cost) >= best);
  CHECK(std::sqrt(r.cost) < best + 0.11);
  std::set<OctreeCell::Fate> fates;
  for (const OctreeCell& cell : r.cells) {
    fates.insert(cell.fate);
    if (cell.fate == OctreeCell::Fate::invalid) CHECK(distance(cell.box.center(), center) >= radius);
  }
  CHECK(fates.count(OctreeCell::Fate::split) == 1);
  CHECK(fates.count(OctreeCell::Fate::invalid) == 1);
  CHECK(fates.count(OctreeCell::Fate::costlier) == 1);
  // Without Ψ the same target at a higher price.
  const TargetSearchResult blind =
      search_kernel(f.star, f.kernel, f.cost, only_in_ball(center, radius), options);
  CHECK(blind.target == r.target);
  CHECK(blind.tried > r.tried);
}

TEST_CASE("the octree keeps to its limits") {
  const Fixture f;
  const TargetJudge never = [](Vec3 x) { return rejection(Reason::normals, x); };
  TargetSearchOptions options;
  options.strategy = TargetStrategy::octree;
  options.octree_samples = 37;
  CHECK(search_kernel(f.star, f.kernel, f.cost, never, options).tried == 37);
  options.octree_depth = 0;
  TargetSearchResult r = search_kernel(f.star, f.kernel, f.cost, never, options);
  CHECK(r.tried == 1);
  CHECK(r.cells.empty());
  // Down to the last level the cells that are not split cover the box, and those outside the kernel are left
  // out.
  options.octree_depth = 3;
  options.octree_samples = 100000;
  options.record = true;
  r = search_kernel(f.star, f.kernel, f.cost, never, options);
  double volume = 0;
  std::size_t outside = 0;
  for (const OctreeCell& cell : r.cells) {
    const Vec3 e = cell.box.extent();
    if (cell.fate != OctreeCell::Fate::split) volume += e.x * e.y * e.z;
    if (cell.fate != OctreeCell::Fate::outside_kernel) continue;
    ++outside;
    CHECK_FALSE(f.kernel.contains(cell.box.center()));
  }
  CHECK(outside > 50);
  CHECK(volume == doctest::Approx(8));
}

TEST_CASE("an empty kernel and a set without candidates are reasons of their own") {
  Fixture f;
  const TargetJudge any = [](Vec3) { return TargetVerdict{}; };
  const std::array<Vec3, 2> outside{Vec3{2, 0, 0}, Vec3{0.5, 0.5, 0}};
  TargetSearchResult r =
      search_candidates(f.star, f.kernel, f.cost, outside, Reason::sample_candidate, any, {});
  CHECK(r.last_rejection.reason == Reason::no_candidate);
  CHECK(r.tried == 0);
  std::swap(f.star.vertices[6].position, f.star.vertices[7].position);
  f.kernel = compute_kernel(f.star);
  REQUIRE(f.kernel.empty);
  for (const TargetStrategy s : strategies) {
    r = f.search(s, any);
    CHECK(r.last_rejection.reason == Reason::kernel_empty);
    CHECK_FALSE(r.target);
  }
  r = search_candidates(f.star, f.kernel, f.cost, outside, Reason::halfedge, any, {});
  CHECK(r.last_rejection.reason == Reason::kernel_empty);
}

TEST_CASE("given points: those in the kernel, by ascending error, until one passes") {
  const Fixture f;
  const std::array<Vec3, 5> points{Vec3{0, 0, -0.3}, Vec3{0, 0, 0.3}, Vec3{0.2, 0, 0.02}, Vec3{0.19, 0, 0},
                                   Vec3{0.2, 5, 0}};
  const TargetJudge upper = [](Vec3 x) {
    return x.z > 0.1 ? TargetVerdict{} : rejection(Reason::misclassified, x);
  };
  TargetSearchOptions options;
  options.record = true;
  TargetSearchResult r =
      search_candidates(f.star, f.kernel, f.cost, points, Reason::sample_candidate, upper, options);
  CHECK(r.target == points[1]);
  CHECK(r.found_by == Reason::sample_candidate);
  REQUIRE(r.candidates.size() == 4);
  CHECK(r.candidates[0].point == points[3]);
  CHECK(r.candidates[1].point == points[2]);
  CHECK(r.candidates[2].point == points[0]);
  options.kernel_samples = 2;
  r = search_candidates(f.star, f.kernel, f.cost, points, Reason::sample_candidate, upper, options);
  CHECK_FALSE(r.target);
  CHECK(r.tried == 2);
  CHECK(r.last_rejection.witness == points[3]); // of the least error
}

TEST_CASE("every strategy judges points of the kernel only, and always the same ones") {
  std::size_t searched = 0;
  for (EdgeStar& star : random_stars(80, 11, 21)) {
    const Kernel kernel = compute_kernel(star);
    if (kernel.empty) continue;
    for (const EdgeStar::StarTet& t : star.tets) {
      const auto p = star.positions(t);
      star.cost_facets.push_back({p[0], p[1], p[2]});
    }
    const CollapseCost cost(star);
    const Vec3 middle = kernel.center + 0.5 * kernel.inscribed_radius * Vec3{0, 0, 1};
    for (const TargetStrategy s : strategies) {
      TargetSearchOptions options;
      options.strategy = s;
      options.record = true;
      const TargetJudge inner = only_in_ball(middle, 0.5 * kernel.inscribed_radius);
      const TargetJudge judge = [&](Vec3 x) {
        CHECK(kernel.contains(x));
        return inner(x);
      };
      const TargetSearchResult first = search_kernel(star, kernel, cost, judge, options);
      options.record = false;
      const TargetSearchResult second = search_kernel(star, kernel, cost, judge, options);
      CHECK(first.target == second.target);
      CHECK(first.cost == second.cost);
      CHECK(first.tried == second.tried);
      CHECK(first.candidates.size() == first.tried);
      CHECK(second.candidates.empty());
      CHECK(first.target.has_value() == (first.last_rejection.reason == Reason::none));
      ++searched;
    }
  }
  CHECK(searched > 20);
}

TEST_CASE("a walk stays inside and fills a cube evenly") {
  const std::vector<HalfSpace> cube{{{1, 0, 0}, 0},   {{-1, 0, 0}, -1}, {{0, 1, 0}, 0},
                                    {{0, -1, 0}, -1}, {{0, 0, 1}, 0},   {{0, 0, -1}, -1}};
  const auto points = walk_kernel(cube, {0.9, 0.9, 0.9}, 8000, 5);
  REQUIRE(points.size() == 8000);
  std::array<int, 8> octants{};
  for (const Vec3 p : points) {
    for (const HalfSpace& h : cube) CHECK(h.slack(p) >= -1e-12);
    ++octants[static_cast<std::size_t>((p.x > 0.5) + 2 * (p.y > 0.5) + 4 * (p.z > 0.5))];
  }
  for (const int n : octants) {
    CHECK(n > 800);
    CHECK(n < 1200);
  }
  CHECK(walk_kernel(cube, {0.9, 0.9, 0.9}, 8000, 5) == points);
  CHECK(walk_kernel(cube, {0.9, 0.9, 0.9}, 8000, 6) != points);
}

TEST_CASE("names of checks differ") {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < collapse_check_count; ++i) names.insert(name(static_cast<CollapseCheck>(i)));
  CHECK(names.size() == collapse_check_count);
  CHECK(name(CollapseCheck::zero_link) == "zero-link");
  CHECK(name(CollapseCheck::witness) == "witness");
}
