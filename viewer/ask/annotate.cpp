// What the answers draw: the tetrahedron's copy and height, a sample's remedy, a point's neighbours and ball,
// a vertex' way, heat, handle loops, places where something is broken.
#include "ask/investigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isoscope {
namespace {

constexpr std::size_t most_cells = 500;

void tet(const Investigation& i, const StateSnapshot& s, TetId t, Annotation& a) {
  const auto index = i.window.sample_index();
  const auto x = inspect_tet(s, t, i.shrink.value_or(s.criteria.shrink),
                             index && index->set == s.samples ? &index->nearest : nullptr);
  if (!x) return;
  const auto& q = x->shrunk;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = j + 1; k < 4; ++k) a.lines.push_back({q[j], q[k], Tone::accent, 1.8f, false});
  if (x->orientation)
    for (const OrientationTest& test : x->orientation->tests) {
      if (!test.asked()) continue;
      const Vec3 sample = s.samples->positions[test.sample.index()];
      const Tone tone = test.good() ? Tone::good : Tone::bad;
      a.lines.push_back({test.shrunk, sample, tone, 1.6f, !test.good()});
      a.marks.push_back({sample, tone, test.good() ? MarkerShape::disc : MarkerShape::cross, 11});
    }
  if (x->height.split == Height::Split::none) return;
  const auto p = s.complex.positions(t);
  const auto& o = x->height.order;
  const Tone tone = x->height.value < s.criteria.height_limit() ? Tone::warning : Tone::quiet;
  a.lines.push_back({x->gap[0], x->gap[1], tone, 3.2f, false});
  for (const Vec3& end : x->gap) a.marks.push_back({end, tone, MarkerShape::square, 7});
  const auto thick = [&](std::size_t j, std::size_t k) {
    a.lines.push_back({p[o[j]], p[o[k]], tone, 2.6f, false});
  };
  if (x->height.split == Height::Split::two_two) {
    thick(0, 1);
    thick(2, 3);
    // The lines reach the ends of the height also where those lie outside the tetrahedron.
    a.lines.push_back({p[o[0]], x->gap[0], tone, 1.2f, true});
    a.lines.push_back({p[o[2]], x->gap[1], tone, 1.2f, true});
  } else {
    thick(1, 2);
    thick(2, 3);
    thick(3, 1);
    a.faces.push_back({{p[o[1]], p[o[2]], p[o[3]]}, tone, 0.25f});
    a.lines.push_back({p[o[1]], x->gap[1], tone, 1.2f, true});
  }
}

void sample(const StateSnapshot& s, SampleId id, Annotation& a) {
  const auto x = inspect_sample(s, id);
  if (!x || !x->fixer.valid() || x->fixer == id) return;
  const Vec3 from = s.samples->positions[id.index()], to = s.samples->positions[x->fixer.index()];
  a.lines.push_back({from, to, Tone::accent, 1.6f, true});
  a.marks.push_back({to, Tone::accent, MarkerShape::diamond, 13});
}

void way(const ElementHistory& h, Annotation& a) {
  for (std::size_t i = 1; i < h.path.size(); ++i)
    a.lines.push_back({h.path[i - 1], h.path[i], Tone::accent, 2.6f, false});
  for (const auto& in : h.inflows) {
    a.lines.push_back({in.from, in.to, Tone::quiet, 1.4f, true});
    a.marks.push_back({in.from, Tone::quiet, MarkerShape::hollow_square, 8});
  }
  for (const Vec3& p : h.path) a.marks.push_back({p, Tone::accent, MarkerShape::disc, 6});
  if (!h.path.empty()) a.marks.push_back({h.path.front(), Tone::accent, MarkerShape::hollow_diamond, 14});
}

void heat(const WorkMap& map, Annotation& a) {
  if (map.cells.empty()) return;
  const auto most = static_cast<float>(map.cells.front().count);
  for (std::size_t i = 0; i < std::min(most_cells, map.cells.size()); ++i)
    a.cells.push_back({map.cells[i].center, map.cell_size, static_cast<float>(map.cells[i].count) / most});
}

void loops(const TopologyReport& report, const StateSnapshot& s, Annotation& a) {
  for (const ComponentReport& c : report.components) {
    if (!c.loop) continue;
    const auto& v = c.loop->vertices;
    const bool good = c.as_expected() && report.verdict.as_expected;
    for (std::size_t i = 0; i < v.size(); ++i)
      a.lines.push_back({s.zero_set.vertices[v[i]].position,
                         s.zero_set.vertices[v[(i + 1) % v.size()]].position, good ? Tone::accent : Tone::bad,
                         3.6f, !good});
  }
}

/// A circle around a centre, across an axis.
void circle(Vec3 center, double radius, int axis, Tone tone, Annotation& a) {
  constexpr int parts = 64;
  const auto at = [&](int i) {
    const double turn = 2 * std::numbers::pi * i / parts;
    Vec3 p = center;
    p[(axis + 1) % 3] += radius * std::cos(turn);
    p[(axis + 2) % 3] += radius * std::sin(turn);
    return p;
  };
  for (int i = 0; i < parts; ++i) a.lines.push_back({at(i), at(i + 1), tone, 1.3f, false});
}

