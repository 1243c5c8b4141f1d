// The worker that looks at edges: the newest question is answered, wherever the edge is.
#include "app/small_run.h"
#include "edge/probe.h"

#include <doctest/doctest.h>

#include <atomic>

using namespace isoscope;

TEST_CASE("the newest question is answered last") {
  Session session;
  const SessionSnapshot run = small_run(session);
  REQUIRE(run.phase == SessionPhase::finished);
  Playback playback(run.journal);
  std::optional<Step> embedded;
  for (Step k = 0; k < run.journal->steps() && !embedded; ++k)
    if (run.journal->events()[run.journal->operations()[k].event].kind == EventKind::tessellation)
      embedded = k + 1;
  REQUIRE(embedded.has_value());
  const auto state = make_snapshot(playback, *embedded, {}, nullptr);
  const ZeroSet& zero = state->zero_set;

  std::atomic<int> notified{0};
  auto owner = std::make_unique<ProbeWorker>(
      probe_work(), [&] { ++notified; }, Overtaken::finished);
  ProbeWorker& probe = *owner;
  CHECK(probe.idle());
  CHECK(probe.answered() == nullptr);
  ProbeRequest request;
  request.state = state;
  request.journal = run.journal;
  request.scene = run.scene;
  request.parameters = run.parameters;
  for (std::size_t i = 0; i < 40; ++i) {
    const auto& p = zero.polygons[i % zero.polygons.size()];
    request.question = {zero.vertices[p.v[0]].negative, zero.vertices[p.v[1]].negative, {}, {}};
    probe.ask(request);
  }
  probe.wait();
  REQUIRE(probe.answered() != nullptr);
  CHECK(probe.answered()->answer->request == request);
  REQUIRE(probe.answered()->answer->xray != nullptr);
  CHECK(probe.answered()->answer->xray->attempt.kind == EdgeKind::zero);

  request.question = {VertexId(0), VertexId(0), {}, {}};
  probe.ask(request);
  probe.wait();
  CHECK(probe.answered()->answer->xray == nullptr);
  owner.reset(); // a notification may come after the wait for its answer
  CHECK(notified > 0);
}

TEST_CASE("a probe may be dropped while it works") {
  Session session;
  const SessionSnapshot run = small_run(session);
  Playback playback(run.journal);
  const auto state = make_snapshot(playback, run.journal->steps(), {}, nullptr);
  for (int i = 0; i < 20; ++i) {
    ProbeWorker probe(
        probe_work(), [] {}, Overtaken::finished);
    ProbeRequest request;
    request.state = state;
    request.journal = run.journal;
    request.scene = run.scene;
    request.question = {VertexId(9), VertexId(10), {}, {}};
    probe.ask(request);
  }
}
