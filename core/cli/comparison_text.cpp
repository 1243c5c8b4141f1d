// Columns of fixed width; what is the same in both runs is left out where that can be.
#include "cli/comparison_text.h"

#include "base/numbers.h"
#include "journal/describe.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace isoscope {

namespace {

/// Columns that a terminal needs: bytes that begin a character.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string left(std::string text, std::size_t columns) {
  for (std::size_t n = width(text); n < columns; ++n) text += ' ';
  return text;
}

std::string right(const std::string& text, std::size_t columns) {
  const std::size_t n = width(text);
  return std::string(n < columns ? columns - n : 0, ' ') + text;
}

/// A label, then values flush right.
std::string row(std::string_view label, std::initializer_list<std::string> values, std::size_t column = 13) {
  std::string text = "  " + left(std::string(label), 18);
  for (const std::string& value : values) text += right(value, column);
  return text + "\n";
}

template <class Value> std::string of(const std::optional<StageStatistics>& stage, const Value& value) {
  return stage ? value(*stage) : "-";
}

std::string stages_text(const RunComparison& found) {
  std::string text = "\n" + left("Stage", 20) + right("operations", 20) + right("vertices of Z", 20) +
                     right("rejected", 20) + right("seconds", 20) + "\n" +
                     row("", {"A", "B", "A", "B", "A", "B", "A", "B"}, 10);
  for (const StageComparison& s : found.stages) {
    const auto operations = [](const StageStatistics& f) { return grouped(f.operations); };
    const auto vertices = [](const StageStatistics& f) { return grouped(f.zero_set_vertices); };
    const auto rejected = [](const StageStatistics& f) { return grouped(f.rejections()); };
    const auto time = [](const StageStatistics& f) { return fixed(f.seconds, 2); };
    text += row(name(s.stage),
                {of(s.a, operations), of(s.b, operations), of(s.a, vertices), of(s.b, vertices),
                 of(s.a, rejected), of(s.b, rejected), of(s.a, time), of(s.b, time)},
                10);
  }
  return text;
}

std::string reasons_text(const RunComparison& found) {
  std::string text;
  for (const StageComparison& s : found.stages)
    for (std::size_t r = 0; r < static_cast<std::size_t>(reason_count); ++r) {
      const std::size_t a = s.a ? s.a->rejected[r] : 0, b = s.b ? s.b->rejected[r] : 0;
      if (a != b)
        text += "  " + left(std::string(name(s.stage)), 13) +
                left(std::string(name(static_cast<Reason>(r))), 20) + right(grouped(a), 11) +
                right(grouped(b), 13) + "\n";
    }
  if (text.empty()) return text;
  return "\n" + left("Rejected, by reason, where it differs", 35) + right("A", 11) + right("B", 13) + "\n" +
         text;
}

std::string difference(const char* heading, const std::optional<JournalDifference>& d, const ComparedRun& a,
                       const ComparedRun& b) {
  if (!d) return {};
  return "\n" + std::string(heading) + ": event " + grouped(d->event) + ", after " +
         counted(d->step, "operation") + "\n  A  " + describe(*d, a.journal, d->in_a) + "\n  B  " +
         describe(*d, b.journal, d->in_b) + "\n";
}

std::string decision_table(const DecisionTable& table) {
  if (table.stages.empty()) return {};
  std::string text = "\n" + left("Decided from there on", 22) + right("by both", 11) + right("only A", 13) +
                     right("only B", 13) + "\n";
  for (const StageDecisions& s : table.stages)
    text += row(name(s.stage), {grouped(s.both), grouped(s.only_a), grouped(s.only_b)});
  return text;
}

std::string decisions(const RunComparison& found, const ComparedRun& a, const ComparedRun& b,
                      std::size_t rows) {
  const DecisionTable& table = found.decisions;
  std::string text = decision_table(table);
  const std::size_t listed = std::min(rows, table.rows.size());
  if (listed == 0) return text;
  text += "\nMade by one run alone\n";
  for (std::size_t i = 0; i < listed; ++i) {
    const DecisionDifference& d = table.rows[i];
    const Journal &maker = d.made_by_a ? a.journal : b.journal, &other = d.made_by_a ? b.journal : a.journal;
    text += std::string("  ") + (d.made_by_a ? "A" : "B") + "  " + std::string(name(d.stage)) + " " +
            describe(maker, maker.events()[d.event]) + "\n";
    if (d.refusal)
      text += std::string("     in ") + (d.made_by_a ? "B" : "A") + " " +
              describe(other, other.events()[*d.refusal]) + "\n";
  }
  const std::size_t all = table.only_a() + table.only_b();
  if (all > listed) text += "  and " + grouped(all - listed) + " more\n";
  return text;
}

std::string heading(const char* letter, const ComparedRun& run) {
  return std::string(letter) + "  " + run.name + ": " + counted(run.journal.events().size(), "event") + ", " +
         counted(run.journal.operations().size(), "operation") + "\n";
}

} // namespace

std::string comparison_text(const RunComparison& found, const ComparedRun& a, const ComparedRun& b,
                            std::size_t rows) {
  std::string text = heading("A", a) + heading("B", b);
  if (!found.parameters.empty() || !found.same_samples) {
    text += "\n" + left("Parameters", 20) + right("A", 13) + right("B", 13) + "\n";
    for (const FieldDifference& p : found.parameters) text += row(p.name, {p.a, p.b});
    if (!found.same_samples)
      text += row("samples of ∂Ω", {grouped(found.samples_a), grouped(found.samples_b)});
  }
  text += stages_text(found);
  if (found.same()) return text + "\nEvery decision and every number is the same.\n";
  text += reasons_text(found);
  text += difference("First event judged by other numbers", found.measure, a, b);
  text += difference("First differing decision", found.decision, a, b);
  if (!found.decision) text += "\nEvery decision is the same.\n";
  return text + decisions(found, a, b, rows);
}

} // namespace isoscope
