// Whole runs on rooms that share walls (§4.2), from soups and from segmentations.
#include "base/disjoint_sets.h"
#include "input/gallery.h"
#include "input/label_walls.h"
#include "input/mesh_io.h"
#include "journal/playback.h"
#include "mesh/validity.h"
#include "mesh/zero_set.h"
#include "run/complete_run.h"
#include "run/report.h"
#include "run/room_soups.h"
#include "run/statistics.h"
#include "tolerance/grid_sides.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::unique_ptr<CompleteRun> run_rooms(TriangleSoup soup, double percent,
                                       SidesMode sides = SidesMode::automatic, Stage until = Stage::all) {
  RunParameters parameters;
  parameters.input = "soup";
  parameters.tolerance = {percent, true};
  parameters.sides = sides;
  parameters.until = until;
  auto run = std::make_unique<CompleteRun>(parameters);
  run->soup = std::make_shared<const TriangleSoup>(std::move(soup));
  run->run();
  return run;
}

/// The edges of a mesh on other than two facets.
struct Curves {
  std::size_t components = 0;
  std::map<std::size_t, std::size_t> edge_facets, vertex_edges; ///< how many of each number
};
Curves curves_of(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> facets;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++facets[std::minmax(t[k], t[(k + 1) % 3])];
  Curves curves;
  std::map<std::uint32_t, std::size_t> degree;
  DisjointSets sets(mesh.points.size());
  for (const auto& [edge, count] : facets) {
    if (count == 2) continue;
    ++curves.edge_facets[count];
    ++degree[edge.first];
    ++degree[edge.second];
    sets.unite(edge.first, edge.second);
  }
  for (const auto& [v, count] : degree) {
    ++curves.vertex_edges[count];
    curves.components += sets.find(v) == v ? 1 : 0;
  }
  return curves;
}

void check_rooms(const CompleteRun& run, std::size_t rooms, long euler_characteristic,
                 std::size_t components = 1) {
  REQUIRE_MESSAGE(run.result.has_value(), (run.error ? run.error->line() : ""));
  const Certificate& c = run.result->certificate;
  CHECK_MESSAGE(c.holds(), (c.failures.empty() ? "" : c.failures.front()));
  CHECK(c.components == components);
  CHECK(c.euler_characteristic == euler_characteristic);
  CHECK(c.topology == Certificate::Topology::as_expected);
  REQUIRE(c.regions.size() == rooms + 1);
  for (const RegionCertificate& r : c.regions) {
    CHECK(r.closed_manifold);
    CHECK(r.oriented);
    CHECK((r.label > 0) == (r.volume < 0));
  }
  const Complex replay = replayed(*run.journal);
  CHECK(check_complex(replay).empty());
  CHECK(triangulate(extract_zero_set(replay)).triangles == run.result->mesh.triangles);
}

/// A ball in a segmentation, one label above its middle and another below.
ScalarGrid two_halves(std::size_t n) {
  ScalarGrid grid;
  grid.name = "halves";
  grid.size = {n, n, n};
  const double middle = 0.5 * static_cast<double>(n - 1), radius = 0.4 * static_cast<double>(n);
  for (std::size_t z = 0; z < n; ++z)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x) {
        const bool in = distance(grid.point(x, y, z), {middle, middle, middle}) < radius;
        grid.values.push_back(!in ? 0.0F : 2 * z < n ? 3.0F : 7.0F);
      }
  return grid;
}

/// A block of a segmentation, and the label of its voxels.
struct Block {
  std::array<std::size_t, 3> at;
  int label;
};

/// The walls of such blocks, each of so many voxels along an axis.
TriangleSoup walls_of(const std::vector<Block>& blocks, std::size_t voxels) {
  std::map<std::array<std::size_t, 3>, int> labels;
  std::array<std::size_t, 3> most{};
  for (const Block& b : blocks) {
    labels[b.at] = b.label;
    for (std::size_t k = 0; k < 3; ++k) most[k] = std::max(most[k], b.at[k] + 1);
  }
  ScalarGrid grid;
  grid.name = "blocks";
  grid.size = {most[0] * voxels, most[1] * voxels, most[2] * voxels};
  for (std::size_t z = 0; z < grid.size[2]; ++z)
    for (std::size_t y = 0; y < grid.size[1]; ++y)
      for (std::size_t x = 0; x < grid.size[0]; ++x) {
        const auto found = labels.find({x / voxels, y / voxels, z / voxels});
        grid.values.push_back(found == labels.end() ? 0.0F : static_cast<float>(found->second));
      }
  auto walls = walls_between_labels(grid);
  REQUIRE(walls.ok());
  return std::move(*walls);
}

} // namespace

