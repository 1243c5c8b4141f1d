// Checks Z against the expected topology and inserts where it can be mended.
#include "refine/topology_repair.h"

#include "refine/sample_conditions.h"

#include <algorithm>
#include <utility>

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
  Event check;
  check.kind = EventKind::topology_check;
  check.condition = Condition::topology;
  check.value = static_cast<double>(verdict().euler_characteristic);
  check.limit = static_cast<double>(expected_.euler_characteristic.value_or(verdict().euler_characteristic));
  check.count = static_cast<std::uint32_t>(verdict().components);
  context_.note(check);
}

void TopologyCondition::reconsider() {
  enter(Phase::edges);
}

void TopologyCondition::enter(Phase phase) {
  phase_ = phase;
  points_.clear();
  candidates_.clear();
  fresh_ = true;
}

bool TopologyCondition::sides_known() const {
  const InputTopology& input = context_.volume().input();
  return context_.criteria().certified && input.closed_manifold && input.self_intersection_free;
}

Event TopologyCondition::event(Reason reason) const {
  Event event;
  event.condition = Condition::topology;
  event.reason = reason;
  event.value = static_cast<double>(context_.live().euler_characteristic());
  event.limit = static_cast<double>(expected_.euler_characteristic.value_or(0));
  return event;
}

Turn TopologyCondition::turn() {
  if (phase_ == Phase::given_up) return Turn::satisfied;
  const long found = context_.live().euler_characteristic();
  if (expected_.euler_characteristic.value_or(found) == found && verdict().as_expected) {
    note_check();
    // Condition 3 waited: it has its turn, and then the topology again.
    return std::exchange(mending_, false) ? Turn::acted : Turn::satisfied;
  }
  if (!mending_) note_check();
  return mend();
}

Turn TopologyCondition::mend() {
  while (phase_ != Phase::given_up) {
    if (context_.cancelled()) return Turn::satisfied;
    if (context_.insertions(Condition::topology) >= insertion_limit_) break;
    if (phase_ == Phase::circumradii) {
      if (context_.criteria().certified || !refine_largest()) break;
      return Turn::acted;
    }
    const bool looked = points_.empty();
    if (looked) {
      if (!sides_known()) {
        enter(Phase::circumradii);
        continue;
      }
      collect_points();
    }
    while (!points_.empty()) {
      const MisclassifiedPoint point = points_.back();
      points_.pop_back();
      if (insert_point(point)) {
        fresh_ = false;
        mending_ = true;
        return Turn::acted;
      }
    }
    if (fresh_)
      enter(phase_ == Phase::edges ? Phase::facets : Phase::circumradii);
    else
      fresh_ = true;
  }
  enter(Phase::given_up);
  mending_ = false;
  note_check();
  return Turn::acted;
}

void TopologyCondition::collect_points() {
  points_ = phase_ == Phase::edges ? misclassified_on_edges(context_.live(), context_.volume())
                                   : misclassified_on_facets(context_.live(), context_.volume());
  std::reverse(points_.begin(), points_.end());
}

bool TopologyCondition::insert_point(const MisclassifiedPoint& point) {
  const LiveTriangulation& live = context_.live();
  const Vertex vertex = context_.free_vertex(point.point, point.label, VertexKind::topology);
  const TetId start = live.alive(point.tet) ? point.tet : context_.hint();
  const TetId t = live.delaunay().locate(vertex.position, start);
  if (!t.valid()) return false;
  const double f = interpolate(live.complex().positions(t), live.complex().values(t))(vertex.position);
  if (f * point.label > 0) return false;
  if (context_.spacing(vertex.position, t) < context_.smallest_spacing()) return false;
  Event why = event(Reason::crossing_simplex);
  why.tet = t;
  why.witness = point.point;
  return context_.insert(vertex, t, why);
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

bool TopologyCondition::refine_largest() {
  const LiveTriangulation& live = context_.live();
  if (candidates_.empty()) collect_candidates();
  while (!candidates_.empty()) {
    const Candidate candidate = candidates_.back();
    candidates_.pop_back();
    if (!live.alive(candidate.tet) || live.generation(candidate.tet) != candidate.generation) continue;
    const SampleId s = steiner_sample(context_, candidate.tet);
    if (!s.valid()) continue;
    Event why = event(Reason::circumcenter_sample);
    why.tet = candidate.tet;
    why.witness = live.delaunay().circumcenter(candidate.tet);
    if (context_.insert(context_.sample_vertex(s), candidate.tet, why)) return true;
  }
  return false;
}

} // namespace isoscope
