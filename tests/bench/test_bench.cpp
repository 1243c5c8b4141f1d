// The bench's parts: Lindstrom–Turk stays within δ of a sphere, peers are measured, the icosphere is one,
// lines and sums are right.
#include "bench/cases.h"
#include "bench/lindstrom_turk.h"
#include "bench/measure.h"
#include "bench/peer.h"
#include "bench/table.h"
#include "bench/targets.h"

#include "tolerance/border_gate.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/tolerance_volume.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include <unistd.h>

using namespace isoscope;
using namespace isoscope::bench;

namespace {

std::size_t facets_outside(const TriangleMesh& mesh, const TriangleSoup& input, double delta) {
  const ClosestPointIndex index(input);
  std::size_t outside = 0;
  for (const auto& t : mesh.triangles) {
    const FacetVerdict v =
        certify_facet(index, {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, delta, delta);
    outside += v.kind == FacetVerdict::Kind::inside ? 0u : 1u;
  }
  return outside;
}

Row row(std::size_t ours, std::size_t theirs, bool certified) {
  Row r;
  r.asked.model = "m" + std::to_string(ours);
  r.asked.tolerance = {0.6, true};
  r.ours.outcome = {certified, ours, certified ? "certified" : "NOT certified: it is not."};
  r.lindstrom_turk.outcome = {true, theirs, ""};
  return r;
}

} // namespace

TEST_CASE("The icosphere is a closed surface on the unit sphere, seen from outside") {
  for (const unsigned levels : {0u, 1u, 3u}) {
    const TriangleSoup sphere = icosphere(levels);
    CHECK(sphere.points.size() == 10 * (1u << (2 * levels)) + 2);
    CHECK(sphere.triangles.size() == 20 * (1u << (2 * levels)));
    const InputTopology topology = analyse_input(sphere);
    CHECK(topology.closed_manifold);
    CHECK(topology.consistently_oriented);
    CHECK(topology.euler_characteristic == 2);
    double volume = 0;
    for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
      const Triangle3 t = sphere.triangle(i);
      volume += dot(t[0], cross(t[1], t[2])) / 6;
      CHECK(length(t[0]) == doctest::Approx(1));
    }
    CHECK(volume > 2.5);
    CHECK(volume < 4.19);
  }
}

TEST_CASE("Lindstrom–Turk under the certificate is coarse, closed and within δ of a sphere") {
  const TriangleSoup sphere = icosphere(4);
  std::size_t before = sphere.points.size();
  for (const double delta : {0.02, 0.05, 0.1}) {
    CAPTURE(delta);
    const auto result = lindstrom_turk(sphere, delta, CollapseFilter::certificate);
    REQUIRE(result.ok());
    const TriangleMesh& mesh = result->mesh;
    CHECK(facets_outside(mesh, sphere, delta) == 0);
    CHECK(!result->intersects_itself);
    const InputTopology topology = analyse_input({mesh.points, mesh.triangles, {}});
    CHECK(topology.closed_manifold);
    CHECK(topology.euler_characteristic == 2);
    CHECK(mesh.points.size() < before);
    // Greedy collapses end at about 2.3 times the optimum.
    CHECK(static_cast<double>(mesh.points.size()) < 3 * sphere_optimum(1, delta));
    CHECK(static_cast<double>(mesh.points.size()) > sphere_optimum(1, delta));
    before = mesh.points.size();
  }
}

TEST_CASE("The envelope is the stricter filter, an input's order and copies of its points do not matter") {
  const TriangleSoup sphere = icosphere(2);
  const double delta = 0.1;
  const auto certified = lindstrom_turk(sphere, delta, CollapseFilter::certificate);
  const auto enveloped = lindstrom_turk(sphere, delta, CollapseFilter::envelope);
  REQUIRE(certified.ok());
  REQUIRE(enveloped.ok());
  CHECK(facets_outside(enveloped->mesh, sphere, delta) == 0);
  CHECK(enveloped->mesh.points.size() >= certified->mesh.points.size());
  CHECK(enveloped->mesh.points.size() < sphere.points.size());

  TriangleSoup loose;
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
    for (const Vec3 p : sphere.triangle(i)) loose.points.push_back(p);
    const auto base = static_cast<std::uint32_t>(3 * i);
    loose.triangles.push_back({base, base + (i % 2 == 0 ? 1 : 2), base + (i % 2 == 0 ? 2 : 1)});
  }
  const auto merged = lindstrom_turk(loose, delta, CollapseFilter::certificate);
  REQUIRE(merged.ok());
  CHECK(facets_outside(merged->mesh, sphere, delta) == 0);

  TriangleSoup fin = sphere;
  fin.points.push_back({0, 0, 2});
  fin.triangles.push_back(
      {fin.triangles[0][0], fin.triangles[0][1], static_cast<std::uint32_t>(fin.points.size() - 1)});
  const auto refused = lindstrom_turk(fin, delta, CollapseFilter::certificate);
  REQUIRE(!refused.ok());
  CHECK(refused.error().code == ErrorCode::unsupported);
}

