// Which events of a journal written by hand pass.
#include "query/hand_made_events.h"
#include "query/search.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;

namespace {

using Events = std::vector<std::uint32_t>;

std::shared_ptr<const Expression> read(const std::string& text) {
  const ParsedQuery parsed = parse_query(text);
  if (const auto* error = std::get_if<QueryError>(&parsed)) FAIL(error->picture(text));
  return std::get<std::shared_ptr<const Expression>>(parsed);
}

Events passing(const std::string& text) {
  const auto journal = test::hand_made_events();
  const auto expression = read(text);
  JournalWatch watch(journal, expression->needs());
  return matches(*expression, *journal, 0, static_cast<std::uint32_t>(complete_events(*journal)), &watch);
}

} // namespace

TEST_CASE("conditions over the events of a short journal") {
  const std::vector<std::pair<std::string, Events>> cases{
      {"", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},
      {"all", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},
      {"reject", {5, 6, 8}},
      {"!reject && stage == zero_set", {4, 7, 9}},
      {"reject && reason == kernel_empty", {5, 8}},
      {"reason == kernel", {5, 8}},
      {"reason != kernel_empty && reject", {6}},
      {"insertion", {1, 2}},
      {"height", {1}},
      {"condition == height", {1}},
      {"height < 2*sigma/alpha && insertion", {1}}, // 0.5 · 2 < 5 but 3 · 2 > 5
      {"height < 2", {1}},
      {"bad_samples == 0", {2, 3, 4, 5, 6, 7, 8, 9}}, // unknown before the first operation
      {"bad_samples != 0", {1}},
      {"vertices < 40", {1, 7, 8, 9}},
      {"took >= 3", {2}},
      {"took < 1", {7}},
      {"took > 0", {1, 2, 7}},
      {"value > limit", {2, 5, 6, 8}},
      {"value - limit == 1", {5, 6, 8}},
      {"ratio == 2", {5, 6, 8}},
      {"-value > -0.2 && kind == collapse", {7}},
      {"step == 2", {3, 4, 5, 6, 7}},
      {"step / 2 == 1 && !reject", {3, 4, 7}},
      {"vertex(3)", {5, 6, 8}},
      {"edge(3,9)", {5, 8}},
      {"edge(9,3) && step == 3", {8}},
      {"vertex == 9", {2, 8}},
      {"sample(42)", {2}},
      {"tet(5)", {1, 2}},
      {"tet == 5 && sample == 41", {1}},
      {"near(1,0,0.5,1)", {1}},
      {"near(0,4,0,0.5) || near(1,0,0,0)", {1, 2}},
      {"edge near (0,0,0) 100", {}}, // no vertex of this journal has a place
      {"\"kernel\"", {5, 8}},
      {"alpha == 0.2 && sigma == 0.5 && delta == 2 && shrink == 0.7 && insertion", {1, 2}},
      {"1/0 > 0 && reject", {5, 6, 8}},
      {"0/0 == 0/0 || 0/0 != 0/0 || 0/0 < 1", {}},
      {"genus == 0 || genus != 0", {}}, // no Z
      {"stall(1)", {5, 6, 8}},
      {"stall(2)", {6}},
      {"reject || insertion && height", {1, 5, 6, 8}},
      {"+reject +(kernel normals) -halfedge", {5, 6, 8}},
      {"+reject -kernel", {6}},
      {"-reject -insertion", {0, 3, 4, 7, 9}},
      {"zero-set kernel-empty normals", {5, 6, 8}},
      {"zero-set halfedge", {7}},
      {"insertion rejection zero-set", {5, 6, 8}},
      {"tess zero-set", {}},
  };
  for (const auto& [text, expected] : cases) {
    CAPTURE(text);
    CHECK(passing(text) == expected);
  }
}

