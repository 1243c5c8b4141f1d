// Builds Ω in order, labels its regions, finds ways out of it.
#include "tolerance/tolerance_volume.h"

#include "base/numbers.h"
#include "tolerance/border_gate.h"
#include "tolerance/narrow_passages.h"
#include "tolerance/octree_estimate.h"
#include "tolerance/region_labels.h"
#include "tolerance/regions.h"
#include "tolerance/room_labels.h"
#include "tolerance/volume_components.h"
#include "tolerance/wall_neighbours.h"
#include "tolerance/wall_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

constexpr std::size_t most_components = 0xffff;

/// What is said where the octree takes too much memory: with the tolerance that fits, where the area tells
/// it.
Error with_fitting_tolerance(Error error, const ToleranceField& field, const OctreeEstimate& estimate,
                             const ToleranceVolume::Options& options) {
  if (error.code != ErrorCode::unsupported || !std::isfinite(options.most_bytes)) return error;
  const double delta = estimate.fitting_boundary(options.most_bytes) / options.boundary_ratio;
  if (!(delta > options.delta)) return error;
  const double step = std::pow(10.0, std::floor(std::log10(delta)) - 1),
               rounded = step * std::ceil(delta / step);
  error.remedy = "Choose a tolerance of at least " + general(rounded, 3) + " (" +
                 general(100 * rounded / field.bounds().longest_edge(), 3) +
                 "% of the longest edge), or give more with --memory-limit.";
  return error;
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
  copy.given_rule_ = given_rule_;
  copy.sides_ = sides_;
  copy.open_sides_ = open_sides_;
  copy.open_sides_found_ = open_sides_found_;
  copy.thresholds_ = thresholds_;
  copy.border_gate_ = border_gate_;
  copy.regions_ = regions_;
  copy.witnesses_ = witnesses_;
  copy.cover_path_ = cover_path_;
  copy.boundary_components_ = boundary_components_;
  copy.volume_components_ = volume_components_;
  copy.volume_component_count_ = volume_component_count_;
  return copy;
}

void ToleranceVolume::hold(std::span<const Witness> held, std::vector<Witness> path) {
  witnesses_.insert(witnesses_.end(), held.begin(), held.end());
  cover_path_ = std::move(path);
}

std::size_t ToleranceVolume::held() const {
  return static_cast<std::size_t>(
      std::count_if(witnesses_.begin(), witnesses_.end(), [](const Witness& w) { return w.cover; }));
}

void ToleranceVolume::settle_open_sides(std::shared_ptr<const OpenSides> sides) {
  open_sides_ = std::move(sides);
  if (open_sides_) keep_border_to(open_segments(open_sides_->rim()));
}

void ToleranceVolume::open(std::shared_ptr<const OpenSides> sides, const RunControl& control) {
  open_sides_found_ = std::move(sides);
  settle_open_sides(open_sides_found_);
  for (Region& r : regions_) {
    const ClosestPoint closest = field_->closest(r.deepest);
    if (r.unbounded || !(r.shallow || has_surface()) || !open_sides_->is_open(closest.triangle)) continue;
    if (const int side = open_sides_->side(r.deepest, closest); side != 0) r.label = side;
  }
  // The ways up from there lead to the outside on both sides of a sheet.
  for (std::size_t i = 0; i < basins_.size(); ++i) {
    const TriangleId site = octree_->cell(static_cast<Regions::CellIndex>(i)).triangle;
    if (site.valid() && open_sides_->is_open(site)) basins_[i] = 0;
  }
  for (BoundaryComponent& c : boundary_components_) c.label = regions_[c.region.index()].label;
  witnesses_ = find_witnesses(*this, control);
}

