// Builds Ω: octree, pockets, regions, labels, boundary components.
#include "tolerance/tolerance_volume.h"

#include "tolerance/border_gate.h"
#include "tolerance/boundary_topology.h"
#include "tolerance/region_labels.h"
#include "tolerance/regions.h"
#include "tolerance/room_labels.h"
#include "tolerance/thin_parts.h"
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
constexpr std::size_t most_components = 0xffff;
/// Places between opposite walls of a component from which a region that the main cells miss is climbed to.
constexpr std::size_t most_climbs = 64;
/// Places that are looked at where they are deep enough as they are: each may cost a flood of small cells.
constexpr std::size_t most_looks = 16;
/// Steps down to Ω', and how near to it, in units of δ', counts as there.
constexpr int most_descents = 60;
constexpr double arrival = 1e-3;
/// How far from Ω, in units of δ, a cell's way down to it is looked at.
constexpr double nearby = 2;

/// The side of the octree's main cells, in units of δ': half, and where that would take more than about 30
/// million cells and parity tells the sides anyway, one, which takes a quarter of them. Regions that only
/// smaller cells see are then found when somebody asks for them.
double main_side_ratio(const ToleranceField& field, const InputTopology& input, double boundary) {
  constexpr double most_fine_cells = 3e7, fine_cells_by_area = 40;
  if (!input.sides_known()) return 0.5;
  return fine_cells_by_area * field.area() > most_fine_cells * boundary * boundary ? 1 : 0.5;
}

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
    const Regions::Cell& c = octree.cell(i);
    if (c.kind != Regions::Kind::out) continue;
    const Regions::CellIndex root = octree.root(i);
    if (root >= octree.main_size()) continue;
    if (index[root] == none) {
      index[root] = static_cast<std::uint32_t>(list.size());
      list.emplace_back().root = root;
    }
    RegionSummary& s = list[index[root]];
    const double side = octree.side(c.level);
    ++s.cells;
    s.volume += side * side * side;
    if (s.deepest == Regions::none || c.distance > octree.cell(s.deepest).distance) s.deepest = i;
  }
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.root < b.root; });
  return list;
}

std::vector<Segment3> open_segments(const Rim& rim) {
  std::vector<Segment3> segments;
  for (const RimPiece& p : rim.pieces())
    if (p.open) segments.push_back({p.a, p.b});
  return segments;
}

} // namespace

ToleranceVolume::ToleranceVolume() = default;

ToleranceVolume ToleranceVolume::without_octree() const {
  ToleranceVolume copy;
  copy.field_ = field_;
  copy.input_ = input_;
  copy.sides_ = sides_;
  copy.open_sides_ = open_sides_;
  copy.open_sides_found_ = open_sides_found_;
  copy.thresholds_ = thresholds_;
  copy.border_gate_ = border_gate_;
  copy.regions_ = regions_;
  copy.witnesses_ = witnesses_;
  copy.boundary_components_ = boundary_components_;
  copy.volume_components_ = volume_components_;
  copy.volume_component_count_ = volume_component_count_;
  return copy;
}

void ToleranceVolume::settle_open_sides(std::shared_ptr<const OpenSides> sides) {
  open_sides_ = std::move(sides);
  if (open_sides_) keep_border_to(open_segments(open_sides_->rim()));
}

void ToleranceVolume::keep_border_to(std::vector<Segment3> rim) {
  border_gate_ = std::make_shared<const BorderGate>(std::move(rim), thresholds_.delta);
}

ToleranceVolume::ToleranceVolume(ToleranceVolume&&) noexcept = default;
ToleranceVolume& ToleranceVolume::operator=(ToleranceVolume&&) noexcept = default;
ToleranceVolume::~ToleranceVolume() = default;

