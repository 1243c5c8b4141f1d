// The play head's motion: pauses, speeds, the gentle automatic start, following a growing run.
#include "model/transport.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;

namespace {
constexpr double frame = 1.0 / 60;
}

TEST_CASE("a paused head stays, a playing one moves at its speed and stops at the end") {
  Transport t;
  t.jump(10);
  t.update(1, 100, false);
  CHECK(t.step() == 10);
  t.set_speed(8);
  t.play();
  for (int i = 0; i < 60; ++i) t.update(frame, 100, false);
  CHECK(t.step() >= 17);
  CHECK(t.step() <= 18);
  for (int i = 0; i < 6000; ++i) t.update(frame, 100, false);
  CHECK(t.step() == 100);
  CHECK(t.mode() == Transport::Mode::paused);
}

TEST_CASE("automatic speed tells any run in about ten seconds, slowly at first") {
  for (const Step steps : {20u, 800u, 100000u}) {
    CAPTURE(steps);
    Transport t;
    Step after_one = 0;
    int frames = 0;
    for (; frames < 60 * 30 && t.step() < steps; ++frames) {
      t.update(frame, steps, false);
      if (frames == 60) after_one = t.step();
    }
    CHECK(t.step() == steps);
    CHECK(frames > 60 * 7);
    CHECK(frames < 60 * 13);
    CHECK(after_one <= std::max<Step>(steps / 20, 3));
  }
}

TEST_CASE("a head at the end of a growing run follows it") {
  Transport t;
  t.set_speed(Transport::unlimited);
  t.jump(0);
  t.play();
  t.update(frame, 50, true);
  CHECK(t.step() == 50);
  CHECK(t.mode() == Transport::Mode::following);
  t.update(frame, 90, true);
  CHECK(t.step() == 90);
}

TEST_CASE("steps are clamped to what there is") {
  Transport t;
  t.step_by(-5, 10);
  CHECK(t.step() == 0);
  t.step_by(7, 10);
  t.step_by(7, 10);
  CHECK(t.step() == 10);
  t.update(frame, 4, false); // a shorter journal
  CHECK(t.step() == 4);
}

TEST_CASE("scripts follow at once") {
  Transport t;
  t.set_immediate(true);
  t.update(0, 1234, true);
  CHECK(t.step() == 1234);
}
