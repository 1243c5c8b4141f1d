// Calls the peer, then measures both distances and looks for intersections.
#include "bench/peer.h"

#include "bench/alpha_wrap.h"
#include "bench/lindstrom_turk.h"
#include "bench/meshoptimizer.h"

#include "tolerance/self_intersections.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <ctime>
#include <utility>

namespace isoscope::bench {

namespace {

/// Of the bounds of distances, as a share of the longest edge.
constexpr double precision = 1e-4;

constexpr std::array<const char*, 5> names{"lindstrom-turk", "certificate", "envelope", "meshoptimizer",
                                           "alpha-wrap"};

Result<TriangleMesh> mesh_of(Result<Simplified> simplified) {
  if (!simplified) return simplified.error();
  return std::move(simplified->mesh);
}

Result<TriangleMesh> simplify(const TriangleSoup& input, const Asked& asked, double delta) {
  switch (asked.peer) {
  case Peer::lindstrom_turk:
    return mesh_of(lindstrom_turk_to(input, *asked.vertices));
  case Peer::certificate:
    return mesh_of(lindstrom_turk(input, delta, CollapseFilter::certificate));
  case Peer::envelope:
    return mesh_of(lindstrom_turk(input, delta, CollapseFilter::envelope));
  case Peer::meshoptimizer:
    return meshoptimizer(input, delta);
  case Peer::alpha_wrap:
    return alpha_wrap(input, delta);
  }
  return Error{ErrorCode::internal, "There is no such peer.", ""};
}

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

} // namespace

std::optional<Peer> peer_of(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return static_cast<Peer>(found - names.begin());
}

std::vector<std::string> peer_names() {
  return {names.begin(), names.end()};
}

Result<PeerResult> ask_peer(const TriangleSoup& input, const Asked& asked) {
  const bool counts = asked.peer == Peer::lindstrom_turk;
  if (counts != asked.vertices.has_value() || counts == asked.tolerance.has_value())
    return Error{ErrorCode::usage,
                 counts ? "This peer takes a number of vertices and no tolerance."
                        : "This peer takes a tolerance and no number of vertices.",
                 counts ? "Give --vertices." : "Give --tolerance."};
  if (asked.tolerance && asked.tolerance->automatic)
    return Error{ErrorCode::usage, "A peer finds no tolerance of its own.", "Give a percentage or a length."};
  PeerResult result;
  result.longest_edge = input.bounds().longest_edge();
  const double began = cpu_seconds();
  auto mesh = simplify(input, asked, asked.tolerance ? asked.tolerance->absolute(result.longest_edge) : 0);
  if (!mesh) return mesh.error();
  result.cpu_seconds = cpu_seconds() - began;
  result.mesh = std::move(*mesh);

  const auto crossings = self_intersections(
      result.mesh.points, result.mesh.triangles, [] { return false; }, 1);
  result.intersects_itself = !crossings->empty();
  const ClosestPointIndex from(TriangleSoup{result.mesh.points, result.mesh.triangles, {}}), to(input);
  const RunControl control;
  result.output_distance = bound_distance(from, to, precision * result.longest_edge, control);
  result.input_distance = bound_distance(to, from, precision * result.longest_edge, control);
  return result;
}

std::string json_line(const PeerResult& result) {
  const nlohmann::json json{
      {"vertices", result.mesh.points.size()},         {"faces", result.mesh.triangles.size()},
      {"intersects_itself", result.intersects_itself}, {"cpu_seconds", result.cpu_seconds},
      {"longest_edge", result.longest_edge},           {"output_distance", result.output_distance.upper},
      {"input_distance", result.input_distance.upper}};
  return json.dump();
}

} // namespace isoscope::bench
