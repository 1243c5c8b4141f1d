// Evaluates batches in parallel and commits them in order.
#include "improve/relaxation.h"

#include "base/parallel.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::size_t batch_size = 64;

/// A change that waits for its commit.
struct Proposal {
  SurfacePatch patch;
  bool wanted = false;
  bool best = false; ///< a vertex that gains nothing by moving
};

/// Classes of vertices without edges inside a class, each ascending: greedy by ascending id.
std::vector<std::vector<std::uint32_t>> independent_classes(const FacetComplex& complex) {
  constexpr std::uint32_t uncoloured = 0xffffffffu;
  std::vector<std::uint32_t> colour(complex.points.size(), uncoloured);
  std::vector<std::vector<std::uint32_t>> classes;
  std::vector<std::uint8_t> taken;
  for (std::uint32_t v = 0; v < colour.size(); ++v) {
    if (!complex.alive_vertex(v)) continue;
    taken.assign(classes.size() + 1, 0);
    for (const std::uint32_t f : complex.stars[v])
      for (const std::uint32_t w : complex.facets[f].v)
        if (colour[w] != uncoloured) taken[colour[w]] = 1;
    const auto c = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    if (c == classes.size()) classes.emplace_back();
    colour[v] = static_cast<std::uint32_t>(c);
    classes[c].push_back(v);
  }
  return classes;
}

/// Runs propose(i) for [0, n) in batches and commits what is wanted and still allowed. `largest` becomes the
/// largest sampled d of the changed facets.
template <class Propose>
std::uint32_t run_batches(LiveSurface& surface, std::size_t n, double delta, double& largest,
                          const RunControl& control, const Propose& propose) {
  std::uint32_t committed = 0;
  std::vector<Proposal> batch;
  for (std::size_t first = 0; first < n && !control.cancelled(); first += batch_size) {
    batch.assign(std::min(batch_size, n - first), {});
    parallel_until(batch.size(), 1, control, [&](std::size_t i) { batch[i] = propose(first + i); });
    for (const Proposal& p : batch) {
      if (!p.wanted || !surface.up_to_date(p.patch) || !surface.check(p.patch).accepted()) continue;
      surface.commit(p.patch, EventKind::relaxation);
      largest = std::max(largest, p.patch.largest_distance(delta));
      ++committed;
    }
  }
  return committed;
}

Proposal propose_relocation(const LiveSurface& surface, const SurfaceRules& rules, std::uint32_t v) {
  Proposal p;
  p.patch = surface.patch(std::array{v});
  const auto verdict = relocate_vertex(rules, p.patch, p.patch.local_vertex(v));
  p.wanted = verdict && verdict->accepted();
  p.best = !verdict;
  return p;
}

Proposal propose_flip(const LiveSurface& surface, const SurfaceRules& rules, std::uint32_t f) {
  const FacetComplex& complex = surface.complex();
  Proposal p;
  for (std::size_t k = 0; k < 3; ++k) {
    if (complex.facets[f].v[k] > complex.facets[f].v[(k + 1) % 3]) continue;
    const auto plan = plan_flip(*rules.input, complex, f, k);
    const auto may_lose_facet = [&](std::uint32_t v) {
      return complex.stars[v].size() > complex.fewest_facets(v);
    };
    if (!plan || !may_lose_facet(plan->a) || !may_lose_facet(plan->b) || complex.has_edge(plan->c, plan->d))
      continue;
    if (!surface.may_change(std::array{plan->a, plan->b, plan->c, plan->d})) continue;
    std::optional<SurfacePatch> patch = surface.flip_patch(*plan);
    if (!patch) continue;
    p.patch = std::move(*patch);
    p.wanted = check_briefly(rules, p.patch).accepted();
    if (p.wanted) break;
  }
  return p;
}

} // namespace

RelaxationFigures relax(LiveSurface& surface, const SurfaceRules& rules, BestPlaces& best_places,
                        const RunControl& control) {
  best_places.resize(surface.complex().points.size(), 0);
  RelaxationFigures figures;
  const double delta = rules.input->delta();
  for (std::vector<std::uint32_t>& c : independent_classes(surface.complex())) {
    std::erase_if(c, [&](std::uint32_t v) { return surface.frozen(v); });
    // Commit numbers start at 1, so that 0 stands for never.
    std::erase_if(c,
                  [&](std::uint32_t v) { return best_places[v] > 0 && best_places[v] >= surface.stamp(v); });
    const std::uint32_t now = surface.commits();
    figures.moved += run_batches(surface, c.size(), delta, figures.largest, control, [&](std::size_t i) {
      Proposal p = propose_relocation(surface, rules, c[i]);
      if (p.best) best_places[c[i]] = now;
      return p;
    });
  }
  std::vector<std::uint32_t> facets;
  for (std::uint32_t f = 0; f < surface.complex().facets.size(); ++f)
    if (surface.complex().facets[f].alive()) facets.push_back(f);
  figures.flipped += run_batches(surface, facets.size(), delta, figures.largest, control,
                                 [&](std::size_t i) { return propose_flip(surface, rules, facets[i]); });
  return figures;
}

} // namespace isoscope