TEST_CASE("An open surface keeps its border within δ of the input's, both ways") {
  TriangleSoup half = icosphere(3);
  std::erase_if(half.triangles, [&](const auto& t) {
    return half.points[t[0]].z < 0 || half.points[t[1]].z < 0 || half.points[t[2]].z < 0;
  });
  const double delta = 0.05;
  const auto result = lindstrom_turk(half, delta, CollapseFilter::certificate);
  REQUIRE(result.ok());
  const TriangleMesh& mesh = result->mesh;
  CHECK(facets_outside(mesh, half, delta) == 0);
  CHECK(mesh.points.size() * 4 < half.points.size());
  const auto border_of = [](const std::vector<Vec3>& points, const auto& triangles) {
    std::vector<Segment3> border;
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto from = t[k], to = t[(k + 1) % 3];
        const bool inner = std::any_of(triangles.begin(), triangles.end(), [&](const auto& o) {
          return (o[0] == to && o[1] == from) || (o[1] == to && o[2] == from) || (o[2] == to && o[0] == from);
        });
        if (!inner) border.push_back({points[from], points[to]});
      }
    return border;
  };
  const std::vector<Segment3> rim = border_of(half.points, half.triangles),
                              border = border_of(mesh.points, mesh.triangles);
  CHECK(border.size() * 2 < rim.size());
  for (const Segment3& edge : border) CHECK(BorderGate(rim, delta).keeps_to_rim(edge).proven);
  for (const Segment3& edge : rim) CHECK(BorderGate(border, delta).keeps_to_rim(edge).proven);
}

TEST_CASE("Without a bound the collapse ends at the number of vertices that was asked for") {
  const TriangleSoup sphere = icosphere(3);
  for (const std::size_t vertices : {300u, 50u}) {
    const auto result = lindstrom_turk_to(sphere, vertices);
    REQUIRE(result.ok());
    CHECK(result->mesh.points.size() == vertices);
  }
  const auto untouched = lindstrom_turk_to(sphere, 10000);
  REQUIRE(untouched.ok());
  CHECK(untouched->mesh.points.size() == sphere.points.size());
}

