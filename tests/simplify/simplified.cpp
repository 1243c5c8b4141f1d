// Sets the simplification up as the pipeline does.
#include "simplify/simplified.h"

#include "mesh/validity.h"
#include "mesh/zero_set.h"
#include "tolerance/facet_certificate.h"

#include <doctest/doctest.h>

#include <map>

namespace isoscope::testing {

Simplified::Simplified(std::string_view model, const BenchOptions& options,
                       const SimplificationParameters& parameters)
    : bench(Bench::gallery(model, options)) {
  bench.run();
  simplification = std::make_unique<Simplification>(*bench.volume, bench.samples, bench.criteria, parameters,
                                                    *bench.recorder, *bench.control, bench.complex());
}

bool Simplified::run() {
  const Result<bool> done = simplification->run();
  REQUIRE(done.ok());
  return *done;
}

std::size_t Simplified::events(EventKind kind) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < bench.journal->events().size(); ++i)
    count += bench.journal->events()[i].kind == kind;
  return count;
}

void check_zero_set(const Simplified& s) {
  const ZeroSet z = extract_zero_set(s.complex());
  const TriangleMesh mesh = triangulate(z);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  bool inside = true;
  const double delta = s.bench.volume->thresholds().delta;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    const Triangle3 facet{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    inside = inside &&
             certify_facet(s.bench.volume->index(), facet, delta, delta).kind == FacetVerdict::Kind::inside;
  }
  if (s.bench.criteria.certified) CHECK(inside);
  bool closed = !edges.empty();
  for (const auto& [edge, count] : edges)
    closed = closed && count == 1 && edges.count({edge.second, edge.first}) == 1;
  CHECK(closed);
  CHECK(check_topology(z, s.bench.expected).as_expected);
  if (s.complex().form != ZeroForm::free) CHECK(check_complex(s.complex()).empty());
}

} // namespace isoscope::testing
