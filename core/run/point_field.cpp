// Sites of points, and which of them are left out.
#include "run/point_field.h"

#include "base/disjoint_sets.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/place.h"
#include "base/scramble.h"
#include "tolerance/closest_point.h"
#include "tolerance/region_labels.h"
#include "tolerance/witnessed_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>

namespace isoscope {
namespace {

/// A part of Ω' with so many of the sites is no blob of noise.
constexpr double largest_blob = 0.05;
/// So few balls enclose nothing deep. Seen from a place there, where φ is beyond 1.3 δ, each hides less than
/// asin(1/1.3) = 50.3° around its centre; seven need 51.03° to hide all around.
constexpr std::size_t largest_speck = 7;
/// Blobs that are told each for itself.
constexpr std::size_t told_blobs = 8;
/// Samples of triangles by δ², and at most: δ is five times the distance between neighbours, and Ω has holes
/// up to three. δ where none is known yet, relative to the longest edge.
constexpr double samples_by_square = 24, reference_delta = 0.02;
constexpr std::size_t most_samples = 2'000'000, fewest_samples = 1000;
/// Values of the study are right to about a tenth.
constexpr double study_error = 1.1;
/// How far around a saddle an opening is looked for, in units of its level, and by how many steps to each
/// side.
constexpr double opening_reach = 0.5;
constexpr std::size_t opening_steps = 10;

std::uint64_t digest_of(const TriangleSoup& soup) {
  std::uint64_t digest = golden_step;
  const auto add = [&](std::uint64_t value) { digest = scrambled(digest + golden_step) ^ value; };
  for (const Vec3 p : soup.points)
    for (int a = 0; a < 3; ++a) add(std::bit_cast<std::uint64_t>(p[a] + 0.0));
  for (const auto& t : soup.triangles)
    for (const std::uint32_t v : t) add(v);
  return digest;
}

std::shared_ptr<const TriangleSoup> points_of(const std::shared_ptr<const TriangleSoup>& input,
                                              std::optional<double> delta) {
  if (input->is_point_set()) return input;
  const double spacing = delta.value_or(reference_delta * input->bounds().longest_edge());
  const double wanted = samples_by_square * input->area() / (spacing * spacing);
  const auto n = static_cast<std::size_t>(
      std::clamp(wanted, static_cast<double>(fewest_samples), static_cast<double>(most_samples)));
  auto drawn = std::make_shared<TriangleSoup>();
  drawn->name = input->name;
  drawn->points = sample_area(*input, n, digest_of(*input));
  return drawn;
}

/// Without the sites for which `drops` holds; `why` of those that are dropped comes with them.
template <class Drops>
MadePointField without_sites(const MadePointField& from, const Drops& drops, double dropped_area,
                             const RunControl& control) {
  const WeightedPointIndex& index = *from.index;
  std::vector<WeightedPoint> sites;
  MadePointField made{std::make_shared<PointField>(*from.points), nullptr, from.left_out};
  LeftOutSites& left_out = made.left_out;
  if (left_out.sites.empty()) left_out.area = index.area();
  made.points->point.clear();
  for (std::uint32_t s = 0; s < index.size(); ++s) {
    const bool kept = !drops(s);
    (kept ? sites : left_out.sites).push_back(index.site(TriangleId(s)));
    (kept ? made.points->point : left_out.points)
        .push_back(from.points->point.empty() ? s : from.points->point[s]);
  }
  made.index = std::make_shared<const WeightedPointIndex>(sites, index.area() - dropped_area, control);
  return made;
}

/// All but the largest ones as one entry; `blobs` are of parts, largest first.
void fold_small(std::vector<DroppedPoints>& blobs) {
  if (blobs.size() <= told_blobs + 1) return;
  DroppedPoints rest = blobs[told_blobs];
  for (std::size_t i = told_blobs + 1; i < blobs.size(); ++i) {
    rest.points += blobs[i].points;
    rest.parts += blobs[i].parts;
    rest.size = std::max(rest.size, blobs[i].size);
  }
  blobs.resize(told_blobs);
  blobs.push_back(rest);
}

std::string percent(double part, double whole) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * part / whole);
  return text;
}

