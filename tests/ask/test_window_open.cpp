// Sessions over open surfaces and rooms: rim, boundary samples, the cut, holes kept and filled, rooms told
// apart, strata and link conditions.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace isoscope::test;

namespace {

std::string picture(const std::string& name) {
  return (std::filesystem::path(ISOSCOPE_RESULTS) / (name + ".png")).string();
}

} // namespace

TEST_CASE("an open surface: B, the rim, the cut, an edge of the border, and a hole that is filled") {
  CHECK(run_window("open",
                   R"(
wait settled
expect phase == finished and certified == on and euler == 1
expect holes == 1 and holes.kept == 1 and holes.filled == 0 and rooms == 0
expect samples.over_rim > 100
seek 0
wait settled
expect holes.kept == 0 and curves.border == 0 and curves.dropped == 0
pick over-rim 7
wait answers
expect selection == over-rim and rim.over == on and rim.hole == 1 and rim.distance > 0.9 and rim.distance < 1
screenshot )" + picture("open-sample") +
                       R"(
pick sample 0
wait answers
expect selection == sample and rim.over == off and rim.distance > 0.95
clear
stage rim
wait settled
expect curves.border == 0
stage zero-set
wait settled
expect curves.border > 10 and curves.points == 0 and curves.dropped > 10 and holes.kept == 1
set layer.dropped on
frame-all
screenshot )" + picture("open-cut") +
                       R"(
section
wait settled
screenshot )" + picture("open-section") +
                       R"(
scene
next-event border-distance
wait answers
expect stratum.edge == curve and stratum.border == on and stratum.a == curve and stratum.b == curve
expect stratum.link_t == holds and stratum.link_sheets == holds and stratum.link_curves == holds
screenshot )" + picture("open-edge") +
                       R"(
clear
end
filter split
wait settled
expect loop.lanes == 1 and loop.events > events.listed and events.listed > 0
lane loop-1
wait settled
expect lane == loop-1 and events.listed == loop.events
lane-event loop-1 0
expect event.kind == split
lane loop-1
expect lane == none
end
holes
look-at-hole 1
hole 1 fill
expect fill == all
hole 1 keep
expect fill == none
hole all flat
expect fill == flat
screenshot )" + picture("open-holes") +
                       R"(
restart
wait settled
expect phase == finished and certified == on and euler == 2 and holes.filled == 1 and holes.kept == 0
expect curves.border == 0
quit
)",
                   "gallery:hemisphere --until all --size 1440x900") == 0);
}

TEST_CASE("rooms: told apart by colour and hatch, strata of edges, the point where four meet") {
  CHECK(run_window("rooms",
                   R"(
wait settled
expect phase == finished and certified == on and euler == 3 and rooms == 2
expect curves.triple > 3 and curves.points == 0 and curves.border == 0 and holes == 0
seek 0
step 60
section
wait settled
screenshot )" + picture("rooms-refining") +
                       R"(
stage zero-set
wait settled
screenshot )" + picture("rooms-section") +
                       R"(
scene
set layer.samples off
set layer.outer off
set layer.inner off
set layer.tets off
wait settled
expect curves.triple > 8
screenshot )" + picture("rooms-scene") +
                       R"(
next-event zero-link-condition
wait answers
expect stratum.sides >= 2 and xray.zero-link == failed and stratum.link_t == holds
screenshot )" + picture("rooms-edge") +
                       R"(
quit
)",
                   "gallery:two-rooms --size 1440x900") == 0);
  CHECK(run_window("bubbles",
                   R"(
wait settled
expect rooms == 4 and curves.points >= 1 and curves.triple > 20
set layer.samples off
set layer.outer off
set layer.inner off
set layer.tets off
clip-next
wait settled
screenshot )" + picture("bubbles") +
                       R"(
section
set layer.tets on
wait settled
screenshot )" + picture("bubbles-section") +
                       R"(
quit
)",
                   "gallery:bubbles --tolerance 8% --until tessellation --size 1440x900") == 0);
}
