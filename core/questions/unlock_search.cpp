// Collapses are made on a copy of T and undone; the edge is judged in between.
#include "questions/unlock_search.h"

#include "base/sort_unique.h"
#include "collapse/sample_targets.h"
#include "mesh/strata.h"
#include "questions/star_at.h"

#include <algorithm>
#include <utility>

namespace isoscope {

namespace {

class Bench {
 public:
  Bench(Complex complex, const StateSnapshot& state, const XrayContext& context, CriteriaParameters criteria)
      : complex_(std::move(complex)), incidence_(complex_), state_(state),
        context_(context), evaluation_{*context.scene.volume, context.nearest, criteria},
        sampled_(!criteria.certified && state.samples) {
    if (sampled_) targets_.emplace(*state.samples);
  }

  const Complex& complex() const { return complex_; }
  bool has(VertexId a, VertexId b) const {
    const auto alive = [&](VertexId v) {
      return v.valid() && v.index() < complex_.vertices.size() && complex_.vertices[v.index()].alive;
    };
    return a != b && alive(a) && alive(b) && incidence_.adjacent(complex_, a, b);
  }
  EdgeStar star(VertexId a, VertexId b) const {
    const auto [stays, goes] = oriented_edge(complex_, incidence_, a, b);
    return gather_edge_star(complex_, incidence_, stays, goes, context_.parameters.cost_ring);
  }
  /// As the stages do it: the ends first, then the search.
  CollapseAttempt judge(EdgeStar star) const {
    if (sampled_) add_star_samples(star, *state_.samples);
    const EdgeKind kind = star.kind();
    const auto ask = [&](bool halfedge, std::span<const Vec3> samples) {
      return evaluate_collapse(star, settings_for(kind, halfedge, context_.parameters), evaluation_,
                               EvaluationDetail::decision, samples);
    };
    if (kind != EdgeKind::mixed) {
      CollapseAttempt attempt = ask(true, {});
      if (attempt.possible() || (kind == EdgeKind::gamma && !targets_)) return attempt;
    }
    const std::vector<Vec3> near =
        kind == EdgeKind::gamma && targets_ ? targets_->near(star) : std::vector<Vec3>();
    return ask(false, near);
  }
  Delta collapse(const CollapseAttempt& attempt) {
    Delta delta = collapse_delta(complex_, incidence_, attempt.a, attempt.b, attempt.target);
    complex_.apply(delta);
    incidence_.apply(delta);
    return delta;
  }
  void undo(Delta delta) {
    complex_.undo(delta);
    std::swap(delta.removed, delta.added);
    incidence_.apply(delta);
  }

 private:
  Complex complex_;
  Incidence incidence_;
  const StateSnapshot& state_;
  const XrayContext& context_;
  EvaluationContext evaluation_;
  bool sampled_;
  std::optional<SampleTargets> targets_;
};

std::vector<std::pair<VertexId, VertexId>> edges_of(const EdgeStar& star) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const EdgeStar::StarTet& t : star.tets)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const VertexId a = star.vertices[t.v[i]].id, b = star.vertices[t.v[j]].id;
        edges.emplace_back(std::min(a, b), std::max(a, b));
      }
  sort_unique(edges);
  std::erase(edges, std::pair(std::min(star.a(), star.b()), std::max(star.a(), star.b())));
  return edges;
}

} // namespace

std::size_t UnlockSearch::count() const {
  return static_cast<std::size_t>(
      std::count_if(trials.begin(), trials.end(), [](const UnlockTrial& t) { return t.unlocks(); }));
}

std::optional<UnlockSearch> search_unlocks(const StateSnapshot& state, const EdgeQuestion& question,
                                           const XrayContext& context,
                                           const std::function<bool(double)>& progress) {
  if (state.complex.form == ZeroForm::free || !context.scene.volume) return std::nullopt;
  Complex complex = state.complex;
  Step step = state.step;
  if (question.event && *question.event < context.journal.events().size()) {
    const Event& e = context.journal.events()[*question.event];
    if (e.operation && state.step == e.step + 1) {
      complex.undo(context.journal.operations()[e.step].delta());
      step = e.step;
    }
  }
  Bench bench(std::move(complex), state, context, context.journal.parameters_at(step));
  if (!bench.has(question.a, question.b)) return std::nullopt;
  const EdgeStar star = bench.star(question.a, question.b);
  const EdgeKind wanted = star.form == ZeroForm::embedded ? EdgeKind::mixed : EdgeKind::gamma;
  const auto edges = edges_of(star);
  UnlockSearch search;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(edges.size()))) return search;
    if (!bench.has(edges[i].first, edges[i].second)) continue;
    EdgeStar other = bench.star(edges[i].first, edges[i].second);
    if (other.kind() != wanted) continue;
    UnlockTrial trial;
    trial.a = other.a();
    trial.b = other.b();
    trial.from = other.vertices[0].position;
    trial.to = other.vertices[1].position;
    trial.kind = wanted;
    const CollapseAttempt own = bench.judge(std::move(other));
    trial.rejected = own.rejected;
    if (own.possible()) {
      trial.target = own.target;
      Delta delta = bench.collapse(own);
      trial.gone = !bench.has(question.a, question.b);
      if (!trial.gone) {
        const CollapseAttempt then = bench.judge(bench.star(question.a, question.b));
        trial.then = then.rejected;
        trial.target_then = then.target;
      }
      bench.undo(std::move(delta));
    }
    search.trials.push_back(trial);
  }
  std::stable_sort(search.trials.begin(), search.trials.end(),
                   [](const UnlockTrial& x, const UnlockTrial& y) { return x.unlocks() > y.unlocks(); });
  search.complete = true;
  return search;
}

} // namespace isoscope
