// Each target is a function of the rows of its models.
#include "bench/targets.h"

#include "base/scramble.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <optional>
#include <span>

namespace isoscope::bench {

namespace {

enum class Measure {
  vertices, ///< ours over theirs, both summed
  optimum,  ///< ours over the optimum, the mean
  cpu       ///< CPU time over theirs, the median
};

struct TargetLine {
  const char* what;
  Measure measure;
  std::span<const char* const> models; ///< at 1 %; none: spheres
  double floor, goal;
};

constexpr std::array free_form{"elephant", "cow", "camel", "armadillo", "homer", "bones", "boeing"};
constexpr std::array mixed{"elephant", "cow", "turbine", "fandisk", "joint", "anchor", "oblong", "u"};
constexpr std::array lines{
    TargetLine{"vertices / LT, all of free-form models at 1 %", Measure::vertices, free_form, 0.54, 0.5},
    TargetLine{"vertices / optimum, spheres at .01, .02, .04 r", Measure::optimum, {}, 1.15, 1.1},
    TargetLine{"CPU / LT, median of eight models at 1 %", Measure::cpu, mixed, 15, 8},
};
constexpr double percent = 1;

bool belongs(const Row& row, const TargetLine& line) {
  if (line.measure == Measure::optimum) return row.asked.optimum.has_value();
  return row.asked.tolerance == Tolerance{percent, true} &&
         std::any_of(line.models.begin(), line.models.end(),
                     [&](const char* model) { return row.asked.model == model; });
}

/// Nothing without rows.
std::optional<double> value_of(Measure measure, const std::vector<const Row*>& rows) {
  std::vector<double> cpu;
  double ours = 0, theirs = 0, over_optimum = 0;
  if (rows.empty()) return {};
  for (const Row* row : rows) {
    const auto vertices = static_cast<double>(row->ours.outcome.vertices);
    ours += vertices;
    theirs += static_cast<double>(row->lindstrom_turk.outcome.vertices);
    if (row->asked.optimum) over_optimum += vertices / *row->asked.optimum;
    if (const auto ratio = row->cpu_ratio()) cpu.push_back(*ratio);
  }
  switch (measure) {
  case Measure::vertices:
    return theirs > 0 ? std::optional(ours / theirs) : std::nullopt;
  case Measure::optimum:
    return over_optimum / static_cast<double>(rows.size());
  case Measure::cpu:
    return cpu.empty() ? std::nullopt : std::optional(median(cpu));
  }
  return {};
}

std::string text_of(const TargetLine& line, const std::vector<Row>& rows, bool markdown) {
  std::map<std::uint32_t, std::vector<const Row*>> by_seed;
  std::size_t asked = 0, counted = 0;
  for (const Row& row : rows) {
    if (!belongs(row, line)) continue;
    ++asked;
    if (!row.ours.outcome.good) continue;
    ++counted;
    by_seed[row.seed].push_back(&row);
  }
  std::vector<double> values;
  for (const auto& [seed, of_seed] : by_seed)
    if (const auto value = value_of(line.measure, of_seed)) values.push_back(*value);
  const int digits = line.measure == Measure::cpu ? 1 : 3;
  std::string now = "-";
  if (!values.empty()) {
    double sum = 0;
    for (const double v : values) sum += v;
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), values.size() > 1 ? "%.*f (%.*f to %.*f)" : "%.*f", digits,
                  sum / static_cast<double>(values.size()), digits, *least, digits, *largest);
    now = text.data();
  }
  const std::string of = std::to_string(counted) + " of " + std::to_string(asked);
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                markdown ? "| %s | %s | %s | %g | %g |\n" : "%-48s %-24s %10s %6g %6g\n", line.what,
                now.c_str(), of.c_str(), line.floor, line.goal);
  return text.data();
}

} // namespace

std::vector<Case> cases_of_targets() {
  std::vector<std::string> models;
  for (const TargetLine& line : lines)
    for (const char* model : line.models)
      if (std::find(models.begin(), models.end(), model) == models.end()) models.emplace_back(model);
  std::vector<Case> cases;
  for (const std::string& model : models)
    for (Case& c : installed_cases(model + ".off", {percent, true})) cases.push_back(std::move(c));
  for (Case& c : sphere_cases()) cases.push_back(std::move(c));
  return cases;
}

TriangleSoup nudged(TriangleSoup soup, double delta, std::uint32_t seed) {
  if (seed == 0) return soup;
  Vec3 by;
  for (std::size_t axis = 0; axis < 3; ++axis)
    by[axis] = delta * static_cast<double>(scrambled(3 * std::uint64_t{seed} + axis) >> 11) * 0x1p-53;
  for (Vec3& p : soup.points) p += by;
  return soup;
}

std::string target_table(const std::vector<Row>& rows, bool markdown) {
  std::string text;
  if (markdown) {
    text = "| target | now | certified | floor | goal |\n| --- | --: | --: | --: | --: |\n";
  } else {
    std::array<char, 200> head{};
    std::snprintf(head.data(), head.size(), "%-48s %-24s %10s %6s %6s\n", "target", "now", "certified",
                  "floor", "goal");
    text = head.data();
  }
  for (const TargetLine& line : lines) text += text_of(line, rows, markdown);
  return text;
}

} // namespace isoscope::bench