PointDistances::Quantiles quantiles(std::vector<double> distances) {
  std::sort(distances.begin(), distances.end());
  const auto at = [&](double part) {
    if (distances.empty()) return 0.0;
    const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(distances.size())));
    return distances[std::clamp<std::size_t>(rank, 1, distances.size()) - 1];
  };
  return {at(0.5), at(0.9), at(0.99), at(1)};
}

/// `opened`: a passage was found at the study's saddle.
Error nothing_inside(const DeltaStudy& study, double delta, bool opened) {
  const std::string what = "At this tolerance the volume around the points encloses nothing";
  if (!study.found())
    return {ErrorCode::open_surface, what + ".", "Points of an open surface are taken with --gamma auto."};
  const std::string why =
      opened || delta < study.least
          ? ": it has holes, as between the points near " + place(study.saddle(), place_digits) + "."
      : delta > study.most
          ? ": the inside is closed up, as around " + place(study.closing(), place_digits) + "."
          : ": it has holes.";
  return {ErrorCode::open_surface, what + why, enclosing_remedy(study)};
}

/// Whether Ω' is open where the study saw an inside open: balls outside of Ω' around the nodes of a lattice
/// there, joined where they overlap, lead to both sides; or its level there exceeds δ' by more than the study
/// errs.
bool is_open_at(const LastingRegion& inside, const ToleranceVolume& volume) {
  const double boundary = volume.thresholds().boundary;
  if (inside.separation > study_error * boundary) return true;
  if (!(inside.separation > boundary)) return false;
  constexpr std::size_t n = 2 * opening_steps + 1;
  const double spacing = inside.separation * opening_reach / opening_steps;
  std::vector<double> radius(n * n * n);
  DisjointSets joined(radius.size());
  std::vector<std::array<bool, 2>> leads(radius.size()); // by set: outside, inside
  const std::array<std::size_t, 3> strides{1, n, n * n};
  const auto coordinates = [&](std::size_t i) { return std::array{i % n, i / n % n, i / (n * n)}; };
  const auto position = [&](std::size_t i) {
    Vec3 p = inside.saddle;
    const auto at = coordinates(i);
    for (int a = 0; a < 3; ++a)
      p[a] += spacing * (static_cast<double>(at[static_cast<std::size_t>(a)]) - opening_steps);
    return p;
  };
  for (std::size_t i = 0; i < radius.size(); ++i) {
    radius[i] = volume.field().distance(position(i)) - boundary;
    const auto at = coordinates(i);
    for (std::size_t a = 0; a < 3; ++a)
      if (at[a] > 0 && std::min(radius[i], radius[i - strides[a]]) > 0 &&
          radius[i] + radius[i - strides[a]] > spacing)
        joined.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i - strides[a]));
  }
  for (std::size_t i = 0; i < radius.size(); ++i) {
    if (!(radius[i] > 0)) continue;
    const int label = label_above(volume, position(i));
    if (label == 0) continue;
    std::array<bool, 2>& both = leads[joined.find(static_cast<std::uint32_t>(i))];
    both[label < 0 ? 1 : 0] = true;
    if (both[0] && both[1]) return true;
  }
  return false;
}

/// An inside by the octree's main cells although Ω' has a passage there, which they are too coarse to show.
bool has_hidden_opening(const PointField& points, const ToleranceVolume& volume) {
  return std::any_of(points.study.insides.begin(), points.study.insides.end(),
                     [&](const LastingRegion& inside) {
                       return label_above(volume, inside.deepest) < 0 && is_open_at(inside, volume);
                     });
}

} // namespace

std::size_t PointField::dropped_points() const {
  std::size_t n = 0;
  for (const DroppedPoints& d : dropped) n += d.points;
  return n;
}

std::vector<bool> PointField::kept() const {
  std::vector<bool> kept(points->points.size(), point.empty());
  for (const std::uint32_t p : point) kept[p] = true;
  return kept;
}

