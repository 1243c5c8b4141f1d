// Whole runs: valid results, fewer vertices with more effort, the same bits on any number of threads.
#include "base/parallel.h"
#include "improve/support.h"
#include "improve/surface_collapses.h"
#include "input/gallery.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

using namespace isoscope;
using isoscope::testing::check_valid;
using isoscope::testing::Listener;
using isoscope::testing::sphere;
using isoscope::testing::Start;
using isoscope::testing::with_effort;

namespace {

TriangleSoup torus(unsigned n) {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 1, 0.4, n);
  for (auto& f : soup.triangles) std::swap(f[0], f[1]); // outward
  return soup;
}

/// Applies the changes to the start mesh, checking that each fits what is there.
struct Replay {
  std::map<std::uint32_t, std::array<std::uint32_t, 3>> facets;
  std::vector<Vec3> points;

  explicit Replay(const TriangleMesh& start) : points(start.points) {
    for (std::uint32_t f = 0; f < start.triangles.size(); ++f) facets[f] = start.triangles[f];
  }
  void apply(const SurfaceChange& change) {
    for (const auto& f : change.removed) {
      REQUIRE(facets.contains(f.slot));
      CHECK(facets[f.slot] == f.v);
      facets.erase(f.slot);
    }
    for (const auto& f : change.added) {
      CHECK_FALSE(facets.contains(f.slot));
      facets[f.slot] = f.v;
    }
    for (const auto& m : change.moves) {
      CHECK(points[m.vertex] == m.before);
      points[m.vertex] = m.after;
    }
  }
  std::vector<Triangle3> triangles() const {
    std::vector<Triangle3> all;
    for (const auto& [slot, v] : facets) all.push_back({points[v[0]], points[v[1]], points[v[2]]});
    return all;
  }
};

std::vector<Triangle3> triangles(const TriangleMesh& mesh) {
  std::vector<Triangle3> all;
  for (const auto& t : mesh.triangles)
    all.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  return all;
}

} // namespace

TEST_CASE("a sphere gets near the optimum, and more effort never needs more vertices") {
  const Start start(sphere(24), 2); // δ = 0.04 r: the optimum is 2 + 1.209 / 0.04 = 32 vertices
  std::size_t last = start.mesh.points.size();
  for (int effort = 0; effort <= 2; ++effort) {
    TriangleMesh mesh = start.mesh;
    Listener listener;
    const auto outcome = improve(mesh, *start.volume, nullptr, with_effort(effort), RunControl(), listener);
    CHECK(outcome.end == ImproverOutcome::End::finished);
    CHECK(outcome.collapses == start.mesh.points.size() - mesh.points.size());
    check_valid(mesh, start, 2);
    CHECK(mesh.points.size() <= last);
    last = mesh.points.size();
    const bool relaxed = std::any_of(listener.changes.begin(), listener.changes.end(),
                                     [](const SurfaceChange& c) { return c.kind == EventKind::relaxation; });
    CHECK(relaxed == (effort > 0));
    CHECK((outcome.repairs > 0) == (effort > 1));
  }
  CHECK(last <= 48);
}

