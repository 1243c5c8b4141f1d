// Counts walls between regions, and colours what they part.
#include "tolerance/wall_neighbours.h"

#include "base/parallel.h"
#include "base/solid_angle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <span>
#include <utility>

namespace isoscope {
namespace {

/// Both sides of walls are looked at this far from them, in units of δ', at places about so many δ apart, but
/// at no more of them than this.
constexpr double wall_reach = 1.2, probe_spacing = 2;
constexpr std::size_t most_wall_probes = 100000, most_thinned = 50000, wall_probes_per_task = 256;
/// A few places are mistaken, as segments may run through cracks: so many say nothing where they are less
/// than this share, nor does the share.
constexpr std::size_t few_places = 2;
constexpr double small_share = 0.05;
/// How far from a triangle rays tell its sides, in δ.
constexpr double beside_wall = 1e-4;

/// Places that say that walls part two regions, and that they do not.
struct Votes {
  std::size_t parted = 0, joined = 0;
  std::size_t all() const { return parted + joined; }
  bool parts() const { return parted > joined; }
};
using WallVotes = std::map<std::pair<RegionId, RegionId>, Votes>;

/// So many of them at most, evenly spread over the triangles.
std::vector<WallProbe> thinned(std::vector<WallProbe> probes) {
  const std::size_t stride = probes.size() / most_thinned + 1;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < probes.size(); i += stride) probes[kept++] = probes[i];
  probes.resize(kept);
  return probes;
}

/// How far from a whole number a winding may be: what gaps of soups may take away, and else what holes do
/// that are as wide as Ω closes them.
constexpr std::array<double, 2> clear_windings{0.12, 0.3};

/// What lies on both sides of the walls, at places spread over them.
struct Survey {
  std::vector<WallProbe> probes;
  std::vector<WallNeighbours> found;

  Survey(const ToleranceVolume& volume, const RunControl& control)
      : probes(thinned(probes_on_walls(volume))), found(probes.size()) {
    parallel_until(probes.size(), wall_probes_per_task, control,
                   [&](std::size_t i) { found[i] = neighbours_of_wall(volume, probes[i]); });
  }
  bool has_fins() const {
    return std::any_of(found.begin(), found.end(), [](const auto& n) { return n.ends_in_the_open(); });
  }
  WallVotes votes() const {
    WallVotes votes;
    for (const WallNeighbours& n : found) {
      if (!n.told()) continue;
      Votes& between = votes[std::minmax(n.regions[0], n.regions[1])];
      ++(n.parted ? between.parted : between.joined);
    }
    return votes;
  }
};

/// How the triangles of a soup have to turn so that the inside is behind them, as rays from both sides of
/// each tell.
std::vector<std::int8_t> turns_by_rays(const ToleranceVolume& volume, const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  std::vector<std::int8_t> turns(index.size(), 1);
  parallel_until(index.size(), wall_probes_per_task, control, [&](std::size_t i) {
    const Triangle3& t = index.triangle(TriangleId(i));
    const Vec3 off = beside_wall * volume.thresholds().delta * normalized(area_vector(t));
    if (volume.sides().inside(centroid(t) + off) && !volume.sides().inside(centroid(t) - off)) turns[i] = -1;
  });
  return turns;
}

/// Whether the soup winds clearly, up to so much, with its triangles turned as these angles have them.
bool winds_clearly(const ToleranceVolume& volume, const SolidAngles& angles, double clear,
                   const Survey& survey, const RunControl& control) {
  std::vector<long> of_region;
  for (const Region& r : volume.regions()) {
    const auto winding = r.unbounded ? 0 : whole_winding(angles.winding(r.deepest), clear);
    if (!winding) return false;
    of_region.push_back(*winding);
  }
  if (std::all_of(of_region.begin(), of_region.end(), [](long w) { return w == 0; })) return false;
  // A wall between two regions of one side is one between rooms.
  for (const auto& [pair, between] : survey.votes())
    if (pair.first != pair.second && between.parts() && between.parted > few_places &&
        (of_region[pair.first.index()] - of_region[pair.second.index()]) % 2 == 0)
      return false;
  std::vector<std::uint8_t> mistaken(survey.probes.size(), 0);
  parallel_until(mistaken.size(), wall_probes_per_task, control, [&](std::size_t i) {
    const WallNeighbours& n = survey.found[i];
    mistaken[i] = n.ends_in_the_open();
    for (std::size_t k = 0; k < 2 && n.told() && mistaken[i] == 0; ++k)
      mistaken[i] = whole_winding(angles.winding(n.places[k]), clear) != of_region[n.regions[k].index()];
  });
  std::vector<std::size_t> all(volume.volume_component_count()), wrong(all.size());
  for (std::size_t i = 0; i < mistaken.size(); ++i) {
    const std::uint32_t c = volume.volume_component(survey.probes[i].triangle);
    all[c] += survey.found[i].told();
    wrong[c] += mistaken[i];
  }
  for (std::size_t c = 0; c < all.size(); ++c)
    if (static_cast<double>(wrong[c]) > small_share * static_cast<double>(all[c])) return false;
  return true;
}

} // namespace

