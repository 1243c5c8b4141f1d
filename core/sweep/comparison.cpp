// Differences as sentences.
#include "sweep/comparison.h"

#include "base/numbers.h"
#include "base/quantiles.h"

#include <algorithm>
#include <utility>

namespace isoscope::sweep {

namespace {

constexpr double much = 1.2;
/// Seconds and vertices below which a fifth more is chance.
constexpr double least_seconds = 0.5, least_vertices = 5;

std::string name_of(const Asked& asked) {
  return asked.model + " at " + asked.tolerance + ": ";
}

std::string number(double value) {
  return general(value, 3);
}

void compare_results(const Row& before, const Row& now, Comparison& out) {
  const std::string here = name_of(now.asked);
  const std::string because = now.message.empty() ? "" : " (" + now.message + ")";
  if (before.outcome != now.outcome) {
    auto& list = now.outcome < before.outcome ? out.better : out.worse; // best first
    list.push_back(here + std::string(name(before.outcome)) + " became " + std::string(name(now.outcome)) +
                   because);
  } else if (before.exit != now.exit) {
    out.notes.push_back(here + "exit " + std::to_string(before.exit) + " became " + std::to_string(now.exit) +
                        because);
  }
  for (const auto& [line, held] : before.certificate) {
    const auto found = now.certificate.find(line);
    if (found == now.certificate.end()) continue; // the outcome tells
    if (held && !found->second) out.worse.push_back(here + "the certificate lost \"" + line + "\"");
    if (!held && found->second) out.better.push_back(here + "the certificate gained \"" + line + "\"");
  }
  if (before.exit == now.exit && before.euler_characteristic != now.euler_characteristic)
    out.notes.push_back(here + "χ " + std::to_string(before.euler_characteristic.value_or(0)) + " became " +
                        std::to_string(now.euler_characteristic.value_or(0)));
  if (before.vertices && now.vertices) {
    const auto a = static_cast<double>(*before.vertices), b = static_cast<double>(*now.vertices);
    const std::string change =
        here + std::to_string(*before.vertices) + " vertices became " + std::to_string(*now.vertices);
    if (b > much * a && b - a >= least_vertices) out.worse.push_back(change);
    if (a > much * b && a - b >= least_vertices) out.better.push_back(change);
  }
  if (before.covers && now.covers && *now.covers > much * *before.covers && *now.covers > 1)
    out.worse.push_back(here + "the input was " + number(*before.covers) + " δ away and is " +
                        number(*now.covers) + " δ");
}

} // namespace

Comparison compare(const std::vector<Row>& old_rows, const std::vector<Row>& new_rows) {
  std::map<Asked, const Row*> before;
  for (const Row& row : old_rows) before[row.asked] = &row;
  std::vector<std::pair<const Row*, const Row*>> pairs;
  Comparison out;
  for (const Row& row : new_rows) {
    const auto found = before.find(row.asked);
    if (found == before.end())
      out.notes.push_back(name_of(row.asked) + "is not in the old table");
    else
      pairs.emplace_back(found->second, &row);
  }
  out.compared = pairs.size();
  std::vector<double> ratios;
  for (const auto& [a, b] : pairs)
    if (a->exit == b->exit && a->seconds > least_seconds && b->seconds > 0)
      ratios.push_back(b->seconds / a->seconds);
  out.speed = ratios.empty() ? 1 : upper_median(std::move(ratios));
  for (const auto& [a, b] : pairs) {
    compare_results(*a, *b, out);
    if (a->vertices.value_or(0) > 0 && b->vertices.value_or(0) > 0) {
      out.vertices.push_back(static_cast<double>(*b->vertices) / static_cast<double>(*a->vertices));
      if (a->seconds > 0 && b->seconds > 0) out.seconds.push_back(b->seconds / a->seconds);
    }
    const double fair = a->seconds * out.speed;
    if (a->exit == b->exit && b->seconds > much * fair && b->seconds - fair > least_seconds)
      out.worse.push_back(name_of(b->asked) + number(fair) + " CPU seconds became " + number(b->seconds) +
                          ", as this machine counts them");
  }
  return out;
}

} // namespace isoscope::sweep
