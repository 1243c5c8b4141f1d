// Sweeps of relocations and flips, certificates that add samples, and the decision when to give up.
#include "simplify/transaction.h"

#include "simplify/facet_intersection.h"
#include "simplify/swept_witness.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <numeric>

namespace isoscope {
namespace {

using Refusal = ImproverVerdict::Reason;

constexpr std::size_t certificate_budget = 4000;
constexpr std::size_t most_extra = 40; ///< samples a facet may gather
constexpr int relocation_rounds = 2;
constexpr int collapse_retries = 4;   ///< of a collapse without repair whose certificate failed
constexpr int relocation_retries = 2; ///< of a relocation whose certificate failed

/// Weights of a point of the triangle's plane.
Barycentric weights(Vec3 p, const Triangle3& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double area2 = squared_length(n);
  if (!(area2 > 0)) return {1. / 3, 1. / 3, 1. / 3};
  const double a = dot(n, cross(t[1] - p, t[2] - p)) / area2, b = dot(n, cross(t[2] - p, t[0] - p)) / area2;
  return {a, b, 1 - a - b};
}

struct Proof {
  std::uint32_t failures = 0;
  double distance = 0; ///< of the worst violating point
  Vec3 witness;
};

/// Certifies all unproven facets; each violating point becomes a sample of its facet.
Proof prove(const InputSurface& input, FacetComplex& complex) {
  Proof proof;
  const double delta = input.delta();
  for (std::uint32_t f = 0; f < complex.facets.size(); ++f) {
    Facet& facet = complex.facets[f];
    if (!facet.alive() || facet.proven) continue;
    const Triangle3 t = complex.triangle(facet);
    const FacetVerdict verdict =
        certify_facet(input.index(), t, delta, delta, certificate_budget, facet.seed);
    if (verdict.kind == FacetVerdict::Kind::inside) {
      facet.proven = true;
      continue;
    }
    ++proof.failures;
    const double d = verdict.kind == FacetVerdict::Kind::outside ? verdict.closest.distance() : delta;
    if (d >= proof.distance) proof.distance = d, proof.witness = verdict.witness;
    if (facet.extra.size() >= most_extra) facet.extra.clear();
    facet.extra.push_back(weights(verdict.witness, t));
    measure_facet(input, complex, f);
  }
  return proof;
}

PatchVerdict refuse(Refusal reason, double value, double limit, Vec3 witness) {
  PatchVerdict verdict;
  verdict.reason = reason;
  verdict.value = value;
  verdict.limit = limit;
  verdict.witness = witness;
  return verdict;
}

/// Everything but certificates: fold, orientation, witnesses.
PatchVerdict check_shape(const SurfaceRules& rules, SurfacePatch& patch) {
  std::vector<Triangle3> before, after;
  std::uint32_t misoriented = 0, misoriented_before = patch.start_misoriented;
  for (std::size_t f = 0; f < patch.complex.facets.size(); ++f) {
    Facet& facet = patch.complex.facets[f];
    if (!patch.changed(f)) {
      misoriented_before -= facet.misoriented;
      continue;
    }
    before.push_back(patch.start_triangle(f));
    if (!facet.alive()) continue;
    const Triangle3 t = patch.complex.triangle(facet);
    after.push_back(t);
    if (facet.folded || is_degenerate(t)) return refuse(Refusal::folded, 0, 0, t[0]);
    if (!rules.orientation) continue;
    facet.misoriented = rules.orientation->failures(t);
    misoriented += facet.misoriented;
  }
  if (misoriented > misoriented_before)
    return refuse(Refusal::orientation, misoriented, misoriented_before, after.front()[0]);
  if (const auto swept = swept_witness(rules.witnesses, before, after))
    return refuse(Refusal::witness, 0, 0, *swept);
  return {};
}

/// The state of a patch between two sweeps.
struct Level {
  double largest = 0, energy = 0;
  bool folded = false;
  Vec3 where;
};

Level measure(const FacetComplex& complex) {
  Level level;
  for (const Facet& f : complex.facets) {
    if (!f.alive()) continue;
    if (f.largest > level.largest) level.largest = f.largest, level.where = complex.points[f.v[0]];
    level.energy += f.energy;
    level.folded = level.folded || f.folded;
  }
  return level;
}

double worst_energy(const FacetComplex& complex, std::uint32_t v) {
  double worst = 0;
  for (const std::uint32_t f : complex.stars[v]) worst = std::max(worst, complex.facets[f].energy);
  return worst;
}

/// Relocates all free vertices, those with the worst facet first, then tries flips.
void sweep(const InputSurface& input, SurfacePatch& patch, RepairSweep& record) {
  FacetComplex& complex = patch.complex;
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t v = 0; v < complex.points.size(); ++v)
    if (patch.free[v] && complex.alive_vertex(v)) order.emplace_back(-worst_energy(complex, v), v);
  std::sort(order.begin(), order.end());
  for (const auto& [key, v] : order) record.moved += relocate(input, complex, v, relocation_rounds) ? 1u : 0u;
  for (std::uint32_t f = 0; f < complex.facets.size(); ++f)
    for (std::size_t k = 0; k < 3 && complex.facets[f].alive(); ++k)
      if (try_flip(input, patch, f, k)) {
        ++record.flipped;
        break;
      }
}

PatchVerdict repair(const SurfaceRules& rules, SurfacePatch& patch, const RepairOptions& options) {
  PatchVerdict verdict;
  const double delta = rules.input->delta(), limit = rules.sampled_limit();
  int certificates = 0;
  double last = std::numeric_limits<double>::infinity();
  const auto give_up = [&](Refusal reason, double value, double bound, Vec3 where) {
    verdict.reason = reason;
    verdict.value = value;
    verdict.limit = bound;
    verdict.witness = where;
    return verdict;
  };
  for (int s = 0;; ++s) {
    const Level level = measure(patch.complex);
    RepairSweep record{level.largest, level.energy, 0, 0, 0};
    const bool low = level.largest <= limit && !level.folded;
    if (low) {
      const Proof proof = prove(*rules.input, patch.complex);
      if (proof.failures == 0) {
        PatchVerdict shape = check_shape(rules, patch);
        shape.sweeps = std::move(verdict.sweeps);
        shape.moved = verdict.moved;
        shape.flipped = verdict.flipped;
        return shape;
      }
      record.points_added = proof.failures;
      if (++certificates > options.certificates || s >= options.sweeps)
        return give_up(Refusal::certificate, proof.distance, delta, proof.witness);
    } else {
      const double excess = level.largest - limit, gain = last - level.largest;
      const bool hopeless = excess > 0 && ((s > 3 && gain <= 0.002 * delta) ||
                                           (s > 2 && excess > 1.2 * gain * (options.sweeps - s)));
      if (s >= options.sweeps || hopeless)
        return give_up(level.folded ? Refusal::folded : Refusal::distance, level.largest, limit, level.where);
    }
    last = level.largest;
    sweep(*rules.input, patch, record);
    verdict.moved += record.moved;
    verdict.flipped += record.flipped;
    verdict.sweeps.push_back(record);
  }
}

/// Proves the facets around v, relocating it when a certificate fails.
PatchVerdict settle(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t v, int retries) {
  for (int attempt = 0;; ++attempt) {
    const Level level = measure(patch.complex);
    if (level.largest > rules.sampled_limit())
      return refuse(Refusal::distance, level.largest, rules.sampled_limit(), level.where);
    if (level.folded) return refuse(Refusal::folded, 0, 0, level.where);
    const Proof proof = prove(*rules.input, patch.complex);
    if (proof.failures == 0) return check_shape(rules, patch);
    if (attempt == retries || !relocate(*rules.input, patch.complex, v, relocation_rounds))
      return refuse(Refusal::certificate, proof.distance, rules.input->delta(), proof.witness);
  }
}

} // namespace

PatchVerdict collapse_with_repair(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t a,
                                  std::uint32_t b, Vec3 target, const RepairOptions& options) {
  collapse_to(*rules.input, patch.complex, a, b, target);
  if (options.sweeps > 0) return repair(rules, patch, options);
  return settle(rules, patch, a, collapse_retries);
}

PatchVerdict relocate_vertex(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t v) {
  if (!relocate(*rules.input, patch.complex, v, relocation_rounds))
    return refuse(Refusal::connectivity, 0, 0, patch.complex.points[v]);
  PatchVerdict verdict = settle(rules, patch, v, relocation_retries);
  verdict.moved = 1;
  return verdict;
}

PatchVerdict check_patch(const SurfaceRules& rules, SurfacePatch& patch) {
  const Proof proof = prove(*rules.input, patch.complex);
  if (proof.failures > 0)
    return refuse(Refusal::certificate, proof.distance, rules.input->delta(), proof.witness);
  return check_shape(rules, patch);
}

} // namespace isoscope
