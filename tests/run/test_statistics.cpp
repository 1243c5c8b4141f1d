// Statistics of a journal written by hand are exactly what was written; those of a real run add up.
#include "run/statistics.h"

#include "run/complete_run.h"
#include "run/hand_made_journal.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::size_t at(const StageStatistics::ReasonCounts& counts, Reason reason) {
  return counts[static_cast<std::size_t>(reason)];
}

} // namespace

TEST_CASE("Every stage of a journal has its figures, repeated beginnings are one stage") {
  const std::vector<StageStatistics> stages = gather_statistics(*hand_made_journal());
  REQUIRE(stages.size() == 6);
  const StageStatistics &refinement = stages[0], &gamma = stages[1], &tessellation = stages[2],
                        &zero_set = stages[3], &all = stages[4], &improve = stages[5];

  CHECK(refinement.stage == Stage::refinement);
  CHECK(refinement.operations == 4);
  CHECK(refinement.insertions[static_cast<std::size_t>(Condition::containment)] == 4);
  CHECK(refinement.seconds == doctest::Approx(64).epsilon(1e-6));
  CHECK(refinement.seconds_per_operation() == doctest::Approx(16).epsilon(1e-6));
  CHECK(refinement.zero_set_vertices == 1200);
  CHECK(refinement.rejections() == 1);
  CHECK(at(refinement.rejected, Reason::too_close) == 1);
  CHECK(refinement.collapses == 0);

  CHECK(gamma.stage == Stage::gamma);
  CHECK(gamma.operations == 2);
  CHECK(gamma.collapses == 2);
  CHECK(gamma.seconds == doctest::Approx(16).epsilon(1e-6));
  CHECK(at(gamma.found, Reason::halfedge) == 1);
  CHECK(at(gamma.found, Reason::sample_candidate) == 1);
  CHECK(at(gamma.rejected, Reason::link_condition) == 2);
  CHECK(at(gamma.rejected, Reason::kernel_empty) == 1);
  CHECK(gamma.rejections() == 3);
  CHECK(gamma.zero_set_vertices == 1000);

  CHECK(tessellation.operations == 1);
  CHECK(tessellation.collapses == 0);
  CHECK(tessellation.seconds == doctest::Approx(32).epsilon(1e-6));

  CHECK(zero_set.operations == 0);
  CHECK(zero_set.seconds == 0);
  CHECK(zero_set.seconds_per_operation() == 0);
  CHECK(zero_set.rejections() == 1);
  CHECK(zero_set.zero_set_vertices == 1000);

  CHECK(all.stage == Stage::all);
  CHECK(all.operations == 3);
  CHECK(all.seconds == doctest::Approx(32).epsilon(1e-6));
  CHECK(at(all.found, Reason::kernel_sampling) == 1);
  CHECK(all.rejections() == 1);
  CHECK(all.zero_set_vertices == 700);

  CHECK(improve.stage == Stage::improve);
  CHECK(improve.operations == 5);
  CHECK(improve.relaxations == 2);
  CHECK(improve.repairs == 2);
  CHECK(improve.repair_sweeps == 5);
  CHECK(improve.failed_repairs == 2);
  CHECK(improve.failed_repair_sweeps == 17);
  CHECK(improve.rejections() == 3);
  CHECK(at(improve.rejected, Reason::stays_above) == 2);
  CHECK(at(improve.found, Reason::minimax_placement) == 2);
  CHECK(improve.zero_set_vertices == 698);
}

TEST_CASE("What comes before the first stage belongs to none, an empty journal has none") {
  CHECK(gather_statistics(Journal()).empty());
  Journal journal;
  Event warning;
  warning.stage = Stage::setup;
  journal.add_event(warning);
  CHECK(gather_statistics(journal).empty());
}

TEST_CASE("Marks tell what a stage did after its last operation, and leave the digest alone") {
  Journal journal;
  Event begin, end;
  begin.kind = EventKind::stage_begin;
  end.kind = EventKind::stage_end;
  begin.stage = end.stage = Stage::gamma;
  journal.add_event(begin);
  journal.add_event({});
  journal.add_event(end);
  REQUIRE(journal.stage_marks().size() == 2);
  CHECK(journal.stage_marks()[0].event == 0);
  CHECK(journal.stage_marks()[1].event == 2);
  CHECK(journal.stage_marks()[1].seconds >= journal.stage_marks()[0].seconds);
  const std::vector<StageStatistics> stages = gather_statistics(journal);
  REQUIRE(stages.size() == 1);
  CHECK(stages[0].seconds ==
        doctest::Approx(journal.stage_marks()[1].seconds - journal.stage_marks()[0].seconds));
  CHECK(digest(*hand_made_journal()) == digest(*hand_made_journal()));
}

TEST_CASE("The operations of a run's stages add up to its journal's") {
  CompleteRun run(gallery_parameters("sphere"));
  REQUIRE(run.run());
  const std::vector<StageStatistics> stages = gather_statistics(*run.journal);
  std::size_t operations = 0;
  for (const StageStatistics& s : stages) {
    operations += s.operations;
    CHECK(s.seconds > 0);
  }
  CHECK(operations == run.journal->steps());
  CHECK(stages.back().zero_set_vertices == run.result->mesh.points.size());
}
