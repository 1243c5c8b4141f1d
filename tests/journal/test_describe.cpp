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

TEST_CASE("Every stage, kind, condition and reason has a name and words of its own") {
  std::set<std::string_view> kinds, conditions, reasons, stages, sentences, plain;
  for (const KindWords& row : kind_table) {
    kinds.insert(row.name);
    sentences.insert(row.sentence);
    plain.insert(row.plain);
    CHECK(!row.title.empty());
    CHECK(!row.one.empty());
    CHECK(!row.help.empty());
  }
  CHECK(kinds.size() == event_kind_count);
  CHECK(sentences.size() == event_kind_count);
  CHECK(plain.size() == event_kind_count);
  for (const ConditionWords& row : condition_table) conditions.insert(row.name);
  CHECK(conditions.size() == condition_count);
  for (const ReasonWords& row : reason_table) {
    reasons.insert(row.name);
    CAPTURE(row.name);
    CHECK((row.role == ReasonRole::none) == row.sentence.empty());
    CHECK(rejects(row.value) == !row.plain.empty());
  }
  CHECK(reasons.size() == reason_count);
  for (const StageWords& row : stage_table) stages.insert(row.name);
  CHECK(stages.size() == stage_count);
}

TEST_CASE("Every combination of kind, condition and reason has a sentence") {
  Journal& journal = journal_with_delta();
  for (const KindWords& kind : kind_table)
    for (const ConditionWords& condition : condition_table)
      for (const ReasonWords& reason : reason_table) {
        Event e;
        e.kind = kind.value;
        e.condition = condition.value;
        e.reason = reason.value;
        e.vertex = VertexId(3);
        e.other = VertexId(4);
        const std::string text = describe(journal, e);
        CAPTURE(text);
        CHECK(!text.empty());
        CHECK(!contains(text, "  "));
        CHECK(!contains(text, "4294967295"));
        // Every figure is known.
        CHECK(text.find_first_of("{}?") == std::string::npos);
        CHECK(plain_words(journal, e).find_first_of("{}?") == std::string::npos);
      }
}

TEST_CASE("Rejections tell the edge, the reason and the number that decided") {
  Journal& journal = journal_with_delta();
  Event e;
  e.kind = EventKind::rejection;
  e.vertex = VertexId(3);
  e.other = VertexId(4);
  e.value = 0.75;
  e.limit = 0.5;
  std::set<std::string> texts;
  for (const Reason reason : rejecting_reasons) {
    e.reason = reason;
    const std::string text = describe(journal, e);
    CHECK(text.starts_with("edge 3–4 stays: "));
    texts.insert(text);
  }
  CHECK(texts.size() == rejecting_reasons.size());
  const auto said = [&](Reason reason) {
    e.reason = reason;
    return describe(journal, e);
  };
  CHECK(said(Reason::misclassified) == "edge 3–4 stays: a sample would change class, ε = 0.75 (limit 0.50)");
  CHECK(said(Reason::outside_tolerance) == "edge 3–4 stays: Z would leave Ω, d = 1.500 δ (limit 1.000 δ)");
  CHECK(said(Reason::folded) == "edge 3–4 stays: a facet would turn over");
  CHECK(said(Reason::ineligible) == "edge 3–4 stays: it is not of the kind that the stage collapses");
  CHECK(said(Reason::budget) == "edge 3–4 stays: a limit of work was reached");
  e.facet = {VertexId(5), VertexId(17), VertexId(40)};
  CHECK(said(Reason::outside_tolerance) ==
        "edge 3–4 stays: Z would leave Ω at facet 5–17–40, d = 1.500 δ (limit 1.000 δ)");
  CHECK(said(Reason::stays_above) ==
        "edge 3–4 stays: the repair was rolled back, facet 5–17–40 stays at d = 1.500 δ (limit 1.000 δ), "
        "0.500 δ too far");
  // δ is 0.5 here: what is hardly beyond the limit does not read like it.
  e.value = 0.50004;
  CHECK(said(Reason::misclassified) ==
        "edge 3–4 stays: a sample would change class, ε = 0.50004 (limit 0.50)");
  CHECK(said(Reason::stays_above) ==
        "edge 3–4 stays: the repair was rolled back, facet 5–17–40 stays at d = 1.0001 δ (limit 1.000 δ), "
        "0.0001 δ too far");
  e.value = 0.5;
  CHECK(said(Reason::misclassified) == "edge 3–4 stays: a sample would change class, ε = 0.50 (limit 0.50)");
}

