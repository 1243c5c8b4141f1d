// One bar over the parts of a preparation, and the time that is left.
#include "model/preparation_progress.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("the share only grows, and the time that is left follows from the time so far") {
  PreparationProgress progress;
  CHECK(progress.share() == 0);
  CHECK(progress.words() == "input");
  progress.report("input", -1, 0.2);
  CHECK_FALSE(progress.seconds_left().has_value());
  progress.report("regions", 0.5, 2);
  const double regions = progress.share();
  CHECK(regions > 0);
  REQUIRE(progress.seconds_left().has_value());
  CHECK(*progress.seconds_left() == doctest::Approx(2 * (1 - regions) / regions));
  progress.report("sampling", 0, 3);
  const double sampling = progress.share();
  CHECK(sampling > regions);
  progress.report("regions", 0, 4); // another tolerance is tried
  CHECK(progress.share() == sampling);
  progress.report("what nobody knows", 0.5, 5);
  CHECK(progress.share() == sampling);
  progress.report("sampling", 1, 6);
  CHECK(progress.share() == 1);
  CHECK(*progress.seconds_left() == 0);
  progress.begin();
  CHECK(progress.share() == 0);
}

TEST_CASE("parts that only points have count where there are points") {
  PreparationProgress mesh, points;
  mesh.report("regions", 0, 1);
  points.report("neighbours", -1, 1);
  points.report("tolerances", -1, 2);
  points.report("regions", 0, 3);
  CHECK(points.share() > mesh.share());
  points.report("sampling", 1, 4);
  CHECK(points.share() == 1);
}

TEST_CASE("seconds and minutes are told") {
  PreparationProgress progress;
  progress.report("sampling", 1, 75);
  CHECK(progress.words() == "sampling \u00b7 1 min 15 s, about 1 s left");
  progress.report("sampling", 1, 120);
  CHECK(progress.words() == "sampling \u00b7 2 min, about 1 s left");
}
