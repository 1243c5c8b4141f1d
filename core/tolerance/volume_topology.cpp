// What the boundaries of Ω are: how many, of which Euler characteristic, whether Ω is a thickening.
#include "tolerance/boundary_topology.h"
#include "tolerance/open_changes.h"
#include "tolerance/retraction.h"
#include "tolerance/self_intersections.h"
#include "tolerance/tolerance_volume.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <vector>

namespace isoscope {
namespace {

/// Whether a closed connected surface may have these numbers.
bool may_be(long euler_characteristic) {
  return euler_characteristic <= 2 && euler_characteristic % 2 == 0;
}

/// How often the lattice is halved at most where regions are too thin for it.
constexpr unsigned most_halvings = 1;
/// Cells in which Ω' is looked at for what closes there: 3 µs each.
constexpr std::size_t most_proof_cells = 3'000'000;

/// χ of the triangles in each component of Ω'.
std::vector<long> input_characteristics(const ToleranceVolume& volume, const WeldedMesh& mesh) {
  std::vector<long> chi(volume.volume_component_count());
  std::vector<std::uint32_t> of_point(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t c = volume.volume_component(TriangleId(t));
    ++chi[c];
    for (const std::uint32_t v : mesh.triangles[t]) of_point[v] = c;
  }
  for (const std::uint32_t c : of_point) ++chi[c];
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (i == 0 || uses[i].low != uses[i - 1].low || uses[i].high != uses[i - 1].high)
      --chi[of_point[uses[i].low]];
  return chi;
}

/// Of open input of which Ω keeps components and loops and, as far as a lattice tells, not χ, the χ of each
/// component where Ω' is proven to shrink onto the input; nothing else.
std::vector<long> proven_characteristics(const ToleranceVolume& volume, const RunControl& control) {
  const InputTopology& input = volume.input();
  if (volume.open_sides() == nullptr || !volume.has_surface() || !input.manifold) return {};
  const OpenTopology told = open_topology(volume);
  if (told.is_of_input || told.components != input.components || told.loops != input.boundary_loops)
    return {};
  const WeldedMesh mesh = weld(volume.index());
  const auto stop = [&] { return control.cancelled(); };
  const auto meeting = self_intersections(mesh.points, mesh.triangles, stop, 1);
  if (!meeting || !meeting->empty()) return {};
  control.report("topology", -1);
  if (!shrinks_onto_triangles(volume.index(), volume.thresholds().boundary, most_proof_cells, control))
    return {};
  return input_characteristics(volume, mesh);
}

} // namespace

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

bool ToleranceVolume::topology_told() const {
  return std::all_of(
      boundary_components_.begin(), boundary_components_.end(),
      [&](const BoundaryComponent& c) { return c.told || regions_[c.region.index()].shallow; });
}

bool ToleranceVolume::has_paired_boundaries() const {
  std::vector<std::size_t> boundaries(volume_component_count_, 0);
  for (const BoundaryComponent& c : boundary_components_)
    if (!regions_[c.region.index()].shallow) ++boundaries[c.volume_component];
  for (std::uint32_t c = 0; c < boundaries.size(); ++c) {
    // That of an open surface has one boundary, which goes round its rim.
    const std::size_t wanted = open_sides_ && open_sides_->is_open_component(c) ? 1 : 2;
    if (boundaries[c] != wanted) return false;
  }
  return true;
}

bool ToleranceVolume::has_equal_characteristics() const {
  std::vector<std::optional<long>> first(volume_component_count_);
  for (const BoundaryComponent& c : boundary_components_) {
    if (regions_[c.region.index()].shallow) continue;
    std::optional<long>& known = first[c.volume_component];
    if (known && *known != c.euler_characteristic) return false;
    known = c.euler_characteristic;
  }
  return true;
}

bool ToleranceVolume::thickening() const {
  if (std::any_of(regions_.begin(), regions_.end(),
                  [&](const Region& r) { return !r.shallow && is_uncounted(r); }))
    return false;
  return has_rooms() || (topology_told() && has_paired_boundaries() && has_equal_characteristics());
}

/// A quick count first. Where it tells of what cannot be, or of boundaries that differ, walls or gaps of
/// little more than 2 δ may have left regions that the lattice breaks into pieces: then those count too.
Status ToleranceVolume::count_boundary_topology(const RunControl& control) {
  const auto adopt = [&](const std::vector<BoundaryCount>& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i)
      boundary_components_[i].euler_characteristic = counts[i].euler_characteristic;
  };
  const auto all = [&](const std::vector<BoundaryCount>& counts, const auto& holds) {
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (!regions_[boundary_components_[i].region.index()].shallow && !holds(counts[i])) return false;
    return true;
  };
  const auto quick = count_boundaries(*this, {}, control);
  if (!quick) return quick.error();
  adopt(*quick);
  if (const std::vector<long> proven = proven_characteristics(*this, control); !proven.empty()) {
    std::vector<long> boundaries(proven.size());
    for (const BoundaryComponent& c : boundary_components_) ++boundaries[c.volume_component];
    // That of a sheet goes round its rim, a closed surface has two.
    for (BoundaryComponent& c : boundary_components_)
      c.euler_characteristic = 2 * proven[c.volume_component] / boundaries[c.volume_component];
    return {};
  }
  const bool possible = all(*quick, [](const BoundaryCount& c) { return may_be(c.euler_characteristic); });
  if (has_rooms() || (possible && (!has_paired_boundaries() || has_equal_characteristics()))) return {};
  for (unsigned halvings = 0; halvings <= most_halvings; ++halvings) {
    const auto careful = count_boundaries(*this, {halvings, true}, control);
    if (!careful && careful.error().code == ErrorCode::cancelled) return careful.error();
    if (!careful) { // too large: what the quick count says of what may be is taken for true
      if (halvings > 0) break;
      for (BoundaryComponent& c : boundary_components_) c.told = may_be(c.euler_characteristic);
      break;
    }
    const auto is_sound = [](const BoundaryCount& c) {
      return c.pieces == 1 && may_be(c.euler_characteristic);
    };
    for (std::size_t i = 0; i < careful->size(); ++i) boundary_components_[i].told = is_sound((*careful)[i]);
    if (!all(*careful, is_sound)) continue;
    adopt(*careful);
    return {};
  }
  return {};
}

bool ToleranceVolume::has_inner_walls() const {
  return sides_.rule() == SideRule::winding &&
         std::any_of(regions_.begin(), regions_.end(),
                     [](const Region& r) { return std::abs(r.winding_number) > 1; });
}

} // namespace isoscope
