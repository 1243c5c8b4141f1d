// Playback: the same bits at every step from wherever one comes, samples included.
#include "journal/playback.h"

#include "journal/synthetic.h"
#include "mesh/support.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <thread>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Journal> recorded(std::size_t insertions, std::size_t samples, std::uint64_t seed) {
  auto journal = std::make_shared<Journal>();
  record_insertions(*journal, insertions, samples, seed);
  return journal;
}

/// The state made by the first `step` deltas, applied to nothing.
Complex replayed(const Journal& journal, Step step) {
  Complex complex;
  for (Step k = 0; k < step; ++k) complex.apply(journal.operations()[k].delta());
  return complex;
}

bool same_samples(Playback& playback) {
  const auto samples = playback.samples();
  SampleSets fresh(samples->positions);
  fresh.assign_all(playback.complex());
  const SampleSets& followed = playback.sample_sets();
  if (followed.size() != fresh.size()) return false;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    if (followed.tet_of(SampleId(i)) != fresh.tet_of(SampleId(i))) return false;
  }
  return true;
}

} // namespace

TEST_CASE("Undoing an applied delta is the identity, bit by bit, at every step") {
  const auto journal = recorded(400, 40, 11);
  Complex complex;
  for (Step k = 0; k < journal->steps(); ++k) {
    const Delta delta = journal->operations()[k].delta();
    const Complex before = complex;
    complex.apply(delta);
    const Complex after = complex;
    complex.undo(delta);
    REQUIRE(complex == before);
    complex.apply(delta);
    REQUIRE(complex == after);
  }
}

TEST_CASE("Random seeks give the state that replay from zero gives, whatever the keyframes may cost") {
  // Enough work for several keyframes; the small limit forces them to be thinned.
  const auto journal = recorded(16000, 100, 12);
  std::map<Step, Complex> expected;
  Random random(5);
  for (int i = 0; i < 10; ++i) expected.try_emplace(static_cast<Step>(random.below(journal->steps() + 1)));
  expected.try_emplace(0);
  expected.try_emplace(journal->steps());
  Complex complex;
  for (Step k = 0; k <= journal->steps(); ++k) {
    if (const auto it = expected.find(k); it != expected.end()) it->second = complex;
    if (k < journal->steps()) complex.apply(journal->operations()[k].delta());
  }
  for (const std::size_t limit : {std::size_t{0}, std::size_t{8} << 20, std::size_t{256} << 20}) {
    Playback playback(journal, limit);
    for (int round = 0; round < 24; ++round) {
      const auto& [step, state] =
          *std::next(expected.begin(), static_cast<long>(random.below(expected.size())));
      CHECK(playback.seek(step) == step);
      CHECK(playback.step() == step);
      REQUIRE(playback.complex() == state);
    }
    CHECK(check_complex(playback.complex()).empty());
  }
}

TEST_CASE("Keyframes stay within their limit") {
  const auto journal = recorded(16000, 10, 13);
  constexpr std::size_t some_bytes = std::size_t{8} << 20;
  Playback none(journal, 0), some(journal, some_bytes), many(journal);
  for (Playback* playback : {&none, &some, &many}) playback->seek(journal->steps());
  const std::size_t state = many.complex().memory_bytes();
  CHECK(none.memory_bytes() == state);
  CHECK(some.memory_bytes() <= state + some_bytes);
  CHECK(many.memory_bytes() > state + some_bytes);
}

TEST_CASE("A lower limit thins the keyframes at once, and a long run stays inside it wherever one goes") {
  const auto journal = recorded(16000, 10, 17);
  constexpr std::size_t wide = std::size_t{256} << 20, narrow = std::size_t{8} << 20;
  Playback playback(journal, wide), reference(journal, 0);
  playback.seek(journal->steps());
  REQUIRE(playback.keyframe_bytes() > narrow);
  playback.set_keyframe_limit(narrow);
  CHECK(playback.keyframe_bytes() <= narrow);
  CHECK(playback.keyframe_bytes() > 0);
  Random random(18);
  for (int i = 0; i < 12; ++i) {
    const auto step = static_cast<Step>(random.below(journal->steps() + 1));
    playback.seek(step);
    reference.seek(step);
    CHECK(playback.keyframe_bytes() <= narrow);
    REQUIRE(playback.complex() == reference.complex());
  }
  playback.set_keyframe_limit(0);
  CHECK(playback.keyframe_bytes() == 0);
  playback.seek(journal->steps());
  CHECK(playback.keyframe_bytes() == 0);
}

