// Finds the regions outside of Ω and what each touches.
#include "tolerance/region_labels.h"
#include "tolerance/regions.h"
#include "tolerance/tolerance_volume.h"
#include "tolerance/volume_components.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

/// A pocket of more cells than this is real: what crevices cut off is small.
constexpr std::size_t most_pocket_cells = 5000;
/// Cells that one flood may visit while joining pockets, and all of them together may create.
constexpr std::size_t pocket_budget = 20000;
constexpr std::size_t thin_region_budget = 200000;
constexpr std::size_t most_refined_cells = 6'000'000;
/// Places between opposite walls of a component from which a region that the main cells miss is climbed to.
constexpr std::size_t most_probes = 64;
/// Places that are looked at where they are deep enough as they are: each may cost a flood of small cells.
constexpr std::size_t most_looks = 16;
/// Steps down to Ω', and how near to it, in units of δ', counts as there.
constexpr int most_descents = 60;
constexpr double arrival = 1e-3;
/// How far from Ω, in units of δ, a cell's way down to it is looked at.
constexpr double nearby = 2;

struct RegionSummary {
  Regions::CellIndex root = Regions::none;
  Regions::CellIndex deepest = Regions::none;
  std::size_t cells = 0;
  double volume = 0;
};

/// The components of OUT cells, ascending by root.
std::vector<RegionSummary> summarize(const Regions& octree, const RunControl& control) {
  SparsePoll poll(control);
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> index(octree.size(), none);
  std::vector<RegionSummary> list;
  for (std::size_t k = 0; k < octree.size() && !poll.cancelled(); ++k) {
    const auto i = static_cast<Regions::CellIndex>(k);
    if (octree.kind(i) != Regions::Kind::out) continue;
    const Regions::CellIndex root = octree.root(i);
    if (root >= octree.main_size()) continue;
    if (index[root] == none) {
      index[root] = static_cast<std::uint32_t>(list.size());
      list.emplace_back().root = root;
    }
    RegionSummary& s = list[index[root]];
    const Regions::Cell c = octree.cell(i);
    const double side = octree.side(c.level);
    ++s.cells;
    s.volume += side * side * side;
    if (s.deepest == Regions::none || c.distance > octree.distance(s.deepest)) s.deepest = i;
  }
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.root < b.root; });
  return list;
}

} // namespace

/// Pockets that only a crevice between main cells cuts off are joined to what they belong to, smallest first.
void ToleranceVolume::join_pockets(const RunControl& control) {
  std::vector<RegionSummary> pockets = summarize(*octree_, control);
  std::stable_sort(pockets.begin(), pockets.end(),
                   [](const auto& a, const auto& b) { return a.volume < b.volume; });
  const std::size_t built = octree_->size();
  for (std::size_t k = 0; k + 1 < pockets.size(); ++k) {
    if (control.cancelled() || octree_->size() > built + most_refined_cells) return;
    const RegionSummary& pocket = pockets[k];
    if (pocket.cells > most_pocket_cells || octree_->root(pocket.root) != pocket.root) continue;
    octree_->flood(pocket.deepest, pocket_budget, control);
    control.report("regions", -1);
  }
}

/// Climbs from a point of a region to where d is locally largest, by steps that stay within the ball around
/// the point. What the octree took for a pocket may lead outside: there d grows without end.
void ToleranceVolume::deepen(Region& region) const {
  const double outside = field_->bounds().longest_edge();
  double step = region.depth - thresholds_.boundary;
  while (step > 1e-3 * thresholds_.boundary && region.depth < outside) {
    step = std::min(step, 0.99 * (region.depth - thresholds_.boundary));
    const ThicknessProbe best = deepest_around(*field_, {region.deepest, region.depth, {}}, step);
    if (best.distance < region.depth + 0.05 * step) step *= 0.5;
    region.deepest = best.middle;
    region.depth = best.distance;
  }
}

/// A point of the unbounded region within the domain.
Vec3 ToleranceVolume::first_corner() const {
  const Box3 cube = domain();
  return cube.lo + Vec3{1, 1, 1} * (1e-9 * cube.longest_edge());
}

RegionId ToleranceVolume::add_region(std::uint32_t cell, Vec3 deepest, double depth, double volume) {
  const RegionId id(regions_.size());
  octree_->set_number(cell, id.value);
  regions_.push_back({id, +1, false, deepest, depth, volume});
  if (id.value > 0) deepen(regions_.back());
  return id;
}

