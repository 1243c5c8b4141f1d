// Local copies of tetrahedra, and the deltas that bring them back.
#include "collapse/tet_patch.h"

#include "base/sort_unique.h"

#include <algorithm>

namespace isoscope {

namespace {

/// The vertices of the facet opposite corner k, ascending.
std::array<std::uint32_t, 3> facet_of(const std::array<std::uint32_t, 4>& v, std::size_t k) {
  std::array<std::uint32_t, 3> facet{v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4]};
  std::sort(facet.begin(), facet.end());
  return facet;
}

} // namespace

bool TetPatch::LocalTet::has(std::uint32_t vertex) const {
  return std::find(v.begin(), v.end(), vertex) != v.end();
}

TetPatch::TetPatch(const Complex& complex, std::span<const TetId> tets) : slots_(tets.begin(), tets.end()) {
  vertices_.reserve(4 * slots_.size());
  for (const TetId t : slots_)
    for (const VertexId v : complex.tet(t).v) vertices_.push_back(v);
  sort_unique(vertices_);
  start_.reserve(vertices_.size());
  points_.reserve(vertices_.size());
  for (const VertexId v : vertices_) {
    start_.push_back(complex.vertices[v.index()]);
    points_.push_back(complex.position(v));
  }
  at_.resize(vertices_.size());
  tets_.reserve(slots_.size());
  for (const TetId t : slots_) {
    const Tet& tet = complex.tet(t);
    add({{local(tet.v[0]), local(tet.v[1]), local(tet.v[2]), local(tet.v[3])}, tet.side});
    start_dropped_.push_back(tet.dropped);
    for (std::size_t k = 0; k < 4; ++k)
      if ((tet.dropped >> k & 1u) != 0) dropped_.push_back(facet_of(tets_.back().v, k));
  }
  sort_unique(dropped_);
  start_tets_ = tets_;
}

std::uint8_t TetPatch::dropped_of(const LocalTet& tet) const {
  unsigned bits = 0;
  for (std::size_t k = 0; !dropped_.empty() && k < 4; ++k)
    if (std::binary_search(dropped_.begin(), dropped_.end(), facet_of(tet.v, k))) bits |= 1u << k;
  return static_cast<std::uint8_t>(bits);
}