TEST_CASE("Seeking beyond the end stops at the end") {
  const auto journal = recorded(20, 10, 14);
  Playback playback(journal);
  CHECK(playback.seek(1000000) == journal->steps());
  CHECK(playback.seek(0) == 0);
  CHECK(playback.complex() == Complex{});
  const auto nothing = std::make_shared<const Journal>();
  Playback empty(nothing);
  CHECK(empty.seek(5) == 0);
  CHECK(empty.samples() == nullptr);
  CHECK(empty.sample_sets().size() == 0);
}

TEST_CASE("Samples are where an assignment from scratch puts them, after single steps and far seeks alike") {
  const auto journal = recorded(600, 400, 15);
  Playback playback(journal);
  playback.seek(journal->steps());
  REQUIRE(same_samples(playback));
  for (int i = 0; i < 60; ++i) { // backwards, one by one
    playback.seek(playback.step() - 1);
    REQUIRE(same_samples(playback));
  }
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    playback.seek(static_cast<Step>(1 + random.below(journal->steps())));
    REQUIRE(same_samples(playback));
    playback.seek(std::max<Step>(2, playback.step()) - 1);
    REQUIRE(same_samples(playback));
  }
}

TEST_CASE("The sample set in force changes with the operation that replaced it, both ways") {
  const auto journal = recorded(200, 60, 16);
  const Step change = journal->parameters()[1].step;
  Playback playback(journal);
  playback.seek(change);
  CHECK(playback.samples()->size() == 60);
  CHECK(playback.parameters().alpha == 0.4);
  playback.seek(change + 1);
  CHECK(playback.samples()->size() == 30);
  CHECK(same_samples(playback));
  playback.seek(change - 1);
  CHECK(playback.samples()->size() == 60);
  CHECK(playback.parameters().alpha == 0.2);
  CHECK(same_samples(playback));
}

TEST_CASE("What changed in the last n steps is what those operations made and nobody removed since") {
  const auto journal = recorded(300, 10, 17);
  Playback playback(journal);
  for (const Step step : {Step{1}, Step{2}, Step{150}, journal->steps()}) {
    for (const Step n : {Step{0}, Step{1}, Step{7}, Step{1000}}) {
      playback.seek(step);
      std::set<TetId> expected;
      const Complex before = replayed(*journal, step - std::min(n, step));
      const Complex& now = playback.complex();
      for (std::size_t t = 0; t < now.tets.size(); ++t) {
        if (!now.tets[t].alive()) continue;
        if (t >= before.tets.size() || before.tets[t].v != now.tets[t].v) expected.insert(TetId(t));
      }
      const std::vector<TetId> changed = playback.changed_in_last(n);
      CHECK(std::is_sorted(changed.begin(), changed.end()));
      CHECK(std::set(changed.begin(), changed.end()) == expected);
    }
  }
}

TEST_CASE("A watcher may seek while the journal grows") {
  const auto journal = std::make_shared<Journal>();
  std::atomic<bool> done{false};
  std::thread writer([&] {
    record_insertions(*journal, 1500, 100, 18, [] { std::this_thread::yield(); });
    done = true;
  });
  Playback playback(journal);
  Random random(1);
  std::size_t seeks = 0;
  bool placed = true;
  while (!done) {
    const Step known = journal->steps();
    const Step wanted = random.below(2) == 0 ? known : static_cast<Step>(random.below(known + 1));
    playback.seek(wanted);
    if (playback.step() > 0 && ++seeks % 10 == 0) placed = placed && same_samples(playback);
  }
  writer.join();
  CHECK(placed);
  CHECK(playback.seek(journal->steps()) == journal->steps());
  CHECK(playback.complex() == replayed(*journal, journal->steps()));
}
