// The points that a field is made of, as they are drawn and picked: where they are, and what each counts for.
#pragma once

#include "input/triangle_soup.h"
#include "run/pipeline.h"
#include "scene/palette.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace isoscope {

struct InputPoints {
  std::shared_ptr<const TriangleSoup> soup; ///< those of the input, or drawn from its triangles
  std::vector<float> weights; ///< √w/δ in [0, 1), by point; negative where no site stands for the point
  double spacing = 0;         ///< typical distance between neighbours

  std::size_t size() const { return weights.size(); }
  Vec3 position(std::size_t i) const { return soup->points[i]; }
  bool dropped(std::size_t i) const { return weights[i] < 0; }
};

/// Null where the scene's field is not one of points.
std::shared_ptr<const InputPoints> input_points(const Scene& scene);
/// Of points that nothing is known of yet: all count the same. Null where the input is no point set.
std::shared_ptr<const InputPoints> input_points(std::shared_ptr<const TriangleSoup> input);

/// The colour of a weight: the less a point's ball is left, the lighter (in the dark theme) or the darker.
glm::vec3 weight_color(ThemeKind theme, float weight);

} // namespace isoscope
