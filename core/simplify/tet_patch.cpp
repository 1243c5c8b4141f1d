// Local copies of tetrahedra, and the deltas that bring them back.
#include "simplify/tet_patch.h"

#include "base/sort_unique.h"

#include <algorithm>

namespace isoscope {

TetPatch::TetPatch(const Complex& complex, std::span<const TetId> tets)
    : slots_(tets.begin(), tets.end()), tets_(tets.size()) {
  vertices_.reserve(4 * slots_.size());
  for (const TetId t : slots_)
    for (const VertexId v : complex.tet(t).v) vertices_.push_back(v);
  sort_unique(vertices_);
  points_.reserve(vertices_.size());
  for (const VertexId v : vertices_) points_.push_back(complex.position(v));
  at_.resize(vertices_.size());
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    const Tet& tet = complex.tet(slots_[i]);
    tets_[i].side = tet.side;
    for (std::size_t k = 0; k < 4; ++k) {
      tets_[i].v[k] = local(tet.v[k]);
      at_[tets_[i].v[k]].push_back(i);
    }
  }
  start_points_ = points_;
  start_tets_ = tets_;
}

std::uint32_t TetPatch::local(VertexId v) const {
  return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                    vertices_.begin());
}

Kernel TetPatch::kernel(VertexId vertex) const {
  const std::uint32_t v = local(vertex);
  Kernel kernel;
  kernel.center = points_[v];
  kernel.facets.reserve(at_[v].size());
  kernel.half_spaces.reserve(at_[v].size());
  for (const std::uint32_t t : at_[v]) {
    const auto& corners = tets_[t].v;
    const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    const auto& outward = outward_facets[k];
    kernel.add({points_[corners[outward[0]]], points_[corners[outward[2]]], points_[corners[outward[1]]]});
  }
  return kernel;
}

void TetPatch::move(VertexId v, Vec3 to) {
  points_[local(v)] = to;
}

void TetPatch::collapse(VertexId a, VertexId b, Vec3 to) {
  const std::uint32_t stays = local(a), goes = local(b);
  for (const std::uint32_t t : at_[goes]) {
    LocalTet& tet = tets_[t];
    if (std::find(tet.v.begin(), tet.v.end(), stays) != tet.v.end()) {
      tet.alive = false;
      continue;
    }
    *std::find(tet.v.begin(), tet.v.end(), goes) = stays;
    at_[stays].push_back(t);
  }
  at_[goes].clear();
  for (auto& list : at_) std::erase_if(list, [&](std::uint32_t t) { return !tets_[t].alive; });
  points_[stays] = to;
  killed_.push_back(b);
}

std::optional<std::uint32_t> TetPatch::tet_between(const std::array<VertexId, 4>& corners) const {
  std::array<std::uint32_t, 4> wanted{};
  for (std::size_t k = 0; k < 4; ++k) wanted[k] = local(corners[k]);
  for (const std::uint32_t t : at_[wanted[0]])
    if (std::is_permutation(wanted.begin(), wanted.end(), tets_[t].v.begin())) return t;
  return std::nullopt;
}

bool TetPatch::up_to_date(const Complex& complex) const {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const Tet& tet = complex.tet(slots_[i]);
    if (tet.side != start_tets_[i].side) return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (tet.v[k] != vertices_[start_tets_[i].v[k]]) return false;
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    if (complex.position(vertices_[v]) != start_points_[v]) return false;
  return true;
}

bool TetPatch::moved(const LocalTet& tet) const {
  return std::any_of(tet.v.begin(), tet.v.end(),
                     [&](std::uint32_t v) { return points_[v] != start_points_[v]; });
}

TetRecord TetPatch::record(std::size_t i, const LocalTet& tet) const {
  const auto& v = tet.v;
  return {slots_[i], canonical_order({vertices_[v[0]], vertices_[v[1]], vertices_[v[2]], vertices_[v[3]]}),
          tet.side};
}

Delta TetPatch::delta(std::size_t slots) const {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(slots);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (tets_[i] == start_tets_[i] && !moved(tets_[i])) continue;
    delta.removed.push_back(record(i, start_tets_[i]));
    if (tets_[i].alive) delta.added.push_back(record(i, tets_[i]));
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    if (points_[v] != start_points_[v]) delta.moves.push_back({vertices_[v], start_points_[v], points_[v]});
  delta.killed_vertices = killed_;
  return delta;
}

Delta difference(const Complex& before, const Complex& after) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(before.tets.size());
  for (std::size_t v = 0; v < before.vertices.size(); ++v) {
    const VertexId id(v);
    if (before.position(id) != after.position(id))
      delta.moves.push_back({id, before.position(id), after.position(id)});
  }
  const auto moved = [&](VertexId v) { return before.position(v) != after.position(v); };
  for (std::size_t t = 0; t < before.tets.size(); ++t) {
    const Tet &was = before.tets[t], &is = after.tets[t];
    if (!was.alive() ||
        (was.v == is.v && was.side == is.side && std::none_of(is.v.begin(), is.v.end(), moved)))
      continue;
    delta.removed.push_back({TetId(t), was.v, was.side});
    delta.added.push_back({TetId(t), is.v, is.side});
  }
  return delta;
}

} // namespace isoscope
