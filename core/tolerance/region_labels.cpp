// Sides of regions, from the input or by two-colouring.
#include "tolerance/region_labels.h"

#include "base/place.h"

#include <algorithm>
#include <deque>
#include <optional>

namespace isoscope {
namespace {

/// Triangles from which the thickness of a part is measured.
constexpr std::size_t thickness_probes = 2000;
constexpr int place_digits = 6;
/// Places between its walls that are asked whether a part is closed.
constexpr std::size_t thin_part_probes = 16;
constexpr int most_steps = 200; ///< of a climb
/// Triangles whose sides are compared, how far from the plane in units of δ', and the share of them with one
/// region on both sides from which on the surface counts as open.
constexpr std::size_t side_probes = 4000;
constexpr double side_reach = 1.2, open_share = 0.05;

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

Error open_surface(const ToleranceVolume& volume, std::uint32_t component) {
  const auto border = border_in(volume, component);
  return open_surface_near(
      border ? *border : centroid(volume.index().triangle(triangles_of(volume, component).front())));
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

/// A triangle with the same region on both sides, where so many are so that the surface does not separate:
/// pockets along an open surface would pass for its other side.
/// Thin parts, by component of Ω', have one region all around them and count neither way.
std::optional<Vec3> one_sided_place(const ToleranceVolume& volume, const std::vector<bool>& thin,
                                    const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  const double reach = side_reach * volume.thresholds().boundary;
  const std::size_t stride = index.size() / side_probes + 1;
  std::size_t compared = 0, same = 0;
  std::optional<Vec3> first;
  for (std::size_t i = 0; i < index.size() && !control.cancelled(); i += stride) {
    if (thin[volume.volume_component(TriangleId(i))]) continue;
    const Triangle3& t = index.triangle(TriangleId(i));
    const Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    if (n == Vec3{}) continue;
    std::array<RegionId, 2> sides;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 p = centroid(t) + (k == 0 ? reach : -reach) * n;
      const ClosestPoint closest = index.closest(p);
      if (closest.distance() > volume.thresholds().boundary) sides[k] = volume.escape(p, closest).region;
    }
    if (!sides[0].valid() || !sides[1].valid()) continue;
    ++compared;
    if (sides[0] != sides[1]) continue;
    ++same;
    if (!first) first = centroid(t);
  }
  return static_cast<double>(same) > open_share * static_cast<double>(compared) ? first : std::nullopt;
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

} // namespace

Error open_surface_near(Vec3 p) {
  return {ErrorCode::open_surface,
          "The input is an open surface near " + place(p, place_digits) +
              ": both its sides are connected outside of the tolerance volume.",
          "A larger tolerance closes gaps; approximating open surfaces comes with a later version."};
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
  std::vector<bool> thin(sides.size());
  for (std::size_t c = 0; c < sides.size(); ++c) {
    if (sides[c].size() > 1) continue;
    if (control.cancelled()) break;
    thin[c] = is_thin_part(volume, static_cast<std::uint32_t>(c));
    if (!thin[c]) return open_surface(volume, static_cast<std::uint32_t>(c));
  }
  if (const auto p = one_sided_place(volume, thin, control)) return open_surface_near(*p);

  std::vector<int> labels(volume.regions().size(), 0);
  labels[0] = +1;
  std::deque<RegionId> queue{RegionId(0)};
  while (!queue.empty() && !control.cancelled()) {
    const RegionId from = queue.front();
    queue.pop_front();
    for (const std::uint32_t c : components[from.index()]) {
      for (const RegionId to : sides[c]) {
        if (labels[to.index()] != 0) continue;
        int sign = -1;
        if (sides[c].size() > 2) {
          const auto here = volume.sides().unanimous_parity(volume.regions()[from.index()].deepest);
          const auto there = volume.sides().unanimous_parity(volume.regions()[to.index()].deepest);
          if (!here || !there) {
            if (is_open_at_border(volume)) return open_surface(volume, c);
            return std::vector<int>();
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
