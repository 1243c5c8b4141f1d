// Two walks over each journal: one gathers what was decided and where, one looks for refusals of what only
// the other run did. Matching is by sorting, so nothing depends on addresses or hashes.
#include "compare/decision_table.h"

#include <algorithm>
#include <array>
#include <compare>
#include <functional>
#include <numeric>
#include <tuple>

namespace isoscope {

namespace {

/// A point, or the ends of an edge in ascending order.
struct Place {
  bool edge = false;
  std::array<double, 6> at{};
  friend auto operator<=>(const Place&, const Place&) = default;
  Vec3 middle() const {
    const Vec3 p{at[0], at[1], at[2]}, q{at[3], at[4], at[5]};
    return edge ? 0.5 * (p + q) : p;
  }
};

Place place_of(Vec3 p) {
  return {false, {p.x, p.y, p.z, 0, 0, 0}};
}

Place place_of(Vec3 p, Vec3 q) {
  if (std::tie(q.x, q.y, q.z) < std::tie(p.x, p.y, p.z)) std::swap(p, q);
  return {true, {p.x, p.y, p.z, q.x, q.y, q.z}};
}

/// Where the vertices are, step by step.
class Positions {
 public:
  void apply(const Delta& delta) {
    for (const Vertex& v : delta.added_vertices) positions_.push_back(v.position);
    for (const Delta::Move& m : delta.moves) positions_[m.vertex.index()] = m.after;
  }
  bool has(VertexId v) const { return v.valid() && v.index() < positions_.size(); }
  Vec3 operator[](VertexId v) const { return positions_[v.index()]; }

 private:
  std::vector<Vec3> positions_;
};

bool accepts(const Event& e) {
  return e.operation &&
         (e.kind == EventKind::insertion || e.kind == EventKind::collapse || e.kind == EventKind::repair);
}

/// Calls `found` with the number and the place of each event from `from` on that is `wanted`.
void walk(const Journal& journal, std::size_t from, bool (*wanted)(const Event&), const RunControl& control,
          const std::function<void(std::uint32_t, const Place&)>& found) {
  constexpr std::size_t poll = 4096;
  Positions positions;
  for (std::size_t i = 0, n = journal.events().size(); i < n; ++i) {
    if (i % poll == 0 && control.cancelled()) return;
    const Event& e = journal.events()[i];
    if (e.operation && e.step >= journal.operations().size()) return; // it is being written
    if (i >= from && wanted(e)) {
      if (e.kind == EventKind::insertion)
        found(static_cast<std::uint32_t>(i), place_of(e.point));
      else if (positions.has(e.vertex) && positions.has(e.other))
        found(static_cast<std::uint32_t>(i), place_of(positions[e.vertex], positions[e.other]));
    }
    if (e.operation) positions.apply(journal.operations()[e.step].delta());
  }
}

struct Made {
  Place place;
  std::uint32_t event = 0;
  bool common = false;                  ///< the other run did it too
  std::optional<std::uint32_t> refusal; ///< by the other run
};

bool by_place(const Made& a, const Made& b) {
  return std::tie(a.place, a.event) < std::tie(b.place, b.event);
}

std::vector<Made> gather(const Journal& journal, std::size_t from, const RunControl& control) {
  std::vector<Made> made;
  walk(journal, from, accepts, control, [&](std::uint32_t event, const Place& place) {
    made.push_back({place, event, false, {}});
  });
  std::sort(made.begin(), made.end(), by_place);
  return made;
}

/// The n-th decision at a place matches the other run's n-th there.
void match(std::vector<Made>& a, std::vector<Made>& b) {
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const auto order = a[i].place <=> b[j].place;
    if (order < 0)
      ++i;
    else if (order > 0)
      ++j;
    else
      a[i++].common = b[j++].common = true;
  }
}

void find_refusals(std::vector<Made>& made, const Journal& other, std::size_t from,
                   const RunControl& control) {
  const auto refuses = [](const Event& e) { return e.kind == EventKind::rejection; };
  walk(other, from, refuses, control, [&](std::uint32_t event, const Place& place) {
    for (auto at = std::lower_bound(made.begin(), made.end(), place,
                                    [](const Made&m, const Place&p) { return m.place < p; });
         at != made.end() && at->place == place; ++at)
      if (!at->common) at->refusal = event;
  });
}

void count(const std::vector<Made>& made, const Journal& journal, bool by_a,
           std::array<StageDecisions, stage_count>& stages, std::vector<DecisionDifference>& rows) {
  std::vector<const Made*> ordered(made.size());
  std::transform(made.begin(), made.end(), ordered.begin(), [](const Made& m) { return &m; });
  std::sort(ordered.begin(), ordered.end(), [](const Made* x, const Made* y) { return x->event < y->event; });
  std::array<std::size_t, stage_count> listed{};
  for (const Made* m : ordered) {
    const Stage stage = journal.events()[m->event].stage;
    const auto s = static_cast<std::size_t>(stage);
    if (m->common) {
      if (by_a) ++stages[s].both; // counted once
      continue;
    }
    ++(by_a ? stages[s].only_a : stages[s].only_b);
    if (listed[s]++ < DecisionTable::row_limit)
      rows.push_back({stage, by_a, m->event, m->refusal, m->place.middle()});
  }
}

std::size_t sum(const std::vector<StageDecisions>& stages, std::size_t StageDecisions::*member) {
  return std::accumulate(stages.begin(), stages.end(), std::size_t{0},
                         [&](std::size_t n, const StageDecisions& s) { return n + s.*member; });
}

} // namespace

std::size_t DecisionTable::both() const {
  return sum(stages, &StageDecisions::both);
}
std::size_t DecisionTable::only_a() const {
  return sum(stages, &StageDecisions::only_a);
}
std::size_t DecisionTable::only_b() const {
  return sum(stages, &StageDecisions::only_b);
}

DecisionTable differing_decisions(const Journal& a, const Journal& b, std::size_t from,
                                  const RunControl& control) {
  std::vector<Made> made_a = gather(a, from, control), made_b = gather(b, from, control);
  match(made_a, made_b);
  find_refusals(made_a, b, from, control);
  find_refusals(made_b, a, from, control);
  std::array<StageDecisions, stage_count> stages;
  for (std::size_t s = 0; s < stages.size(); ++s) stages[s].stage = static_cast<Stage>(s);
  DecisionTable table;
  count(made_a, a, true, stages, table.rows);
  count(made_b, b, false, stages, table.rows);
  for (const StageDecisions& s : stages)
    if (s.both + s.only_a + s.only_b > 0) table.stages.push_back(s);
  const auto step = [&](const DecisionDifference& d) { return (d.made_by_a ? a : b).events()[d.event].step; };
  std::stable_sort(table.rows.begin(), table.rows.end(),
                   [&](const DecisionDifference& x, const DecisionDifference& y) {
                     return std::tuple(x.stage, step(x)) < std::tuple(y.stage, step(y));
                   });
  return table;
}

} // namespace isoscope
