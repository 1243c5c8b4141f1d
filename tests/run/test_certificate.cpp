// The certificate holds for a good mesh, and finds each planted defect.
#include "run/certificate.h"

#include "input/gallery.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

using namespace isoscope;

namespace {

constexpr double relative_delta = 0.04;

/// The bundled sphere as input, its volume, and itself as a mesh within it.
struct Sphere {
  TriangleSoup soup;
  ToleranceVolume volume;
  ExpectedTopology expected;
  double delta;

  static ToleranceVolume build(const TriangleSoup& soup, double delta) {
    auto volume = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(soup), analyse_input(soup),
                                         {delta, 0.95}, RunControl());
    REQUIRE(volume.ok());
    return std::move(*volume);
  }
  static TriangleSoup model() {
    auto made = make_gallery_model("sphere");
    REQUIRE(made.ok());
    return std::move(*made);
  }
  Sphere()
      : soup(model()), volume(build(soup, relative_delta * soup.bounds().longest_edge())),
        expected(expected_topology(volume, TopologyMode::keep)),
        delta(relative_delta * soup.bounds().longest_edge()) {}
  TriangleMesh mesh() const { return {soup.points, soup.triangles}; }
  Vec3 center() const { return soup.bounds().center(); }
  Certificate judge(const TriangleMesh& m) const { return certify(m, volume, expected, RunControl()); }
};

const Sphere& sphere() {
  static const Sphere instance;
  return instance;
}

/// A second copy of the mesh's points and facets, moved by `place`.
template <class Place> void append_copy(TriangleMesh& m, const TriangleMesh& copy, Place&& place) {
  const auto offset = static_cast<std::uint32_t>(m.points.size());
  for (const Vec3 p : copy.points) m.points.push_back(place(p));
  for (const auto& t : copy.triangles) m.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

bool mentions(const Certificate& c, const std::string& part) {
  return std::any_of(c.failures.begin(), c.failures.end(),
                     [&](const std::string& f) { return f.find(part) != std::string::npos; });
}

} // namespace

TEST_CASE("A good mesh is certified, and its distance bound is proven") {
  const Certificate c = sphere().judge(sphere().mesh());
  CHECK(c.holds());
  CHECK(c.failures.empty());
  CHECK(c.components == 1);
  CHECK(c.euler_characteristic == 2);
  CHECK(c.max_distance <= sphere().delta);

  TriangleMesh grown = sphere().mesh();
  for (Vec3& p : grown.points) p += 0.5 * sphere().delta * normalized(p - sphere().center());
  const Certificate outer = sphere().judge(grown);
  CHECK(outer.holds());
  CHECK(outer.max_distance >= 0.49 * sphere().delta);
  CHECK(outer.max_distance <= sphere().delta);
}

TEST_CASE("Nothing is no certified mesh") {
  CHECK(!sphere().judge({}).holds());
}

TEST_CASE("A hole is found") {
  TriangleMesh m = sphere().mesh();
  m.triangles.pop_back();
  const Certificate c = sphere().judge(m);
  CHECK(!c.closed_manifold);
  CHECK(!c.holds());
  CHECK(mentions(c, "edge"));
}

TEST_CASE("A flipped facet is found") {
  TriangleMesh m = sphere().mesh();
  std::swap(m.triangles[7][0], m.triangles[7][1]);
  const Certificate c = sphere().judge(m);
  CHECK(!c.oriented);
  CHECK(!c.holds());
}

TEST_CASE("A facet that uses a vertex twice is found") {
  TriangleMesh m = sphere().mesh();
  m.triangles[3][1] = m.triangles[3][0];
  const Certificate c = sphere().judge(m);
  CHECK(!c.closed_manifold);
  CHECK(!c.holds());
}

TEST_CASE("Two fans at one vertex are no manifold") {
  TriangleMesh m = sphere().mesh();
  const TriangleMesh one = m;
  append_copy(m, one, [](Vec3 p) { return p + Vec3{0.1, 0, 0}; });
  const auto pinched = static_cast<std::uint32_t>(one.points.size());
  for (auto& t : m.triangles) {
    for (auto& v : t) {
      if (v == pinched) v = 0;
    }
  }
  const Certificate c = sphere().judge(m);
  CHECK(!c.closed_manifold);
  CHECK(mentions(c, "fan"));
}

