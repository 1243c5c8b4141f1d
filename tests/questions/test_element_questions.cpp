// One tetrahedron with known height, shrunk copy and samples; parameters at which verdicts change.
#include "questions/element_questions.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

/// A tetrahedron of height `height` over the plane z = 0, where F = −1; samples as given.
StateSnapshot one_tet(double height, const std::vector<Vec3>& positions,
                      const std::vector<std::int8_t>& labels) {
  StateSnapshot s;
  const auto vertex = [&](Vec3 p, double value) {
    Vertex v;
    v.position = p;
    v.value = value;
    s.complex.vertices.push_back(v);
  };
  vertex({0, 0, 0}, -1);
  vertex({3, 0, 0}, -1);
  vertex({0, 3, 0}, -1);
  vertex({0, 0, height}, 1);
  Tet t;
  t.v = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  s.complex.tets = {t};
  s.tet_flags = {tet_alive | tet_heterogeneous};
  s.heights = {static_cast<float>(height)};
  s.criteria.delta = 1;
  s.criteria.sigma = 0.25;
  s.criteria.alpha = 0.2; // 2σ/α = 2.5
  s.criteria.shrink = 0.7;
  auto samples = std::make_shared<BoundarySamples>();
  samples->positions = positions;
  samples->labels = labels;
  const AffineFunction f = interpolate(s.complex.positions(TetId(0)), s.complex.values(TetId(0)));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    s.errors.push_back(static_cast<float>(sample_error(f(positions[i]), labels[i])));
    s.sample_tets.push_back(TetId(0));
  }
  s.samples = samples;
  return s;
}

const ParameterAdvice* find(const std::vector<ParameterAdvice>& all, ParameterAdvice::Parameter parameter,
                            Condition condition) {
  for (const ParameterAdvice& a : all)
    if (a.parameter == parameter && a.condition == condition) return &a;
  return nullptr;
}

} // namespace

TEST_CASE("the height lies between the apex and its plane, and flat tetrahedra are listed") {
  const StateSnapshot s = one_tet(2, {}, {});
  const auto x = inspect_tet(s, TetId(0), 0.5, nullptr);
  REQUIRE(x);
  CHECK(x->height.value == doctest::Approx(2));
  CHECK(x->gap[0] == Vec3{0, 0, 2});
  CHECK(length(x->gap[1]) < 1e-12);
  CHECK(x->shrunk[1] == Vec3{0.75 + 0.5 * (3 - 0.75), 0.375, 0.25});
  CHECK(!x->orientation);
  CHECK(flat_tets(s, s.criteria.height_limit()).size() == 1);
  CHECK(flat_tets(s, 1.9).empty());
  CHECK(!inspect_tet(s, TetId(5), 0.5, nullptr));
}

TEST_CASE("two lines carry the height of a tetrahedron split 2-2") {
  StateSnapshot s = one_tet(2, {}, {});
  const std::array<Vec3, 4> p{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 3}, {0, 1, 3}}};
  for (std::size_t i = 0; i < 4; ++i) {
    s.complex.vertices[i].position = p[i];
    s.complex.vertices[i].value = i < 2 ? 1 : -1;
  }
  const auto x = inspect_tet(s, TetId(0), 1, nullptr);
  REQUIRE(x);
  CHECK(x->height.value == doctest::Approx(3));
  CHECK(distance(x->gap[0], x->gap[1]) == doctest::Approx(3));
  CHECK(length(x->gap[0] - Vec3{0, 0, 0}) < 1e-12);
}

TEST_CASE("the smallest change of alpha and sigma that satisfies condition 2 is told") {
  const StateSnapshot s = one_tet(2, {}, {});
  const auto advice = advise_tet(s, TetId(0), nullptr);
  const auto* alpha = find(advice, ParameterAdvice::Parameter::alpha, Condition::height);
  const auto* sigma = find(advice, ParameterAdvice::Parameter::sigma, Condition::height);
  REQUIRE(alpha);
  REQUIRE(sigma);
  CHECK(!alpha->holds);
  CHECK(*alpha->works == doctest::Approx(0.25)); // 2σ/h
  CHECK(alpha->at_least);
  CHECK(*sigma->works == doctest::Approx(0.2)); // αh/2
  const StateSnapshot high = one_tet(3, {}, {});
  CHECK(
      find(advise_tet(high, TetId(0), nullptr), ParameterAdvice::Parameter::alpha, Condition::height)->holds);
  // Below 2σ no α < 1 is enough.
  const StateSnapshot low = one_tet(0.4, {}, {});
  CHECK(
      !find(advise_tet(low, TetId(0), nullptr), ParameterAdvice::Parameter::alpha, Condition::height)->works);
}

TEST_CASE("the factor below which a tetrahedron is oriented well separates good from bad") {
  // f = z − 1. A positive sample on the wrong side, beyond corner 1, is asked only while the copy's corner is
  // nearer to it than to the positive sample above the centroid.
  const StateSnapshot s = one_tet(2, {{3.3, -0.2, 0.4}, {0.75, 0.75, 1.4}}, {1, 1});
  const NearestSample nearest(s.samples->positions, s.samples->labels);
  const auto advice = advise_tet(s, TetId(0), &nearest);
  const auto* shrink = find(advice, ParameterAdvice::Parameter::shrink, Condition::orientation);
  REQUIRE(shrink);
  CHECK(!shrink->holds);
  REQUIRE(shrink->works);
  CHECK(*shrink->works < 0.7);
  const auto misoriented = [&](double factor) {
    return inspect_tet(s, TetId(0), factor, &nearest)->orientation->misoriented;
  };
  CHECK(!misoriented(*shrink->works));
  CHECK(misoriented(*shrink->works + 0.001));
}

TEST_CASE("a sample is mended by the worst one of its tetrahedron") {
  // f = z − 1; labels + at z = 0.5 (ε 1.5), + at z = 1.1 (ε 0.9), + at z = 1.9 (ε 0.1).
  const StateSnapshot s = one_tet(2, {{0.2, 0.2, 0.5}, {0.1, 0.1, 1.1}, {0.02, 0.02, 1.9}}, {1, 1, 1});
  using Remedy = SampleInspection::Remedy;
  const auto worst = inspect_sample(s, SampleId(0)), second = inspect_sample(s, SampleId(1)),
             good = inspect_sample(s, SampleId(2));
  REQUIRE((worst && second && good));
  CHECK(worst->bad);
  CHECK(worst->remedy == Remedy::itself_next);
  CHECK(worst->f == doctest::Approx(-0.5));
  CHECK(!second->bad);
  CHECK(second->remedy == Remedy::worse_in_tet);
  CHECK(second->fixer == SampleId(0));
  CHECK(second->worse_in_tet == 1);
  CHECK(good->remedy == Remedy::none_needed);
  CHECK(!inspect_sample(s, SampleId(9)));
  CHECK(!advise_sample(s, SampleId(0))[0].works);
  CHECK(*advise_sample(s, SampleId(1))[0].works == doctest::Approx(0.1));
  CHECK(advise_sample(s, SampleId(2))[0].holds);
}

TEST_CASE("before T is there no sample is judged") {
  StateSnapshot s = one_tet(2, {{0.2, 0.2, 0.5}}, {1});
  s.complex.tets.clear();
  s.tet_flags.clear();
  s.heights.clear();
  s.errors = {0};
  s.sample_tets = {TetId()};
  CHECK(!inspect_sample(s, SampleId(0)));
  CHECK(advise_sample(s, SampleId(0)).empty());
}
