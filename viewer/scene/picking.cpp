// What lies under the mouse: rays against the elements that layers, filter and clip let see.
#include "scene/picking.h"

#include "mesh/sample_sets.h"
#include "scene/clip.h"
#include "scene/sample_scope.h"
#include "scene/tet_visibility.h"
#include "scene/zero_facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

namespace isoscope {
namespace {

struct Hit {
  double t = 0;
  Pick pick;
};

/// Everything a search needs about its ray.
struct Search {
  const PickScene& scene;
  const ViewSettings& view;
  Camera::Ray ray;
  Clip clip;
  double point_radius_rate, point_radius; ///< catch radius of points at parameter t: rate·t + radius

  Search(const PickScene& s, const Camera& camera, const ViewSettings& v, const PickAt& at)
      : scene(s), view(v), ray(camera.ray(at.x, at.y, at.width, at.height)), clip(v.clip) {
    const CameraPose& pose = camera.pose();
    const double per_depth = 2 * std::tan(pose.fov * std::numbers::pi / 360) / at.height;
    point_radius_rate = pose.orthographic ? 0 : at.radius * per_depth;
    point_radius = pose.orthographic ? at.radius * per_depth * pose.distance : 0;
  }
  Vec3 along(double t) const { return ray.origin + t * ray.direction; }
  /// Parameter at which the point is nearest to the ray when it is caught.
  std::optional<double> caught(Vec3 p) const {
    const double t = dot(p - ray.origin, ray.direction);
    if (t <= 0 || distance(p, along(t)) > point_radius_rate * t + point_radius) return std::nullopt;
    return t;
  }
};

std::optional<double> meet_triangle(const Camera::Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 e1 = b - a, e2 = c - a, h = cross(ray.direction, e2);
  const double det = dot(e1, h);
  if (det == 0) return std::nullopt;
  const Vec3 s = ray.origin - a;
  const double u = dot(s, h) / det;
  if (u < 0 || u > 1) return std::nullopt;
  const Vec3 q = cross(s, e1);
  const double v = dot(ray.direction, q) / det, t = dot(e2, q) / det;
  if (v < 0 || u + v > 1 || t <= 0) return std::nullopt;
  return t;
}

/// The stretch of the ray inside a positively oriented tetrahedron.
std::optional<std::array<double, 2>> meet_tetrahedron(const Camera::Ray& ray, const std::array<Vec3, 4>& p) {
  constexpr std::array<std::array<std::size_t, 3>, 4> outward{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  double lo = 0, hi = Box3::inf;
  for (const auto& f : outward) {
    const Vec3 n = cross(p[f[1]] - p[f[0]], p[f[2]] - p[f[0]]);
    const double rate = dot(n, ray.direction), rest = dot(n, p[f[0]] - ray.origin);
    if (rate > 0) hi = std::min(hi, rest / rate);
    if (rate < 0) lo = std::max(lo, rest / rate);
    if (rate == 0 && rest < 0) return std::nullopt;
  }
  if (lo >= hi) return std::nullopt;
  return std::array<double, 2>{lo, hi};
}

/// Whether a cell's point at p is visible: cut away point by point, or shown as a whole.
bool cell_visible(const Search& search, std::span<const Vec3> cell, Vec3 p) {
  return search.clip.cuts() ? search.clip.keeps(p) : search.clip.shows_cell(cell);
}

void hit_tetrahedra(const Search& search, std::vector<Hit>& hits) {
  if (!search.view.tetrahedra.shown()) return;
  const StateSnapshot& state = *search.scene.state;
  for_each_visible_tet(state, search.view.tets, search.clip, [&](TetId id, TetRole) {
    std::array<Vec3, 4> p = state.complex.positions(id);
    const Vec3 center = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    for (Vec3& q : p) q = center + static_cast<double>(search.view.tets.shrink) * (q - center);
    const auto inside = meet_tetrahedron(search.ray, p);
    if (!inside) return;
    double t = (*inside)[0];
    if (search.clip.cuts()) {
      const auto kept =
          search.clip.kept_intervals(search.ray.origin, search.ray.direction, (*inside)[0], (*inside)[1]);
      if (kept.empty()) return;
      t = kept.front()[0];
    }
    hits.push_back({t, {Pick::Kind::tet, id.value, search.along(t)}});
  });
}

void hit_zero_set(const Search& search, std::vector<Hit>& hits) {
  if (!search.view.zero_set.shown()) return;
  const StateSnapshot& state = *search.scene.state;
  const ZeroSet& zero = state.zero_set;
  for (const ZeroSet::Polygon& polygon : zero.polygons) {
    const auto corner = [&](std::size_t i) { return zero.vertices[polygon.v[i]].position; };
    auto t = meet_triangle(search.ray, corner(0), corner(1), corner(2));
    if (!t && polygon.count == 4) t = meet_triangle(search.ray, corner(0), corner(2), corner(3));
    if (!t || !cell_visible(search, clip_cell(state, polygon).span(), search.along(*t))) continue;
    if (polygon.facet.valid())
      hits.push_back({*t, {Pick::Kind::facet, polygon.facet.value, search.along(*t)}});
    else
      hits.push_back({*t, {Pick::Kind::tet, polygon.tet.value, search.along(*t)}});
  }
}

void hit_samples(const Search& search, std::vector<Hit>& hits) {
  const StateSnapshot& state = *search.scene.state;
  if (!search.view.samples.shown() || !state.samples) return;
  const auto& positions = state.samples->positions;
  const SampleScope scope(state, search.view);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto t = search.caught(positions[i]);
    if (!t) continue;
    const bool bad = i < state.errors.size() && is_bad(static_cast<double>(state.errors[i]));
    if (!(bad ? search.view.bad_samples : search.view.good_samples).shown()) continue;
    if (!bad && !scope.shows_good(positions[i])) continue;
    const TetId tet = i < state.sample_tets.size() ? state.sample_tets[i] : TetId();
    const bool known = tet.valid() && state.complex.tet(tet).alive();
    const bool visible = known ? search.clip.shows_point(positions[i], state.complex.positions(tet))
                               : search.clip.keeps(positions[i]);
    if (visible) hits.push_back({*t, {Pick::Kind::sample, static_cast<std::uint32_t>(i), positions[i]}});
  }
  const auto& over_rim = state.samples->over_rim;
  for (std::size_t i = 0; i < over_rim.size() && search.view.over_rim.shown(); ++i)
    if (const auto t = search.caught(over_rim[i]); t && search.clip.keeps(over_rim[i]))
      hits.push_back({*t, {Pick::Kind::over_rim, static_cast<std::uint32_t>(i), over_rim[i]}});
}

void hit_points(const Search& search, std::vector<Hit>& hits) {
  const InputPoints* points = search.scene.points;
  if (!search.view.points.shown() || points == nullptr) return;
  for (std::size_t i = 0; i < points->size(); ++i) {
    const Vec3 p = points->position(i);
    const auto t = search.caught(p);
    if (t && search.clip.keeps(p))
      hits.push_back({*t, {Pick::Kind::point, static_cast<std::uint32_t>(i), p}});
  }
}

void hit_vertices(const Search& search, std::vector<Hit>& hits) {
  const ViewSettings& view = search.view;
  const bool zero = view.zero_set.shown() && search.scene.state->complex.form != ZeroForm::interpolated;
  if (!view.tetrahedra.shown() && !view.samples.shown() && !view.gamma.shown() && !zero) return;
  const bool only_zero = search.scene.state->complex.form == ZeroForm::free;
  const auto& vertices = search.scene.state->complex.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    if (!v.alive || (v.kind == VertexKind::box && !view.tets.box) || !search.clip.keeps(v.position)) continue;
    if (only_zero && v.kind != VertexKind::zero) continue;
    if (const auto t = search.caught(v.position))
      hits.push_back({*t, {Pick::Kind::vertex, static_cast<std::uint32_t>(i), v.position}});
  }
}

/// Where the ray passes nearest to a segment when it catches it.
std::optional<double> meet_segment(const Search& search, Vec3 a, Vec3 b) {
  const Vec3 along = b - a, d = search.ray.direction, r = a - search.ray.origin;
  const double aa = dot(along, along), ad = dot(along, d), dd = dot(d, d);
  const double det = aa * dd - ad * ad;
  double s = det > 0 ? (ad * dot(d, r) - dd * dot(along, r)) / det : 0;
  s = std::clamp(s, 0.0, 1.0);
  return search.caught(a + s * along);
}

/// Edges of Z once it is embedded or free, of visible tetrahedra, and of ∂Γ where it is shown.
void hit_edges(const Search& search, std::vector<Hit>& hits) {
  const StateSnapshot& state = *search.scene.state;
  std::vector<std::pair<VertexId, VertexId>> edges;
  if (search.view.zero_set.shown() && state.complex.form != ZeroForm::interpolated)
    for (const ZeroSet::Polygon& p : state.zero_set.polygons) {
      if (!shows_polygon(state, p, search.clip)) continue;
      for (std::size_t i = 0; i < p.count; ++i)
        edges.push_back(std::minmax(state.zero_set.vertices[p.v[i]].negative,
                                    state.zero_set.vertices[p.v[(i + 1) % p.count]].negative));
    }
  const auto in_box = [&](VertexId v) { return state.complex.vertices[v.index()].kind == VertexKind::box; };
  const auto add = [&](VertexId a, VertexId b) {
    if (search.view.tets.box || (!in_box(a) && !in_box(b))) edges.push_back(std::minmax(a, b));
  };
  if (search.view.tetrahedra.shown())
    for_each_visible_tet(state, search.view.tets, search.clip, [&](TetId id, TetRole) {
      const auto& v = state.complex.tet(id).v;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) add(v[i], v[j]);
    });
  if (search.view.gamma.shown())
    for (const GammaFacet& f : state.gamma)
      for (std::size_t i = 0; i < 3; ++i) add(f.v[i], f.v[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    const auto t = meet_segment(search, state.complex.position(a), state.complex.position(b));
    if (!t || !search.clip.keeps(search.along(*t))) continue;
    hits.push_back({*t, {Pick::Kind::edge, a.value, search.along(*t), b.value}});
  }
}

void hit_input(const Search& search, std::vector<Hit>& hits) {
  if (!search.view.input.shown() || !search.scene.input) return;
  for (std::size_t i = 0; i < search.scene.input->triangles.size(); ++i) {
    const Triangle3 p = search.scene.input->triangle(i);
    const auto t = meet_triangle(search.ray, p[0], p[1], p[2]);
    if (t && cell_visible(search, p, search.along(*t)))
      hits.push_back({*t, {{}, Pick().id, search.along(*t)}});
  }
}

/// Where the ray enters Ω.
std::optional<double> meet_tolerance(const Search& search) {
  const DistanceGrid* grid = search.scene.grid;
  if (!grid || grid->empty() || !(search.view.outer.shown() || search.view.inner.shown()))
    return std::nullopt;
  double lo = 0, hi = Box3::inf;
  for (int i = 0; i < 3; ++i) {
    const double a = (grid->box.lo[i] - search.ray.origin[i]) / search.ray.direction[i];
    const double b = (grid->box.hi[i] - search.ray.origin[i]) / search.ray.direction[i];
    lo = std::max(lo, std::min(a, b));
    hi = std::min(hi, std::max(a, b));
  }
  const auto level = static_cast<double>(search.view.level);
  const double least_step = 0.5 * grid->voxel;
  // φ is 1-Lipschitz, and at least what is read where there are no samples.
  for (const auto& [from, to] : search.clip.kept_intervals(search.ray.origin, search.ray.direction, lo, hi))
    for (double t = from; t < to;) {
      const double value = grid->value(search.along(t));
      if (value <= level) return t;
      t += std::max(least_step, 0.9 * grid->delta * (value - level));
    }
  return std::nullopt;
}

double first(const std::vector<Hit>& hits) {
  double t = Box3::inf;
  for (const Hit& hit : hits) t = std::min(t, hit.t);
  return t;
}

} // namespace

