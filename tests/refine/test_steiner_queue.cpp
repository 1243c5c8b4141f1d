// The modifiable priority queue against a sorted list.
#include "refine/steiner_queue.h"

#include <doctest/doctest.h>

#include <map>

using namespace isoscope;

TEST_CASE("ties go to the smallest slot") {
  SteinerQueue queue;
  for (const int slot : {5, 2, 9}) queue.set(TetId(slot), 1.5);
  CHECK(queue.top() == TetId(2));
  queue.erase(TetId(2));
  CHECK(queue.top() == TetId(5));
  queue.set(TetId(9), 2);
  CHECK(queue.top() == TetId(9));
  CHECK(queue.top_key() == 2);
  queue.set(TetId(9), 0);
  CHECK(queue.top() == TetId(5));
}

TEST_CASE("random changes keep the largest key on top") {
  SteinerQueue queue;
  std::map<std::uint32_t, double> keys;
  std::uint64_t state = 3;
  const auto random = [&](std::uint64_t n) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>((state >> 33) % n);
  };
  for (int i = 0; i < 5000; ++i) {
    const std::uint32_t slot = random(60);
    if (random(3) == 0) {
      queue.erase(TetId(slot));
      keys.erase(slot);
    } else {
      const double key = random(20);
      queue.set(TetId(slot), key);
      keys[slot] = key;
    }
    REQUIRE(queue.size() == keys.size());
    if (keys.empty()) continue;
    auto best = keys.begin();
    for (auto it = keys.begin(); it != keys.end(); ++it) {
      if (it->second > best->second) best = it;
    }
    CHECK(queue.top() == TetId(best->first));
    CHECK(queue.top_key() == best->second);
  }
}