TEST_CASE("Peers are asked by name and measured both ways") {
  const TriangleSoup sphere = icosphere(3);
  const Tolerance delta{0.1, false};
  CHECK(!peer_of("nobody"));
  for (const std::string& name : peer_names()) {
    CAPTURE(name);
    Asked asked{*peer_of(name), delta, {}};
    if (asked.peer == Peer::lindstrom_turk) {
      CHECK(ask_peer(sphere, asked).error().code == ErrorCode::usage);
      asked = {asked.peer, {}, 60};
    }
    const auto result = ask_peer(sphere, asked);
    if (!result.ok()) {
      // A peer that was not built in says what is missing.
      CHECK(result.error().code == ErrorCode::unsupported);
      CHECK(!result.error().remedy.empty());
      CHECK((asked.peer == Peer::meshoptimizer || asked.peer == Peer::alpha_wrap));
      continue;
    }
    CHECK(result->mesh.points.size() > 8);
    CHECK(result->longest_edge == doctest::Approx(sphere.bounds().longest_edge()));
    CHECK(result->output_distance.lower <= result->output_distance.upper);
    CHECK(result->output_distance.upper < 3 * delta.value);
    CHECK(result->input_distance.upper < 3 * delta.value);
    if (asked.peer == Peer::certificate || asked.peer == Peer::envelope)
      CHECK(result->output_distance.lower <= delta.value);
    CHECK(!result->intersects_itself);
    const std::string line = json_line(*result);
    CHECK(line.find("\"vertices\":" + std::to_string(result->mesh.points.size())) != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
  CHECK(ask_peer(sphere, {Peer::certificate, {}, {}}).error().code == ErrorCode::usage);
  CHECK(ask_peer(sphere, {Peer::certificate, Tolerance{0, false, true}, {}}).error().code ==
        ErrorCode::usage);
}

TEST_CASE("Work in a process of its own is measured, whatever becomes of it") {
  const Measured good = measure([] { return Outcome{true, 42, "all is well, in some words"}; }, 0);
  CHECK(good.outcome.good);
  CHECK(good.outcome.vertices == 42);
  CHECK(good.outcome.status == "all is well, in some words");
  CHECK(good.peak_bytes > 0);
  CHECK(good.seconds > 0);
  const Measured thrown = measure([]() -> Outcome { throw std::runtime_error("no luck"); }, 0);
  CHECK(!thrown.outcome.good);
  CHECK(thrown.outcome.status == "no luck");
  const Measured crashed = measure(
      []() -> Outcome {
        std::signal(SIGTERM, SIG_DFL);
        std::raise(SIGTERM);
        return {};
      },
      0);
  CHECK(!crashed.outcome.good);
  CHECK(crashed.outcome.status == "crashed by signal " + std::to_string(SIGTERM));
  const Measured endless = measure(
      []() -> Outcome {
        for (;;) pause();
      },
      0.05);
  CHECK(!endless.outcome.good);
  CHECK(endless.outcome.status == "took too long");
}

TEST_CASE("Ratios are of results that count, sums and the worst line too") {
  CHECK(*row(65, 100, true).ratio() == doctest::Approx(0.65));
  CHECK(!row(65, 100, false).ratio());
  const std::vector<Row> rows{row(60, 100, true), row(45, 50, true), row(10, 100, false)};
  const Table text(false), markdown(true);
  CHECK(text.summary(rows) ==
        "\n3 lines, 1 of ours not certified; 105 vertices for 150 of Lindstrom–Turk on 2 lines: "
        "0.700 in total, at worst 0.900 (m45 0.6%).\n");
  const std::string head = markdown.head(), line = markdown.line(rows[0]);
  const auto bars = [](const std::string& s) { return std::count(s.begin(), s.end(), '|'); };
  CHECK(bars(head) == 2 * bars(line));
  CHECK(line.starts_with("| m60 | 0.6% | 60 | 100 | 0.600 |"));
  CHECK(text.line(rows[2]).find("NOT certified") != std::string::npos);
  Row limited = rows[0];
  limited.asked.at_most = 59;
  CHECK(text.line(limited).find("ABOVE THE LIMIT") != std::string::npos);
}

TEST_CASE("Selections grow, and the sphere knows its optimum") {
  const auto quick = target_cases(Selection::quick), standard = target_cases(Selection::standard),
             complete = target_cases(Selection::complete);
  CHECK(!quick.empty());
  CHECK(quick.size() < standard.size());
  CHECK(standard.size() <= complete.size());
  CHECK(*standard.back().optimum == doctest::Approx(2 + 1.209 / 0.04));
  CHECK(*standard.back().at_most == 48);
  const auto cases = model_cases("gallery:torus", {{1, true}, {0.5, false}});
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].load().ok());
}

TEST_CASE("The median is the middle, or the mean of the two in the middle") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  CHECK(median({7}) == 7);
}

TEST_CASE("An input is nudged by less than δ, the same way for the same seed, and by nothing for seed 0") {
  const TriangleSoup sphere = icosphere(1);
  const double delta = 0.1;
  CHECK(nudged(sphere, delta, 0).points == sphere.points);
  const TriangleSoup once = nudged(sphere, delta, 1), again = nudged(sphere, delta, 1);
  CHECK(once.points == again.points);
  CHECK(once.points != nudged(sphere, delta, 2).points);
  for (std::size_t i = 0; i < sphere.points.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(once.points[i][axis] - sphere.points[i][axis] >= 0);
      CHECK(once.points[i][axis] - sphere.points[i][axis] < delta);
    }
}

