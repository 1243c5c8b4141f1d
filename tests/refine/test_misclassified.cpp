// What edges and facets of T tell is the same, whether it is remembered or asked anew.
#include "refine/bench.h"

#include "refine/loose_box.h"
#include "refine/misclassified_points.h"

#include <doctest/doctest.h>

#include <random>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

template <std::size_t N> class Both {
 public:
  /// How many points both name, which have to be the same in the same order.
  std::size_t compare(const LiveTriangulation& live, const ToleranceVolume& volume) {
    const RunControl control;
    const auto known = remembering_.find(live, volume, control);
    const auto fresh = MisclassifiedSearch<N>().find(live, volume, control);
    REQUIRE(known.size() == fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      REQUIRE(known[i].point == fresh[i].point);
      REQUIRE(known[i].label == fresh[i].label);
      REQUIRE(known[i].summit == fresh[i].summit);
      REQUIRE(live.alive(known[i].tet));
    }
    return fresh.size();
  }

 private:
  MisclassifiedSearch<N> remembering_;
};

} // namespace

TEST_CASE("searches for misclassified points that remember T find what new ones find") {
  Bench bench = Bench::gallery("torus", {});
  const ToleranceVolume& volume = *bench.volume;
  LiveTriangulation live(bench.samples);
  live.start(loose_box_corners(volume, *bench.samples));
  Both<2> edges;
  Both<3> facets;
  std::size_t found = 0;
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> sample(0, bench.samples->size() - 1);
  for (int i = 0; i < 160; ++i) {
    const std::size_t s = sample(random);
    Vertex vertex;
    vertex.position = bench.samples->positions[s];
    vertex.value = bench.samples->labels[s];
    live.insert(vertex, {});
    if (i % 8 != 0) continue;
    found += edges.compare(live, volume) + facets.compare(live, volume);
    const std::vector<VertexId> turned{VertexId(static_cast<std::uint32_t>(8 + i / 8))};
    if (i % 16 == 0 && turned.front().index() < live.complex().vertices.size()) live.relabel(turned);
  }
  CHECK(found > 100);
}
