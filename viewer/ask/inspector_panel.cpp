// The inspector: everything about the picked element, its numbers beside their limits, every row a link.
#include "ask/investigation.h"
#include "ask/pinned_verdict.h"

#include "criteria/height.h"
#include "criteria/orientation.h"
#include "debug/debugger.h"
#include "edge/edge_inspector.h"
#include "journal/describe.h"
#include "model/words.h"
#include "ui/answer.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace isoscope::panels {
namespace {

void pick(Ui& ui, const char* kind, std::uint32_t id) {
  ui.commands.post("pick", {kind, std::to_string(id)});
}

std::string position_text(Vec3 p) {
  return short_number(p.x) + "  " + short_number(p.y) + "  " + short_number(p.z);
}

const char* kind_text(VertexKind kind) {
  constexpr std::array<const char*, 6> words{"corner of the bounding box",
                                             "sample of S",
                                             "containment",
                                             "region witness",
                                             "topology",
                                             "vertex of Z"};
  return words.at(static_cast<std::size_t>(kind));
}

/// The circumscribed sphere of a tetrahedron; radius infinite for a flat one.
struct Sphere {
  Vec3 center;
  double radius = 0;
};
Sphere circumsphere(const std::array<Vec3, 4>& p) {
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double det = 2 * dot(a, cross(b, c));
  const Vec3 offset =
      (squared_length(a) * cross(b, c) + squared_length(b) * cross(c, a) + squared_length(c) * cross(a, b)) /
      det;
  return {p[0] + offset, length(offset)};
}

void vertex_details(Ui& ui, Investigation& asked, const std::shared_ptr<const StateSnapshot>& state,
                    std::uint32_t id) {
  const StateSnapshot& s = *state;
  if (id >= s.complex.vertices.size())
    return widgets::quiet_text(ui, "This vertex is not there at this step.", true);
  const Vertex& v = s.complex.vertices[id];
  widgets::heading(ui, icon::dot, "Vertex " + grouped(id), kind_text(v.kind));
  widgets::value_row(ui, "position", position_text(v.position));
  widgets::value_row(ui, "F", short_number(v.value),
                     v.value > 0   ? ui.colors.accent_text
                     : v.value < 0 ? ui.colors.inner
                                   : ui.colors.text);
  if (v.sample.valid() && widgets::link_row(ui, "sample", "made of sample", grouped(v.sample.value),
                                            "Selects the sample that became this vertex."))
    pick(ui, "sample", v.sample.value);
  if (const auto born = ui.window.index.birth_of(VertexId(id))) {
    const Journal& journal = *ui.window.index.journal();
    const Event& event = journal.events()[journal.operations()[*born].event];
    if (widgets::link_row(ui, "born", "born at step", grouped(*born + 1), describe(journal, event)))
      ui.commands.post("seek", {std::to_string(*born + 1)});
  }
  const auto& star = asked.star_of(state, VertexId(id));
  if (star.first &&
      widgets::link_row(ui, "star", "tetrahedra around it", grouped(star.degree), "Selects one of them."))
    pick(ui, "tet", star.first->value);
}

/// Where the operation that led here is about the sample: what held of it before. The rest is of the state
/// after it.
void before_the_operation(Ui& ui, const StateSnapshot& s, std::uint32_t id, int label) {
  if (!s.event || s.event->kind != EventKind::insertion || s.event->sample.value != id) return;
  const Event& e = *s.event;
  const bool judged = e.condition == Condition::classification;
  widgets::subtitle(ui, "Before this operation");
  if (judged) {
    widgets::verdict_text(ui, !is_bad(e.value),
                          !is_bad(e.value) ? "good, but beyond 1 − α" : "bad: f had the wrong sign here");
    widgets::value_row(ui, "f(s)", short_number((1 - e.value) * (label > 0 ? 1 : -1)));
    widgets::limit_bar(ui, "error ε(s)", e.value, e.limit, e.value <= e.limit, "", true);
  } else {
    widgets::quiet_text(ui,
                        "It was no vertex of T; condition " + std::string(words(e.condition).title) +
                            " chose it as the sample nearest to the circumcentre of a tetrahedron.",
                        true);
  }
  widgets::subtitle(ui, "After it: a vertex of T");
}

void sample_details(Ui& ui, const Investigation& asked, const StateSnapshot& s, std::uint32_t id) {
  const bool classified = s.classifies();
  if (!s.samples || id >= s.samples->size() || (classified && id >= s.errors.size()))
    return widgets::quiet_text(ui, "This sample is not in the set of this step.", true);
  const int label = s.samples->labels[id];
  const double error = classified ? static_cast<double>(s.errors[id]) : 0;
  widgets::heading(ui, is_bad(error) ? icon::close : icon::dot, "Sample " + grouped(id),
                   !classified     ? s.complex.form == ZeroForm::free ? "not classified: Z is outside of T"
                                                                      : "not judged yet: T is not there yet"
                   : is_bad(error) ? "bad: f has the wrong sign here (§2.2)"
                                   : "good: f has its sign (§2.2)");
  widgets::value_row(ui, "position", position_text(s.samples->positions[id]));
  widgets::value_row(ui, "side F(s)",
                     (label > 0 ? "+1  " : "−" + std::to_string(-label) + "  ") +
                         side_text(label, ui.window.has_rooms()),
                     label > 0 ? ui.colors.accent_text : ui.colors.inner);
  before_the_operation(ui, s, id, label);
  if (const std::string may_stay = ui.window.why_bad_may_stay(); is_bad(error) && !may_stay.empty())
    widgets::quiet_text(ui, may_stay, true);
  if (classified) {
    widgets::value_row(ui, "f(s)", short_number((1 - error) * (label > 0 ? 1 : -1)));
    widgets::limit_bar(ui, "error ε(s)", error, s.criteria.error_limit(), error <= s.criteria.error_limit(),
                       "", true);
  } else if (s.complex.form != ZeroForm::free) {
    widgets::value_row(ui, "error ε(s)", "–", ui.colors.quiet);
    widgets::quiet_text(ui, "f lives on T, so it is good or bad from the first step on.", true);
  } else {
    widgets::quiet_text(ui,
                        "f lives on T, so nothing says any more on which side of Z the sample is. The "
                        "proof of d ≤ δ on every facet of Z stands in for it.",
                        true);
  }
  if (id < s.sample_tets.size() && s.sample_tets[id].valid() &&
      widgets::link_row(ui, "tet", "lies in tetrahedron", grouped(s.sample_tets[id].value), "Selects it."))
    pick(ui, "tet", s.sample_tets[id].value);
  const std::uint16_t component = s.samples->components[id];
  if (component != 0xffff) widgets::value_row(ui, "component of ∂Ω", std::to_string(component));
  rim_rows(ui, asked);
  sample_questions(ui, s, id);
}

void orientation_details(Ui& ui, const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                         const TetLabels& labels, const CriteriaParameters& criteria) {
  const auto index = ui.window.sample_index();
  if (!index) return widgets::quiet_text(ui, "Condition 3 is judged when the play head rests.", true);
  const OrientationVerdict verdict =
      check_orientation(p, f, labels, criteria.shrink, orientation_reach * criteria.delta, index->nearest);
  widgets::value_row(ui, "condition 3, orientation", verdict.misoriented ? "misoriented" : "holds",
                     verdict.misoriented ? ui.colors.bad_text : ui.colors.good_text);
  for (std::size_t i = 0; i < verdict.tests.size(); ++i) {
    const OrientationTest& test = verdict.tests[i];
    if (!test.asked()) continue;
    ImGui::PushID(static_cast<int>(i));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushFont(ui.fonts.small);
    ImGui::SetCursorScreenPos({at.x, at.y + ui.px(4)});
    widgets::verdict_glyph(ui, test.good());
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({at.x + ui.px(20), at.y});
    const std::string name = "vertex " + std::to_string(i / 2) + ", " + side_text(test.label) + " sample " +
                             grouped(test.sample.value);
    if (widgets::link_row(ui, "test", name, "f " + short_number(test.f),
                          "f, + on that side, must be positive at its sample nearest to the shrunk vertex. "
                          "Click selects the sample."))
      pick(ui, "sample", test.sample.value);
    ImGui::SetCursorScreenPos({at.x, ImGui::GetCursorScreenPos().y});
    ImGui::PopID();
  }
}

void height_details(Ui& ui, const StateSnapshot& s, const std::array<Vec3, 4>& p,
                    const std::array<double, 4>& f, const TetLabels& labels, const Tet& tet) {
  const Height height = tetrahedron_height(p, f, labels);
  if (height.split == Height::Split::none) return;
  const double delta = s.criteria.unit();
  const double limit = s.criteria.height_limit() / delta;
  widgets::limit_bar(ui, "height (condition 2)", height.value / delta, limit, height.value / delta >= limit,
                     "δ", false);
  const auto name = [&](std::size_t i) { return std::to_string(tet.v.at(height.order.at(i)).value); };
  const std::string between = height.split == Height::Split::one_three
                                  ? "point " + name(0) + " – plane " + name(1) + " " + name(2) + " " + name(3)
                                  : "line " + name(0) + " " + name(1) + " – line " + name(2) + " " + name(3);
  widgets::value_row(ui, "between", between);
}

void tet_details(Ui& ui, Investigation& asked, const StateSnapshot& s, std::uint32_t id) {
  if (id >= s.complex.tets.size() || !s.complex.tets[id].alive())
    return widgets::quiet_text(ui, "This tetrahedron is not there at this step.", true);
  const Tet& tet = s.complex.tets[id];
  const auto p = s.complex.positions(TetId(id));
  const auto f = s.complex.values(TetId(id));
  const std::uint8_t flags = id < s.tet_flags.size() ? s.tet_flags[id] : std::uint8_t{0};
  const bool carries = (flags & tet_heterogeneous) != 0;
  widgets::heading(ui, icon::cube, "Tetrahedron " + grouped(id),
                   s.complex.form == ZeroForm::embedded
                       ? side_text(tet.side, ui.window.has_rooms()) + (carries ? ", in Γ" : "")
                   : carries                ? std::string("carries Z: in Γ")
                   : (flags & tet_box) != 0 ? "at the bounding box"
                                            : "one label: no Z in it");
  for (std::size_t i = 0; i < 4; ++i) {
    if (widgets::link_row(ui, "vertex", "vertex " + grouped(tet.v[i].value), "F " + short_number(f[i]),
                          "Selects the vertex.", i))
      pick(ui, "vertex", tet.v[i].value);
  }
  const AffineFunction function = interpolate(p, f);
  const double delta = s.criteria.unit();
  widgets::value_row(ui, "gradient |grad f| · δ", short_number(length(function.gradient) * delta));
  widgets::value_row(ui, "grad f, direction", position_text(normalized(function.gradient)));
  const Sphere sphere = circumsphere(p);
  widgets::value_row(ui, "circumradius", short_number(sphere.radius / delta) + " δ");
  ImGui::Dummy({0, ui.px(4)});
  std::size_t held = 0, beyond = 0;
  std::uint32_t worst = SampleId::none;
  for (std::size_t k = 0; k < s.sample_tets.size(); ++k) {
    if (s.sample_tets[k].value != id) continue;
    ++held;
    beyond += static_cast<double>(s.errors[k]) > s.criteria.error_limit();
    if (worst == SampleId::none || s.errors[k] > s.errors[worst]) worst = static_cast<std::uint32_t>(k);
  }
  widgets::value_row(ui, "samples inside",
                     grouped(held) + (beyond ? ", " + grouped(beyond) + " beyond 1 − α" : ""),
                     beyond ? ui.colors.bad_text : ui.colors.text);
  if (worst != SampleId::none) {
    const auto error = static_cast<double>(s.errors[worst]);
    widgets::limit_bar(ui, "largest ε (condition 1)", error, s.criteria.error_limit(),
                       error <= s.criteria.error_limit(), "", true);
    if (widgets::link_row(ui, "worst", "its worst sample", grouped(worst), "Selects it."))
      pick(ui, "sample", worst);
  }
  if (!carries || s.complex.form != ZeroForm::interpolated) return;
  const TetLabels labels = s.complex.labels(TetId(id));
  height_details(ui, s, p, f, labels, tet);
  orientation_details(ui, p, f, labels, s.criteria);
  tet_questions(ui, asked, s, id);
}

void facet_details(Ui& ui, const StateSnapshot& s, std::uint32_t id) {
  if (id >= s.complex.facets.size() || !s.complex.facets[id].alive())
    return widgets::quiet_text(ui, "This facet is not there at this step.", true);
  const auto& v = s.complex.facets[id].v;
  widgets::heading(ui, icon::cube, "Facet " + grouped(id), "of Z, outside of T");
  Triangle3 p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = s.complex.position(v[i]);
    if (widgets::link_row(ui, "vertex", "vertex", grouped(v[i].value), "Selects the vertex.", i))
      pick(ui, "vertex", v[i].value);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId a = v[i], b = v[(i + 1) % 3];
    if (widgets::link_row(ui, "edge", "edge", std::to_string(a.value) + " – " + std::to_string(b.value),
                          "Selects the edge.", i))
      ui.commands.post("pick", {"edge", std::to_string(a.value), std::to_string(b.value)});
  }
  const double delta = s.criteria.unit();
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  widgets::value_row(ui, "area", short_number(0.5 * length(normal) / (delta * delta)) + " δ²");
  widgets::value_row(ui, "normal", position_text(normalized(normal)));
  const auto& scene = ui.window.run.scene;
  if (!scene || !scene->field) return;
  double largest = 0;
  const Vec3 center = (1.0 / 3) * (p[0] + p[1] + p[2]);
  for (const Vec3& q : {p[0], p[1], p[2], center}) largest = std::max(largest, scene->field->distance(q));
  widgets::limit_bar(ui, "φ at corners and centroid", largest / delta, 1, largest <= delta, "δ", true);
}