/// Whether the way up from a region's deepest cell, which stays in the region, ends in another one: the main
/// cells are too coarse for what joins the two.
bool ToleranceVolume::joins_another(std::uint32_t root, std::uint32_t deepest) {
  const Regions::Cell from = octree_->cell(deepest);
  Region climbed;
  climbed.deepest = octree_->center(from);
  climbed.depth = static_cast<double>(from.distance);
  deepen(climbed);
  const Regions::CellIndex top = octree_->locate(climbed.deepest);
  const bool beyond = top == Regions::none; // of the domain: the unbounded region
  if (!beyond && octree_->kind(top) != Regions::Kind::out) return false;
  const Regions::CellIndex other =
      beyond ? octree_->root(octree_->locate(first_corner())) : octree_->root(top);
  if (other == octree_->root(root)) return false;
  octree_->join(root, other);
  return true;
}

void ToleranceVolume::collect_regions(const RunControl& control) {
  const Regions::CellIndex unbounded = octree_->root(octree_->locate(first_corner()));
  std::vector<RegionSummary> list = summarize(*octree_, control);
  std::stable_partition(list.begin(), list.end(),
                        [&](const RegionSummary& s) { return s.root == unbounded; });
  for (const RegionSummary& s : list) {
    if (control.cancelled()) return;
    const Regions::Cell c = octree_->cell(s.deepest);
    if (!sides_.known() && !regions_.empty() && joins_another(s.root, s.deepest)) continue;
    add_region(s.root, octree_->center(c), static_cast<double>(c.distance), s.volume);
  }
  octree_->flatten(control);
  if (regions_.empty()) return;
  regions_.front().unbounded = true;
  regions_.front().volume = std::numeric_limits<double>::infinity();
}

/// Regions that the field knows of and the main cells are too coarse for.
void ToleranceVolume::add_seeded_regions(const RunControl& control) {
  for (const Vec3 seed : field_->region_seeds()) {
    if (control.cancelled()) return;
    region_at(seed, thin_region_budget, control);
  }
}

std::uint32_t ToleranceVolume::component_below(Vec3 p, const ClosestPoint& closest) const {
  // On the way to the closest point everything outside of Ω' is in the region of p.
  if (field_->is_distance()) return volume_component(closest.triangle);
  const double boundary = thresholds_.boundary;
  ClosestPoint at = closest;
  for (int step = 0; step < most_descents; ++step) {
    const double radius = at.distance() - boundary;
    if (radius <= arrival * boundary) return volume_component(at.triangle);
    const Vec3 before = p;
    p = p - std::max(radius, arrival * boundary) * normalized(p - at.point);
    const double depth = at.distance();
    at = field_->closest_near(p, at.triangle);
    if (p == before || at.distance() >= depth) break;
  }
  return VolumeComponents::none;
}

/// A region touches the component of Ω' that the ways down from its cells lead to.
void ToleranceVolume::collect_boundary_components(const RunControl& control) {
  SparsePoll poll(control);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t k = 0; k < octree_->size() && !poll.cancelled(); ++k) {
    const auto i = static_cast<Regions::CellIndex>(k);
    if (octree_->kind(i) != Regions::Kind::out) continue;
    const auto number = octree_->number(i);
    if (!number) continue;
    const Regions::Cell c = octree_->cell(i);
    std::uint32_t component = VolumeComponents::none;
    if (field_->is_distance()) {
      component = volume_component(c.triangle);
    } else {
      const Vec3 center = octree_->center(c);
      // Cells far from Ω lie behind others that are nearer.
      if (static_cast<double>(c.distance) > nearby * thresholds_.delta) continue;
      component = component_below(center, field_->closest_near(center, c.triangle));
    }
    if (component == VolumeComponents::none) continue;
    const std::pair<std::uint32_t, std::uint32_t> pair{*number, component};
    if (!pairs.empty() && pairs.back() == pair) continue;
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [region, component] : pairs) boundary_components_.push_back({RegionId(region), component});
}

/// Whether the way from p, at distance d from the input, to the nearest triangle of a component of Ω' stays
/// in the region of p: the component is as near as any.
bool ToleranceVolume::touches(Vec3 p, double d, std::uint32_t component) const {
  const double reach = d * (1 + 1e-3);
  const Vec3 corner{reach, reach, reach};
  const std::vector<TriangleId> near = index().triangles_in({p - corner, p + corner});
  return std::any_of(near.begin(), near.end(), [&](TriangleId t) {
    return volume_component(t) == component &&
           distance(p, closest_point_on_triangle(p, index().triangle(t))) <= reach;
  });
}

