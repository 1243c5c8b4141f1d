// Histories of elements: hand-made journals with known rows, and samples against every state looked at.
#include "journal/history.h"

#include "journal/playback.h"
#include "journal/sample_history.h"
#include "journal/synthetic.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;
using Kind = HistoryRow::Kind;

namespace {

/// Three vertices; an edge is rejected, 2 goes into 1, then 1 into 0, which moves; tetrahedra are two slots.
struct Collapses {
  Journal journal;

  Collapses() {
    Delta first;
    for (int i = 0; i < 4; ++i) {
      Vertex v;
      v.position = {static_cast<double>(i), 0, 0};
      v.value = 1;
      first.added_vertices.push_back(v);
    }
    first.added = {{TetId(0), {VertexId(0), VertexId(1), VertexId(2), VertexId(3)}, 0}};
    operation(EventKind::insertion, {}, {}, Reason::none, first);
    event(EventKind::rejection, 1, 2, Reason::kernel_empty);
    event(EventKind::rejection, 1, 2, Reason::normals);
    Delta second;
    second.killed_vertices = {VertexId(2)};
    second.moves = {{VertexId(1), {1, 0, 0}, {1.5, 0, 0}}};
    second.removed = first.added;
    operation(EventKind::collapse, VertexId(1), VertexId(2), Reason::quadric_optimum, second);
    Delta third;
    third.killed_vertices = {VertexId(1)};
    third.moves = {{VertexId(0), {0, 0, 0}, {0.5, 1, 0}}};
    operation(EventKind::collapse, VertexId(0), VertexId(1), Reason::halfedge, third);
    Delta fourth;
    fourth.values = {{VertexId(0), 1, -1}};
    operation(EventKind::relabel, {}, {}, Reason::none, fourth);
  }
  void operation(EventKind kind, VertexId a, VertexId b, Reason reason, Delta delta) {
    Event e;
    e.kind = kind;
    e.vertex = a;
    e.other = b;
    e.reason = reason;
    journal.add_operation(e, std::move(delta), {});
  }
  void event(EventKind kind, int a, int b, Reason reason) {
    Event e;
    e.kind = kind;
    e.vertex = VertexId(a);
    e.other = VertexId(b);
    e.reason = reason;
    journal.add_event(e);
  }
  ElementHistory ask(ElementRef element) const {
    return element_history(journal, element, Complex(), 0, RunControl());
  }
};

std::vector<Kind> kinds(const ElementHistory& h) {
  std::vector<Kind> out;
  for (const HistoryRow& r : h.rows) out.push_back(r.kind);
  return out;
}

} // namespace

TEST_CASE("a vertex is followed through the collapses that took it") {
  const Collapses c;
  const ElementHistory two = c.ask({ElementRef::Kind::vertex, 2, 0});
  CHECK(kinds(two) == std::vector{Kind::born, Kind::merged, Kind::merged, Kind::relabeled});
  CHECK(two.rows[1].other == VertexId(1));
  CHECK(two.rows[1].step == 2);
  CHECK(two.rows[2].other == VertexId(0));
  CHECK(two.heir == VertexId(0));
  CHECK(two.absorbed == 0);
  CHECK(two.path == std::vector<Vec3>{{2, 0, 0}, {1.5, 0, 0}, {0.5, 1, 0}});

  const ElementHistory zero = c.ask({ElementRef::Kind::vertex, 0, 0});
  CHECK(kinds(zero) == std::vector{Kind::born, Kind::absorbed, Kind::moved, Kind::relabeled});
  CHECK(zero.absorbed == 2);
  CHECK(zero.heir == VertexId(0));
  REQUIRE(zero.inflows.size() == 1);
  CHECK(zero.inflows[0].from == Vec3{1.5, 0, 0});
  CHECK(zero.inflows[0].to == Vec3{0.5, 1, 0});
  CHECK(c.ask({ElementRef::Kind::vertex, 9, 0}).rows.empty());
}

TEST_CASE("an edge tells its attempts and when it was there") {
  const Collapses c;
  const ElementHistory h = c.ask({ElementRef::Kind::edge, 2, 1});
  CHECK(kinds(h) == std::vector{Kind::born, Kind::rejected, Kind::rejected, Kind::collapsed, Kind::gone});
  CHECK(h.attempts == 3);
  CHECK(h.rejections == 2);
  CHECK(h.rows[1].reason == Reason::kernel_empty);
  CHECK(h.rows[1].step == 1);
  CHECK(h.rows[3].step == 2);
}

TEST_CASE("a tetrahedron comes, is named and goes") {
  const Collapses c;
  const ElementHistory h = c.ask({ElementRef::Kind::tet, 0, 0});
  CHECK(kinds(h) == std::vector{Kind::born, Kind::gone});
}

TEST_CASE("the last change lies before the step and is no mere attempt") {
  const Collapses c;
  const ElementHistory h = c.ask({ElementRef::Kind::edge, 1, 2});
  REQUIRE(h.last_change(3) != nullptr);
  CHECK(h.last_change(3)->step == 2);
  REQUIRE(h.last_change(2) != nullptr);
  CHECK(h.last_change(2)->step == 1);
  CHECK(h.last_change(1) == nullptr);
}

TEST_CASE("class changes of samples are those that all states show, from wherever they are read") {
  const auto journal = std::make_shared<Journal>();
  record_insertions(*journal, 80, 120, 7);
  Playback playback(journal);
  // Until the other set comes.
  Step end = 0;
  while (end < journal->steps() && !journal->operations()[end].delta().sample_set) ++end;
  REQUIRE(end > 10);
  std::vector<std::vector<char>> bad(end + 1);
  for (Step k = 1; k <= end; ++k) {
    playback.seek(k);
    const BoundarySamples& samples = *playback.samples();
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const TetId t = playback.sample_sets().tet_of(SampleId(s));
      const double f =
          interpolate(playback.complex().positions(t), playback.complex().values(t))(samples.positions[s]);
      bad[k].push_back(is_bad(sample_error(f, samples.labels[s])));
    }
  }
  std::size_t changes = 0;
  for (std::size_t s = 0; s < bad[1].size(); s += 5) {
    const ElementRef element{ElementRef::Kind::sample, static_cast<std::uint32_t>(s), 0};
    std::vector<HistoryRow> first;
    for (const Step from : {Step{1}, end / 2, end}) {
      playback.seek(from);
      const ElementHistory h = element_history(*journal, element, playback.complex(), from, RunControl());
      std::vector<std::pair<Step, bool>> found, expected;
      for (const HistoryRow& r : h.rows)
        if (r.kind != Kind::other_set) found.emplace_back(r.step, r.kind == Kind::became_bad);
      for (Step k = 2; k <= end; ++k)
        if (bad[k][s] != bad[k - 1][s]) expected.emplace_back(k, bad[k][s] != 0);
      CHECK(found == expected);
      CHECK(h.rows.back().kind == Kind::other_set);
      changes += found.size();
      const auto last = last_class_change(*journal, SampleId(s), playback.complex(), from, RunControl());
      const HistoryRow* wanted = h.last_change(from);
      REQUIRE(last.has_value() == (wanted != nullptr));
      if (last) {
        CHECK(last->step == wanted->step);
        CHECK(last->kind == wanted->kind);
        CHECK(last->before == wanted->before);
        CHECK(last->after == wanted->after);
      }
    }
  }
  CHECK(changes > 10);
}
