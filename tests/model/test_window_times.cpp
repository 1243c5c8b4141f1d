// The window's own times: what is counted, and that a script can ask for it.
#include "model/window_times.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("a step counts from the moment it is asked for until a frame shows it") {
  WindowTimes times;
  times.stands_at(3, 0);
  times.frame(0, 1, Step{3}, 3);
  CHECK(times.frames().size() == 0); // not begun
  times.begin();
  times.stands_at(3, 1);
  times.frame(1, 1.5, Step{3}, 3);
  CHECK(times.pictures().size() == 0); // nothing was asked for
  times.stands_at(9, 2);
  times.frame(2, 2.25, Step{3}, 9);
  times.frame(2.25, 3, std::nullopt, 9);
  CHECK(times.pictures().size() == 0);
  times.frame(3, 4.5, Step{9}, 9);
  CHECK(times.pictures().size() == 1);
  CHECK(times.pictures().at(1) == 2.5);
  times.frame(5, 5.125, Step{9}, 9);
  CHECK(times.pictures().size() == 1);
  CHECK(times.frames().size() == 5);
  CHECK(times.frames().at(0.2) == 0.125);
  CHECK(times.frames().at(1) == 1.5);
  CHECK(times.table().find("step to picture") != std::string::npos);
  times.begin();
  CHECK(times.frames().size() == 0);
}

TEST_CASE("a script measures frames and steps of the window") {
  CHECK(run_window("times", "wait settled\n"
                            "expect frame.count == 0\n"
                            "times reset\n"
                            "seek 3\nwait settled\nseek 20\nwait settled\nstep\nwait settled\n"
                            "expect picture.count == 3 and frame.count >= 9\n"
                            "expect picture.median > 0 and picture.largest >= picture.median\n"
                            "expect frame.largest >= frame.95\n"
                            "times\n") == 0);
}
