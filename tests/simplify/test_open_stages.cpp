// Stages on a Z with a border: part of a refined closed surface, cut out by hand, whose own border is the
// rim.
#include "simplify/simplified.h"

#include "base/parallel.h"
#include "journal/digest.h"
#include "journal/playback.h"
#include "mesh/strata.h"
#include "mesh/validity.h"
#include "tolerance/border_gate.h"
#include "tolerance/facet_certificate.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

SimplificationParameters cut_until(Stage stage, ImproverPlace place) {
  SimplificationParameters p;
  p.until = stage;
  p.improver = place;
  p.skipped[static_cast<std::size_t>(Stage::tessellation)] = true;
  return p;
}

/// Drops facets of Z that have a corner where `kept` says no, and those at points where fans of kept ones
/// meet.
Complex cut(Complex c, const std::function<bool(Vec3)>& kept) {
  const auto drop = [&](const auto& wanted) {
    for (std::size_t t = 0; t < c.tets.size(); ++t)
      for (std::size_t k = 0; c.tets[t].alive() && k < 4; ++k)
        if (c.on_zero_set(TetId(t), k) && wanted(c.tets[t].facet(k)))
          c.tets[t].dropped = static_cast<std::uint8_t>(c.tets[t].dropped | 1u << k);
  };
  drop([&](const std::array<VertexId, 3>& f) {
    return std::any_of(f.begin(), f.end(), [&](VertexId v) { return !kept(c.position(v)); });
  });
  for (bool changed = true; changed;) {
    changed = false;
    const Incidence incidence(c);
    for (std::size_t v = 0; v < c.vertices.size(); ++v) {
      if (stratum_of(c, incidence, VertexId(v)) != Stratum::point) continue;
      drop([&](const std::array<VertexId, 3>& f) {
        const bool at = std::find(f.begin(), f.end(), VertexId(v)) != f.end();
        changed = changed || at;
        return at;
      });
    }
  }
  return c;
}

struct Surface {
  long characteristic = 0;
  std::vector<Segment3> border;
  std::size_t loops = 0;
  bool manifold = true;
};

Surface surface_of(const ZeroSet& z) {
  Surface s;
  s.characteristic = z.euler_characteristic();
  std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
  for (const auto& p : z.polygons)
    for (std::size_t k = 0; k < 3; ++k)
      s.manifold = directed.insert({p.v[k], p.v[(k + 1) % 3]}).second && s.manifold;
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b] : directed) {
    if (directed.contains({b, a})) continue;
    s.manifold = next.emplace(a, b).second && s.manifold;
    s.border.push_back({z.vertices[a].position, z.vertices[b].position});
  }
  while (!next.empty()) {
    ++s.loops;
    for (auto at = next.begin(); at != next.end();) {
      const std::uint32_t to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return s;
}

/// A sphere or torus cut open at its tessellation, to be simplified with its border held to the cut.
struct CutOpen {
  Simplified s;
  Complex start;
  Surface before;
  std::unique_ptr<Simplification> simplification;

  CutOpen(std::string_view model, double percent, const std::function<bool(Vec3)>& kept,
          ImproverPlace place = ImproverPlace::free)
      : s(model, {.percent = percent}, [] {
          SimplificationParameters p;
          p.until = Stage::tessellation;
          return p;
        }()) {
    s.run();
    start = cut(s.complex(), kept);
    before = surface_of(extract_zero_set(start));
    REQUIRE(before.manifold);
    s.bench.volume->keep_border_to(before.border);
    simplification = std::make_unique<Simplification>(*s.bench.volume, s.bench.samples, s.bench.criteria,
                                                      cut_until(Stage::improve, place), *s.bench.recorder,
                                                      *s.bench.control, start);
  }
};

void check_surface(const CutOpen& open, const Complex& state) {
  const ZeroSet z = extract_zero_set(state);
  const Surface now = surface_of(z);
  CHECK(now.manifold);
  CHECK(now.characteristic == open.before.characteristic);
  CHECK(now.loops == open.before.loops);
  CHECK(z.components.size() == 1);
  const double delta = open.s.bench.volume->thresholds().delta;
  const BorderGate to_rim(open.before.border, delta), to_border(now.border, delta);
  for (const Segment3& edge : now.border) CHECK(to_rim.keeps_to_rim(edge).proven);
  for (const Segment3& edge : open.before.border) CHECK(to_border.keeps_to_rim(edge).proven);
  for (const auto& p : z.polygons) {
    const auto& v = z.vertices;
    const Triangle3 facet{v[p.v[0]].position, v[p.v[1]].position, v[p.v[2]].position};
    CHECK(certify_facet(open.s.bench.volume->field(), facet, delta, delta).kind ==
          FacetVerdict::Kind::inside);
  }
  if (state.form != ZeroForm::free) CHECK(check_complex(state).empty());
}

} // namespace

