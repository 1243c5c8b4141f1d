// Whole runs on points: noise, outliers, blobs, gaps, two scans, and soups that are taken as points.
#include "base/parallel.h"
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "run/complete_run.h"
#include "run/point_field.h"
#include "run/report.h"
#include "run/statistics.h"
#include "support/clouds.h"
#include "support/models.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

const Box3 around{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};

/// A run of these points as far as the refinement, with δ found.
std::unique_ptr<CompleteRun> run_of(std::vector<Vec3> points, Tolerance tolerance = {.automatic = true}) {
  RunParameters parameters;
  parameters.tolerance = tolerance;
  parameters.until = Stage::refinement;
  auto run = std::make_unique<CompleteRun>(parameters);
  auto soup = std::make_shared<TriangleSoup>();
  soup->points = std::move(points);
  run->soup = soup;
  return run;
}

std::size_t deep_regions(const Scene& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.regions.begin(), scene.regions.end(), [](const Region& r) { return !r.shallow; }));
}

void check_closed_sphere(CompleteRun& run) {
  if (!run.run()) FAIL(run.error->line());
  for (const std::string& failure : run.result->certificate.failures) MESSAGE(failure);
  CHECK(run.result->certificate.holds());
  CHECK(run.result->certificate.euler_characteristic == 2);
  CHECK(run.result->certificate.components == 1);
  CHECK(run.result->exit_status() == 0);
  CHECK(deep_regions(*run.scene) == 2);
  REQUIRE(run.result->points);
}

void check_sphere(CompleteRun& run) {
  check_closed_sphere(run);
  CHECK(run.result->points->kept.percentile_99 < 1.5 * run.scene->delta);
}

/// Those that some site stands for.
std::vector<std::uint32_t> kept_points(const PointField& field) {
  std::vector<std::uint32_t> ids;
  const std::vector<bool> kept = field.kept();
  for (std::uint32_t i = 0; i < kept.size(); ++i)
    if (kept[i]) ids.push_back(i);
  return ids;
}

