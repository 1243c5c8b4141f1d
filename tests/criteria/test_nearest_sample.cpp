// Nearest samples against a search through all of them, ties and bounds included.
#include "criteria/nearest_sample.h"

#include "base/parallel.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;

namespace {

std::uint32_t brute_force(const std::vector<Vec3>& positions, const std::vector<std::int8_t>& labels, Vec3 p,
                          int label) {
  std::uint32_t best = SampleId::none;
  double distance = Box3::inf;
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (label != 0 && labels[i] != label) continue;
    const double d = squared_length(positions[i] - p);
    if (d >= distance) continue;
    distance = d;
    best = i;
  }
  return best;
}

/// Points on a lattice, so that ties are many.
std::vector<Vec3> lattice(std::size_t n) {
  std::vector<Vec3> points;
  std::uint64_t state = 7;
  for (std::size_t i = 0; i < n; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    points.push_back({static_cast<double>((state >> 33) % 16), static_cast<double>((state >> 40) % 16),
                      static_cast<double>((state >> 47) % 16)});
  }
  return points;
}

} // namespace

TEST_CASE("the nearest sample is the one of smallest id among the nearest, on any number of threads") {
  for (const std::size_t n : {1u, 12u, 13u, 500u, 4000u}) {
    const std::vector<Vec3> positions = lattice(n);
    std::vector<std::int8_t> labels;
    for (std::size_t i = 0; i < n; ++i) labels.push_back(i % 3 == 0 ? -1 : +1);
    for (const unsigned threads : {1u, 3u}) {
      const ThreadLimit limit(threads);
      const NearestSample index(positions, labels);
      for (int k = 0; k < 200; ++k) {
        const Vec3 p{std::fmod(k * 1.37, 18) - 1, std::fmod(k * 0.5, 17), std::fmod(k * 2.11, 40) - 12};
        CHECK(index.nearest(p).value == brute_force(positions, labels, p, 0));
        CHECK(index.nearest_of(p, +1).value == brute_force(positions, labels, p, +1));
        CHECK(index.nearest_of(p, -1).value == brute_force(positions, labels, p, -1));
      }
    }
  }
}

TEST_CASE("a bounded search finds what lies within the radius only") {
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 0, 0}};
  const std::vector<std::int8_t> labels{1, -1};
  const NearestSample index(positions, labels);
  CHECK(index.nearest({2, 0, 0}, 1.5) == SampleId(1));
  CHECK(index.nearest({2, 0, 0}, 1.0) == SampleId(1));
  CHECK_FALSE(index.nearest({2, 0, 0}, 0.5).valid());
  CHECK(index.has_near({2, 0, 0}, -1, 1.0));
  CHECK_FALSE(index.has_near({2, 0, 0}, -1, 0.5));
  CHECK(index.has_near({2, 0, 0}, +1, 2.0));
  CHECK_FALSE(index.has_near({2, 0, 0}, +1, 1.5));
}

TEST_CASE("samples far from the origin are told apart though floats could not") {
  const Vec3 off{1e6, -2e6, 3e6};
  std::vector<Vec3> positions = lattice(600);
  for (Vec3& p : positions) p = off + (1. / 1024) * p;
  const std::vector<std::int8_t> labels(positions.size(), 1);
  const NearestSample index(positions, labels);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p = off + (1. / 1024) * Vec3{std::fmod(k * 1.37, 18), std::fmod(k * 0.5, 17), k * 0.06};
    CHECK(index.nearest(p).value == brute_force(positions, labels, p, 0));
    CHECK(index.has_near(p, +1, 1) == (length(positions[index.nearest(p).index()] - p) <= 1));
  }
}

TEST_CASE("a side without samples has no nearest one") {
  const std::vector<Vec3> positions{{0, 0, 0}};
  const std::vector<std::int8_t> labels{1};
  const NearestSample index(positions, labels);
  CHECK(index.has(+1));
  CHECK_FALSE(index.has(-1));
  CHECK_FALSE(index.nearest_of({}, -1).valid());
  CHECK_FALSE(index.has_near({}, -1, 1));
  CHECK_FALSE(NearestSample({}, {}).nearest({}).valid());
}
