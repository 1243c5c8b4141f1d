// Checks Z against the expected topology and refines by circumradius.
#include "refine/topology_repair.h"

#include "refine/sample_conditions.h"

#include <algorithm>

namespace isoscope {

const TopologyVerdict& TopologyCondition::verdict() {
  const Step now = context_.recorder().journal().steps();
  if (!verdict_ || judged_at_ != now) {
    verdict_ = check_topology(extract_zero_set(context_.live().complex()), expected_);
    judged_at_ = now;
  }
  return *verdict_;
}

void TopologyCondition::note_check() {
  const Step now = context_.recorder().journal().steps();
  if (noted_at_ && *noted_at_ == now) return;
  noted_at_ = now;
  Event event;
  event.kind = EventKind::topology_check;
  event.condition = Condition::topology;
  event.value = static_cast<double>(verdict().euler_characteristic);
  event.limit = static_cast<double>(expected_.euler_characteristic.value_or(verdict().euler_characteristic));
  event.count = static_cast<std::uint32_t>(verdict().components);
  context_.note(event);
}

Turn TopologyCondition::turn() {
  if (given_up_) return Turn::satisfied;
  const bool settled = verdict().as_expected;
  note_check();
  if (settled) return Turn::satisfied;
  return refine_largest();
}

void TopologyCondition::collect_candidates() {
  const LiveTriangulation& live = context_.live();
  candidates_.clear();
  for (std::uint32_t i = 0; i < live.complex().tets.size(); ++i) {
    const TetId t(i);
    if (!live.alive(t) || !live.heterogeneous(t)) continue;
    const Vec3 center = live.delaunay().circumcenter(t);
    if (!is_finite(center)) continue;
    candidates_.push_back({t, live.generation(t), distance(center, live.complex().positions(t)[0])});
  }
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.radius < b.radius; });
}

Turn TopologyCondition::refine_largest() {
  const LiveTriangulation& live = context_.live();
  const bool fresh = candidates_.empty();
  if (fresh) collect_candidates();
  while (!candidates_.empty() && context_.insertions(Condition::topology) < insertion_limit_) {
    const Candidate candidate = candidates_.back();
    candidates_.pop_back();
    if (!live.alive(candidate.tet) || live.generation(candidate.tet) != candidate.generation) continue;
    const SampleId s = steiner_sample(context_, candidate.tet);
    if (!s.valid()) continue;
    Event event;
    event.condition = Condition::topology;
    event.reason = Reason::circumcenter_sample;
    event.tet = candidate.tet;
    event.witness = live.delaunay().circumcenter(candidate.tet);
    event.value = static_cast<double>(live.euler_characteristic());
    event.limit = static_cast<double>(expected_.euler_characteristic.value_or(0));
    if (context_.insert(context_.sample_vertex(s), candidate.tet, event)) return Turn::acted;
  }
  if (!fresh && context_.insertions(Condition::topology) < insertion_limit_) return Turn::acted;
  given_up_ = true;
  return Turn::satisfied;
}

} // namespace isoscope
