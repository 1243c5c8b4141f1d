// Sides of regions, from the input or by two-colouring.
#include "tolerance/region_labels.h"

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "tolerance/facet_turns.h"
#include "tolerance/patch_seams.h"
#include "tolerance/room_labels.h"
#include "tolerance/wall_neighbours.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <tuple>

namespace isoscope {
namespace {

/// Triangles from which the thickness of a part is measured.
constexpr std::size_t thickness_probes = 2000;
/// Places between its walls that are asked whether a part is closed.
constexpr std::size_t thin_part_probes = 16;
constexpr int most_steps = 200; ///< of a climb
/// Triangles whose sides are compared, and the share of them with one region on both sides from which on the
/// surface counts as open.
constexpr std::size_t side_probes = 4000;
constexpr double open_share = 0.05;
/// The same of one component of Ω' among others that separate.
constexpr double open_component_share = 0.5;
/// The share of the sides of a component's triangles that must have a neighbour for its border to mean
/// something: in a soup of triangles every edge is one.
constexpr double sheet_share = 0.3;
constexpr double shortest_fin = 2;  ///< in units of δ'
constexpr double largest_crumb = 2; ///< in units of δ'
constexpr double shortest_run = 1;  ///< of one without a break, in the same: what is here and there is none

/// The regions on the sides of each component of Ω'.
std::vector<std::vector<RegionId>> regions_by_component(const ToleranceVolume& volume) {
  std::vector<std::vector<RegionId>> sides(volume.volume_component_count());
  for (const BoundaryComponent& c : volume.boundary_components())
    sides[c.volume_component].push_back(c.region);
  return sides;
}

std::vector<TriangleId> triangles_of(const ToleranceVolume& volume, std::uint32_t component) {
  std::vector<TriangleId> list;
  for (std::size_t t = 0; t < volume.index().size(); ++t)
    if (volume.volume_component(TriangleId(t)) == component) list.push_back(TriangleId(t));
  return list;
}

/// A point of the input's border, where the known one lies in this component of Ω'.
std::optional<Vec3> border_in(const ToleranceVolume& volume, std::uint32_t component) {
  const auto& border = volume.input().border;
  if (border && volume.volume_component(volume.index().closest(*border).triangle) == component) return border;
  return std::nullopt;
}

/// Whether both sides of the surface at its known border are in one region.
bool is_open_at_border(const ToleranceVolume& volume) {
  if (!volume.input().border) return false;
  const Vec3 border = *volume.input().border;
  const ClosestPointIndex& index = volume.index();
  const Triangle3& t = index.triangle(index.closest(border).triangle);
  const Vec3 step = 1.5 * volume.thresholds().boundary * normalized(cross(t[1] - t[0], t[2] - t[0]));
  const auto region = [&](Vec3 p) {
    const ClosestPoint closest = index.closest(p);
    return closest.distance() > volume.thresholds().boundary ? volume.escape(p, closest).region : RegionId();
  };
  const RegionId above = region(border + step), below = region(border - step);
  return above.valid() && above == below;
}

/// Adds the components whose triangles have the same region on both sides, where so many do that the surface
/// does not separate: pockets along an open surface would pass for its other side. Thin parts have one region
/// all around them and count neither way.
void add_one_sided(const ToleranceVolume& volume, const std::vector<bool>& thin,
                   std::vector<std::uint8_t>& open, const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  const std::size_t stride = index.size() / side_probes + 1;
  std::vector<std::size_t> compared(open.size(), 0), same(open.size(), 0);
  std::size_t all_compared = 0, all_same = 0;
  for (std::size_t i = 0; i < index.size() && !control.cancelled(); i += stride) {
    const std::uint32_t component = volume.volume_component(TriangleId(i));
    if (thin[component]) continue;
    const WallNeighbours sides =
        neighbours_of_wall(volume, {TriangleId(i), centroid(index.triangle(TriangleId(i)))});
    if (!sides.told()) continue;
    const bool alike = sides.ends_in_the_open();
    ++compared[component], ++all_compared;
    same[component] += alike, all_same += alike;
  }
  const auto exceeds = [](std::size_t part, double share, std::size_t whole) {
    return static_cast<double>(part) > share * static_cast<double>(whole);
  };
  const double share = exceeds(all_same, open_share, all_compared) ? open_share : open_component_share;
  for (std::size_t c = 0; c < open.size(); ++c)
    if (exceeds(same[c], share, compared[c])) open[c] = 1;
}

/// Whether a component of Ω' with one region around it is a closed part that is thinner than Ω is thick, and
/// no open surface: it shows no border, and between its walls, in Ω', is a place that every ray takes for
/// inside. Were such a place outside of Ω', it would be in the one region there is, which is that of the
/// outside.
bool is_thin_part(const ToleranceVolume& volume, std::uint32_t component) {
  if (border_in(volume, component)) return false;
  std::vector<ThicknessProbe> probes = probe_thickness(volume, component);
  std::stable_sort(probes.begin(), probes.end(),
                   [](const auto& a, const auto& b) { return a.distance > b.distance; });
  probes.resize(std::min(probes.size(), thin_part_probes));
  const auto first_inside = std::find_if(probes.begin(), probes.end(), [&](const ThicknessProbe& probe) {
    return volume.sides().unanimous_parity(probe.middle).value_or(false);
  });
  return first_inside != probes.end() && first_inside->distance <= volume.thresholds().reject;
}

/// What is said of an open component without a rim.
Error open_component_error(const ToleranceVolume& volume, std::uint32_t component) {
  const auto border = border_in(volume, component);
  return open_surface_near(
      border ? *border : centroid(volume.index().triangle(triangles_of(volume, component).front())));
}

/// Where the rims of a component's sheets end on other parts of it for that long, in runs of `least` or more.
std::optional<Vec3> end_on_wall(const ToleranceVolume& volume, const OpenSides& sides, double enough,
                                double least) {
  std::vector<const RimPiece*> ending;
  for (const RimPiece& piece : sides.rim().pieces())
    if (piece.meets_wall && sides.is_open(piece.triangle)) ending.push_back(&piece);
  std::vector<std::pair<Vec3, std::uint32_t>> ends;
  for (std::uint32_t i = 0; i < ending.size(); ++i)
    for (const Vec3 p : {ending[i]->a, ending[i]->b}) ends.emplace_back(p, i);
  std::sort(ends.begin(), ends.end(), [](const auto& x, const auto& y) {
    return std::tie(x.first.x, x.first.y, x.first.z, x.second) <
           std::tie(y.first.x, y.first.y, y.first.z, y.second);
  });
  DisjointSets runs(ending.size());
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (ends[i].first == ends[i - 1].first) runs.unite(ends[i].second, ends[i - 1].second);
  std::vector<double> length(ending.size(), 0);
  for (std::uint32_t i = 0; i < ending.size(); ++i)
    length[runs.find(i)] += distance(ending[i]->a, ending[i]->b);
  std::vector<double> in_component(volume.volume_component_count(), 0);
  for (std::uint32_t i = 0; i < ending.size(); ++i) {
    if (runs.find(i) != i || length[i] < least) continue;
    double& sum = in_component[volume.volume_component(ending[i]->triangle)];
    if ((sum += length[i]) >= enough) return 0.5 * (ending[i]->a + ending[i]->b);
  }
  return std::nullopt;
}

/// Where three sheets or more meet along some way, two δ' of it in one open component: at edges of three
/// triangles, or where the rim of one ends on another.
std::optional<Vec3> place_of_fin(const ToleranceVolume& volume, const OpenSides& sides,
                                 const WeldedMesh& mesh, const std::vector<EdgeUse>& uses) {
  std::vector<double> length(volume.volume_component_count(), 0);
  const double enough = shortest_fin * volume.thresholds().boundary;
  const auto long_enough = [&](TriangleId t, Vec3 a, Vec3 b) {
    return sides.is_open(t) && (length[volume.volume_component(t)] += distance(a, b)) >= enough;
  };
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    const Vec3 a = mesh.points[uses[i].low], b = mesh.points[uses[i].high];
    if (end - i > 2 && long_enough(TriangleId(uses[i].triangle), a, b)) return 0.5 * (a + b);
  }
  return end_on_wall(volume, sides, enough, shortest_run * volume.thresholds().boundary);
}

/// The components among the open ones whose triangles, if they have more than one, are no sheet.
std::vector<std::uint32_t> open_soups(const ToleranceVolume& volume, const std::vector<std::uint8_t>& open,
                                      const std::vector<EdgeUse>& uses) {
  std::vector<std::size_t> sides(open.size(), 0), linked(open.size(), 0);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    for (std::size_t k = i; k < end; ++k) {
      const std::uint32_t component = volume.volume_component(TriangleId(uses[k].triangle));
      ++sides[component];
      linked[component] += end - i > 1;
    }
  }
  std::vector<std::uint32_t> soups;
  for (std::uint32_t c = 0; c < open.size(); ++c)
    if (open[c] != 0 && sides[c] > 3 &&
        static_cast<double>(linked[c]) < sheet_share * static_cast<double>(sides[c]))
      soups.push_back(c);
  return soups;
}

