// What scripts can expect of two runs.
#include "two_runs/comparison.h"

namespace isoscope {
namespace {

const std::string none = "none";

std::string count(std::size_t n) {
  return std::to_string(n);
}

void reading(NamedValues& t, const std::string& name, std::string help, std::function<std::string()> get) {
  t.add("compare." + name, std::move(help), std::move(get));
}

/// A reading of what was found, "none" before.
void of_found(NamedValues& t, const Comparison& m, const std::string& name, std::string help,
              std::string (*value)(const RunComparison&)) {
  reading(t, name, std::move(help), [value, &m] {
    const auto found = m.other() ? m.found() : nullptr;
    return found ? value(*found) : none;
  });
}

void of_run(NamedValues& t, const Comparison& m, bool b) {
  const std::string letter = b ? "b" : "a";
  const auto add = [&](const char* name, const char* help, auto value) {
    reading(t, letter + "." + name, help, [b, value, &m] {
      const ShownRun* run = m.run(b);
      return run ? value(*run) : none;
    });
  };
  add("step", "its step shown",
      [](const ShownRun& run) { return run.state() ? count(run.state()->step) : none; });
  add("steps", "its steps so far", [](const ShownRun& run) { return count(run.live_step()); });
  add("vertices", "vertices of its Z at the step shown",
      [](const ShownRun& run) { return run.state() ? count(run.state()->zero_set.vertices.size()) : none; });
  add("event", "what was decided there: the kind of the last operation", [](const ShownRun& run) {
    const auto state = run.state();
    return state && state->event ? std::string(name(state->event->kind)) : none;
  });
  add("certified", "whether it ended with a certificate that holds", [](const ShownRun& run) {
    return std::string(run.run.result && run.run.result->certificate.holds() ? "on" : "off");
  });
  add("distance", "of its camera from its target", [&m](const ShownRun& run) {
    const bool own = &run != &m.window && !m.linked_cameras;
    return text_of((own ? m.camera : m.window.camera).pose().distance);
  });
}

} // namespace

void Comparison::add_values(NamedValues& t) {
  reading(t, "beside", "whether two runs are drawn", [this] { return std::string(beside() ? "on" : "off"); });
  reading(t, "active", "the active run, a or b", [this] { return std::string(active_is_b() ? "b" : "a"); });
  reading(t, "row", "the row of the table that is shown", [this] { return row ? count(*row) : none; });
  of_run(t, *this, false);
  of_run(t, *this, true);
  of_found(t, *this, "same", "whether every decision and number is the same",
           [](const RunComparison& c) { return std::string(c.same() ? "on" : "off"); });
  of_found(t, *this, "parameters", "parameters that differ",
           [](const RunComparison& c) { return count(c.parameters.size()); });
  of_found(t, *this, "common", "operations before the first difference",
           [](const RunComparison& c) { return count(c.alignment.common()); });
  of_found(t, *this, "first_event", "number of the first event that was decided differently",
           [](const RunComparison& c) { return c.decision ? count(c.decision->event) : none; });
  of_found(t, *this, "first_step", "operations before it",
           [](const RunComparison& c) { return c.decision ? count(c.decision->step) : none; });
  of_found(t, *this, "measure_event", "number of the first event that was judged by other numbers",
           [](const RunComparison& c) { return c.measure ? count(c.measure->event) : none; });
  of_found(t, *this, "both", "decisions from there on that both made",
           [](const RunComparison& c) { return count(c.decisions.both()); });
  of_found(t, *this, "only_a", "those of A alone",
           [](const RunComparison& c) { return count(c.decisions.only_a()); });
  of_found(t, *this, "only_b", "those of B alone",
           [](const RunComparison& c) { return count(c.decisions.only_b()); });
}

void Comparison::add_run_values(NamedValues& t) {
  t.add("runs", "runs to change between: two once one has branched",
        [this] { return std::string(other() ? "2" : "1"); });
  t.add("branched", "whether the run shown left another one", [this] {
    if (!window.run.journal) return std::string("off");
    const Journal& journal = *window.run.journal;
    for (std::size_t i = 0, n = journal.operations().size(); i < n; ++i)
      if (journal.events()[journal.operations()[i].event].reason == Reason::user &&
          journal.events()[journal.operations()[i].event].kind == EventKind::collapse)
        return std::string("on");
    return std::string("off");
  });
}

void Comparison::add_history_values(NamedValues& t) {
  const auto count = [&](const char* name, const char* help, auto get) {
    t.add(name, help, [get] { return std::to_string(get()); });
  };
  count("history.disk", "bytes of the journal that are on the disk",
        [this] { return history_memory().disk; });
  count("history.bytes", "bytes of journal and keyframes in memory",
        [this] { return history_memory().bytes(); });
  count("history.journal", "bytes of the journal in memory", [this] { return history_memory().journal; });
  count("history.keyframes", "bytes of the keyframes", [this] { return history_memory().keyframes; });
  t.add(
      "history.limit", "what journal and keyframes may take together, MiB, 1 to 1048576",
      [this] { return text_of(window.settings.history_limit); },
      [this](const std::string& text) -> Status {
        const auto value = parse_number(text);
        if (!value) return value.error();
        if (*value < 1 || *value > 1048576)
          return Error{ErrorCode::usage, "\"" + text + "\" is no limit of the history.",
                       "It lies between 1 and 1048576 MiB."};
        window.settings.history_limit = *value;
        return {};
      });
}

} // namespace isoscope