std::vector<std::string> PointField::notes(double delta, double longest_edge, bool open) const {
  std::vector<std::string> notes;
  const auto n = static_cast<double>(points->points.size());
  const auto length = [&](double l) {
    return general(l, 3) + " (" + percent(l, longest_edge) + " of the longest edge)";
  };
  std::string made =
      drawn ? "The triangles are taken as " + counted(points->points.size(), "sample") + " of their area: "
            : counted(points->points.size(), "point") + " without triangles: ";
  if (neighbors == 1)
    made += "φ is the distance to the nearest.";
  else
    made += "φ is the witnessed k-distance with k = " + std::to_string(neighbors) +
            (automatic ? ", as " + percent(outlying, 1) + " of the points stand far from all others." : ".");
  notes.push_back(std::move(made));
  if (open) {
    // Nothing is asked to be enclosed.
  } else if (study.found()) {
    std::string interval = "Ω encloses what the points are on for δ from " + length(study.least) + " to " +
                           length(study.most) + "; the first opening is near " +
                           place(study.saddle(), place_digits) + ".";
    if (delta < study.least)
      interval += " The tolerance is below that: inside and outside may be joined there.";
    else if (delta > study.most)
      interval += " The tolerance is beyond that: what is narrower than " + general(delta, 3) +
                  " is closed up, as the inside around " + place(study.closing(), place_digits) + ".";
    notes.push_back(std::move(interval));
  } else {
    notes.emplace_back("No tolerance was found at which Ω encloses something.");
  }
  for (const DroppedPoints& d : dropped) {
    const std::string which =
        counted(d.points, "point") + " (" + percent(static_cast<double>(d.points), n) + ")";
    if (d.why == DroppedPoints::Why::outliers)
      notes.push_back(which + (d.points == 1 ? " is an outlier and left out" : " are outliers and left out") +
                      ": φ at them exceeds δ; one is at " + place(d.place, place_digits) + ".");
    else if (d.parts > 1)
      notes.push_back(which + " in " + grouped(d.parts) + " parts" +
                      (d.size > 0 ? " of size " + general(d.size, 3) + " or less" : std::string()) +
                      " enclose nothing and are left out; one is at " + place(d.place, place_digits) + ".");
    else
      notes.push_back(
          which + " around " + place(d.place, place_digits) + " of size " + general(d.size, 3) +
          (d.points == 1 ? " encloses nothing and is left out." : " enclose nothing and are left out."));
  }
  return notes;
}

bool is_field_of_points(const TriangleSoup& input, const RunParameters& parameters) {
  return input.is_point_set() || parameters.robust.neighbors > Robust::off;
}

MadePointField make_point_field(const std::shared_ptr<const TriangleSoup>& input,
                                const RunParameters& parameters, std::optional<double> delta,
                                const RunControl& control) {
  MadePointField made{std::make_shared<PointField>(), nullptr, {}};
  PointField& field = *made.points;
  field.points = points_of(input, delta);
  field.drawn = field.points != input;
  const auto neighbors = static_cast<std::size_t>(parameters.robust.neighbors);
  const WitnessedDistance distance = witness_distance(field.points->points, neighbors, control);
  if (control.cancelled()) return made;
  field.neighbors = distance.neighbors;
  field.automatic = distance.automatic;
  field.outlying = distance.outlying;
  made.index = std::make_shared<const WeightedPointIndex>(distance.sites, distance.area, control);
  if (control.cancelled()) return made;
  field.study = study_delta(*made.index, distance.finest(), control);
  return made;
}