TEST_CASE("rooms have the Euler characteristic of their walls, and sheets meet in curves and points") {
  struct Known {
    TriangleSoup soup;
    std::size_t rooms;
    long euler_characteristic;
    std::size_t points;        ///< where four labels meet
    std::size_t most_vertices; ///< after the last stage
  };
  const std::vector<Known> known{{cubes(2, 1, 1), 2, 3, 0, 20},
                                 {three_in_t(), 3, 4, 2, 32},
                                 {cubes(2, 2, 1), 4, 5, 0, 55},
                                 {sphere_with_disc(), 2, 3, 0, 55}};
  for (const Known& k : known) {
    CAPTURE(k.rooms);
    CAPTURE(k.euler_characteristic);
    const auto run = run_rooms(k.soup, 4);
    check_rooms(*run, k.rooms, k.euler_characteristic);
    CHECK(run->result->last_stage == Stage::all);
    CHECK(run->result->mesh.points.size() <= k.most_vertices);
    const Curves curves = curves_of(run->result->mesh);
    CHECK(curves.components == 1);
    for (const auto& [facets, count] : curves.edge_facets) CHECK(facets == 3);
    for (const auto& [edges, count] : curves.vertex_edges) CHECK((edges == 2 || edges == 4));
    if (k.rooms == 2) CHECK(curves.vertex_edges.size() == 1); // one closed curve
    if (k.points > 0) CHECK(curves.vertex_edges.at(4) == k.points);
  }
}

TEST_CASE("on Z alone boxes come down to their corners") {
  struct Known {
    TriangleSoup soup;
    double percent;
    std::size_t rooms;
    long euler_characteristic;
    std::size_t vertices; ///< the least there are, or few
    bool boxes = true;
  };
  const std::vector<Known> known{{cubes(2, 1, 1), 4, 2, 3, 12},
                                 {three_in_t(), 4, 3, 4, 18},
                                 {cubes(2, 2, 1), 4, 4, 5, 18},
                                 {cubes(2, 2, 2), 4, 8, 9, 27},
                                 {sphere_with_disc(), 4, 2, 3, 30, false}};
  for (const Known& k : known) {
    CAPTURE(k.rooms);
    CAPTURE(k.euler_characteristic);
    const auto run = run_rooms(k.soup, k.percent, SidesMode::automatic, Stage::improve);
    check_rooms(*run, k.rooms, k.euler_characteristic);
    CHECK(run->result->form == ZeroForm::free);
    CHECK(run->result->mesh.labels.size() == run->result->mesh.triangles.size());
    CHECK(run->result->mesh.points.size() <= k.vertices);
    CHECK(curves_of(run->result->mesh).components == 1);
    if (!k.boxes) continue;
    // No wall has slid along another.
    for (const Vec3 corner : k.soup.points) {
      double nearest = Box3::inf;
      for (const Vec3 p : run->result->mesh.points) nearest = std::min(nearest, distance(p, corner));
      CHECK(nearest <= 4 * run->scene->delta);
    }
  }
}

TEST_CASE("eight rooms") {
  check_rooms(*run_rooms(cubes(2, 2, 2), 6), 8, 9);
}

TEST_CASE("closed surfaces that cross are one inside, or several where that is asked for") {
  TriangleSoup soup = make_sphere(3), other = make_sphere(3);
  for (Vec3& p : other.points) p = p + Vec3{0.9, 0.2, 0.1};
  append(soup, other);
  check_rooms(*run_rooms(soup, 4, SidesMode::multi), 3, 4);

  const auto united = run_rooms(soup, 4);
  REQUIRE(united->result.has_value());
  CHECK(united->result->certificate.regions.empty());
  CHECK(united->result->mesh.labels.empty());
  CHECK(united->result->certificate.euler_characteristic == 2);
}

