// Compares numbers, then looks for the place.
#include "tolerance/open_changes.h"

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/place.h"
#include "tolerance/sample_grid.h"

#include <algorithm>
#include <vector>

namespace isoscope {
namespace {

/// Both sides of a sheet that Ω keeps have samples this near to its triangles, in units of δ'.
constexpr double other_side_within = 2;
/// So many triangles are looked at, at most.
constexpr std::size_t most_places = 20000;

/// The middle of a triangle with samples of one side only around it, of such the farthest from the open rim.
std::optional<Vec3> place_with_one_side(const ToleranceVolume& volume, const BoundarySamples& samples,
                                        const RunControl& control) {
  const OpenSides& open = *volume.open_sides();
  const double reach = other_side_within * volume.thresholds().boundary;
  SampleGrid grid(volume.domain().lo, 0.5 * reach);
  for (const Vec3 p : samples.positions) grid.add(p);
  const std::size_t n = volume.field().size(), stride = n / most_places + 1;
  std::vector<double> from_rim(n / stride + 1, 0);
  const auto middle = [&](std::size_t i) { return volume.field().place_of(TriangleId(i * stride)); };
  parallel_until(from_rim.size(), 64, control, [&](std::size_t i) {
    if (i * stride >= n || !open.is_open(TriangleId(i * stride))) return;
    const Vec3 p = middle(i);
    std::vector<std::uint32_t> near;
    grid.gather(Box3{p, p}.grown(reach), near);
    bool plus = false, minus = false;
    for (const std::uint32_t s : near)
      if (distance(samples.positions[s], p) <= reach) (samples.labels[s] > 0 ? plus : minus) = true;
    if (plus != minus) from_rim[i] = open.rim().curve().closest(p).distance();
  });
  const auto farthest = std::max_element(from_rim.begin(), from_rim.end());
  if (!(*farthest > reach)) return std::nullopt;
  return middle(static_cast<std::size_t>(farthest - from_rim.begin()));
}

std::optional<Vec3> bridged_place(const Rim& rim) {
  const auto bridged =
      std::find_if(rim.pieces().begin(), rim.pieces().end(), [](const RimPiece& p) { return !p.open; });
  if (bridged == rim.pieces().end()) return std::nullopt;
  return 0.5 * (bridged->a + bridged->b);
}

} // namespace

OpenTopology open_topology(const ToleranceVolume& volume) {
  OpenTopology now;
  for (const BoundaryComponent& c : volume.boundary_components())
    if (!volume.regions()[c.region.index()].shallow) now.boundary_characteristic += c.euler_characteristic;
  now.components = volume.volume_component_count();
  now.loops = volume.open_sides()->rim().loops().size();
  const InputTopology& input = volume.input();
  now.is_of_input = input.manifold && now.boundary_characteristic == 2 * *input.euler_characteristic &&
                    now.components == input.components && now.loops == *input.boundary_loops;
  return now;
}

std::optional<std::string> open_changes(const ToleranceVolume& volume, const BoundarySamples& samples,
                                        const RunControl& control) {
  const OpenSides* open = volume.open_sides();
  const InputTopology& input = volume.input();
  if (open == nullptr || open->by_samples() || open->rim().empty() || !input.manifold ||
      !input.euler_characteristic || !input.boundary_loops)
    return std::nullopt;
  const OpenTopology now = open_topology(volume);
  if (now.boundary_characteristic % 2 != 0 || now.is_of_input) return std::nullopt;
  const auto words = [](long chi, std::size_t parts, std::size_t curves) {
    return "χ = " + std::to_string(chi) + " in " + counted(parts, "component") + " with " +
           counted(curves, "loop");
  };
  auto at = place_with_one_side(volume, samples, control);
  if (!at) at = bridged_place(open->rim());
  return "Ω does not keep the open surface as it is: the input has " +
         words(*input.euler_characteristic, input.components, *input.boundary_loops) + ", Ω " +
         words(now.boundary_characteristic / 2, now.components, now.loops) +
         " of the rim. It closes what is narrower than twice the tolerance" +
         (at ? ", as near " + place(*at, place_digits) : std::string()) + ".";
}

} // namespace isoscope
