// Sweeps of relocations and flips, certificates that add samples, and the decision when to give up.
#include "improve/repair.h"

#include "improve/facet_intersection.h"
#include "improve/joint_relocation.h"
#include "improve/swept_witness.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <numeric>

namespace isoscope {
namespace {

constexpr std::size_t certificate_budget = 4000;
/// A point above this share of δ counts as a violation: deciding closer to δ takes many more pieces and gains
/// nothing.
constexpr double reject_from = 0.998;
constexpr std::size_t most_extra = 40;    ///< samples a facet may gather
constexpr std::size_t most_witnesses = 6; ///< of which one certificate
constexpr int relocation_rounds = 2;
constexpr int joint_rounds = 3;
constexpr int collapse_retries = 4;   ///< of a collapse without repair whose certificate failed
constexpr int relocation_retries = 2; ///< of a relocation whose certificate failed

struct Proof {
  std::uint32_t failures = 0;
  double distance = 0; ///< of the worst violating point
  Vec3 witness;
  PatchVerdict::Corners facet{};
};

/// Certifies all unproven facets; true where all are inside Ω.
bool prove_all(const InputSurface& input, FacetComplex& complex) {
  const double delta = input.delta();
  std::vector<Vec3> witness;
  for (Facet& facet : complex.facets) {
    if (!facet.alive() || facet.proven) continue;
    const FacetSearch search{certificate_budget, facet.seed, &witness, 1, nullptr, nullptr, input.parts()};
    const FacetVerdict verdict =
        certify_facet(input.field(), complex.triangle(facet), delta, reject_from * delta, search);
    if (verdict.kind != FacetVerdict::Kind::inside) return false;
    facet.proven = true;
  }
  return true;
}

/// Certifies all unproven facets; violating points become samples of their facets.
Proof prove(const InputSurface& input, FacetComplex& complex) {
  Proof proof;
  const double delta = input.delta();
  std::vector<Vec3> witnesses;
  for (std::uint32_t f = 0; f < complex.facets.size(); ++f) {
    Facet& facet = complex.facets[f];
    if (!facet.alive() || facet.proven) continue;
    const Triangle3 t = complex.triangle(facet);
    witnesses.clear();
    const FacetVerdict verdict = certify_facet(input.field(), t, delta, reject_from * delta,
                                               FacetSearch{certificate_budget, facet.seed, &witnesses,
                                                           most_witnesses, nullptr, nullptr, input.parts()});
    if (verdict.kind == FacetVerdict::Kind::inside) {
      facet.proven = true;
      continue;
    }
    if (verdict.kind == FacetVerdict::Kind::undecided) witnesses.push_back(verdict.witness);
    const double d = verdict.kind == FacetVerdict::Kind::outside ? verdict.closest.distance() : delta;
    if (d >= proof.distance) proof.distance = d, proof.witness = verdict.witness, proof.facet = facet.v;
    if (facet.extra.size() + witnesses.size() > most_extra) facet.extra.clear();
    for (const Vec3 w : witnesses) facet.extra.push_back(weights_of(w, t));
    proof.failures += static_cast<std::uint32_t>(witnesses.size());
    measure_facet(input, complex, f);
  }
  return proof;
}

/// Proves the unproven border edges of a patch to keep to the rim.
PatchVerdict prove_border(const InputSurface& input, FacetComplex& complex) {
  for (std::uint32_t v = 0; v < complex.border.size(); ++v) {
    BorderEdge& edge = complex.border[v];
    if (!edge.here() || edge.proven) continue;
    const BorderVerdict verdict = input.gate()->keeps_to_rim({complex.points[v], complex.points[edge.next]});
    if (!verdict.proven)
      return {Refusal{Reason::border_distance, verdict.distance, input.delta(), verdict.witness},
              complex.facets[complex.facet_left_of(v, edge.next)].v};
    edge.proven = true;
  }
  return {};
}

/// Condition 3 of the changed facets. Where more tests fail than before, the failed ones become samples of
/// their facets.
PatchVerdict check_orientation(const SurfaceRules& rules, SurfacePatch& patch) {
  std::uint32_t before = patch.start_misoriented, after = 0;
  std::vector<std::pair<std::uint32_t, std::vector<SideSample>>> failed;
  for (std::uint32_t f = 0; f < patch.complex.facets.size(); ++f) {
    Facet& facet = patch.complex.facets[f];
    if (!patch.changed(f)) before -= facet.misoriented;
    if (!patch.changed(f) || !facet.alive()) continue;
    auto failures = rules.orientation->failures(patch.complex.triangle(facet), facet.labels);
    facet.misoriented = static_cast<std::uint8_t>(failures.size());
    after += facet.misoriented;
    if (!failures.empty()) failed.emplace_back(f, std::move(failures));
  }
  if (after <= before) return {};
  const auto& worst = *std::max_element(failed.begin(), failed.end(), [](const auto& a, const auto& b) {
    return a.second.size() < b.second.size();
  });
  const PatchVerdict::Corners& corners = patch.complex.facets[worst.first].v;
  PatchVerdict verdict{{Reason::normals, double(after), double(before), patch.complex.points[corners[0]]},
                       corners};
  verdict.points_added = after;
  for (const auto& [f, sides] : failed) {
    Facet& facet = patch.complex.facets[f];
    if (facet.sides.size() >= most_extra) facet.sides.clear();
    facet.sides.insert(facet.sides.end(), sides.begin(), sides.end());
    measure_facet(*rules.input, patch.complex, f);
  }
  return verdict;
}

/// Where more facets are folded than before: one of them, the last.
std::optional<PatchVerdict::Corners> find_fold(const SurfacePatch& patch) {
  std::uint32_t folded = 0;
  std::optional<PatchVerdict::Corners> last;
  for (const Facet& f : patch.complex.facets)
    if (f.alive() && f.folded) last = f.v, ++folded;
  return folded > patch.start_folded ? last : std::nullopt;
}

/// A witness that lies between the facets as they were and as they are.
std::optional<Vec3> find_swept(const SurfaceRules& rules, const SurfacePatch& patch) {
  if (!patch.complex.strata.empty()) return swept_witness_between_rooms(rules.witnesses, patch);
  std::vector<Triangle3> before, after;
  for (std::size_t f = 0; f < patch.complex.facets.size(); ++f) {
    if (!patch.changed(f)) continue;
    before.push_back(patch.start_triangle(f));
    if (patch.complex.facets[f].alive()) after.push_back(patch.complex.triangle(patch.complex.facets[f]));
  }
  return swept_witness(rules.witnesses, before, after);
}

/// Everything but certificates: fold, orientation, witnesses.
PatchVerdict check_shape(const SurfaceRules& rules, SurfacePatch& patch) {
  if (const auto fold = find_fold(patch))
    return {Refusal{Reason::folded, 0, 0, patch.complex.points[(*fold)[0]]}, *fold};
  for (std::size_t f = 0; f < patch.complex.facets.size(); ++f) {
    const Facet& facet = patch.complex.facets[f];
    if (!patch.changed(f) || !facet.alive()) continue;
    const Triangle3 t = patch.complex.triangle(facet);
    if (is_degenerate(t)) return {Refusal{Reason::folded, 0, 0, t[0]}, facet.v};
  }
  if (const auto swept = find_swept(rules, patch)) return Refusal{Reason::witness_side, 0, 0, *swept};
  return rules.orientation ? check_orientation(rules, patch) : PatchVerdict{};
}

/// The state of a patch between two sweeps.
struct Level {
  double largest = 0, energy = 0;
  Vec3 where;                                ///< a corner of the facet of the largest d
  PatchVerdict::Corners worst{};             ///< that facet
  Triangle3 place{};                         ///< where it lies
  std::optional<PatchVerdict::Corners> fold; ///< a folded one, where there are more than before

