// Small programs around the folder of a sweep.
#include "cli/sweep_verbs.h"

#include "base/numbers.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/interruptible.h"
#include "run/report.h"
#include "sweep/page.h"

#include <unistd.h>

namespace isoscope {

namespace {

namespace fs = std::filesystem;
using namespace sweep;

Result<std::vector<Row>> rows_of(const std::string& place) {
  std::error_code failure;
  const Folder folder(place);
  if (!fs::is_directory(place, failure)) return read_table(place);
  const auto plan = read_plan(folder);
  if (!plan) return plan.error();
  const auto rows = gather_rows(folder, *plan);
  if (!rows) return rows.error();
  std::vector<Row> list;
  for (const auto& [run, row] : *rows) list.push_back(row);
  return list;
}

std::string told(const char* heading, const std::vector<std::string>& sentences) {
  std::string text = sentences.empty() ? "" : std::string(heading) + "\n";
  for (const std::string& s : sentences) text += "  " + s + "\n";
  return text;
}

} // namespace

fs::path own_program() {
  std::error_code failure;
  const fs::path self = fs::read_symlink("/proc/self/exe", failure);
  return failure ? fs::path("isoscope-sweep") : self;
}

fs::path run_program() {
  return own_program().parent_path() / "isoscope-run";
}

Status check_program(const fs::path& program) {
  if (::access(program.c_str(), X_OK) == 0) return {};
  return Error{ErrorCode::usage, program.string() + " cannot be started.",
               "Give an isoscope-run by --program."};
}

int sweep_status(const Plan& plan, const std::map<std::size_t, Row>& rows) {
  if (rows.size() < plan.runs()) return 4;
  for (const auto& [run, row] : rows)
    if (row.outcome != Outcome::certified) return 1;
  return 0;
}

int finish_sweep(const Folder& folder, const Plan& plan, bool quiet) {
  const auto rows = merge(folder, plan);
  if (!rows) return fail(rows.error());
  if (Status written = write_page(folder, plan, *rows); !written) return fail(written.error());
  std::size_t certified = 0;
  for (const auto& [run, row] : *rows) certified += row.outcome == Outcome::certified ? 1 : 0;
  const std::string text = counted(rows->size(), "run") + " of " + grouped(plan.runs()) + ", " +
                           grouped(certified) + " certified: " + folder.page().string() + "\n";
  if (!quiet)
    if (Status printed = print(text); !printed) return fail(printed.error());
  return sweep_status(plan, *rows);
}

int sweep_step(int argc, char** argv) {
  std::string place;
  unsigned run = 0, every = 0;
  std::string program = run_program().string();
  CommandLine app{
      "Does one run of a sweep, or every so many from it on, where they have no row yet. The rows go "
      "into a part of their own, so that any number of these may work at once, on any machines that "
      "share the folder.",
      "isoscope-sweep step"};
  app.option("FOLDER", place, "of the sweep", true);
  app.option("--run", run, "the number of the run, from 0");
  app.option("--every", every, "do the runs K, K + N, K + 2 N, …, where K is that of --run");
  app.option("--program", program, "the isoscope-run to try; default the one beside this program");
  app.notes("GNU parallel does a whole sweep, and what is missing of one:\n\n"
            "isoscope-sweep missing FOLDER | parallel isoscope-sweep step FOLDER --run {}");
  app.exit_status("0 the runs have their rows, however they ended; 2 usage; 3 no sweep; 4 interrupted.");
  app.see_also("isoscope-sweep");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  if (!app.given("--run"))
    return fail({ErrorCode::usage, "--run is missing.", "Give the number of a run; they begin at 0."}, 2);
  const Folder folder(place);
  const auto plan = read_plan(folder);
  if (!plan) return fail(plan.error());
  if (run >= plan->runs())
    return fail({ErrorCode::usage, "There is no run " + std::to_string(run) + ".",
                 "The last one is " + std::to_string(plan->runs() - 1) + "."},
                2);
  if (Status there = check_program(program); !there) return fail(there.error());
  const auto rows = rows_with_part(folder, *plan, run);
  if (!rows) return fail(rows.error());
  std::vector<std::size_t> wanted;
  for (const std::size_t missing : missing_runs(*plan, *rows))
    if (missing == run || (every > 0 && missing > run && (missing - run) % every == 0))
      wanted.push_back(missing);
  RunControl control;
  const Interruptible signals(control);
  if (Status done = do_runs(folder, *plan, wanted, folder.part(run), {program, 1, {}}, control); !done)
    return fail(done.error(), 1);
  return control.cancelled() ? 4 : 0;
}

int sweep_missing(int argc, char** argv) {
  std::string place;
  CommandLine app{"Prints the numbers of the runs of a sweep that have no row yet, one a line.",
                  "isoscope-sweep missing"};
  app.option("FOLDER", place, "of the sweep", true);
  app.exit_status("0 also where nothing is missing; 2 usage; 3 no sweep.");
  app.see_also("isoscope-sweep");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  const auto plan = read_plan(Folder(place));
  if (!plan) return fail(plan.error());
  const auto rows = gather_rows(Folder(place), *plan);
  if (!rows) return fail(rows.error());
  std::string text;
  for (const std::size_t run : missing_runs(*plan, *rows)) text += std::to_string(run) + "\n";
  return answer(text);
}

int sweep_merge(int argc, char** argv) {
  std::string place;
  bool quiet = false;
  CommandLine app{"Joins the parts that tasks have left into the table of a sweep, and writes its page.",
                  "isoscope-sweep merge"};
  app.option("FOLDER", place, "of the sweep", true);
  app.flag("--quiet", quiet, "print nothing but errors");
  app.exit_status("0 all runs are certified, 1 some are not, 2 usage, 3 no sweep, 4 some are missing.");
  app.see_also("isoscope-sweep");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  const auto plan = read_plan(Folder(place));
  if (!plan) return fail(plan.error());
  return finish_sweep(Folder(place), *plan, quiet);
}

int sweep_compare(int argc, char** argv) {
  std::string a, b, page_file;
  CommandLine app{"Tells what is worse in a sweep than in an earlier one: runs that fail, lost lines of the "
                  "certificate, a fifth more vertices, distance or time. Times count by the median of all "
                  "runs, so that another machine is no difference.",
                  "isoscope-sweep compare"};
  app.option("A", a, "the earlier sweep: its folder or its table", true);
  app.option("B", b, "the later one", true);
  app.option("--page", page_file, "write it as a page too: FILE.html");
  app.exit_status("0 nothing is worse, 1 something is, 2 usage or a file that cannot be read.");
  app.see_also("isoscope-sweep");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  const auto before = rows_of(a);
  if (!before) return fail(before.error(), 2);
  const auto now = rows_of(b);
  if (!now) return fail(now.error(), 2);
  const Comparison c = compare(*before, *now);
  std::string text = counted(c.compared, "run") + " of " + grouped(now->size()) +
                     " are in both; the later sweep took " + general(c.speed, 3) + " times as long\n";
  text += told("Worse:", c.worse) + told("Better:", c.better) + told("Also:", c.notes);
  if (Status printed = print(text); !printed) return fail(printed.error(), 2);
  if (!page_file.empty())
    if (Status written = write_text_file(page_file, comparison_page(c, a, b)); !written)
      return fail(written.error(), 2);
  return c.worse.empty() ? 0 : 1;
}

} // namespace isoscope
