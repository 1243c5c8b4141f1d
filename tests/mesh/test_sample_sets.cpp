// The tetrahedron of a sample is a function of T alone, whatever the way there and the number of threads.
#include "base/parallel.h"
#include "mesh/sample_sets.h"
#include "mesh/support.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

using namespace isoscope;
using namespace isoscope::test;

namespace {

struct Setting {
  const char* name;
  Box3 box;
  std::vector<Vec3> inserted, samples;
};

/// Samples on a lattice twice as fine as the vertices: on vertices, edges, facets and inside.
Setting lattice_setting() {
  std::vector<Vec3> samples;
  for (const Vec3 p : lattice_points(17, 6)) samples.push_back(0.5 * p);
  return {"lattice", {{0, 0, 0}, {8, 8, 8}}, lattice_points(9, 5), samples};
}

std::vector<Setting> settings() {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}}, inner{{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}};
  const auto samples = random_points(6000, inner, 3);
  const std::vector<Vec3> some(samples.begin(), samples.begin() + 400);
  return {lattice_setting(), {"random samples, some of them inserted", unit, some, samples}};
}

bool same(const Complex& c, const SampleSets& a, const SampleSets& b) {
  for (std::size_t s = 0; s < a.size(); ++s) {
    if (a.tet_of(SampleId(s)) != b.tet_of(SampleId(s))) return false;
  }
  for (std::size_t t = 0; t < c.tets.size(); ++t) {
    std::vector<SampleId> x, y;
    a.for_each(TetId(t), [&](SampleId s) { x.push_back(s); });
    b.for_each(TetId(t), [&](SampleId s) { y.push_back(s); });
    if (x != y || !std::is_sorted(x.begin(), x.end())) return false;
  }
  return true;
}

} // namespace

TEST_CASE("following insertions and undoing them equals assigning from scratch, on 1, 2 and 7 threads") {
  for (const Setting& setting : settings()) {
    INFO(setting.name);
    const Grown g = grow(setting.box, setting.inserted);
    std::vector<TetId> reference;
    for (const unsigned threads : {1u, 2u, 7u}) {
      const ThreadLimit limit(threads);
      Complex c;
      c.apply(g.deltas[0]);
      SampleSets followed(setting.samples), fresh(setting.samples);
      followed.assign_all(c);
      for (std::size_t i = 1; i < g.deltas.size(); ++i) {
        c.apply(g.deltas[i]);
        followed.redistribute(c, g.deltas[i].removed, g.deltas[i].added);
        if (i % 60 == 0 || i < 4) {
          fresh.assign_all(c);
          CHECK(same(c, followed, fresh));
        }
      }
      std::vector<TetId> all;
      for (std::size_t s = 0; s < followed.size(); ++s) all.push_back(followed.tet_of(SampleId(s)));
      if (threads == 1) reference = all;
      CHECK(all == reference);
      for (std::size_t i = g.deltas.size(); i-- > 1;) {
        c.undo(g.deltas[i]);
        followed.redistribute(c, g.deltas[i].added, g.deltas[i].removed);
        if (i % 120 == 1) {
          fresh.assign_all(c);
          CHECK(same(c, followed, fresh));
        }
      }
    }
  }
}

