// Planes, ghosts and ellipses of the X-ray.
#include "scene/attempt_builder.h"

#include "criteria/collapse_cost.h"
#include "scene/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace isoscope {

void AttemptBuilder::line(Vec3 a, Vec3 b, glm::vec3 color, float alpha, float width, bool dashed) {
  lines.segment(space.local(a), space.local(b), color8(color, alpha), width, dashed);
}

void AttemptBuilder::outline(const Triangle3& t, glm::vec3 color, float alpha, float width) {
  for (std::size_t i = 0; i < 3; ++i) line(t[i], t[(i + 1) % 3], color, alpha, width);
}

void AttemptBuilder::face(const Triangle3& t, glm::vec3 color, float alpha) {
  faces.triangle(space.local(t[0]), space.local(t[1]), space.local(t[2]), color8(color, alpha), 0);
}

void AttemptBuilder::mark(Vec3 p, glm::vec3 color, MarkerShape shape, std::uint8_t diameter, float alpha) {
  marks.push_back({space.local(p), color8(color, alpha), shape, diameter});
}

void add_empty_kernel(AttemptBuilder& b, const EdgeXray& xray, double push) {
  const Kernel& k = *xray.attempt.kernel;
  const glm::vec3 color = rgb(kernel_color);
  Box3 box;
  for (const auto& v : xray.star.vertices) box.add(v.position);
  const double radius = 0.2 * box.longest_edge();
  for (const std::uint32_t w : k.witness) {
    if (w >= k.facets.size()) continue;
    b.outline(k.facets[w], color, 0.95f, 2.4f);
    b.face(k.facets[w], color, 0.5f);
    const HalfSpace& h = k.half_spaces[w];
    if (h.normal == Vec3{}) continue;
    // The plane where it is, and where it is pushed to; its side is told by a spike towards the half-space.
    const Vec3 foot = k.center - h.slack(k.center) * h.normal - push * k.missing_slack * h.normal;
    const PlaneAxes axes = plane_axes(h.normal);
    constexpr std::size_t corners = 32;
    std::array<Vec3, corners> rim;
    for (std::size_t i = 0; i < corners; ++i) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(i) / corners;
      rim[i] = foot + radius * (std::cos(turn) * axes.u + std::sin(turn) * axes.v);
    }
    for (std::size_t i = 0; i < corners; ++i) {
      const Vec3 next = rim[(i + 1) % corners];
      b.line(rim[i], next, color, 0.9f, 1.5f, i % 2 == 1);
      b.face({foot, rim[i], next}, color, 0.14f);
    }
    const Vec3 tip = foot + 0.25 * radius * h.normal;
    b.line(foot, tip, color, 0.9f, 1.5f);
    b.mark(tip, color, MarkerShape::triangle, 7);
    b.line(k.center, foot, color, 0.8f, 1.0f, true);
  }
  b.mark(k.center, color, push >= 1 ? MarkerShape::disc : MarkerShape::circle, 11);
}

void add_ghost(AttemptBuilder& b, const TargetStudy& study, const SceneColors& colors) {
  const bool possible = study.attempt.possible();
  for (const TargetStudy::Facet& facet : study.after) {
    const glm::vec3 color = facet.inside ? colors.accent : colors.bad;
    b.outline(facet.corners, color, 0.9f, facet.inside ? 1.4f : 2.2f);
    b.face(facet.corners, color, facet.inside ? 0.16f : 0.4f);
  }
  if (study.tet)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        b.line((*study.tet)[i], (*study.tet)[j], colors.bad, 0.9f, 1.6f);
  if (study.failed && study.witness != Vec3{}) {
    b.line(study.target, study.witness, colors.bad, 0.9f, 1.4f, true);
    if (study.measured_to != study.witness) {
      b.line(study.witness, study.measured_to, colors.bad, 1, 2.4f);
      b.mark(study.measured_to, colors.bad, MarkerShape::circle, 9);
    }
    b.mark(study.witness, colors.bad, MarkerShape::cross, 13);
  }
  b.mark(study.target, possible ? colors.good : colors.bad,
         possible ? MarkerShape::disc : MarkerShape::diamond, 12);
  b.mark(study.target, colors.accent, MarkerShape::ring, 24);
}

void add_cost_ellipsoid(AttemptBuilder& b, const EdgeXray& xray, Vec3 target, glm::vec3 color) {
  const CollapseCost cost(xray.star);
  const Vec3 optimum = xray.attempt.optimum;
  const double least = cost(optimum), level = cost(target) - least;
  // Where the planes are nearly parallel the surface hardly ends: what is drawn stays near the edge.
  const double edge = length(xray.star.vertices[1].position - xray.star.vertices[0].position);
  const double reach = 3 * std::max(edge, length(target - optimum)), unit = 1e-2 * reach;
  if (!(level > 0) || !(unit > 0)) return;
  const auto at = [&](Vec3 direction) {
    const double rise = cost(optimum + unit * direction) - least;
    const double t = rise > 0 ? unit * std::sqrt(level / rise) : reach;
    return optimum + std::min(t, reach) * direction;
  };
  const std::array<Vec3, 3> axis{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  constexpr int steps = 72;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto on = [&](int i) {
      const double turn = 2 * std::numbers::pi * i / steps;
      return at(std::cos(turn) * axis[k] + std::sin(turn) * axis[(k + 1) % 3]);
    };
    for (int i = 0; i < steps; ++i) b.line(on(i), on(i + 1), color, 0.55f, 1.0f, i % 3 == 2);
  }
}

} // namespace isoscope
