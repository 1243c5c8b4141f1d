// Writing and reading in one call each.
#include "recording/recorded.h"

#include "journal/digest.h"
#include "journal/synthetic.h"
#include "run/recorded_run.h"

#include <doctest/doctest.h>

namespace isoscope::test {

const CompleteRun& whole_run() {
  static const std::unique_ptr<CompleteRun> run = [] {
    auto made = std::make_unique<CompleteRun>(complete_parameters("sphere"));
    made->run();
    return made;
  }();
  REQUIRE(run->result.has_value());
  return *run;
}

std::shared_ptr<const Journal> small_journal() {
  auto journal = std::make_shared<Journal>();
  record_insertions(*journal, 150, 300, 5);
  return journal;
}

Status write_recording(const std::filesystem::path& file, std::shared_ptr<const Journal> journal,
                       bool finished, std::size_t events_per_commit) {
  const CompleteRun& run = whole_run();
  auto writer = RecordingWriter::create(file, {std::chrono::milliseconds(1), events_per_commit});
  if (!writer) return writer.error();
  (*writer)->start(recording_header(run.parameters, run.scene->input), journal);
  if (finished)
    (*writer)->end([&] { return recording_end(run.parameters, *run.scene, *run.result, *journal); });
  return (*writer)->finish();
}

ReadBack read_back(const std::filesystem::path& file) {
  ReadBack back;
  auto opened = RecordingReader::open(file);
  if (!opened) {
    back.error = opened.error();
    return back;
  }
  back.reader = std::move(*opened);
  for (;;) {
    const auto more = back.reader->read_commit(*back.journal);
    if (!more) {
      back.error = more.error();
      return back;
    }
    if (!*more) break;
  }
  auto end = back.reader->end();
  if (end)
    back.end = *end;
  else
    back.error = end.error();
  return back;
}

void check_same(const Journal& a, const Journal& b) {
  CHECK(digest(a) == digest(b));
  REQUIRE(a.operations().size() == b.operations().size());
  for (std::size_t i = 0; i < a.operations().size(); ++i) {
    const Operation &x = a.operations()[i], &y = b.operations()[i];
    CHECK(x.event == y.event);
    CHECK(x.figures.tets == y.figures.tets);
    CHECK(x.figures.seconds == y.figures.seconds);
    CHECK(x.delta().slots_before == y.delta().slots_before);
    CHECK(x.delta().facet_slots_before == y.delta().facet_slots_before);
  }
  REQUIRE(a.parameters().size() == b.parameters().size());
  for (std::size_t i = 0; i < a.parameters().size(); ++i) {
    CHECK(a.parameters()[i].step == b.parameters()[i].step);
    CHECK(a.parameters()[i].criteria == b.parameters()[i].criteria);
  }
  REQUIRE(a.stage_marks().size() == b.stage_marks().size());
  for (std::size_t i = 0; i < a.stage_marks().size(); ++i) {
    CHECK(a.stage_marks()[i].event == b.stage_marks()[i].event);
    CHECK(a.stage_marks()[i].seconds == b.stage_marks()[i].seconds);
  }
  REQUIRE(a.sample_sets().size() == b.sample_sets().size());
  for (std::size_t i = 0; i < a.sample_sets().size(); ++i) {
    CHECK(a.sample_sets()[i]->components == b.sample_sets()[i]->components);
    CHECK(a.sample_sets()[i]->sigma == b.sample_sets()[i]->sigma);
  }
}

void check_prefix(const Journal& read, const Journal& whole) {
  REQUIRE(read.events().size() <= whole.events().size());
  REQUIRE(read.operations().size() <= whole.operations().size());
  Digest a, b;
  for (std::size_t i = 0; i < read.events().size(); ++i) {
    a.add(read.events()[i]);
    b.add(whole.events()[i]);
  }
  for (std::size_t i = 0; i < read.operations().size(); ++i) {
    a.add(read.operations()[i].delta());
    b.add(whole.operations()[i].delta());
  }
  CHECK(a.value() == b.value());
}

} // namespace isoscope::test
