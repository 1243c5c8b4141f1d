// The bench: our pipeline and Lindstrom–Turk side by side, each line in processes of its own.
#include "base/field_options.h"
#include "base/parallel.h"
#include "bench/cases.h"
#include "bench/lindstrom_turk.h"
#include "bench/measure.h"
#include "bench/table.h"
#include "bench/targets.h"
#include "run/complete_run.h"
#include "run/statistics.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace isoscope;
using namespace isoscope::bench;

/// What the command line asks for.
struct Options {
  std::string model;
  std::vector<std::string> tolerances;
  bool quick = false, complete = false, all = false, open = false, targets = false, cores = false;
  bool markdown = false, envelope = false, no_normals = false;
  std::string effort, start, cover; ///< of ours; empty: by default
  RunParameters ours;               ///< what they come to
  unsigned threads = 0, seeds = 1;
  double time_limit = 0, kill_after = 3600;
};

Outcome run_ours(const Case& asked, std::uint32_t seed, const Options& options, unsigned threads_at_most) {
  const ThreadLimit threads(threads_at_most);
  RunParameters parameters = options.ours;
  parameters.input = asked.model;
  parameters.tolerance = asked.tolerance;
  parameters.conditions[2] = !options.no_normals;
  parameters.time_limit = options.time_limit;
  auto soup = asked.load();
  if (!soup) return {false, 0, soup.error().message};
  const double delta = asked.tolerance.absolute(soup->bounds().longest_edge());
  const std::size_t given = soup->points.size();
  test::CompleteRun run(parameters);
  run.soup = std::make_shared<const TriangleSoup>(nudged(std::move(*soup), delta, seed));
  run.gate.decide = [&](const Journal&, const Event&) {
    return run.control.cancelled() ? Gate::Verdict::stop : Gate::Verdict::go_on;
  };
  if (!run.run()) return {false, 0, run.error->message};
  const Certificate& c = run.result->certificate;
  std::string status = c.holds() ? "certified" : "NOT certified: " + c.failures.front();
  if (run.result->end != RunResult::End::finished) status += ", at the time limit";
  double improving = 0;
  for (const StageStatistics& stage : gather_statistics(*run.journal))
    if (stage.stage == Stage::improve) improving += stage.seconds;
  return {c.holds(), run.result->mesh.points.size(), status, given, improving};
}

Outcome run_theirs(const Case& asked, CollapseFilter filter) {
  const auto soup = asked.load();
  if (!soup) return {false, 0, soup.error().message};
  const double delta = asked.tolerance.absolute(soup->bounds().longest_edge());
  const auto simplified = lindstrom_turk(*soup, delta, filter);
  if (!simplified) return {false, 0, simplified.error().message};
  return {true, simplified->mesh.points.size(), simplified->intersects_itself ? "intersects itself" : "",
          soup->points.size()};
}

Row run_case(const Case& asked, const Measured& lindstrom_turk, std::uint32_t seed, const Options& options) {
  Row row{asked, {}, lindstrom_turk, {}, seed};
  const auto ours = [&](unsigned threads) {
    return measure([&] { return run_ours(asked, seed, options, threads); }, options.kill_after);
  };
  row.ours = ours(options.cores ? 1 : options.threads);
  if (options.cores) row.on_two = ours(2);
  if (options.envelope && seed == 0)
    row.envelope = measure([&] { return run_theirs(asked, CollapseFilter::envelope); }, options.kill_after);
  return row;
}

Result<std::vector<Case>> cases_for(const Options& options) {
  std::vector<Tolerance> tolerances;
  for (const std::string& text : options.tolerances) {
    const auto tolerance = read_field<Tolerance>(field_of(&RunParameters::tolerance), "--tolerance", text);
    if (!tolerance) return tolerance.error();
    tolerances.push_back(*tolerance);
  }
  if (options.open && tolerances.empty()) tolerances = {{1, true}};
  if (tolerances.empty()) tolerances = {{0.4, true}, {1, true}, {2.5, true}};
  if (options.open) return open_demo_cases(tolerances);
  if (options.all) return demo_cases(tolerances);
  if (!options.model.empty()) return model_cases(options.model, tolerances);
  if (options.targets) return cases_of_targets(options.complete);
  return target_cases(options.quick      ? Selection::quick
                      : options.complete ? Selection::complete
                                         : Selection::standard);
}