TEST_CASE("the changes replay the run, and every decision names its reason") {
  const Start start(torus(12), 3);
  TriangleMesh mesh = start.mesh;
  Listener listener;
  const auto outcome = improve(mesh, *start.volume, nullptr, with_effort(2), RunControl(), listener);
  check_valid(mesh, start, 0);
  const auto shakes = std::count_if(listener.changes.begin(), listener.changes.end(),
                                    [](const SurfaceChange& c) { return c.kind == EventKind::shake; });
  CHECK(shakes > 0);
  CHECK(outcome.shakes == static_cast<std::size_t>(shakes));
  CHECK(outcome.shaken_edges >= outcome.shakes);
  Replay replay(start.mesh);
  for (const SurfaceChange& change : listener.changes) replay.apply(change);
  CHECK(replay.triangles() == triangles(mesh));
  for (const ImproverVerdict& v : listener.verdicts) {
    CHECK(v.accepted());
    CHECK(v.value > 0);
    CHECK(v.value <= v.limit);
    CHECK(v.limit == start.delta());
  }
  std::size_t above = 0;
  for (const ImproverVerdict& v : listener.rejections) {
    CHECK_FALSE(v.accepted());
    CHECK(v.a < v.b);
    if (v.reason == Reason::stays_above) {
      CHECK(v.value > v.limit);
      ++above;
    }
    if (v.reason == Reason::stays_above || v.reason == Reason::outside_tolerance) {
      REQUIRE(v.facet);
      // Three vertices of Z; b has been merged into a.
      for (const std::uint32_t corner : *v.facet) CHECK(corner < start.mesh.points.size());
      CHECK((*v.facet)[0] != (*v.facet)[1]);
      CHECK((*v.facet)[1] != (*v.facet)[2]);
      CHECK(std::find(v.facet->begin(), v.facet->end(), v.b) == v.facet->end());
    }
    if (v.reason == Reason::outside_tolerance)
      CHECK(start.volume->index().distance(v.witness) == doctest::Approx(v.value));
  }
  CHECK(above > 0);
}

TEST_CASE("one thread and several give the same bits") {
  const Start start(torus(12), 4);
  const auto samples = sample_boundary(*start.volume, start.delta() / 2, RunControl());
  REQUIRE(samples.ok());
  const NearestSample nearest(samples->positions, samples->labels);
  std::vector<TriangleMesh> results;
  std::vector<std::size_t> rejections;
  for (const unsigned threads : {1u, 5u}) {
    const ThreadLimit limit(threads);
    TriangleMesh mesh = start.mesh;
    Listener listener;
    improve(mesh, *start.volume, &nearest, with_effort(2), RunControl(), listener);
    results.push_back(mesh);
    rejections.push_back(listener.rejections.size());
  }
  for (std::size_t i = 1; i < results.size(); ++i) {
    CHECK(results[i].points == results[0].points);
    CHECK(results[i].triangles == results[0].triangles);
    CHECK(rejections[i] == rejections[0]);
  }
}

TEST_CASE("stopped or cancelled at any moment there is a valid surface") {
  const Start start(sphere(12), 4);
  for (const std::size_t moment : {1u, 2u, 7u, 30u, 60u, 100u, 101u, 103u, 110u, 130u}) {
    for (const bool cancel : {false, true}) {
      TriangleMesh mesh = start.mesh;
      RunControl control;
      Listener listener;
      listener.control = &control;
      (cancel ? listener.cancel_after : listener.stop_after) = moment;
      const auto outcome = improve(mesh, *start.volume, nullptr, with_effort(3), control, listener);
      CHECK(outcome.end == ImproverOutcome::End::stopped);
      check_valid(mesh, start, 2);
      Replay replay(start.mesh);
      for (const SurfaceChange& change : listener.changes) replay.apply(change);
      CHECK(replay.triangles() == triangles(mesh));
    }
  }
}

TEST_CASE("an input whose triangles run both ways is no obstacle") {
  const TriangleSoup soup = sphere(14);
  std::size_t straight = 0;
  for (const int turned : {0, 1, 2}) {
    const Start start = Start::with_turned(
        soup, 4, [&](std::size_t i) { return turned == 1 || (turned == 2 && i % 2 == 0); });
    TriangleMesh mesh = start.mesh;
    Listener listener;
    improve(mesh, *start.volume, nullptr, with_effort(1), RunControl(), listener);
    check_valid(mesh, start, 2);
    if (turned == 0) straight = mesh.points.size();
    CHECK(mesh.points.size() <= straight + straight / 10 + 1);
  }
}

