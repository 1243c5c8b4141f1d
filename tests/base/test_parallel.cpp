// Parallel loops visit every index once, on any number of threads.
#include "base/parallel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace isoscope;

TEST_CASE("parallel_for visits every index exactly once on 1, 2 and 7 threads") {
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{100003}}) {
      std::vector<int> visits(n, 0);
      parallel_for(n, 64, [&](std::size_t i) { ++visits[i]; });
      CHECK(std::accumulate(visits.begin(), visits.end(), 0) == static_cast<int>(n));
      CHECK(std::all_of(visits.begin(), visits.end(), [](int v) { return v == 1; }));
    }
  }
}