/// A point's neighbours, their mean, and the ball that the point gives Ω.
void point_and_ball(const PointInspection& x, const Scene& scene, Annotation& a) {
  for (const std::uint32_t i : x.neighbors) {
    const Vec3 p = scene.points->points->points[i];
    a.lines.push_back({p, x.mean, Tone::accent, 1.3f, false});
    a.marks.push_back({p, Tone::accent, MarkerShape::ring, 9});
  }
  a.marks.push_back({x.mean, Tone::accent, MarkerShape::diamond, 12});
  if (x.position != x.mean) a.lines.push_back({x.position, x.mean, Tone::quiet, 2.2f, true});
  if (const double radius = x.ball_radius(scene.delta); radius > 0)
    for (int axis = 0; axis < 3; ++axis) circle(x.mean, radius, axis, Tone::quiet, a);
}

/// From a sample to its closest point and, where that is another one, to the rim.
void to_rim(const RimInspection& x, Vec3 sample, Annotation& a) {
  a.lines.push_back({sample, x.closest, Tone::accent, 1.8f, false});
  a.marks.push_back({x.closest, Tone::accent, MarkerShape::disc, 7});
  if (x.over_rim) return;
  a.lines.push_back({sample, x.on_rim, Tone::quiet, 1.4f, true});
  a.marks.push_back({x.on_rim, Tone::quiet, MarkerShape::ring, 9});
}

/// The facet that was left above δ, and how far its farthest point is from the input.
void refused(const RefusedFacet& f, double delta, Annotation& a) {
  const bool above = f.distance > delta;
  const Tone tone = above ? Tone::bad : Tone::good;
  a.faces.push_back({f.corners, tone, 0.5f});
  for (std::size_t k = 0; k < 3; ++k)
    a.lines.push_back({f.corners[k], f.corners[(k + 1) % 3], tone, 2.6f, false});
  a.lines.push_back({f.farthest, f.closest, tone, 2.0f, true});
  a.marks.push_back({f.farthest, tone, above ? MarkerShape::cross : MarkerShape::disc, 12});
  a.marks.push_back({f.closest, Tone::quiet, MarkerShape::ring, 9});
}

void broken_places(const StateReport& report, Annotation& a) {
  for (const InvariantVerdict& v : report.verdicts)
    if (v.state == InvariantVerdict::State::broken && v.place) {
      a.marks.push_back({*v.place, Tone::bad, MarkerShape::cross, 16});
      a.marks.push_back({*v.place, Tone::bad, MarkerShape::ring, 26});
    }
}

/// Where the finished mesh leaves the input behind.
void uncovered(const std::vector<UncoveredPlace>& places, Annotation& a) {
  for (const UncoveredPlace& p : places) {
    a.marks.push_back({p.point, Tone::bad, MarkerShape::cross, 12});
    a.marks.push_back({p.point, Tone::bad, MarkerShape::ring, 20});
  }
}

} // namespace

std::optional<RefusedFacet> shown_refusal(const WindowState& m) {
  const auto state = m.state();
  const auto event = m.selected_event();
  if (!state || !event || !m.run.journal || !m.run.scene || !m.run.scene->field) return std::nullopt;
  std::optional<std::size_t> sweep;
  if (m.place.level == DebugLevel::gate && m.place.gate_event == event) sweep = m.place.gate;
  return refused_facet(*m.run.journal, m.run.journal->events()[*event], *state, *m.run.scene->field, sweep);
}

Annotation Investigation::make_annotation() const {
  const WindowState& m = window;
  Annotation a;
  const auto state = m.state();
  if (!state) return a;
  const Pick& picked = m.selection.picked;
  if (picked.kind == Pick::Kind::tet) tet(*this, *state, TetId(picked.id), a);
  if (picked.kind == Pick::Kind::sample) sample(*state, SampleId(picked.id), a);
  if (point_) point_and_ball(*point_, *point_scene_, a);
  if (beside_rim_) to_rim(*beside_rim_, *rim_place_, a);
  if (m.settings.panes.tab == BottomTab::loops)
    for (const Segment3& s : loop_shown) a.lines.push_back({s[0], s[1], Tone::quiet, 3.4f, false});
  if (const auto facet = shown_refusal(m)) refused(*facet, state->criteria.delta, a);
  if (const auto h = history(); h && m.settings.panes.tab == BottomTab::history) way(*h, a);
  if (const auto w = work()) heat(w->map, a);
  // While a run is played the answer is about an earlier step: its loops are of another Z.
  if (const auto t = topology(); t && topology_asked_->state == state) loops(*t, *state, a);
  if (const auto c = check(); c && c->report.step == state->step) broken_places(c->report, a);
  if (m.run.result && m.transport.step() >= m.live_step()) uncovered(m.run.result->certificate.uncovered, a);
  return a;
}

} // namespace isoscope
