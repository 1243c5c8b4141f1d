// Reads both recordings whole and compares their journals.
#include "cli/command_line.h"
#include "cli/comparison_text.h"
#include "cli/exit_status.h"
#include "cli/recorded_file.h"
#include "cli/verbs.h"
#include "compare/compare_runs.h"

#include <string>

namespace isoscope {

int diff(int argc, char** argv) {
  std::string file_a, file_b;
  unsigned rows = 10;
  bool quiet = false;
  CommandLine app{
      "Tells what differs between two recorded runs: parameters, the outcome of each stage, the first "
      "differing decision, and which decisions only one of them made.",
      "isoscope-run diff"};
  app.option("A", file_a, "a recording, RUN.isorun", true);
  app.option("B", file_b, "the recording that it is compared with", true);
  app.option("--rows", rows, "how many decisions of one run alone are listed; default 10");
  app.flag("--quiet", quiet, "print nothing but errors: the exit status tells");
  app.notes("Runs on the same input are compared event by event, without times; decisions after the first "
            "difference are matched by their places.");
  app.exit_status("0 the same, 1 different, 2 usage or a file that cannot be read.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  const auto a = read_recorded_run(file_a);
  if (!a) return fail(a.error(), 2);
  const auto b = read_recorded_run(file_b);
  if (!b) return fail(b.error(), 2);
  const RunComparison found =
      compare_runs(a->parameters, *a->journal, b->parameters, *b->journal, RunControl());
  if (!quiet) {
    const std::string text = comparison_text(found, {file_a, *a->journal}, {file_b, *b->journal}, rows);
    if (Status printed = print(text); !printed) return fail(printed.error(), 2);
  }
  return found.same() ? 0 : 1;
}

} // namespace isoscope
