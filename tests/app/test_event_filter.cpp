// Filtering the events: by stage, kind, condition and reason, by the names that scripts use.
#include "app/event_filter.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

Event event_of(EventKind kind, Stage stage, Reason reason = Reason::none) {
  Event e;
  e.kind = kind;
  e.stage = stage;
  e.reason = reason;
  return e;
}

} // namespace

TEST_CASE("everything passes until something is asked for") {
  EventFilter filter;
  CHECK(filter.everything());
  for (int k = 0; k < event_kind_count; ++k)
    CHECK(filter.passes(event_of(static_cast<EventKind>(k), Stage::zero_set, Reason::kernel_empty)));
}

TEST_CASE("names of one sort add up, of different sorts narrow") {
  EventFilter filter;
  REQUIRE(filter.narrow("kernel-empty"));
  REQUIRE(filter.narrow("outside-tolerance"));
  const Event empty = event_of(EventKind::rejection, Stage::zero_set, Reason::kernel_empty);
  const Event outside = event_of(EventKind::rejection, Stage::all, Reason::outside_tolerance);
  const Event normals = event_of(EventKind::rejection, Stage::all, Reason::normals);
  CHECK(filter.passes(empty));
  CHECK(filter.passes(outside));
  CHECK(!filter.passes(normals));
  REQUIRE(filter.narrow("all-edges") == false);
  REQUIRE(filter.narrow("zero-set"));
  CHECK(filter.passes(empty));
  CHECK(!filter.passes(outside));
  REQUIRE(filter.narrow("all"));
  CHECK(filter.everything());
}

TEST_CASE("every stage, kind, condition and reason can be asked for by its name") {
  for (int k = 0; k < event_kind_count; ++k) {
    EventFilter filter;
    const auto kind = static_cast<EventKind>(k);
    CAPTURE(name(kind));
    REQUIRE(filter.narrow(std::string(name(kind))));
    CHECK(filter.passes(event_of(kind, kind == EventKind::tessellation ? Stage::tessellation : Stage::all)));
  }
  for (int r = 1; r < reason_count; ++r) {
    EventFilter filter;
    REQUIRE(filter.narrow(std::string(name(static_cast<Reason>(r)))));
    CHECK(filter.passes(event_of(EventKind::rejection, Stage::all, static_cast<Reason>(r))));
    CHECK(!filter.passes(event_of(EventKind::rejection, Stage::all, static_cast<Reason>(r == 1 ? 2 : 1))));
  }
  EventFilter filter;
  CHECK(!filter.narrow("no such thing"));
  CHECK(!filter.narrow("none"));
}