std::vector<WallProbe> probes_on_walls(const ToleranceVolume& volume) {
  const ClosestPointIndex& index = volume.index();
  const double spacing = probe_spacing * volume.thresholds().delta;
  double area = 0;
  for (std::size_t i = 0; i < index.size(); ++i) area += isoscope::area(index.triangle(TriangleId(i)));
  const double share = std::max(spacing * spacing, area / most_wall_probes);
  std::vector<WallProbe> probes;
  for (std::size_t i = 0; i < index.size(); ++i) {
    const Triangle3& t = index.triangle(TriangleId(i));
    // n² equal parts, each asked at its middle: the upright ones and those between them.
    const auto n = static_cast<int>(std::ceil(std::sqrt(isoscope::area(t) / share)));
    const Vec3 u = (t[1] - t[0]) / std::max(n, 1), v = (t[2] - t[0]) / std::max(n, 1);
    for (int a = 0; a < n; ++a)
      for (int b = 0; a + b < n; ++b) {
        const Vec3 corner = t[0] + double(a) * u + double(b) * v;
        probes.push_back({TriangleId(i), corner + (u + v) / 3});
        if (a + b + 1 < n) probes.push_back({TriangleId(i), corner + 2.0 / 3 * (u + v)});
      }
  }
  return probes;
}

WallNeighbours neighbours_of_wall(const ToleranceVolume& volume, const WallProbe& probe) {
  const ClosestPointIndex& index = volume.index();
  const double boundary = volume.thresholds().boundary;
  const Vec3 normal = normalized(area_vector(index.triangle(probe.triangle)));
  WallNeighbours found;
  if (normal == Vec3{}) return found;
  std::array<Vec3, 2>& reached = found.places;
  for (std::size_t k = 0; k < 2; ++k) {
    reached[k] = probe.point + (k == 0 ? wall_reach : -wall_reach) * boundary * normal;
    const ClosestPoint closest = index.closest(reached[k]);
    if (!(closest.distance() > boundary)) return found;
    found.regions[k] = volume.escape(reached[k], closest).region;
  }
  found.parted = index.crossings(reached[0], reached[1]).size() % 2 != 0;
  return found;
}

std::shared_ptr<const SolidAngles> find_clear_windings(const ToleranceVolume& volume,
                                                       const RunControl& control) {
  const InputTopology& input = volume.input();
  if (!input.may_wind_open) return nullptr;
  const Survey survey(volume, control);
  // As the triangles are turned, or as they are given and then as rays turn them.
  std::vector<std::shared_ptr<const SolidAngles>> ways;
  const std::size_t most_ways = input.turns ? 1 : 2;
  for (const double clear : clear_windings)
    for (std::size_t k = 0; k < most_ways; ++k) {
      if (ways.size() == k) {
        const std::vector<std::int8_t> turns = k > 0         ? turns_by_rays(volume, control)
                                               : input.turns ? *input.turns
                                                             : std::vector<std::int8_t>();
        ways.push_back(std::make_shared<const SolidAngles>(volume.index(), turns));
      }
      if (control.cancelled()) return nullptr;
      // What stands out is no hole.
      if (clear > clear_windings.front() && survey.has_fins()) return nullptr;
      if (winds_clearly(volume, *ways[k], clear, survey, control)) return ways[k];
    }
  return nullptr;
}

std::optional<std::vector<int>> label_by_walls(const ToleranceVolume& volume, const RunControl& control) {
  const WallVotes votes = Survey(volume, control).votes();
  std::size_t all = 0, in_the_open = 0;
  std::vector<std::size_t> seen(volume.regions().size());
  for (const auto& [pair, between] : votes)
    for (const RegionId r : {pair.first, pair.second}) seen[r.index()] += between.all();
  std::vector<std::vector<std::pair<RegionId, int>>> beside(volume.regions().size());
  for (const auto& [pair, between] : votes) {
    const auto [a, b] = pair;
    all += between.all();
    if (a == b) {
      in_the_open += between.parted;
      continue;
    }
    const auto least = static_cast<double>(std::min(seen[a.index()], seen[b.index()]));
    if (between.all() <= few_places && static_cast<double>(between.all()) < small_share * least) continue;
    const int sign = between.parts() ? -1 : +1;
    beside[a.index()].emplace_back(b, sign);
    beside[b.index()].emplace_back(a, sign);
  }
  if (static_cast<double>(in_the_open) > small_share * static_cast<double>(all)) return std::nullopt;
  std::vector<int> labels(volume.regions().size(), 0);
  labels[0] = +1;
  std::deque<RegionId> queue{RegionId(0)};
  while (!queue.empty()) {
    const RegionId from = queue.front();
    queue.pop_front();
    for (const auto& [to, sign] : beside[from.index()]) {
      const int label = sign * labels[from.index()];
      if (labels[to.index()] == -label) return std::nullopt;
      if (std::exchange(labels[to.index()], label) == 0) queue.push_back(to);
    }
  }
  // Pockets that hardly a place sees.
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != 0) continue;
    const auto inside = volume.sides().unanimous_parity(volume.regions()[i].deepest);
    if (!inside) return std::nullopt;
    labels[i] = *inside ? -1 : +1;
  }
  return labels;
}

} // namespace isoscope
