// Checks Z against the expected topology and inserts where it can be mended.
#include "refine/topology_repair.h"

#include "mesh/label_functions.h"
#include "refine/pockets.h"
#include "refine/sample_conditions.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

/// Summits go in from high to low: each level lower than the last one by this factor, down to the lowest, in
/// units of δ. Where the topology is only aimed at, parts of the input may cross, and what lies lower is as
/// likely to be such a crossing as a handle.
constexpr double level_step = 0.7, lowest_level = 0.01, lowest_level_aimed_at = 0.3;
/// The same of open surfaces, where more points have brought no more.
constexpr double lowest_level_of_sheets = 0.01;
/// The same for places between regions and pockets where sides are told by depth, in units of δ'.
constexpr double highest_basin = 0.98, basin_step = 0.93, lowest_basin = 0.3;
/// Points beyond the offset of the outside go in down to so much beyond; parts of edges and facets this small
/// are judged by their middles. In units of δ'.
constexpr double lowest_offset_level = 0.05, smallest_offset_part = 0.15;
/// How far apart points along contacts are, in units of δ', at first and at last.
constexpr double first_contact_spacing = 0.5, finest_contact_spacing = 0.125;
/// From a summit down to its point, the first of so many stations that f has on the wrong side goes in.
constexpr int climb_stations = 4;

} // namespace

