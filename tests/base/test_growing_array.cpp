// The list that grows in place: what is in it stays, and a list that was moved is empty.
#include "base/growing_array.h"

#include <doctest/doctest.h>

#include <utility>

using namespace isoscope;

TEST_CASE("A growing array keeps its values while it grows and when it is moved") {
  GrowingArray<std::size_t> list;
  CHECK(list.size() == 0);
  list.reserve(100);
  for (std::size_t i = 0; i < 100000; ++i) list.push_back(3 * i);
  CHECK(list.size() == 100000);
  list.push_back(list[5]); // out of its own, while there may be no room
  list[7] = 1;
  GrowingArray<std::size_t> other = std::move(list);
  CHECK(other.size() == 100001);
  CHECK(other[99999] == 299997);
  CHECK(other[100000] == 15);
  CHECK(other[7] == 1);
  GrowingArray<std::size_t> third;
  third.push_back(4);
  third = std::move(other);
  CHECK(third.size() == 100001);
  CHECK(third[1] == 3);
}