TEST_CASE("Targets are told as mean, least and largest over the seeds") {
  const auto measured = [](const char* model, std::uint32_t seed, std::size_t ours, double cpu) {
    Row r = row(ours, 100, true);
    r.asked.model = model;
    r.asked.tolerance = {1, true};
    r.seed = seed;
    r.ours.cpu_seconds = cpu;
    r.lindstrom_turk.cpu_seconds = 0.5;
    return r;
  };
  std::vector<Row> rows{measured("elephant", 0, 60, 5), measured("elephant", 1, 64, 6),
                        measured("cow", 0, 70, 9), measured("cow", 1, 66, 10)};
  CHECK(*rows[0].cpu_ratio() == doctest::Approx(10));
  CHECK(Table(true).line(rows[0]).starts_with("| elephant | 1% |"));
  CHECK(Table(true).line(rows[1]).starts_with("| elephant #1 | 1% |"));
  CHECK(target_table(rows, true) ==
        "| target | now | certified | floor | goal |\n| --- | --: | --: | --: | --: |\n"
        "| vertices / LT, all of free-form models at 1 % | 0.650 (0.650 to 0.650) | 4 of 4 | 0.54 | 0.5 |\n"
        "| CPU / LT, median of eight models at 1 % | 15.0 (14.0 to 16.0) | 4 of 4 | 15 | 8 |\n"
        "| CPU / CPU at less δ, worst of free-form | - | 4 of 4 | 1 | 0.8 |\n");
  rows[1].ours.outcome.good = false;
  CHECK(target_table(rows, true).find("models at 1 % | 0.655 (0.650 to 0.660) | 3 of 4 |") !=
        std::string::npos);
  for (const Case& c : cases_of_targets(false)) {
    CAPTURE(c.model);
    CHECK(c.load().ok());
  }
  CHECK(cases_of_targets(true).size() >= cases_of_targets(false).size());
}

TEST_CASE("Targets of small tolerances, of two threads and of all models are of their rows alone") {
  const auto measured = [](const char* model, double percent, double cpu) {
    Row r = row(60, 100, true);
    r.asked.model = model;
    r.asked.tolerance = {percent, true};
    r.ours.cpu_seconds = cpu;
    r.ours.outcome.improving = 3;
    r.lindstrom_turk.cpu_seconds = 2;
    return r;
  };
  std::vector<Row> rows{measured("elephant", 0.4, 30), measured("elephant", 0.8, 24),
                        measured("elephant", 1, 36), measured("armadillo", 0.1, 250)};
  rows[0].envelope = rows[0].ours;
  rows[0].envelope->cpu_seconds = 20;
  rows[1].on_two = rows[1].ours;
  rows[1].on_two->outcome.improving = 2;
  CHECK(rows[1].speed_up() == 1.5);
  CHECK(!rows[0].speed_up());
  CHECK(rows[0].envelope_cpu_ratio() == 1.5);
  // One that cannot shrink does not count among all.
  for (const std::size_t i : {2u, 3u}) rows[i].asked.of_all = true;
  rows[2].lindstrom_turk.outcome.given = 500;
  rows.push_back(measured("cube", 1, 1));
  rows.back().asked.of_all = true;
  rows.back().lindstrom_turk.outcome.given = 100;
  const std::string table = target_table(rows, true);
  const auto says = [&](const char* words) { return table.find(words) != std::string::npos; };
  CAPTURE(table);
  CHECK(says("all of closed models at 1 % | 0.600 | 1 of 1 | 0.62 | 0.58 |"));
  CHECK(says("CPU / LT, median of free-form at .4, .8 % | 13.5 | 2 of 2 | 10 | 5 |"));
  CHECK(says("CPU / envelope, median of free-form to 1 % | 1.5 | 1 of 1 | 1 | 0.5 |"));
  CHECK(says("improver, times faster on 2 threads | 1.50 | 1 of 1 | 1.7 | 1.9 |"));
  CHECK(says("CPU / CPU at less δ, worst of free-form | 1.50 | 3 of 3 | 1 | 0.8 |"));
  CHECK(says("CPU seconds, armadillo at .1 % | 250.0 | 1 of 1 | 200 | 100 |"));
}

TEST_CASE("What work says comes back whole") {
  const Measured all = measure([] { return Outcome{true, 5, "fine", 42, 1.5}; }, 0);
  CHECK(all.outcome.given == 42);
  CHECK(all.outcome.improving == 1.5);
  CHECK(all.outcome.status == "fine");
}
