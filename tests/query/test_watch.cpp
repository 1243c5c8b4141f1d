// What is followed over a journal is what the state says, at every step of a complete run.
#include "journal/playback.h"
#include "mesh/zero_set.h"
#include "query/search.h"
#include "run/complete_run.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Journal> complete_torus() {
  static const std::shared_ptr<const Journal> journal = [] {
    CompleteRun run(complete_parameters("torus"));
    run.parameters.effort = 1;
    REQUIRE(run.run());
    return run.journal;
  }();
  return journal;
}

/// The class of a sample as the playback has it.
SampleClass class_of(Playback& playback, SampleId s) {
  const Complex& complex = playback.complex();
  const auto samples = playback.samples();
  if (complex.form == ZeroForm::free || !samples) return SampleClass::outside;
  const TetId t = playback.sample_sets().tet_of(s);
  if (!t.valid()) return SampleClass::outside;
  const double f = interpolate(complex.positions(t), complex.values(t))(samples->positions[s.index()]);
  const int label = samples->labels[s.index()], side = complex.tet(t).side;
  const double error =
      side == 0 ? sample_error(f, label) : embedded_sample_error(sample_error(f, label), side == label);
  return is_bad(error)                                 ? SampleClass::bad
         : error > playback.parameters().error_limit() ? SampleClass::margin
                                                       : SampleClass::good;
}

std::shared_ptr<const Expression> query_of(const std::string& text) {
  return std::get<std::shared_ptr<const Expression>>(parse_query(text));
}

} // namespace

TEST_CASE("χ and components are those of Z at every operation") {
  const auto journal = complete_torus();
  QueryNeeds needs;
  needs.topology = true;
  JournalWatch watch(journal, needs);
  Playback playback(journal);
  std::size_t compared = 0;
  for (std::uint32_t i = 0; i < journal->events().size(); ++i) {
    watch.go_to(i);
    const Event& event = journal->events()[i];
    if (!event.operation) continue;
    playback.seek(event.step + 1);
    const ZeroSet z = extract_zero_set(playback.complex());
    REQUIRE(watch.euler_characteristic() == z.euler_characteristic());
    REQUIRE(watch.components() == z.components.size());
    ++compared;
  }
  CHECK(compared == journal->steps());
  // Almost all operations are understood from what they change alone.
  CHECK(watch.component_recounts() * 2 < compared);
}

TEST_CASE("a sample's class changes exactly where the states differ") {
  const auto journal = complete_torus();
  const std::vector<SampleId> samples{SampleId(3), SampleId(57), SampleId(211)};
  for (const SampleId s : samples) {
    Playback playback(journal);
    std::vector<std::uint32_t> changes;
    SampleClass before = SampleClass::outside;
    for (Step step = 1; step <= journal->steps(); ++step) {
      playback.seek(step);
      const SampleClass now = class_of(playback, s);
      if (now != before) changes.push_back(journal->operations()[step - 1].event);
      before = now;
    }
    const auto changing = query_of("sample(" + std::to_string(s.value) + ").class changes");
    JournalWatch watch(journal, changing->needs());
    CHECK(changes.size() >= 2);
    CHECK(matches(*changing, *journal, 0, static_cast<std::uint32_t>(journal->events().size()), &watch) ==
          changes);
    // Going back starts anew and ends at the same.
    watch.go_to(changes[1]);
    CHECK(holds(*changing, *journal, changes[1], &watch));
  }
}

TEST_CASE("edges near a point, by the places their ends had before the operation") {
  const auto journal = complete_torus();
  std::uint32_t event = 0;
  while (journal->events()[event].kind != EventKind::collapse) ++event;
  const Event& e = journal->events()[event];
  Playback playback(journal);
  playback.seek(e.step);
  const Vec3 a = playback.complex().position(e.vertex), b = playback.complex().position(e.other);
  const Vec3 middle = 0.5 * (a + b);
  char text[160];
  std::snprintf(text, sizeof text, "collapse && edge near (%.17g, %.17g, %.17g) 1e-9", middle.x, middle.y,
                middle.z);
  const auto near = query_of(text);
  JournalWatch watch(journal, near->needs());
  const auto found =
      matches(*near, *journal, 0, static_cast<std::uint32_t>(journal->events().size()), &watch);
  CHECK(found == std::vector<std::uint32_t>{event});
}

TEST_CASE("the genus of a torus, and what it should be") {
  const auto journal = complete_torus();
  const auto count = [&](const std::string& text, const ExpectedGenus& expected) {
    const auto expression = query_of(text);
    JournalWatch watch(journal, expression->needs(), expected);
    return matches(*expression, *journal, 0, static_cast<std::uint32_t>(journal->events().size()), &watch)
        .size();
  };
  const ExpectedGenus one = [] { return std::optional<double>(1); };
  CHECK(count("stage == improve && genus != 1", {}) == 0);
  CHECK(count("stage == improve && genus == expected && euler == 0 && components == 1", one) > 0);
  CHECK(count("expected != 1", one) == 0);
  CHECK(count("expected == 1", one) == journal->events().size());
}
