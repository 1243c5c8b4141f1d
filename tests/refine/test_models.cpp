// Real models: handles, thin walls and narrow tunnels come out right.
#include "refine/bench.h"

#include "input/mesh_io.h"
#include "support/models.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

struct Model {
  std::string name;
  double percent;
  long euler;
};

} // namespace

TEST_CASE("real models end certified with the input's topology") {
  for (const Model& m :
       {Model{"elephant.off", 1, -4}, Model{"turbine.off", 1.5, -20}, Model{"rotor.off", 1, 0},
        Model{"anchor.off", 1.5, -6}, Model{"knot1.off", 1.5, 0}, Model{"femur.off", 1, -2}}) {
    const auto path = demo_model(m.name);
    if (!path) continue;
    CAPTURE(m.name);
    const auto soup = read_mesh(*path);
    REQUIRE(soup.ok());
    Bench bench(*soup, {.percent = m.percent});
    const RefinementOutcome outcome = bench.run();
    check_all(bench, outcome);
    CHECK(outcome.topology.euler_characteristic == m.euler);
    CHECK(outcome.topology.components == 1);
  }
}
