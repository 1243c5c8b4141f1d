// A thread a run at a time; the table is the only thing that they share.
#include "sweep/work.h"

#include "sweep/mesh_picture.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace isoscope::sweep {

namespace {

namespace fs = std::filesystem;

std::map<Asked, std::size_t> numbers_of(const Plan& plan) {
  std::map<Asked, std::size_t> numbers;
  for (std::size_t run = 0; run < plan.runs(); ++run) numbers.emplace(plan.asked(run), run);
  return numbers;
}

/// The first row of a run counts.
Status take_rows(const fs::path& table, const std::map<Asked, std::size_t>& numbers,
                 std::map<std::size_t, Row>& rows) {
  std::error_code failure;
  if (!fs::exists(table, failure)) return {};
  auto read = read_table(table);
  if (!read) return read.error();
  for (Row& row : *read)
    if (const auto found = numbers.find(row.asked); found != numbers.end())
      rows.emplace(found->second, std::move(row));
  return {};
}

std::vector<fs::path> parts_of(const Folder& folder) {
  std::error_code failure;
  std::vector<fs::path> parts;
  for (const auto& entry : fs::directory_iterator(folder.parts(), failure))
    if (entry.path().extension() == ".jsonl") parts.push_back(entry.path());
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// The row of a run with its mesh and its picture; nothing where it was abandoned.
std::optional<Row> do_run(const Folder& folder, const Plan& plan, std::size_t run, const fs::path& program,
                          const RunControl& control) {
  const std::string output = plan.output(run);
  RunCall call{program, plan.model(run).path, plan.options, folder.path() / output, folder.report(run)};
  auto row = run_one(call, plan.asked(run), plan.limits, control);
  if (!row) return row;
  std::error_code failure;
  if (fs::exists(call.mesh, failure)) row->output = output;
  draw_result(row->output.empty() ? fs::path(call.model) : call.mesh, !row->output.empty(),
              folder.picture(run));
  return row;
}

} // namespace

Result<std::map<std::size_t, Row>> gather_rows(const Folder& folder, const Plan& plan) {
  std::map<std::size_t, Row> rows;
  const auto numbers = numbers_of(plan);
  if (Status taken = take_rows(folder.table(), numbers, rows); !taken) return taken.error();
  for (const fs::path& part : parts_of(folder))
    if (Status taken = take_rows(part, numbers, rows); !taken) return taken.error();
  return rows;
}

Result<std::map<std::size_t, Row>> rows_with_part(const Folder& folder, const Plan& plan, std::size_t part) {
  std::map<std::size_t, Row> rows;
  const auto numbers = numbers_of(plan);
  if (Status taken = take_rows(folder.table(), numbers, rows); !taken) return taken.error();
  if (Status taken = take_rows(folder.part(part), numbers, rows); !taken) return taken.error();
  return rows;
}

std::vector<std::size_t> missing_runs(const Plan& plan, const std::map<std::size_t, Row>& rows) {
  std::vector<std::size_t> missing;
  for (std::size_t run = 0; run < plan.runs(); ++run)
    if (!rows.contains(run)) missing.push_back(run);
  return missing;
}

Status do_runs(const Folder& folder, const Plan& plan, const std::vector<std::size_t>& runs,
               const fs::path& table, const Doing& doing, const RunControl& control) {
  if (runs.empty()) return {};
  auto opened = GrowingTable::open(table);
  if (!opened) return opened.error();
  std::mutex mutex;
  Status failed;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> over{false};
  const auto worker = [&] {
    for (std::size_t i = next++; i < runs.size() && !over && !control.cancelled(); i = next++) {
      const auto row = do_run(folder, plan, runs[i], doing.program, control);
      if (!row) break;
      const std::lock_guard lock(mutex);
      if (Status appended = opened->append(*row); !appended) {
        failed = appended;
        over = true;
        break;
      }
      if (doing.done) doing.done(runs[i], *row);
    }
  };
  std::vector<std::thread> workers;
  const std::size_t count = std::min<std::size_t>(std::max(1u, doing.jobs), runs.size());
  for (std::size_t k = 0; k < count; ++k) workers.emplace_back(worker);
  for (std::thread& t : workers) t.join();
  return failed;
}

Result<std::map<std::size_t, Row>> merge(const Folder& folder, const Plan& plan) {
  // Held while they are joined: whoever still appends to one is told of, and nobody does so behind our back.
  const std::vector<fs::path> parts = parts_of(folder);
  std::vector<GrowingTable> held;
  std::vector<fs::path> tables{folder.table()};
  tables.insert(tables.end(), parts.begin(), parts.end());
  for (const fs::path& table : tables) {
    auto opened = GrowingTable::open(table);
    if (!opened) return opened.error();
    held.push_back(std::move(*opened));
  }
  auto rows = gather_rows(folder, plan);
  if (!rows) return rows;
  std::vector<Row> ordered;
  for (const auto& [run, row] : *rows) ordered.push_back(row);
  if (Status written = write_table(folder.table(), ordered); !written) return written.error();
  std::error_code ignored;
  for (const fs::path& part : parts) fs::remove(part, ignored);
  return rows;
}

} // namespace isoscope::sweep
