// Merging, relocating and flipping with measured facets.
#include "improve/patch_moves.h"

#include "collapse/tet_flips.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double least_gain = 0.995;     ///< of a relocation: new energy over old
constexpr double least_flip_gain = 0.98; ///< of a flip
constexpr double flip_from = 0.7;        ///< flips are tried where the largest d exceeds this share of δ

void store(FacetComplex& complex, std::span<const Wedge> wedges, const Placement& placement) {
  for (std::size_t i = 0; i < wedges.size(); ++i) {
    Facet& f = complex.facets[wedges[i].facet];
    f.energy = placement.facets[i].energy;
    f.largest = placement.facets[i].largest;
    f.folded = placement.facets[i].folded;
    f.seed = placement.seeds[i];
    f.proven = false;
  }
}

/// Where the merged vertex of an edge has to lie, as one end alone is on the border or a curve.
std::optional<Vec3> pinned_target(const FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  if (!complex.strata.empty()) {
    const std::optional<std::uint32_t> end = pinned_end(complex, a, b);
    return end ? std::optional(complex.points[*end]) : std::nullopt;
  }
  if (complex.on_border(a) == complex.on_border(b)) return std::nullopt;
  return complex.points[complex.on_border(a) ? a : b];
}

/// What failed checks have added to a facet goes to that of the flip's new facets onto which it projects.
void carry_samples(const FacetComplex& complex, const Facet& from, const std::array<Triangle3, 2>& to,
                   FlipPlan& plan) {
  const auto place = [&](Vec3 p) {
    std::array<Barycentric, 2> w{weights_of(p, to[0]), weights_of(p, to[1])};
    const auto least = [&](std::size_t i) { return std::min({w[i][0], w[i][1], w[i][2]}); };
    const std::size_t i = least(0) >= least(1) ? 0 : 1;
    return std::pair(least(i) >= 0 ? i : 2, w[i]);
  };
  const Triangle3 t = complex.triangle(from);
  for (const Barycentric& e : from.extra)
    if (const auto [i, w] = place(at(e, t)); i < 2) plan.extra[i].push_back(w);
  for (const SideSample& side : from.sides)
    if (const std::size_t i = place(side.point).first; i < 2) plan.sides[i].push_back(side);
}

/// What a flip makes of its two facets.
std::array<Triangle3, 2> flipped_triangles(const FacetComplex& complex, const FlipPlan& plan) {
  const auto& p = complex.points;
  return {Triangle3{p[plan.a], p[plan.d], p[plan.c]}, Triangle3{p[plan.d], p[plan.b], p[plan.c]}};
}

/// The tetrahedron of T between the two facets of a flip; nothing without T or where there is none.
std::optional<std::uint32_t> tet_of(const SurfacePatch& patch, const FlipPlan& plan) {
  if (!patch.in_t) return std::nullopt;
  const auto& in_t = patch.in_t->vertices;
  return patch.in_t->tets.tet_between({in_t[plan.a], in_t[plan.b], in_t[plan.c], in_t[plan.d]});
}

} // namespace

std::optional<CollapseCandidate> collapse_candidate(const InputSurface& input, const FacetComplex& complex,
                                                    std::uint32_t a, std::uint32_t b,
                                                    const PlacementEffort& effort, const Kernel* kernel) {
  if (!complex.link_condition(a, b)) return std::nullopt;
  const std::vector<Wedge> wedges = complex.merged_star(a, b);
  Star star = make_star(complex, wedges, false);
  const auto candidate = [&](const Placement& placed) {
    return CollapseCandidate{placed.point,
                             placed.largest + (placed.folded ? effort.folded_surcharge * input.delta() : 0)};
  };
  const auto allowed = [&](Vec3 p) { return kernel == nullptr || kernel->contains(p); };
  if (const std::optional<Vec3> pinned = pinned_target(complex, a, b)) {
    if (!allowed(*pinned)) return std::nullopt;
    return candidate(StarEvaluator(input, star).evaluate(*pinned));
  }
  if (complex.on_border(a)) move_border(input, complex, a, b, star);
  StarEvaluator evaluator(input, star);
  const Vec3 pa = complex.points[a], pb = complex.points[b];
  const Vec3 middle = 0.5 * (pa + pb);
  Placement best =
      evaluator.evaluate(allowed(middle) ? middle : kernel->center, unbounded, effort.farthest_start);
  if (effort.three_starts)
    for (const Vec3 p : {pa, pb}) {
      if (!allowed(p)) continue;
      Placement other = evaluator.evaluate(p, best.energy, effort.farthest_start);
      if (other.energy < best.energy) best = std::move(other);
    }
  if (!(best.energy < unbounded)) return std::nullopt;
  if (effort.three_starts) best = evaluator.evaluate(best.point);
  evaluator.improve(best, effort.rounds, kernel);
  return candidate(best);
}