TEST_CASE("a round makes no more attempts than it may, to the rest of its batch, the cheapest first") {
  const Start start(sphere(24), 4);
  const InputSurface input(start.volume->index(), start.delta(), start.mesh);
  SurfaceRules rules;
  rules.input = &input;
  std::size_t all = 0;
  for (const std::size_t most : {std::numeric_limits<std::size_t>::max(), std::size_t{1}, std::size_t{40}}) {
    LiveSurface surface(start.mesh, rules);
    const std::size_t before = surface.vertex_count();
    CollapseRoundOptions options;
    options.cost_limit = rules.sampled_limit();
    options.most_attempts = most;
    FailedEdges failed;
    Listener listener;
    const CollapseRoundFigures figures =
        collapse_round(surface, rules, options, failed, RunControl(), listener);
    CHECK(figures.collapses == before - surface.vertex_count());
    if (all == 0) all = figures.attempts;
    if (most > all) continue;
    CHECK(figures.attempts >= most);
    CHECK(figures.attempts < most + 16);
    CHECK(figures.collapses > 0);
  }
  REQUIRE(all > 56);
}

TEST_CASE("preserved normals cost little and leave no failed test of condition 3") {
  const Start start(torus(14), 3);
  RunControl control;
  const auto samples = sample_boundary(*start.volume, start.delta() / 2, control);
  REQUIRE(samples.ok());
  const NearestSample nearest(samples->positions, samples->labels);
  const OrientationTester tester{&nearest, 0.7, 2.5 * start.delta(), &start.volume->field(), start.delta()};
  std::size_t before = 0, after = 0;
  for (const Triangle3& t : triangles(start.mesh)) before += tester.failures(t).size();
  TriangleMesh kept = start.mesh, loose = start.mesh;
  Listener listener;
  improve(kept, *start.volume, &nearest, with_effort(1), control, listener);
  improve(loose, *start.volume, nullptr, with_effort(1), control, listener);
  check_valid(kept, start, 0);
  for (const Triangle3& t : triangles(kept)) after += tester.failures(t).size();
  CHECK(after <= before);
  CHECK(kept.points.size() <= loose.points.size() + loose.points.size() / 5 + 2);
}

TEST_CASE("two nested spheres keep their walls apart and their component each") {
  TriangleSoup soup = sphere(16);
  const std::size_t outer = soup.triangles.size();
  testing::add_sphere(soup, {0, 0, 0}, 0.7, 16);
  for (std::size_t i = outer; i < soup.triangles.size(); ++i)
    std::swap(soup.triangles[i][0], soup.triangles[i][1]);
  const Start start(soup, 4); // δ = 0.08: the wall of 0.3 is less than twice 2 δ
  TriangleMesh mesh = start.mesh;
  Listener listener;
  improve(mesh, *start.volume, nullptr, with_effort(1), RunControl(), listener);
  check_valid(mesh, start, 4);
}

TEST_CASE("gallery models come out valid") {
  for (const GalleryEntry& entry : gallery()) {
    if (entry.name != "sphere" && entry.name != "knot") continue;
    const auto soup = make_gallery_model(entry.name);
    REQUIRE(soup.ok());
    const Start start(*soup, 2 * entry.tolerance_percent);
    TriangleMesh mesh = start.mesh;
    Listener listener;
    improve(mesh, *start.volume, nullptr, with_effort(1), RunControl(), listener);
    check_valid(mesh, start, entry.euler_characteristic);
    CHECK(mesh.points.size() < start.mesh.points.size() / 2);
  }
}

TEST_CASE("an empty surface stays empty, and its input keeps its normals") {
  const Start start(sphere(8), 4);
  TriangleMesh mesh;
  Listener listener;
  const auto outcome = improve(mesh, *start.volume, nullptr, with_effort(3), RunControl(), listener);
  CHECK(outcome.end == ImproverOutcome::End::finished);
  CHECK(mesh.triangles.empty());
  CHECK(listener.changes.empty());
  const InputSurface input(start.volume->index(), start.delta(), {});
  const Triangle3& t = start.volume->index().triangle(TriangleId(0));
  CHECK(dot(input.normal(TriangleId(0)), cross(t[1] - t[0], t[2] - t[0])) > 0);
}
