// Finds components of Ω' without an inside and measures them.
#include "tolerance/thin_parts.h"

#include "base/disjoint_sets.h"
#include "base/numbers.h"
#include "base/place.h"
#include "input/point_numbers.h"
#include "tolerance/region_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>

namespace isoscope {
namespace {

constexpr std::size_t most_named = 3; ///< parts in a sentence
/// Places of one closed part from which the largest thickness is climbed to.
constexpr std::size_t most_climbs = 24;
/// Of half the thickness: what is left of it beyond δ' has room for cells and samples.
constexpr double keeping_share = 0.9;
/// Each further try of a tolerance is smaller than the one before by this factor at least.
constexpr double next_try = 0.7;
constexpr int most_tries = 6;
/// Main cells of the octree for an area of δ'², and how many of them fit: beside them stand some samples
/// each.
constexpr double cells_by_area = 40, most_main_cells = 2e8;
/// Volumes of more cells are not built to try a tolerance.
constexpr double most_tried_cells = 2e6;

/// Rounds down to two significant digits.
double two_digits_below(double value) {
  if (!(value > 0)) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  char text[32]; // the decimal number itself, not a multiple of an inexact unit
  std::snprintf(text, sizeof text, "%.1e", std::floor(value / unit * (1 + 1e-6)) * unit);
  return std::strtod(text, nullptr);
}

/// Triangles that share corners, by the smallest of their ids.
DisjointSets connected_triangles(const ClosestPointIndex& index) {
  std::vector<Vec3> corners;
  PointNumbers numbers(corners);
  std::vector<std::uint32_t> first; ///< by corner, the triangle where it occurs first
  DisjointSets sets(index.size());
  for (std::uint32_t t = 0; t < index.size(); ++t)
    for (const Vec3 p : index.triangle(TriangleId(t))) {
      const std::uint32_t corner = numbers.number(p);
      if (corner == first.size()) first.push_back(t);
      sets.unite(first[corner], t);
    }
  return sets;
}

/// The probes of one closed part, deepest first.
using Probes = std::vector<ThicknessProbe>;

/// The deepest place that can be climbed to from the probes on the lost side.
ThicknessProbe deepest(const ToleranceVolume& volume, Probes probes, int side) {
  std::stable_sort(probes.begin(), probes.end(),
                   [](const auto& a, const auto& b) { return a.distance > b.distance; });
  ThicknessProbe best;
  std::size_t climbs = 0;
  for (const ThicknessProbe& probe : probes) {
    if (climbs == most_climbs) break;
    if (!(probe.distance > 0) || volume.sides().label(probe.middle) != side) continue;
    const ThicknessProbe top = climb(volume.index(), probe, 2 * volume.thresholds().delta);
    // A probe a rounding away from its wall may climb out through it.
    if (top.distance > best.distance && volume.sides().label(top.middle) == side) best = top;
    ++climbs;
  }
  return best;
}

void measure(const ToleranceVolume& volume, DisjointSets& connected, ThinPart& part) {
  std::map<std::uint32_t, Probes> by_closed_part;
  for (const ThicknessProbe& probe : probe_thickness(volume, part.volume_component))
    by_closed_part[connected.find(probe.wall.value)].push_back(probe);
  part.place = part.box.center();
  part.least_thickness = by_closed_part.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (auto& [root, probes] : by_closed_part) {
    const ThicknessProbe best = deepest(volume, std::move(probes), part.lost);
    if (2 * best.distance > part.thickness) part.thickness = 2 * best.distance, part.place = best.middle;
    part.least_thickness = std::min(part.least_thickness, 2 * best.distance);
  }
}

/// Where there are rooms the region that is too shallow tells, where the octree sees it, else walls that face
/// each other.
void measure_room(const ToleranceVolume& volume, ThinPart& part) {
  const auto take = [&](Vec3 p, double depth) {
    if (2 * depth > part.thickness) part.thickness = 2 * depth, part.place = p;
  };
  part.place = part.box.center();
  for (const BoundaryComponent& c : volume.boundary_components()) {
    const Region& region = volume.regions()[c.region.index()];
    if (c.volume_component == part.volume_component && region.shallow) take(region.deepest, region.depth);
  }
  const double enough = deep_enough * volume.thresholds().delta;
  if (part.thickness == 0)
    for (const ThicknessProbe& probe : probe_thickness(volume, part.volume_component)) {
      if (!(probe.distance > 0) || probe.distance > enough) continue;
      // What comes out in a wider place was not in this one.
      const ThicknessProbe top = climb(volume.index(), probe, 2 * volume.thresholds().delta);
      if (top.distance <= enough) take(top.middle, top.distance);
    }
  part.least_thickness = part.thickness;
}

/// The largest tolerance that keeps all of them, by their thickness.
double keeping_by_thickness(std::span<const ThinPart> parts) {
  double least = std::numeric_limits<double>::infinity();
  for (const ThinPart& part : parts)
    least = std::min(least, keeping_share * part.least_thickness / part.thinnest_kept());
  return least;
}

/// "thinner than twice the tolerance"
std::string thinner_words(const ThinPart& part) {
  return "thinner than " + (part.room ? general(part.thinnest_kept(), 2) + " times" : std::string("twice")) +
         " the tolerance";
}

} // namespace

std::vector<ThinPart> find_thin_parts(const ToleranceVolume& volume) {
  if (!volume.has_surface()) return {};
  std::vector<std::array<bool, 2>> has(volume.volume_component_count()); // an inside, an outside
  for (const BoundaryComponent& c : volume.boundary_components())
    has[c.volume_component][volume.regions()[c.region.index()].label < 0 ? 0 : 1] = true;
  std::vector<ThinPart> parts;
  std::vector<std::uint32_t> part_of(has.size(), 0);
  for (std::uint32_t c = 0; c < has.size(); ++c) {
    if (has[c][0] && has[c][1]) continue;
    if (volume.open_sides() != nullptr && volume.open_sides()->is_open_component(c)) continue;
    parts.emplace_back().volume_component = c;
    parts.back().lost = has[c][0] ? +1 : -1;
    parts.back().room = volume.has_rooms();
    part_of[c] = static_cast<std::uint32_t>(parts.size());
  }
  if (parts.empty()) return parts;
  for (std::size_t t = 0; t < volume.index().size(); ++t) {
    const std::uint32_t part = part_of[volume.volume_component(TriangleId(t))];
    if (part == 0) continue;
    ++parts[part - 1].triangles;
    for (const Vec3 p : volume.index().triangle(TriangleId(t))) parts[part - 1].box.add(p);
  }
  if (volume.has_rooms()) {
    for (ThinPart& part : parts) measure_room(volume, part);
    return parts;
  }
  DisjointSets connected = connected_triangles(volume.index());
  for (ThinPart& part : parts) measure(volume, connected, part);
  // A wall with the inside on both its sides encloses no gap that could close.
  std::erase_if(parts, [](const ThinPart& part) { return part.lost > 0 && part.thickness == 0; });
  return parts;
}

Result<KeepingTolerance> find_keeping_tolerance(const ToleranceVolume& volume,
                                                std::span<const ThinPart> parts, const RunControl& control) {
  const ToleranceThresholds& t = volume.thresholds();
  const double ratio = t.boundary / t.delta, surface = volume.field().area();
  const auto cells = [&](double delta) { return cells_by_area * surface / (ratio * ratio * delta * delta); };
  KeepingTolerance keeping{two_digits_below(keeping_by_thickness(parts)), true};
  for (int tries = 0; tries < most_tries && keeping.value > 0; ++tries) {
    keeping.fits = cells(keeping.value) <= most_main_cells;
    // A single closed part keeps what is deep enough; several may come apart at a smaller tolerance, and then
    // each must have an inside of its own.
    if (cells(keeping.value) > most_tried_cells || volume.input().components == 1) break;
    const auto smaller =
        ToleranceVolume::build(volume.shared_index(), volume.given_input(), {keeping.value, ratio}, control);
    if (control.cancelled()) return Error{ErrorCode::cancelled, "Stopped while looking for a tolerance.", ""};
    if (!smaller) break;
    const std::vector<ThinPart> left = find_thin_parts(*smaller);
    if (left.empty()) break;
    keeping.value = two_digits_below(std::min(next_try * keeping.value, keeping_by_thickness(left)));
  }
  return keeping;
}

Error thin_parts_error(const ToleranceVolume& volume, std::span<const ThinPart> parts,
                       const KeepingTolerance& keeping) {
  const auto thinnest =
      std::min_element(parts.begin(), parts.end(),
                       [](const ThinPart& a, const ThinPart& b) { return a.thickness < b.thickness; });
  const double delta = volume.thresholds().delta, edge = volume.index().bounds().longest_edge();
  Error error{ErrorCode::unsupported, "", ""};
  const bool one = parts.size() == 1, all = parts.size() == volume.volume_component_count(),
             gap = thinnest->lost > 0;
  const std::string where = place(thinnest->place, place_digits);
  const std::string width =
      general(thinnest->thickness, 3) + " (" + general(thinnest->thickness / delta, 3) + " δ)";
  const std::string thinner = thinner_words(*thinnest) + " everywhere";
  if (thinnest->room) {
    error.message =
        (one ? "A room of the input is " + thinner
             : std::to_string(parts.size()) + " rooms of the input are " + thinner + ", the thinnest one") +
        " around " + where + ", at most " + width + ": what is around takes " + (one ? "it." : "them.");
  } else if (one) {
    error.message = gap ? "A gap inside of the input is " : all ? "The input is " : "A part of the input is ";
    error.message += thinner + " around " + where + ", at most " + width + ": nothing is left " +
                     (gap ? "of it." : "inside of it.");
  } else {
    error.message = std::to_string(parts.size()) + " parts of the input are " + thinner +
                    ", the thinnest one, of " + width + " at most, around " + where +
                    ": nothing is left inside of them.";
  }
  if (keeping.value > 0) {
    const std::string value = general(keeping.value, 2) + " (" +
                              general(two_digits_below(100 * keeping.value / edge), 2) +
                              "% of the longest edge)";
    error.remedy = keeping.fits ? "Choose a tolerance of at most " + value
                                : "A tolerance that keeps " + std::string(one ? "it" : "them") +
                                      ", at most " + value + ", needs more memory than there is";
  } else {
    error.remedy = "No tolerance keeps what has no thickness";
  }
  if (!all)
    error.remedy += (keeping.value > 0 && keeping.fits ? ", or leave " : ": leave ") +
                    std::string(one ? "it" : "them") + " out with --drop-thin";
  error.remedy += ".";
  return error;
}

std::string left_out_words(std::span<const ThinPart> parts) {
  std::size_t triangles = 0;
  std::vector<const ThinPart*> largest;
  for (const ThinPart& part : parts) triangles += part.triangles, largest.push_back(&part);
  std::stable_sort(largest.begin(), largest.end(), [](const ThinPart* a, const ThinPart* b) {
    return a->box.longest_edge() > b->box.longest_edge();
  });
  const std::string what = parts.front().room ? " room" : " part";
  std::string words = std::to_string(parts.size()) + what + (parts.size() == 1 ? "" : "s") +
                      " of the input, " + thinner_words(parts.front()) + " everywhere, " +
                      (parts.size() == 1 ? "is" : "are") + " left out (" + std::to_string(triangles) +
                      (triangles == 1 ? " triangle)" : " triangles)");
  for (std::size_t i = 0; i < std::min(largest.size(), most_named); ++i) {
    words += (i == 0 ? ": " : "; ") + general(largest[i]->box.longest_edge(), 3) + " long and " +
             general(largest[i]->thickness, 3) + " thick around " + place(largest[i]->place, place_digits);
  }
  if (parts.size() > most_named) words += "; and smaller ones";
  return words + ".";
}

TriangleSoup without_parts(const TriangleSoup& soup, const ToleranceVolume& volume,
                           std::span<const ThinPart> parts) {
  TriangleSoup rest{soup.points, {}, soup.name};
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const std::uint32_t component = volume.volume_component(TriangleId(t));
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const ThinPart& p) { return p.volume_component == component; }))
      rest.triangles.push_back(soup.triangles[t]);
  }
  return rest;
}

} // namespace isoscope