Status read_ours(Options& options) {
  const auto take = [&](const auto& field, const std::string& text) -> Status {
    return text.empty() ? Status() : take_text(field, options.ours, text);
  };
  if (Status s = take(field_of(&RunParameters::effort), options.effort); !s) return s;
  if (Status s = take(field_of(&RunParameters::start), options.start); !s) return s;
  return take(field_of(&RunParameters::cover), options.cover);
}

int refuse(const Error& error) {
  std::fprintf(stderr, "isoscope-bench: %s\n", error.line().c_str());
  return 2;
}

int run(Options options) {
  if (Status s = read_ours(options); !s) return refuse(s.error());
  const auto cases = cases_for(options);
  if (!cases) return refuse(cases.error());
  const Table table(options.markdown);
  std::fputs(table.head().c_str(), stdout);
  std::vector<Row> rows;
  for (const Case& asked : *cases) {
    const Measured theirs =
        measure([&] { return run_theirs(asked, CollapseFilter::certificate); }, options.kill_after);
    const bool any = options.all || options.open || asked.of_all;
    if (any && !theirs.outcome.good) continue; // no oriented manifold
    for (std::uint32_t seed = 0; seed < options.seeds; ++seed) {
      rows.push_back(run_case(asked, theirs, seed, options));
      std::fputs(table.line(rows.back()).c_str(), stdout);
      std::fflush(stdout);
    }
  }
  std::fputs(table.summary(rows).c_str(), stdout);
  if (options.targets) std::fputs(("\n" + target_table(rows, options.markdown)).c_str(), stdout);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Vertices, seconds and ratios of Isoscope and of CGAL's Lindstrom–Turk edge collapse, which accepts "
      "what is certified within δ of the input.",
      "isoscope-bench"};
  Options options;
  app.add_option("MODEL", options.model,
                 "a mesh file or gallery:NAME; without it the models that have targets");
  app.add_option("TOLERANCES", options.tolerances, "percentages of the longest edge (0.6%) or lengths");
  app.add_flag("--all", options.all, "every oriented manifold of libcgal-demo, at 0.4, 1 and 2.5 %");
  app.add_flag("--open", options.open, "those of them that are open, at 1 %");
  app.add_option("--at", options.tolerances, "tolerances for --all and --open");
  app.add_flag("--targets", options.targets, "the models of the table of targets, and that table");
  app.add_option("--seeds", options.seeds,
                 "ours so many times, from the second on of an input that is nudged")
      ->check(CLI::Range(1, 100));
  app.add_flag("--quick", options.quick, "only a few models, for seconds");
  app.add_flag("--long", options.complete,
               "the longest model too; with --targets all models that these are of, an hour's work");
  app.add_flag("--cores", options.cores,
               "ours on one thread and once more on two: how much faster the improver is");
  app.add_flag("--envelope", options.envelope,
               "also Lindstrom–Turk within CGAL's polyhedral envelope (slow)");
  app.add_flag("--no-normals", options.no_normals, "ours without condition 3");
  app.add_option("--effort", options.effort, "of ours, as of a run");
  app.add_option("--start", options.start, "of ours, as of a run");
  app.add_option(
      "--cover", options.cover,
      "of ours, as of a run; off: how far the input may be from the result is bounded as little as it "
      "is of Lindstrom–Turk's");
  app.add_option("--threads", options.threads, "of ours; 0: all cores");
  app.add_option("--time-limit", options.time_limit,
                 "seconds after which ours stops with what it has; 0: none");
  app.add_option("--kill-after", options.kill_after, "seconds after which any run is given up");
  app.add_flag("--markdown", options.markdown, "a Markdown table");
  CLI11_PARSE(app, argc, argv);
  return run(options);
}
