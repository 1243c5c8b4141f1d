// What the merge trees of φ say of a tolerance.
#include "tolerance/delta_study.h"

#include "tolerance/field_octree.h"
#include "tolerance/level_histories.h"
#include "tolerance/region_labels.h"
#include "tolerance/tolerance_volume.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

/// A region lasts that is cut off at less than this part of its depth.
constexpr double lasting_factor = 1.5;
/// Insides open at about the same δ, where the points are too few; necks of the model close later.
constexpr double same_opening = 1.3;
/// How far inside of the interval δ is proposed, and how much farther fewer components are looked for.
constexpr double above_separation = 1.15, search_factor = 1.5;
/// A neck at a level between these parts of δ' and of δ may be open for the one and closed for the other.
constexpr double neck_below = 0.97, neck_above = 1.05;
constexpr std::size_t curve_steps = 64;
constexpr std::size_t most_regions = 200;

/// Those that one surface may enclose: they open at about the same δ as the one that lasts longest.
std::vector<LastingRegion> find_insides(const std::vector<LastingRegion>& regions) {
  const auto lasts = [](const LastingRegion& r) { return r.depth / r.separation; };
  const auto main = std::max_element(regions.begin(), regions.end(),
                                     [&](const auto& a, const auto& b) { return lasts(a) < lasts(b); });
  std::vector<LastingRegion> insides;
  if (main == regions.end()) return insides;
  for (const LastingRegion& r : regions)
    if (r.separation <= same_opening * main->separation &&
        r.depth > deep_enough * above_separation * same_opening * main->separation)
      insides.push_back(r);
  if (insides.empty()) insides.push_back(*main);
  return insides;
}

std::vector<DeltaStudy::Step> make_curve(const LevelHistories& histories, double from, double to) {
  std::vector<DeltaStudy::Step> curve(curve_steps);
  for (std::size_t i = 0; i < curve_steps; ++i) {
    DeltaStudy::Step& step = curve[i];
    const double t = static_cast<double>(i) / (curve_steps - 1);
    step.delta = from * std::pow(to / from, t);
    step.regions = 1;
    step.components = 1; // the first of all ends nowhere
    for (const LevelPair& p : histories.regions) {
      if (!(p.death < step.delta && step.delta < p.birth)) continue;
      ++step.regions;
      if (p.birth > deep_enough * step.delta) ++step.deep;
    }
    for (const LevelPair& p : histories.components)
      if (p.birth <= step.delta && step.delta < p.death) ++step.components;
  }
  return curve;
}

/// Whether a neck of a deep region is as wide as Ω' leaves open and Ω may close: what is joined there is left
/// to chance.
bool has_neck(const LevelHistories& histories, double delta) {
  const double narrowest = neck_below * ToleranceVolume::Options().boundary_ratio * delta;
  return std::any_of(histories.regions.begin(), histories.regions.end(), [&](const LevelPair& p) {
    return p.death > narrowest && p.death < neck_above * delta && p.birth > deep_enough * delta;
  });
}

/// The least δ above the margin with as few components as there are at any δ a little larger, and no neck.
double propose(const DeltaStudy& study, const LevelHistories& histories, double separation) {
  const double from = above_separation * separation, to = std::min(study.most, search_factor * from);
  if (from >= study.most) return study.most > study.least ? std::sqrt(study.least * study.most) : 0;
  double best = from;
  std::pair<std::size_t, bool> fewest{~std::size_t{0}, true};
  for (const DeltaStudy::Step& step : study.curve) {
    if (step.delta * 1.001 < from || step.delta > to) continue;
    const double delta = std::max(from, step.delta);
    const std::pair here{step.components, has_neck(histories, delta)};
    if (here >= fewest) continue;
    fewest = here;
    best = delta;
  }
  return best;
}

} // namespace

Vec3 DeltaStudy::saddle() const {
  const auto last = std::max_element(insides.begin(), insides.end(), [](const auto& a, const auto& b) {
    return a.separation < b.separation;
  });
  return last == insides.end() ? Vec3{} : last->saddle;
}

Vec3 DeltaStudy::closing() const {
  const auto first = std::min_element(insides.begin(), insides.end(),
                                      [](const auto& a, const auto& b) { return a.depth < b.depth; });
  return first == insides.end() ? Vec3{} : first->deepest;
}

DeltaStudy study_delta(const ToleranceField& field, double finest, const RunControl& control) {
  DeltaStudy study;
  control.report("tolerances", -1);
  const FieldOctree octree(field, finest, control);
  if (control.cancelled() || octree.empty()) return study;
  const LevelHistories histories = find_histories(octree, control);
  if (control.cancelled()) return study;
  for (const LevelPair& p : histories.regions)
    if (p.birth > lasting_factor * p.death && p.death > 0)
      study.regions.push_back({p.death, p.birth, octree.center(p.saddle), octree.center(p.at)});
  std::stable_sort(study.regions.begin(), study.regions.end(),
                   [](const auto& a, const auto& b) { return a.depth > b.depth; });
  if (study.regions.size() > most_regions) study.regions.resize(most_regions);
  for (LastingRegion& r : study.regions) { // from the centre of a leaf to the top itself
    if (control.cancelled()) return study;
    const ThicknessProbe top =
        climb(field, {r.deepest, r.depth, {}}, std::numeric_limits<double>::infinity());
    r.deepest = top.middle;
    r.depth = top.distance;
  }
  study.insides = find_insides(study.regions);
  double from = finest, to = 4 * finest, separation = 0;
  if (!study.insides.empty()) {
    study.most = std::numeric_limits<double>::infinity();
    for (const LastingRegion& r : study.insides) {
      separation = std::max(separation, r.separation);
      study.most = std::min(study.most, r.depth / deep_enough);
    }
    study.least = separation / ToleranceVolume::Options().boundary_ratio;
    from = std::min(0.6 * separation, std::max(finest, 0.3 * separation));
    to = 1.05 * study.insides.front().depth;
  }
  study.curve = make_curve(histories, from, to);
  if (!study.insides.empty()) study.proposed = propose(study, histories, separation);
  return study;
}

} // namespace isoscope