const TopologyVerdict& TopologyCondition::verdict() {
  const Step now = context_.recorder().journal().steps();
  if (!verdict_ || judged_at_ != now) {
    const Complex& complex = context_.live().complex();
    verdict_ = trial_ ? trial_(complex) : check_topology(extract_zero_set(complex), expected_);
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
  summits_.reset();
  contacts_.reset();
  edge_search_.forget();
  facet_search_.forget();
  contact_spacing_ = first_contact_spacing;
  // A cut on trial after each of the many points of the paper's rule would take too long.
  enter(context_.criteria().certified || trial_ ? first_search() : Phase::circumradii);
}

std::string TopologyCondition::expectation() const {
  std::string text;
  if (expected_.euler_characteristic) text = "χ = " + std::to_string(*expected_.euler_characteristic);
  if (expected_.components) {
    if (!text.empty()) text += " with ";
    text +=
        std::to_string(*expected_.components) + (*expected_.components == 1 ? " component" : " components");
  }
  return text + " (from " + expected_.source + ")";
}

void TopologyCondition::enter(Phase phase) {
  phase_ = phase;
  points_.clear();
  candidates_.clear();
  fruitful_ = false;
  if (phase == Phase::contacts || phase == Phase::offset || phase == Phase::edges || phase == Phase::summits)
    level_ = context_.volume().thresholds().boundary * level_step;
  if (phase == Phase::basins) level_ = context_.volume().thresholds().boundary * highest_basin;
}

std::size_t TopologyCondition::circumradius_limit() const {
  return searchable() ? insertion_limit_ / 2 : insertion_limit_;
}

Event TopologyCondition::event(Reason reason) const {
  Event event;
  event.condition = Condition::topology;
  event.reason = reason;
  event.value = static_cast<double>(context_.live().euler_characteristic());
  event.limit = static_cast<double>(expected_.euler_characteristic.value_or(0));
  return event;
}

bool TopologyCondition::is_right() {
  if (trial_) return (!mending_ || points_.empty()) && verdict().as_expected;
  const long found = context_.live().euler_characteristic();
  if (expected_.euler_characteristic.value_or(found) != found) return false;
  // All of Z is looked at once only that is right which is counted as T changes.
  if (expected_.components && context_.live().zero_components() != *expected_.components) return false;
  return verdict().as_expected;
}

Turn TopologyCondition::turn() {
  if (phase_ == Phase::given_up) return Turn::satisfied;
  if (is_right()) return settle();
  if (!mending_ && candidates_.empty()) note_check();
  return mend();
}

Turn TopologyCondition::settle() {
  note_check();
  // Condition 3 waited: it has its turn, and then the topology again.
  return std::exchange(mending_, false) ? Turn::acted : Turn::satisfied;
}

Turn TopologyCondition::mend() {
  while (phase_ != Phase::given_up && context_.insertions(Condition::topology) < insertion_limit_) {
    if (context_.cancelled()) return Turn::acted;
    if (phase_ == Phase::circumradii) {
      if (context_.insertions(Condition::topology) < circumradius_limit() && refine_largest())
        return Turn::acted;
      enter(first_search());
    }
    if (!searchable()) break;
    if (points_.empty() && turn_pockets()) return Turn::acted;
    if (insert_next_point()) {
      mending_ = true;
      return Turn::acted;
    }
    if (context_.cancelled()) return Turn::acted; // before all points were collected
    if (trial_ && mending_ && verdict().as_expected) return settle();
    advance();
  }
  enter(Phase::given_up);
  mending_ = false;
  note_check();
  return Turn::acted;
}

bool TopologyCondition::turn_pockets() {
  LiveTriangulation& live = context_.live();
  if (trial_ || !sides_known() || context_.volume().has_rooms()) return false;
  if (!expected_.euler_characteristic || !expected_.components) return false;
  const long surplus = live.euler_characteristic() - *expected_.euler_characteristic;
  if (surplus <= 0 || surplus % 2 != 0) return false;
  const std::size_t spheres = static_cast<std::size_t>(surplus / 2);
  if (live.zero_components() != *expected_.components + spheres) return false;
  std::vector<VertexId> vertices;
  std::size_t found = 0;
  for (const std::vector<VertexId>& pocket : find_pockets(live.complex())) {
    const bool again = std::any_of(pocket.begin(), pocket.end(), [&](VertexId v) {
      return std::binary_search(turned_.begin(), turned_.end(), v);
    });
    if (again || found == spheres) continue;
    ++found;
    vertices.insert(vertices.end(), pocket.begin(), pocket.end());
  }
  if (vertices.empty()) return false;
  turned_.insert(turned_.end(), vertices.begin(), vertices.end());
  std::sort(turned_.begin(), turned_.end());
  Event why = event(Reason::pocket);
  why.vertex = vertices.front();
  why.point = live.complex().position(vertices.front());
  why.count = static_cast<std::uint32_t>(vertices.size());
  context_.relabel(vertices, why);
  return true;
}

bool TopologyCondition::insert_next_point() {
  if (points_.empty()) {
    collect_points();
    if (context_.cancelled()) {
      points_.clear();
      return false;
    }
    fruitful_ = false;
  }
  while (!points_.empty() && points_.back().height >= level_) {
    const MisclassifiedPoint point = points_.back();
    points_.pop_back();
    if (!insert_point(point)) continue;
    fruitful_ = true;
    return true;
  }
  points_.clear();
  return false;
}

void TopologyCondition::advance() {
  if (fruitful_) return;
  if (phase_ == Phase::contacts) return leave_contacts();
  if (phase_ == Phase::offset) {
    level_ *= level_step;
    if (level_ < lowest_offset_level * context_.volume().thresholds().boundary) enter(Phase::given_up);
    return;
  }
  if (phase_ == Phase::basins) {
    level_ *= basin_step;
    if (level_ < lowest_basin * context_.volume().thresholds().boundary) enter(Phase::given_up);
    return;
  }
  if (phase_ != Phase::facets) {
    phase_ = phase_ == Phase::summits ? Phase::edges : Phase::facets;
    return;
  }
  lower_level();
  if (expected_.joined) {
    phase_ = Phase::edges;
    if (!levels_left()) enter(Phase::offset);
    return;
  }
  phase_ = summits_ ? Phase::summits : first_search();
  if (!levels_left()) try_summits();
}

/// Parts in which points are held may be as thin as they like: the last level has all of them.
void TopologyCondition::lower_level() {
  const ToleranceVolume& volume = context_.volume();
  const double last = lowest_level * volume.thresholds().delta, lower = level_ * level_step;
  level_ = lower < last && last <= level_ && volume.held() > 0 ? lowest_level * last : lower;
}

bool TopologyCondition::levels_left() const {
  if (trial_) return level_ >= lowest_level_of_sheets * context_.volume().thresholds().delta;
  if (!expected_.required) return level_ >= lowest_level_aimed_at * context_.volume().thresholds().delta;
  const ToleranceVolume& volume = context_.volume();
  const double lowest = volume.held() > 0 ? lowest_level * lowest_level : lowest_level;
  return level_ >= lowest * volume.thresholds().delta;
}

void TopologyCondition::try_summits() {
  if (summits_ || !expected_.required || trial_) return enter(Phase::given_up);
  std::vector<MisclassifiedPoint> summits = thin_summits(context_.volume(), context_.control());
  if (context_.cancelled()) return;
  summits_ = std::move(summits);
  enter(Phase::summits);
}

/// Contacts are looked at more and more finely; what is not joined then is found by the offset of the
/// outside. That would fill thin parts that are held with more points than their middles, which come before.
void TopologyCondition::leave_contacts() {
  if (contact_spacing_ > finest_contact_spacing) {
    contact_spacing_ *= 0.5;
    contacts_.reset();
    return;
  }
  if (context_.volume().has_rooms()) return enter(Phase::basins);
  enter(context_.volume().held() > 0 ? Phase::edges : Phase::offset);
}

void TopologyCondition::collect_points() {
  if (phase_ == Phase::contacts) {
    if (!contacts_)
      contacts_ = contact_points(
          context_.volume(), contact_spacing_ * context_.volume().thresholds().boundary, context_.control());
    points_ = *contacts_;
  } else if (phase_ == Phase::summits) {
    points_ = *summits_;
    while (!points_.empty() && points_.back().height < level_) points_.pop_back();
  } else if (phase_ == Phase::offset) {
    const double boundary = context_.volume().thresholds().boundary;
    const double reach = expected_.reach > 0
                             ? expected_.reach
                             : OuterOffset::usual_reach(context_.volume(), context_.criteria().sigma);
    points_ = offset_search_.find(context_.live(), OuterOffset(context_.volume(), context_.nearest(), reach),
                                  {level_, smallest_offset_part * boundary, reach}, context_.control());
  } else if (phase_ == Phase::basins) {
    points_ = misclassified_basins(context_.live(), context_.volume(), level_, context_.control());
  } else if (phase_ == Phase::edges) {
    points_ = edge_search_.find(context_.live(), context_.volume(), context_.control());
  } else {
    points_ = facet_search_.find(context_.live(), context_.volume(), context_.control());
  }
  // Gaps between parts that are to be joined stay as they are.
  if (expected_.joined && phase_ != Phase::contacts && phase_ != Phase::offset)
    std::erase_if(points_, [](const MisclassifiedPoint& p) { return p.label > 0; });
  std::reverse(points_.begin(), points_.end());
}

bool TopologyCondition::misclassified(Vec3 p, int label, TetId t) const {
  const Complex& complex = context_.live().complex();
  return LabelFunctions(complex, t).of(label)(p) <= 0;
}

bool TopologyCondition::insert_point(const MisclassifiedPoint& candidate) {
  const LiveTriangulation& live = context_.live();
  TetId t = live.alive(candidate.tet) ? candidate.tet : context_.hint();
  for (int k = climb_stations; k >= 0; --k) {
    const double up = static_cast<double>(k) / climb_stations;
    const Vec3 p = candidate.point + up * (candidate.summit - candidate.point);
    const Vertex vertex = context_.free_vertex(p, candidate.label, VertexKind::topology);
    const TetId at = live.delaunay().locate(vertex.position, t);
    if (!at.valid()) continue;
    t = at;
    if (!misclassified(vertex.position, candidate.label, t)) continue;
    if (context_.spacing(vertex.position, t) < context_.smallest_spacing()) continue;
    Event why = event(phase_ == Phase::basins ? Reason::cut_off : Reason::crossing_simplex);
    why.tet = t;
    why.witness = candidate.point;
    if (context_.insert(vertex, t, why)) return true;
  }
  return false;
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
