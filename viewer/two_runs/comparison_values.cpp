// What scripts can expect of two runs.
#include "two_runs/comparison.h"

namespace isoscope {
namespace {

void of_run(NamedValues& t, const Comparison& m, bool b) {
  const auto add = t.readings(b ? "compare.b." : "compare.a.", [b, &m] { return m.run(b); });
  const auto of_state = t.readings(b ? "compare.b." : "compare.a.", [b, &m] {
    const ShownRun* run = m.run(b);
    return run ? run->state() : nullptr;
  });
  of_state("step", "its step shown", &StateSnapshot::step);
  add("steps", "its steps so far", &ShownRun::live_step);
  of_state("vertices", "vertices of its Z at the step shown",
           [](const StateSnapshot& s) { return s.zero_set.vertices.size(); });
  of_state("event", "what was decided there: the kind of the last operation",
           [](const StateSnapshot& s) { return s.event ? std::optional(s.event->kind) : std::nullopt; });
  add("certified", "whether it ended with a certificate that holds",
      [](const ShownRun& run) { return run.run.result && run.run.result->certificate.holds(); });
  add("distance", "of its camera from its target", [&m](const ShownRun& run) {
    const bool own = &run != &m.window && !m.linked_cameras;
    return (own ? m.camera : m.window.camera).pose().distance;
  });
}

} // namespace

void Comparison::add_values(NamedValues& t) {
  using C = RunComparison;
  t.add("compare.beside", "whether two runs are drawn", [this] { return beside(); });
  t.add("compare.active", "the active run, a or b", [this] { return active_is_b() ? "b" : "a"; });
  t.add("compare.row", "the row of the table that is shown", [this] { return row; });
  of_run(t, *this, false);
  of_run(t, *this, true);
  const auto found = t.readings("compare.", [this] { return other() ? this->found() : nullptr; });
  found("same", "whether every decision and number is the same", &C::same);
  found("parameters", "parameters that differ", [](const C& c) { return c.parameters.size(); });
  found("common", "operations before the first difference", [](const C& c) { return c.alignment.common(); });
  found("first_event", "number of the first event that was decided differently",
        [](const C& c) { return c.decision ? std::optional(c.decision->event) : std::nullopt; });
  found("first_step", "operations before it",
        [](const C& c) { return c.decision ? std::optional(c.decision->step) : std::nullopt; });
  found("measure_event", "number of the first event that was judged by other numbers",
        [](const C& c) { return c.measure ? std::optional(c.measure->event) : std::nullopt; });
  found("both", "decisions from there on that both made", [](const C& c) { return c.decisions.both(); });
  found("only_a", "those of A alone", [](const C& c) { return c.decisions.only_a(); });
  found("only_b", "those of B alone", [](const C& c) { return c.decisions.only_b(); });
}

void Comparison::add_run_values(NamedValues& t) {
  t.add("runs", "runs to change between: two once one has branched", [this] { return other() ? 2 : 1; });
  t.add("branched", "whether the run shown left another one", [this] {
    if (!window.run.journal) return false;
    const Journal& journal = *window.run.journal;
    for (std::size_t i = 0, n = journal.operations().size(); i < n; ++i)
      if (journal.events()[journal.operations()[i].event].reason == Reason::user &&
          journal.events()[journal.operations()[i].event].kind == EventKind::collapse)
        return true;
    return false;
  });
}

void Comparison::add_history_values(NamedValues& t) {
  t.add("history.disk", "bytes of the journal that are on the disk",
        [this] { return history_memory().disk; });
  t.add("history.bytes", "bytes of journal and keyframes in memory",
        [this] { return history_memory().bytes(); });
  t.add("history.journal", "bytes of the journal in memory", [this] { return history_memory().journal; });
  t.add("history.keyframes", "bytes of the keyframes", [this] { return history_memory().keyframes; });
  t.bind("history.limit", "what journal and keyframes may take together, MiB, 1 to 1048576",
         {.range = {.low = 1,
                    .high = 1048576,
                    .wrong = "no limit of the history",
                    .remedy = "It lies between 1 and 1048576 MiB."}},
         window.settings.history_limit);
}

} // namespace isoscope
