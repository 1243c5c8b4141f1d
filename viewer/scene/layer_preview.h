// What would violate under other parameters, over the finished picture: rings around samples, outlines of
// tetrahedra.
#pragma once

#include "questions/snapshot.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

#include <vector>

namespace isoscope {

class PreviewLayer {
 public:
  /// Rebuilds the marks; cheap. Both may be null.
  void update(const StateSnapshot* state, const ViolationPreview* preview, const ViewFrame& frame);
  void draw(Programs& programs);

 private:
  LineBatch lines_;
  MarkerBatch marks_;
};

/// Calls sample(id) and tetrahedron(id, misoriented) for what a view marks; of very many some alone.
template <class Sample, class Tetrahedron>
void for_each_marked(const StateSnapshot& state, const ViolationPreview& preview, Sample&& sample,
                     Tetrahedron&& tetrahedron) {
  constexpr std::size_t most_samples = 3000, most_tets = 600;
  const auto some = [](const auto& all, std::size_t most, auto&& visit) {
    const std::size_t stride = 1 + all.size() / most;
    for (std::size_t i = 0; i < all.size(); i += stride) visit(all[i]);
  };
  if (state.samples)
    some(preview.samples, most_samples, [&](SampleId s) {
      if (s.index() < state.samples->size()) sample(s);
    });
  const auto alive = [&](TetId t) {
    return t.index() < state.complex.tets.size() && state.complex.tet(t).alive();
  };
  // Heights are not asked where facets are proven inside Ω.
  if (!state.criteria.certified)
    some(preview.flat_tets, most_tets, [&](TetId t) {
      if (alive(t)) tetrahedron(t, false);
    });
  some(preview.misoriented_tets, most_tets, [&](TetId t) {
    if (alive(t)) tetrahedron(t, true);
  });
}

} // namespace isoscope
