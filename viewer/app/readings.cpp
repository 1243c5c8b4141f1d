// What scripts can expect: readings of the run, the state, the selection and the X-ray.
#include "command/named_table.h"
#include "model/words.h"

#include <limits>
#include <sstream>

namespace isoscope {

std::string text_of(double value) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10 - 2);
  out << value;
  return out.str();
}

namespace {

void add_reading(NamedTable& t, std::string name, std::string help,
                 std::function<std::string(const AppModel&)> get) {
  t.push_back({std::move(name), std::move(help), std::move(get), nullptr});
}

std::string on_off(bool on) {
  return on ? "on" : "off";
}

std::string form_word(ZeroForm form) {
  return form == ZeroForm::interpolated ? "interpolated" : form == ZeroForm::embedded ? "embedded" : "free";
}

std::string check_word(CheckVerdict::State state) {
  return state == CheckVerdict::State::passed   ? "passed"
         : state == CheckVerdict::State::failed ? "failed"
                                                : "skipped";
}

void add_run_readings(NamedTable& t) {
  add_reading(t, "stage", "the stage of the operation shown", [](const AppModel& m) {
    const auto state = m.state();
    return std::string(name(state && state->event ? state->event->stage : Stage::setup));
  });
  add_reading(t, "form", "how the state holds Z: interpolated, embedded or free", [](const AppModel& m) {
    const auto state = m.state();
    return state ? form_word(state->complex.form) : std::string("none");
  });
  for (int i = static_cast<int>(Stage::refinement); i < stage_count; ++i) {
    const auto stage = static_cast<Stage>(i);
    add_reading(t, "begin." + std::string(name(stage)), "the step at which the stage begins",
                [stage](const AppModel& m) {
                  const auto begin = m.index.begin_of(stage);
                  return begin ? std::to_string(*begin) : std::string("nan");
                });
  }
  for (const EventKind kind : {EventKind::insertion, EventKind::collapse, EventKind::repair,
                               EventKind::relaxation, EventKind::shake})
    add_reading(
        t, "count." + std::string(name(kind)), "operations of that kind so far",
        [kind](const AppModel& m) { return std::to_string(m.index.count(kind, 0, m.index.steps())); });
  for (int i = static_cast<int>(first_rejection); i <= static_cast<int>(last_rejection); ++i) {
    const auto reason = static_cast<Reason>(i);
    add_reading(t, "rejected." + std::string(name(reason)), "edges rejected for that reason so far",
                [reason](const AppModel& m) {
                  return std::to_string(m.index.rejections(reason, 0, m.index.steps() + 1));
                });
  }
  add_reading(t, "facets_added", "facets of Z that the operation put there", [](const AppModel& m) {
    return std::to_string(m.state() ? m.state()->added_facets.size() : 0);
  });
  add_reading(t, "facets_removed", "facets of Z that it took away", [](const AppModel& m) {
    return std::to_string(m.state() ? m.state()->removed_facets.size() : 0);
  });
  add_reading(t, "vertices_moved", "vertices that it moved",
              [](const AppModel& m) { return std::to_string(m.state() ? m.state()->moves.size() : 0); });
}

void add_event_readings(NamedTable& t) {
  const auto of_event = [&](const char* name, const char* help, auto get) {
    add_reading(t, name, help, [get](const AppModel& m) {
      const auto index = m.selected_event();
      return index ? std::string(get(m.run.journal->events()[*index])) : std::string("none");
    });
  };
  of_event("event.kind", "the selected event's kind", [](const Event& e) { return name(e.kind); });
  of_event("event.reason", "its reason", [](const Event& e) { return name(e.reason); });
  of_event("event.step", "its step", [](const Event& e) { return std::to_string(e.step); });
  of_event("event.value", "what it measured", [](const Event& e) { return text_of(e.value); });
  of_event("event.limit", "the limit of that", [](const Event& e) { return text_of(e.limit); });
}

void add_xray_readings(NamedTable& t) {
  const auto of_xray = [&](std::string name, std::string help, auto get) {
    add_reading(t, "xray." + std::move(name), std::move(help), [get](const AppModel& m) {
      const auto xray = m.xray();
      return xray ? std::string(get(*xray)) : std::string("none");
    });
  };
  of_xray("verdict", "none where there is no X-ray; possible, or why the edge stays", [](const EdgeXray& x) {
    return x.attempt.possible() ? std::string_view("possible") : name(x.attempt.rejected);
  });
  of_xray("found_by", "how its target was found", [](const EdgeXray& x) { return name(x.attempt.found_by); });
  of_xray("agrees", "whether the journal's verdict is the same; unasked without an event",
          [](const EdgeXray& x) { return x.agrees ? on_off(*x.agrees) : std::string("unasked"); });
  of_xray("halfedge", "whether the ends alone were asked",
          [](const EdgeXray& x) { return on_off(x.halfedge); });
  of_xray("tried", "candidates judged", [](const EdgeXray& x) { return std::to_string(x.attempt.tried); });
  of_xray("recorded", "candidates recorded",
          [](const EdgeXray& x) { return std::to_string(x.attempt.candidates.size()); });
  of_xray("kernel_radius", "of the largest ball in the kernel", [](const EdgeXray& x) {
    return x.attempt.kernel ? text_of(x.attempt.kernel->inscribed_radius) : std::string("nan");
  });
  of_xray("kernel_faces", "of the kernel's polyhedron",
          [](const EdgeXray& x) { return std::to_string(x.kernel.faces.size()); });
  of_xray("psi_shown", "Ψ that have room in the kernel, the largest",
          [](const EdgeXray& x) { return std::to_string(x.invalid.size()); });
  of_xray("cells_visited", "cells of the octree search",
          [](const EdgeXray& x) { return std::to_string(x.attempt.cells.size()); });
  of_xray("cost", "the error at the target", [](const EdgeXray& x) { return text_of(x.attempt.cost); });
  of_xray("optimum_cost", "the least error without constraints",
          [](const EdgeXray& x) { return text_of(x.attempt.unconstrained_cost); });
  of_xray("offenders", "simplices that break the link condition", [](const EdgeXray& x) {
    return std::to_string(x.attempt.link.offending_t.size() + x.attempt.link.offending_zero.size());
  });
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    const auto check = static_cast<CollapseCheck>(i);
    const std::string key(name(check));
    of_xray(key, "passed, failed or skipped",
            [check](const EdgeXray& x) { return check_word(x.attempt.check(check).state); });
    of_xray(key + ".value", "what the check measured",
            [check](const EdgeXray& x) { return text_of(x.attempt.check(check).value); });
    of_xray(key + ".limit", "its limit",
            [check](const EdgeXray& x) { return text_of(x.attempt.check(check).limit); });
  }
}

} // namespace

