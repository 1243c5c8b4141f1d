// Vertices, edges and tetrahedra: one pass over the journal. Samples are followed in sample_history.cpp.
#include "journal/history.h"

#include "journal/sample_history.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

constexpr Step poll = 256; ///< operations between two looks at the control

/// Events and operations in order: `at_event` for each event, `at_operation` besides where it has a delta.
template <class AtEvent, class AtOperation>
void walk(const Journal& journal, const RunControl& control, AtEvent&& at_event, AtOperation&& at_operation) {
  const Step steps = journal.steps();
  const std::size_t events = journal.events().size();
  for (std::size_t i = 0; i < events; ++i) {
    const Event& event = journal.events()[i];
    at_event(event, static_cast<std::uint32_t>(i));
    if (!event.operation) continue;
    if (event.step >= steps || (event.step % poll == 0 && control.cancelled())) return;
    at_operation(event, journal.operations()[event.step].delta(), static_cast<std::uint32_t>(i));
  }
}

HistoryRow row(HistoryRow::Kind kind, const Event& event, std::uint32_t index) {
  HistoryRow r;
  r.kind = kind;
  r.step = step_showing(event);
  r.event = index;
  r.reason = event.reason;
  return r;
}

void read_vertex(const Journal& journal, ElementHistory& h, const RunControl& control) {
  VertexId self(h.element.id);
  std::vector<Vec3> places;
  std::vector<std::uint32_t> weight; ///< vertices that ended in each, itself included
  const auto go = [&](Vec3 p) {
    if (h.path.empty() || h.path.back() != p) h.path.push_back(p);
  };
  walk(
      journal, control, [](const Event&, std::uint32_t) {},
      [&](const Event& event, const Delta& delta, std::uint32_t index) {
        for (const Vertex& v : delta.added_vertices) {
          if (places.size() == self.index()) {
            h.rows.push_back(row(HistoryRow::Kind::born, event, index));
            h.rows.back().to = v.position;
            h.rows.back().after = v.value;
            h.origin = index;
            go(v.position);
          }
          places.push_back(v.position);
          weight.push_back(1);
        }
        const bool there = self.index() < places.size();
        for (const Delta::ValueChange& change : delta.values)
          if (change.vertex == self) {
            h.rows.push_back(row(HistoryRow::Kind::relabeled, event, index));
            h.rows.back().before = change.before;
            h.rows.back().after = change.after;
          }
        // Before the moves: where those that go were, and where the one that stays will be.
        std::optional<VertexId> heir;
        const auto target = [&](VertexId v) {
          for (const Delta::Move& move : delta.moves)
            if (move.vertex == v) return move.after;
          return places[v.index()];
        };
        for (const VertexId dead : delta.killed_vertices) {
          const VertexId stays = event.other == dead && event.vertex.valid() ? event.vertex : VertexId();
          if (stays.valid()) weight[stays.index()] += weight[dead.index()];
          if (dead == self) {
            h.rows.push_back(
                row(stays.valid() ? HistoryRow::Kind::merged : HistoryRow::Kind::gone, event, index));
            h.rows.back().other = stays;
            h.rows.back().from = places[dead.index()];
            h.rows.back().to = stays.valid() ? target(stays) : places[dead.index()];
            heir = stays;
          } else if (stays == self && there) {
            h.rows.push_back(row(HistoryRow::Kind::absorbed, event, index));
            h.rows.back().other = dead;
            h.rows.back().from = places[dead.index()];
            h.rows.back().to = target(self);
            h.inflows.push_back({places[dead.index()], target(self)});
          }
        }
        for (const Delta::Move& move : delta.moves) {
          if (move.vertex == self && !heir) {
            h.rows.push_back(row(HistoryRow::Kind::moved, event, index));
            h.rows.back().from = move.before;
            h.rows.back().to = move.after;
            go(move.after);
          }
          places[move.vertex.index()] = move.after;
        }
        if (!heir) return;
        if (self.index() == h.element.id) h.absorbed = weight[self.index()] - 1;
        self = *heir;
        if (self.valid()) go(places[self.index()]);
      });
  if (self.index() == h.element.id && self.index() < weight.size()) h.absorbed = weight[self.index()] - 1;
  h.heir = self.valid() && self.index() < places.size() ? self : VertexId();
}