/// Components without an edge of one triangle alone are closed, whatever rays through open ones say: thin.
void mark_closed(const ToleranceVolume& volume, std::vector<std::uint8_t>& open, std::vector<bool>& thin) {
  std::vector<bool> has_border(open.size(), false);
  for (const EdgeUse& e : border_uses(weld(volume.index()).triangles))
    has_border[volume.volume_component(TriangleId(e.triangle))] = true;
  for (std::size_t c = 0; c < open.size(); ++c)
    if (open[c] != 0 && !has_border[c]) open[c] = 0, thin[c] = true;
}

/// A 1 by component for those that are open.
std::vector<std::uint8_t> find_open_components(const ToleranceVolume& volume, const RunControl& control) {
  const auto sides = regions_by_component(volume);
  std::vector<std::uint8_t> open(sides.size(), 0);
  std::vector<bool> thin(sides.size());
  for (std::size_t c = 0; c < sides.size(); ++c) {
    if (sides[c].size() > 1) continue;
    if (control.cancelled()) return open;
    thin[c] = is_thin_part(volume, static_cast<std::uint32_t>(c));
    open[c] = thin[c] ? 0 : 1;
  }
  if (std::find(open.begin(), open.end(), 1) != open.end()) mark_closed(volume, open, thin);
  add_one_sided(volume, thin, open, control);
  return open;
}