bool warned(const Scene& scene, const std::string& words) {
  return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                     [&](const ParameterWarning& w) { return w.message.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("a noisy sphere with outliers comes out as a sphere, and they are told") {
  Random random(1);
  std::vector<Vec3> points = sphere_points(random, 4000, 1, 0.02);
  add_outliers(random, points, 210, around);
  const auto run = run_of(std::move(points));
  check_sphere(*run);
  CHECK(run->scene->points->dropped_points() > 50);
  CHECK(run->scene->points->dropped_points() < 250);
  CHECK(warned(*run->scene, "are outliers and left out"));
  CHECK(run->result->points->all.most > run->result->points->kept.most);
  const auto report = nlohmann::json::parse(
      report_json(run->parameters, *run->scene, *run->result, gather_statistics(*run->journal)));
  CHECK(report["points"]["count"] == 4210);
  CHECK(report["points"]["neighbors"] == run->scene->points->neighbors);
  CHECK(report["tolerances"]["curve"].size() > 10);
  CHECK(report["tolerances"]["proposed"] == run->scene->delta);
  CHECK(report["parameters"]["tolerance_given"] == "auto");
}

TEST_CASE("a blob of 4 % of the points is dropped with its share and place, a larger part refused") {
  Random random(2);
  const auto with_blob = [&](std::size_t n) {
    std::vector<Vec3> points = sphere_points(random, 3000, 1, 0.01);
    for (std::size_t i = 0; i < n; ++i) points.push_back(Vec3{2, 0, 0} + noise(random, 0.05));
    return points;
  };
  const auto run = run_of(with_blob(125));
  check_sphere(*run);
  REQUIRE(run->scene->points->dropped.size() >= 1);
  const DroppedPoints& blob = run->scene->points->dropped.back();
  CHECK(blob.why == DroppedPoints::Why::blob);
  CHECK(blob.points > 100);
  CHECK(distance(blob.place, {2, 0, 0}) < 0.3);
  CHECK(warned(*run->scene, "enclose nothing and are left out"));

  const auto refused = run_of(with_blob(400));
  REQUIRE_FALSE(refused->prepare());
  CHECK(refused->error->code == ErrorCode::open_surface);
  CHECK(refused->error->message.find("encloses nothing") != std::string::npos);
  CHECK(refused->error->message.find("12 %") != std::string::npos);
}

TEST_CASE("hundreds of specks are told together, and are gone before Ω is built") {
  Random random(11);
  std::vector<Vec3> points = sphere_points(random, 4000, 1, 0.01);
  const Vec3 corner{1.5, 1.5, 1.5};
  for (int i = 0; i < 30; ++i) { // each is the whole neighbourhood of its points
    const Vec3 at = corner + Vec3{0.5 * (i % 6), 0.5 * (i / 6), 0};
    for (int j = 0; j < 7; ++j) points.push_back(at + noise(random, 1e-3));
  }
  const auto run = run_of(std::move(points), {.value = 0.2, .percent = false});
  run->parameters.robust.neighbors = 7;
  check_closed_sphere(*run);
  REQUIRE(run->scene->points->dropped.size() == 1);
  const DroppedPoints& specks = run->scene->points->dropped[0];
  CHECK(specks.why == DroppedPoints::Why::blob);
  CHECK(specks.parts == 30);
  CHECK(specks.points == 210);
  CHECK(specks.size < 0.02);
  CHECK(specks.place.x > 1.4);
  CHECK(warned(*run->scene, "in 30 parts"));
}

TEST_CASE("sites that were left out at one tolerance are there again for another one") {
  Random random(5);
  auto soup = std::make_shared<TriangleSoup>();
  soup->points = sphere_points(random, 3000, 1, 0.02);
  add_outliers(random, soup->points, 100, around);
  const RunControl control;
  const MadePointField all = make_point_field(soup, {}, {}, control);
  const double delta = all.points->study.proposed;
  const MadePointField kept = without_strays(all, delta, 0.95 * delta, control);
  CHECK(kept.index->size() < all.index->size());
  CHECK(kept.index->size() + kept.points->dropped_points() == all.index->size());
  const MadePointField again = with_all_sites(kept, control);
  REQUIRE(again.index->size() == all.index->size());
  CHECK(again.index->area() == all.index->area());
  CHECK(again.points->point.empty());
  CHECK(again.points->dropped.empty());
  for (std::uint32_t s = 0; s < all.index->size(); ++s) {
    CHECK(again.index->site(TriangleId(s)).center == all.index->site(TriangleId(s)).center);
    CHECK(again.index->site(TriangleId(s)).weight == all.index->site(TriangleId(s)).weight);
  }
}

TEST_CASE("in sampled mode the samples alone hold Z to the points") {
  Random random(12);
  const auto run = run_of(sphere_points(random, 1500, 1, 0.01));
  run->parameters.containment = Containment::sampled;
  run->parameters.sigma = 0.3;
  if (!run->run()) FAIL(run->error->line());
  CHECK(run->scene->thresholds.boundary == run->scene->delta);
  CHECK(run->result->certificate.euler_characteristic == 2);
  CHECK(run->result->certificate.components == 1);
  CHECK(run->result->certificate.intersection_free);
  CHECK(run->result->certificate.separates);
}

TEST_CASE("points on what is too thin to have an inside are told") {
  Random random(12);
  std::vector<Vec3> points = sphere_points(random, 4000, 1, 0.005);
  const std::size_t on_sphere = points.size();
  while (points.size() < 2 * on_sphere) { // a brim
    const Vec3 p = 2 * random.in_box({{-1, -1, 0}, {1, 1, 0}});
    if (length(p) > 1 && length(p) < 2) points.push_back(p + noise(random, 0.005));
  }
  const auto run = run_of(std::move(points));
  check_closed_sphere(*run);
  const PointDistances& distances = *run->result->points;
  CHECK(distances.far > on_sphere / 4);
  CHECK(distances.far < on_sphere);
  CHECK(distance(distances.farthest, {}) > 1.9);
}

TEST_CASE("gaps are closed, double layers are one, and densities may differ twenty times") {
  Random random(3);
  SUBCASE("a gap of 3 % of the size") {
    std::vector<Vec3> points = sphere_points(random, 4000, 1, 0.005);
    std::erase_if(points, [](Vec3 p) { return std::abs(p.z) < 0.03; });
    const auto run = run_of(std::move(points));
    check_sphere(*run);
  }
  SUBCASE("two scans 1 % apart") {
    std::vector<Vec3> points = sphere_points(random, 2500, 1, 0);
    for (const Vec3 p : sphere_points(random, 2500, 1.02, 0)) points.push_back(p);
    const auto run = run_of(std::move(points));
    check_sphere(*run);
  }
  SUBCASE("one half has a twentieth of the points") {
    std::vector<Vec3> points = sphere_points(random, 8000, 1, 0);
    std::erase_if(points, [&](Vec3 p) { return p.x < 0 && random.unit() > 0.05; });
    const auto run = run_of(std::move(points));
    check_sphere(*run);
  }
}

TEST_CASE("a torus of points has its hole, two spheres are two") {
  Random random(4);
  TriangleSoup torus;
  add_torus(torus, {}, 1, 0.45, 40);
  const auto ring = run_of(surface_points(random, torus, 5000, 0.01));
  if (!ring->run()) FAIL(ring->error->line());
  CHECK(ring->result->certificate.holds());
  CHECK(ring->result->certificate.euler_characteristic == 0);

  std::vector<Vec3> apart = sphere_points(random, 1500, 1, 0);
  for (const Vec3 p : sphere_points(random, 1500, 1, 0)) apart.push_back(p + Vec3{3, 0, 0});
  const auto two = run_of(std::move(apart));
  if (!two->run()) FAIL(two->error->line());
  CHECK(two->result->certificate.holds());
  CHECK(two->result->certificate.euler_characteristic == 4);
  CHECK(two->result->certificate.components == 2);
}

TEST_CASE("of two spheres in each other the proposed tolerance closes the sparser one too") {
  Random random(6);
  std::vector<Vec3> points = sphere_points(random, 6000, 1, 0.004);
  for (const Vec3 p : sphere_points(random, 3000, 0.45, 0.004)) points.push_back(p);
  const auto nested = run_of(std::move(points));
  if (!nested->run()) FAIL(nested->error->line());
  CHECK(nested->result->certificate.holds());
  CHECK(nested->result->certificate.components == 2);
  CHECK(nested->result->certificate.euler_characteristic == 4);
}

TEST_CASE("tolerances outside of the interval are told, by the end that is left") {
  Random random(5);
  const std::vector<Vec3> points = sphere_points(random, 1500, 1, 0.01);
  const auto small = run_of(points, {2, true});
  REQUIRE_FALSE(small->prepare());
  CHECK(small->error->code == ErrorCode::open_surface);
  CHECK(small->error->message.find("encloses nothing: it has holes") != std::string::npos);
  CHECK(small->error->remedy.find("--tolerance auto") != std::string::npos);
  const auto large = run_of(points, {0.85, false});
  const bool prepared = large->prepare();
  CHECK((prepared ? warned(*large->scene, "closed up")
                  : large->error->message.find("encloses nothing") != std::string::npos));
  const auto larger = run_of(points, {1.5, false});
  REQUIRE_FALSE(larger->prepare());
  CAPTURE(larger->error->message);
  CHECK(larger->error->message.find("the inside is closed up") != std::string::npos);
  std::vector<Vec3> sheet;
  for (int i = 0; i < 1000; ++i) sheet.push_back({random.unit(), random.unit(), 0});
  const auto open = run_of(sheet); // where γ finds its end: test_point_sheets.cpp
  open->parameters.gamma.gamma = BallTestFactor::off;
  REQUIRE_FALSE(open->prepare());
  CHECK(open->error->code == ErrorCode::open_surface);
}

TEST_CASE("just below the interval a passage is found that the octree does not show") {
  Random random(15);
  const std::vector<Vec3> points = sphere_points(random, 2500, 1, 0.005);
  const auto studied = run_of(points);
  REQUIRE(studied->prepare());
  const double least = studied->scene->points->study.least;
  for (const double part : {0.8, 0.9, 0.94, 0.97}) {
    CAPTURE(part);
    const auto run = run_of(points, {part * least, false});
    if (run->prepare()) {
      run->run();
      CHECK(run->result->certificate.holds());
    } else {
      CHECK(run->error->code == ErrorCode::open_surface);
      CHECK(run->error->message.find("encloses nothing: it has holes") != std::string::npos);
    }
  }
}

TEST_CASE("around the proposed tolerance every run ends, certified or refused with what to choose") {
  Random random(16);
  TriangleSoup torus;
  add_torus(torus, {}, 1, 0.4, 40);
  for (const double size : {0.01, 0.03}) {
    const std::vector<Vec3> points = surface_points(random, torus, 2500, size);
    const auto proposed = run_of(points);
    if (!proposed->run()) FAIL(proposed->error->line());
    CHECK(proposed->result->certificate.holds());
    CHECK(proposed->result->certificate.euler_characteristic == 0);
    for (const double part : {0.85, 0.92, 1.06, 1.15, 1.4}) {
      CAPTURE(size);
      CAPTURE(part);
      const auto run = run_of(points, {part * proposed->scene->delta, false});
      if (run->run()) {
        CHECK(run->result->certificate.holds());
        CHECK(run->result->mesh.points.size() < 5000);
      } else {
        CHECK(run->error->code == ErrorCode::open_surface);
        CHECK(run->error->remedy.find("auto") != std::string::npos);
      }
    }
  }
}

TEST_CASE("a tolerance that is to be found is never refused with the advice to have it found") {
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Vec3> bowl;
    const double rim = random.between(-0.98, -0.4);
    while (bowl.size() < 300)
      if (const Vec3 p = random.direction(); p.z > rim) bowl.push_back(p);
    const auto run = run_of(bowl);
    if (run->prepare()) continue;
    ++refused;
    CAPTURE(run->error->line());
    CHECK(run->error->code == ErrorCode::open_surface);
    CHECK(run->error->remedy.find("--tolerance auto") == std::string::npos);
  }
  CHECK(refused > 0);
  CHECK(refused < 16);
}

TEST_CASE("a pocket in the tip of a trunk is no part of its own") {
  const auto file = demo_model("elephant.off");
  if (!file) return;
  const auto soup = read_mesh(*file);
  REQUIRE(soup.ok());
  for (const std::uint64_t seed : {2, 4}) {
    Random random(seed);
    const auto run = run_of(surface_points(random, *soup, 10000, 0));
    if (!run->run()) FAIL(run->error->line());
    CAPTURE(seed);
    CHECK(run->result->certificate.holds());
    CHECK(run->result->certificate.components == 1);
  }
}

TEST_CASE("a torn soup is taken as points where that is asked for") {
  RunParameters parameters = gallery_parameters("soup");
  parameters.tolerance = {6, true};
  parameters.robust = {12};
  CompleteRun run(parameters);
  if (!run.run()) FAIL(run.error->line());
  CHECK(run.result->certificate.holds());
  CHECK(run.result->certificate.euler_characteristic == 0);
  CHECK(run.scene->points->drawn);
  CHECK(run.scene->points->neighbors == 12);
}

TEST_CASE("the journal of points is the same on any number of threads") {
  Random random(6);
  std::vector<Vec3> points = sphere_points(random, 1200, 1, 0.02);
  add_outliers(random, points, 40, around);
  std::set<std::uint64_t> digests;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    const auto run = run_of(points);
    run->parameters.until = Stage::tessellation;
    if (!run->run()) FAIL(run->error->line());
    CHECK(run->result->certificate.holds());
    digests.insert(digest(*run->journal));
  }
  CHECK(digests.size() == 1);
}

