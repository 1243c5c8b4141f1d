// The table of a run's stages: its text for a journal written by hand, and the option that prints it.
#include "cli/compare_table.h"
#include "run/hand_made_journal.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("The table of a journal written by hand is this text") {
  // Stages that ended have the time that passed too, far below what their operations tell.
  const std::string text = compare_table(gather_statistics(*hand_made_journal()));
  CHECK(text == "Stage          Operations  Vertices of Z    Seconds   ms/operation    Rejected\n"
                "refinement              4          1,200      64.00      16000.000           1\n"
                "gamma                   2          1,000      16.00       8000.000           3\n"
                "tessellation            1          1,000      32.00      32000.000           0\n"
                "zero-set                0          1,000       0.00              -           1\n"
                "all                     3            700      32.00      10666.667           1\n"
                "improve                 5            698      16.00       3200.000           3\n"
                "total                  15            698     160.00      10666.667           9\n"
                "\n"
                "Rejected, by reason\n"
                "  refinement  too-close 1\n"
                "  gamma       link-condition 2, kernel-empty 1\n"
                "  zero-set    outside-tolerance 1\n"
                "  all         unproven 1\n"
                "  improve     stays-above 2, folded 1\n"
                "\n"
                "Targets, by what found them\n"
                "  gamma       halfedge 1, sample-candidate 1\n"
                "  all         quadric-optimum 1, lazy-constraints 1, kernel-sampling 1\n"
                "  improve     minimax-placement 2\n"
                "\n"
                "Repairs\n"
                "  improve     relaxation sweeps 2, made 2 in 5 sweeps, rolled back 2 in 17 sweeps\n");
}

TEST_CASE("A run without stages has a table without rows") {
  CHECK(compare_table({}) ==
        "Stage          Operations  Vertices of Z    Seconds   ms/operation    Rejected\n"
        "total                   0              0       0.00              -           0\n");
}

TEST_CASE("--compare prints the table after the summary, and alone when quiet") {
  const Ended both = run_batch({"gallery:sphere", "--compare"});
  CHECK(both.status == 0);
  CHECK(both.out.find("Certificate") < both.out.find("Stage  "));
  CHECK(both.out.find("Output") < both.out.find("Certificate"));
  CHECK(both.out.find("ms/operation") != std::string::npos);
  const Ended alone = run_batch({"gallery:sphere", "--compare", "--quiet"});
  CHECK(alone.status == 0);
  CHECK(alone.out.starts_with("Stage  "));
  CHECK(alone.out.find("refinement  ") != std::string::npos);
  CHECK(alone.out.find("total  ") != std::string::npos);
  const Ended clash = run_batch({"gallery:sphere", "--compare", "--report", "-"});
  CHECK(clash.status == 2);
  CHECK(clash.error.find("--compare") != std::string::npos);
}