Result<ToleranceVolume> ToleranceVolume::build(std::shared_ptr<const ToleranceField> field,
                                               const InputTopology& input, const Options& options,
                                               const RunControl& control) {
  if (!(options.delta > 0) || !std::isfinite(options.delta))
    return Error{ErrorCode::usage, "The tolerance must be a positive length.",
                 "Give it as a percentage, such as 0.6%."};
  if (!(options.boundary_ratio > 0 && options.boundary_ratio <= 1))
    return Error{ErrorCode::usage, "The boundary ratio must lie in (0, 1].", ""};
  ToleranceVolume v;
  v.field_ = std::move(field);
  v.input_ = input;
  v.sides_ = v.has_surface() ? InputSides(v.shared_index(), input.side_rule, input.turns)
                             : InputSides(v.field_, input.side_rule);
  const double delta = options.delta, boundary = options.boundary_ratio * delta;
  v.thresholds_ = {delta, std::max(0.5 * (boundary + delta), boundary + 0.01 * delta), boundary};

  // A cell of this side that holds a point beyond δ_r is OUT: its centre is at most 0.867 sides away from
  // that point, and OUT needs another 0.867 sides.
  const double min_side = 0.57 * (v.thresholds_.reject - boundary);
  const double main_side = main_side_ratio(*v.field_, input, boundary) * boundary;
  auto octree =
      Regions::build(*v.field_, {boundary, main_side, min_side, 3 * delta, options.most_bytes}, control);
  if (!octree.ok()) return octree.error();
  v.octree_ = std::make_unique<Regions>(std::move(octree).value());
  const Error stopped{ErrorCode::cancelled, "Stopped while building the tolerance volume.", ""};
  v.join_pockets(control);
  if (control.cancelled()) return stopped;

  VolumeComponents components = v.field_->components(boundary, control);
  if (control.cancelled()) return stopped;
  v.volume_components_ = std::move(components.of_triangle);
  v.volume_component_count_ = components.count;
  v.collect_regions(control);
  if (control.cancelled()) return stopped;
  v.add_seeded_regions(control);
  v.collect_boundary_components(control);
  // Where sides are known, those that are missing are; soups must know all regions before they can be
  // coloured.
  if (v.has_surface() && !v.sides_.known()) v.find_thin_regions(control);
  if (control.cancelled()) return stopped;
  if (v.has_surface() && !v.sides_.known()) {
    auto found = find_open_sides(v, control);
    if (control.cancelled()) return stopped;
    if (!found) return found.error();
    v.open_sides_found_ = std::move(*found);
    if (v.open_sides_found_ && !options.open_surfaces)
      return open_surface_near(v.open_sides_found_->rim().pieces()[0].a);
    v.settle_open_sides(v.open_sides_found_);
  }
  const Status labelled = v.label_regions(control);
  if (control.cancelled()) return stopped;
  if (!labelled) return labelled.error();
  if (v.has_surface() && v.sides_.known()) v.find_thin_regions(control);
  if (control.cancelled()) return stopped;
  for (BoundaryComponent& c : v.boundary_components_) c.label = v.regions_[c.region.index()].label;

  auto characteristics = boundary_characteristics(v, 0, control);
  if (!characteristics.ok()) return characteristics.error();
  for (std::size_t i = 0; i < v.boundary_components_.size(); ++i)
    v.boundary_components_[i].euler_characteristic = (*characteristics)[i];
  v.witnesses_ = find_witnesses(v, control);
  if (control.cancelled()) return stopped;
  return v;
}

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

RegionId ToleranceVolume::add_region(std::uint32_t cell, Vec3 deepest, double depth, double volume) {
  const RegionId id(regions_.size());
  octree_->set_number(cell, id.value);
  regions_.push_back({id, +1, false, deepest, depth, volume});
  if (id.value > 0) deepen(regions_.back());
  return id;
}

