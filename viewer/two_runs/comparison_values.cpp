// What scripts can expect of two runs.
#include "command/named_table.h"

#include <functional>

namespace isoscope {
namespace {

const std::string none = "none";

std::string count(std::size_t n) {
  return std::to_string(n);
}

void reading(NamedTable& t, const std::string& name, std::string help,
             std::function<std::string(const AppModel&)> get) {
  t.push_back({"compare." + name, std::move(help), std::move(get), nullptr});
}

/// A reading of what was found, "none" before.
void of_found(NamedTable& t, const std::string& name, std::string help,
              std::string (*value)(const RunComparison&)) {
  reading(t, name, std::move(help), [value](const AppModel& m) {
    const auto found = m.comparison.other() ? m.comparison.found() : nullptr;
    return found ? value(*found) : none;
  });
}

void of_run(NamedTable& t, bool b) {
  const std::string letter = b ? "b" : "a";
  const auto add = [&](const char* name, const char* help,
                       std::string (*value)(const AppModel&, const ShownRun&)) {
    reading(t, letter + "." + name, help, [b, value](const AppModel& m) {
      const ShownRun* run = compared_run(m, b);
      return run ? value(m, *run) : none;
    });
  };
  add("step", "its step shown",
      [](const AppModel&, const ShownRun& run) { return run.state() ? count(run.state()->step) : none; });
  add("steps", "its steps so far",
      [](const AppModel&, const ShownRun& run) { return count(run.live_step()); });
  add("vertices", "vertices of its Z at the step shown", [](const AppModel&, const ShownRun& run) {
    return run.state() ? count(run.state()->zero_set.vertices.size()) : none;
  });
  add("event", "what was decided there: the kind of the last operation",
      [](const AppModel&, const ShownRun& run) {
        const auto state = run.state();
        return state && state->event ? std::string(name(state->event->kind)) : none;
      });
  add("certified", "whether it ended with a certificate that holds",
      [](const AppModel&, const ShownRun& run) {
        return std::string(run.run.result && run.run.result->certificate.holds() ? "on" : "off");
      });
  add("distance", "of its camera from its target", [](const AppModel& m, const ShownRun& run) {
    const bool own = &run != &m && !m.comparison.linked_cameras;
    return text_of((own ? m.comparison.camera : m.camera).pose().distance);
  });
}

} // namespace

void add_comparison(NamedTable& t) {
  reading(t, "beside", "whether two runs are drawn",
          [](const AppModel& m) { return std::string(m.comparison.beside() ? "on" : "off"); });
  reading(t, "active", "the active run, a or b",
          [](const AppModel& m) { return std::string(m.comparison.active_is_b() ? "b" : "a"); });
  reading(t, "row", "the row of the table that is shown",
          [](const AppModel& m) { return m.comparison.row ? count(*m.comparison.row) : none; });
  of_run(t, false);
  of_run(t, true);
  of_found(t, "same", "whether every decision and number is the same",
           [](const RunComparison& c) { return std::string(c.same() ? "on" : "off"); });
  of_found(t, "parameters", "parameters that differ",
           [](const RunComparison& c) { return count(c.parameters.size()); });
  of_found(t, "common", "operations before the first difference",
           [](const RunComparison& c) { return count(c.alignment.common()); });
  of_found(t, "first_event", "number of the first event that was decided differently",
           [](const RunComparison& c) { return c.decision ? count(c.decision->event) : none; });
  of_found(t, "first_step", "operations before it",
           [](const RunComparison& c) { return c.decision ? count(c.decision->step) : none; });
  of_found(t, "measure_event", "number of the first event that was judged by other numbers",
           [](const RunComparison& c) { return c.measure ? count(c.measure->event) : none; });
  of_found(t, "both", "decisions from there on that both made",
           [](const RunComparison& c) { return count(c.decisions.both()); });
  of_found(t, "only_a", "those of A alone",
           [](const RunComparison& c) { return count(c.decisions.only_a()); });
  of_found(t, "only_b", "those of B alone",
           [](const RunComparison& c) { return count(c.decisions.only_b()); });
}

} // namespace isoscope
