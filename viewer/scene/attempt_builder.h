// What the layer of the X-ray is put together from: segments, faces and marks in the scene's coordinates.
#pragma once

#include "questions/target_study.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/meanings.h"
#include "scene/mesh_batch.h"
#include "scene/view_frame.h"

namespace isoscope {

struct AttemptBuilder {
  const SceneSpace& space;
  LineBuilder lines;
  MeshBuilder faces;
  std::vector<Marker> marks;

  void line(Vec3 a, Vec3 b, glm::vec3 color, float alpha, float width, bool dashed = false);
  void outline(const Triangle3& t, glm::vec3 color, float alpha, float width);
  void face(const Triangle3& t, glm::vec3 color, float alpha);
  void mark(Vec3 p, glm::vec3 color, MarkerShape shape, std::uint8_t diameter, float alpha = 1);
};

/// The facets whose half-spaces have no common point, each with a piece of its plane pushed outwards by
/// `push` of what they miss by, and the point that misses least.
void add_empty_kernel(AttemptBuilder& b, const EdgeXray& xray, double push);
/// Z at the edge as the target would leave it, and what goes wrong there.
void add_ghost(AttemptBuilder& b, const TargetStudy& study, const SceneColors& colors);
/// Three great ellipses of the points that have the same error as `target`, within a few sizes of the star.
void add_cost_ellipsoid(AttemptBuilder& b, const EdgeXray& xray, Vec3 target, glm::vec3 color);

/// Of the kernel.
constexpr std::uint32_t kernel_color = meaning_color::kernel;

} // namespace isoscope
