// isoscope-corpus: all models of libcgal-demo at several tolerances, compared with the table of the last
// time.
#include "corpus/corpus_run.h"
#include "corpus/corpus_table.h"
#include "support/models.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <thread>

#include <unistd.h>

using namespace isoscope;
using namespace isoscope::corpus;

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> models; ///< parts of file names; empty: all
  std::vector<std::string> tolerances{"8%", "3%", "1%", "0.3%"};
  int effort = 0;
  unsigned jobs = 1;
  Limits limits;
  fs::path program, table, output, folder;
  bool go_on = false;
};

struct Work {
  fs::path model;
  Asked asked;
};

int fail(const Error& error) {
  std::fprintf(stderr, "isoscope-corpus: %s\n", error.line().c_str());
  return 2;
}

std::vector<Work> work_of(const Options& options) {
  std::vector<fs::path> models = demo_models();
  if (!options.folder.empty()) {
    models.clear();
    for (const auto& entry : fs::directory_iterator(options.folder))
      if (entry.is_regular_file()) models.push_back(entry.path());
    std::sort(models.begin(), models.end());
  }
  std::vector<Work> work;
  for (const fs::path& model : models) {
    const std::string name = model.filename().string();
    const auto is_part = [&](const std::string& part) { return name.find(part) != std::string::npos; };
    if (!options.models.empty() && std::none_of(options.models.begin(), options.models.end(), is_part))
      continue;
    for (const std::string& tolerance : options.tolerances)
      work.push_back({model, {name, tolerance, options.effort}});
  }
  return work;
}

/// Runs everything that `rows` does not have yet, several at a time, and adds it; each row is printed and
/// appended to the output as soon as it is there.
void run_all(const Options& options, const std::vector<Work>& work, std::vector<Row>& rows) {
  std::string scratch = (fs::temp_directory_path() / "isoscope-corpus-XXXXXX").string();
  if (::mkdtemp(scratch.data()) == nullptr) return;
  std::FILE* const out = options.output.empty() ? nullptr : std::fopen(options.output.c_str(), "a");
  std::mutex mutex;
  std::atomic<std::size_t> next{0};
  const std::vector<Row> known = rows;
  const auto worker = [&] {
    for (std::size_t i = next++; i < work.size(); i = next++) {
      const auto is_this = [&](const Row& row) { return row.asked == work[i].asked; };
      if (std::any_of(known.begin(), known.end(), is_this)) continue;
      const Row row = run_one(options.program, work[i].model, work[i].asked, options.limits, scratch);
      const std::string line = json_line(row);
      const std::lock_guard lock(mutex);
      rows.push_back(row);
      std::printf("%s\n", line.c_str());
      std::fflush(stdout);
      if (out == nullptr) continue;
      std::fprintf(out, "%s\n", line.c_str());
      std::fflush(out);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned k = 0; k < std::max(1u, options.jobs); ++k) workers.emplace_back(worker);
  for (std::thread& t : workers) t.join();
  if (out != nullptr) std::fclose(out);
  std::error_code ignored;
  fs::remove_all(scratch, ignored);
}

void tell(const char* heading, const std::vector<std::string>& sentences) {
  if (!sentences.empty()) std::printf("%s\n", heading);
  for (const std::string& s : sentences) std::printf("  %s\n", s.c_str());
}

int run(const Options& options) {
  const std::vector<Work> work = work_of(options);
  if (work.empty()) {
    std::printf("Nothing to do: no model fits, or libcgal-demo is not installed.\n");
    return 0;
  }
  std::vector<Row> rows;
  if (options.go_on && fs::exists(options.output)) {
    auto before = read_table(options.output);
    if (!before) return fail(before.error());
    rows = std::move(*before);
  } else if (!options.output.empty()) {
    if (Status fresh = write_table(options.output, {}); !fresh) return fail(fresh.error());
  }
  run_all(options, work, rows);
  if (!options.output.empty())
    if (Status written = write_table(options.output, rows); !written) return fail(written.error());
  double seconds = 0;
  std::size_t certified = 0;
  for (const Row& row : rows) {
    seconds += row.seconds;
    certified += row.exit == 0 ? 1 : 0;
  }
  std::printf("%zu runs, %zu certified, %.0f CPU seconds\n", rows.size(), certified, seconds);
  if (options.table.empty()) return 0;
  const auto before = read_table(options.table);
  if (!before) return fail(before.error());
  const Comparison c = compare(*before, rows);
  std::printf("%zu of them are in %s; this machine takes %.2f times as long\n", c.compared,
              options.table.filename().c_str(), c.speed);
  tell("Worse:", c.worse);
  tell("Better:", c.better);
  tell("Also:", c.notes);
  return c.worse.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  Options options;
  options.program = ISOSCOPE_RUN_PROGRAM;
  options.table = ISOSCOPE_CORPUS_TABLE;
  CLI::App app(
      "Runs isoscope-run on all models of libcgal-demo, a process and a JSON line a run, and compares them "
      "with the table of the last time.");
  app.add_option("models", options.models, "parts of file names; all without any");
  app.add_option("--folder", options.folder, "models from here instead")->check(CLI::ExistingDirectory);
  app.add_option("--tolerances", options.tolerances, "for each model")->delimiter(',')->capture_default_str();
  app.add_option("--effort", options.effort, "of the improver; rows of another effort are not compared")
      ->check(CLI::Range(0, 3))
      ->capture_default_str();
  app.add_option("--jobs", options.jobs, "runs at a time, of one thread each")
      ->check(CLI::Range(1u, 256u))
      ->capture_default_str();
  app.add_option("--cpu-limit", options.limits.cpu_seconds, "CPU seconds after which a run counts as endless")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str();
  app.add_option("--memory-limit", options.limits.memory_mb, "MB of address space for a run; 0: no limit")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  app.add_option("--program", options.program, "the isoscope-run to try")->check(CLI::ExistingFile);
  app.add_option("--table", options.table, "what to compare with; empty: nothing")->capture_default_str();
  app.add_option("-o,--output", options.output, "the new table");
  app.add_flag("--go-on", options.go_on, "keep the rows that the new table has already");
  app.footer("Exit status: 0 nothing is worse, 1 something is, 2 usage.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return run(options);
}
