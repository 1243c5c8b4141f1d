// Lines of words.
#include "ui/word_wrap.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;

namespace {

/// Every letter as wide as any other.
float letters(std::string_view text) {
  return static_cast<float>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

} // namespace

TEST_CASE("lines end at blanks alone") {
  CHECK(broken_lines("one two three", 7, letters) == "one two\nthree");
  CHECK(broken_lines("one two three", 13, letters) == "one two three");
  CHECK(broken_lines("overlong word", 3, letters) == "overlong\nword");
  CHECK(broken_lines("one\n\ntwo three", 5, letters) == "one\n\ntwo\nthree");
  CHECK(broken_lines("", 5, letters).empty());
  // What ends a sentence elsewhere stands in a number here.
  CHECK(broken_lines("d is 1.0001, not 1", 9, letters) == "d is\n1.0001,\nnot 1");
}

TEST_CASE("a number keeps its unit") {
  CHECK(broken_lines("at most 1.0001 δ here", 14, letters) == "at most\n1.0001 δ here");
  CHECK(broken_lines("at most 1.0001 δ here", 16, letters) == "at most 1.0001 δ\nhere");
  CHECK(broken_lines("it is 0.6 %, fine", 9, letters) == "it is\n0.6 %,\nfine");
  CHECK(broken_lines("all 3 sides", 5, letters) == "all 3\nsides"); // no seconds
}
