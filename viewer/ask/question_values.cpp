// What scripts can expect of the answers to questions, and the settings of these.
#include "ask/investigation.h"

#include "model/words.h"

#include <algorithm>
#include <array>
#include <limits>

namespace isoscope {
namespace {

const std::string none = "none";

/// A reading of an answer that may not be there.
template <class Find, class Value>
void of(NamedValues& t, std::string name, std::string help, Find find, Value value) {
  t.add(std::move(name), std::move(help), [find, value] {
    const auto answer = find();
    return answer ? std::string(value(*answer)) : none;
  });
}

std::string count(std::size_t n) {
  return std::to_string(n);
}

double delta_of(const Investigation& m) {
  const auto state = m.window.state();
  return state && state->criteria.delta > 0 ? state->criteria.delta : 1;
}

std::optional<TetInspection> tet_shown(const Investigation& m) {
  const auto state = m.window.state();
  if (!state || m.window.selection.picked.kind != Pick::Kind::tet) return std::nullopt;
  const auto index = m.window.sample_index();
  return inspect_tet(*state, TetId(m.window.selection.picked.id), m.shrink.value_or(state->criteria.shrink),
                     index && index->set == state->samples ? &index->nearest : nullptr);
}

std::optional<SampleInspection> sample_shown(const Investigation& m) {
  const auto state = m.window.state();
  if (!state || m.window.selection.picked.kind != Pick::Kind::sample) return std::nullopt;
  return inspect_sample(*state, SampleId(m.window.selection.picked.id));
}

void add_tet_questions(NamedValues& t, Investigation& m) {
  const auto tet = [&m] { return tet_shown(m); };
  const auto sample = [&m] { return sample_shown(m); };
  t.add(
      "inspect.shrink", "factor of the shrunk copy that is drawn, 0 for condition 3's own",
      [&m] { return text_of(m.shrink.value_or(0)); },
      [&m](const std::string& text) -> Status {
        const auto n = parse_number(text);
        if (!n || *n < 0 || *n > 1) return Error{ErrorCode::usage, "0 to 1 is needed.", ""};
        m.shrink = *n > 0 ? std::optional<double>(*n) : std::nullopt;
        return {};
      });
  t.add("violations.misoriented", "tetrahedra that violate condition 3",
        [&m] { return m.window.state() ? count(misoriented_tets(*m.window.state()).size()) : none; });
  t.add("violations.flat", "tetrahedra that carry Z below 2σ/α", [&m] {
    return m.window.state() ? count(violating_tets(*m.window.state(), ViolationKind::flat).size()) : none;
  });
  of(t, "tet.misoriented", "the selected tetrahedron violates condition 3 at inspect.shrink", tet,
     [](const TetInspection& x) {
       return !x.orientation ? "none" : x.orientation->misoriented ? "on" : "off";
     });
  of(t, "tet.tests", "its samples of condition 3 that are asked", tet, [](const TetInspection& x) {
    return !x.orientation ? none
                          : count(static_cast<std::size_t>(
                                std::count_if(x.orientation->tests.begin(), x.orientation->tests.end(),
                                              [](const auto& test) { return test.asked(); })));
  });
  of(t, "tet.failed_tests", "of these, the ones that fail", tet, [](const TetInspection& x) {
    return !x.orientation ? none
                          : count(static_cast<std::size_t>(
                                std::count_if(x.orientation->tests.begin(), x.orientation->tests.end(),
                                              [](const auto& test) { return !test.good(); })));
  });
  t.add("tet.height", "its height in δ", [&m] {
    const auto x = tet_shown(m);
    return x ? text_of(x->height.value / delta_of(m)) : none;
  });
  t.add("tet.gap", "distance of the ends of its height, in δ", [&m] {
    const auto x = tet_shown(m);
    return x ? text_of(distance(x->gap[0], x->gap[1]) / delta_of(m)) : none;
  });
  t.add("tet.height_limit", "2σ/α in δ", [&m] {
    return m.window.state() ? text_of(m.window.state()->criteria.height_limit() / delta_of(m)) : none;
  });
  of(t, "sample.error", "ε of the selected sample", sample,
     [](const SampleInspection& x) { return text_of(x.error); });
  of(t, "sample.f", "f at it", sample, [](const SampleInspection& x) { return text_of(x.f); });
  of(t, "sample.class", "good or bad", sample,
     [](const SampleInspection& x) { return x.bad ? "bad" : "good"; });
  of(t, "sample.remedy", "how it will be mended", sample, [](const SampleInspection& x) {
    constexpr std::array<std::string_view, 6> words{"none-needed",  "not-asked",    "itself-next",
                                                    "itself-later", "worse-in-tet", "vertex-already"};
    return words.at(static_cast<std::size_t>(x.remedy));
  });
  of(t, "sample.fixer", "the sample that is inserted for it", sample,
     [](const SampleInspection& x) { return x.fixer.valid() ? count(x.fixer.value) : none; });
  of(t, "sample.tet", "the tetrahedron that holds it", sample,
     [](const SampleInspection& x) { return x.tet.valid() ? count(x.tet.value) : none; });
  of(t, "sample.tets_before", "tetrahedra that get a point first", sample,
     [](const SampleInspection& x) { return count(x.tets_before); });
}

void add_history_questions(NamedValues& t, Investigation& m) {
  const auto history = [&m] { return m.history(); };
  using H = ElementHistory;
  of(t, "history.rows", "lines of the selected element's history", history,
     [](const H& h) { return count(h.rows.size()); });
  t.add("history.shown", "those within the chosen range", [&m] {
    const auto h = m.history();
    if (!h) return std::string("nan");
    const auto& range = m.window.range;
    const auto in = [&](const HistoryRow& row) { return !range || range->holds(row.step); };
    return std::to_string(std::count_if(h->rows.begin(), h->rows.end(), in));
  });
  of(t, "history.changes", "those that changed it", history, [](const H& h) { return count(h.changes()); });
  of(t, "history.attempts", "attempts to collapse the edge", history,
     [](const H& h) { return count(h.attempts); });
  of(t, "history.rejections", "those that failed", history, [](const H& h) { return count(h.rejections); });
  of(t, "history.absorbed", "vertices that ended in the vertex", history,
     [](const H& h) { return count(h.absorbed); });
  of(t, "history.heir", "who stands for the vertex at the end", history,
     [](const H& h) { return h.heir.valid() ? count(h.heir.value) : none; });
  of(t, "history.places", "places of the vertex' way", history,
     [](const H& h) { return count(h.path.size()); });
  of(t, "history.first_step", "the step of the first line", history,
     [](const H& h) { return h.rows.empty() ? none : count(h.rows.front().step); });
  of(t, "history.last_step", "the step of the last line", history,
     [](const H& h) { return h.rows.empty() ? none : count(h.rows.back().step); });
  of(t, "history.first_kind", "the kind of the first line", history,
     [](const H& h) { return h.rows.empty() ? none : std::string(name(h.rows.front().kind)); });
  of(t, "history.last_kind", "the kind of the last line", history,
     [](const H& h) { return h.rows.empty() ? none : std::string(name(h.rows.back().kind)); });
}

void add_work_questions(NamedValues& t, Investigation& m) {
  static constexpr std::array<std::string_view, 3> kinds{"insertions", "attempts", "rejections"};
  t.add(
      "work.kind", "what the heat map counts: insertions, attempts or rejections",
      [&m] { return std::string(kinds.at(static_cast<std::size_t>(m.work_kind))); },
      [&m](const std::string& text) -> Status {
        const auto found = std::find(kinds.begin(), kinds.end(), text);
        if (found == kinds.end())
          return Error{ErrorCode::usage, "insertions, attempts or rejections is needed.", ""};
        m.work_kind = static_cast<WorkKind>(found - kinds.begin());
        return {};
      });
  t.add(
      "stall.last", "how many attempts back the stall panel looks", [&m] { return count(m.stall_attempts); },
      [&m](const std::string& text) -> Status {
        const auto n = parse_number(text);
        if (!n || *n < 1 || *n > 1e6) return Error{ErrorCode::usage, "1 to 1000000 is needed.", ""};
        m.stall_attempts = static_cast<std::size_t>(*n);
        return {};
      });
  const auto work = [&m] { return m.work(); };
  using W = WorkAnswer;
  of(t, "work.total", "events on the heat map", work, [](const W& w) { return count(w.map.total); });
  of(t, "work.cells", "its cells", work, [](const W& w) { return count(w.map.cells.size()); });
  of(t, "work.hottest", "events in the busiest cell", work,
     [](const W& w) { return w.map.cells.empty() ? "0" : count(w.map.cells[0].count); });
  of(t, "work.seconds", "time of all that was decided in the range", work, [](const W& w) {
    double seconds = 0;
    for (const WorkTime& time : w.times) seconds += time.seconds;
    return text_of(seconds);
  });
  of(t, "work.decisions", "decisions in the range", work, [](const W& w) {
    std::size_t n = 0;
    for (const WorkTime& time : w.times) n += time.count;
    return count(n);
  });
  of(t, "stall.attempts", "attempts looked at", work, [](const W& w) { return count(w.stall.attempts); });
  of(t, "stall.accepted", "of these, accepted", work, [](const W& w) { return count(w.stall.accepted); });
  of(t, "stall.since_accepted", "attempts since the last accepted one", work,
     [](const W& w) { return count(w.stall.since_accepted); });
  of(t, "stall.reason", "the reason that rejected most", work, [](const W& w) {
    const auto& n = w.stall.by_reason;
    const auto most = std::max_element(n.begin() + 1, n.end());
    return *most == 0 ? none : std::string(name(static_cast<Reason>(most - n.begin())));
  });
  of(t, "stall.places", "cells with rejections among them", work,
     [](const W& w) { return count(w.stall.places.cells.size()); });
}

void add_state_questions(NamedValues& t, Investigation& m) {
  t.add("refused.distance", "the largest d on the facet that a collapse of the improver left above δ, in δ",
        [&m] {
          const auto facet = shown_refusal(m.window);
          return facet ? text_of(facet->distance / m.window.run.scene->delta) : std::string("nan");
        });

  const auto topology = [&m] { return m.topology(); };
  using T = TopologyReport;
  of(t, "topology.verdict", "whether Z has the expected topology", topology,
     [](const T& r) { return r.verdict.as_expected ? "on" : "off"; });
  of(t, "topology.components", "components of Z", topology,
     [](const T& r) { return count(r.components.size()); });
  of(t, "topology.genus", "the genus of all components", topology, [](const T& r) {
    long genus = 0;
    for (const auto& c : r.components) genus += c.counts.genus();
    return std::to_string(genus);
  });
  of(t, "topology.expected_genus", "what the boundaries say of the first component", topology,
     [](const T& r) {
       return r.components.empty() || !r.components[0].expected_genus
                  ? none
                  : std::to_string(*r.components[0].expected_genus);
     });
  of(t, "topology.boundaries", "boundary components beside the first component", topology,
     [](const T& r) { return r.components.empty() ? "0" : count(r.components[0].sides.size()); });
  of(t, "topology.wrong", "components whose genus is not that of the boundaries beside", topology,
     [](const T& r) { return count(r.wrong_components); });
  of(t, "topology.thickening", "whether the boundaries of Ω agree", topology,
     [](const T& r) { return r.thickening ? "on" : "off"; });
  t.add("topology.loop", "length of the shortest handle loop in δ", [&m] {
    const auto r = m.topology();
    double shortest = std::numeric_limits<double>::infinity();
    if (r)
      for (const auto& c : r->components)
        if (c.loop) shortest = std::min(shortest, c.loop->length);
    return shortest < std::numeric_limits<double>::infinity() ? text_of(shortest / delta_of(m)) : none;
  });

  const auto result = [&m] { return m.window.run.result; };
  of(t, "covers", "whether the finished mesh is near enough to every point of the input", result,
     [](const RunResult& r) { return r.certificate.covers ? "on" : "off"; });
  of(t, "uncovered.places", "places of the input that it leaves behind", result,
     [](const RunResult& r) { return count(r.certificate.uncovered_count); });
  t.add("uncovered.distance", "of the farthest of them, in δ", [&m] {
    if (!m.window.run.result || m.window.run.result->certificate.uncovered.empty()) return none;
    return text_of(m.window.run.result->certificate.uncovered[0].distance / delta_of(m));
  });
  t.add("uncovered.marked", "the one that is marked", [&m] {
    if (!m.window.run.result || !m.window.selection.mark) return none;
    const auto& places = m.window.run.result->certificate.uncovered;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i].point == *m.window.selection.mark) return count(i);
    return none;
  });

