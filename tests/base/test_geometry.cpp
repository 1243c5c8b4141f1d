// Points, boxes and ids behave as arithmetic says.
#include "base/geometry.h"
#include "base/ids.h"
#include "base/status.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("cross and dot products follow the right-hand rule") {
  CHECK(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}) == Vec3{0, 0, 1});
  CHECK(dot(Vec3{1, 2, 3}, Vec3{4, 5, 6}) == 32);
  CHECK(length(Vec3{3, 4, 12}) == 13);
  CHECK(normalized(Vec3{}) == Vec3{});
}

TEST_CASE("a box grows with its points and knows its longest edge") {
  Box3 box;
  CHECK(box.empty());
  CHECK(box.longest_edge() == 0);
  box.add(Vec3{0, 0, 0});
  box.add(Vec3{1, 5, 2});
  CHECK(box.longest_edge() == 5);
  CHECK(box.center() == Vec3{0.5, 2.5, 1});
  CHECK(box.grown(1).longest_edge() == 7);
}

TEST_CASE("ids of one kind order, and default ones are invalid") {
  CHECK_FALSE(VertexId{}.valid());
  CHECK(VertexId(1) < VertexId(2));
}

TEST_CASE("results carry either a value or a full error line") {
  const Result<int> good = 3;
  CHECK(good.ok());
  CHECK(*good == 3);
  const Result<int> bad = Error{ErrorCode::bad_input, "a.off has no faces.", "Give a mesh."};
  CHECK_FALSE(bad.ok());
  CHECK(bad.error().line() == "a.off has no faces. Give a mesh.");
}
