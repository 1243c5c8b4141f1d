// States by slot and their counts.
#include "refine/checklist.h"

#include <doctest/doctest.h>

using namespace isoscope;
using State = Checklist::State;

TEST_CASE("pending slots come ascending and once, until they are judged") {
  Checklist list;
  for (const int slot : {7, 3, 7, 1}) list.add(TetId(slot));
  CHECK(list.pending() == std::vector<TetId>{TetId(1), TetId(3), TetId(7)});
  list.set(TetId(3), State::good);
  list.forget(TetId(1));
  CHECK(list.pending() == std::vector<TetId>{TetId(7)});
  list.add(TetId(3));
  CHECK(list.pending() == std::vector<TetId>{TetId(3), TetId(7)});
}

TEST_CASE("violations are counted and leave with their slots") {
  Checklist list;
  CHECK_FALSE(list.first_violated().valid());
  list.set(TetId(4), State::violated);
  list.set(TetId(2), State::violated);
  list.set(TetId(9), State::exhausted);
  list.set(TetId(5), State::undecided);
  CHECK(list.first_violated() == TetId(2));
  CHECK(list.violated() == 2);
  CHECK(list.exhausted() == 1);
  CHECK(list.undecided() == 1);
  list.set(TetId(2), State::exhausted);
  CHECK(list.first_violated() == TetId(4));
  CHECK(list.exhausted() == 2);
  list.forget(TetId(9));
  CHECK(list.exhausted() == 1);
  list.clear();
  CHECK(list.exhausted() + list.violated() + list.undecided() == 0);
  CHECK(list.state(TetId(4)) == State::absent);
}