void read_edge(const Journal& journal, ElementHistory& h, const RunControl& control) {
  const VertexId a(h.element.id), b(h.element.other);
  long around = 0; ///< tetrahedra or facets that have the edge
  const auto has = [&](const auto& corners) {
    return std::find(corners.begin(), corners.end(), a) != corners.end() &&
           std::find(corners.begin(), corners.end(), b) != corners.end();
  };
  walk(
      journal, control,
      [&](const Event& e, std::uint32_t index) {
        const bool collapsed = e.kind == EventKind::collapse || e.kind == EventKind::repair;
        if (!collapsed && e.kind != EventKind::rejection) return;
        if (!((e.vertex == a && e.other == b) || (e.vertex == b && e.other == a))) return;
        ++h.attempts;
        h.rejections += !collapsed;
        h.rows.push_back(row(collapsed ? HistoryRow::Kind::collapsed : HistoryRow::Kind::rejected, e, index));
        h.rows.back().before = e.value;
        h.rows.back().after = e.limit;
      },
      [&](const Event& event, const Delta& delta, std::uint32_t index) {
        const long before = around;
        for (const TetRecord& t : delta.removed) around -= has(t.v);
        for (const TetRecord& t : delta.added) around += has(t.v);
        for (const FacetRecord& f : delta.removed_facets) around -= has(f.v);
        for (const FacetRecord& f : delta.added_facets) around += has(f.v);
        if ((before == 0) == (around == 0)) return;
        h.rows.push_back(row(around > 0 ? HistoryRow::Kind::born : HistoryRow::Kind::gone, event, index));
      });
}

void read_tet(const Journal& journal, ElementHistory& h, const RunControl& control) {
  const TetId slot(h.element.id);
  std::array<VertexId, 4> corners;
  walk(
      journal, control,
      [&](const Event& event, std::uint32_t index) {
        if (event.tet == slot) h.rows.push_back(row(HistoryRow::Kind::asked, event, index));
      },
      [&](const Event& event, const Delta& delta, std::uint32_t index) {
        for (const TetRecord& t : delta.removed)
          if (t.id == slot) {
            h.rows.push_back(row(HistoryRow::Kind::gone, event, index));
            corners = {};
          }
        for (const TetRecord& t : delta.added)
          if (t.id == slot) {
            h.rows.push_back(row(HistoryRow::Kind::born, event, index));
            corners = t.v;
          }
        for (const Delta::ValueChange& change : delta.values)
          if (std::find(corners.begin(), corners.end(), change.vertex) != corners.end()) {
            h.rows.push_back(row(HistoryRow::Kind::relabeled, event, index));
            h.rows.back().other = change.vertex;
            h.rows.back().before = change.before;
            h.rows.back().after = change.after;
          }
        for (const Delta::SideChange& change : delta.sides)
          if (change.tet == slot) {
            h.rows.push_back(row(HistoryRow::Kind::sided, event, index));
            h.rows.back().before = change.before;
            h.rows.back().after = change.after;
          }
      });
}

} // namespace

std::string_view name(HistoryRow::Kind kind) {
  constexpr std::array<std::string_view, 13> names{
      "born",     "moved",     "absorbed", "merged",     "relabeled",   "sided",    "gone",
      "rejected", "collapsed", "asked",    "became-bad", "became-good", "other-set"};
  return names.at(static_cast<std::size_t>(kind));
}

std::size_t ElementHistory::changes() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const HistoryRow& r) { return r.changes(); }));
}

const HistoryRow* ElementHistory::last_change(Step step) const {
  for (auto r = rows.rbegin(); r != rows.rend(); ++r)
    if (r->step < step && r->changes()) return &*r;
  return nullptr;
}

ElementHistory element_history(const Journal& journal, const ElementRef& element, const Complex& state,
                               Step at, const RunControl& control) {
  ElementHistory h;
  h.element = element;
  h.steps = journal.steps();
  switch (element.kind) {
  case ElementRef::Kind::vertex:
    read_vertex(journal, h, control);
    break;
  case ElementRef::Kind::edge:
    read_edge(journal, h, control);
    break;
  case ElementRef::Kind::tet:
    read_tet(journal, h, control);
    break;
  case ElementRef::Kind::sample:
    h.rows = sample_class_changes(journal, SampleId(element.id), state, at, control);
    break;
  }
  return h;
}

} // namespace isoscope