/// A 1 by component for those with an open rim.
std::vector<std::uint8_t> with_rim(const ToleranceVolume& volume, const OpenSides& sides) {
  std::vector<std::uint8_t> rimmed(volume.volume_component_count(), 0);
  for (const RimPiece& piece : sides.rim().pieces())
    if (piece.open) rimmed[volume.volume_component(piece.triangle)] = 1;
  return rimmed;
}

/// Parts so small that Ω closes all of their rim are thin ones. False where there are none.
bool drop_open_crumbs(const ToleranceVolume& volume, const OpenSides& sides,
                      std::vector<std::uint8_t>& open) {
  const std::vector<std::uint8_t> rimmed = with_rim(volume, sides);
  std::vector<Box3> boxes(open.size());
  for (std::uint32_t t = 0; t < volume.index().size(); ++t)
    for (const Vec3 p : volume.index().triangle(TriangleId(t)))
      boxes[volume.volume_component(TriangleId(t))].add(p);
  bool found = false;
  for (std::size_t c = 0; c < open.size(); ++c) {
    if (open[c] == 0 || rimmed[c] != 0 ||
        length(boxes[c].extent()) > largest_crumb * volume.thresholds().boundary)
      continue;
    open[c] = 0;
    found = true;
  }
  return found;
}

} // namespace

Error open_surface_near(Vec3 p) {
  return {
      ErrorCode::open_surface,
      "The input is an open surface near " + place(p, place_digits) +
          ": both its sides are connected outside of the tolerance volume, and its triangles are not joined "
          "to a sheet with a rim there.",
      "A larger tolerance closes gaps."};
}

