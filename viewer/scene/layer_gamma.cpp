// The edges of ∂Γ.
#include "scene/layer_gamma.h"

#include <algorithm>
#include <utility>

namespace isoscope {

void GammaLayer::update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
                        const SceneSpace& space) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  edges.reserve(3 * state.gamma.size());
  for (const GammaFacet& facet : state.gamma) {
    if (clip.active() && !clip.cuts() && !clip.shows_cell(state.complex.positions(facet.tet))) continue;
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(facet.v[i], facet.v[(i + 1) % 3]));
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