MadePointField without_strays(const MadePointField& from, double delta, double boundary,
                              const RunControl& control) {
  // Balls of outliers are empty: of no component.
  const VolumeComponents components = from.index->components(boundary, control);
  if (control.cancelled()) return from;
  const std::size_t all = from.index->size();
  const auto is_outlier = [&](std::uint32_t s) {
    return from.index->site(TriangleId(s)).weight >= delta * delta;
  };
  DroppedPoints outliers, specks{DroppedPoints::Why::blob, 0, {}, 0, 0};
  Box3 box;
  std::vector<std::size_t> sites(components.count);
  std::vector<Box3> boxes(components.count);
  for (std::uint32_t s = 0; s < all; ++s) {
    if (is_outlier(s)) {
      const Vec3 at = from.points->points->points[from.points->point.empty() ? s : from.points->point[s]];
      if (outliers.points++ == 0) outliers.place = at;
      box.add(at);
    }
    const std::uint32_t c = components.of_triangle[s];
    if (c == VolumeComponents::none || ++sites[c] > largest_speck) continue;
    boxes[c].add(from.index->site(TriangleId(s)).center);
  }
  if (outliers.points == all) return from;
  outliers.size = box.longest_edge();
  const auto n = static_cast<double>(all - outliers.points);
  const auto is_small = [&](std::uint32_t c) {
    return sites[c] <= largest_speck && static_cast<double>(sites[c]) < largest_blob * n;
  };
  for (std::uint32_t c = 0; c < components.count; ++c) {
    if (!is_small(c)) continue;
    specks.size = std::max(specks.size, boxes[c].longest_edge());
    ++specks.parts;
  }
  if (specks.parts == components.count) specks.parts = 0; // nothing would be left
  const auto is_speck = [&](std::uint32_t s) {
    const std::uint32_t c = components.of_triangle[s];
    return specks.parts > 0 && c != VolumeComponents::none && is_small(c);
  };
  for (std::uint32_t s = 0; s < all; ++s)
    if (is_speck(s) && specks.points++ == 0) specks.place = from.index->site(TriangleId(s)).center;
  if (outliers.points + specks.points == 0) return from;
  const double area = from.index->area() * static_cast<double>(specks.points) / n;
  MadePointField made = without_sites(
      from, [&](std::uint32_t s) { return is_outlier(s) || is_speck(s); }, area, control);
  for (const DroppedPoints& dropped : {outliers, specks})
    if (dropped.points > 0) made.points->dropped.push_back(dropped);
  return made;
}

MadePointField with_all_sites(const MadePointField& from, const RunControl& control) {
  const LeftOutSites& left_out = from.left_out;
  if (left_out.sites.empty()) return from;
  std::vector<WeightedPoint> sites(from.index->size() + left_out.sites.size());
  for (std::uint32_t s = 0; s < from.index->size(); ++s)
    sites[from.points->point[s]] = from.index->site(TriangleId(s));
  for (std::size_t i = 0; i < left_out.sites.size(); ++i) sites[left_out.points[i]] = left_out.sites[i];
  MadePointField made{std::make_shared<PointField>(*from.points), nullptr, {}};
  made.points->point.clear();
  made.points->dropped.clear();
  made.index = std::make_shared<const WeightedPointIndex>(sites, left_out.area, control);
  return made;
}

std::string enclosing_remedy(const DeltaStudy& study) {
  return "Ω encloses something for δ from " + general(study.least, 3) + " to " + general(study.most, 3) +
         ": choose --tolerance auto, or a length between them; of an open surface --gamma 2.";
}

Error nothing_inside_between(double least, double most) {
  return {ErrorCode::open_surface,
          "The volume around the points encloses nothing at any tolerance that was tried, from " +
              general(least, 3) + " to " + general(most, 3) + ": it has holes.",
          "Give more points where they are sparse; those of an open surface are taken with --gamma 2."};
}

std::vector<std::uint8_t> sheets_among(const ToleranceVolume& volume) {
  std::vector<std::array<bool, 2>> has(volume.volume_component_count()); // an inside, an outside
  for (const BoundaryComponent& c : volume.boundary_components())
    has[c.volume_component][volume.regions()[c.region.index()].label < 0 ? 0 : 1] = true;
  std::vector<std::uint8_t> sheets;
  for (const auto& [inside, outside] : has) sheets.push_back(inside && outside ? 0 : 1);
  return sheets;
}

