// Certifies zero polygons in parallel, mends violations one by one in slot order.
#include "refine/containment.h"

#include "base/parallel.h"
#include "mesh/junction.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::size_t polygon_grain = 16;
constexpr int march_steps = 2000;
/// The march has reached d = δ' when it is this near, relative to δ'.
constexpr double march_precision = 1e-6;
/// Places of different sides of an open surface that are nearer than this, in units of δ, with nothing of Ω'
/// between them, are beyond its rim whatever their nearest place is.
constexpr double meeting_distance = 0.25;

} // namespace

ContainmentCondition::ContainmentCondition(RefinementContext& context)
    : context_(context), judge_(outside_judge(context.volume())) {
  context.follow(checklist_);
}

FacetVerdict::Kind ContainmentCondition::certify(TetId t, Violation* violation) const {
  const Complex& complex = context_.live().complex();
  const ToleranceThresholds& limits = context_.volume().thresholds();
  auto worst = FacetVerdict::Kind::inside;
  std::vector<LabelledTriangle> facets;
  append_zero_triangles(complex.positions(t), complex.values(t), complex.labels(t), complex.tet(t).v, facets);
  FacetSearch search;
  if (judge_) search.judge = &judge_;
  for (const LabelledTriangle& facet : facets) {
    const FacetVerdict verdict = certify_facet(context_.volume().field(), facet.corners, limits.delta,
                                               std::min(limits.reject, limits.delta), search);
    if (verdict.kind == FacetVerdict::Kind::inside) continue;
    worst = verdict.kind;
    if (verdict.kind != FacetVerdict::Kind::outside) continue;
    if (violation) *violation = {verdict.witness, verdict.closest};
    return worst;
  }
  return worst;
}

Checklist::State ContainmentCondition::judge(TetId t) const {
  switch (certify(t, nullptr)) {
  case FacetVerdict::Kind::inside:
    return Checklist::State::good;
  case FacetVerdict::Kind::outside:
    return Checklist::State::violated;
  case FacetVerdict::Kind::undecided:
    break;
  }
  return Checklist::State::undecided;
}

void ContainmentCondition::judge_pending() {
  const std::vector<TetId> pending = checklist_.pending();
  std::vector<Checklist::State> states(pending.size(), Checklist::State::pending);
  parallel_until(pending.size(), polygon_grain, context_.control(),
                 [&](std::size_t i) { states[i] = judge(pending[i]); });
  for (std::size_t i = 0; i < pending.size(); ++i) checklist_.set(pending[i], states[i]);
}

Turn ContainmentCondition::turn() {
  judge_pending();
  if (context_.cancelled()) return Turn::acted;
  const TetId t = checklist_.first_violated();
  if (!t.valid()) return Turn::satisfied;
  Violation violation;
  certify(t, &violation);
  return mend(t, violation);
}

Turn ContainmentCondition::mend(TetId t, const Violation& violation) {
  Event event;
  event.condition = Condition::containment;
  event.tet = t;
  event.witness = violation.witness;
  event.value = violation.closest.distance();
  event.limit = context_.volume().thresholds().delta;
  if (!open_at_ && context_.volume().sides().rule() == SideRule::depth) open_at_ = sides_joined_beyond(t);
  const int label = context_.volume().label_at(violation.witness, context_.control());
  if (context_.cancelled()) return Turn::acted; // the label may be unknown for no other reason
  if (label == 0) {
    event.reason = Reason::budget;
    return give_up(t, Checklist::State::exhausted, event);
  }
  if (meets_other_side(t, violation.witness, label)) {
    event.reason = Reason::too_close;
    return give_up(t, Checklist::State::exhausted, event);
  }
  const std::optional<Candidate> chosen = candidate(t, violation, label);
  event.reason = chosen ? chosen->reason : Reason::too_close;
  const std::uint32_t generation = context_.live().generation(t);
  if (!chosen ||
      !context_.insert(context_.free_vertex(chosen->point, label, VertexKind::containment), t, event)) {
    return give_up(t, Checklist::State::exhausted, event);
  }
  // The new vertex may lie outside the circumscribed ball: then the tetrahedron lives on and is asked again.
  if (context_.live().alive(t) && context_.live().generation(t) == generation) checklist_.add(t);
  return Turn::acted;
}

Turn ContainmentCondition::give_up(TetId t, Checklist::State state, Event event) {
  checklist_.set(t, state);
  const InputSides& sides = context_.volume().sides();
  if (!open_at_ && context_.volume().has_surface() && (!sides.known() || sides.by_solid_angles()) &&
      context_.volume().open_sides() == nullptr)
    open_at_ = both_sides_meet(t);
  event.kind = EventKind::exhausted;
  if (event.reason != Reason::budget) event.reason = Reason::too_close;
  event.count = static_cast<std::uint32_t>(checklist_.exhausted());
  context_.note(event);
  return Turn::acted;
}

double ContainmentCondition::clearance(Vec3 p) const {
  return context_.volume().field().distance(p) - context_.volume().thresholds().boundary;
}

bool ContainmentCondition::joined_outside(Vec3 p, Vec3 q) const {
  const double room_p = clearance(p), room_q = clearance(q);
  return room_p > 0 && room_q > 0 && distance(p, q) < room_p + room_q;
}

