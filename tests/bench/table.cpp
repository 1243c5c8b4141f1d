// Columns of fixed width or Markdown cells.
#include "bench/table.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace isoscope::bench {

namespace {

struct Column {
  const char* title;
  int width; ///< negative: aligned to the left
};
constexpr std::array columns{
    Column{"model", -18}, Column{"δ", -7},       Column{"ours", 7},    Column{"LT", 7},
    Column{"ratio", 6},   Column{"envelope", 9}, Column{"at most", 8}, Column{"goal", 7},
    Column{"/opt", 6},    Column{"ours s", 8},   Column{"CPU s", 8},   Column{"LT CPU s", 8},
    Column{"/LT CPU", 7}, Column{"env s", 7},    Column{"ours MB", 8}, Column{"status", -6},
};

/// Characters, not bytes: what a column's width is about.
std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string fixed(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string count(const std::optional<std::size_t>& n) {
  return n ? std::to_string(*n) : "-";
}

std::string vertices(const Measured& m) {
  return m.outcome.vertices > 0 ? std::to_string(m.outcome.vertices) : "-";
}

/// What keeps a row from being as it should: ours first, then what the others did.
std::string status(const Row& row) {
  std::string text = row.ours.outcome.status;
  if (row.asked.at_most && row.ours.outcome.good && row.ours.outcome.vertices > *row.asked.at_most)
    text += ", ABOVE THE LIMIT";
  if (!row.lindstrom_turk.outcome.status.empty()) text += "; LT " + row.lindstrom_turk.outcome.status;
  if (row.envelope && !row.envelope->outcome.status.empty())
    text += "; envelope " + row.envelope->outcome.status;
  return text;
}

} // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

std::optional<double> Row::ratio() const {
  if (!ours.outcome.good || !lindstrom_turk.outcome.good || lindstrom_turk.outcome.vertices == 0) return {};
  return static_cast<double>(ours.outcome.vertices) / static_cast<double>(lindstrom_turk.outcome.vertices);
}

std::optional<double> Row::cpu_ratio() const {
  if (!ratio() || !(lindstrom_turk.cpu_seconds > 0)) return {};
  return ours.cpu_seconds / lindstrom_turk.cpu_seconds;
}

std::optional<double> Row::envelope_cpu_ratio() const {
  if (!ours.outcome.good || !envelope || !envelope->outcome.good || !(envelope->cpu_seconds > 0)) return {};
  return ours.cpu_seconds / envelope->cpu_seconds;
}

std::optional<double> Row::speed_up() const {
  if (!ours.outcome.good || !on_two || !on_two->outcome.good || !(on_two->outcome.improving > 0)) return {};
  return ours.outcome.improving / on_two->outcome.improving;
}

std::string Table::cells(const std::vector<std::string>& texts) const {
  std::string line = markdown_ ? "|" : "";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (markdown_) {
      line += " " + texts[i] + " |";
      continue;
    }
    const auto width = static_cast<std::size_t>(std::abs(columns[i].width));
    const std::string space(width - std::min(width, length_of(texts[i])), ' ');
    if (i > 0) line += " ";
    line += columns[i].width < 0 ? texts[i] + space : space + texts[i];
  }
  return line + "\n";
}

std::string Table::head() const {
  std::vector<std::string> titles, rules;
  for (const Column& column : columns) {
    titles.emplace_back(column.title);
    rules.emplace_back(column.width < 0 ? "---" : "--:");
  }
  return cells(titles) + (markdown_ ? cells(rules) : "");
}

std::string Table::line(const Row& row) const {
  const auto ratio = row.ratio(), cpu = row.cpu_ratio();
  const auto& optimum = row.asked.optimum;
  const double ours = static_cast<double>(row.ours.outcome.vertices);
  return cells(
      {row.asked.model + (row.seed > 0 ? " #" + std::to_string(row.seed) : ""), row.asked.tolerance.text(),
       vertices(row.ours), vertices(row.lindstrom_turk), ratio ? fixed(*ratio, 3) : "-",
       row.envelope ? vertices(*row.envelope) : "-", count(row.asked.at_most), count(row.asked.goal),
       optimum && row.ours.outcome.good ? fixed(ours / *optimum, 2) : "-", fixed(row.ours.seconds, 1),
       fixed(row.ours.cpu_seconds, 1), fixed(row.lindstrom_turk.cpu_seconds, 2), cpu ? fixed(*cpu, 1) : "-",
       row.envelope ? fixed(row.envelope->seconds, 1) : "-",
       fixed(static_cast<double>(row.ours.peak_bytes) / 1e6, 0), status(row)});
}

std::string Table::summary(const std::vector<Row>& rows) const {
  std::size_t ours = 0, theirs = 0, counted = 0, failed = 0;
  const Row* worst = nullptr;
  std::vector<double> cpu_ratios;
  for (const Row& row : rows) {
    if (!row.ours.outcome.good) ++failed;
    const auto ratio = row.ratio();
    if (!ratio) continue;
    ++counted;
    if (const auto cpu = row.cpu_ratio()) cpu_ratios.push_back(*cpu);
    ours += row.ours.outcome.vertices;
    theirs += row.lindstrom_turk.outcome.vertices;
    if (worst == nullptr || *ratio > *worst->ratio()) worst = &row;
  }
  std::string text =
      std::to_string(rows.size()) + " lines, " + std::to_string(failed) + " of ours not certified";
  if (worst != nullptr) {
    text += "; " + std::to_string(ours) + " vertices for " + std::to_string(theirs) +
            " of Lindstrom–Turk on " + std::to_string(counted) +
            " lines: " + fixed(static_cast<double>(ours) / static_cast<double>(theirs), 3) +
            " in total, at worst " + fixed(*worst->ratio(), 3) + " (" + worst->asked.model + " " +
            worst->asked.tolerance.text() + ")";
    if (!cpu_ratios.empty())
      text += "; CPU time: " + fixed(median(cpu_ratios), 1) + " times its, at the median";
  }
  return "\n" + text + ".\n";
}

} // namespace isoscope::bench