Result<MadePointField> without_blobs(const MadePointField& from, const ToleranceVolume& volume,
                                     bool may_be_sheets, const RunControl& control) {
  const auto regions = volume.regions();
  if (!may_be_sheets &&
      std::none_of(regions.begin(), regions.end(), [](const Region& r) { return r.label < 0 && !r.shallow; }))
    return nothing_inside(from.points->study, volume.thresholds().delta, false);
  if (!may_be_sheets && has_hidden_opening(*from.points, volume))
    return nothing_inside(from.points->study, volume.thresholds().delta, true);
  const std::size_t components = volume.volume_component_count();
  const std::vector<std::uint8_t> one_sided = sheets_among(volume);
  std::vector<DroppedPoints> blobs(components);
  std::vector<Box3> boxes(components);
  const std::size_t n = from.index->size();
  for (std::uint32_t s = 0; s < n; ++s) {
    const std::uint32_t c = volume.volume_component(TriangleId(s));
    if (c == VolumeComponents::none || one_sided[c] == 0) continue;
    const Vec3 at = from.index->site(TriangleId(s)).center;
    if (blobs[c].points++ == 0) blobs[c] = {DroppedPoints::Why::blob, 1, at, 0, 1};
    boxes[c].add(at);
  }
  std::vector<DroppedPoints> dropped;
  std::size_t all = 0;
  for (std::size_t c = 0; c < components; ++c) {
    if (blobs[c].points == 0) continue;
    blobs[c].size = boxes[c].longest_edge();
    const bool small = static_cast<double>(blobs[c].points) < largest_blob * static_cast<double>(n);
    if (!small && may_be_sheets) {
      blobs[c].points = 0;
      continue;
    }
    all += blobs[c].points;
    dropped.push_back(blobs[c]);
    if (small) continue;
    return Error{ErrorCode::open_surface,
                 "A part of the points, " +
                     percent(static_cast<double>(blobs[c].points), static_cast<double>(n)) +
                     " of them around " + place(blobs[c].place, place_digits) +
                     ", encloses nothing at this tolerance.",
                 "A larger tolerance closes gaps; --gamma 2 takes the part for an open surface; remove it if "
                 "it is none of the surface."};
  }
  if (dropped.empty()) return from;
  std::stable_sort(dropped.begin(), dropped.end(),
                   [](const auto& a, const auto& b) { return a.points > b.points; });
  fold_small(dropped);
  const auto drops = [&](std::uint32_t s) {
    const std::uint32_t c = volume.volume_component(TriangleId(s));
    return c != VolumeComponents::none && blobs[c].points > 0;
  };
  const double area = from.index->area() * static_cast<double>(all) / static_cast<double>(n);
  MadePointField made = without_sites(from, drops, area, control);
  std::vector<DroppedPoints>& list = made.points->dropped;
  list.insert(list.end(), dropped.begin(), dropped.end());
  return made;
}

Result<double> proposed_tolerance(const DeltaStudy& study) {
  if (study.found()) return study.proposed;
  return Error{ErrorCode::open_surface, "No tolerance was found at which the volume encloses something.",
               "Points of an open surface are taken with --gamma auto."};
}

std::optional<PointDistances> measure_points(const PointField& points, const TriangleMesh& mesh, double limit,
                                             const RunControl& control) {
  if (mesh.triangles.empty()) return {};
  const ClosestPointIndex index({mesh.points, mesh.triangles, {}});
  const std::vector<Vec3>& all = points.points->points;
  std::vector<double> of_all(all.size());
  if (!parallel_until(all.size(), 256, control, [&](std::size_t i) { of_all[i] = index.distance(all[i]); }))
    return {};
  PointDistances distances;
  const std::vector<bool> kept = points.kept();
  std::vector<double> of_kept;
  double most = -1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!kept[i]) continue;
    of_kept.push_back(of_all[i]);
    if (of_all[i] > limit) ++distances.far;
    if (of_all[i] > most) most = of_all[i], distances.farthest = all[i];
  }
  distances.all = quantiles(std::move(of_all));
  distances.kept = quantiles(std::move(of_kept));
  return distances;
}

} // namespace isoscope
