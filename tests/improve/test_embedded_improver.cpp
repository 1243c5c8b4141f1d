// The improver inside T: T valid and Z certified after every operation, each of them reversible, the same on
// any number of threads.
#include "simplify/simplified.h"

#include "base/parallel.h"
#include "journal/playback.h"
#include "mesh/validity.h"
#include "tolerance/facet_certificate.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

SimplificationParameters inside_t(Stage until = Stage::improve) {
  SimplificationParameters p;
  p.improver = ImproverPlace::embedded;
  p.until = until;
  return p;
}

bool proven(const Simplified& s, const ZeroSet& z) {
  const double delta = s.bench.volume->thresholds().delta;
  for (const auto& p : z.polygons) {
    const auto& v = z.vertices;
    const Triangle3 facet{v[p.v[0]].position, v[p.v[1]].position, v[p.v[2]].position};
    if (certify_facet(s.bench.volume->index(), facet, delta, delta).kind != FacetVerdict::Kind::inside)
      return false;
  }
  return true;
}

} // namespace

TEST_CASE("inside T every operation leaves T valid and Z certified, and undoes what it did") {
  std::size_t repaired = 0, relaxed = 0, looked = 0;
  for (const auto& [model, percent] : {std::pair("sphere", 4.0), std::pair("torus", 4.0)}) {
    CAPTURE(std::string(model));
    Simplified s(model, {.percent = percent}, inside_t());
    CHECK(s.run());
    check_zero_set(s);
    CHECK(s.complex().form == ZeroForm::embedded);
    CHECK(s.events(EventKind::departure) == 0);
    const auto& operations = s.bench.journal->operations();
    Complex state = s.complex();
    std::size_t vertices = extract_zero_set(state).vertices.size();
    const std::size_t last = vertices;
    for (Step k = s.bench.journal->steps(); k > 0; --k) {
      const Event& e = s.bench.journal->events()[operations[k - 1].event];
      if (e.stage != Stage::improve) break;
      CHECK(check_complex(state).empty());
      const ZeroSet z = extract_zero_set(state);
      CHECK(z.vertices.size() == operations[k - 1].figures.zero_set_vertices);
      CHECK(z.vertices.size() >= vertices);
      CHECK(check_topology(z, s.bench.expected).as_expected);
      if (looked++ % 4 == 0) CHECK(proven(s, z));
      vertices = z.vertices.size();
      // A collapse that fits where it was put needs no sweep.
      repaired += e.kind == EventKind::repair && !s.bench.journal->repairs()[e.detail].empty();
      relaxed += e.kind == EventKind::relaxation;
      if (e.kind == EventKind::relaxation || e.kind == EventKind::repair)
        CHECK(e.value <= s.bench.volume->thresholds().delta);
      const Complex after = state;
      state.undo(operations[k - 1].delta());
      Complex again = state;
      again.apply(operations[k - 1].delta());
      CHECK(again == after);
    }
    Simplified before(model, {.percent = percent}, inside_t(Stage::all));
    before.run();
    CHECK(10 * last < 9 * extract_zero_set(before.complex()).vertices.size());
  }
  CHECK(relaxed > 0);
  CHECK(repaired > 0);
}

TEST_CASE("inside T too every number of threads writes the same journal") {
  std::uint64_t expected = 0;
  for (const unsigned threads : {1u, 7u}) {
    const ThreadLimit limit(threads);
    Simplified s("torus", {.percent = 4}, inside_t());
    s.run();
    if (expected == 0) expected = digest(*s.bench.journal);
    CHECK(digest(*s.bench.journal) == expected);
  }
}

TEST_CASE("inside T it stops with a valid Z and goes on, and replay reaches its state") {
  Simplified s("sphere", {.percent = 3}, inside_t());
  std::size_t improved = 0;
  s.bench.gate->script = [&](const Journal&, const Event& e) {
    improved += e.stage == Stage::improve && e.operation;
    return improved == 10 ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  CHECK_FALSE(s.run());
  check_zero_set(s);
  s.bench.gate->script = nullptr;
  CHECK(s.run());
  check_zero_set(s);
  Playback playback(s.bench.journal);
  playback.seek(s.bench.journal->steps());
  CHECK(playback.complex() == s.complex());
}

TEST_CASE("without normals it stays inside T as well, and every effort gives a valid Z") {
  std::size_t last = 0xffffffff;
  for (const int effort : {0, 1, 2}) {
    CAPTURE(effort);
    SimplificationParameters parameters = inside_t();
    parameters.effort = effort;
    Simplified s("sphere", {.percent = 5, .adjust = [](CriteriaParameters& c) { c.condition_3 = false; }},
                 parameters);
    CHECK(s.run());
    check_zero_set(s);
    CHECK(s.events(EventKind::repair) * std::size_t(effort < 2) == 0);
    const std::size_t vertices = extract_zero_set(s.complex()).vertices.size();
    CHECK(vertices <= last);
    last = vertices;
  }
}