void collapse_to(const InputSurface& input, SurfacePatch& patch, std::uint32_t a, std::uint32_t b,
                 Vec3 target) {
  FacetComplex& complex = patch.complex;
  if (patch.in_t) {
    const VertexId stays = patch.in_t->vertices[a], goes = patch.in_t->vertices[b];
    Kernel kernel; // the target was found in it, after the same flips
    make_collapsible(patch.in_t->tets, stays, goes, kernel);
    patch.in_t->tets.collapse(stays, goes, target);
  }
  const bool border_moves = complex.on_border(a) && complex.on_border(b);
  complex.collapse(a, b);
  complex.points[a] = target;
  if (border_moves) measure_border_at(input, complex, a);
  const std::vector<Wedge> wedges = complex.star(a);
  for (const Wedge& w : wedges) complex.facets[w.facet].extra.clear(), complex.facets[w.facet].sides.clear();
  const Star star = make_star(complex, wedges, false);
  store(complex, wedges, StarEvaluator(input, star).evaluate(target));
}

bool relocate(const InputSurface& input, SurfacePatch& patch, std::uint32_t v, int rounds) {
  FacetComplex& complex = patch.complex;
  if (complex.is_rigid(v)) return false;
  const std::vector<Wedge> wedges = complex.star(v);
  Star star = make_star(complex, wedges, true);
  if (complex.on_border(v)) move_border(input, complex, v, v, star);
  StarEvaluator evaluator(input, star);
  Placement placement = evaluator.evaluate(complex.points[v]);
  const double before = placement.energy;
  if (patch.in_t) {
    const Kernel kernel = patch.in_t->tets.kernel(patch.in_t->vertices[v]);
    evaluator.improve(placement, rounds, &kernel);
  } else {
    evaluator.improve(placement, rounds);
  }
  if (!(placement.energy < least_gain * before)) return false;
  complex.points[v] = placement.point;
  if (patch.in_t) patch.in_t->tets.move(patch.in_t->vertices[v], placement.point);
  store(complex, wedges, placement);
  if (complex.on_border(v)) measure_border_at(input, complex, v);
  return true;
}

std::optional<FlipPlan> flip_corners(const FacetComplex& complex, std::uint32_t f, std::size_t k) {
  const Facet& first = complex.facets[f];
  FlipPlan plan;
  plan.f = f;
  plan.a = first.v[k];
  plan.b = first.v[(k + 1) % 3];
  plan.c = first.v[(k + 2) % 3];
  if (complex.on_curve(plan.a, plan.b)) return std::nullopt;
  plan.g = complex.facet_left_of(plan.b, plan.a);
  if (plan.g == Facet::none) return std::nullopt;
  const Facet& second = complex.facets[plan.g];
  plan.d = second.v[(second.corner(plan.a) + 1) % 3];
  return plan;
}

std::optional<FlipPlan> flip_of_edge(const FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  if (!complex.has_edge(a, b) || complex.on_curve(a, b)) return std::nullopt;
  const std::uint32_t f = complex.facet_left_of(a, b);
  if (f == Facet::none) return std::nullopt;
  return flip_corners(complex, f, complex.facets[f].corner(a));
}

double distance_of_new_edge(const InputSurface& input, const FacetComplex& complex, const FlipPlan& plan) {
  const Vec3 c = complex.points[plan.c], d = complex.points[plan.d];
  const int steps = sampling_steps(distance(c, d), input.delta());
  return input.sample(d + (steps / 2) / static_cast<double>(steps) * (c - d), complex.facets[plan.f].seed)
      .distance;
}