TEST_CASE("every facet is within δ of the witnessed distance, by all sites asked for many places") {
  Random random(7);
  const auto run = run_of(sphere_points(random, 1500, 1, 0.02));
  run->parameters.until = Stage::improve;
  run->parameters.effort = 0;
  if (!run->run()) FAIL(run->error->line());
  REQUIRE(run->result->certificate.holds());
  // By the definition: the mean of the k nearest points and their mean squared distance from it.
  const std::vector<Vec3>& points = run->scene->points->points->points;
  const std::size_t k = run->scene->points->neighbors;
  std::vector<std::pair<Vec3, double>> sites;
  for (const std::uint32_t i : kept_points(*run->scene->points)) {
    std::vector<Vec3> near = points;
    std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(k), near.end(),
                     [&](Vec3 a, Vec3 b) { return distance(a, points[i]) < distance(b, points[i]); });
    Vec3 mean;
    for (std::size_t j = 0; j < k; ++j) mean += near[j] / static_cast<double>(k);
    double weight = 0;
    for (std::size_t j = 0; j < k; ++j) weight += squared_length(near[j] - mean) / static_cast<double>(k);
    sites.emplace_back(mean, weight);
  }
  const TriangleMesh& mesh = run->result->mesh;
  double most = 0;
  constexpr int steps = 8;
  for (const auto& t : mesh.triangles)
    for (int a = 0; a <= steps; ++a)
      for (int b = 0; a + b <= steps; ++b) {
        const Vec3 p = mesh.points[t[0]] + (mesh.points[t[1]] - mesh.points[t[0]]) * (a / double{steps}) +
                       (mesh.points[t[2]] - mesh.points[t[0]]) * (b / double{steps});
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [center, weight] : sites)
          least = std::min(least, squared_length(p - center) + weight);
        most = std::max(most, std::sqrt(least));
      }
  CHECK(most <= run->scene->delta * (1 + 1e-9));
  CHECK(most > 0.5 * run->scene->delta);
}

