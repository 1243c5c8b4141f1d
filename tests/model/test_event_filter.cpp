// Choosing events by stage, kind, condition and reason.
#include "model/event_filter.h"

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

TEST_CASE("an event passes when all of its four may") {
  EventFilter filter;
  filter.stages.reset().set(static_cast<std::size_t>(Stage::zero_set));
  filter.reasons.reset().set(static_cast<std::size_t>(Reason::kernel_empty));
  CHECK(!filter.everything());
  CHECK(filter.passes(event_of(EventKind::rejection, Stage::zero_set, Reason::kernel_empty)));
  CHECK(!filter.passes(event_of(EventKind::rejection, Stage::all, Reason::kernel_empty)));
  CHECK(!filter.passes(event_of(EventKind::rejection, Stage::zero_set, Reason::normals)));
}
