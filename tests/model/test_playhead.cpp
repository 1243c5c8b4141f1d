// The worker behind the play head: the newest request wins, answers are right, nothing is left behind.
#include "model/playhead.h"
#include "support/small_run.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

using namespace isoscope;

TEST_CASE("requests are answered, the newest one last") {
  Session session;
  const SessionSnapshot run = small_run(session);
  REQUIRE(run.phase == SessionPhase::finished);
  REQUIRE(run.journal->steps() > 10);
  std::atomic<int> notified{0};
  Playhead head([&] { ++notified; });
  CHECK(head.idle());
  CHECK(head.result() == nullptr);

  PlayheadRequest request;
  request.generation = run.generation;
  request.journal = run.journal;
  const Step last = run.journal->steps();
  for (Step k = 0; k < 300; ++k) {
    request.step = (k * 7) % last;
    head.request(request);
  }
  request.step = last;
  head.request(request);
  head.wait();
  REQUIRE(head.result() != nullptr);
  CHECK(head.result()->request == request);
  CHECK(head.result()->state->step == last);
  CHECK(head.result()->state->bad_samples == 0);

  // A state reached from the end is the state reached from the start.
  request.step = 5;
  head.request(request);
  head.wait();
  Playback fresh(run.journal);
  fresh.seek(5);
  CHECK(head.result()->state->complex == fresh.complex());
  CHECK(head.result()->index == nullptr);

  request.options.orientation = true;
  head.request(request);
  head.wait();
  CHECK(head.result()->index != nullptr);
  CHECK(notified > 0); // an answer is told before the next is begun
}

TEST_CASE("near steps are judged from the state before, and far ones anew, alike") {
  Session session;
  const SessionSnapshot run = small_run(session);
  Playhead head(nullptr);
  PlayheadRequest request;
  request.journal = run.journal;
  const Step last = run.journal->steps();
  // Forwards, backwards, far away, across the tessellation and the departure of Z.
  std::vector<Step> steps;
  for (Step k = 0; k <= last; k += std::max<Step>(1, last / 40)) steps.push_back(k);
  for (Step k = 0; k < 40 && k < last; ++k) steps.push_back(last - k);
  steps.insert(steps.end(), {0, last, 1, last / 2});
  for (const Step step : steps) {
    request.step = step;
    head.request(request);
    head.wait();
    Playback fresh(run.journal);
    const auto alone = make_snapshot(fresh, step, {}, nullptr);
    const auto& state = *head.result()->state;
    CAPTURE(step);
    CHECK(state.complex == alone->complex);
    CHECK(state.tet_flags == alone->tet_flags);
    CHECK(state.errors == alone->errors);
    CHECK(state.heights == alone->heights);
    CHECK(state.sample_tets == alone->sample_tets);
    CHECK(state.bad_samples == alone->bad_samples);
    CHECK(state.removed_facets == alone->removed_facets);
  }
}

TEST_CASE("previews judge the state shown by other parameters") {
  Session session;
  const SessionSnapshot run = small_run(session);
  REQUIRE(run.scene != nullptr);
  Playhead head(nullptr);
  PlayheadRequest request;
  request.generation = run.generation;
  request.journal = run.journal;
  // Where the refinement ends: later steps have no margin.
  for (Step k = 0; k < run.journal->steps(); ++k)
    if (run.journal->events()[run.journal->operations()[k].event].stage == Stage::refinement)
      request.step = k + 1;
  head.request(request);
  CriteriaParameters criteria = run.journal->parameters_at(request.step);
  head.wait();
  criteria.alpha = 0.2;
  head.request_preview(criteria);
  head.wait();
  REQUIRE(head.preview().has_value());
  CHECK(head.preview()->criteria == criteria);
  CHECK(head.preview()->violations->beyond_margin == 0);
  criteria.alpha = 0.95;
  head.request_preview(criteria);
  head.wait();
  CHECK(head.preview()->violations->beyond_margin > 0);

  head.clear();
  CHECK(head.result() == nullptr);
  CHECK(!head.preview().has_value());
  head.request(request);
  head.wait();
  CHECK(head.result() != nullptr);
}

TEST_CASE("a play head may be dropped while it works") {
  Session session;
  const SessionSnapshot run = small_run(session);
  for (int i = 0; i < 20; ++i) {
    Playhead head([] {});
    PlayheadRequest request;
    request.journal = run.journal;
    request.step = run.journal->steps();
    head.request(request);
    if (i % 2 == 0) head.clear();
  }
}
