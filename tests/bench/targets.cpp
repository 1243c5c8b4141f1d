// Each target is a function of the rows of its models.
#include "bench/targets.h"

#include "base/scramble.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <span>

namespace isoscope::bench {

namespace {

enum class Measure {
  vertices,     ///< ours over theirs, both summed
  optimum,      ///< ours over the optimum, the mean
  cpu,          ///< CPU time over theirs, the median
  envelope_cpu, ///< the same over that within the envelope
  speed_up,     ///< of the improver on two threads, the median
  dearer,       ///< CPU time over that at the next smaller tolerance of the same model, at worst
  cpu_seconds   ///< CPU time, the median
};

struct TargetLine {
  const char* what;
  Measure measure;
  std::span<const char* const> models; ///< none: spheres for the optimum, else all
  std::span<const double> percents;    ///< of the longest edge
  double floor, goal;
};

constexpr std::array free_form{"elephant", "cow", "camel", "armadillo", "homer", "bones", "boeing"};
constexpr std::array mixed{"elephant", "cow", "turbine", "fandisk", "joint", "anchor", "oblong", "u"};
constexpr std::array fine{"armadillo"};
constexpr std::array one{1.0};
constexpr std::array below_one{0.4, 0.8};
constexpr std::array to_one{0.4, 0.8, 1.0};
constexpr std::array finest{0.1};
constexpr std::array lines{
    TargetLine{"vertices / LT, all of closed models at 1 %", Measure::vertices, {}, one, 0.62, 0.58},
    TargetLine{"vertices / LT, all of free-form models at 1 %", Measure::vertices, free_form, one, 0.54, 0.5},
    TargetLine{"vertices / optimum, spheres at .01, .02, .04 r", Measure::optimum, {}, {}, 1.15, 1.1},
    TargetLine{"CPU / LT, median of eight models at 1 %", Measure::cpu, mixed, one, 15, 8},
    TargetLine{"CPU / LT, median of free-form at .4, .8 %", Measure::cpu, free_form, below_one, 10, 5},
    TargetLine{"CPU / envelope, median of free-form to 1 %", Measure::envelope_cpu, free_form, to_one, 1,
               0.5},
    TargetLine{"improver, times faster on 2 threads", Measure::speed_up, free_form, to_one, 1.7, 1.9},
    TargetLine{"CPU / CPU at less δ, worst of free-form", Measure::dearer, free_form, to_one, 1, 0.8},
    TargetLine{"CPU seconds, armadillo at .1 %", Measure::cpu_seconds, fine, finest, 200, 100},
};

/// Whether anything can be taken from the input, so that counts tell something.
bool can_shrink(const Row& row) {
  const Outcome& theirs = row.lindstrom_turk.outcome;
  return theirs.good && theirs.vertices < theirs.given;
}

bool belongs(const Row& row, const TargetLine& line) {
  if (line.measure == Measure::optimum) return row.asked.optimum.has_value();
  const bool at = std::any_of(line.percents.begin(), line.percents.end(), [&](double percent) {
    return row.asked.tolerance == Tolerance{percent, true};
  });
  if (line.models.empty()) return at && row.asked.of_all && can_shrink(row);
  if (line.measure == Measure::envelope_cpu && !row.envelope) return false;
  if (line.measure == Measure::speed_up && !row.on_two) return false;
  return at && std::any_of(line.models.begin(), line.models.end(),
                           [&](const char* model) { return row.asked.model == model; });
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The value over that of the row of the same model at the next smaller tolerance; none for the smallest.
std::vector<double> ratios_to_smaller_tolerances(const std::vector<const Row*>& rows) {
  std::map<std::string, std::map<double, double>> cpu;
  for (const Row* row : rows) cpu[row->asked.model][row->asked.tolerance.value] = row->ours.cpu_seconds;
  std::vector<double> ratios;
  for (const auto& [model, of_model] : cpu)
    for (auto at = of_model.begin(); at != of_model.end(); ++at)
      if (const auto next = std::next(at); next != of_model.end())
        ratios.push_back(next->second / at->second);
  return ratios;
}

/// Nothing without rows.
std::optional<double> value_of(Measure measure, const std::vector<const Row*>& rows) {
  std::vector<double> values, theirs;
  const auto add = [&](const std::optional<double>& value) {
    if (value) values.push_back(*value);
  };
  if (measure == Measure::dearer) values = ratios_to_smaller_tolerances(rows);
  for (const Row* row : rows) {
    const auto vertices = static_cast<double>(row->ours.outcome.vertices);
    switch (measure) {
    case Measure::vertices:
      add(vertices);
      theirs.push_back(static_cast<double>(row->lindstrom_turk.outcome.vertices));
      break;
    case Measure::optimum:
      add(vertices / *row->asked.optimum);
      break;
    case Measure::cpu:
      add(row->cpu_ratio());
      break;
    case Measure::envelope_cpu:
      add(row->envelope_cpu_ratio());
      break;
    case Measure::speed_up:
      add(row->speed_up());
      break;
    case Measure::cpu_seconds:
      add(row->ours.cpu_seconds);
      break;
    case Measure::dearer:
      break;
    }
  }
  if (values.empty()) return {};
  if (measure == Measure::vertices) return sum(values) / sum(theirs);
  if (measure == Measure::optimum) return sum(values) / static_cast<double>(values.size());
  if (measure == Measure::dearer) return *std::max_element(values.begin(), values.end());
  return median(values);
}

int digits_of(Measure measure) {
  switch (measure) {
  case Measure::vertices:
  case Measure::optimum:
    return 3;
  case Measure::speed_up:
  case Measure::dearer:
    return 2;
  default:
    return 1;
  }
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
  if (asked == 0) return {};
  std::vector<double> values;
  for (const auto& [seed, of_seed] : by_seed)
    if (const auto value = value_of(line.measure, of_seed)) values.push_back(*value);
  const int digits = digits_of(line.measure);
  std::string now = "-";
  if (!values.empty()) {
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), values.size() > 1 ? "%.*f (%.*f to %.*f)" : "%.*f", digits,
                  sum(values) / static_cast<double>(values.size()), digits, *least, digits, *largest);
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

std::vector<Case> cases_of_targets(bool complete) {
  std::vector<Case> cases;
  const auto has = [&](const std::string& model, double percent) {
    return std::any_of(cases.begin(), cases.end(), [&](const Case& c) {
      return c.model == model && c.tolerance == Tolerance{percent, true};
    });
  };
  for (const TargetLine& line : lines)
    for (const char* model : line.models)
      for (const double percent : line.percents) {
        if (has(model, percent) || (percent != one[0] && !complete)) continue;
        for (Case& c : installed_cases(std::string(model) + ".off", {percent, true}))
          cases.push_back(std::move(c));
      }
  for (Case& c : sphere_cases()) cases.push_back(std::move(c));
  if (!complete) return cases;
  for (Case& c : cases) c.of_all = c.tolerance == Tolerance{one[0], true};
  for (Case& c : closed_demo_cases({{one[0], true}})) {
    if (has(c.model, one[0])) continue;
    c.of_all = true;
    cases.push_back(std::move(c));
  }
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
