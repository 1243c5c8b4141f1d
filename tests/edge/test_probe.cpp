// The worker that looks at edges: the newest question is answered, wherever the edge is.
#include "edge/probe.h"
#include "scene/section_attempt.h"
#include "scene/section_attempt_svg.h"
#include "support/small_run.h"
#include "view/section_through.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <string>

using namespace isoscope;

namespace {

/// The section through an edge shows its kernel, and passes through both ends.
void check_section(const StateSnapshot& state, const EdgeXray& xray) {
  Pick pick;
  pick.kind = Pick::Kind::edge;
  pick.id = xray.star.vertices[0].id.value;
  pick.other = xray.star.vertices[1].id.value;
  const auto through = section_through(state, pick, &xray, {0, 0, 1});
  REQUIRE(through.has_value());
  SectionPlane plane;
  plane.origin = through->point;
  plane.axes = plane_axes(through->normal);
  for (std::size_t i = 0; i < 2; ++i) CHECK(std::abs(plane.height(xray.star.vertices[i].position)) < 1e-9);
  REQUIRE(xray.attempt.kernel.has_value());
  const AttemptSection section =
      attempt_section(xray, nullptr, plane, {true, true, scene_colors(ThemeKind::paper)});
  using Role = AttemptSection::Role;
  if (xray.attempt.kernel->empty) {
    CHECK(section.count(Role::kernel) == 0);
    CHECK(section.lines.size() > 1);
  } else {
    CHECK(section.count(Role::kernel) == 1);
    CHECK(section.marks.size() >= 2);
  }
  const std::string svg = attempt_svg(section, [](const PlanePoint& p) { return p; });
  CHECK(svg.find("<g id=\"edge-marks\">") != std::string::npos);
  CHECK((svg.find("edge-kernel") != std::string::npos) == (section.count(Role::kernel) > 0));
  // A tetrahedron is cut, and what has no edge is refused.
  for (std::uint32_t t = 0; t < state.complex.tets.size(); ++t) {
    if (!state.complex.tets[t].alive()) continue;
    pick = {Pick::Kind::tet, t, {}};
    const auto cell = section_through(state, pick, nullptr, {0, 0, 1});
    REQUIRE(cell.has_value());
    CHECK(length(cell->normal) == doctest::Approx(1));
    break;
  }
  CHECK(!section_through(state, {Pick::Kind::tet, 4000000000u, {}}, nullptr, {0, 0, 1}).has_value());
}

} // namespace

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
  check_section(*state, *probe.answered()->answer->xray);

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
