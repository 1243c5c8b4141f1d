// Places, reasons and times of a hand-made journal.
#include "questions/work_map.h"

#include "run/hand_made_journal.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

/// Four vertices on a line, two insertions near 0, edges 2–3 rejected five times and 0–1 collapsed once.
struct Work {
  Journal journal;
  Work() {
    Delta delta;
    for (const double x : {0.1, 0.3, 5.1, 5.3}) {
      Vertex v;
      v.position = {x, 0.1, 0.1};
      delta.added_vertices.push_back(v);
    }
    add(EventKind::insertion, 0, 0, Reason::largest_error, {0.1, 0.1, 0.1}, delta, 1);
    add(EventKind::insertion, 0, 0, Reason::projected, {0.2, 0.1, 0.1}, Delta(), 3);
    for (int i = 0; i < 3; ++i) reject(Reason::kernel_empty);
    Delta moves;
    moves.moves = {{VertexId(0), {0.1, 0.1, 0.1}, {2.5, 0.1, 0.1}}};
    moves.killed_vertices = {VertexId(1)};
    add(EventKind::collapse, 0, 1, Reason::halfedge, {2.5, 0.1, 0.1}, moves, 7);
    reject(Reason::normals);
    reject(Reason::kernel_empty);
  }
  void add(EventKind kind, int a, int b, Reason reason, Vec3 point, Delta delta, float seconds) {
    Event e;
    e.kind = kind;
    if (a != b) e.vertex = VertexId(a), e.other = VertexId(b);
    e.reason = reason;
    e.point = point;
    StepFigures figures;
    figures.seconds = seconds;
    journal.add_operation(e, std::move(delta), figures);
  }
  void reject(Reason reason) {
    Event e;
    e.kind = EventKind::rejection;
    e.vertex = VertexId(2);
    e.other = VertexId(3);
    e.reason = reason;
    journal.add_event(e);
  }
};

} // namespace

TEST_CASE("events fall into cells by where they took place") {
  const Work w;
  const WorkMap insertions = map_work(w.journal, 0, 100, WorkKind::insertions, 1);
  REQUIRE(insertions.cells.size() == 1);
  CHECK(insertions.cells[0].count == 2);
  CHECK(insertions.cells[0].center == Vec3{0.5, 0.5, 0.5});
  const WorkMap attempts = map_work(w.journal, 0, 100, WorkKind::attempts, 1);
  REQUIRE(attempts.cells.size() == 2);
  CHECK(attempts.total == 6);
  CHECK(attempts.cells[0].count == 5);
  CHECK(attempts.cells[0].reason == Reason::kernel_empty);
  CHECK(attempts.cells[0].cell == std::array<std::int32_t, 3>{5, 0, 0});
  CHECK(attempts.cells[1].cell == std::array<std::int32_t, 3>{0, 0, 0}); // where the edge was before
  CHECK(map_work(w.journal, 6, 100, WorkKind::rejections, 1).total == 2);
}

TEST_CASE("the last attempts tell why nothing is accepted") {
  const Work w;
  const StallReport s = examine_stall(w.journal, w.journal.events().size(), 4, 1);
  CHECK(s.attempts == 4);
  CHECK(s.accepted == 1);
  CHECK(s.since_accepted == 2);
  CHECK(s.by_reason[static_cast<std::size_t>(Reason::kernel_empty)] == 2);
  CHECK(s.by_reason[static_cast<std::size_t>(Reason::normals)] == 1);
  CHECK(s.by_reason[0] == 1);
  CHECK(s.over_time.size() == 4);
  REQUIRE(s.places.cells.size() == 1);
  CHECK(s.places.cells[0].count == 3);
  CHECK(examine_stall(w.journal, 0, 4, 1).attempts == 0);
}

TEST_CASE("what is tried between two operations shares their time") {
  const Work w;
  const auto times = time_by_reason(w.journal, 0, 100);
  double all = 0;
  for (const WorkTime& t : times) {
    all += t.seconds;
    if (t.kind == EventKind::rejection && t.reason == Reason::kernel_empty) {
      CHECK(t.count == 4);
      CHECK(t.seconds == doctest::Approx(3)); // three of four seconds; the last one has no stamp
    }
    if (t.kind == EventKind::collapse) CHECK(t.seconds == doctest::Approx(1));
  }
  CHECK(all == doctest::Approx(7));
}

TEST_CASE("times of a whole run's stages add up to their operations") {
  const auto journal = test::hand_made_journal();
  double refinement = 0, improve = 0;
  for (const WorkTime& t : time_by_reason(*journal, 0, journal->events().size())) {
    if (t.stage == Stage::refinement) refinement += t.seconds;
    if (t.stage == Stage::improve) improve += t.seconds;
  }
  CHECK(refinement == doctest::Approx(64));
  CHECK(improve == doctest::Approx(16));
}
