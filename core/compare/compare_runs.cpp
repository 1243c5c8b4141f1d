// A walk over the common part of both journals, then what each of them did alone.
#include "compare/compare_runs.h"

#include "journal/describe.h"
#include "journal/digest.h"

#include <algorithm>
#include <bit>

namespace isoscope {

namespace {

/// As bits: NaN is the same as itself.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(Vec3 a, Vec3 b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// What an operation changes, but for the sample set: its number is the journal's own.
std::uint64_t effect(const Journal& journal, const Event& e) {
  Delta delta = journal.operations()[e.step].delta();
  delta.sample_set.reset();
  Digest digest;
  digest.add(delta);
  return digest.value();
}

/// Whether an event says by itself what its operation does to a given state.
bool tells_all(EventKind kind) {
  return kind == EventKind::insertion || kind == EventKind::collapse;
}

bool same_measure(const Journal& journal_a, const Event& a, const Journal& journal_b, const Event& b) {
  return same(a.value, b.value) && same(a.limit, b.limit) && same(a.witness, b.witness) &&
         a.count == b.count && a.tet == b.tet && a.sample == b.sample &&
         journal_a.repairs()[a.detail] == journal_b.repairs()[b.detail];
}

bool same_set(const BoundarySamples& a, const BoundarySamples& b) {
  return a.positions == b.positions && a.labels == b.labels;
}

std::shared_ptr<const BoundarySamples> first_samples(const Journal& journal) {
  return journal.sample_sets().empty() ? nullptr : journal.sample_sets()[0];
}

void compare_journals(const Journal& a, const Journal& b, const RunControl& control, RunComparison& found) {
  constexpr std::size_t poll = 4096;
  const std::size_t both = std::min(found.events_a, found.events_b);
  const auto part = [&](std::size_t i) {
    JournalDifference d;
    d.event = static_cast<std::uint32_t>(i);
    d.in_a = i < found.events_a;
    d.in_b = i < found.events_b;
    d.step = d.in_a ? a.events()[i].step : b.events()[i].step;
    return d;
  };
  for (std::size_t i = 0; i < both; ++i) {
    if (i % poll == 0 && control.cancelled()) return;
    const Event &x = a.events()[i], &y = b.events()[i];
    if (!same_decision(a, x, b, y)) {
      found.decision = part(i);
      return;
    }
    if (!found.measure && !same_measure(a, x, b, y)) found.measure = part(i);
  }
  if (found.events_a != found.events_b) found.decision = part(both);
}

std::vector<StageComparison> compare_stages(const Journal& a, const Journal& b) {
  const std::vector<StageStatistics> of_a = gather_statistics(a), of_b = gather_statistics(b);
  const auto stages = [](const std::vector<StageStatistics>& all) {
    std::vector<Stage> list;
    for (const StageStatistics& s : all) list.push_back(s.stage);
    return list;
  };
  std::vector<StageComparison> rows;
  for (const auto& [i, j] : pair_stages(stages(of_a), stages(of_b))) {
    StageComparison row;
    if (i) row.stage = of_a[*i].stage, row.a = of_a[*i];
    if (j) row.stage = of_b[*j].stage, row.b = of_b[*j];
    rows.push_back(row);
  }
  return rows;
}

/// As asked for, but with the σ that the journal began with.
RunParameters told(RunParameters p, const Journal& journal) {
  if (journal.parameters().empty()) return p;
  const CriteriaParameters& c = journal.parameters()[0].criteria;
  if (c.delta > 0) p.sigma = c.sigma / c.delta;
  return p;
}

} // namespace

std::vector<FieldDifference> differing_parameters(const RunParameters& a, const Journal& journal_a,
                                                  const RunParameters& b, const Journal& journal_b) {
  return differing_fields(told(a, journal_a), told(b, journal_b));
}

bool same_decision(const Journal& journal_a, const Event& a, const Journal& journal_b, const Event& b) {
  if (a.kind != b.kind || a.stage != b.stage || a.condition != b.condition || a.reason != b.reason ||
      a.operation != b.operation || a.vertex != b.vertex || a.other != b.other || !same(a.point, b.point))
    return false;
  if (a.kind == EventKind::exhausted && a.tet != b.tet) return false;
  if (a.kind == EventKind::parameter_change &&
      !(journal_a.parameters_at(a.step) == journal_b.parameters_at(b.step)))
    return false;
  if (journal_a.texts()[a.text] != journal_b.texts()[b.text]) return false;
  return !a.operation || tells_all(a.kind) || effect(journal_a, a) == effect(journal_b, b);
}

RunComparison compare_runs(const RunParameters& a, const Journal& journal_a, const RunParameters& b,
                           const Journal& journal_b, const RunControl& control) {
  RunComparison found;
  found.parameters = differing_parameters(a, journal_a, b, journal_b);
  const auto samples_a = first_samples(journal_a), samples_b = first_samples(journal_b);
  found.samples_a = samples_a ? samples_a->positions.size() : 0;
  found.samples_b = samples_b ? samples_b->positions.size() : 0;
  found.same_samples = !samples_a || !samples_b || same_set(*samples_a, *samples_b);
  found.events_a = complete_events(journal_a);
  found.events_b = complete_events(journal_b);
  compare_journals(journal_a, journal_b, control, found);
  found.stages = compare_stages(journal_a, journal_b);
  const Step steps_a = journal_a.steps(), steps_b = journal_b.steps();
  found.alignment = RunAlignment(stage_stretches(journal_a), steps_a, stage_stretches(journal_b), steps_b,
                                 found.decision ? found.decision->step : std::min(steps_a, steps_b));
  if (found.decision)
    found.decisions = differing_decisions(journal_a, journal_b, found.decision->event, control);
  return found;
}

std::string describe(const JournalDifference& difference, const Journal& journal, bool there) {
  return there ? describe(journal, journal.events()[difference.event]) : "the run ends here";
}

} // namespace isoscope
