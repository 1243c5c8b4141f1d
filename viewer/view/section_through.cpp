// Planes spanned by a direction that they must hold and one that they should.
#include "view/section_through.h"

#include "criteria/orientation.h"
#include "scene/pick_geometry.h"

#include <cmath>

namespace isoscope {
namespace {

/// The normal of a plane that holds both directions; zero where they are nearly one.
Vec3 spanned(Vec3 a, Vec3 b) {
  constexpr double least_angle = 0.05;
  const Vec3 n = cross(normalized(a), normalized(b));
  return length(n) > least_angle ? normalized(n) : Vec3{};
}

/// Of the planes that hold a direction the one that faces the eye most.
Vec3 facing(Vec3 held, Vec3 eye) {
  const Vec3 d = normalized(held), left = eye - dot(eye, d) * d;
  if (length(left) > 1e-6) return normalized(left);
  const Vec3 other = std::abs(d.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalized(other - dot(other, d) * d);
}

/// Across Z, where it is known which way it runs.
Vec3 across(Vec3 surface, Vec3 eye) {
  return squared_length(surface) > 0 ? facing(surface, eye) : normalized(eye);
}

Vec3 edge_normal(const std::array<Vec3, 2>& ends, const EdgeXray* xray, Vec3 surface, Vec3 eye) {
  const Vec3 along = ends[1] - ends[0];
  if (!(length(along) > 0)) return across(surface, eye);
  if (xray != nullptr && xray->attempt.kernel)
    if (const Vec3 n = spanned(along, xray->attempt.kernel->center - ends[0]); n != Vec3{}) return n;
  if (const Vec3 n = spanned(along, surface); squared_length(surface) > 0 && n != Vec3{}) return n;
  return facing(along, eye);
}

Vec3 tet_normal(const StateSnapshot& state, TetId tet, Vec3 eye) {
  const auto p = state.complex.positions(tet);
  Vec3 longest;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (squared_length(p[j] - p[i]) > squared_length(longest)) longest = p[j] - p[i];
  const Vec3 gradient = interpolate(p, state.complex.values(tet)).gradient;
  if (squared_length(gradient) > 0)
    if (const Vec3 n = spanned(gradient, longest); n != Vec3{}) return n;
  return facing(longest, eye);
}

} // namespace

Vec3 clip_anchor(const ClipSettings& clip, const Box3& model) {
  for (int k = 0; k < 3; ++k)
    if (clip.point[k] < model.lo[k] || clip.point[k] > model.hi[k]) {
      const Vec3 middle = model.center();
      return middle - dot(middle - clip.point, clip.normal) * clip.normal;
    }
  return clip.point;
}

std::optional<SectionThrough> section_through(const StateSnapshot& state, const Pick& pick,
                                              const EdgeXray* xray, Vec3 eye) {
  SectionThrough out;
  out.shown = pick_bounds(state, pick);
  Vec3 surface = surface_normal(state, pick);
  if (pick.kind == Pick::Kind::edge) {
    auto ends = edge_positions(state, pick);
    if (!ends) return std::nullopt;
    if (xray != nullptr) {
      // The X-ray may be of the moment before: its star is what is drawn.
      ends = std::array{xray->star.vertices[0].position, xray->star.vertices[1].position};
      for (const auto& v : xray->star.vertices) out.shown.add(v.position);
    }
    out.normal = edge_normal(*ends, xray, surface, eye);
    out.point = 0.5 * ((*ends)[0] + (*ends)[1]);
  } else {
    if (out.shown.empty()) return std::nullopt;
    out.point = out.shown.center();
    if (pick.kind == Pick::Kind::tet) {
      const auto p = state.complex.positions(TetId(pick.id));
      out.point = 0.25 * (p[0] + p[1] + p[2] + p[3]);
      out.normal = tet_normal(state, TetId(pick.id), eye);
    } else if (pick.kind == Pick::Kind::facet) {
      const auto& v = state.complex.facets[pick.id].v;
      const Triangle3 facet{state.complex.position(v[0]), state.complex.position(v[1]),
                            state.complex.position(v[2])};
      surface = area_vector(facet);
      out.point = centroid(facet);
      out.normal = across(surface, eye);
    } else {
      out.normal = across(surface, eye);
    }
  }
  if (dot(out.normal, eye) < 0) out.normal = -out.normal;
  return out;
}

} // namespace isoscope