  const auto checked = [&m] { return m.check(); };
  using C = CheckAnswer;
  of(t, "check.step", "the step that was checked last", checked,
     [](const C& c) { return count(c.report.step); });
  of(t, "check.broken", "what is broken there", checked, [](const C& c) { return count(c.report.broken()); });
  for (std::size_t i = 0; i < invariant_count; ++i) {
    const auto invariant = static_cast<Invariant>(i);
    of(t, "check." + std::string(name(invariant)), "holds, broken, not-due or absent", checked,
       [invariant](const C& c) {
         constexpr std::array<std::string_view, 4> words{"holds", "broken", "not-due", "absent"};
         return words.at(static_cast<std::size_t>(c.report[invariant].state));
       });
  }
  of(t, "check.search", "how the search for the first invalid step ended", checked, [](const C& c) {
    constexpr std::array<std::string_view, 3> words{"found", "all-valid", "cancelled"};
    return c.first ? words.at(static_cast<std::size_t>(c.first->end)) : std::string_view("none");
  });
  of(t, "check.first_step", "the step that it found", checked, [](const C& c) {
    return c.first && c.first->end == FirstInvalid::End::found ? count(c.first->report.step) : none;
  });

  struct Name {
    const char* name;
    ParameterAdvice::Parameter parameter;
  };
  for (const Name& n :
       {Name{"alpha", ParameterAdvice::Parameter::alpha}, Name{"sigma", ParameterAdvice::Parameter::sigma},
        Name{"shrink", ParameterAdvice::Parameter::shrink}})
    t.add(std::string("advice.") + n.name,
          "where the verdict on the selection changes: a value, holds, or none", [n, &m] {
            const auto advice = m.advice();
            std::string found = none;
            for (std::size_t i = 0; advice && i < advice->size(); ++i) {
              const ParameterAdvice& a = (*advice)[i];
              if (a.parameter != n.parameter) continue;
              if (a.works) return text_of(*a.works);
              if (a.holds) found = "holds";
            }
            return found;
          });
}

} // namespace

void Investigation::add_values(NamedValues& values) {
  add_tet_questions(values, *this);
  add_history_questions(values, *this);
  add_work_questions(values, *this);
  add_state_questions(values, *this);
}

} // namespace isoscope
