// What differs between two runs: parameters, outcome by stage, the first differing decision, and which
// decisions one of them made and the other did not. Read off the journals alone.
#pragma once

#include "base/run_control.h"
#include "compare/decision_table.h"
#include "compare/run_alignment.h"
#include "run/parameters.h"
#include "run/statistics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// A stage in both runs, or in the one that has it.
struct StageComparison {
  Stage stage = Stage::refinement;
  std::optional<StageStatistics> a, b;
};

/// Where two journals part. All events before it are the same, so its number and step are those of both.
struct JournalDifference {
  std::uint32_t event = 0;
  Step step = 0;                   ///< operations before it
  bool in_a = false, in_b = false; ///< false: that journal ends there
};

struct RunComparison {
  std::vector<FieldDifference> parameters;
  std::vector<StageComparison> stages;
  /// Of the sample sets that the runs began with; 0 before there is one.
  std::size_t samples_a = 0, samples_b = 0;
  bool same_samples = true;
  /// Events that were compared: those there were.
  std::size_t events_a = 0, events_b = 0;
  /// The first event at which something else was decided: inserted, collapsed, refused for another reason.
  std::optional<JournalDifference> decision;
  /// The first event with the same decision that was measured or judged otherwise (another α gives another
  /// limit); none when the decisions part before.
  std::optional<JournalDifference> measure;
  RunAlignment alignment;
  DecisionTable decisions; ///< from the first difference on

  /// The same samples and the same events to the end.
  bool same() const { return same_samples && !decision && !measure; }
};

/// What may change a result; the number of threads is left out. σ is that of the journals where these have
/// begun.
std::vector<FieldDifference> differing_parameters(const RunParameters& a, const Journal& journal_a,
                                                  const RunParameters& b, const Journal& journal_b);

/// Whether two events decide the same: their numbers (ε, d, limits, candidates judged) may differ, and so may
/// sample ids, which belong to a sample set.
bool same_decision(const Journal& journal_a, const Event& a, const Journal& journal_b, const Event& b);

/// The journals may be growing: what is there is compared, and a journal that ends sooner differs where it
/// ends. When cancelled, what was found so far.
RunComparison compare_runs(const RunParameters& a, const Journal& journal_a, const RunParameters& b,
                           const Journal& journal_b, const RunControl& control);

/// The event of a difference in plain words, or that the run ends there.
std::string describe(const JournalDifference& difference, const Journal& journal, bool there);

} // namespace isoscope
