// Whole runs between two surfaces and between two levels: closed, inside, of the known topology, with few
// vertices; and what is refused.
#include "input/gallery_shapes.h"
#include "run/complete_run.h"
#include "run/replay_check.h"
#include "tolerance/exact_position.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

TriangleSoup scaled(TriangleSoup soup, double by) {
  for (Vec3& p : soup.points) p = by * p;
  return soup;
}

TriangleSoup cube() {
  TriangleSoup soup;
  for (unsigned k = 0; k < 8; ++k)
    soup.points.push_back({k & 1u ? 1. : -1., k & 2u ? 1. : -1., k & 4u ? 1. : -1.});
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return soup;
}

std::shared_ptr<const TriangleSoup> walls(TriangleSoup outer, const TriangleSoup& inner) {
  outer.outer_triangles = outer.triangles.size();
  append(outer, inner);
  return std::make_shared<const TriangleSoup>(std::move(outer));
}

/// Runs to the end; the certificate holds, and the facets meet no wall by a test of its own.
void check_run(CompleteRun& run, long euler_characteristic, std::size_t most_vertices) {
  const bool ended = run.run();
  CAPTURE(run.error ? run.error->line() : std::string());
  REQUIRE(ended);
  const Certificate& c = run.result->certificate;
  CAPTURE(c.failures.empty() ? std::string() : c.failures.front());
  CHECK(c.holds());
  CHECK(c.euler_characteristic == euler_characteristic);
  CHECK(c.topology == Certificate::Topology::as_expected);
  CHECK(run.result->mesh.points.size() <= most_vertices);
  CHECK(run.result->exit_status() == 0);
}

/// No facet of the result meets a wall, and its vertices are inside the outer one and not inside the inner.
void check_between(const CompleteRun& run, const TriangleSoup& soup) {
  const TriangleMesh& mesh = run.result->mesh;
  for (const auto& t : mesh.triangles)
    for (std::size_t w = 0; w < soup.triangles.size(); ++w)
      REQUIRE_FALSE(
          triangles_meet({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, soup.triangle(w)));
  const ClosestPointIndex index(soup);
  for (const Vec3 p : mesh.points) {
    const auto crossed = crossed_on_the_way_out(p, index);
    REQUIRE(crossed.has_value());
    CHECK(crossed->size() % 2 == 1);
  }
}

std::shared_ptr<const TriangleSoup> grid_of(std::size_t n, double half, double (*value)(Vec3)) {
  auto grid = std::make_shared<ScalarGrid>();
  grid->size = {n, n, n};
  grid->spacing = Vec3{1, 1, 1} * (2 * half / static_cast<double>(n - 1));
  grid->origin = {-half, -half, -half};
  for (std::size_t z = 0; z < n; ++z)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x)
        grid->values.push_back(static_cast<float>(value(grid->point(x, y, z))));
  auto soup = std::make_shared<TriangleSoup>();
  soup->grid = std::move(grid);
  return soup;
}

/// Every point of the result, densely looked at, has a value between the levels.
void check_values(const CompleteRun& run, double (*value)(Vec3), double low, double high) {
  const TriangleMesh& mesh = run.result->mesh;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; i + j <= 20; ++j) {
        const Vec3 p = mesh.points[t[0]] + (i / 20.0) * (mesh.points[t[1]] - mesh.points[t[0]]) +
                       (j / 20.0) * (mesh.points[t[2]] - mesh.points[t[0]]);
        REQUIRE(value(p) > low);
        REQUIRE(value(p) < high);
      }
}

RunParameters with_levels(double low, double high) {
  RunParameters parameters;
  parameters.levels = {low, high};
  return parameters;
}

double radius(Vec3 p) {
  return length(p);
}

} // namespace

TEST_CASE("between spheres of radius 1 and 0.8") {
  // A covering of the sphere by 14 caps of 34.9° is known, and none by 13 of less than acos(0.8) = 36.9°:
  // with all vertices on the outer sphere 14 are the fewest.
  CompleteRun run(RunParameters{});
  run.soup = walls(make_sphere(3), scaled(make_sphere(3), 0.8));
  check_run(run, 2, 20);
  CHECK(run.scene->delta == doctest::Approx(0.097).epsilon(0.03));
  CHECK(run.scene->regions.size() == 2);
  check_between(run, *run.soup);
}