TEST_CASE("many insertions taken at once, there and back, equal assigning from scratch") {
  for (const Setting& setting : settings()) {
    INFO(setting.name);
    const Grown g = grow(setting.box, setting.inserted);
    const std::size_t middle = g.deltas.size() / 2;
    Complex c;
    for (std::size_t i = 0; i < middle; ++i) c.apply(g.deltas[i]);
    SampleSets followed(setting.samples), fresh(setting.samples);
    followed.assign_all(c);
    // Every slot that one of the insertions touched, whatever it holds before and after.
    std::vector<TetRecord> touched;
    for (std::size_t i = middle; i < g.deltas.size(); ++i) {
      for (const TetRecord& t : g.deltas[i].removed) touched.push_back(t);
      for (const TetRecord& t : g.deltas[i].added) touched.push_back(t);
    }
    std::sort(touched.begin(), touched.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    touched.erase(std::unique(touched.begin(), touched.end(),
                              [](const auto& a, const auto& b) { return a.id == b.id; }),
                  touched.end());
    const auto alive = [&] {
      std::vector<TetRecord> records;
      for (const TetRecord& t : touched)
        if (t.id.index() < c.tets.size() && c.tet(t.id).alive())
          records.push_back({t.id, c.tet(t.id).v, c.tet(t.id).side});
      return records;
    };
    const auto before = alive();
    for (std::size_t i = middle; i < g.deltas.size(); ++i) c.apply(g.deltas[i]);
    REQUIRE(alive().size() > 300);
    followed.redistribute(c, before, alive());
    fresh.assign_all(c);
    CHECK(same(c, followed, fresh));
    const auto after = alive();
    for (std::size_t i = g.deltas.size(); i-- > middle;) c.undo(g.deltas[i]);
    followed.redistribute(c, after, alive());
    fresh.assign_all(c);
    CHECK(same(c, followed, fresh));
  }
}

TEST_CASE("exhaustive search agrees, with samples on vertices, edges and facets") {
  for (const Setting& setting : settings()) {
    INFO(setting.name);
    Grown g(setting.box);
    SampleSets sets(setting.samples);
    sets.assign_all(g.complex);
    for (std::size_t i = 0; i < setting.inserted.size(); ++i) {
      if (!g.insert(setting.inserted[i])) continue;
      sets.redistribute(g.complex, g.deltas.back().removed, g.deltas.back().added);
      if (i % 200 == 7) CHECK(check_samples(g.complex, sets, setting.samples).empty());
    }
    CHECK(check_samples(g.complex, sets, setting.samples).empty());
  }
}

TEST_CASE("every sample inside the hull has a tetrahedron, those outside have none") {
  const Box3 box{{0, 0, 0}, {8, 8, 8}};
  const Grown g = grow(box, lattice_points(9, 5));
  const std::vector<Vec3> samples{{4, 4, 4},          {4.5, 4, 4}, {4.5, 4.5, 4},
                                  {1.25, 2.5, 3.125}, {9, 4, 4},   {4, 4, -1e-30}};
  SampleSets sets(samples);
  sets.assign_all(g.complex);
  for (int s = 0; s < 4; ++s) CHECK(sets.tet_of(SampleId(s)).valid());
  CHECK_FALSE(sets.tet_of(SampleId(4)).valid());
  CHECK_FALSE(sets.tet_of(SampleId(5)).valid());
  sets.assign_all(Complex{});
  CHECK_FALSE(sets.tet_of(SampleId(0)).valid());
}

TEST_CASE("the checks find a sample that was not moved") {
  const auto samples = random_points(500, {{0, 0, 0}, {1, 1, 1}}, 2);
  Grown g(Box3{{0, 0, 0}, {1, 1, 1}});
  SampleSets sets(samples);
  sets.assign_all(g.complex);
  REQUIRE(g.insert({0.4, 0.5, 0.6}));
  CHECK_FALSE(check_samples(g.complex, sets, samples).empty());
}

TEST_CASE("error and badness of a sample follow its label") {
  CHECK(sample_error(1, 1) == 0);
  CHECK(sample_error(0, -1) == 1);
  CHECK(is_bad(sample_error(0, -1)));
  CHECK(is_bad(sample_error(0.5, -1)));
  CHECK_FALSE(is_bad(sample_error(0.25, 1)));
}

TEST_CASE("speed of assignment and of the first insertions") {
  // Points of a sphere in spatial order, as samplers give them.
  std::vector<Vec3> samples;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      const double a = 3.14159265 * (i + 0.5) / n, b = 3.14159265 * (j + 0.5) / n;
      samples.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  }
  using Clock = std::chrono::steady_clock;
  Random random(4);
  Grown g(Box3{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
  SampleSets sets(samples);
  sets.assign_all(g.complex);
  std::size_t moves = 0;
  double nanoseconds = 0;
  for (int i = 0; i < 300; ++i) {
    if (!g.insert(samples[random.below(samples.size())])) continue;
    const auto before = Clock::now();
    moves += sets.redistribute(g.complex, g.deltas.back().removed, g.deltas.back().added);
    nanoseconds += std::chrono::duration<double, std::nano>(Clock::now() - before).count();
  }
  SampleSets fresh(samples);
  const auto before = Clock::now();
  fresh.assign_all(g.complex);
  const double all = std::chrono::duration<double, std::nano>(Clock::now() - before).count();
  MESSAGE(samples.size() << " samples: redistribute " << nanoseconds / static_cast<double>(moves)
                         << " ns a move (" << moves << " moves), assign_all "
                         << all / static_cast<double>(samples.size()) << " ns a sample");
  CHECK(same(g.complex, sets, fresh));
}