void ToleranceVolume::collect_regions(const RunControl& control) {
  const Box3 cube = domain();
  const Vec3 inset = Vec3{1, 1, 1} * (1e-9 * cube.longest_edge());
  const Regions::CellIndex unbounded = octree_->root(octree_->locate(cube.lo + inset));
  std::vector<RegionSummary> list = summarize(*octree_, control);
  std::stable_partition(list.begin(), list.end(),
                        [&](const RegionSummary& s) { return s.root == unbounded; });
  for (const RegionSummary& s : list) {
    if (control.cancelled()) return;
    const Regions::Cell& c = octree_->cell(s.deepest);
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
    const Regions::Cell& c = octree_->cell(i);
    if (c.kind != Regions::Kind::out) continue;
    const auto number = octree_->number(i);
    if (!number) continue;
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
  for (const auto& [region, component] : pairs)
    boundary_components_.push_back({RegionId(region), component, +1, 0});
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
    probes.resize(std::min(probes.size(), most_climbs));
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
        boundary_components_.push_back({r, component, +1, 0});
  }
  std::sort(boundary_components_.begin(), boundary_components_.end(), [](const auto& a, const auto& b) {
    return std::pair{a.region, a.volume_component} < std::pair{b.region, b.volume_component};
  });
}

std::optional<std::uint16_t> ToleranceVolume::boundary_component(RegionId region,
                                                                 std::uint32_t component) const {
  const std::pair wanted{region, component};
  const auto found = std::lower_bound(boundary_components_.begin(), boundary_components_.end(), wanted,
                                      [](const BoundaryComponent& c, const auto& w) {
                                        return std::pair{c.region, c.volume_component} < w;
                                      });
  if (found == boundary_components_.end() || std::pair{found->region, found->volume_component} != wanted)
    return std::nullopt;
  const auto i = static_cast<std::size_t>(found - boundary_components_.begin());
  if (i >= most_components) return std::nullopt;
  return static_cast<std::uint16_t>(i);
}

Status ToleranceVolume::label_regions(const RunControl& control) {
  if (sides_.rule() == SideRule::depth) {
    adopt(label_by_depth(*this, control));
    return {};
  }
  if (has_surface() && input_.every_region) {
    const auto rooms = label_rooms_of_input(control);
    if (!rooms) return rooms.error();
    if (*rooms) return {};
  }
  auto labels = sides_.known() ? label_by_sides(*this, control) : label_by_two_colouring(*this, control);
  if (control.cancelled()) return {};
  if (!labels.ok()) return labels.error();
  if (labels->empty()) {
    const auto rooms = label_rooms_of_input(control);
    return rooms ? Status() : rooms.error();
  }
  for (std::size_t i = 0; i < regions_.size(); ++i) regions_[i].label = (*labels)[i];
  if (winds())
    for (Region& r : regions_) r.winding_number = r.unbounded ? 0 : sides_.winding_number(r.deepest);
  return {};
}

void ToleranceVolume::adopt(DepthLabels labels) {
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    regions_[i].label = labels.of_regions[i];
    regions_[i].shallow = labels.shallow[i];
  }
  basins_ = std::move(labels.of_cells);
}

Result<bool> ToleranceVolume::label_rooms_of_input(const RunControl& control) {
  auto labels = label_rooms(*this, control);
  if (!labels) return labels.error();
  const auto& of = labels->of_regions;
  if (input_.every_region && *std::min_element(of.begin(), of.end()) >= -1) return false;
  adopt(std::move(*labels));
  input_.side_rule = SideRule::rooms;
  sides_ = InputSides(shared_index(), SideRule::rooms, input_.turns);
  return true;
}

Status ToleranceVolume::check_passages() const {
  for (const Regions::Passage& p : octree_->passages()) {
    if (regions_[p.numbers[0]].label == regions_[p.numbers[1]].label) continue;
    const Vec3 where = octree_->center(octree_->cell(p.cell));
    // A pocket along an open surface has the side that it is on, whatever it is joined to.
    if (open_sides_ && open_sides_->is_open(field_->closest(where).triangle)) continue;
    return open_surface_near(where);
  }
  return {};
}

Box3 ToleranceVolume::domain() const {
  return octree_->domain();
}

