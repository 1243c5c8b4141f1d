// Real models: regions, labels and Euler characteristics at usual tolerances.
#include "input/mesh_io.h"
#include "support/models.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

struct Model {
  const char* name;
  double percent;
  long euler;
};

/// Points just beyond the reject distance, where labels are hardest.
std::size_t wrong_labels(ToleranceVolume& v, int samples) {
  Random random(11);
  const ToleranceThresholds t = v.thresholds();
  std::size_t wrong = 0;
  for (int i = 0; i < samples; ++i) {
    const Triangle3& face = v.index().triangle(TriangleId(random.below(v.index().size())));
    const Vec3 center = (face[0] + face[1] + face[2]) / 3.0;
    const Vec3 p = center + random.between(1, 2) * t.reject * random.direction();
    if (v.index().distance(p) <= t.reject) continue;
    wrong += v.label_at(p) != (v.index().inside_by_parity(p) ? -1 : +1) ? 1u : 0u;
  }
  return wrong;
}

} // namespace

TEST_CASE("closed models have the known topology and labels that agree with parity") {
  for (const Model m : {Model{"elephant.off", 1, -4}, Model{"anchor.off", 1.5, -6}, Model{"rotor.off", 1, 0},
                        Model{"turbine.off", 1.5, -20}, Model{"cheese.off", 2.5, -264}}) {
    const auto path = demo_model(m.name);
    if (!path) continue;
    CAPTURE(m.name);
    const auto soup = read_mesh(*path);
    REQUIRE(soup.ok());
    const InputTopology topology = analyse_input(*soup);
    CHECK(topology.closed_manifold);
    CHECK(topology.self_intersection_free);
    CHECK(topology.euler_characteristic == m.euler);
    CHECK(topology.components == 1);
    const auto index = std::make_shared<const ClosestPointIndex>(*soup);
    const double delta = m.percent / 100 * index->bounds().longest_edge();
    auto v = ToleranceVolume::build(index, topology, {delta, 0.95}, RunControl());
    REQUIRE(v.ok());
    CHECK(v->regions()[0].label == +1);
    CHECK(v->volume_component_count() == 1);
    for (const Region& r : v->regions())
      CHECK(r.label == (!r.unbounded && index->inside_by_parity(r.deepest) ? -1 : +1));
    CHECK(wrong_labels(*v, 2000) == 0);
  }
}

TEST_CASE("the volume of elephant at a small tolerance is a thickening") {
  const auto path = demo_model("elephant.off");
  if (!path) return;
  const auto soup = read_mesh(*path);
  REQUIRE(soup.ok());
  const auto index = std::make_shared<const ClosestPointIndex>(*soup);
  auto v = ToleranceVolume::build(index, analyse_input(*soup), {0.004 * index->bounds().longest_edge(), 0.95},
                                  RunControl());
  REQUIRE(v.ok());
  REQUIRE(v->boundary_components().size() == 2);
  CHECK(v->boundary_components()[0].euler_characteristic == -4);
  CHECK(v->boundary_components()[1].euler_characteristic == -4);
  CHECK(v->thickening());
}

TEST_CASE("open models are told from others") {
  for (const std::string name : {"blade.off", "lion-head.off", "blobby_3cc.off"}) {
    const auto path = demo_model(name);
    if (!path) continue;
    CAPTURE(name);
    const auto soup = read_mesh(*path);
    REQUIRE(soup.ok());
    const auto index = std::make_shared<const ClosestPointIndex>(*soup);
    const auto v = ToleranceVolume::build(index, analyse_input(*soup),
                                          {0.006 * index->bounds().longest_edge(), 0.95}, RunControl());
    REQUIRE(v.ok());
    REQUIRE(v->open_sides() != nullptr);
    CHECK_FALSE(v->open_sides()->rim().loops().empty());
  }
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {

/// A memory figure of this process in bytes, by its name in the kernel's status file.
double status_bytes(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return 0;
}

} // namespace

TEST_CASE("sampling needs at most 200 bytes a sample") {
  const auto path = demo_model("elephant.off");
  if (!path) return;
  const auto soup = read_mesh(*path);
  REQUIRE(soup.ok());
  const auto index = std::make_shared<const ClosestPointIndex>(*soup);
  const double delta = 0.01 * index->bounds().longest_edge();
  auto v = ToleranceVolume::build(index, analyse_input(*soup), {delta, 0.95}, RunControl());
  REQUIRE(v.ok());
  std::ofstream("/proc/self/clear_refs") << "5"; // the peak starts anew
  const double before = status_bytes("VmHWM");
  const auto samples = sample_boundary(*v, delta / 2, RunControl());
  REQUIRE(samples.ok());
  CHECK(samples->size() > 100000);
  const double per_sample = (status_bytes("VmHWM") - before) / static_cast<double>(samples->size());
  CHECK(per_sample <= 200);
}
#endif
