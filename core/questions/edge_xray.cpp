// Gathers the star on the state, or on the one before it, and asks the evaluator for everything.
#include "questions/edge_xray.h"

#include "collapse/sample_targets.h"
#include "criteria/collapse_cost.h"
#include "mesh/strata.h"
#include "questions/star_at.h"

#include <algorithm>

namespace isoscope {

namespace {

bool speaks_of(const Event& e, VertexId a, VertexId b) {
  return (e.vertex == a && e.other == b) || (e.vertex == b && e.other == a);
}

std::vector<EdgeXray::Invalid> largest_invalid(const CollapseAttempt& attempt) {
  constexpr std::size_t most = 12; ///< more would be a tangle
  std::vector<EdgeXray::Invalid> shapes;
  for (const InvalidRegion& region : attempt.invalid_regions) {
    KernelPolyhedron shape = invalid_polyhedron(region, *attempt.kernel);
    const std::size_t ball_from = attempt.kernel->half_spaces.size() + region.half_spaces.size();
    if (!shape.vertices.empty()) shapes.push_back({std::move(shape), ball_from});
  }
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const auto& a, const auto& b) { return a.shape.volume > b.shape.volume; });
  if (shapes.size() > most) shapes.resize(most);
  return shapes;
}

bool same_reason(const CollapseAttempt& attempt, const Event& e) {
  return e.kind == EventKind::collapse ? attempt.possible()
                                       : !attempt.possible() && attempt.rejected == e.reason;
}

/// Bit for bit: the reason, the target and every number that the journal keeps.
bool same_verdict(const CollapseAttempt& attempt, const Event& e) {
  if (!same_reason(attempt, e)) return false;
  if (e.kind == EventKind::collapse)
    return attempt.target == e.point && attempt.found_by == e.reason && attempt.tried == e.count &&
           attempt.cost == e.value && attempt.unconstrained_cost == e.limit;
  const CheckVerdict* failed = attempt.first_failed();
  if (failed == nullptr || failed->value != e.value || failed->limit != e.limit ||
      failed->witness != e.witness)
    return false;
  // A decision ends at the first check that fails; behind the kernel nothing more was measured.
  const bool searched = failed == &attempt.check(CollapseCheck::candidates);
  return !searched || (attempt.tried == e.count && attempt.optimum == e.point);
}

/// Whether the checks that depend on the target let it pass.
bool target_passes(const EdgeStar& star, Vec3 target, const CollapseSettings& settings,
                   const EvaluationContext& context) {
  const CollapseAttempt attempt = evaluate_target(star, target, settings, context);
  for (std::size_t i = static_cast<std::size_t>(CollapseCheck::candidates); i < collapse_check_count; ++i)
    if (attempt.checks[i].state == CheckVerdict::State::failed) return false;
  return true;
}

/// Judges centres of what was left out.
EdgeXray::Pruning check_pruning(const EdgeXray& x, const CollapseSettings& settings,
                                const EvaluationContext& context) {
  constexpr std::uint32_t most = 160; ///< a judgement may cost a millisecond
  EdgeXray::Pruning pruning;
  const Kernel& kernel = *x.attempt.kernel;
  const CollapseCost cost(x.star);
  for (const OctreeCell& cell : x.attempt.cells) {
    const Vec3 c = cell.box.center();
    if (cell.fate == OctreeCell::Fate::costlier) {
      ++pruning.costlier_judged;
      pruning.costlier_wrong += cost(c) < x.attempt.cost;
    }
    if (cell.fate != OctreeCell::Fate::invalid) continue;
    ++pruning.cells;
    if (pruning.cells_judged == most || !kernel.contains(c)) continue;
    ++pruning.cells_judged;
    if (target_passes(x.star, c, settings, context)) pruning.wrong.push_back(c);
  }
  for (const EdgeXray::Invalid& region : x.invalid) {
    Vec3 middle;
    for (const Vec3& v : region.shape.vertices) middle += v;
    middle = middle / static_cast<double>(region.shape.vertices.size());
    if (!kernel.contains(middle)) continue;
    ++pruning.regions_judged;
    if (target_passes(x.star, middle, settings, context)) pruning.wrong.push_back(middle);
  }
  return pruning;
}

} // namespace

