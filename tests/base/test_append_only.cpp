// The append-only list: elements stay where they are, and readers see only finished ones.
#include "base/append_only.h"

#include <doctest/doctest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

using namespace isoscope;

TEST_CASE("An append-only list keeps its elements where they are while it grows") {
  AppendOnly<std::string> list;
  CHECK(list.empty());
  list.push_back("0");
  const std::string* first = &list[0];
  for (int i = 1; i < 5000; ++i) list.push_back(std::to_string(i));
  CHECK(list.size() == 5000);
  CHECK(first == &list[0]);
  CHECK(list.back() == "4999");
  // The blocks end at 1024, 3072 and 7168.
  for (const std::size_t i : {0, 1023, 1024, 1025, 3071, 3072, 3073, 4999}) {
    CHECK(list[i] == std::to_string(i));
  }
}

TEST_CASE("Readers of an append-only list see every element below its size complete") {
  constexpr std::size_t count = 50000;
  AppendOnly<std::vector<std::size_t>> list;
  std::atomic<bool> wrong{false};
  std::vector<std::thread> readers;
  for (int r = 0; r < 2; ++r) {
    readers.emplace_back([&] {
      std::size_t seen = 0;
      while (seen < count) {
        const std::size_t size = list.size();
        for (; seen < size; ++seen) {
          const auto& element = list[seen];
          if (element.size() != 2 || element[0] != seen || element[1] != seen * seen) wrong = true;
        }
        std::this_thread::yield();
      }
    });
  }
  for (std::size_t i = 0; i < count; ++i) list.push_back({i, i * i});
  for (std::thread& reader : readers) reader.join();
  CHECK(!wrong);
}
