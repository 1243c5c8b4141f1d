// The conditions one by one: switched off, in sampled mode, and on inputs that are hard to end on.
#include "refine/bench.h"

#include "criteria/height.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

TriangleSoup cube() {
  TriangleSoup soup;
  soup.name = "cube";
  for (unsigned k = 0; k < 8; ++k)
    soup.points.push_back({k & 1u ? 1.0 : 0, k & 2u ? 1.0 : 0, k & 4u ? 1.0 : 0});
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return soup;
}

} // namespace

TEST_CASE("each condition can be switched off") {
  using Switch = bool CriteriaParameters::*;
  const auto without = [](Switch condition) {
    BenchOptions options;
    options.adjust = [condition](CriteriaParameters& c) { c.*condition = false; };
    Bench bench = Bench::gallery("torus", options);
    const RefinementOutcome outcome = bench.run();
    CHECK(outcome.end == RefinementOutcome::End::finished);
    CHECK(check_complex(bench.complex()).empty());
    return bench;
  };
  CHECK(without(&CriteriaParameters::condition_1).insertions(Condition::classification) == 0);
  CHECK(without(&CriteriaParameters::condition_2).insertions(Condition::containment) == 0);
  CHECK(without(&CriteriaParameters::condition_3).insertions(Condition::orientation) == 0);
  CHECK(without(&CriteriaParameters::condition_4).insertions(Condition::topology) == 0);
}

TEST_CASE("containment alone, without classification, still proves Z inside") {
  BenchOptions options;
  options.adjust = [](CriteriaParameters& c) { c.condition_1 = false; };
  Bench bench = Bench::gallery("sphere", options);
  const RefinementOutcome outcome = bench.run();
  CHECK(outcome.contained);
  CHECK(outcome.witnessed);
}

TEST_CASE("sampled mode: every tetrahedron of Z is high enough or reported as exhausted") {
  BenchOptions options;
  options.percent = 8;
  options.sigma_ratio = 0.125;
  options.certified = false;
  Bench bench = Bench::gallery("sphere", options);
  const RefinementOutcome outcome = bench.run();
  check_all(bench, outcome);
  CHECK(bench.insertions(Condition::containment) == 0);
  std::size_t low = 0;
  for (std::uint32_t i = 0; i < bench.complex().tets.size(); ++i) {
    const TetId t(i);
    if (!bench.complex().tet(t).alive() || !bench.complex().heterogeneous(t)) continue;
    const Height h = tetrahedron_height(bench.complex().positions(t), bench.complex().values(t));
    low += h.value < bench.criteria.height_limit() ? 1u : 0u;
  }
  CHECK(low == outcome.unmet_height);
  CHECK(outcome.unmet_height <= bench.exhausted(Condition::height));
}

TEST_CASE("sharp edges at small and at large tolerances") {
  for (const double percent : {1.5, 8.0}) {
    CAPTURE(percent);
    Bench bench(cube(), {.percent = percent, .sigma_ratio = 1});
    const RefinementOutcome outcome = bench.run();
    check_all(bench, outcome);
    CHECK(outcome.topology.euler_characteristic == 2);
  }
}

TEST_CASE("a hole that Ω closes is kept") {
  BenchOptions options;
  options.percent = 14;
  Bench bench = Bench::gallery("torus", options);
  const RefinementOutcome outcome = bench.run();
  CHECK(outcome.end == RefinementOutcome::End::finished);
  CHECK(outcome.topology.euler_characteristic == 0);
  CHECK(outcome.topology.as_expected);
  CHECK(outcome.contained);
}

TEST_CASE("mere separation leaves the topology alone") {
  BenchOptions options;
  options.topology = TopologyMode::separate;
  Bench bench = Bench::gallery("torus", options);
  check_all(bench, bench.run());
  CHECK(bench.insertions(Condition::topology) == 0);
}
