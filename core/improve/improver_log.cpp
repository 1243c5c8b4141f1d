// Fills events from verdicts.
#include "improve/improver_log.h"

namespace isoscope {

bool ImproverLog::accepted(const SurfaceChange& change, const ImproverVerdict& verdict) {
  Delta delta = follow(change);
  Event e = event(verdict);
  e.kind = change.kind;
  e.reason = verdict.placed;
  if (change.kind == EventKind::relaxation || change.kind == EventKind::shake)
    e.vertex = e.other = VertexId();
  log_.operation(e, std::move(delta), figures());
  return !log_.stopped();
}

bool ImproverLog::rejected(const ImproverVerdict& verdict) {
  Event e = event(verdict);
  e.kind = EventKind::rejection;
  e.reason = verdict.reason;
  log_.event(e);
  return !log_.stopped();
}

Event ImproverLog::event(const ImproverVerdict& v) {
  Event e;
  e.vertex = vertex(v.a);
  e.other = vertex(v.b);
  e.point = v.target;
  e.value = v.value;
  e.limit = v.accepted() ? delta_ : v.limit;
  e.witness = v.witness;
  if (v.facet)
    for (std::size_t k = 0; k < 3; ++k) e.facet[k] = vertex((*v.facet)[k]);
  e.count = v.moved;
  if (!v.sweeps.empty()) e.detail = log_.repair(v.sweeps);
  return e;
}

} // namespace isoscope