/// Where a component of Ω' seems to have one side only, the other may be too thin for the main cells: looks
/// for it midway between opposite walls.
void ToleranceVolume::find_thin_regions(const RunControl& control) {
  std::vector<std::array<bool, 2>> has(
      volume_component_count_); // before labels are known: one, more than one
  for (const BoundaryComponent& c : boundary_components_) {
    auto& sides = has[c.volume_component];
    const bool second = sides_.known() ? regions_[c.region.index()].label < 0 : sides[0];
    sides[second ? 1 : 0] = true;
  }
  for (std::uint32_t component = 0; component < has.size(); ++component) {
    if (has[component][0] && has[component][1]) continue;
    if (control.cancelled()) return;
    std::vector<RegionId> found;
    const auto look = [&](const ThicknessProbe& probe) {
      const RegionId r = region_at(probe.middle, thin_region_budget, control);
      if (!r.valid() || std::find(found.begin(), found.end(), r) != found.end()) return;
      if (!touches(probe.middle, probe.distance, component)) return;
      found.push_back(r);
    };
    std::vector<ThicknessProbe> probes = probe_thickness(*this, component, control);
    if (sides_.known()) { // gaps between parts are wide places too, on the side that is known
      const int missing = has[component][0] ? -1 : +1;
      std::erase_if(probes, [&](const auto& probe) { return sides_.label(probe.middle) != missing; });
    }
    std::stable_sort(probes.begin(), probes.end(),
                     [](const auto& a, const auto& b) { return a.distance > b.distance; });
    probes.resize(std::min(probes.size(), most_probes));
    for (std::size_t i = 0; i < std::min(probes.size(), most_looks) && !control.cancelled(); ++i)
      if (probes[i].distance > thresholds_.reject) look(probes[i]);
    if (found.empty()) {
      for (const ThicknessProbe& probe : probes) {
        if (control.cancelled()) return;
        if (const auto top = climb(*field_, probe, 1.01 * thresholds_.reject);
            top.distance > thresholds_.reject)
          look(top);
      }
    }
    for (const RegionId r : found)
      if (std::none_of(boundary_components_.begin(), boundary_components_.end(),
                       [&](const auto& c) { return c.region == r && c.volume_component == component; }))
        boundary_components_.push_back({r, component});
  }
  std::sort(boundary_components_.begin(), boundary_components_.end(), [](const auto& a, const auto& b) {
    return std::pair{a.region, a.volume_component} < std::pair{b.region, b.volume_component};
  });
}

RegionId ToleranceVolume::region_at(Vec3 p, std::size_t budget, const RunControl& control) {
  const Regions::CellIndex i = octree_->locate_refining(p);
  if (i == Regions::none) return RegionId(0);
  if (octree_->kind(i) != Regions::Kind::out) return {};
  if (const auto number = octree_->number(i)) return RegionId(*number);
  octree_->flood(i, budget, control);
  if (const auto number = octree_->number(i)) return RegionId(*number);
  if (control.cancelled()) return {}; // whether it belongs to a known one was not found out
  const Regions::Cell c = octree_->cell(i);
  const double side = octree_->side(c.level);
  const RegionId id = add_region(i, octree_->center(c), static_cast<double>(c.distance), side * side * side);
  Region& region = regions_.back();
  region.shallow = sides_.rule() == SideRule::depth || has_rooms();
  region.label = region.shallow ? basin_at(region.deepest) : sides_.label(region.deepest);
  const TriangleId site = open_sides_ ? field_->closest(region.deepest).triangle : TriangleId();
  const bool beside_sheet = open_sides_ && open_sides_->is_open(site);
  if (winds()) region.winding_number = sides_.winding_number(region.deepest);
  if (region.depth > thresholds_.delta && !beside_sheet)
    witnesses_.push_back({region.deepest, region.label, region.depth});
  return id;
}

int ToleranceVolume::basin_at(Vec3 p) const {
  const Regions::CellIndex leaf = octree_->locate_among(p, basins_.size());
  return leaf != Regions::none && basins_[leaf] < 0 ? basins_[leaf] : +1;
}

int ToleranceVolume::label_at(Vec3 p, const RunControl& control) {
  if (sides_.rule() == SideRule::given && field_->distance(p) > thresholds_.boundary) return field_->side(p);
  if (open_sides_) {
    const ClosestPoint closest = field_->closest(p);
    if (open_sides_->is_open(closest.triangle)) return open_sides_->side(p, closest);
  }
  const RegionId region = region_at(p, thin_region_budget, control);
  return region.valid() ? regions_[region.index()].label : 0;
}

} // namespace isoscope
