// Its corners are vertices of T.
#include "scene/first_box.h"

namespace isoscope {

Box3 first_box(const StateSnapshot& state) {
  Box3 box;
  if (!state.zero_set.polygons.empty()) return box;
  for (const Vertex& v : state.complex.vertices)
    if (v.alive && v.kind == VertexKind::box) box.add(v.position);
  return box;
}

} // namespace isoscope