  PatchVerdict::Corners facet() const { return fold.value_or(worst); }
};

Level measure(const SurfacePatch& patch) {
  Level level;
  const auto add = [&](const Facet& f, double largest, double energy) {
    if (largest > level.largest)
      level.largest = largest, level.worst = f.v, level.place = patch.complex.triangle(f),
      level.where = level.place[0];
    level.energy += energy;
  };
  for (const Facet& f : patch.complex.facets)
    if (f.alive()) add(f, f.largest, f.energy);
  for (std::uint32_t v = 0; v < patch.complex.border.size(); ++v) {
    const BorderEdge& edge = patch.complex.border[v];
    if (edge.here())
      add(patch.complex.facets[patch.complex.facet_left_of(v, edge.next)], edge.largest, edge.energy);
  }
  level.fold = find_fold(patch);
  return level;
}

double worst_energy(const FacetComplex& complex, std::uint32_t v) {
  double worst = 0;
  for (const std::uint32_t f : complex.stars[v]) worst = std::max(worst, complex.facets[f].energy);
  if (complex.on_border(v))
    for (const std::uint32_t w : {v, complex.border_before(v)})
      worst = std::max(worst, complex.border[w].energy);
  return worst;
}

/// By local vertex: whether it was found at its best place and nothing in its star has changed since.
using Settled = std::vector<std::uint8_t>;

void unsettle(const Facet& facet, Settled& settled) {
  for (const std::uint32_t v : facet.v) settled[v] = 0;
}

/// An edge by its ends, ascending.
using EdgeOfPatch = std::pair<std::uint32_t, std::uint32_t>;

/// Relocates all free vertices, those with the worst facet first.
void relocate_in_turn(const InputSurface& input, SurfacePatch& patch, Settled& settled, RepairSweep& record) {
  FacetComplex& complex = patch.complex;
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t v = 0; v < complex.points.size(); ++v)
    if (patch.free[v] && !settled[v] && complex.alive_vertex(v))
      order.emplace_back(-worst_energy(complex, v), v);
  std::sort(order.begin(), order.end());
  for (const auto& [key, v] : order) {
    settled[v] = 1;
    if (!relocate(input, patch, v, relocation_rounds)) continue;
    for (const std::uint32_t f : complex.stars[v]) unsettle(complex.facets[f], settled);
    ++record.moved;
  }
}

/// Relocates all free vertices, then tries to flip the edges of facets that changed, but not `kept`.
void sweep(const InputSurface& input, SurfacePatch& patch, const std::optional<EdgeOfPatch>& kept,
           bool jointly, Settled& settled, RepairSweep& record) {
  FacetComplex& complex = patch.complex;
  if (jointly && relocate_jointly(input, patch, joint_rounds))
    ++record.moved;
  else
    relocate_in_turn(input, patch, settled, record);
  for (std::uint32_t f = 0; f < complex.facets.size(); ++f)
    for (std::size_t k = 0; k < 3 && complex.facets[f].alive() && !complex.facets[f].proven; ++k) {
      const auto& v = complex.facets[f].v;
      if (kept && EdgeOfPatch(std::minmax(v[k], v[(k + 1) % 3])) == *kept) continue;
      if (const auto plan = try_flip(input, patch, f, k)) {
        for (const std::uint32_t w : {plan->a, plan->b, plan->c, plan->d}) settled[w] = 0;
        ++record.flipped;
        break;
      }
    }
}

/// Whether samples were added because of this reason, so that moving vertices may help.
bool can_be_repaired(Reason reason) {
  return reason == Reason::outside_tolerance || reason == Reason::normals;
}

/// How a repair has gone so far.
struct Progress {
  int sweeps = 0, checks = 0;
  int above = 0; ///< measurements in a row above the limit
  std::uint32_t points_added = 0;
  bool changing = true;                                  ///< the last sweep moved or flipped something
  double last = std::numeric_limits<double>::infinity(); ///< largest d before the last sweep
};

/// More samples than this are not asked for: their facets do not come below δ together.
constexpr std::uint32_t most_points_added = 200;

/// Whether a repair above the limit is given up. Replayed on 7,940 recorded repairs, the impatient rules
/// saved a third of the sweeps and stopped 14 of the 169 that had succeeded. Of 1,950 recorded repairs after
/// these, 18 of which succeeded, they would have stopped 7; the patient ones stop 1 and take an eighth more
/// sweeps.
bool is_hopeless(const Progress& p, double largest, double limit, const RepairOptions& options) {
  if (!p.changing) return true;
  const auto stage = static_cast<std::size_t>(p.sweeps) - 2; // a huge number before the second sweep
  if (stage < options.funnel.size() && largest > options.funnel[stage] * limit) return true;
  if (p.checks > 0) return p.above >= 2;
  const double excess = largest - limit, gain = p.last - largest;
  return excess > 0 && ((p.sweeps > 3 && gain <= 0.002 * limit) ||
                        (p.sweeps > 2 && excess > 1.6 * gain * (options.sweeps - p.sweeps)));
}

/// Whether somebody hears why a change failed.
enum class Failures { told, untold };

/// The last check of a change, after which it is committed or forgotten.
PatchVerdict check_at_last(const SurfaceRules& rules, SurfacePatch& patch, Failures failures) {
  return failures == Failures::told ? check_patch(rules, patch) : check_briefly(rules, patch);
}

PatchVerdict repair(const SurfaceRules& rules, SurfacePatch& patch, const RepairOptions& options,
                    Failures failures, const std::optional<EdgeOfPatch>& kept = {}) {
  const double limit = rules.sampled_limit();
  // Sweeps bring a facet back to the side of a witness so rarely that they are not worth their time.
  if (const auto swept = find_swept(rules, patch)) return Refusal{Reason::witness_side, 0, 0, *swept};
  PatchVerdict verdict;
  std::vector<RepairSweep> sweeps;
  Settled settled(patch.complex.points.size(), 0);
  Progress progress;
  for (;; ++progress.sweeps) {
    const Level level = measure(patch);
    if (!sweeps.empty()) sweeps.back().distance_left = level.largest, sweeps.back().worst_facet = level.place;
    RepairSweep record;
    record.largest_distance = level.largest;
    record.energy = level.energy;
    if (level.largest <= limit && !level.fold) {
      const bool last = ++progress.checks > options.certificates || progress.sweeps >= options.sweeps;
      verdict = last ? check_at_last(rules, patch, failures) : check_patch(rules, patch);
      record.points_added = verdict.points_added;
      progress.points_added += verdict.points_added;
      if (last || !can_be_repaired(verdict.reason) || progress.points_added > most_points_added) break;
      for (const Facet& f : patch.complex.facets)
        if (f.alive() && (!f.extra.empty() || !f.sides.empty())) unsettle(f, settled);
      progress.above = 0;
    } else {
      verdict = {
          Refusal{level.fold ? Reason::folded : Reason::stays_above, level.largest, limit, level.where},
          level.facet()};
      ++progress.above;
      if (progress.sweeps >= options.sweeps || is_hopeless(progress, level.largest, limit, options)) break;
    }
    progress.last = level.largest;
    sweep(*rules.input, patch, kept, options.jointly, settled, record);
    progress.changing = record.moved + record.flipped > 0;
    sweeps.push_back(record);
  }
  for (const RepairSweep& r : sweeps) verdict.moved += r.moved, verdict.flipped += r.flipped;
  verdict.sweeps = std::move(sweeps);
  return verdict;
}

/// Checks the facets around v, relocating it when that may help.
PatchVerdict settle(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t v, int retries,
                    Failures failures) {
  for (int attempt = 0;; ++attempt) {
    const Level level = measure(patch);
    if (level.largest > rules.sampled_limit())
      return {Refusal{Reason::stays_above, level.largest, rules.sampled_limit(), level.where}, level.worst};
    if (level.fold) return {Refusal{Reason::folded, 0, 0, level.where}, *level.fold};
    if (attempt == retries) return check_at_last(rules, patch, failures);
    PatchVerdict verdict = check_patch(rules, patch);
    if (!can_be_repaired(verdict.reason) || !relocate(*rules.input, patch, v, relocation_rounds))
      return verdict;
  }
}

} // namespace

