// Judges conditions 1 to 3 and inserts samples where they are violated.
#include "refine/sample_conditions.h"

#include "base/parallel.h"
#include "refine/misclassified_points.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::size_t tetrahedron_grain = 64;
/// Samples farther from the circumcentre than the computed radius times this are outside the ball for sure.
constexpr double radius_margin = 1 + 1e-6;

/// Samples that go in for conditions 2 and 3 keep this fraction of δ from all vertices: it bounds their
/// number where a condition cannot hold, as where σ is too large for the heights or a wall ends inside Ω.
/// Where it can hold nearly all keep more.
constexpr double smallest_spacing = 0.5;

/// Inserts the sample near the circumcentre of a violating tetrahedron, or notes that there is none.
Turn refine_at_circumcenter(RefinementContext& context, Checklist& checklist, TetId t, Event event) {
  const SampleId s = steiner_sample(context, t);
  event.tet = t;
  event.reason = Reason::circumcenter_sample;
  const bool crowded = s.valid() && context.spacing(context.nearest().positions()[s.index()], t) <
                                        smallest_spacing * context.volume().thresholds().delta;
  if (s.valid() && !crowded && context.insert(context.sample_vertex(s), t, event)) return Turn::acted;
  checklist.set(t, Checklist::State::exhausted);
  event.kind = EventKind::exhausted;
  event.reason =
      !s.valid() ? Reason::no_sample_inside : (crowded ? Reason::too_close : Reason::already_vertex);
  event.sample = s;
  event.count = static_cast<std::uint32_t>(checklist.exhausted());
  context.note(event);
  return Turn::acted;
}

/// Such a tetrahedron lies in a crevice or wall thinner than Ω, where no sample tells the sides: condition 3
/// is not asked of it.
bool has_topology_vertex(const Complex& complex, TetId t) {
  const auto& v = complex.tet(t).v;
  return std::any_of(v.begin(), v.end(),
                     [&](VertexId id) { return complex.vertices[id.index()].kind == VertexKind::topology; });
}

/// Beyond the rim of open surfaces both sides meet, and Z runs where it is cut off later: in front of a
/// sheet, whose other side is behind it. Nothing is to be told from its normal there.
bool runs_outside(const ToleranceVolume& volume, const Complex& complex, TetId t) {
  if (volume.open_sides() == nullptr) return false;
  const ZeroPolygon polygon = zero_polygon(complex.positions(t), complex.values(t));
  const double delta = volume.thresholds().delta;
  Vec3 sum;
  for (int i = 0; i < polygon.count; ++i) {
    const Vec3 p = polygon.corner[static_cast<std::size_t>(i)];
    if (volume.field().distance(p) <= delta) return false;
    sum = sum + p;
  }
  return polygon.count > 0 && volume.field().distance((1.0 / polygon.count) * sum) > delta;
}

} // namespace

SampleId steiner_sample(const RefinementContext& context, TetId t) {
  const Delaunay& delaunay = context.live().delaunay();
  const Vec3 center = delaunay.circumcenter(t);
  if (!is_finite(center)) return {};
  const double radius = distance(center, context.live().complex().positions(t)[0]);
  const SampleId s = context.nearest().nearest(center, radius * radius_margin);
  if (!s.valid()) return {};
  return delaunay.strictly_inside_circumsphere(t, context.nearest().positions()[s.index()]) ? s : SampleId();
}

bool ClassificationCondition::holds() const {
  const SteinerQueue& queue = context_.live().errors();
  return context_.live().blocked() == 0 &&
         (queue.empty() || queue.top_key() <= context_.criteria().error_limit());
}

Turn ClassificationCondition::turn() {
  LiveTriangulation& live = context_.live();
  const SteinerQueue& queue = live.errors();
  if (queue.empty() || queue.top_key() <= context_.criteria().error_limit()) return Turn::satisfied;
  const TetId t = queue.top();
  const SampleId worst = live.figures(t).worst;
  Event event;
  event.condition = Condition::classification;
  event.reason = Reason::largest_error;
  event.tet = t;
  event.witness = live.samples().positions[worst.index()];
  event.value = queue.top_key();
  event.limit = context_.criteria().error_limit();
  if (context_.insert(context_.sample_vertex(worst), t, event)) return Turn::acted;
  live.block(worst);
  event.kind = EventKind::exhausted;
  event.reason = Reason::already_vertex;
  event.sample = worst;
  event.count = static_cast<std::uint32_t>(live.blocked());
  context_.note(event);
  return Turn::acted;
}

Turn HeightCondition::turn() {
  const LiveTriangulation& live = context_.live();
  const double limit = context_.criteria().height_limit();
  for (const TetId t : std::vector<TetId>(checklist_.pending())) {
    checklist_.set(t, live.figures(t).height < limit ? Checklist::State::violated : Checklist::State::good);
  }
  const TetId t = checklist_.first_violated();
  if (!t.valid()) return Turn::satisfied;
  Event event;
  event.condition = Condition::height;
  event.witness = live.delaunay().circumcenter(t);
  event.value = live.figures(t).height;
  event.limit = limit;
  return refine_at_circumcenter(context_, checklist_, t, event);
}

OrientationVerdict OrientationCondition::check(TetId t) const {
  const Complex& complex = context_.live().complex();
  const double reach = orientation_reach * context_.volume().thresholds().delta;
  return check_orientation(complex.positions(t), complex.values(t), complex.labels(t),
                           context_.criteria().shrink, reach, context_.nearest());
}

void OrientationCondition::judge_pending() {
  const std::vector<TetId> pending = checklist_.pending();
  std::vector<std::uint8_t> misoriented(pending.size());
  const Complex& complex = context_.live().complex();
  const bool sides_known = context_.volume().input().sides_known();
  const bool complete =
      parallel_until(pending.size(), tetrahedron_grain, context_.control(), [&](std::size_t i) {
        const TetId t = pending[i];
        if (has_topology_vertex(complex, t)) return;
        misoriented[i] = check(t).misoriented && !runs_outside(context_.volume(), complex, t) &&
                         !(sides_known && spans_thin_place(context_.live(), context_.volume(), t));
      });
  if (!complete) return;
  for (std::size_t i = 0; i < pending.size(); ++i) {
    checklist_.set(pending[i], misoriented[i] ? Checklist::State::violated : Checklist::State::good);
  }
}

Turn OrientationCondition::turn() {
  judge_pending();
  if (context_.cancelled()) return Turn::acted;
  const TetId t = checklist_.first_violated();
  if (!t.valid()) return Turn::satisfied;
  const OrientationVerdict verdict = check(t);
  const OrientationTest& worst = verdict.tests[static_cast<std::size_t>(verdict.worst)];
  Event event;
  event.condition = Condition::orientation;
  event.witness = context_.nearest().positions()[worst.sample.index()];
  event.value = worst.f;
  event.limit = 0;
  return refine_at_circumcenter(context_, checklist_, t, event);
}

} // namespace isoscope