TEST_CASE("known answers of full size, to the end" * doctest::test_suite("soak")) {
  const auto finish = [](CompleteRun& run) {
    run.parameters.until = Stage::improve;
    run.parameters.effort = 0;
    if (!run.run()) FAIL(run.error->line());
    for (const std::string& failure : run.result->certificate.failures) MESSAGE(failure);
    CHECK(run.result->certificate.holds());
    CHECK(run.result->certificate.components == 1);
    return run.result->certificate.euler_characteristic;
  };
  Random random(8);
  SUBCASE("a sphere of 20,000 points with 1 % of noise and 5 % of outliers") {
    std::vector<Vec3> points = sphere_points(random, 20000, 1, 0.02);
    add_outliers(random, points, 1000, around);
    const auto run = run_of(std::move(points));
    CHECK(finish(*run) == 2);
    CHECK(deep_regions(*run->scene) == 2);
  }
  const auto noisy = [&](const char* name, std::size_t n, double share) -> std::optional<std::vector<Vec3>> {
    const auto file = demo_model(name);
    if (!file) return {};
    const auto soup = read_mesh(*file);
    REQUIRE(soup.ok());
    return surface_points(random, *soup, n, share * soup->bounds().longest_edge());
  };
  SUBCASE("elephant, 0.5 % of noise") {
    if (auto points = noisy("elephant.off", 40000, 0.005)) finish(*run_of(*std::move(points)));
  }
  // The ears are thinner than the noise. At 2.6 % what is left of an inside there leads outside through a
  // passage that the octree's main cells do not show.
  SUBCASE("elephant, 1 % of noise") {
    for (const Tolerance tolerance : {Tolerance{.automatic = true}, Tolerance{.value = 2.6}}) {
      auto points = noisy("elephant.off", 40000, 0.01);
      if (!points) continue;
      const auto run = run_of(*std::move(points), tolerance);
      CHECK(finish(*run) == 2);
      CHECK(run->result->points->kept.percentile_90 > 2 * run->scene->delta);
    }
  }
  SUBCASE("knot, 0.5 % of noise") {
    if (auto points = noisy("knot1.off", 40000, 0.005)) CHECK(finish(*run_of(*std::move(points))) == 0);
  }
}