/// What is known before there is a scene.
void input_facts(const Ui& ui, const TriangleSoup& input) {
  ImGui::Dummy({0, ui.px(4)});
  if (!input.triangles.empty()) widgets::value_row(ui, "triangles", grouped(input.triangles.size()));
  widgets::value_row(ui, input.is_point_set() ? "points" : "vertices", grouped(input.points.size()));
  widgets::value_row(ui, "longest edge of its box", short_number(ui.window.scene_bounds().longest_edge()));
}

void run_summary(Ui& ui, const StateSnapshot& s) {
  const WindowState& m = ui.window;
  widgets::bold_text(ui, "This step");
  widgets::value_row(ui, "step", grouped(s.step) + " of " + grouped(m.live_step()));
  if (s.event && s.event->vertex.valid() && s.event->other.valid() &&
      widgets::link_row(ui, "operation", "edge of the operation",
                        std::to_string(s.event->vertex.value) + " – " + std::to_string(s.event->other.value),
                        "Selects it: the X-ray shows the moment before."))
    ui.commands.post("pick-operation");
  if (!s.moves.empty()) widgets::value_row(ui, "vertices moved", grouped(s.moves.size()));
  if (!s.added_facets.empty() || !s.removed_facets.empty())
    widgets::value_row(ui, "facets of Z",
                       "−" + grouped(s.removed_facets.size()) + "  +" + grouped(s.added_facets.size()));
  const bool free = s.complex.form == ZeroForm::free, interpolated = s.complex.form == ZeroForm::interpolated;
  if (!free) {
    const std::size_t samples = s.samples ? s.samples->size() : 0;
    widgets::value_row(ui, "samples", grouped(samples));
    if (s.samples && !s.samples->over_rim.empty())
      widgets::value_row(ui, "boundary samples B", grouped(s.samples->over_rim.size()));
    // Without samples or before T is there nothing is judged, which is not "none is bad".
    const bool judged = samples > 0 && s.classifies();
    const std::string may_stay = m.why_bad_may_stay();
    widgets::value_row(ui, "bad samples", judged ? grouped(s.bad_samples) : "–",
                       !judged             ? ui.colors.quiet
                       : !may_stay.empty() ? ui.colors.text
                       : s.bad_samples     ? ui.colors.bad_text
                                           : ui.colors.good_text);
    if (!may_stay.empty()) widgets::quiet_text(ui, may_stay, true);
  }
  const auto largest = static_cast<double>(s.largest_error);
  if (interpolated && s.classifies())
    widgets::limit_bar(ui, "largest ε", largest, s.criteria.error_limit(),
                       largest <= s.criteria.error_limit(), "", true);
  if (interpolated && s.classifies() && s.worst_sample.valid() &&
      widgets::link_row(ui, "worst", "worst sample", grouped(s.worst_sample.value),
                        "Selects the sample with the largest ε."))
    pick(ui, "sample", s.worst_sample.value);
  if (!free) {
    const auto alive = std::count_if(s.complex.vertices.begin(), s.complex.vertices.end(),
                                     [](const Vertex& v) { return v.alive; });
    widgets::value_row(ui, "vertices of T", grouped(static_cast<std::size_t>(alive)));
    widgets::value_row(ui, "tetrahedra of T", grouped(s.complex.alive_tets()));
  }
  widgets::value_row(ui, "vertices of Z", grouped(s.zero_set.vertices.size()));
  widgets::value_row(ui, "components of Z", grouped(s.zero_set.components.size()));
  if (s.zero_set.boundary_loops() > 0)
    widgets::value_row(ui, "loops of the border of Z", grouped(s.zero_set.boundary_loops()));
  widgets::value_row(ui, "χ of Z", std::to_string(s.zero_set.euler_characteristic()));
  if (m.run.scene && m.run.scene->expected.euler_characteristic)
    widgets::value_row(ui, "χ expected", std::to_string(*m.run.scene->expected.euler_characteristic));
  ImGui::Dummy({0, ui.px(6)});
}

} // namespace