Pick pick_scene(const PickScene& scene, const Camera& camera, const ViewSettings& view, const PickAt& at,
                PickKinds kinds, int depth_index) {
  if (!scene.state) return {};
  const Search search(scene, camera, view, at);
  std::vector<Hit> zero, opaque, hits;
  hit_zero_set(search, zero);
  hit_input(search, opaque);
  double wall = view.input.opacity >= 1 ? first(opaque) : Box3::inf;
  if (view.zero_set.opacity >= 1) wall = std::min(wall, first(zero));
  if (has(kinds, PickKinds::vertices)) hit_vertices(search, hits);
  if (has(kinds, PickKinds::samples)) hit_samples(search, hits);
  if (has(kinds, PickKinds::points)) hit_points(search, hits);
  if (has(kinds, PickKinds::edges)) {
    // Alone an edge may be far from the mouse; beside cells it must leave them room.
    PickAt near = at;
    near.radius *= kinds == PickKinds::edges ? 2.0 : 0.7;
    hit_edges(Search(scene, camera, view, near), hits);
  }
  // A point that lies within its catch radius of a wall is drawn before it.
  const double slack = search.point_radius + (std::isfinite(wall) ? search.point_radius_rate * wall : 0);
  if (has(kinds, PickKinds::tetrahedra)) {
    hits.insert(hits.end(), zero.begin(), zero.end());
    hit_tetrahedra(search, hits);
  }
  if (depth_index == 0) std::erase_if(hits, [&](const Hit& hit) { return hit.t > wall + slack; });
  // Points are small: where one is caught it wins over the cell right around it.
  const auto rank = [&](const Hit& hit) {
    // Twice for vertices: the edges at a vertex pass through it.
    const Pick::Kind kind = hit.pick.kind;
    const double lead = kind == Pick::Kind::tet || kind == Pick::Kind::facet ? 0
                        : kind == Pick::Kind::edge                           ? 1
                                                                             : 2;
    return hit.t - lead * (search.point_radius + search.point_radius_rate * hit.t);
  };
  std::sort(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return std::tie(a.pick.kind, a.pick.id, a.pick.other) < std::tie(b.pick.kind, b.pick.id, b.pick.other);
  });
  // A tetrahedron and its zero polygon are one thing to pick.
  std::vector<Pick> picks;
  for (const Hit& hit : hits)
    if (std::find(picks.begin(), picks.end(), hit.pick) == picks.end()) picks.push_back(hit.pick);
  if (depth_index < 0 || static_cast<std::size_t>(depth_index) >= picks.size()) return {};
  return picks[static_cast<std::size_t>(depth_index)];
}

Vec3 surface_point(const PickScene& scene, const Camera& camera, const ViewSettings& view, const PickAt& at) {
  const Search search(scene, camera, view, at);
  std::vector<Hit> hits;
  if (scene.state) {
    hit_zero_set(search, hits);
    hit_tetrahedra(search, hits);
    hit_samples(search, hits);
  }
  hit_input(search, hits);
  hit_points(search, hits);
  double t = first(hits);
  if (const auto enters = meet_tolerance(search)) t = std::min(t, *enters);
  if (!std::isfinite(t)) {
    const Camera::Ray axis = camera.ray(at.width / 2.0, at.height / 2.0, at.width, at.height);
    t = dot(camera.pose().target - search.ray.origin, axis.direction) /
        dot(search.ray.direction, axis.direction);
  }
  return search.along(t);
}

} // namespace isoscope
