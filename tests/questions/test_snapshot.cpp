// Snapshots: what a viewer shows is what the definitions say, counted by brute force.
#include "questions/snapshot.h"

#include "criteria/height.h"
#include "criteria/orientation.h"
#include "journal/synthetic.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Journal> recorded() {
  static const std::shared_ptr<const Journal> journal = [] {
    auto j = std::make_shared<Journal>();
    record_insertions(*j, 300, 500, 4);
    return j;
  }();
  return journal;
}

} // namespace

TEST_CASE("Step 0 is empty, and so is an empty journal") {
  Playback playback(recorded());
  const auto state = make_snapshot(playback, 0, {}, nullptr);
  CHECK(state->step == 0);
  CHECK(state->complex.tets.empty());
  CHECK(!state->event);
  CHECK(!state->inserted.valid());
  Playback nothing(std::make_shared<const Journal>());
  const auto empty = make_snapshot(nothing, 7, {}, nullptr);
  CHECK(empty->step == 0);
  CHECK(empty->samples == nullptr);
}

TEST_CASE("Errors, flags, heights and totals are those of the definitions") {
  Playback playback(recorded());
  for (const Step step : {Step{1}, Step{40}, Step{250}}) {
    const auto s = make_snapshot(playback, step, {}, nullptr);
    REQUIRE(s->errors.size() == s->samples->size());
    std::size_t bad = 0, beyond = 0;
    float largest = -1e30f;
    SampleId worst;
    for (std::size_t i = 0; i < s->errors.size(); ++i) {
      const TetId t = s->sample_tets[i];
      REQUIRE(s->complex.tet(t).alive());
      const double f = interpolate(s->complex.positions(t), s->complex.values(t))(s->samples->positions[i]);
      const double error = sample_error(f, s->samples->labels[i]);
      CHECK(s->errors[i] == static_cast<float>(error));
      bad += error >= 1;
      if (error > s->criteria.error_limit()) {
        ++beyond;
        CHECK((s->tet_flags[t.index()] & tet_violates_1) != 0);
      }
      if (s->errors[i] > largest) {
        largest = s->errors[i];
        worst = SampleId(i);
      }
    }
    CHECK(s->bad_samples == bad);
    CHECK(s->beyond_margin == beyond);
    CHECK(s->largest_error == largest);
    CHECK(s->worst_sample == worst);
    std::size_t flat = 0;
    for (std::size_t i = 0; i < s->complex.tets.size(); ++i) {
      const TetId t(i);
      const bool alive = s->complex.tet(t).alive();
      CHECK(((s->tet_flags[i] & tet_alive) != 0) == alive);
      if (!alive) continue;
      const bool heterogeneous = s->complex.heterogeneous(t);
      CHECK(((s->tet_flags[i] & tet_heterogeneous) != 0) == heterogeneous);
      const auto& v = s->complex.tet(t).v;
      const bool box = std::any_of(v.begin(), v.end(), [](VertexId id) { return id.value < 8; });
      if (step > 1)
        CHECK(((s->tet_flags[i] & tet_box) != 0) == (box && s->complex.vertices[0].kind == VertexKind::box));
      if (!heterogeneous) continue;
      const double height = tetrahedron_height(s->complex.positions(t), s->complex.values(t)).value;
      CHECK(s->heights[i] == static_cast<float>(height));
      flat += height < s->criteria.height_limit();
    }
    CHECK(s->violating_2 == flat);
    CHECK(s->zero_set.polygons.size() == static_cast<std::size_t>(std::count_if(
                                             s->tet_flags.begin(), s->tet_flags.end(),
                                             [](std::uint8_t f) { return (f & tet_heterogeneous) != 0; })));
  }
}

