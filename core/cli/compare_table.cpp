// The table's text: columns of fixed width, lists by descending counts.
#include "cli/compare_table.h"

#include "cli/progress_line.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <utility>

namespace isoscope {

namespace {

std::string row(const char* stage, const std::string& operations, const std::string& vertices,
                const std::string& seconds, const std::string& per_operation, const std::string& rejected) {
  char text[160];
  std::snprintf(text, sizeof text, "%-13s %11s %14s %10s %14s %11s\n", stage, operations.c_str(),
                vertices.c_str(), seconds.c_str(), per_operation.c_str(), rejected.c_str());
  return text;
}

std::string figures(const char* stage, const StageStatistics& s) {
  const std::string per_operation = s.operations > 0 ? fixed(1e3 * s.seconds_per_operation(), 3) : "-";
  return row(stage, grouped(s.operations), grouped(s.zero_set_vertices), fixed(s.seconds, 2), per_operation,
             grouped(s.rejections()));
}

/// "link-condition 2, kernel-empty 1", the most frequent first.
std::string ranking(const StageStatistics::ReasonCounts& counts) {
  std::vector<std::pair<std::size_t, Reason>> ranked;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) ranked.emplace_back(counts[i], static_cast<Reason>(i));
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [count, reason] : ranked)
    text += (text.empty() ? "" : ", ") + std::string(name(reason)) + " " + grouped(count);
  return text;
}

std::string repairs(const StageStatistics& s) {
  if (s.relaxations + s.repairs + s.failed_repairs == 0) return {};
  const std::string shaken = s.shakes > 0 ? ", shaken " + grouped(s.shakes) + " times" : "";
  return "relaxation sweeps " + grouped(s.relaxations) + shaken + ", made " + grouped(s.repairs) + " in " +
         grouped(s.repair_sweeps) + " sweeps, rolled back " + grouped(s.failed_repairs) + " in " +
         grouped(s.failed_repair_sweeps) + " sweeps";
}

/// A heading and a line for each stage that has something to say; nothing when none has.
std::string section(const char* heading, const std::vector<StageStatistics>& stages,
                    const std::function<std::string(const StageStatistics&)>& words) {
  std::string lines;
  for (const StageStatistics& s : stages) {
    const std::string text = words(s);
    if (text.empty()) continue;
    std::string stage(name(s.stage));
    stage.resize(12, ' ');
    lines += "  " + stage + text + "\n";
  }
  return lines.empty() ? lines : std::string("\n") + heading + "\n" + lines;
}

} // namespace

std::string compare_table(const std::vector<StageStatistics>& stages) {
  std::string text = row("Stage", "Operations", "Vertices of Z", "Seconds", "ms/operation", "Rejected");
  StageStatistics total;
  for (const StageStatistics& s : stages) {
    text += figures(std::string(name(s.stage)).c_str(), s);
    total.operations += s.operations;
    total.seconds += s.seconds;
    total.zero_set_vertices = s.zero_set_vertices;
    for (std::size_t i = 0; i < s.rejected.size(); ++i) total.rejected[i] += s.rejected[i];
  }
  text += figures("total", total);
  text +=
      section("Rejected, by reason", stages, [](const StageStatistics& s) { return ranking(s.rejected); });
  text += section("Targets, by what found them", stages,
                  [](const StageStatistics& s) { return ranking(s.found); });
  text += section("Repairs", stages, repairs);
  return text;
}

} // namespace isoscope
