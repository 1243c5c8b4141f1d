// A journal whose older part is on the disk: the same events, deltas and states for everyone who reads it.
#include "journal/digest.h"
#include "journal/history.h"
#include "journal/playback.h"
#include "journal/synthetic.h"

#include <doctest/doctest.h>

#include <atomic>
#include <random>
#include <thread>

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::size_t insertions = 4000, samples = 60;
constexpr std::uint64_t seed = 11;

std::shared_ptr<Journal> recorded(std::size_t limit) {
  auto journal = std::make_shared<Journal>();
  journal->keep_within(limit);
  record_insertions(*journal, insertions, samples, seed);
  return journal;
}

Delta full_delta() {
  Delta d;
  d.added_vertices = {{{1, 2, 3}, -0.0, VertexKind::sample, true, 2, SampleId(7)}};
  d.killed_vertices = {VertexId(3), VertexId(9)};
  d.values = {{VertexId(1), 0.5, -1}};
  d.moves = {{VertexId(4), {0, 0, 1}, {0, 1, 0}}};
  d.removed = {{TetId(2), {VertexId(0), VertexId(1), VertexId(2), VertexId(3)}, -1}};
  d.added = {{TetId(2), {VertexId(0), VertexId(1), VertexId(2), VertexId(5)}, 1}, {TetId(8), {}, 0}};
  d.slots_before = 8;
  d.sides = {{TetId(1), 0, -1}};
  d.removed_facets = {{FacetId(5), {VertexId(0), VertexId(2), VertexId(4)}}};
  d.added_facets = {{FacetId(6), {VertexId(0), VertexId(2), VertexId(5)}}};
  d.facet_slots_before = 6;
  d.sample_set = Delta::SampleSetChange{1, 2};
  d.form = Delta::FormChange{ZeroForm::interpolated, ZeroForm::embedded};
  return d;
}

} // namespace

TEST_CASE("A stored delta is read bit for bit, also into one that held another") {
  SpillPool pool;
  DeltaStore store(pool);
  const Delta full = full_delta();
  const StoredDelta first = store.add(full), none = store.add(Delta()), copy = store.add(first);
  CHECK(digest(first.read()) == digest(full));
  CHECK(digest(copy.read()) == digest(full));
  Delta again = full;
  none.read(again);
  CHECK(again.empty());
  CHECK(digest(again) == digest(Delta()));
  first.read(again);
  CHECK(digest(again) == digest(full));
  CHECK(digest(StoredDelta().read()) == digest(Delta()));
}

TEST_CASE("With a tiny limit the journal says the same, and keeps within it but for what grows") {
  const auto all = recorded(SpillPool::unlimited), little = recorded(0);
  CHECK(digest(*all) == digest(*little));
  CHECK(all->disk_bytes() == 0);
  CHECK(little->disk_bytes() > 0);
  // One segment of events, one of operations, one of deltas are open; samples and texts stay.
  CHECK(little->memory_bytes() < 1200000);
  CHECK(little->memory_bytes() + little->disk_bytes() == all->memory_bytes());
  // Taken later, the same.
  all->keep_within(0);
  CHECK(all->disk_bytes() == little->disk_bytes());
  CHECK(digest(*all) == digest(*little));
  all->release_read_back();
  CHECK(digest(*all) == digest(*little));
}

TEST_CASE("Random seeks over a journal on the disk give the states of one in memory") {
  const auto all = recorded(SpillPool::unlimited), little = recorded(0);
  Playback wanted(all), found(little, 200000);
  std::mt19937 random(5);
  for (int i = 0; i < 25; ++i) {
    const auto step = static_cast<Step>(random() % (all->steps() + 1));
    wanted.seek(step);
    found.seek(step);
    little->release_read_back();
    CHECK(found.complex() == wanted.complex());
    CHECK(found.changed_in_last(3) == wanted.changed_in_last(3));
  }
  const ElementRef vertex{ElementRef::Kind::vertex, 40, 0};
  const auto a = element_history(*all, vertex, {}, 0, RunControl());
  const auto b = element_history(*little, vertex, {}, 0, RunControl());
  CHECK(a.rows.size() == b.rows.size());
  CHECK(a.path == b.path);
}

TEST_CASE("A branch takes what lies on the disk") {
  const auto little = recorded(0);
  Journal branch, same;
  branch.take_prefix(*little, 1500);
  same.take_prefix(*recorded(SpillPool::unlimited), 1500);
  CHECK(branch.steps() == 1500);
  CHECK(digest(branch) == digest(same));
  Journal fewer;
  fewer.take_prefix(*little, 1500, little->operations()[700].event);
  CHECK(fewer.steps() == 700);
}

TEST_CASE("Readers follow a journal that goes to the disk while it grows") {
  const std::uint64_t expected = digest(*recorded(SpillPool::unlimited));
  const auto journal = std::make_shared<Journal>();
  std::atomic<bool> done{false}, wrong{false};
  std::thread head([&] {
    Playback playback(journal, 500000);
    std::mt19937 random(2);
    while (!done) {
      const Step steps = journal->steps();
      if (steps < 2) continue;
      const Step step = playback.seek(static_cast<Step>(random() % steps));
      if (playback.step() != step) wrong = true;
    }
  });
  std::thread list([&] {
    while (!done)
      for (std::size_t i = 0, n = journal->events().size(); i < n && !done; i += 37)
        if (journal->events()[i].step > n) wrong = true;
  });
  std::thread limit([&] {
    for (std::size_t k = 0; !done; ++k) {
      journal->keep_within(k % 2 == 0 ? 0 : 600000);
      journal->release_read_back();
      std::this_thread::yield();
    }
  });
  record_insertions(*journal, insertions, samples, seed);
  done = true;
  for (std::thread* t : {&head, &list, &limit}) t->join();
  CHECK(!wrong);
  CHECK(journal->disk_bytes() > 0);
  CHECK(digest(*journal) == expected);
}
