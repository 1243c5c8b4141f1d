// Readings, by what they speak of.
#include "steering/steering.h"

#include "model/words.h"

#include <cmath>

namespace isoscope {
namespace {

std::string_view form_word(ZeroForm form) {
  return form == ZeroForm::interpolated ? "interpolated" : form == ZeroForm::embedded ? "embedded" : "free";
}

void add_run_readings(NamedValues& t, const WindowState& m) {
  t.add("stage", "the stage of the operation shown", [&m] {
    const auto state = m.state();
    return state && state->event ? state->event->stage : Stage::setup;
  });
  t.readings("",
             [&m] { return m.state(); })("form", "how the state holds Z: interpolated, embedded or free",
                                         [](const StateSnapshot& s) { return form_word(s.complex.form); });
  for (int i = static_cast<int>(Stage::refinement); i < stage_count; ++i) {
    const auto stage = static_cast<Stage>(i);
    t.add("begin." + std::string(name(stage)), "the step at which the stage begins",
          [stage, &m] { return value_text(m.index.begin_of(stage), "nan"); });
  }
  for (const EventKind kind : {EventKind::insertion, EventKind::collapse, EventKind::repair,
                               EventKind::relaxation, EventKind::shake})
    t.add("count." + std::string(name(kind)), "operations of that kind so far",
          [kind, &m] { return m.index.count(kind, 0, m.index.steps()); });
  for (const Reason reason : rejecting_reasons) {
    t.add("rejected." + std::string(name(reason)), "edges rejected for that reason so far",
          [reason, &m] { return m.index.rejections(reason, 0, m.index.steps() + 1); });
  }
  t.add("facets_added", "facets of Z that the operation put there",
        [&m] { return m.state() ? m.state()->added_facets.size() : 0; });
  t.add("facets_removed", "facets of Z that it took away",
        [&m] { return m.state() ? m.state()->removed_facets.size() : 0; });
  t.add("vertices_moved", "vertices that it moved", [&m] { return m.state() ? m.state()->moves.size() : 0; });
}

/// χ of Ω's boundaries on one side, taken together.
void add_volume_readings(NamedValues& t, const WindowState& m) {
  const auto euler = [&m](bool outer) -> std::optional<long> {
    if (!m.run.scene) return std::nullopt;
    long sum = 0;
    for (const BoundaryComponent& b : m.run.scene->boundary_components)
      if ((b.label > 0) == outer) sum += b.euler_characteristic;
    return sum;
  };
  t.add("omega.euler.outer", "χ of the outer boundary of Ω", [=] { return euler(true); });
  t.add("omega.euler.inner", "χ of the inner boundary of Ω", [=] { return euler(false); });
}

void add_event_readings(NamedValues& t, const WindowState& m) {
  const auto of_event = t.readings("event.", [&m]() -> std::optional<Event> {
    const auto index = m.selected_event();
    return index ? std::optional(m.run.journal->events()[*index]) : std::nullopt;
  });
  of_event("kind", "the selected event's kind", &Event::kind);
  of_event("reason", "its reason", &Event::reason);
  of_event("step", "its step", &Event::step);
  of_event("value", "what it measured", &Event::value);
  of_event("limit", "the limit of that", &Event::limit);
}

} // namespace

void add_run_values(NamedValues& t, const WindowState& m) {
  const auto of_state = t.readings(
      "", [&m] { return m.state(); }, "nan");
  t.add("step", "the step shown", [&m] { return m.transport.step(); });
  of_state("state_step", "the step of the state that is drawn", &StateSnapshot::step);
  t.add("steps", "operations so far", [&m] { return m.live_step(); });
  t.add("events", "events so far", [&m] { return m.run.journal ? m.run.journal->events().size() : 0; });
  t.add("phase", "what the run is doing", [&m] { return phase_word(m.run.phase); });
  const auto preparing = t.readings(
      "preparation.", [&m] { return m.run.phase == SessionPhase::preparing ? &m.preparation() : nullptr; });
  preparing("share", "of what comes before the first operation, in [0, 1]", &PreparationProgress::share);
  preparing("seconds", "that it took so far", &PreparationProgress::seconds);
  preparing("left", "seconds that it will take yet, as far as can be told",
            &PreparationProgress::seconds_left);
  t.add("transport", "what the play head is doing", [&m] { return transport_word(m.transport.mode()); });
  // Nothing is judged before T is there, which is not 0.
  const auto judged = [&](const char* name, const char* help, auto member) {
    of_state(name, help, [member](const StateSnapshot& s) {
      return s.complex.tets.empty() && s.complex.form != ZeroForm::free ? std::nullopt
                                                                        : std::optional(s.*member);
    });
  };
  judged("bad_samples", "samples with ε ≥ 1, nan before T is there", &StateSnapshot::bad_samples);
  judged("beyond_margin", "samples with ε > 1 − α", &StateSnapshot::beyond_margin);
  judged("violating_2", "tetrahedra that violate condition 2", &StateSnapshot::violating_2);
  of_state("violating_3", "tetrahedra that violate condition 3, nan where that is not judged yet",
           [](const StateSnapshot& s) {
             return s.orientation_judged && s.classifies() ? std::optional(s.violating_3) : std::nullopt;
           });
  judged("largest_error", "the largest ε", &StateSnapshot::largest_error);
  of_state("samples", "samples in S",
           [](const StateSnapshot& s) { return s.samples ? s.samples->size() : 0; });
  of_state("tets", "tetrahedra of T", [](const StateSnapshot& s) { return s.complex.alive_tets(); });
  of_state("vertices", "vertices of T", [](const StateSnapshot& s) { return s.complex.vertices.size(); });
  of_state("zero_vertices", "vertices of Z",
           [](const StateSnapshot& s) { return s.zero_set.vertices.size(); });
  of_state("components", "components of Z",
           [](const StateSnapshot& s) { return s.zero_set.components.size(); });
  of_state("euler", "Euler characteristic of Z",
           [](const StateSnapshot& s) { return s.zero_set.euler_characteristic(); });
  t.add("selection", "what is selected: none, vertex, edge, tet, sample, facet or point",
        [&m] { return pick_word(m.selection.picked.kind); });
  t.add("selected_id", "its number", [&m] {
    return m.selection.picked.kind == Pick::Kind::none ? std::string("nan")
                                                       : std::to_string(m.selection.picked.id);
  });
  t.add("selected_other", "the other end of a selected edge", [&m] {
    return m.selection.picked.kind != Pick::Kind::edge ? std::string("nan")
                                                       : std::to_string(m.selection.picked.other);
  });
  t.add("certified", "whether the finished run's mesh is proven",
        [&m] { return m.run.result && m.run.result->certificate.holds(); });
  t.add("improvable", "whether the run has ended and can go on improving",
        [&m] { return m.can_go_on_improving(); });
  t.add("improving", "whether it does", [&m] { return m.run.improving; });
  t.add("optimum", "the asymptotic estimate of the least vertices; nan where there is none",
        [&m] { return m.run.scene && m.run.scene->optimum ? m.run.scene->optimum->vertices : std::nan(""); });
  t.add("model", "what is open", [&m] { return m.run.parameters.input; });
  t.add("answer", "the answer that was last brought into sight", [&m] { return m.answer.shown; });
  t.add("answer.flashes", "whether it still flashes", [&m] {
    return m.answer.shown != AnswerKind::none && m.clock - m.answer.since <= AnswerInSight::flash;
  });
  t.add("inspector.scroll", "how far the inspector is scrolled, pixels", [&m] { return m.inspector_scroll; });
  t.add("messages", "messages shown", [&m] { return m.messages.size(); });
  t.add("message", "the last of them",
        [&m] { return m.messages.empty() ? std::string("none") : m.messages.back().text; });
  t.add("distance", "of the camera from its target", [&m] { return m.camera.pose().distance; });
  t.add("filled", "the model's longest edge over the height of the view, at the camera's target", [&m] {
    const Box3 box = m.scene_bounds();
    return box.empty() ? std::nan("") : box.longest_edge() / m.camera.height_at_target();
  });
  t.add("heading", "x of the camera's backward axis", [&m] {
    const auto& q = m.camera.pose().orientation;
    return 2 * (q[0] * q[2] + q[3] * q[1]);
  });
  add_run_readings(t, m);
  add_volume_readings(t, m);
  add_event_readings(t, m);
}

} // namespace isoscope