TEST_CASE("A number that two digits would show as zero has as many as show its first") {
  Event e;
  e.kind = EventKind::insertion;
  e.condition = Condition::orientation;
  e.tet = TetId(7);
  e.value = -0.0041;
  CHECK(contains(describe(journal_with_delta(), e), "f·F = -0.004 at"));
  e.value = -0.09;
  CHECK(contains(describe(journal_with_delta(), e), "f·F = -0.09 at"));
  e.value = 0;
  CHECK(contains(describe(journal_with_delta(), e), "f·F = 0.00 at"));
}

TEST_CASE("What an event's value is, its kind, its reason or its condition says") {
  const auto of = [](EventKind kind, Condition condition, Reason reason) {
    Event e;
    e.kind = kind;
    e.condition = condition;
    e.reason = reason;
    return measure_of(e);
  };
  CHECK(of(EventKind::repair, Condition::none, Reason::quadric_optimum) == Measure::length);
  CHECK(of(EventKind::rejection, Condition::none, Reason::border_distance) == Measure::length);
  CHECK(of(EventKind::rejection, Condition::none, Reason::kernel_empty) == Measure::depth);
  CHECK(of(EventKind::rejection, Condition::none, Reason::misclassified) == Measure::error);
  CHECK(of(EventKind::rejection, Condition::none, Reason::folded) == Measure::none);
  CHECK(of(EventKind::split, Condition::none, Reason::leaves_volume) == Measure::length);
  CHECK(of(EventKind::insertion, Condition::height, Reason::circumcenter_sample) == Measure::depth);
  CHECK(of(EventKind::exhausted, Condition::containment, Reason::too_close) == Measure::length);
  CHECK(of(EventKind::stage_begin, Condition::none, Reason::none) == Measure::none);
  CHECK(is_length(Measure::depth));
  CHECK(!is_length(Measure::error));
}

TEST_CASE("The kinds of the later stages tell what they did") {
  Journal& journal = journal_with_delta();
  Event e;
  e.operation = true;
  e.step = 6;
  e.count = 12;
  e.value = 0.25;
  e.vertex = VertexId(3);
  e.other = VertexId(4);
  const auto said = [&](EventKind kind) {
    e.kind = kind;
    return describe(journal, e);
  };
  e.reason = Reason::quadric_optimum;
  CHECK(said(EventKind::collapse) == "7 · edge 3–4 collapses to the least error in its kernel");
  CHECK(said(EventKind::tessellation) == "7 · mutual tessellation: 12 vertices of Z go into T");
  CHECK(said(EventKind::departure) == "7 · Z leaves T: from here on its own facets are kept inside Ω");
  CHECK(said(EventKind::relaxation) == "7 · 12 vertices relocated in a sweep over Z, largest d = 0.500 δ");
  CHECK(said(EventKind::repair) == "7 · edge 3–4 collapses, repaired in 0 sweeps, largest d = 0.500 δ");
  CHECK(said(EventKind::shake) == "7 · Z shaken: edges flipped against the energy and 12 vertices relocated "
                                  "around them, largest d = 0.500 δ");
  CHECK(said(EventKind::relabel) == "7 · labels of 12 vertices change side");
  CHECK(describe_event(journal, e) == "labels of 12 vertices change side");
  e.operation = false;
  e.kind = EventKind::exhausted;
  e.condition = Condition::height;
  e.reason = Reason::too_close;
  e.limit = 0.5;
  e.tet = TetId(8);
  CHECK(describe(journal, e) ==
        "condition 2 stays violated: height 0.500 δ (at least 1.000 δ) in tetrahedron "
        "8; the candidate is too close to a vertex");
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
