// Sorts the walls at an edge by angle, and asks the octree between each and the next.
#include "tolerance/room_contacts.h"

#include "base/parallel.h"
#include "tolerance/regions.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>

namespace isoscope {
namespace {

constexpr std::size_t fewest_walls = 4, edge_grain = 16;
/// Between two walls the place is asked that would be δ' from both. Where it is not so far from all walls, by
/// this share, Ω leaves nothing of the corner; nor is it asked farther from the edge than so many δ'.
constexpr double room_enough = 0.9, farthest = 3;
/// Where along an edge: other walls are near to its ends.
constexpr std::array stations{0.5, 0.0, 1.0};

/// From an end of an edge to the corner of a triangle across from it; nothing where it is collapsed.
Vec3 away_from_edge(const WeldedMesh& mesh, const EdgeUse& use) {
  for (const std::uint32_t p : mesh.triangles[use.triangle])
    if (p != use.low && p != use.high) return mesh.points[p] - mesh.points[use.low];
  return {};
}

/// The label of the cell that holds p, 0 where it has none.
int basin_at(const ToleranceVolume& volume, Vec3 p) {
  const Regions::CellIndex leaf = volume.octree().locate_among(p, volume.basins().size());
  return leaf == Regions::none ? 0 : volume.basins()[leaf];
}

/// By label, between how many pairs of neighbouring walls, which leave an edge at these angles around `at`,
/// of u and v; nothing where one is not told.
std::optional<std::map<int, int>> labels_between(const ToleranceVolume& volume,
                                                 std::span<const double> angles, Vec3 at, Vec3 u, Vec3 v) {
  const double boundary = volume.thresholds().boundary;
  std::map<int, int> times;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + 2 * std::numbers::pi;
    const double half = 0.5 * (next - angles[i]), middle = angles[i] + half;
    const double sine = half < std::numbers::pi / 2 ? std::sin(half) : 1;
    if (sine * farthest < 1) return {};
    const Vec3 p = at + (boundary / sine) * (std::cos(middle) * u + std::sin(middle) * v);
    if (volume.index().distance(p) < room_enough * boundary) return {};
    const int label = basin_at(volume, p);
    if (label == 0) return {};
    ++times[label];
  }
  return times;
}

/// The room that lies between one pair of walls only, where another lies between more.
std::optional<int> room_at_edge(const ToleranceVolume& volume, const WeldedMesh& mesh,
                                std::span<const EdgeUse> uses) {
  const Vec3 a = mesh.points[uses.front().low], b = mesh.points[uses.front().high];
  const Vec3 along = normalized(b - a), first = away_from_edge(mesh, uses.front());
  const Vec3 u = normalized(first - dot(first, along) * along), v = cross(along, u);
  if (u == Vec3{}) return {};
  std::vector<double> angles; // of each wall
  for (const EdgeUse& use : uses) {
    const Vec3 away = away_from_edge(mesh, use);
    angles.push_back(std::atan2(dot(away, v), dot(away, u)));
  }
  std::sort(angles.begin(), angles.end());
  for (const double station : stations) {
    const auto times = labels_between(volume, angles, a + station * (b - a), u, v);
    if (!times) continue;
    const auto first_of = [&](const auto& wanted) {
      return std::find_if(times->begin(), times->end(), wanted);
    };
    if (first_of([](const auto& t) { return t.second > 1; }) == times->end()) return {};
    const auto single = first_of([](const auto& t) { return t.second == 1; }); // the innermost comes first
    return single == times->end() ? std::nullopt : std::optional(single->first);
  }
  return {};
}

} // namespace

std::vector<RoomContact> room_contacts(const ToleranceVolume& volume, const RunControl& control) {
  if (!volume.has_rooms() || volume.basins().empty()) return {};
  const WeldedMesh mesh = weld(volume.index());
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  std::vector<std::span<const EdgeUse>> edges;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i >= fewest_walls) edges.push_back(std::span(uses).subspan(i, end - i));
  }
  std::vector<std::optional<int>> rooms(edges.size());
  parallel_until(edges.size(), edge_grain, control,
                 [&](std::size_t i) { rooms[i] = room_at_edge(volume, mesh, edges[i]); });
  std::vector<RoomContact> contacts;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!rooms[i]) continue;
    const EdgeUse& edge = edges[i].front();
    contacts.push_back({{mesh.points[edge.low], mesh.points[edge.high]}, *rooms[i]});
  }
  return contacts;
}

} // namespace isoscope