std::optional<std::uint32_t> edge_event(const Journal& journal, Step step, VertexId a, VertexId b) {
  if (step > 0 && step <= journal.steps()) {
    const std::uint32_t made = journal.operations()[step - 1].event;
    if (speaks_of(journal.events()[made], a, b)) return made;
  }
  const std::size_t first = step > 0 && step <= journal.steps() ? journal.operations()[step - 1].event : 0;
  for (std::size_t i = first; i < journal.events().size(); ++i) {
    const Event& e = journal.events()[i];
    if (e.step > step) break;
    if (e.step == step && e.kind == EventKind::rejection && speaks_of(e, a, b))
      return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

std::optional<Vec3> witness_of(const EdgeXray& xray, const CollapseAttempt& attempt, CollapseCheck check) {
  const CheckVerdict& verdict = attempt.check(check);
  if (verdict.state == CheckVerdict::State::skipped) return std::nullopt;
  const auto middle = [&](const std::vector<std::vector<VertexId>>& simplices) -> std::optional<Vec3> {
    if (simplices.empty()) return std::nullopt;
    Vec3 sum;
    for (const VertexId v : simplices.front())
      for (const auto& w : xray.star.vertices)
        if (w.id == v) sum += w.position;
    return sum / static_cast<double>(simplices.front().size());
  };
  switch (check) {
  case CollapseCheck::eligible:
    return 0.5 * (xray.star.vertices[0].position + xray.star.vertices[1].position);
  case CollapseCheck::link:
    return middle(attempt.link.offending_t);
  case CollapseCheck::zero_link:
    return middle(attempt.link.offending_zero);
  case CollapseCheck::candidates:
    return attempt.tried > 0 ? std::optional(verdict.witness) : std::nullopt;
  default:
    // A check that passed without a number has nothing to show.
    return verdict.state == CheckVerdict::State::failed || verdict.witness != Vec3{}
               ? std::optional(verdict.witness)
               : std::nullopt;
  }
}

std::optional<EdgeXray> edge_xray(const StateSnapshot& state, const EdgeQuestion& question,
                                  const XrayContext& context) {
  const Event* event = question.event && *question.event < context.journal.events().size()
                           ? &context.journal.events()[*question.event]
                           : nullptr;
  EdgeXray out;
  out.before = event != nullptr && event->operation && state.step == event->step + 1;
  Complex before;
  if (out.before) {
    before = state.complex;
    before.undo(context.journal.operations()[event->step].delta());
  }
  const Complex& complex = out.before ? before : state.complex;
  const auto alive = [&](VertexId v) {
    return v.valid() && v.index() < complex.vertices.size() && complex.vertices[v.index()].alive;
  };
  if (complex.form == ZeroForm::free || question.a == question.b || !alive(question.a) ||
      !alive(question.b) || !context.scene.volume)
    return std::nullopt;
  const Incidence incidence(complex);
  if (!incidence.adjacent(complex, question.a, question.b)) return std::nullopt;

  auto [a, b] = oriented_edge(complex, incidence, question.a, question.b);
  if (event != nullptr && event->vertex.valid()) a = event->vertex, b = event->other;
  out.star = gather_edge_star(complex, incidence, a, b, context.parameters.cost_ring);
  out.criteria = context.criteria ? *context.criteria
                                  : context.journal.parameters_at(out.before ? state.step - 1 : state.step);
  if (!out.criteria.certified && state.samples) add_star_samples(out.star, *state.samples);
  const EdgeKind kind = out.star.kind();
  const bool by_samples = kind == EdgeKind::gamma && !out.criteria.certified && state.samples;
  const std::vector<Vec3> targets =
      by_samples ? SampleTargets(*state.samples).near(out.star) : std::vector<Vec3>();
  const EvaluationContext evaluation{*context.scene.volume, context.nearest, out.criteria};
  // The improver places its targets otherwise; what makes room for it is an ordinary collapse.
  const bool judged_alike = event != nullptr && question.target == XrayTarget::automatic &&
                            (event->stage != Stage::improve || kind == EdgeKind::mixed);
  const bool octree = question.target == XrayTarget::octree;
  const auto judge = [&](bool halfedge) {
    out.halfedge = halfedge;
    out.settings = settings_for(kind, halfedge, context.parameters);
    if (octree) out.settings.search.strategy = TargetStrategy::octree;
    out.attempt = evaluate_collapse(out.star, out.settings, evaluation, EvaluationDetail::full, targets);
    if (judged_alike) out.agrees = same_verdict(out.attempt, *event);
  };
  const bool usual = kind == EdgeKind::gamma && !by_samples;
  judge(question.target == XrayTarget::automatic ? usual : question.target == XrayTarget::halfedge);
  // The journal does not say in which of a stage's two passes it was: its numbers do.
  if (question.target == XrayTarget::automatic && out.agrees == false) {
    const CollapseAttempt first = out.attempt;
    judge(!usual);
    if (out.agrees == false && !(same_reason(out.attempt, *event) && !same_reason(first, *event))) {
      out.attempt = first;
      out.halfedge = usual;
      out.settings = settings_for(kind, usual, context.parameters);
    }
  }
  for (const CandidateRecord& c : out.attempt.candidates)
    ++out.candidates[static_cast<std::size_t>(c.rejected)];
  if (out.attempt.kernel) {
    out.kernel = kernel_polyhedron(*out.attempt.kernel);
    out.invalid = largest_invalid(out.attempt);
    if (!out.attempt.kernel->empty) out.pruning = check_pruning(out, out.settings, evaluation);
  }
  return out;
}

} // namespace isoscope
