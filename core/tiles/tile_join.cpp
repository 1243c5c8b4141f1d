// Points and facets are sorted on the disk; proofs are made tile by tile.
#include "tiles/tile_join.h"

#include "base/external_sort.h"
#include "base/memory.h"
#include "base/point_order.h"
#include "base/stopwatch.h"
#include "input/mesh_io.h"
#include "tiles/proof_sum.h"

#include <algorithm>
#include <optional>

namespace isoscope {
namespace {

struct PointOrder {
  bool operator()(Vec3 a, Vec3 b) const { return lies_before(a, b); }
};
struct FacetOrder {
  bool operator()(const Triangle3& a, const Triangle3& b) const { return comes_before(a, b); }
};

/// The number of a point among those that fill a file in their order.
std::uint32_t number_of(Vec3 p, BlockReader& points, std::uint64_t count) {
  std::uint64_t first = 0;
  while (count > 0) {
    const std::uint64_t half = count / 2;
    if (lies_before(points.record<Vec3>(first + half), p))
      first += half + 1, count -= half + 1;
    else
      count = half;
  }
  return static_cast<std::uint32_t>(first);
}

/// Vertices and facets are ascending, whatever tiles they come from.
Status write_joined(const TileFolder& folder, std::uint32_t round, const std::filesystem::path& file) {
  const auto share = static_cast<std::size_t>(folder.manifest().memory / 4);
  ExternalSort<Vec3, PointOrder> corners(share, folder.folder());
  ExternalSort<Triangle3, FacetOrder> facets(share, folder.folder());
  const Status read = folder.each_facet_before(round, [&](const Triangle3& f) {
    for (const Vec3 p : f) corners.add(p);
    facets.add(canonical(f));
  });
  if (!read) return read;
  ScratchFile points(folder.folder());
  std::optional<Vec3> last;
  const Status sorted = corners.each([&](Vec3 p) {
    if (last && *last == p) return;
    last = p;
    points.append(&p, sizeof p);
  });
  if (!sorted) return sorted;
  MeshSource source;
  source.vertices = points.size() / sizeof(Vec3);
  source.facets = facets.size();
  source.each_point = [&](const MeshSource::TakePoint& take) {
    BlockReader reader(points, 0);
    for (std::uint64_t i = 0; i < source.vertices; ++i) take(reader.record<Vec3>(i));
    return points.status();
  };
  source.each_facet = [&](const MeshSource::TakeFacet& take) {
    BlockReader reader(points, share);
    const Status told = facets.each([&](const Triangle3& f) {
      std::array<std::uint32_t, 3> numbers{};
      for (std::size_t k = 0; k < 3; ++k) numbers[k] = number_of(f[k], reader, source.vertices);
      take(numbers, f);
    });
    return told ? points.status() : told;
  };
  return write_mesh(file, source);
}

} // namespace

std::shared_ptr<const Scene> scene_of(const TileFolder& folder) {
  const TileManifest& m = folder.manifest();
  auto scene = std::make_shared<Scene>();
  scene->input_size = {m.vertices, m.triangles};
  scene->held = m.held.size();
  scene->delta = m.delta;
  scene->longest_edge = m.box.grown(-m.delta).longest_edge();
  scene->samples = std::make_shared<const BoundarySamples>();
  InputTopology& topology = scene->input_topology;
  topology.closed_manifold = topology.self_intersection_free = topology.consistently_oriented = true;
  topology.manifold = true;
  topology.side_rule = SideRule::winding;
  topology.euler_characteristic = m.euler_characteristic;
  topology.boundary_loops = 0;
  topology.components = m.components;
  ExpectedTopology& expected = scene->expected;
  if (m.parameters.topology == TopologyMode::separate) {
    expected.source = "separation of the sides only";
    return scene;
  }
  expected.euler_characteristic = m.euler_characteristic;
  expected.components = m.components;
  expected.source = "the input";
  return scene;
}

Result<JoinedTiles> join_tiles(const TileFolder& folder, const std::filesystem::path& mesh,
                               RunControl& control) {
  const Stopwatch watch;
  const auto round = folder.round();
  if (!round) return round.error();
  if (*round)
    return Error{ErrorCode::usage,
                 "Round " + std::to_string((*round)->number) + " has " +
                     std::to_string(folder.pending(**round).size()) + " of " +
                     std::to_string((*round)->tiles.size()) + " tiles left.",
                 "Make them first: isoscope-run tiles step."};
  JoinedTiles joined;
  joined.parameters = folder.manifest().parameters;
  const RunParameters& p = joined.parameters;
  joined.scene = scene_of(folder);
  const double delta = joined.scene->delta;
  auto plan = plan_proof(folder, {p.cover, p.topology == TopologyMode::separate, true});
  if (!plan) return plan.error();
  control.report("mesh", -1);
  if (!mesh.empty())
    if (Status written = write_joined(folder, plan->round, mesh); !written) return written.error();
  ProofSum sum(*plan);
  for (std::size_t i = 0; i < plan->tiles.size(); ++i) {
    control.report("certificate", static_cast<double>(i) / static_cast<double>(plan->tiles.size()));
    auto proof = prove_tile(folder, *plan, plan->tiles[i], control);
    if (!proof) return proof.error();
    sum.add(std::move(*proof));
  }
  if (Status counted = sum.count_sides(folder, control); !counted) return counted.error();
  RunResult& r = joined.result;
  r.streamed = MeshSize{sum.vertices(), sum.facets()};
  r.last_stage = Stage::improve;
  r.form = ZeroForm::free;
  r.certificate = sum.certificate(joined.scene->expected, delta);
  r.crumbs = sum.small_parts(crumb_size * delta);
  r.normals = sum.normals();
  r.seconds = watch.seconds();
  r.peak_memory_bytes = peak_memory_bytes();
  return joined;
}

} // namespace isoscope
