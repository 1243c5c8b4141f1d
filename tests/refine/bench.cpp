// Builds Ω and S of a soup and hands them to a refinement.
#include "refine/bench.h"

#include "criteria/height.h"
#include "input/gallery.h"
#include "journal/playback.h"
#include "mesh/validity.h"
#include "tolerance/facet_certificate.h"

#include <doctest/doctest.h>

namespace isoscope::testing {

Bench::Bench(const TriangleSoup& soup, const BenchOptions& options) {
  auto index = std::make_shared<const ClosestPointIndex>(soup);
  const double delta = options.percent / 100 * index->bounds().longest_edge();
  ToleranceVolume::Options shape{delta, options.certified ? 0.95 : 1.0};
  auto built = ToleranceVolume::build(index, analyse_input(soup), shape, *control);
  REQUIRE_MESSAGE(built.ok(), built.error().line());
  volume = std::make_unique<ToleranceVolume>(std::move(*built));
  auto sampled = sample_boundary(*volume, options.sigma_ratio * delta, *control);
  REQUIRE(sampled.ok());
  samples = std::make_shared<const BoundarySamples>(std::move(*sampled));
  criteria.delta = delta;
  criteria.sigma = options.sigma_ratio * delta;
  criteria.certified = options.certified;
  options.adjust(criteria);
  gate->wanted = criteria;
  recorder = std::make_unique<Recorder>(*journal, *gate);
  expected = expected_topology(*volume, options.topology);
  refinement =
      std::make_unique<Refinement>(*volume, samples, criteria, expected, options.limits, *recorder, *control);
}

Bench Bench::gallery(std::string_view model, const BenchOptions& options) {
  const auto soup = make_gallery_model(model);
  REQUIRE(soup.ok());
  return Bench(*soup, options);
}

std::size_t Bench::count_errors_above(double limit) const {
  SampleSets sets(samples->positions);
  sets.assign_all(complex());
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < samples->size(); ++i) {
    const TetId t = sets.tet_of(SampleId(i));
    count += sample_error_at(complex(), t, samples->positions[i], samples->labels[i]) > limit ? 1u : 0u;
  }
  return count;
}

std::size_t Bench::insertions(Condition condition) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < journal->operations().size(); ++i) {
    const Event& event = journal->events()[journal->operations()[i].event];
    count += event.kind == EventKind::insertion && event.condition == condition ? 1u : 0u;
  }
  return count;
}

std::size_t Bench::exhausted(Condition condition) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < journal->events().size(); ++i) {
    const Event& event = journal->events()[i];
    count += event.kind == EventKind::exhausted && event.condition == condition ? 1u : 0u;
  }
  return count;
}

namespace {

void check_figures(const Bench& bench, const ZeroSet& zero_set) {
  const StepFigures& figures = bench.journal->operations().back().figures;
  CHECK(figures.zero_set_vertices == zero_set.vertices.size());
  CHECK(figures.tets == bench.complex().alive_tets());
  CHECK(figures.bad_samples == bench.count_errors_above(std::nextafter(1.0, 0.0)));
  double smallest = Box3::inf;
  for (const ZeroSet::Polygon& polygon : zero_set.polygons) {
    const Complex& complex = bench.complex();
    const Height h = tetrahedron_height(complex.positions(polygon.tet), complex.values(polygon.tet),
                                        complex.labels(polygon.tet));
    smallest = std::min(smallest, h.value);
  }
  CHECK(figures.smallest_height == doctest::Approx(smallest / bench.criteria.delta));
}

void check_facets_inside(const Bench& bench, const TriangleMesh& mesh) {
  std::size_t outside = 0;
  const double delta = bench.criteria.delta;
  for (const auto& t : mesh.triangles) {
    const Triangle3 facet{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    const FacetVerdict verdict = certify_facet(bench.volume->index(), facet, delta, delta);
    outside += verdict.kind == FacetVerdict::Kind::inside ? 0u : 1u;
  }
  CHECK(outside == 0);
}

} // namespace

void check_all(Bench& bench, const RefinementOutcome& outcome) {
  CHECK(outcome.end == RefinementOutcome::End::finished);
  CHECK(outcome.classified);
  CHECK(outcome.witnessed);
  CHECK(outcome.topology.as_expected);
  CHECK(check_complex(bench.complex()).empty());
  CHECK(check_delaunay(bench.complex()).empty());
  CHECK(bench.count_errors_above(bench.criteria.error_limit()) == 0);
  const ZeroSet zero_set = extract_zero_set(bench.complex());
  check_figures(bench, zero_set);
  if (!bench.criteria.certified) return;
  CHECK(outcome.contained);
  CHECK(outcome.uncertified == 0);
  check_facets_inside(bench, triangulate(zero_set));
}

} // namespace isoscope::testing