void ToleranceVolume::keep_border_to(std::vector<Segment3> rim) {
  std::vector<Segment3> crossed;
  const std::vector<WallSample> ends = wall_samples(*this);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    const bool turned = ends[i].label > 0;
    crossed.push_back({ends[turned ? i + 1 : i].point, ends[turned ? i : i + 1].point});
  }
  border_gate_ = std::make_shared<const BorderGate>(std::move(rim), thresholds_.delta, std::move(crossed));
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
  v.given_rule_ = input.side_rule;
  v.sides_ = v.has_surface() ? InputSides(v.shared_index(), input.side_rule, input.turns)
                             : InputSides(v.field_, input.side_rule);
  const double delta = options.delta, boundary = options.boundary_ratio * delta;
  v.thresholds_ = {delta, std::max(0.5 * (boundary + delta), boundary + 0.01 * delta), boundary};

  // A cell of this side that holds a point beyond δ_r is OUT: its centre is at most 0.867 sides away from
  // that point, and OUT needs another 0.867 sides.
  const double min_side = 0.57 * (v.thresholds_.reject - boundary);
  const OctreeEstimate estimate(*v.field_, input.sides_known());
  auto octree = Regions::build(*v.field_,
                               {.boundary = boundary,
                                .main_side = estimate.main_side_ratio(boundary) * boundary,
                                .min_side = min_side,
                                .margin = 3 * delta,
                                .most_bytes = options.most_bytes,
                                .expected_cells = v.has_surface() ? estimate.cells(boundary) : 0},
                               control);
  if (!octree.ok())
    return v.has_surface() ? with_fitting_tolerance(octree.error(), *v.field_, estimate, options)
                           : octree.error();
  v.octree_ = std::make_unique<Regions>(std::move(octree).value());
  const Error stopped{ErrorCode::cancelled, "Stopped while building the tolerance volume.", ""};
  v.join_pockets(control);
  // Where depths or regions tell the sides, what is joined has to be known before.
  const bool regions_tell = v.sides_.rule() == SideRule::depth || (v.has_surface() && !v.sides_.known());
  if (regions_tell && !control.cancelled())
    join_narrow_passages(v.octree(), *v.field_, boundary, v.thresholds_.reject, control);
  if (control.cancelled()) return stopped;

  VolumeComponents components = v.field_->components(boundary, control);
  if (control.cancelled()) return stopped;
  v.volume_components_ = std::move(components.of_triangle);
  v.volume_component_count_ = components.count;
  v.collect_regions(control);
  if (control.cancelled()) return stopped;
  v.add_seeded_regions(control);
  v.collect_boundary_components(control);
  if (v.has_surface() && !v.sides_.known())
    if (auto angles = find_clear_windings(v, control)) {
      v.input_.side_rule = SideRule::winding;
      v.sides_ = InputSides(v.shared_index(), std::move(angles));
    }
  if (control.cancelled()) return stopped;
  // Where sides are known, those that are missing are; soups must know all regions before they can be
  // coloured.
  if (v.has_surface() && !v.sides_.known()) v.find_thin_regions(control);
  if (control.cancelled()) return stopped;
  if (v.has_surface() && !v.sides_.known()) {
    auto found = find_open_sides(v, control);
    if (control.cancelled()) return stopped;
    if (!found) {
      if (options.loose_sheets && options.open_surfaces) v.loose_sheets_ = find_loose_sheets(v, control);
      if (v.loose_sheets_.empty()) return found.error();
    } else {
      v.open_sides_found_ = std::move(*found);
    }
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

  if (Status counted = v.count_boundary_topology(control); !counted) return counted.error();
  v.witnesses_ = find_witnesses(v, control);
  if (control.cancelled()) return stopped;
  return v;
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
    return joined_sides_near(*this, where);
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
    if (octree_->kind(i) != Regions::Kind::out) return false;
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

std::size_t ToleranceVolume::memory_bytes() const {
  return octree_->memory_bytes() + basins_.capacity() + (open_sides_ ? open_sides_->memory_bytes() : 0) +
         volume_components_.capacity() * sizeof(std::uint32_t) + regions_.capacity() * sizeof(Region) +
         boundary_components_.capacity() * sizeof(BoundaryComponent);
}

} // namespace isoscope