bool ContainmentCondition::meets_other_side(TetId t, Vec3 p, int label) const {
  if (context_.volume().open_sides() == nullptr) return false;
  const Complex& complex = context_.live().complex();
  const double near = meeting_distance * context_.volume().thresholds().delta;
  const auto meets = [&](VertexId v) {
    if (complex.label(v) == label || complex.label(v) == 0) return false;
    const Vec3 q = complex.position(v);
    return distance(p, q) <= near && joined_outside(p, q);
  };
  const auto& v = complex.tet(t).v;
  return std::any_of(v.begin(), v.end(), meets);
}

std::optional<Vec3> ContainmentCondition::both_sides_meet(TetId t) const {
  const Complex& complex = context_.live().complex();
  for (const VertexId a : complex.tet(t).v) {
    for (const VertexId b : complex.tet(t).v) {
      if (complex.label(a) >= complex.label(b)) continue;
      const Vec3 p = complex.position(a), q = complex.position(b);
      if (joined_outside(p, q)) return 0.5 * (p + q);
    }
  }
  return std::nullopt;
}

std::optional<Vec3> ContainmentCondition::sides_joined_beyond(TetId t) const {
  const Complex& complex = context_.live().complex();
  const ToleranceField& field = context_.volume().field();
  const double delta = context_.volume().thresholds().delta;
  const auto& v = complex.tet(t).v;
  std::array<double, 4> excess{};
  for (std::size_t i = 0; i < 4; ++i) excess[i] = field.distance(complex.position(v[i])) - delta;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      if (complex.label(v[i]) >= complex.label(v[j])) continue;
      const Vec3 p = complex.position(v[i]), q = complex.position(v[j]);
      if (excess[i] + excess[j] <= distance(p, q) * (1 + 1e-9)) continue;
      const Vec3 middle = 0.5 * (p + q);
      // Beyond the rim of open surfaces both sides meet.
      const OpenSides* open = context_.volume().open_sides();
      if (open == nullptr || !open->is_open(field.closest(middle).triangle)) return middle;
    }
  return std::nullopt;
}

std::optional<ContainmentCondition::Candidate>
ContainmentCondition::candidate(TetId t, const Violation& violation, int label) const {
  const ToleranceThresholds& limits = context_.volume().thresholds();
  const double spacing = 0.5 * std::min(limits.delta - limits.boundary, 0.5 * limits.boundary);
  const std::optional<Vec3> projected =
      context_.volume().field().at_level(violation.witness, violation.closest, limits.boundary);
  if (projected && context_.spacing(context_.snapped(*projected), t) >= spacing) {
    return Candidate{*projected, Reason::projected};
  }
  if (const auto traced = traced_candidate(t, violation, label); traced && on_side(traced->point, label))
    return traced;
  // The input may be so thin that all these places coincide with vertices; beyond δ the side is known as
  // well.
  if (has_room(violation.witness, t)) return Candidate{violation.witness, Reason::violating_point};
  return std::nullopt;
}

bool ContainmentCondition::on_side(Vec3 p, int label) const {
  const OpenSides* sides = context_.volume().open_sides();
  if (sides == nullptr) return true;
  const ClosestPoint closest = context_.volume().field().closest(p);
  return !sides->is_open(closest.triangle) || sides->side(p, closest) == label;
}

bool ContainmentCondition::has_room(Vec3 p, TetId t) const {
  return context_.spacing(context_.snapped(p), t) >= context_.smallest_spacing();
}

std::optional<ContainmentCondition::Candidate>
ContainmentCondition::traced_candidate(TetId t, const Violation& violation, int label) const {
  const Vec3 center = context_.live().delaunay().circumcenter(t);
  if (!is_finite(center)) return std::nullopt;
  std::optional<Candidate> best;
  if (const auto p = first_boundary_point(violation.witness, center)) {
    best = Candidate{*p, Reason::toward_circumcenter};
  } else {
    const Complex& complex = context_.live().complex();
    double farthest = -1;
    for (const VertexId v : complex.tet(t).v) {
      if (complex.label(v) == label) continue;
      const auto q = first_boundary_point(center, complex.position(v));
      if (!q || distance(*q, complex.position(v)) <= farthest) continue;
      farthest = distance(*q, complex.position(v));
      best = Candidate{*q, Reason::toward_opposite};
    }
  }
  if (best && !has_room(best->point, t)) return std::nullopt;
  return best;
}

std::optional<Vec3> ContainmentCondition::first_boundary_point(Vec3 from, Vec3 to) const {
  const double boundary = context_.volume().thresholds().boundary;
  const double length = distance(from, to);
  const Vec3 direction = normalized(to - from);
  double travelled = 0;
  for (int step = 0; step < march_steps; ++step) {
    const Vec3 p = from + travelled * direction;
    const double clearance = context_.volume().field().distance(p) - boundary;
    if (clearance < march_precision * boundary) return p;
    travelled += clearance;
    if (travelled >= length) return std::nullopt;
  }
  return from + travelled * direction;
}

} // namespace isoscope