PatchVerdict collapse_with_repair(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t a,
                                  std::uint32_t b, Vec3 target, const RepairOptions& options) {
  collapse_to(*rules.input, patch, a, b, target);
  if (options.sweeps > 0) return repair(rules, patch, options, Failures::told);
  return settle(rules, patch, a, collapse_retries, Failures::told);
}

bool is_worth_a_flip(const SurfaceRules& rules, const FacetComplex& complex, std::uint32_t a, std::uint32_t b,
                     const RepairOptions& options) {
  const std::optional<FlipPlan> plan = flip_of_edge(complex, a, b);
  return plan && distance_of_new_edge(*rules.input, complex, *plan) <=
                     options.most_flip_excess * rules.input->delta();
}

std::optional<PatchVerdict> flip_with_repair(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t a,
                                             std::uint32_t b, const RepairOptions& options) {
  const auto plan = force_flip(*rules.input, patch, a, b, options.most_flip_excess * rules.input->delta());
  if (!plan) return std::nullopt;
  return repair(rules, patch, options, Failures::untold, EdgeOfPatch(std::minmax(plan->c, plan->d)));
}

std::optional<PatchVerdict> relocate_vertex(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t v) {
  if (!relocate(*rules.input, patch, v, relocation_rounds)) return std::nullopt;
  return settle(rules, patch, v, relocation_retries, Failures::untold);
}

PatchVerdict check_patch(const SurfaceRules& rules, SurfacePatch& patch) {
  const Proof proof = prove(*rules.input, patch.complex);
  if (proof.failures == 0) {
    const PatchVerdict border = prove_border(*rules.input, patch.complex);
    return border.accepted() ? check_shape(rules, patch) : border;
  }
  PatchVerdict verdict{{Reason::outside_tolerance, proof.distance, rules.input->delta(), proof.witness},
                       proof.facet};
  verdict.points_added = proof.failures;
  return verdict;
}

PatchVerdict check_briefly(const SurfaceRules& rules, SurfacePatch& patch) {
  // What takes longest comes last.
  if (PatchVerdict shape = check_shape(rules, patch); !shape.accepted()) return shape;
  if (!prove_all(*rules.input, patch.complex)) return Refusal{Reason::outside_tolerance, 0, 0, {}};
  return prove_border(*rules.input, patch.complex);
}

} // namespace isoscope