TEST_CASE("every stage, kind, condition and reason can be asked for by its name") {
  const auto passes = [](const std::string& text, const Event& event) {
    Journal journal;
    journal.add_event(event);
    return holds(*read(text), journal, 0, nullptr);
  };
  Event e;
  for (int k = 0; k < event_kind_count; ++k) {
    e = {};
    e.kind = static_cast<EventKind>(k);
    // The stage of that name holds the kind of that name.
    e.stage = e.kind == EventKind::tessellation ? Stage::tessellation : Stage::all;
    CAPTURE(name(e.kind));
    CHECK(passes(std::string(name(e.kind)), e));
    CHECK(!passes("!" + std::string(name(e.kind)), e));
  }
  for (int r = 1; r < reason_count; ++r) {
    e = {};
    e.reason = static_cast<Reason>(r);
    CHECK(passes(std::string(name(e.reason)), e));
    e.reason = static_cast<Reason>(r == 1 ? 2 : 1);
    CHECK(!passes(std::string(name(static_cast<Reason>(r))), e));
  }
  for (int c = 1; c < condition_count; ++c) {
    e = {};
    e.condition = static_cast<Condition>(c);
    CHECK(passes("condition == " + std::string(name(e.condition)), e));
    CHECK(!passes("condition == none", e));
  }
  for (int s = 0; s < stage_count; ++s) {
    e = {};
    e.stage = static_cast<Stage>(s);
    CHECK(passes("stage == " + std::string(name(e.stage)), e));
  }
}

TEST_CASE("what the screen calls a thing is a name of it") {
  const auto passes = [](const std::string& text, const Event& event) {
    Journal journal;
    journal.add_event(event);
    return holds(*read(text), journal, 0, nullptr);
  };
  const auto asked = [&](const auto& row, auto Event::*member, const char* sort) {
    Event e, other;
    e.*member = row.value;
    other.*member = static_cast<decltype(row.value)>(row.value == decltype(row.value){} ? 1 : 0);
    const std::string title(row.title);
    for (const std::string& text :
         {std::string(sort) + " == " + title, std::string(sort) + " == \"" + title + "\""}) {
      CAPTURE(text);
      CHECK(passes(text, e));
      CHECK(!passes(text, other));
    }
  };
  for (const StageWords& row : stage_table) asked(row, &Event::stage, "stage");
  for (const KindWords& row : kind_table) asked(row, &Event::kind, "kind");
  for (const ConditionWords& row : condition_table) asked(row, &Event::condition, "condition");
  for (const ReasonWords& row : reason_table) asked(row, &Event::reason, "reason");
  Event e;
  e.kind = EventKind::rejection;
  e.reason = Reason::outside_tolerance;
  for (const char* text : {"outside Ω", "\"outside Ω\"", "reason == outside_Ω", "reject outside Ω",
                           "+reject +(link in T outside Ω)", "rejections && reason == Outside Ω"}) {
    CAPTURE(text);
    CHECK(passes(text, e));
  }
  CHECK(!passes("outside the kernel", e));
  CHECK(!passes("reject -(outside Ω)", e));
}

TEST_CASE("the next and the previous match") {
  const auto journal = test::hand_made_events();
  const RunControl control;
  const auto look = [&](std::vector<std::string> texts, std::int64_t from, Direction direction) {
    QuerySearch search;
    for (const std::string& text : texts) search.expressions.push_back(read(text));
    search.from = from;
    search.direction = direction;
    return find(journal, search, control);
  };
  CHECK(look({"reject"}, -1, Direction::forward)->event == 5);
  CHECK(look({"reject"}, 5, Direction::forward)->event == 6);
  CHECK(look({"reject"}, 6, Direction::forward)->event == 8);
  CHECK(!look({"reject"}, 8, Direction::forward));
  CHECK(look({"reject"}, 8, Direction::backward)->event == 6);
  CHECK(!look({"reject"}, 5, Direction::backward));
  CHECK(look({"reject"}, 1000, Direction::backward)->event == 8);
  const auto two = look({"collapse", "insertion"}, 1, Direction::forward);
  CHECK(two->event == 2);
  CHECK(two->expression == 1);
  // What follows the journal finds the same both ways.
  CHECK(look({"stall(2)"}, -1, Direction::forward)->event == 6);
  CHECK(look({"stall(2)"}, 9, Direction::backward)->event == 6);
  CHECK(!look({"stall(2)"}, 6, Direction::backward));
  RunControl cancelled;
  cancelled.cancel();
  QuerySearch search;
  search.expressions = {read("reject")};
  CHECK(!find(journal, search, cancelled));
}
