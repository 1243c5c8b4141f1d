// Further rounds: they begin where effort 2 ends, never need more vertices, and end when they are stopped.
#include "base/parallel.h"
#include "improve/further_rounds.h"
#include "improve/improver.h"
#include "improve/joint_relocation.h"
#include "improve/live_surface.h"
#include "improve/support.h"
#include "improve/symmetric_system.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using isoscope::testing::Bench;
using isoscope::testing::check_valid;
using isoscope::testing::Listener;
using isoscope::testing::sphere;
using isoscope::testing::Start;
using isoscope::testing::with_effort;

namespace {

ImproverOptions with_rounds(std::size_t most) {
  ImproverOptions options = with_effort(3);
  options.most_rounds = most;
  return options;
}

struct Improved {
  TriangleMesh mesh;
  Listener listener;
  ImproverOutcome outcome;
};

Improved improved(const Start& start, const ImproverOptions& options) {
  Improved made;
  made.mesh = start.mesh;
  made.outcome = improve(made.mesh, *start.volume, nullptr, options, RunControl(), made.listener);
  return made;
}

bool same_moves(const SurfaceChange& a, const SurfaceChange& b) {
  return std::equal(a.moves.begin(), a.moves.end(), b.moves.begin(), b.moves.end(),
                    [](const SurfaceChange::Move& x, const SurfaceChange::Move& y) {
                      return x.vertex == y.vertex && x.after == y.after;
                    });
}

double energy_of(const FacetComplex& complex) {
  double sum = 0;
  for (const Facet& f : complex.facets)
    if (f.alive()) sum += f.energy;
  return sum;
}

} // namespace

TEST_CASE("a symmetric system is solved, and one that is not positive definite is refused") {
  SymmetricSystem system(3);
  const double a[3][3] = {{4, 1, 0}, {1, 3, -1}, {0, -1, 2}}, x[3] = {1, -2, 3};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if (j >= i) system.a(i, j) = a[i][j];
      system.b(i) += a[i][j] * x[j];
    }
  REQUIRE(system.solve());
  for (std::size_t i = 0; i < 3; ++i) CHECK(system.b(i) == doctest::Approx(x[i]));
  system.clear();
  system.a(0, 0) = 1;
  CHECK_FALSE(system.solve());
}

TEST_CASE("vertices that move together lower the energy, and what is fixed stays") {
  const Bench bench(sphere(24), 2);
  LiveSurface surface(bench.start.mesh, bench.rules);
  const auto free = vertices_around(surface.complex(), {30}, 2);
  SurfacePatch patch = surface.patch(free);
  // Beside its best place, so that there is something to gain.
  const std::uint32_t moved = patch.local_vertex(30);
  patch.complex.points[moved] = 1.03 * patch.complex.points[moved];
  for (std::uint32_t f = 0; f < patch.complex.facets.size(); ++f)
    measure_facet(bench.input, patch.complex, f);
  const double before = energy_of(patch.complex);
  REQUIRE(relocate_jointly(bench.input, patch, 3));
  CHECK(energy_of(patch.complex) < before);
  for (std::uint32_t v = 0; v < patch.complex.points.size(); ++v)
    if (!patch.free[v]) CHECK(patch.complex.points[v] == patch.start_points[v]);
  // What is stored is what a measurement says, to what guesses may differ far below δ.
  FacetComplex again = patch.complex;
  for (std::uint32_t f = 0; f < again.facets.size(); ++f) measure_facet(bench.input, again, f);
  CHECK(std::abs(energy_of(again) - energy_of(patch.complex)) < 1e-3);
  CHECK(std::any_of(patch.complex.facets.begin(), patch.complex.facets.end(),
                    [](const Facet& f) { return !f.proven; }));
}

TEST_CASE("further rounds begin where effort 2 ends, and never need more vertices") {
  const Start start(sphere(24), 2);
  const Improved two = improved(start, with_effort(2)), three = improved(start, with_rounds(25));
  CHECK(two.outcome.rounds == 0);
  CHECK(three.outcome.rounds == 25);
  check_valid(three.mesh, start, 2);
  CHECK(three.mesh.points.size() < two.mesh.points.size());
  CHECK(three.outcome.collapses == start.mesh.points.size() - three.mesh.points.size());
  REQUIRE(three.listener.changes.size() > two.listener.changes.size());
  for (std::size_t i = 0; i < two.listener.changes.size(); ++i) {
    CHECK(two.listener.changes[i].kind == three.listener.changes[i].kind);
    CHECK(same_moves(two.listener.changes[i], three.listener.changes[i]));
  }
}

TEST_CASE("further rounds give the same bits on one thread and on several") {
  const Start start(sphere(16), 3);
  std::vector<Improved> made;
  for (const unsigned threads : {1u, 2u, 5u}) {
    const ThreadLimit limit(threads);
    made.push_back(improved(start, with_rounds(5)));
  }
  for (const Improved& other : made) {
    CHECK(other.mesh.points == made[0].mesh.points);
    CHECK(other.mesh.triangles == made[0].mesh.triangles);
    CHECK(other.listener.rejections.size() == made[0].listener.rejections.size());
  }
}

TEST_CASE("rounds alone go on with a surface, and wherever they are stopped it is valid and none the worse") {
  const Start start(sphere(24), 2);
  const TriangleMesh before = improved(start, with_effort(2)).mesh;
  ImproverOptions options = with_effort(3);
  options.rounds_alone = true;
  options.first_round = 7;
  for (const std::size_t moment : {1u, 2u, 9u, 40u, 150u}) {
    TriangleMesh mesh = before;
    RunControl control;
    Listener listener;
    listener.control = &control;
    listener.cancel_after = moment;
    const auto outcome = improve(mesh, *start.volume, nullptr, options, control, listener);
    CHECK(outcome.end == ImproverOutcome::End::stopped);
    CHECK(outcome.rounds > 0);
    CHECK(mesh.points.size() <= before.points.size());
    check_valid(mesh, start, 2);
  }
}

TEST_CASE("wide neighbourhoods become rare where they save nothing") {
  FurtherRounds rounds(3);
  const ShakeFigures lively{100, 50, 0, false};
  std::vector<std::size_t> wide;
  for (std::size_t r = 0; r < 60; ++r) {
    if (rounds.is_wide()) wide.push_back(r), rounds.wide_saved(0);
    CHECK(rounds.end(lively, true));
  }
  CHECK(wide == std::vector<std::size_t>{0, 2, 6, 14, 30});
  FurtherRounds lucky(0);
  lucky.wide_saved(2);
  CHECK_FALSE(lucky.is_wide());
  lucky.end(lively, true);
  CHECK(lucky.is_wide());
}

TEST_CASE("the amplitude grows while no flip stays, and rounds end when every one is in vain") {
  FurtherRounds rounds(0);
  const ShakeOptions first = rounds.flips(100);
  CHECK(rounds.flips(1000).most_attempts > first.most_attempts);
  const ShakeFigures lively{100, 50, 0, false}, still{100, 0, 0, true};
  CHECK(rounds.end(still, false));
  const ShakeOptions second = rounds.flips(100);
  CHECK(second.pass == first.pass + 1);
  CHECK(second.repair.most_flip_excess > first.repair.most_flip_excess);
  CHECK(second.rings > first.rings);
  CHECK(rounds.end(lively, true));
  CHECK(rounds.flips(100).rings == first.rings);
  CHECK(rounds.end(still, false));
  CHECK(rounds.end(still, true)); // something collapsed all the same
  CHECK(rounds.end(still, false));
  CHECK(rounds.end(still, false));
  CHECK_FALSE(rounds.end(still, false));
}
