// The edges of ∂Γ.
#include "scene/layers.h"

#include <algorithm>
#include <utility>

namespace isoscope {

void GammaLayer::update(const StateSnapshot& state, bool box, const Clip& clip, const SceneColors& colors,
                        const SceneSpace& space) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  edges.reserve(3 * state.gamma.size());
  const auto in_box = [&](VertexId v) { return state.complex.vertices[v.index()].kind == VertexKind::box; };
  for (const GammaFacet& facet : state.gamma) {
    if (clip.active() && !clip.cuts() && !clip.shows_cell(state.complex.positions(facet.tet))) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(facet.v[i], facet.v[(i + 1) % 3]);
      if (box || (!in_box(a) && !in_box(b))) edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  LineBuilder builder;
  const Color8 tint = color8(colors.gamma);
  for (const auto& [a, b] : edges)
    builder.segment(space.local(state.complex.position(a)), space.local(state.complex.position(b)), tint,
                    1.4f);
  batch_.upload(builder);
}

void GammaLayer::draw(gl::Program& program, const ViewFrame& frame) {
  batch_.draw(program, frame.view.gamma.opacity);
}

} // namespace isoscope