std::optional<FlipPlan> plan_flip(const InputSurface& input, const FacetComplex& complex, std::uint32_t f,
                                  std::size_t k) {
  std::optional<FlipPlan> corners = flip_corners(complex, f, k);
  if (!corners) return std::nullopt;
  FlipPlan& plan = *corners;
  const Facet &first = complex.facets[f], &second = complex.facets[plan.g];
  if (!first.folded && !second.folded && std::max(first.largest, second.largest) < flip_from * input.delta())
    return std::nullopt;
  const double allowed = least_flip_gain * (first.energy + second.energy);
  const std::array<Triangle3, 2> after = flipped_triangles(complex, plan);
  // Most flips fail, and most of these at this one sample.
  const double d = distance_of_new_edge(input, complex, plan);
  const std::size_t others =
      first.extra.size() + second.extra.size() + first.sides.size() + second.sides.size();
  if (energy_of_sample(input, after[0], d, others) + energy_of_sample(input, after[1], d, others) > allowed)
    return std::nullopt;
  plan.seeds = {first.seed, first.seed};
  for (const Facet* facet : {&first, &second}) carry_samples(complex, *facet, after, plan);
  plan.quality[0] = measure_facet(input, after[0], plan.extra[0], plan.sides[0], plan.seeds[0], first.labels);
  if (plan.quality[0].folded || plan.quality[0].energy > allowed) return std::nullopt;
  plan.seeds[1] = plan.seeds[0];
  plan.quality[1] = measure_facet(input, after[1], plan.extra[1], plan.sides[1], plan.seeds[1], first.labels);
  if (plan.quality[1].folded || plan.quality[0].energy + plan.quality[1].energy > allowed)
    return std::nullopt;
  return corners;
}

std::optional<FlipPlan> force_flip(const InputSurface& input, SurfacePatch& patch, std::uint32_t a,
                                   std::uint32_t b, double most_distance) {
  FacetComplex& complex = patch.complex;
  if (!patch.may_lose_facet(a) || !patch.may_lose_facet(b)) return std::nullopt;
  std::optional<FlipPlan> plan = flip_of_edge(complex, a, b);
  if (!plan || complex.has_edge(plan->c, plan->d)) return std::nullopt;
  const std::optional<std::uint32_t> tet = tet_of(patch, *plan);
  if (patch.in_t && !tet) return std::nullopt;
  if (distance_of_new_edge(input, complex, *plan) > most_distance) return std::nullopt;
  plan->seeds = {complex.facets[plan->f].seed, complex.facets[plan->g].seed};
  const std::array<Triangle3, 2> after = flipped_triangles(complex, *plan);
  for (std::size_t i = 0; i < 2; ++i) {
    plan->quality[i] = measure_facet(input, after[i], {}, {}, plan->seeds[i], complex.facets[plan->f].labels);
    if (plan->quality[i].largest > most_distance) return std::nullopt;
  }
  apply_flip(complex, *plan);
  if (tet) patch.in_t->tets.change_side(*tet);
  return plan;
}

void apply_flip(FacetComplex& complex, const FlipPlan& plan) {
  complex.replace_facet(plan.f, {plan.a, plan.d, plan.c});
  complex.replace_facet(plan.g, {plan.d, plan.b, plan.c});
  const std::array<std::uint32_t, 2> changed{plan.f, plan.g};
  for (std::size_t i = 0; i < 2; ++i) {
    Facet& facet = complex.facets[changed[i]];
    facet.energy = plan.quality[i].energy;
    facet.largest = plan.quality[i].largest;
    facet.folded = plan.quality[i].folded;
    facet.seed = plan.seeds[i];
    facet.extra = plan.extra[i];
    facet.sides = plan.sides[i];
  }
}

std::optional<FlipPlan> try_flip(const InputSurface& input, SurfacePatch& patch, std::uint32_t f,
                                 std::size_t k) {
  const auto corners = flip_corners(patch.complex, f, k);
  if (!corners) return std::nullopt;
  const auto [a, b, c, d] = std::array{corners->a, corners->b, corners->c, corners->d};
  if (!patch.may_lose_facet(a) || !patch.may_lose_facet(b)) return std::nullopt;
  if (a > b && !patch.complex.facets[corners->g].proven) return std::nullopt;
  // Between two fixed vertices there may be an edge outside of the patch.
  if (!patch.free[c] && !patch.free[d]) return std::nullopt;
  if (patch.complex.has_edge(patch.free[c] ? c : d, patch.free[c] ? d : c)) return std::nullopt;
  const std::optional<std::uint32_t> tet = tet_of(patch, *corners);
  if (patch.in_t && !tet) return std::nullopt;
  const auto plan = plan_flip(input, patch.complex, f, k);
  if (!plan) return std::nullopt;
  apply_flip(patch.complex, *plan);
  if (tet) patch.in_t->tets.change_side(*tet);
  return plan;
}

} // namespace isoscope
