// A ball around what the operation touched.
#include "scene/sample_scope.h"

#include <algorithm>

namespace isoscope {

SampleScope::SampleScope(const StateSnapshot& state, const ViewSettings& view) {
  if (!view.near_samples || !state.event || !state.samples) return;
  all_ = false;
  Box3 box;
  if (state.inserted.valid() && state.inserted.index() < state.complex.vertices.size()) {
    // The first conflict zones are as large as everything: what counts is where the point goes in.
    box.add(state.complex.position(state.inserted));
  } else {
    for (const StateSnapshot::Move& move : state.moves) box.add(move.after), box.add(move.before);
    if (box.empty())
      for (const Triangle3& facet : state.added_facets)
        for (const Vec3& p : facet) box.add(p);
  }
  if (box.empty()) return;
  Box3 scene;
  for (const ZeroSet::ZeroVertex& v : state.zero_set.vertices) scene.add(v.position);
  const double whole = scene.empty() ? box.longest_edge() : scene.longest_edge();
  if (box.longest_edge() > 0.5 * whole) return; // a sweep over all of Z has no place
  constexpr double sigmas = 6, part = 0.12;
  const double reach =
      std::max(std::min(sigmas * state.samples->sigma, part * whole), 2.5 * state.samples->sigma);
  const double radius = 0.5 * box.longest_edge() + reach;
  center_ = box.center();
  squared_radius_ = radius * radius;
}

} // namespace isoscope