void inspector(Ui& ui, EdgeProbe& probe, const Debugger& debugger, Investigation& asked) {
  const WindowState& m = ui.window;
  const auto state = m.state();
  const Pick& picked = m.selection.picked;
  const bool preparing = m.run.phase == SessionPhase::preparing;
  if (!state || ((preparing || m.run.phase == SessionPhase::failed) && !m.run.scene)) {
    widgets::bold_text(ui, "Inspector");
    widgets::quiet_text(ui, preparing ? "The run is being prepared." : "Open a model to begin.", true);
    if (preparing && m.run.input) input_facts(ui, *m.run.input);
    return;
  }
  const bool at_end = m.run.result && m.transport.step() >= m.live_step(),
             leaves_end = ui.window.inspected_end && !at_end;
  ui.window.inspected_end = at_end;
  if (leaves_end || !(picked == ui.window.inspected) || m.selection.event != ui.window.inspected_event) {
    // What is selected anew begins at the top, and so does what no certificate stands below any more.
    ui.window.inspected = picked;
    ui.window.inspected_event = m.selection.event;
    ui.window.answer.wanted = AnswerKind::none;
    ImGui::SetScrollY(0);
  }
  switch (picked.kind) {
  case Pick::Kind::vertex:
    vertex_details(ui, asked, state, picked.id);
    break;
  case Pick::Kind::edge:
    edge_details(ui, probe, *state);
    break;
  case Pick::Kind::facet:
    facet_details(ui, *state, picked.id);
    break;
  case Pick::Kind::tet:
    tet_details(ui, asked, *state, picked.id);
    break;
  case Pick::Kind::sample:
    sample_details(ui, asked, *state, picked.id);
    break;
  case Pick::Kind::over_rim:
    over_rim_details(ui, asked, *state, picked.id);
    break;
  case Pick::Kind::point:
    point_details(ui, asked, picked.id);
    break;
  case Pick::Kind::none:
    break;
  }
  if (picked.kind != Pick::Kind::none) {
    advice(ui, asked);
    ImGui::Dummy({0, ui.px(6)});
    history_buttons(ui);
    break_rows(ui, debugger);
    ImGui::Separator();
    ImGui::Dummy({0, ui.px(4)});
  }
  run_summary(ui, *state);
  points_summary(ui);
  if (picked.kind == Pick::Kind::none) break_rows(ui, debugger);
  certificate(ui);
  state_questions(ui, asked, *state);
  if (picked.kind == Pick::Kind::none)
    widgets::quiet_text(ui, "Click an element in the view to inspect it; 1 to 4 restrict what a click hits.",
                        true);
  pinned_verdict(ui, element_verdict(ui, probe, *state));
}

} // namespace isoscope::panels
