// Gathers the star on the state, or on the one before it, and asks the evaluator for everything.
#include "run/edge_xray.h"

#include "mesh/incidence.h"
#include "mesh/predicates.h"
#include "simplify/sample_targets.h"

#include <algorithm>

namespace isoscope {

namespace {

bool speaks_of(const Event& e, VertexId a, VertexId b) {
  return (e.vertex == a && e.other == b) || (e.vertex == b && e.other == a);
}

void add_samples(EdgeStar& star, const BoundarySamples& samples) {
  Box3 box;
  for (const auto& v : star.vertices) box.add(v.position);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 p = samples.positions[i];
    const bool near = p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y &&
                      p.z >= box.lo.z && p.z <= box.hi.z;
    if (!near) continue;
    const bool held = std::any_of(star.tets.begin(), star.tets.end(), [&](const EdgeStar::StarTet& t) {
      return holds_perturbed(star.positions(t), p);
    });
    if (held) star.samples.push_back({SampleId(i), p, samples.labels[i]});
  }
}

/// How the stages collapse edges of a kind.
CollapseSettings settings_for(EdgeKind kind, bool halfedge, const RunParameters& parameters) {
  CollapseSettings settings;
  settings.kind = kind;
  settings.halfedge = halfedge;
  settings.search.strategy = parameters.target;
  if (kind == EdgeKind::gamma && !halfedge) settings.search.kernel_samples = most_sample_targets;
  return settings;
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

bool same_verdict(const CollapseAttempt& attempt, const Event& e) {
  if (e.kind == EventKind::collapse) return attempt.possible() && attempt.target == e.point;
  return e.kind == EventKind::rejection && !attempt.possible() && attempt.rejected == e.reason;
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
    before.undo(*context.journal.operations()[event->step].delta);
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

  auto [a, b] = oriented_edge(complex, question.a, question.b);
  if (event != nullptr && event->vertex.valid()) a = event->vertex, b = event->other;
  out.star = gather_edge_star(complex, incidence, a, b, context.parameters.cost_ring);
  out.criteria = context.criteria ? *context.criteria
                                  : context.journal.parameters_at(out.before ? state.step - 1 : state.step);
  if (!out.criteria.certified && state.samples) add_samples(out.star, *state.samples);
  const EdgeKind kind = out.star.kind();
  const bool by_samples = kind == EdgeKind::gamma && !out.criteria.certified && state.samples;
  const std::vector<Vec3> targets =
      by_samples ? SampleTargets(*state.samples).near(out.star) : std::vector<Vec3>();
  const EvaluationContext evaluation{*context.scene.volume, context.nearest, out.criteria};
  const auto judge = [&](bool halfedge) {
    out.halfedge = halfedge;
    out.attempt = evaluate_collapse(out.star, settings_for(kind, halfedge, context.parameters), evaluation,
                                    EvaluationDetail::full, targets);
    if (event != nullptr) out.agrees = same_verdict(out.attempt, *event);
  };
  const bool usual = kind == EdgeKind::gamma && !by_samples;
  judge(question.target == XrayTarget::automatic ? usual : question.target == XrayTarget::halfedge);
  // The journal does not say in which of a stage's two passes it was.
  if (question.target == XrayTarget::automatic && out.agrees == false) {
    const CollapseAttempt first = out.attempt;
    judge(!usual);
    if (out.agrees == false) {
      out.attempt = first;
      out.halfedge = usual;
    }
  }
  for (const CandidateRecord& c : out.attempt.candidates)
    ++out.candidates[static_cast<std::size_t>(c.rejected)];
  if (out.attempt.kernel) {
    out.kernel = kernel_polyhedron(*out.attempt.kernel);
    out.invalid = largest_invalid(out.attempt);
  }
  return out;
}

} // namespace isoscope
