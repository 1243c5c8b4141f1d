// What scripts can expect of the answers to questions, and the settings of these.
#include "ask/investigation.h"

#include "model/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

double delta_of(const Investigation& m) {
  const auto state = m.window.state();
  return state ? state->criteria.unit() : 1;
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

/// Lengths in δ.
auto in_delta(const Investigation& m) {
  return [&m](double length) { return length / delta_of(m); };
}

void add_tet_questions(NamedValues& t, Investigation& m) {
  const auto tet = t.readings("tet.", [&m] { return tet_shown(m); });
  const auto sample = t.readings("sample.", [&m] { return sample_shown(m); });
  const auto violations = t.readings("violations.", [&m] { return m.window.state(); });
  const auto length = in_delta(m);
  using Tet = TetInspection;
  using Sample = SampleInspection;
  t.add(
      "inspect.shrink", "factor of the shrunk copy that is drawn, 0 for condition 3's own",
      [&m] { return m.shrink.value_or(0); },
      [&m](const std::string& text) -> Status {
        const auto n = read_field<double>({.range = {.low = 0, .high = 1}}, "inspect.shrink", text);
        if (!n) return n.error();
        m.shrink = *n > 0 ? std::optional<double>(*n) : std::nullopt;
        return {};
      });
  violations("misoriented", "tetrahedra that violate condition 3", [](const StateSnapshot& s) {
    return s.orientation_judged && s.classifies() ? std::optional(misoriented_tets(s).size()) : std::nullopt;
  });
  violations("flat", "tetrahedra that carry Z below 2σ/α", [](const StateSnapshot& s) {
    return s.classifies() ? std::optional(violating_tets(s, ViolationKind::flat).size()) : std::nullopt;
  });
  const auto tests = [&tet](const char* name, const char* help, auto counts) {
    tet(name, help, [counts](const Tet& x) -> std::optional<std::ptrdiff_t> {
      if (!x.orientation) return std::nullopt;
      return std::count_if(x.orientation->tests.begin(), x.orientation->tests.end(), counts);
    });
  };
  tet("misoriented", "the selected tetrahedron violates condition 3 at inspect.shrink",
      [](const Tet& x) { return x.orientation ? std::optional(x.orientation->misoriented) : std::nullopt; });
  tests("tests", "its samples of condition 3 that are asked", [](const auto& test) { return test.asked(); });
  tests("failed_tests", "of these, the ones that fail", [](const auto& test) { return !test.good(); });
  tet("height", "its height in δ", [length](const Tet& x) { return length(x.height.value); });
  tet("gap", "distance of the ends of its height, in δ",
      [length](const Tet& x) { return length(distance(x.gap[0], x.gap[1])); });
  t.readings("tet.", [&m] { return m.window.state(); })(
      "height_limit", "2σ/α in δ",
      [length](const StateSnapshot& s) { return length(s.criteria.height_limit()); });
  sample("error", "ε of the selected sample", &Sample::error);
  sample("f", "f at it", &Sample::f);
  sample("class", "good or bad", [](const Sample& x) { return x.bad ? "bad" : "good"; });
  sample("remedy", "how it will be mended", [](const Sample& x) {
    constexpr std::array<std::string_view, 6> words{"none-needed",  "not-asked",    "itself-next",
                                                    "itself-later", "worse-in-tet", "vertex-already"};
    return words.at(static_cast<std::size_t>(x.remedy));
  });
  sample("fixer", "the sample that is inserted for it", &Sample::fixer);
  sample("tet", "the tetrahedron that holds it", &Sample::tet);
  sample("tets_before", "tetrahedra that get a point first", &Sample::tets_before);
}

void add_history_questions(NamedValues& t, Investigation& m) {
  const auto history = t.readings("history.", [&m] { return m.history(); });
  using H = ElementHistory;
  history("rows", "lines of the selected element's history", [](const H& h) { return h.rows.size(); });
  t.readings(
      "history.", [&m] { return m.history(); },
      "nan")("shown", "those within the chosen range", [&m](const H& h) {
    const auto& range = m.window.range;
    const auto in = [&](const HistoryRow& row) { return !range || range->holds(row.step); };
    return std::count_if(h.rows.begin(), h.rows.end(), in);
  });
  history("changes", "those that changed it", &H::changes);
  history("attempts", "attempts to collapse the edge", &H::attempts);
  history("rejections", "those that failed", &H::rejections);
  history("absorbed", "vertices that ended in the vertex", &H::absorbed);
  history("heir", "who stands for the vertex at the end", &H::heir);
  history("places", "places of the vertex' way", [](const H& h) { return h.path.size(); });
  const auto row = [&m](bool first) {
    return [&m, first]() -> std::optional<HistoryRow> {
      const auto h = m.history();
      if (!h || h->rows.empty()) return std::nullopt;
      return first ? h->rows.front() : h->rows.back();
    };
  };
  const auto first = t.readings("history.first_", row(true)), last = t.readings("history.last_", row(false));
  first("step", "the step of the first line", &HistoryRow::step);
  last("step", "the step of the last line", &HistoryRow::step);
  first("kind", "the kind of the first line", &HistoryRow::kind);
  last("kind", "the kind of the last line", &HistoryRow::kind);
}

void add_point_questions(NamedValues& t, Investigation& m) {
  const auto point = t.readings("point.", [&m] { return m.point(); });
  using P = PointInspection;
  const auto delta = [&m] { return m.window.run.scene ? m.window.run.scene->delta : 1.0; };
  point("neighbours", "how many points the selected one is averaged with, itself among them",
        [](const P& x) { return x.neighbors.size(); });
  point("weight", "√w of the selected point, in δ",
        [delta](const P& x) { return std::sqrt(x.weight) / delta(); });
  point("radius", "the radius of its ball in δ, 0 where it has none",
        [delta](const P& x) { return x.ball_radius(delta()) / delta(); });
  point("dropped", "no, outlier or blob", [](const P& x) {
    return x.kept ? "no" : x.dropped == DroppedPoints::Why::outliers ? "outlier" : "blob";
  });
}

void add_work_questions(NamedValues& t, Investigation& m) {
  static constexpr std::array<Choice, 3> kinds{{{"insertions"}, {"attempts"}, {"rejections"}}};
  t.bind("work.kind", "what the heat map counts: insertions, attempts or rejections", {.choices = kinds},
         m.work_kind);
  t.bind("stall.last", "how many attempts back the stall panel looks",
         {.range = {.low = 1, .high = 1e6, .wrong = "not from 1 to 1000000"}}, m.stall_attempts);
  using W = WorkAnswer;
  const auto work = t.readings("work.", [&m] { return m.work(); });
  const auto stall = t.readings("stall.", [&m] { return m.work(); });
  work("total", "events on the heat map", [](const W& w) { return w.map.total; });
  work("cells", "its cells", [](const W& w) { return w.map.cells.size(); });
  work("hottest", "events in the busiest cell",
       [](const W& w) { return w.map.cells.empty() ? 0 : w.map.cells[0].count; });
  const auto sum = [](auto member) {
    return [member](const W& w) {
      auto all = WorkTime().*member;
      for (const WorkTime& time : w.times) all += time.*member;
      return all;
    };
  };
  work("seconds", "time of all that was decided in the range", sum(&WorkTime::seconds));
  work("decisions", "decisions in the range", sum(&WorkTime::count));
  stall("attempts", "attempts looked at", [](const W& w) { return w.stall.attempts; });
  stall("accepted", "of these, accepted", [](const W& w) { return w.stall.accepted; });
  stall("since_accepted", "attempts since the last accepted one",
        [](const W& w) { return w.stall.since_accepted; });
  stall("reason", "the reason that rejected most", [](const W& w) {
    const auto& n = w.stall.by_reason;
    const auto most = std::max_element(n.begin() + 1, n.end());
    return *most == 0 ? std::string_view("none") : name(static_cast<Reason>(most - n.begin()));
  });
  stall("places", "cells with rejections among them", [](const W& w) { return w.stall.places.cells.size(); });
}

void add_topology_questions(NamedValues& t, Investigation& m) {
  t.readings(
      "refused.", [&m] { return shown_refusal(m.window); },
      "nan")("distance", "the largest d on the facet that a collapse of the improver left above δ, in δ",
             [&m](const RefusedFacet& facet) { return facet.distance / m.window.run.scene->delta; });

  t.bind("topology.shown", "whether the topology of Z is judged and drawn", {}, m.topology_shown);
  using T = TopologyReport;
  const auto topology = t.readings("topology.", [&m] { return m.topology(); });
  topology("verdict", "whether Z has the expected topology",
           [](const T& r) { return r.verdict.as_expected; });
  topology("components", "components of Z", [](const T& r) { return r.components.size(); });
  topology("genus", "the genus of all components", [](const T& r) {
    long genus = 0;
    for (const auto& c : r.components) genus += c.counts.genus();
    return genus;
  });
  topology("expected_genus", "what the boundaries say of the first component", [](const T& r) {
    return r.components.empty() ? decltype(r.components[0].expected_genus)() : r.components[0].expected_genus;
  });
  topology("boundaries", "boundary components beside the first component",
           [](const T& r) { return r.components.empty() ? 0 : r.components[0].sides.size(); });
  topology("wrong", "components whose genus is not that of the boundaries beside", &T::wrong_components);
  topology("thickening", "whether the boundaries of Ω agree", &T::thickening);
  topology("loop", "length of the shortest handle loop in δ",
           [length = in_delta(m)](const T& r) -> std::optional<double> {
             double shortest = std::numeric_limits<double>::infinity();
             for (const auto& c : r.components)
               if (c.loop) shortest = std::min(shortest, c.loop->length);
             if (std::isinf(shortest)) return std::nullopt;
             return length(shortest);
           });
}

void add_result_questions(NamedValues& t, Investigation& m) {
  const auto result = [&m] { return m.window.run.result; };
  using R = RunResult;
  t.readings("", result)("covers", "whether the finished mesh is near enough to every point of the input",
                         [](const R& r) { return r.certificate.covers; });
  const auto uncovered = t.readings("uncovered.", result);
  uncovered("places", "places of the input that it leaves behind",
            [](const R& r) { return r.certificate.uncovered_count; });
  uncovered("distance", "of the farthest of them, in δ",
            [length = in_delta(m)](const R& r) -> std::optional<double> {
              if (r.certificate.uncovered.empty()) return std::nullopt;
              return length(r.certificate.uncovered[0].distance);
            });
  uncovered("marked", "the one that is marked", [&m](const R& r) -> std::optional<std::size_t> {
    const auto& places = r.certificate.uncovered;
    for (std::size_t i = 0; m.window.selection.mark && i < places.size(); ++i)
      if (places[i].point == *m.window.selection.mark) return i;
    return std::nullopt;
  });

  const auto checked = t.readings("check.", [&m] { return m.check(); });
  using C = CheckAnswer;
  checked("step", "the step that was checked last", [](const C& c) { return c.report.step; });
  checked("broken", "what is broken there", [](const C& c) { return c.report.broken(); });
  for (std::size_t i = 0; i < invariant_count; ++i) {
    const auto invariant = static_cast<Invariant>(i);
    checked(std::string(name(invariant)), "holds, broken, not-due or absent", [invariant](const C& c) {
      constexpr std::array<std::string_view, 4> words{"holds", "broken", "not-due", "absent"};
      return words.at(static_cast<std::size_t>(c.report[invariant].state));
    });
  }
  checked("search", "how the search for the first invalid step ended", [](const C& c) {
    constexpr std::array<std::string_view, 3> words{"found", "all-valid", "cancelled"};
    return c.first ? words.at(static_cast<std::size_t>(c.first->end)) : std::string_view("none");
  });
  checked("first_step", "the step that it found", [](const C& c) {
    return c.first && c.first->end == FirstInvalid::End::found ? std::optional(c.first->report.step)
                                                               : std::nullopt;
  });
}

void add_advice(NamedValues& t, Investigation& m) {
  using P = ParameterAdvice::Parameter;
  for (const auto& [word, parameter] :
       {std::pair{"alpha", P::alpha}, {"sigma", P::sigma}, {"shrink", P::shrink}})
    t.readings("advice.", [&m] { return m.advice(); })(
        word, "where the verdict on the selection changes: a value, holds, or none",
        [parameter = parameter](const std::vector<ParameterAdvice>& advice) {
          std::string found = "none";
          for (const ParameterAdvice& a : advice) {
            if (a.parameter != parameter) continue;
            if (a.works) return text_of(*a.works);
            if (a.holds) found = "holds";
          }
          return found;
        });
}

} // namespace

void Investigation::add_values(NamedValues& values) {
  add_tet_questions(values, *this);
  add_point_questions(values, *this);
  add_history_questions(values, *this);
  add_work_questions(values, *this);
  add_topology_questions(values, *this);
  add_result_questions(values, *this);
  add_advice(values, *this);
  add_rim_values(values);
}

} // namespace isoscope