TEST_CASE("parts that share no wall are what they were, asked for rooms or not") {
  TriangleSoup soup;
  for (const double x : {0.0, 2.0}) add_walls(soup, {x, 0, 0}, {x + 1, 1, 1});
  const auto plain = run_rooms(soup, 3), asked = run_rooms(soup, 3, SidesMode::multi);
  REQUIRE(plain->result.has_value());
  REQUIRE(asked->result.has_value());
  CHECK(digest(*plain->journal) == digest(*asked->journal));
  CHECK(asked->result->certificate.regions.empty());
}

TEST_CASE("fins are refused with their place") {
  TriangleSoup rooms = cubes(2, 1, 1);
  add_square(rooms, {1.5, 0.2, 1}, {0, 0.6, 0}, {0, 0, 0.6});
  const auto run = run_rooms(rooms, 4);
  REQUIRE(run->error.has_value());
  CHECK(run->error->code == ErrorCode::joined_sheets);
  CHECK_MESSAGE(run->error->message.find("(1.5, 0.") != std::string::npos, run->error->message);
  CHECK_MESSAGE(run->error->remedy.find("No tolerance up to 50%") != std::string::npos, run->error->remedy);

  TriangleSoup cube = cubes(1, 1, 1);
  add_square(cube, {0.5, 0.2, 1}, {0, 0.6, 0}, {0, 0, 0.6});
  const auto single = run_rooms(cube, 4);
  REQUIRE(single->error.has_value());
  CHECK(single->error->code == ErrorCode::joined_sheets);
  CHECK_MESSAGE(single->error->message.find("(0.5, 0.") != std::string::npos, single->error->message);

  // Among many small walls a fin counts for little.
  TriangleSoup fine = cubes(2, 1, 1);
  for (int i = 0; i < 3; ++i) fine = in_four(fine);
  add_square(fine, {1.5, 0.2, 1}, {0, 0.6, 0}, {0, 0, 0.6});
  const auto small = run_rooms(fine, 4);
  REQUIRE(small->error.has_value());
  CHECK(small->error->code == ErrorCode::joined_sheets);
  CHECK_MESSAGE(small->error->message.find("(1.5, 0.") != std::string::npos, small->error->message);
}

TEST_CASE("a segmentation gives the walls between its labels") {
  const auto walls = walls_between_labels(two_halves(20));
  REQUIRE(walls.ok());
  const auto run = run_rooms(*walls, 6, SidesMode::multi);
  check_rooms(*run, 2, 3);

  ScalarGrid empty = two_halves(6);
  std::fill(empty.values.begin(), empty.values.end(), 0.0F);
  CHECK_FALSE(walls_between_labels(empty).ok());
  // A label that reaches the border of the grid is closed there.
  std::fill(empty.values.begin(), empty.values.end(), 5.0F);
  const auto block = walls_between_labels(empty);
  REQUIRE(block.ok());
  CHECK(block->triangles.size() == 6 * 6 * 6 * 2);
  CHECK(block->bounds().lo == Vec3{-0.5, -0.5, -0.5});
}

TEST_CASE("rooms that touch along an edge share a wall there, and what is around does not join itself") {
  // Two that touch, and a third on top of one of them.
  const std::vector<Block> stairs{{{0, 0, 0}, 1}, {{1, 1, 0}, 2}, {{0, 0, 1}, 3}};
  // Another one around two that touch.
  const std::vector<Block> within{{{0, 0, 0}, 1}, {{1, 1, 0}, 2}, {{0, 1, 0}, 3}, {{1, 0, 0}, 3},
                                  {{0, 0, 1}, 3}, {{1, 0, 1}, 3}, {{0, 1, 1}, 3}, {{1, 1, 1}, 3}};
  // Two pairs, one above the other.
  const std::vector<Block> pairs{{{0, 0, 0}, 1}, {{1, 1, 0}, 2}, {{0, 0, 1}, 3}, {{1, 1, 1}, 4}};
  check_rooms(*run_rooms(walls_of(stairs, 4), 7.5, SidesMode::multi), 3, 4);
  check_rooms(*run_rooms(walls_of(within, 4), 7.5, SidesMode::multi), 3, 4);
  check_rooms(*run_rooms(walls_of(pairs, 4), 7.5, SidesMode::multi), 4, 5);
}

