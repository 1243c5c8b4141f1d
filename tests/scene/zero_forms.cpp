// Hand-made states.
#include "scene/zero_forms.h"

namespace isoscope::testing {
namespace {

VertexId add(StateSnapshot& state, Vec3 p, double value) {
  Vertex v;
  v.position = p;
  v.value = value;
  v.kind = value == 0 ? VertexKind::zero : VertexKind::sample;
  state.complex.vertices.push_back(v);
  return VertexId(state.complex.vertices.size() - 1);
}

} // namespace

StateSnapshot embedded_facet() {
  StateSnapshot state;
  const VertexId a = add(state, {-1, -1, 0}, 0), b = add(state, {1, -1, 0}, 0), c = add(state, {0, 1, 0}, 0),
                 up = add(state, {0, 0, 1}, 1), down = add(state, {0, 0, -1}, -1);
  state.complex.form = ZeroForm::embedded;
  Tet outer, inner;
  outer.v = {a, b, c, up};
  outer.side = 1;
  outer.neighbor[3] = TetId(1);
  inner.v = {b, a, c, down};
  inner.side = -1;
  inner.neighbor[3] = TetId(0);
  state.complex.tets = {outer, inner};
  state.tet_flags = {tet_alive | tet_heterogeneous, tet_alive | tet_heterogeneous | tet_negative};
  state.zero_set = extract_zero_set(state.complex);
  return state;
}

StateSnapshot free_tetrahedron() {
  StateSnapshot state;
  const std::array<VertexId, 4> v{add(state, {-1, -1, -1}, 0), add(state, {1, -1, -1}, 0),
                                  add(state, {0, 1, -1}, 0), add(state, {0, 0, 1}, 0)};
  state.complex.form = ZeroForm::free;
  for (const auto& f : outward_facets) {
    auto& facet = state.complex.facets.emplace_back();
    facet.v = {v[f[0]], v[f[1]], v[f[2]]};
  }
  state.zero_set = extract_zero_set(state.complex);
  return state;
}

} // namespace isoscope::testing
