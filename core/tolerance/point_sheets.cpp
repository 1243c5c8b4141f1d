// Samples, balls, curves, in that order.
#include "tolerance/point_sheets.h"

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/place.h"
#include "tolerance/ball_test.h"
#include "tolerance/rim_curves.h"
#include "tolerance/sample_estimate.h"
#include "tolerance/sample_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace isoscope {
namespace {

/// The samples of the test, in units of δ', unless they are more than so many.
constexpr double test_density = 0.25;
constexpr double most_test_samples = 4e6;

/// Balls of this radius, in units of δ', around sites reach samples of both sides; so much of the sites, at
/// most, has no such sides: of narrow ends.
constexpr double both_sides_within = 2, most_one_sided = 0.02;

/// The component of Ω' of each site; of those that give no place of it, one of the sheets.
std::vector<std::uint32_t> component_of_sites(const ToleranceVolume& volume,
                                              std::span<const std::uint8_t> sheets) {
  const auto first = static_cast<std::uint32_t>(std::find(sheets.begin(), sheets.end(), 1) - sheets.begin());
  std::vector<std::uint32_t> component(volume.field().size());
  for (std::uint32_t s = 0; s < component.size(); ++s) {
    component[s] = volume.volume_component(TriangleId(s));
    if (component[s] == VolumeComponents::none) component[s] = first;
  }
  return component;
}

/// A sheet with so many handles and loops has χ = 2 - 2 handles - loops, and Ω' twice that around it.
std::optional<Error> misfit(const ToleranceVolume& volume, std::span<const std::uint8_t> sheets,
                            std::span<const std::uint32_t> component, const Rim& rim) {
  std::vector<std::uint32_t> sheet_of(rim.loops().size(), 0);
  for (const RimPiece& piece : rim.pieces())
    if (piece.open) sheet_of[piece.loop] = component[piece.triangle.index()];
  for (std::uint32_t c = 0; c < sheets.size(); ++c) {
    if (sheets[c] == 0) continue;
    long chi = 0, loops = 0;
    bool told = true;
    for (const BoundaryComponent& b : volume.boundary_components()) {
      if (b.volume_component != c || volume.regions()[b.region.index()].shallow) continue;
      chi += b.euler_characteristic;
      told = told && b.told;
    }
    const RimLoop* shortest = nullptr;
    for (std::size_t l = 0; l < sheet_of.size(); ++l) {
      if (sheet_of[l] != c) continue;
      ++loops;
      if (shortest == nullptr || rim.loops()[l].length < shortest->length) shortest = &rim.loops()[l];
    }
    const long twice_handles = 2 - loops - chi / 2;
    if (loops > 0 && (!told || (twice_handles >= 0 && twice_handles % 2 == 0))) continue;
    const auto of =
        static_cast<std::size_t>(std::find(component.begin(), component.end(), c) - component.begin());
    const Vec3 at = shortest != nullptr ? shortest->center : volume.field().place_of(TriangleId(of));
    return Error{ErrorCode::open_surface,
                 "By the balls of --gamma the sheet of points has " +
                     counted(static_cast<std::size_t>(loops), "loop") +
                     (loops > 0 ? ", the shortest near " : " near ") + place(at, place_digits) +
                     ", which does not fit Ω, whose χ is " + std::to_string(chi / 2) + " there.",
                 "A larger tolerance closes pinholes between points; where sheets are narrow take a smaller "
                 "one, or a smaller --gamma."};
  }
  return std::nullopt;
}

/// A site around which both sides are, is on the sheet between them. Where more than few have one side only,
/// the sides meet far from where the points end.
std::optional<Error> sheet_on_one_side(const ToleranceVolume& volume, const BoundarySamples& samples,
                                       std::span<const std::uint8_t> sheets,
                                       std::span<const std::int8_t> labels, const RunControl& control) {
  const double reach = both_sides_within * volume.thresholds().boundary;
  SampleGrid grid(volume.domain().lo, 0.5 * reach);
  for (const Vec3 p : samples.positions) grid.add(p);
  const auto has_both = [&](Vec3 at, std::vector<std::uint32_t>& near) {
    near.clear();
    grid.gather(Box3{at, at}.grown(reach), near);
    bool plus = false, minus = false;
    for (const std::uint32_t i : near)
      if (labels[i] != 0 && distance(samples.positions[i], at) <= reach)
        (labels[i] > 0 ? plus : minus) = true;
    return plus && minus;
  };
  std::vector<std::uint8_t> one_sided(volume.field().size(), 0), counts(one_sided.size(), 0);
  parallel_until(one_sided.size(), 256, control, [&](std::size_t s) {
    const TriangleId site(s);
    const std::uint32_t c = volume.volume_component(site);
    if (c == VolumeComponents::none || sheets[c] == 0) return;
    std::vector<std::uint32_t> near;
    counts[s] = 1;
    one_sided[s] = has_both(volume.field().place_of(site), near) ? 0 : 1;
  });
  const auto all = static_cast<double>(std::count(counts.begin(), counts.end(), 1));
  const auto first = std::find(one_sided.begin(), one_sided.end(), 1);
  const auto few = static_cast<double>(std::count(first, one_sided.end(), 1));
  if (few <= most_one_sided * all) return std::nullopt;
  const TriangleId at(static_cast<std::size_t>(first - one_sided.begin()));
  return Error{ErrorCode::open_surface,
               "Around " + general(std::round(100 * few / all), 3) + " % of the points, as near " +
                   place(volume.field().place_of(at), place_digits) +
                   ", the balls of --gamma find one side only: the sheets of the points are narrow there, or "
                   "meet where Ω joins them.",
               "Choose a smaller tolerance, or a smaller --gamma, and leave out what is of no sheet."};
}

Result<PointSheets> judge(const ToleranceVolume& volume, const BoundarySamples& samples,
                          const std::vector<std::uint8_t>& sheets, double gamma, const RunControl& control) {
  const double boundary = volume.thresholds().boundary;
  const auto told = tell_sheet_sides(volume, samples, sheets, gamma, control);
  if (!told) return told.error();
  if (auto error = sheet_on_one_side(volume, samples, sheets, told->labels, control))
    return std::move(*error);
  const auto curves = find_rim_curves(volume, samples, told->labels, control);
  if (!curves) return curves.error();
  PointSheets found{nullptr, gamma, samples.size(), told->boundary_samples};
  if (control.cancelled()) return found;
  Rim rim(*curves, volume.field(), boundary);
  std::vector<std::uint32_t> component = component_of_sites(volume, sheets);
  if (auto error = misfit(volume, sheets, component, rim)) return std::move(*error);
  std::array<std::vector<Vec3>, 2> by_side;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (told->labels[i] != 0) by_side[told->labels[i] > 0 ? 1 : 0].push_back(samples.positions[i]);
  found.sides =
      std::make_shared<const OpenSides>(volume.shared_field(), std::move(component), sheets, by_side,
                                        std::move(rim), rim_curve_margin * boundary, boundary);
  return found;
}

} // namespace

Result<PointSheets> find_point_sheets(ToleranceVolume& volume, const std::vector<std::uint8_t>& sheets,
                                      std::span<const double> gammas, const RunControl& control) {
  const double densest = test_density * volume.thresholds().boundary;
  const SampleEstimate estimate = estimate_samples(volume);
  double sigma = densest;
  while (sigma < 2 * densest && estimate.samples(sigma) > most_test_samples) sigma *= 1.1;
  const auto samples = sample_boundary(volume, sigma, control);
  if (!samples) return samples.error();
  control.report("sides of open sheets", -1);
  std::optional<Error> first;
  for (const double gamma : gammas) {
    auto found = judge(volume, *samples, sheets, gamma, control);
    if (found || control.cancelled()) return found;
    if (!first) first = found.error();
  }
  return std::move(*first);
}

} // namespace isoscope
