// Runs isoscope-run on many models at many tolerances, on this machine or as a job array: a row a run, one
// page at the end.
#include "base/field_options.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/interruptible.h"
#include "cli/passed_options.h"
#include "cli/sweep_verbs.h"
#include "improve/improver.h"
#include "run/report.h"
#include "sweep/slurm.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace {

using namespace isoscope;
using namespace isoscope::sweep;

const Verb verbs[] = {
    {{"step", "FOLDER --run K", "does one run, or every so many"}, sweep_step},
    {{"missing", "FOLDER", "prints the numbers of runs without a row"}, sweep_missing},
    {{"merge", "FOLDER", "joins what tasks have done and writes the page"}, sweep_merge},
    {{"compare", "A B", "tells what is worse in a later sweep"}, sweep_compare},
};

struct Asks {
  std::vector<std::string> models, slurm_options;
  std::string tolerances, folder, program = run_program().string();
  unsigned jobs = 0, tasks = 1000;
  double cpu_limit = Limits{}.cpu_seconds, memory_cap = 0;
  bool slurm = false, plan_only = false, quiet = false;
};

/// "1%,0.3%": each must be a tolerance.
Result<std::vector<std::string>> tolerances_of(const std::string& text) {
  RunParameters parameters;
  const auto options = field_options(parameters);
  const auto option = std::find_if(options.begin(), options.end(),
                                   [](const FieldOption& o) { return o.name == "--tolerance"; });
  const auto& judge = std::get<FieldOption::Take<std::string>>(option->take);
  std::vector<std::string> found;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    found.push_back(text.substr(at, end - at));
    at = end + 1;
    if (Status read = judge(found.back()); !read) return read.error();
    if (Status valid = check(parameters); !valid) return valid.error();
    if (std::count(found.begin(), found.end(), found.back()) > 1)
      return Error{ErrorCode::usage, "--tolerance has " + found.back() + " twice.", "Give each once."};
  }
  return found;
}

/// What is asked, or the plan that the folder has where nothing is.
Result<Plan> plan_of(const Asks& asks, const PassedOptions& passed, const CommandLine& app) {
  if (asks.models.empty()) {
    for (const char* option : {"--tolerance", "--cpu-limit", "--memory-cap"})
      if (app.given(option))
        return Error{ErrorCode::usage, std::string(option) + " is given, but no models.",
                     "Give models to begin a sweep; -o alone goes on with one."};
    return read_plan(Folder(asks.folder));
  }
  if (asks.tolerances.empty())
    return Error{ErrorCode::usage, "--tolerance is missing.", "Give one or several: --tolerance 1%,0.3%"};
  auto tolerances = tolerances_of(asks.tolerances);
  if (!tolerances) return tolerances.error();
  auto words = passed.words();
  if (!words) return words.error();
  if (passed.parameters().effort == endless_effort && passed.parameters().time_limit == 0)
    return Error{ErrorCode::usage, "--effort 3 improves without end.", "Give a --time-limit for each run."};
  auto models = find_models(asks.models);
  if (!models) return models.error();
  Plan plan{std::move(*models), std::move(*tolerances), std::move(*words), {asks.cpu_limit, asks.memory_cap}};
  // Runs side by side use the cores better than threads of one.
  if (!app.given("--threads")) plan.options.insert(plan.options.end(), {"--threads", "1"});
  if (Status written = write_plan(Folder(asks.folder), plan); !written) return written.error();
  return plan;
}

/// Of one run, as its plan says.
unsigned threads_of(const Plan& plan) {
  const auto at = std::find(plan.options.begin(), plan.options.end(), "--threads");
  const auto given = at != plan.options.end() && at + 1 != plan.options.end()
                         ? read_number<unsigned>(*(at + 1))
                         : std::nullopt;
  return given.value_or(0) > 0 ? *given : hardware_threads();
}

int submit_array(const Asks& asks, const Folder& folder, const Plan& plan) {
  const auto rows = merge(folder, plan);
  if (!rows) return fail(rows.error());
  const std::vector<std::size_t> missing = missing_runs(plan, *rows);
  if (missing.empty()) return finish_sweep(folder, plan, asks.quiet);
  const auto job = submit(folder, plan, {missing, asks.tasks, threads_of(plan), asks.slurm_options},
                          own_program().string());
  if (!job) return fail(job.error(), 1);
  if (asks.quiet) return 0;
  return answer("Submitted as job " + *job + ": " + counted(missing.size(), "run") + ". The page will be " +
                folder.page().string() + "\n");
}