TEST_CASE("between a sphere and the cube around it, and between tori") {
  CompleteRun boxed(RunParameters{});
  boxed.soup = walls(cube(), scaled(make_sphere(3), 0.8));
  check_run(boxed, 2, 12); // a smaller cube has 8
  check_between(boxed, *boxed.soup);
  CompleteRun ring(complete_parameters("nested-tori"));
  check_run(ring, 0, 30); // no torus has fewer than 7, and a ring of 3 triangles 9
}

TEST_CASE("between the levels of grids") {
  CompleteRun ball(with_levels(0.8, 1));
  ball.soup = grid_of(40, 1.3, radius);
  check_run(ball, 2, 24);
  check_values(ball, radius, 0.799, 1.001); // a trilinear function differs from the radius by less
  CompleteRun beads(complete_parameters("density"));
  check_run(beads, 0, 90);
  // A ball of label 2, of radius 12 voxels.
  RunParameters of_label;
  of_label.label = 2;
  of_label.levels = {-1.5, 1.5};
  of_label.effort = 0;
  CompleteRun segmented(of_label);
  segmented.soup = grid_of(32, 16, [](Vec3 p) { return length(p) < 12 ? 2.0 : length(p) < 14 ? 1.0 : 0.0; });
  check_run(segmented, 2, 300);
}

TEST_CASE("in sampled mode the samples alone hold Z between walls and levels") {
  const auto check = [](RunParameters parameters, std::shared_ptr<const TriangleSoup> soup) {
    parameters.containment = Containment::sampled;
    parameters.sigma = 0.3;
    parameters.until = Stage::refinement;
    CompleteRun run(std::move(parameters));
    run.soup = std::move(soup);
    if (!run.run()) FAIL(run.error->line());
    CHECK(run.scene->thresholds.boundary == run.scene->delta);
    CHECK(run.result->certificate.euler_characteristic == 2);
    CHECK(run.result->certificate.components == 1);
    CHECK(run.result->certificate.intersection_free);
    CHECK(run.result->certificate.separates);
  };
  check({}, walls(make_sphere(2), scaled(make_sphere(2), 0.6)));
  check(with_levels(0.6, 1), grid_of(24, 1.3, radius));
}

TEST_CASE("runs between walls and levels replay") {
  for (const char* name : {"nested-tori", "density"}) {
    CAPTURE(name);
    RunParameters parameters = complete_parameters(name);
    parameters.until = Stage::zero_set;
    CompleteRun run(parameters);
    REQUIRE(run.run());
    RunControl control;
    const auto verdict = check_replay(run.parameters, run.scene->input, *run.journal, true, control);
    REQUIRE(verdict.ok());
    CAPTURE(verdict->difference);
    CHECK(verdict->same);
    CHECK(verdict->to_the_end);
  }
}

TEST_CASE("what does not fit the input is said") {
  const auto refused = [](RunParameters p, std::shared_ptr<const TriangleSoup> soup, ErrorCode code,
                          std::string_view words) {
    CompleteRun run(std::move(p));
    run.soup = std::move(soup);
    REQUIRE_FALSE(run.prepare());
    const std::string line = run.error->line();
    CAPTURE(line);
    CHECK(run.error->code == code);
    CHECK(line.find(words) != std::string::npos);
  };
  const auto sphere = std::make_shared<const TriangleSoup>(make_sphere(2));
  const auto grid = grid_of(16, 1.3, radius);
  RunParameters labelled, small;
  labelled.label = 7;
  small.drop_small = 2;
  refused({}, grid, ErrorCode::usage, "--levels LO HI");
  refused(with_levels(0.5, 1), sphere, ErrorCode::usage, "no grid");
  refused(labelled, sphere, ErrorCode::usage, "no grid");
  refused(labelled, grid, ErrorCode::bad_input, "label 7");
  refused(small, walls(cube(), scaled(*sphere, 0.5)), ErrorCode::usage, "left out");
  refused({}, walls(cube(), *sphere), ErrorCode::bad_input, "touch or cross");
  refused(with_levels(0.9, 1.4), grid, ErrorCode::bad_input, "border");
}