Error one_sided_near(Vec3 p) {
  return {ErrorCode::open_surface,
          "The input has one side only, like a Möbius strip: near " + place(p, place_digits) +
              " the sides of neighbouring triangles do not agree, however they are turned.",
          "Cut the surface there."};
}

Result<std::shared_ptr<const OpenSides>> find_open_sides(const ToleranceVolume& volume,
                                                         const RunControl& control) {
  using Sides = std::shared_ptr<const OpenSides>;
  std::vector<std::uint8_t> open = find_open_components(volume, control);
  if (control.cancelled() || std::find(open.begin(), open.end(), 1) == open.end()) return Sides();
  const ClosestPointIndex& index = volume.index();
  const WeldedMesh mesh = weld(index);
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  if (const auto soups = open_soups(volume, open, uses); !soups.empty())
    return open_component_error(volume, soups.front());
  const PatchTurns patches = orient_patches(mesh, uses);
  if (patches.one_sided) {
    const TriangleId at = index.closest(*patches.one_sided).triangle;
    if (open[volume.volume_component(at)] != 0) return one_sided_near(*patches.one_sided);
  }
  // Patches before a one-sided one may be without turns: then all run as they are given.
  std::vector<std::int8_t> turns = patches.one_sided ? std::vector<std::int8_t>() : patches.turns;
  if (!turns.empty()) turn_along_seams(index, mesh, uses, volume.thresholds().boundary, turns);
  std::vector<std::uint32_t> component(index.size());
  for (std::uint32_t t = 0; t < component.size(); ++t) component[t] = volume.volume_component(TriangleId(t));
  const auto make = [&] {
    return std::make_shared<const OpenSides>(volume.shared_index(), component, open, turns,
                                             volume.thresholds().boundary, control);
  };
  Sides sides = make();
  if (control.cancelled()) return Sides();
  if (drop_open_crumbs(volume, *sides, open)) {
    if (std::find(open.begin(), open.end(), 1) == open.end()) return Sides();
    sides = make();
    if (control.cancelled()) return Sides();
  }
  if (const auto fin = place_of_fin(volume, *sides, mesh, uses)) {
    // Where the rest separates regions, what has one of them on both sides stands out.
    const std::uint32_t c = volume.volume_component(index.closest(*fin).triangle);
    const bool separates = regions_by_component(volume)[c].size() > 1;
    const auto wall = separates ? one_sided_wall(volume, c, control) : std::nullopt;
    return Error{ErrorCode::joined_sheets,
                 "The input is not a manifold surface: an open sheet ends on another part of it near " +
                     place(wall.value_or(*fin), place_digits) + ".",
                 "Remove what stands out there."};
  }
  const std::vector<std::uint8_t> rimmed = with_rim(volume, *sides);
  for (std::uint32_t c = 0; c < open.size(); ++c)
    if (open[c] != 0 && rimmed[c] == 0) return open_component_error(volume, c);
  return sides;
}

std::vector<std::uint8_t> find_loose_sheets(const ToleranceVolume& volume, const RunControl& control) {
  std::vector<std::uint8_t> open = find_open_components(volume, control);
  if (control.cancelled()) return {};
  const WeldedMesh mesh = weld(volume.index());
  const auto soups = open_soups(volume, open, sorted_edge_uses(mesh.triangles));
  if (soups.empty() || soups.size() < static_cast<std::size_t>(std::count(open.begin(), open.end(), 1)))
    return {};
  return open;
}

std::vector<ThicknessProbe> probe_thickness(const ToleranceVolume& volume, std::uint32_t component,
                                            const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  const std::vector<TriangleId> part = triangles_of(volume, component);
  const double reach = 8 * volume.thresholds().delta;
  const std::size_t stride = std::max<std::size_t>(1, part.size() / thickness_probes);
  std::vector<ThicknessProbe> probes;
  for (std::size_t i = 0; i < part.size() && !control.cancelled(); i += stride) {
    const Triangle3& t = index.triangle(part[i]);
    const Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    if (n == Vec3{}) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 start = centroid(t) + (1e-7 * reach * side) * n, end = start + (reach * side) * n;
      const std::vector<double> hits = index.crossings(start, end);
      if (hits.empty()) continue;
      const Vec3 middle = start + (0.5 * hits.front()) * (end - start);
      probes.push_back({middle, index.distance(middle), part[i]});
    }
  }
  return probes;
}