void TetPatch::add(const LocalTet& tet) {
  for (const std::uint32_t v : tet.v) at_[v].push_back(static_cast<std::uint32_t>(tets_.size()));
  tets_.push_back(tet);
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

EdgeStar TetPatch::star(VertexId a, VertexId b) const {
  const std::uint32_t stays = local(a), goes = local(b);
  std::vector<std::uint32_t> tets(at_[stays]);
  tets.insert(tets.end(), at_[goes].begin(), at_[goes].end());
  sort_unique(tets);
  std::vector<std::uint32_t> order;
  for (const std::uint32_t t : tets) order.insert(order.end(), tets_[t].v.begin(), tets_[t].v.end());
  sort_unique(order);
  std::erase_if(order, [&](std::uint32_t v) { return v == stays || v == goes; });
  order.insert(order.begin(), {stays, goes});
  EdgeStar star;
  star.form = ZeroForm::embedded;
  for (const std::uint32_t v : order)
    star.vertices.push_back({vertices_[v], points_[v], start_[v].value, start_[v].kind, start_[v].room});
  const auto number = [&](std::uint32_t v) {
    if (v == stays || v == goes) return static_cast<std::uint16_t>(v == goes);
    return static_cast<std::uint16_t>(std::lower_bound(order.begin() + 2, order.end(), v) - order.begin());
  };
  for (const std::uint32_t t : tets) {
    const LocalTet& tet = tets_[t];
    const auto& v = tet.v;
    star.tets.push_back({TetId(),
                         {number(v[0]), number(v[1]), number(v[2]), number(v[3])},
                         tet.side,
                         tet.has(stays),
                         tet.has(goes),
                         dropped_of(tet)});
  }
  return star;
}

void TetPatch::collapse(VertexId a, VertexId b, Vec3 to) {
  const std::uint32_t stays = local(a), goes = local(b);
  std::vector<std::uint32_t> ring;
  for (const std::uint32_t t : at_[goes]) {
    LocalTet& tet = tets_[t];
    if (tet.has(stays)) {
      ring.push_back(t);
      continue;
    }
    *std::find(tet.v.begin(), tet.v.end(), goes) = stays;
    at_[stays].push_back(t);
  }
  std::erase_if(at_[goes], [&](std::uint32_t t) { return tets_[t].has(stays) && !tets_[t].has(goes); });
  replace(ring, {});
  std::sort(at_[stays].begin(), at_[stays].end());
  points_[stays] = to;
  killed_.push_back(b);
  std::erase_if(dropped_, [&](const auto& f) {
    return std::find(f.begin(), f.end(), stays) != f.end() && std::find(f.begin(), f.end(), goes) != f.end();
  });
  for (auto& f : dropped_) {
    std::replace(f.begin(), f.end(), goes, stays);
    std::sort(f.begin(), f.end());
  }
  sort_unique(dropped_);
}

void TetPatch::replace(std::span<const std::uint32_t> removed, std::span<const LocalTet> added) {
  for (const std::uint32_t t : removed) {
    for (const std::uint32_t v : tets_[t].v) std::erase(at_[v], t);
    tets_[t].alive = false;
  }
  for (const LocalTet& t : added) add(t);
}

std::optional<std::uint32_t> TetPatch::tet_between(const std::array<VertexId, 4>& corners) const {
  std::array<std::uint32_t, 4> wanted{};
  for (std::size_t k = 0; k < 4; ++k) wanted[k] = local(corners[k]);
  for (const std::uint32_t t : at_[wanted[0]])
    if (std::is_permutation(wanted.begin(), wanted.end(), tets_[t].v.begin()) && dropped_of(tets_[t]) == 0)
      return t;
  return std::nullopt;
}

bool TetPatch::up_to_date(const Complex& complex) const {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const Tet& tet = complex.tet(slots_[i]);
    if (tet.side != start_tets_[i].side || tet.dropped != start_dropped_[i]) return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (tet.v[k] != vertices_[start_tets_[i].v[k]]) return false;
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    if (complex.position(vertices_[v]) != start_[v].position) return false;
  return true;
}

bool TetPatch::moved(const LocalTet& tet) const {
  return std::any_of(tet.v.begin(), tet.v.end(),
                     [&](std::uint32_t v) { return points_[v] != start_[v].position; });
}

TetRecord TetPatch::record(TetId slot, const LocalTet& tet, std::uint8_t dropped) const {
  const std::array<VertexId, 4> v{vertices_[tet.v[0]], vertices_[tet.v[1]], vertices_[tet.v[2]],
                                  vertices_[tet.v[3]]};
  const std::array<VertexId, 4> order = canonical_order(v);
  return {slot, order, tet.side, reordered_bits(dropped, v, order)};
}

/// By tetrahedron of the complex: whether the delta has it.
std::vector<std::uint8_t> TetPatch::changed() const {
  std::vector<std::uint8_t> flags(slots_.size(), 0);
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    if (!(tets_[i] == start_tets_[i]) || moved(tets_[i]) || dropped_of(tets_[i]) != start_dropped_[i])
      flags[i] = 1;
    if (!tets_[i].alive || tets_[i].side == start_tets_[i].side) continue;
    // Each of its facets has one of any two of its corners.
    for (std::size_t k = 0; k < 2; ++k)
      for (const std::uint32_t t : at_[tets_[i].v[k]]) {
        const auto shared = std::count_if(tets_[i].v.begin(), tets_[i].v.end(),
                                          [&](std::uint32_t v) { return tets_[t].has(v); });
        if (shared == 3 && t < slots_.size()) flags[t] = 1;
      }
  }
  return flags;
}

Delta TetPatch::delta(std::size_t slots) const {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(slots);
  std::vector<TetId> vacant; // descending
  const std::vector<std::uint8_t> has = changed();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (!has[i]) continue;
    delta.removed.push_back(record(slots_[i], start_tets_[i], start_dropped_[i]));
    if (tets_[i].alive) {
      delta.added.push_back(record(slots_[i], tets_[i], dropped_of(tets_[i])));
    } else {
      vacant.insert(vacant.begin(), slots_[i]);
    }
  }
  for (std::size_t i = slots_.size(); i < tets_.size(); ++i) {
    if (!tets_[i].alive) continue;
    const TetId slot = vacant.empty() ? TetId(slots++) : vacant.back();
    if (!vacant.empty()) vacant.pop_back();
    delta.added.push_back(record(slot, tets_[i], dropped_of(tets_[i])));
  }
  std::sort(delta.added.begin(), delta.added.end(),
            [](const TetRecord& x, const TetRecord& y) { return x.id < y.id; });
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    if (points_[v] != start_[v].position)
      delta.moves.push_back({vertices_[v], start_[v].position, points_[v]});
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
  const auto other_side = [&](TetId t) { return t.valid() && before.tet(t).side != after.tet(t).side; };
  for (std::size_t t = 0; t < before.tets.size(); ++t) {
    const Tet &was = before.tets[t], &is = after.tets[t];
    if (!was.alive()) continue;
    if (was.side == is.side && std::none_of(is.v.begin(), is.v.end(), moved) &&
        std::none_of(is.neighbor.begin(), is.neighbor.end(), other_side))
      continue;
    delta.removed.push_back({TetId(t), was.v, was.side, was.dropped});
    delta.added.push_back({TetId(t), is.v, is.side, is.dropped});
  }
  return delta;
}

} // namespace isoscope
