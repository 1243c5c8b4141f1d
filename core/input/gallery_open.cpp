// A surface with a border: half a sphere.
#include "input/exact_circle.h"
#include "input/gallery_shapes.h"

#include <cstdint>

namespace isoscope {

namespace {

using Index = std::uint32_t;

} // namespace

TriangleSoup make_hemisphere(int rings) {
  TriangleSoup model;
  const int around = 4 * rings;
  model.points.push_back({0, 0, 1});
  for (int i = 1; i <= rings; ++i) {
    const CirclePoint down = circle_point(i, 4L * rings);
    for (int k = 0; k < around; ++k) {
      const CirclePoint at = circle_point(k, around);
      model.points.push_back({down.sine * at.cosine, down.sine * at.sine, down.cosine});
    }
  }
  const auto point = [&](int i, int k) {
    return i == 0 ? Index{0} : static_cast<Index>(1 + (i - 1) * around + k % around);
  };
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      model.triangles.push_back({point(i, k), point(i + 1, k), point(i + 1, k + 1)});
      if (i > 0) model.triangles.push_back({point(i, k), point(i + 1, k + 1), point(i, k + 1)});
    }
  return model;
}

} // namespace isoscope