ThicknessProbe deepest_around(const ToleranceField& field, const ThicknessProbe& from, double step) {
  ThicknessProbe best = from;
  for (int k = 0; k < 27; ++k) {
    const Vec3 p = from.middle + step * normalized({k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0});
    const double d = field.distance(p);
    if (d > best.distance) best.middle = p, best.distance = d;
  }
  return best;
}

Error joined_sides_near(const ToleranceVolume& volume, Vec3 p) {
  if (volume.sides().rule() != SideRule::depth) return open_surface_near(p);
  return {ErrorCode::open_surface,
          "At this tolerance inside and outside are joined near " + place(p, place_digits) +
              ": the points leave a hole there that Ω does not close.",
          "Choose a larger tolerance, or --tolerance auto."};
}

int label_above(const ToleranceVolume& volume, Vec3 p) {
  const RegionId region = volume.escape(p, volume.field().closest(p)).region;
  return region.valid() ? volume.regions()[region.index()].label : 0;
}

ThicknessProbe climb(const ToleranceField& field, ThicknessProbe from, double enough) {
  double step = 0.99 * from.distance;
  const double least_step = 1e-3 * from.distance;
  for (int steps = 0; steps < most_steps && step > least_step && from.distance < enough; ++steps) {
    const ThicknessProbe best = deepest_around(field, from, step);
    step = best.distance < from.distance + 0.05 * step ? 0.5 * step : 0.99 * best.distance;
    from = best;
  }
  return from;
}

std::vector<int> label_by_sides(const ToleranceVolume& volume, const RunControl& control) {
  std::vector<int> labels;
  for (const Region& r : volume.regions()) {
    if (control.cancelled()) break;
    labels.push_back(r.unbounded ? +1 : volume.sides().label(r.deepest));
  }
  return labels;
}

Result<std::vector<int>> label_by_two_colouring(const ToleranceVolume& volume, const RunControl& control) {
  const auto sides = regions_by_component(volume);
  std::vector<std::vector<std::uint32_t>> components(volume.regions().size());
  for (const BoundaryComponent& c : volume.boundary_components())
    components[c.region.index()].push_back(c.volume_component);
  std::vector<int> labels(volume.regions().size(), 0);
  labels[0] = +1;
  std::deque<RegionId> queue{RegionId(0)};
  std::size_t pockets = 0; // regions before this one have a label, or none leads to them
  while (!control.cancelled()) {
    if (queue.empty()) {
      while (pockets < labels.size() && labels[pockets] != 0) ++pockets;
      if (volume.open_sides() == nullptr || pockets == labels.size()) break;
      const Vec3 p = volume.regions()[pockets].deepest;
      const ClosestPoint closest = volume.index().closest(p);
      const int side =
          volume.open_sides()->is_open(closest.triangle) ? volume.open_sides()->side(p, closest) : +1;
      labels[pockets] = side == 0 ? +1 : side;
      queue.push_back(RegionId(pockets));
    }
    const RegionId from = queue.front();
    queue.pop_front();
    for (const std::uint32_t c : components[from.index()]) {
      if (volume.open_sides() != nullptr && volume.open_sides()->is_open_component(c)) continue;
      for (const RegionId to : sides[c]) {
        if (labels[to.index()] != 0) continue;
        int sign = -1;
        if (sides[c].size() > 2) {
          const auto here = volume.sides().unanimous_parity(volume.regions()[from.index()].deepest);
          const auto there = volume.sides().unanimous_parity(volume.regions()[to.index()].deepest);
          if (!here || !there) {
            if (is_open_at_border(volume)) return open_component_error(volume, c);
            return label_by_walls(volume, control).value_or(std::vector<int>());
          }
          sign = *here == *there ? +1 : -1;
        }
        labels[to.index()] = sign * labels[from.index()];
        queue.push_back(to);
      }
    }
  }
  for (int& l : labels)
    if (l == 0) l = +1; // touches nothing the octree saw
  return labels;
}

} // namespace isoscope
