// Messages over the view: what is no error goes away by itself.
#include "model/window_state.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("what is told fades and is gone after its time, an error stays until it is closed") {
  Message told;
  told.since = 10;
  CHECK(told.strength(10) == 1);
  CHECK(told.strength(10 + Message::shown - Message::fade) == 1);
  const float fading = told.strength(10 + Message::shown - Message::fade / 2);
  CHECK(fading > 0.4f);
  CHECK(fading < 0.6f);
  CHECK(told.strength(10 + Message::shown) == 0);
  CHECK(told.strength(1000) == 0);
  told.error = true;
  CHECK(told.strength(1000) == 1);
}