void add_readings(NamedTable& t) {
  const auto of_state = [&](const char* name, const char* help, auto get) {
    add_reading(t, name, help, [get](const AppModel& m) {
      const auto state = m.state();
      return state ? text_of(static_cast<double>(get(*state))) : std::string("nan");
    });
  };
  add_reading(t, "step", "the step shown",
              [](const AppModel& m) { return std::to_string(m.transport.step()); });
  of_state("state_step", "the step of the state that is drawn",
           [](const StateSnapshot& s) { return s.step; });
  add_reading(t, "steps", "operations so far",
              [](const AppModel& m) { return std::to_string(m.live_step()); });
  add_reading(t, "events", "events so far", [](const AppModel& m) {
    return std::to_string(m.run.journal ? m.run.journal->events().size() : 0);
  });
  add_reading(t, "phase", "what the run is doing",
              [](const AppModel& m) { return std::string(phase_word(m.run.phase)); });
  add_reading(t, "transport", "what the play head is doing",
              [](const AppModel& m) { return std::string(transport_word(m.transport.mode())); });
  of_state("bad_samples", "samples with ε ≥ 1", [](const StateSnapshot& s) { return s.bad_samples; });
  of_state("beyond_margin", "samples with ε > 1 − α", [](const StateSnapshot& s) { return s.beyond_margin; });
  of_state("violating_2", "tetrahedra that violate condition 2",
           [](const StateSnapshot& s) { return s.violating_2; });
  of_state("violating_3", "tetrahedra that violate condition 3",
           [](const StateSnapshot& s) { return s.violating_3; });
  of_state("largest_error", "the largest ε", [](const StateSnapshot& s) { return s.largest_error; });
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
  add_reading(t, "selection", "what is selected: none, vertex, edge, tet, sample or facet",
              [](const AppModel& m) { return std::string(pick_word(m.selection.picked.kind)); });
  add_reading(t, "selected_id", "its number", [](const AppModel& m) {
    return m.selection.picked.kind == Pick::Kind::none ? std::string("nan")
                                                       : std::to_string(m.selection.picked.id);
  });
  add_reading(t, "selected_other", "the other end of a selected edge", [](const AppModel& m) {
    return m.selection.picked.kind != Pick::Kind::edge ? std::string("nan")
                                                       : std::to_string(m.selection.picked.other);
  });
  add_reading(t, "certified", "whether the finished run's mesh is proven", [](const AppModel& m) {
    return std::string(m.run.result && m.run.result->certificate.holds() ? "on" : "off");
  });
  add_reading(t, "model", "what is open", [](const AppModel& m) { return m.run.parameters.input; });
  add_reading(t, "messages", "messages shown",
              [](const AppModel& m) { return std::to_string(m.messages.size()); });
  add_reading(t, "distance", "of the camera from its target",
              [](const AppModel& m) { return text_of(m.camera.pose().distance); });
  add_reading(t, "heading", "x of the camera's backward axis", [](const AppModel& m) {
    const auto& q = m.camera.pose().orientation;
    return text_of(2 * (q[0] * q[2] + q[3] * q[1]));
  });
  add_run_readings(t);
  add_event_readings(t);
  add_xray_readings(t);
}

} // namespace isoscope
