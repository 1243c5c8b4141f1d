// Every kind of event has a short sentence for an audience.
#include "journal/describe.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

using namespace isoscope;

namespace {

struct Lecture {
  Journal journal;
  Lecture() {
    CriteriaParameters criteria;
    criteria.delta = 0.5;
    criteria.sigma = 0.25;
    journal.add_parameters(criteria);
  }
  std::string say(EventKind kind, Stage stage = Stage::refinement, bool operation = false, Step step = 0) {
    Event e;
    e.kind = kind;
    e.stage = stage;
    e.operation = operation;
    e.step = step;
    return plain_words(journal, e);
  }
};

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

} // namespace

TEST_CASE("an insertion is told with its number and what made it necessary") {
  Lecture l;
  Event e;
  e.kind = EventKind::insertion;
  e.condition = Condition::classification;
  e.operation = true;
  e.step = 36;
  e.value = 1.834;
  CHECK(plain_words(l.journal, e) == "refinement 37: the sample with the largest error, 1.83, goes in");
  e.condition = Condition::height;
  e.value = 0.1;
  CHECK(plain_words(l.journal, e) ==
        "refinement 37: a tetrahedron is too flat, 0.20 δ high: a point splits it");
  e.condition = Condition::containment;
  e.value = 0.6;
  CHECK(plain_words(l.journal, e) ==
        "refinement 37: Z may leave the tolerance, d = 1.20 δ: a point pulls it back");
}

TEST_CASE("every other kind has its words") {
  Lecture l;
  CHECK(l.say(EventKind::stage_begin, Stage::gamma) == "simplifying ∂Γ begins");
  CHECK(l.say(EventKind::stage_end, Stage::zero_set) == "simplifying Z is done");
  CHECK(l.say(EventKind::relabel, Stage::refinement, true, 4) == "refinement 5: 0 vertices change side");
  CHECK(l.say(EventKind::exhausted) == "refinement: no point is left to try here");
  CHECK(l.say(EventKind::parameter_change) == "refinement: the parameters change: α = 0.20, σ = 0.50 δ");
  CHECK(l.say(EventKind::warning) == "a warning");
  CHECK(l.say(EventKind::stopped, Stage::all) == "simplifying around Z is stopped");
  CHECK(l.say(EventKind::collapse, Stage::zero_set, true, 99) ==
        "simplifying Z 100: an edge collapses, one vertex less");
  CHECK(l.say(EventKind::tessellation, Stage::tessellation, true, 9) ==
        "tessellation 10: Z becomes part of the triangulation, with 0 vertices");
  CHECK(l.say(EventKind::departure, Stage::improve, true, 0) ==
        "improvement 1: Z leaves the triangulation and moves freely inside the tolerance");
  CHECK(l.say(EventKind::repair, Stage::improve, true, 1) ==
        "improvement 2: an edge collapses and its neighbours are moved back into the tolerance");
  Event e;
  e.kind = EventKind::topology_check;
  e.count = 1;
  e.value = -2;
  e.limit = 0;
  CHECK(plain_words(l.journal, e) == "refinement: Z has 1 component and χ = −2, but χ = 0 is expected");
  e.limit = -2;
  CHECK(plain_words(l.journal, e) == "refinement: Z has 1 component and χ = −2, as it should");
  e.limit = std::numeric_limits<double>::quiet_NaN();
  CHECK(plain_words(l.journal, e) == "refinement: Z has 1 component and χ = −2");
  e.kind = EventKind::relaxation;
  e.value = 0.45;
  CHECK(plain_words(l.journal, e) == "refinement: 1 vertex moves to better places, farthest d = 0.90 δ");
  e.kind = EventKind::warning;
  e.text = l.journal.add_text("The surface has a hole.");
  CHECK(plain_words(l.journal, e) == "The surface has a hole.");
}

TEST_CASE("every kind, condition and reason gives one line that fits a slide") {
  Lecture l;
  std::set<std::string> rejections;
  for (int kind = 0; kind < event_kind_count; ++kind)
    for (int stage = 0; stage < stage_count; ++stage)
      for (int condition = 0; condition < condition_count; ++condition)
        for (int reason = 0; reason < reason_count; ++reason) {
          Event e;
          e.kind = static_cast<EventKind>(kind);
          e.stage = static_cast<Stage>(stage);
          e.condition = static_cast<Condition>(condition);
          e.reason = static_cast<Reason>(reason);
          e.operation = true;
          e.step = 12344;
          const std::string text = plain_words(l.journal, e);
          CHECK(!text.empty());
          CHECK(characters(text) <= 100);
          CHECK(text.find('\n') == std::string::npos);
          if (e.kind == EventKind::rejection && e.stage == Stage::all && rejects(e.reason))
            rejections.insert(text);
        }
  CHECK(rejections.size() == rejecting_reasons.size());
}