ToleranceVolume::Escape ToleranceVolume::escape(Vec3 p, const ClosestPoint& closest) const {
  const double boundary = thresholds_.boundary;
  Escape result{RegionId(), p, closest.distance()};
  const auto arrive = [&](Vec3 w, double d) {
    if (d > result.distance) result.reached = w, result.distance = d;
    const Regions::CellIndex i = octree_->locate(w);
    if (i == Regions::none) return result.region = RegionId(0), true;
    if (octree_->cell(i).kind != Regions::Kind::out) return false;
    const auto number = octree_->number(i);
    if (number) result.region = RegionId(*number);
    return number.has_value();
  };
  if (arrive(p, closest.distance())) return result;

  // Straight away from the closest point: as long as it stays the closest one, d grows along the whole way.
  const Vec3 direction = normalized(p - closest.point);
  ClosestPoint at = closest;
  Vec3 w = p;
  for (double t = 1.8 * boundary; t > 1.001 * boundary; t = boundary + 0.5 * (t - boundary)) {
    if (t <= closest.distance()) break;
    const Vec3 q = closest.point + t * direction;
    const ClosestPoint c = field_->closest_near(q, closest.triangle);
    if (field_->is_distance() ? c.distance() < t * (1 - 1e-9) : !field_->rises(p, closest, q, c)) continue;
    if (arrive(q, field_->is_distance() ? t : c.distance())) return result;
    w = q;
    at = c;
    break;
  }
  // Then by balls that hold no point of Ω'. Between two walls the closest point alternates, and the sum of
  // two directions leads along the middle.
  Vec3 before = normalized(w - at.point);
  for (int step = 0; step < 40; ++step) {
    const double radius = at.distance() - boundary;
    if (radius < 1e-4 * boundary) break;
    const Vec3 away = normalized(w - at.point);
    w = w + 0.95 * radius * normalized(away + before);
    before = away;
    at = field_->closest_near(w, at.triangle);
    if (arrive(w, at.distance())) return result;
  }
  return result;
}

RegionId ToleranceVolume::region_at(Vec3 p, std::size_t budget, const RunControl& control) {
  const Regions::CellIndex i = octree_->locate_refining(p);
  if (i == Regions::none) return RegionId(0);
  if (octree_->cell(i).kind != Regions::Kind::out) return {};
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

bool ToleranceVolume::is_uncounted(const Region& r) const {
  return std::none_of(boundary_components_.begin(), boundary_components_.end(),
                      [&](const BoundaryComponent& c) { return c.region == r.id; });
}

std::size_t ToleranceVolume::pockets() const {
  return static_cast<std::size_t>(
      std::count_if(regions_.begin(), regions_.end(), [&](const Region& r) { return is_uncounted(r); }));
}

double ToleranceVolume::uncounted_depth() const {
  double depth = 0;
  for (const Region& r : regions_)
    if (is_uncounted(r)) depth = std::max(depth, r.depth);
  return depth;
}

bool ToleranceVolume::thickening() const {
  if (std::any_of(regions_.begin(), regions_.end(),
                  [&](const Region& r) { return !r.shallow && is_uncounted(r); }))
    return false;
  if (has_rooms()) return true;
  std::vector<std::vector<long>> sides(volume_component_count_);
  for (const BoundaryComponent& c : boundary_components_)
    if (!regions_[c.region.index()].shallow) sides[c.volume_component].push_back(c.euler_characteristic);
  for (std::uint32_t c = 0; c < sides.size(); ++c) {
    // That of an open surface has one boundary, which goes round its rim.
    const std::size_t boundaries = open_sides_ && open_sides_->is_open_component(c) ? 1 : 2;
    if (sides[c].size() != boundaries || sides[c].front() != sides[c].back()) return false;
  }
  return true;
}

bool ToleranceVolume::has_inner_walls() const {
  return sides_.rule() == SideRule::winding &&
         std::any_of(regions_.begin(), regions_.end(),
                     [](const Region& r) { return std::abs(r.winding_number) > 1; });
}

std::size_t ToleranceVolume::memory_bytes() const {
  return octree_->memory_bytes() + basins_.capacity() + (open_sides_ ? open_sides_->memory_bytes() : 0) +
         volume_components_.capacity() * sizeof(std::uint32_t) + regions_.capacity() * sizeof(Region) +
         boundary_components_.capacity() * sizeof(BoundaryComponent);
}

} // namespace isoscope