int run_here(const Asks& asks, const Folder& folder, const Plan& plan) {
  const auto before = gather_rows(folder, plan);
  if (!before) return fail(before.error());
  const std::vector<std::size_t> missing = missing_runs(plan, *before);
  std::size_t done = before->size();
  RunControl control;
  const Interruptible signals(control);
  const unsigned jobs = asks.jobs > 0 ? asks.jobs : std::max(1u, hardware_threads() / threads_of(plan));
  const Doing doing{
      asks.program, jobs, [&](std::size_t, const Row& row) {
        ++done;
        if (asks.quiet) return;
        std::fprintf(stderr, "%zu/%zu  %s  %s  %s%s  %.1f s\n", done, plan.runs(), row.asked.model.c_str(),
                     row.asked.tolerance.c_str(), std::string(name(row.outcome)).c_str(),
                     row.vertices ? ("  " + counted(*row.vertices, "vertex", "vertices")).c_str() : "",
                     row.seconds);
      }};
  if (Status did = do_runs(folder, plan, missing, folder.table(), doing, control); !did)
    return fail(did.error(), 1);
  return finish_sweep(folder, plan, asks.quiet);
}

int run(int argc, char** argv) {
  Asks asks;
  CommandLine app{
      "Runs isoscope-run on many models at many tolerances: a process and a line of a table a run, and "
      "one page at the end, with a picture of each result. A sweep that was stopped goes on where it "
      "was.",
      "isoscope-sweep"};
  app.option(
      "MODELS", asks.models,
      "a folder of models, a list of them (a text file, one a line), or models; none to go on with a sweep");
  app.option("--tolerance", asks.tolerances, "δ, one or several: 1%,0.3%");
  app.option("-o,--output", asks.folder, "the folder of the sweep", true);
  app.option("--jobs", asks.jobs, "runs at a time; default as many as there are cores");
  app.option("--cpu-limit", asks.cpu_limit, "CPU seconds after which a run is killed; default 3600", 1, 1e7);
  app.option("--memory-cap", asks.memory_cap, "MiB of address space for a run; default 0, no limit", 0, 1e9);
  app.option("--program", asks.program, "the isoscope-run to try; default the one beside this program");
  app.flag("--plan", asks.plan_only, "make the folder with its list of runs, and print how many there are");
  app.flag("--slurm", asks.slurm, "submit the runs as a job array, and a job behind it that writes the page");
  app.option("--slurm-tasks", asks.tasks,
             "tasks of the array at most, each with its share of the runs; default 1000");
  app.option("--slurm-option", asks.slurm_options,
             "for sbatch, such as --slurm-option=--partition=long; repeatable");
  app.flag("--quiet", asks.quiet, "print nothing but errors");
  const PassedOptions passed(app, {"INPUT", "--tolerance", "--inside", "--levels", "--label"});
  app.version("isoscope-sweep " + std::string(version()));
  for (const Verb& verb : verbs) app.verb(verb.told);
  app.notes(
      "The folder holds runs.jsonl, a line a run; index.html, the page; the meshes below the name of their "
      "tolerance; and sweep.json, the list of runs.\n\n"
      "On machines that share the folder, without Slurm: isoscope-sweep MODELS --tolerance 1% -o FOLDER "
      "--plan, "
      "then isoscope-sweep missing FOLDER | parallel isoscope-sweep step FOLDER --run {}, then "
      "isoscope-sweep "
      "merge FOLDER.");
  app.exit_status(
      "0 all runs are certified, or they were submitted; 1 some are not; 2 usage; 3 no models or no "
      "sweep; 4 interrupted.");
  app.see_also("isoscope-run");
  if (const auto status = run_verb(verbs, argc, argv)) return *status;
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  if (Status there = check_program(asks.program); !there) return fail(there.error());
  const auto plan = plan_of(asks, passed, app);
  if (!plan) return fail(plan.error());
  const Folder folder(asks.folder);
  if (asks.plan_only) return answer(std::to_string(plan->runs()) + "\n");
  return asks.slurm ? submit_array(asks, folder, *plan) : run_here(asks, folder, *plan);
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "isoscope-sweep: internal error: %s\n", e.what());
  }
  return 1;
}
