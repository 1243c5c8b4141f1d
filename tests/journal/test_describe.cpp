// Every event has a sentence with its numbers and the paper's symbols.
#include "journal/describe.h"

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <string>

using namespace isoscope;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Journal& journal_with_delta() {
  static Journal journal;
  if (journal.parameters().empty()) {
    CriteriaParameters criteria;
    criteria.delta = 0.5;
    criteria.sigma = 0.25;
    journal.add_parameters(criteria);
  }
  return journal;
}

} // namespace

TEST_CASE("Every kind, condition and reason has a name of its own") {
  std::set<std::string_view> kinds, conditions, reasons, stages;
  for (int i = 0; i <= static_cast<int>(EventKind::stopped); ++i)
    kinds.insert(name(static_cast<EventKind>(i)));
  for (int i = 0; i < condition_count; ++i) conditions.insert(name(static_cast<Condition>(i)));
  for (int i = 0; i < reason_count; ++i) reasons.insert(name(static_cast<Reason>(i)));
  for (int i = 0; i <= static_cast<int>(Stage::improve); ++i) stages.insert(name(static_cast<Stage>(i)));
  CHECK(kinds.size() == 9);
  CHECK(conditions.size() == condition_count);
  CHECK(reasons.size() == reason_count);
  CHECK(stages.size() == 7);
  CHECK(!kinds.contains(""));
  CHECK(!conditions.contains(""));
  CHECK(!reasons.contains(""));
}

TEST_CASE("Every combination of kind, condition and reason has a sentence") {
  Journal& journal = journal_with_delta();
  for (int kind = 0; kind <= static_cast<int>(EventKind::stopped); ++kind) {
    for (int condition = 0; condition < condition_count; ++condition) {
      for (int reason = 0; reason < reason_count; ++reason) {
        Event e;
        e.kind = static_cast<EventKind>(kind);
        e.condition = static_cast<Condition>(condition);
        e.reason = static_cast<Reason>(reason);
        const std::string text = describe(journal, e);
        CHECK(!text.empty());
        CHECK(!contains(text, "  "));
        CHECK(!contains(text, "4294967295"));
      }
    }
  }
}

TEST_CASE("Insertions tell the violation beside its limit") {
  Journal& journal = journal_with_delta();
  Event e;
  e.kind = EventKind::insertion;
  e.operation = true;
  e.step = 36;
  e.condition = Condition::classification;
  e.sample = SampleId(412);
  e.value = 1.83;
  e.limit = 0.8;
  const std::string first = describe(journal, e);
  CHECK(contains(first, "37"));
  CHECK(contains(first, "condition 1"));
  CHECK(contains(first, "412"));
  CHECK(contains(first, "ε = 1.83"));
  CHECK(contains(first, "0.80"));

  e.condition = Condition::height;
  e.tet = TetId(9);
  e.value = 0.25;
  e.limit = 1.0;
  const std::string second = describe(journal, e);
  CHECK(contains(second, "condition 2"));
  CHECK(contains(second, "tetrahedron 9"));
  CHECK(contains(second, "0.500 δ"));
  CHECK(contains(second, "2.000 δ"));

  e.condition = Condition::orientation;
  CHECK(contains(describe(journal, e), "condition 3"));
  e.condition = Condition::containment;
  CHECK(contains(describe(journal, e), "d = 0.500 δ"));
}

TEST_CASE("Topology checks and non-finite numbers read well") {
  Journal& journal = journal_with_delta();
  Event e;
  e.kind = EventKind::topology_check;
  e.value = -6;
  e.limit = -4;
  e.count = 1;
  CHECK(contains(describe(journal, e), "χ = −6"));
  CHECK(contains(describe(journal, e), "1 component,"));
  CHECK(contains(describe(journal, e), "χ = −4"));
  e.limit = std::numeric_limits<double>::quiet_NaN();
  CHECK(!contains(describe(journal, e), "nan"));

  e.kind = EventKind::insertion;
  e.condition = Condition::classification;
  e.value = std::numeric_limits<double>::infinity();
  CHECK(contains(describe(journal, e), "∞"));
}

TEST_CASE("Warnings and stops carry their text") {
  Journal journal;
  Event e;
  e.kind = EventKind::warning;
  e.text = journal.add_text("σ is too large");
  CHECK(describe(journal, e) == "σ is too large");
  e.kind = EventKind::stopped;
  e.text = journal.add_text("time limit");
  CHECK(contains(describe(journal, e), "time limit"));
  e.text = 77;
  CHECK(!describe(journal, e).empty());
}