TEST_CASE("stages on a cut sphere and a cut torus keep loops and χ, and the border to the rim") {
  const std::pair<const char*, std::function<bool(Vec3)>> cases[] = {
      {"sphere", [](Vec3 p) { return p.z > -0.1; }}, {"torus", [](Vec3 p) { return p.x > -0.3; }}};
  for (const auto& [model, kept] : cases) {
    CAPTURE(std::string(model));
    CutOpen open(model, 3, kept);
    CHECK(open.before.loops == (std::string(model) == "sphere" ? 1u : 2u));
    const Step first = open.s.bench.journal->steps();
    const Result<bool> done = open.simplification->run();
    REQUIRE(done.ok());
    CHECK(*done);
    check_surface(open, open.simplification->complex());
    // Forwards through all operations: the border is right after each, and figures count Z alone.
    Complex state = open.start;
    std::size_t border_collapses = 0, vertices = extract_zero_set(state).vertices.size();
    const auto& operations = open.s.bench.journal->operations();
    for (Step k = first; k < open.s.bench.journal->steps(); ++k) {
      const Surface was = surface_of(extract_zero_set(state));
      state.apply(operations[k].delta());
      const ZeroSet z = extract_zero_set(state);
      CHECK(operations[k].figures.zero_set_vertices == z.vertices.size());
      const Surface is = surface_of(z);
      border_collapses += is.border.size() < was.border.size() ? 1u : 0u;
      if (k % 37 == 0) check_surface(open, state);
    }
    CHECK(state == open.simplification->complex());
    const Surface now = surface_of(extract_zero_set(state));
    MESSAGE(std::string(model) << ": " << vertices << " -> " << extract_zero_set(state).vertices.size()
                               << " vertices, border " << open.before.border.size() << " -> "
                               << now.border.size());
    CHECK(border_collapses > 10);
    CHECK(now.border.size() * 3 < open.before.border.size() * 2);
    CHECK(extract_zero_set(state).vertices.size() * 4 < vertices);
  }
}

TEST_CASE("with a border every thread count writes the same journal") {
  std::uint64_t expected = 0;
  for (const unsigned threads : {1u, 3u}) {
    const ThreadLimit limit(threads);
    CutOpen open("sphere", 5, [](Vec3 p) { return p.z > -0.1; });
    REQUIRE(open.simplification->run().ok());
    if (expected == 0) expected = digest(*open.s.bench.journal);
    CHECK(digest(*open.s.bench.journal) == expected);
  }
}

TEST_CASE("the improver inside T keeps the border to the rim, and dropped facets where they are") {
  CutOpen open(
      "sphere", 5, [](Vec3 p) { return p.z > -0.1; }, ImproverPlace::embedded);
  REQUIRE(open.simplification->run().ok());
  const Complex& state = open.simplification->complex();
  CHECK(state.form == ZeroForm::embedded);
  check_surface(open, state);
  const auto& journal = *open.s.bench.journal;
  std::size_t improved = 0;
  Complex back = state;
  for (Step k = journal.steps(); k > 0; --k) {
    const Operation& operation = journal.operations()[k - 1];
    if (journal.events()[operation.event].stage != Stage::improve) break;
    back.undo(operation.delta());
    CHECK(check_complex(back).empty());
    ++improved;
  }
  CHECK(improved > 0);
}