TEST_CASE("What the last operation touched is named") {
  const auto journal = recorded();
  Playback playback(journal);
  const Step step = 60;
  const auto s = make_snapshot(playback, step, {}, nullptr);
  const Delta delta = journal->operations()[step - 1].delta();
  REQUIRE(s->event);
  CHECK(*s->event == journal->events()[journal->operations()[step - 1].event]);
  CHECK(s->inserted == VertexId(s->complex.vertices.size() - 1));
  CHECK(s->complex.position(s->inserted) == s->event->point);
  CHECK(s->removed_tets.size() == delta.removed.size());
  CHECK(s->added_tets.size() == delta.added.size());
  CHECK(s->violated_tet.has_value());
  for (std::size_t i = 0; i < s->tet_flags.size(); ++i) {
    const bool changed =
        std::find(s->added_tets.begin(), s->added_tets.end(), TetId(i)) != s->added_tets.end();
    CHECK(((s->tet_flags[i] & tet_changed) != 0) == changed);
  }
}

TEST_CASE("A preview counts what a snapshot under those parameters counts") {
  Playback playback(recorded());
  const auto state = make_snapshot(playback, 200, {}, nullptr);
  const NearestSample nearest(state->samples->positions, state->samples->labels);
  for (const double alpha : {0.1, 0.2, 0.7}) {
    for (const double shrink : {0.3, 1.0}) {
      CriteriaParameters criteria = state->criteria;
      criteria.alpha = alpha;
      criteria.shrink = shrink;
      criteria.sigma = 0.02;
      SnapshotOptions options;
      options.orientation = true;
      options.criteria = criteria;
      const auto judged = make_snapshot(playback, 200, options, &nearest);
      const ViolationPreview preview = preview_violations(*state, criteria, &nearest);
      CHECK(preview.bad_samples == judged->bad_samples);
      CHECK(preview.beyond_margin == judged->beyond_margin);
      CHECK(preview.too_flat == judged->violating_2);
      CHECK(preview.misoriented == judged->violating_3);
    }
  }
}

TEST_CASE("A snapshot is the same from whichever side its step is reached") {
  Playback forward(recorded()), backward(recorded());
  backward.seek(1000);
  static_cast<void>(backward.sample_sets());
  const auto a = make_snapshot(forward, 120, {}, nullptr);
  const auto b = make_snapshot(backward, 120, {}, nullptr);
  CHECK(a->complex == b->complex);
  CHECK(a->errors == b->errors);
  CHECK(a->sample_tets == b->sample_tets);
  CHECK(a->tet_flags == b->tet_flags);
  CHECK(a->heights == b->heights);
  CHECK(a->worst_sample == b->worst_sample);
}

TEST_CASE("A snapshot made from another one is the same as one made alone") {
  const auto journal = recorded();
  Playback playback(journal), alone(journal);
  std::uint64_t random = 3;
  std::shared_ptr<const StateSnapshot> last;
  const NearestSample nearest(journal->sample_sets()[0]->positions, journal->sample_sets()[0]->labels);
  Step step = 100;
  for (int i = 0; i < 60; ++i) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    const auto stride = static_cast<Step>((random >> 40) % 7);
    step = (random >> 33) % 10 == 0  ? static_cast<Step>((random >> 45) % (journal->steps() + 1))
           : (random >> 35) % 2 == 0 ? std::min(journal->steps(), step + stride)
                                     : step - std::min(step, stride);
    SnapshotOptions options;
    options.orientation = i % 20 < 5;
    options.recent = 3;
    last = make_snapshot(playback, step, options, &nearest, last.get());
    const auto expected = make_snapshot(alone, step, options, &nearest);
    REQUIRE(last->complex == expected->complex);
    REQUIRE(last->errors == expected->errors);
    REQUIRE(last->sample_tets == expected->sample_tets);
    REQUIRE(last->tet_flags == expected->tet_flags);
    REQUIRE(last->heights == expected->heights);
    CHECK(last->bad_samples == expected->bad_samples);
    CHECK(last->worst_sample == expected->worst_sample);
    CHECK(last->violating_2 == expected->violating_2);
    CHECK(last->violating_3 == expected->violating_3);
  }
}