TEST_CASE("a room that Ω leaves nothing of is refused with the tolerance that keeps it") {
  std::vector<Block> blocks;
  for (std::size_t x = 0; x < 10; ++x)
    for (std::size_t y = 0; y < 5; ++y)
      for (std::size_t z = 0; z < 5; ++z) blocks.push_back({{x, y, z}, x < 5 ? 1 : 2});
  blocks.push_back({{2, 2, 2}, 3}); // later ones count
  const TriangleSoup walls = walls_of(blocks, 1);
  const auto refused = run_rooms(walls, 5, SidesMode::multi, Stage::refinement);
  REQUIRE(refused->error.has_value());
  const std::string& message = refused->error->message;
  CHECK_MESSAGE(message.starts_with("A room of the input is thinner than 2.6 times the tolerance"), message);
  CHECK_MESSAGE(message.find(", at most 1 (2 δ): what is around takes it.") != std::string::npos, message);
  const std::string& remedy = refused->error->remedy;
  CHECK_MESSAGE(remedy.starts_with("Choose a tolerance of at most 0.34 "), remedy);
  CHECK(run_rooms(walls, 3.4, SidesMode::multi, Stage::refinement)->result.has_value());
}

TEST_CASE("all labels of a grid are asked for, or one") {
  RunParameters parameters;
  parameters.input = "labels.nrrd";
  parameters.sides = SidesMode::multi;
  CHECK(check(parameters).ok());
  parameters.label = 2;
  const Status both = check(parameters);
  REQUIRE_FALSE(both.ok());
  CHECK(both.error().code == ErrorCode::usage);
  CHECK(both.error().message.find("--label") != std::string::npos);
}

TEST_CASE("the report tells every region") {
  const auto run = run_rooms(cubes(2, 1, 1), 6);
  REQUIRE(run->result.has_value());
  const auto json = nlohmann::json::parse(
      report_json(run->parameters, *run->scene, *run->result, gather_statistics(*run->journal)));
  const auto& regions = json["output"]["regions"];
  REQUIRE(regions.size() == 3);
  CHECK(regions[0]["label"] == 1);
  CHECK(regions[2]["label"] == -2);
  for (const auto& r : regions) CHECK(r["euler_characteristic"] == 2);
  CHECK(json["output"]["genus"].is_null());
  CHECK(json["input"]["sides_by"] == "rooms");
  CHECK(regions[1]["places"].size() == 1);
}

TEST_CASE("any step of a run between rooms is reached both ways") {
  const auto run = run_rooms(cubes(2, 1, 1), 8);
  REQUIRE(run->result.has_value());
  Playback playback(run->journal);
  const Step last = run->journal->steps();
  playback.seek(last);
  const Complex end = playback.complex();
  playback.seek(last / 2);
  const Complex middle = playback.complex();
  playback.seek(0);
  playback.seek(last / 2);
  CHECK(playback.complex() == middle);
  playback.seek(last);
  CHECK(playback.complex() == end);
}

TEST_CASE("A picture's bricks have all of a room on its inner side") {
  const auto bubbles = make_gallery_model("bubbles");
  REQUIRE(bubbles.ok());
  RunParameters parameters;
  parameters.input = "soup";
  parameters.tolerance = {4, true};
  CompleteRun run(parameters);
  run.soup = std::make_shared<const TriangleSoup>(*bubbles);
  REQUIRE(run.prepare());
  const Scene& scene = *run.scene;
  REQUIRE(scene.volume->sides().rule() == SideRule::rooms);
  GridWish wish;
  wish.delta = scene.delta;
  wish.voxel = 0.25 * scene.delta;
  auto grid = make_distance_grid(*scene.field, wish, {});
  REQUIRE(grid.ok());
  REQUIRE(find_sides(*grid, {*scene.field, scene.volume->sides(), scene.delta, scene.regions}, {}).ok());
  testing::Random random(4);
  std::size_t rooms = 0;
  for (const Region& region : scene.regions) {
    if (region.unbounded) continue;
    ++rooms;
    // Nothing of the input is in this ball.
    const double reach = 0.9 * region.depth;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = region.deepest + reach * random.unit() * random.direction();
      if (!(grid->signed_value(p) < 0)) FAIL_CHECK("a place of room " << region.label << " is outside");
    }
  }
  CHECK(rooms == 4);
}