TEST_CASE("A vertex outside of the volume is found, and how far it is") {
  TriangleMesh m = sphere().mesh();
  m.points[5] += 2 * sphere().delta * normalized(m.points[5] - sphere().center());
  const Certificate c = sphere().judge(m);
  CHECK(c.closed_manifold);
  CHECK(!c.within_tolerance);
  CHECK(c.max_distance > sphere().delta);
  CHECK(mentions(c, "tolerance volume"));
}

TEST_CASE("A mesh turned inside out does not separate the sides") {
  TriangleMesh m = sphere().mesh();
  for (auto& t : m.triangles) std::swap(t[0], t[1]);
  const Certificate c = sphere().judge(m);
  CHECK(c.oriented);
  CHECK(c.within_tolerance);
  CHECK(!c.separates);
  CHECK(!c.holds());
}

TEST_CASE("Two layers wind twice around the inside, intersect or not") {
  TriangleMesh nested = sphere().mesh();
  append_copy(nested, sphere().mesh(),
              [](Vec3 p) { return p + 0.5 * sphere().delta * normalized(p - sphere().center()); });
  const Certificate c = sphere().judge(nested);
  CHECK(c.intersection_free);
  CHECK(!c.separates);
  CHECK(!c.topology_as_expected());
  CHECK(c.components == 2);
  CHECK(c.euler_characteristic == 4);

  TriangleMesh shifted = sphere().mesh();
  append_copy(shifted, sphere().mesh(), [](Vec3 p) { return p + Vec3{0.3 * sphere().delta, 0, 0}; });
  const Certificate crossing = sphere().judge(shifted);
  CHECK(!crossing.intersection_free);
  CHECK(mentions(crossing, "intersect"));
}

TEST_CASE("A degenerate facet is a failure") {
  TriangleMesh m = sphere().mesh();
  m.points[m.triangles[0][1]] = m.points[m.triangles[0][0]];
  const Certificate c = sphere().judge(m);
  CHECK(c.closed_manifold);
  CHECK(!c.intersection_free);
  CHECK(!c.holds());
}

TEST_CASE("An expectation that is not met is a failure, one that is absent is not") {
  ExpectedTopology expected = sphere().expected;
  expected.euler_characteristic = 0;
  const Certificate wrong = certify(sphere().mesh(), sphere().volume, expected, RunControl());
  CHECK(wrong.topology == Certificate::Topology::wrong);
  CHECK(mentions(wrong, "The Euler characteristic is 2 instead of 0"));
  expected.required = false;
  const Certificate missed = certify(sphere().mesh(), sphere().volume, expected, RunControl());
  CHECK(!missed.topology_as_expected());
  CHECK(missed.topology == Certificate::Topology::missed);
  CHECK(missed.topology_note.find("was aimed at") != std::string::npos);
  CHECK(missed.holds());
  expected.required = true;
  expected.euler_characteristic.reset();
  expected.components.reset();
  const Certificate not_asked = certify(sphere().mesh(), sphere().volume, expected, RunControl());
  CHECK(not_asked.topology == Certificate::Topology::not_asked);
  CHECK(not_asked.topology_note.find("any topology will do") != std::string::npos);
  CHECK(not_asked.holds());
}

TEST_CASE("A cancelled control does not keep a mesh from being judged, an abandoned one does") {
  RunControl control;
  control.cancel();
  CHECK(certify(sphere().mesh(), sphere().volume, sphere().expected, control).holds());
  control.abandon();
  CHECK(!certify(sphere().mesh(), sphere().volume, sphere().expected, control).holds());
}

TEST_CASE("An empty mesh is not certified, and that is said at once") {
  const Certificate c = sphere().judge({});
  CHECK_FALSE(c.holds());
  CHECK(mentions(c, "The mesh is empty."));
}
