// The edges of another run's Z over the scene of this one.
#include "base/sort_unique.h"
#include "scene/layers.h"
#include "scene/zero_facets.h"

#include <algorithm>
#include <utility>

namespace isoscope {

void OtherZeroLayer::update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
                            const SceneSpace& space) {
  const ZeroSet& zero = state.zero_set;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ZeroSet::Polygon& polygon : zero.polygons) {
    if (!shows_polygon(state, polygon, clip)) continue;
    for (std::size_t i = 0; i < polygon.count; ++i)
      edges.push_back(std::minmax(polygon.v[i], polygon.v[(i + 1) % polygon.count]));
  }
  sort_unique(edges);
  LineBuilder builder;
  const Color8 tint = color8(colors.other_zero);
  for (const auto& [a, b] : edges)
    builder.segment(space.local(zero.vertices[a].position), space.local(zero.vertices[b].position), tint,
                    1.8f);
  batch_.upload(builder);
}

void OtherZeroLayer::draw(gl::Program& program, const ViewFrame& frame) {
  batch_.draw(program, frame.view.other_zero.opacity, 1e-3f);
}

} // namespace isoscope
