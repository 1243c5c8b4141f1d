// Dashed outlines and rings: light, as nothing has happened yet.
#include "scene/layer_preview.h"

#include "mesh/sample_sets.h"
#include "scene/clip.h"

#include <glad/gl.h>

namespace isoscope {

void PreviewLayer::update(const StateSnapshot* state, const ViolationPreview* preview,
                          const ViewFrame& frame) {
  LineBuilder lines;
  std::vector<Marker> marks;
  if (state && preview) {
    const Clip clip(frame.view.clip);
    const SceneColors& c = frame.colors;
    const auto keeps = [&](Vec3 p) { return !clip.active() || clip.keeps(p); };
    for_each_marked(
        *state, *preview,
        [&](SampleId s) {
          const Vec3 p = state->samples->positions[s.index()];
          if (keeps(p))
            marks.push_back({frame.space.local(p), color8(c.warning, 0.9f), MarkerShape::circle, 9});
        },
        [&](TetId t, bool misoriented) {
          const std::array<Vec3, 4> p = state->complex.positions(t);
          if (!keeps(0.25 * (p[0] + p[1] + p[2] + p[3]))) return;
          const Color8 tint = color8(misoriented ? c.misoriented : c.warning, 0.8f);
          for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
              lines.segment(frame.space.local(p[i]), frame.space.local(p[j]), tint, 1.2f, true);
        });
  }
  lines_.upload(lines);
  marks_.upload(marks);
}

void PreviewLayer::draw(Programs& programs) {
  const auto pass = [&](float strength) {
    lines_.draw(programs.line, strength, 2e-3f);
    marks_.draw(programs.marker, strength);
  };
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GREATER);
  pass(0.25f);
  glDepthFunc(GL_LEQUAL);
  pass(1.0f);
  glDepthMask(GL_TRUE);
}

} // namespace isoscope
