// Commits of patches, with the octree and the stamps kept up to date.
#include "improve/live_surface.h"

#include "base/parallel.h"
#include "improve/facet_intersection.h"

#include <algorithm>

namespace isoscope {
namespace {

Box3 domain_of(const TriangleMesh& mesh, double delta) {
  Box3 box;
  for (const Vec3 p : mesh.points) box.add(p);
  return box.grown(4 * delta);
}

/// A fixed vertex of the patch that would be left with too few facets, or from which two edges would
/// lead to another fixed one. Free vertices have their whole star in the patch, whose moves see to them.
std::optional<std::uint32_t> broken_connectivity(const FacetComplex& surface, const SurfacePatch& patch) {
  const FacetComplex& own = patch.complex;
  const auto facets_at = [&](std::uint32_t v, const auto& second) {
    return std::count_if(patch.start_facets.begin(), patch.start_facets.end(), [&](const auto& f) {
      return std::find(f.begin(), f.end(), v) != f.end() && std::find(f.begin(), f.end(), second) != f.end();
    });
  };
  for (std::uint32_t f = 0; f < own.facets.size(); ++f) {
    const auto& corners = own.facets[f].v;
    if (!own.facets[f].alive() || corners == patch.start_facets[f]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
      if (patch.free[a] || patch.free[b] || facets_at(a, b) > 0) continue;
      if (surface.has_edge(patch.vertices[a], patch.vertices[b])) return a;
    }
  }
  for (std::uint32_t v = 0; v < own.points.size(); ++v) {
    if (patch.free[v]) continue;
    const auto lost = facets_at(v, v) - static_cast<std::ptrdiff_t>(own.stars[v].size());
    const auto fewest = static_cast<std::ptrdiff_t>(surface.fewest_facets(patch.vertices[v]));
    if (lost > 0 && static_cast<std::ptrdiff_t>(surface.stars[patch.vertices[v]].size()) - lost < fewest)
      return v;
  }
  return std::nullopt;
}

/// Gives a patch its part of T.
void embed(const Embedding& embedding, TetPatch tets, SurfacePatch& patch) {
  SurfacePatch::InT in_t{std::move(tets), {}, {}};
  in_t.vertices.reserve(patch.vertices.size());
  for (const std::uint32_t v : patch.vertices) in_t.vertices.push_back(embedding.vertex(v));
  for (const VertexId v : in_t.tets.vertices())
    if (const std::uint32_t w = embedding.surface_vertex(v); w != Embedding::not_on_surface)
      in_t.looked_at.push_back(w);
  patch.in_t = std::move(in_t);
}

} // namespace

LiveSurface::LiveSurface(const TriangleMesh& mesh, const SurfaceRules& rules, Embedding* embedding,
                         const RunControl& control)
    : embedding_(embedding), gate_(rules.input->gate()), octree_(domain_of(mesh, rules.input->delta())),
      box_(rules.box), stamps_(mesh.points.size(), 0), collapse_stamps_(mesh.points.size(), 0) {
  complex_.points = mesh.points;
  complex_.facets.resize(mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) complex_.facets[f].v = mesh.triangles[f];
  for (std::size_t f = 0; f < mesh.labels.size(); ++f) complex_.facets[f].labels = mesh.labels[f];
  complex_.build_stars();
  if (box_)
    freeze();
  else if (mesh.labels.empty())
    complex_.build_border();
  else
    complex_.strata = find_strata(complex_);
  if (!complex_.border.empty()) share_rim(*rules.input);
  for (const auto& star : complex_.stars) vertex_count_ += star.empty() ? 0u : 1u;
  parallel_until(complex_.facets.size(), 64, control, [&](std::size_t f) {
    measure_facet(*rules.input, complex_, static_cast<std::uint32_t>(f));
    Facet& facet = complex_.facets[f];
    facet.proven = true;
    if (rules.orientation)
      facet.misoriented = static_cast<std::uint8_t>(
          rules.orientation->failures(complex_.triangle(facet), facet.labels).size());
  });
  for (std::uint32_t f = 0; f < complex_.facets.size(); ++f) octree_.insert(f, box_of(complex_.triangle(f)));
}

void LiveSurface::freeze() {
  frozen_.assign(complex_.points.size(), 0);
  for (const Facet& f : complex_.facets) {
    if (may_change(f.v)) continue;
    for (const std::uint32_t v : f.v) frozen_[v] = 1;
  }
}

bool LiveSurface::may_change(std::span<const std::uint32_t> vertices) const {
  return !box_ || std::all_of(vertices.begin(), vertices.end(),
                              [&](std::uint32_t v) { return box_->holds(complex_.points[v]); });
}

void LiveSurface::share_rim(const InputSurface& input) {
  std::vector<std::uint32_t> begins;
  std::vector<Segment3> edges;
  for (std::uint32_t v = 0; v < complex_.border.size(); ++v) {
    if (!complex_.on_border(v)) continue;
    begins.push_back(v);
    edges.push_back({complex_.points[v], complex_.points[complex_.border[v].next]});
  }
  const SegmentIndex index(std::move(edges));
  for (const Vec3 r : gate_->rim_samples())
    complex_.border[begins[index.closest(r).segment]].rim.push_back(r);
  for (const std::uint32_t v : begins) {
    measure_border(input, complex_, v);
    complex_.border[v].proven = true;
  }
}

SurfacePatch LiveSurface::patch(std::span<const std::uint32_t> free_vertices) const {
  std::vector<std::uint32_t> free(free_vertices.begin(), free_vertices.end());
  std::erase_if(free, [&](std::uint32_t v) { return frozen(v); });
  SurfacePatch patch = take_patch(complex_, free);
  if (embedding_ != nullptr) embed(*embedding_, embedding_->around(free_vertices), patch);
  return patch;
}

std::optional<SurfacePatch> LiveSurface::flip_patch(const FlipPlan& plan) const {
  std::optional<TetPatch> tet;
  if (embedding_ != nullptr) {
    tet = embedding_->tet_between({plan.a, plan.b, plan.c, plan.d});
    if (!tet) return std::nullopt;
    tet->change_side(0);
  }
  SurfacePatch patch = take_facets(complex_, std::array{std::min(plan.f, plan.g), std::max(plan.f, plan.g)});
  if (tet) embed(*embedding_, std::move(*tet), patch);
  FlipPlan local = plan;
  for (std::uint32_t* v : {&local.a, &local.b, &local.c, &local.d}) *v = patch.local_vertex(*v);
  local.f = plan.f < plan.g ? 0 : 1;
  local.g = 1 - local.f;
  apply_flip(patch.complex, local);
  return patch;
}

void LiveSurface::room_changed(std::span<const std::uint32_t> vertices) {
  ++commits_;
  for (const std::uint32_t v : vertices) stamps_[v] = collapse_stamps_[v] = commits_;
}

Refusal LiveSurface::check(const SurfacePatch& patch) const {
  Refusal met;
  const FacetComplex& own = patch.complex;
  if (const auto where = broken_connectivity(complex_, patch))
    return {Reason::zero_link_condition, 0, 0, own.points[*where]};
  if (Refusal bare = check_rim(patch); !bare.accepted()) return bare;
  if (patch.in_t) return {}; // facets of T do not meet
  // Beyond the box there are facets that nobody here knows.
  for (std::uint32_t v = 0; v < own.points.size(); ++v)
    if (box_ && own.alive_vertex(v) && own.points[v] != patch.start_points[v] && !box_->holds(own.points[v]))
      return {Reason::intersection, 0, 0, own.points[v]};
  for (std::uint32_t f = 0; f < own.facets.size(); ++f) {
    if (!own.facets[f].alive() || !patch.changed(f)) continue;
    const IndexedTriangle facet{own.triangle(f), patch.surface_corners(own.facets[f].v)};
    const Box3 box = box_of(facet.points);
    const auto meets = [&](const IndexedTriangle& other) {
      if (!box.meets(box_of(other.points)) || !intersect_properly(facet, other)) return false;
      met = {Reason::intersection, 0, 0, other.points[0]};
      return true;
    };
    for (std::uint32_t g = 0; g < own.facets.size(); ++g) {
      if (g == f || !own.facets[g].alive() || (g < f && patch.changed(g))) continue;
      if (meets({own.triangle(g), patch.surface_corners(own.facets[g].v)})) return met;
    }
    const bool found = octree_.visit(box, [&](std::uint32_t slot) {
      if (patch.has_slot(slot)) return false;
      return meets({complex_.triangle(slot), complex_.facets[slot].v});
    });
    if (found) return met;
  }
  return {};
}

Refusal LiveSurface::check_rim(const SurfacePatch& patch) const {
  const FacetComplex& own = patch.complex;
  std::vector<Segment3> before, after;
  Box3 box;
  for (std::uint32_t v = 0; v < own.border.size(); ++v) {
    if (!patch.border_changed(v)) continue;
    if (const std::uint32_t next = patch.start_border[v]; next < BorderEdge::elsewhere) {
      before.push_back({patch.start_points[v], patch.start_points[next]});
      for (const Vec3 p : before.back()) box.add(p);
    }
    if (own.border[v].here()) after.push_back({own.points[v], own.points[own.border[v].next]});
  }
  if (before.empty()) return {};
  const auto in_patch = [&](std::uint32_t v) {
    const std::uint32_t local = patch.local_vertex(v);
    return local < patch.vertices.size() && patch.vertices[local] == v && patch.border_changed(local);
  };
  octree_.visit(box.grown(2 * gate_->delta()), [&](std::uint32_t slot) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = complex_.facets[slot].v[k], to = complex_.facets[slot].v[(k + 1) % 3];
      if (complex_.border[from].next == to && !in_patch(from))
        after.push_back({complex_.points[from], complex_.points[to]});
    }
    return false;
  });
  const BorderVerdict verdict = gate_->covers_rim(before, after);
  if (verdict.proven) return {};
  return {Reason::border_distance, verdict.distance, gate_->delta(), verdict.witness};
}

bool LiveSurface::up_to_date(const SurfacePatch& patch) const {
  for (std::size_t f = 0; f < patch.slots.size(); ++f)
    if (complex_.facets[patch.slots[f]].v != patch.surface_corners(patch.start_facets[f])) return false;
  for (std::size_t v = 0; v < patch.vertices.size(); ++v)
    if (complex_.points[patch.vertices[v]] != patch.start_points[v]) return false;
  return !patch.in_t || patch.in_t->tets.up_to_date(embedding_->complex());
}

SurfaceChange LiveSurface::commit(const SurfacePatch& patch, EventKind kind) {
  SurfaceChange change;
  change.kind = kind;
  ++commits_;
  const auto stamp = [&](std::uint32_t v) {
    stamps_[v] = commits_;
    if (kind != EventKind::relaxation) collapse_stamps_[v] = commits_;
  };
  const auto touch = [&](const std::array<std::uint32_t, 3>& v) {
    for (const std::uint32_t w : v) stamp(w);
  };
  std::vector<std::uint32_t> changed;
  for (std::uint32_t f = 0; f < patch.slots.size(); ++f) {
    if (!patch.changed(f)) continue;
    changed.push_back(f);
    octree_.erase(patch.slots[f], box_of(patch.start_triangle(f)));
    touch(complex_.facets[patch.slots[f]].v);
  }
  for (std::uint32_t v = 0; v < patch.vertices.size(); ++v) {
    if (patch.complex.points[v] == patch.start_points[v] || !patch.complex.alive_vertex(v)) continue;
    change.moves.push_back({patch.vertices[v], patch.start_points[v], patch.complex.points[v]});
    complex_.points[patch.vertices[v]] = patch.complex.points[v];
  }
  for (std::uint32_t v = 0; v < patch.complex.border.size(); ++v) {
    if (!patch.border_changed(v)) continue;
    BorderEdge edge = patch.complex.border[v];
    if (edge.here()) edge.next = patch.vertices[edge.next];
    complex_.border[patch.vertices[v]] = std::move(edge);
  }
  for (const std::uint32_t f : changed) {
    const std::uint32_t slot = patch.slots[f];
    Facet facet = patch.complex.facets[f];
    const std::array<std::uint32_t, 3> before = complex_.facets[slot].v;
    if (facet.alive()) facet.v = patch.surface_corners(facet.v);
    if (facet.v != before) {
      change.removed.push_back({slot, before});
      complex_.replace_facet(slot, facet.v);
      if (facet.alive()) change.added.push_back({slot, facet.v});
    }
    complex_.facets[slot] = std::move(facet);
    if (!complex_.facets[slot].alive()) continue;
    touch(complex_.facets[slot].v);
    octree_.insert(slot, box_of(complex_.triangle(slot)));
  }
  for (std::uint32_t v = 0; v < patch.vertices.size(); ++v)
    if (!patch.complex.alive_vertex(v)) change.killed_vertices.push_back(patch.vertices[v]);
  vertex_count_ -= change.killed_vertices.size();
  if (!complex_.strata.empty() && !change.killed_vertices.empty()) renew_strata(complex_, patch.vertices);
  if (patch.in_t) {
    change.tetrahedra = embedding_->commit(patch.in_t->tets);
    for (const TetRecord& t : change.tetrahedra.removed)
      for (const VertexId v : t.v)
        if (const std::uint32_t w = embedding_->surface_vertex(v); w != Embedding::not_on_surface) stamp(w);
  }
  return change;
}

TriangleMesh compacted(const FacetComplex& complex) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> ids(complex.points.size(), Facet::none);
  for (std::uint32_t v = 0; v < ids.size(); ++v) {
    if (!complex.alive_vertex(v)) continue;
    ids[v] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(complex.points[v]);
  }
  for (const Facet& f : complex.facets) {
    if (!f.alive()) continue;
    mesh.triangles.push_back({ids[f.v[0]], ids[f.v[1]], ids[f.v[2]]});
    if (!complex.strata.empty()) mesh.labels.push_back(f.labels);
  }
  return mesh;
}

SurfaceChange difference(const FacetComplex& before, const FacetComplex& after, EventKind kind) {
  SurfaceChange change;
  change.kind = kind;
  for (std::uint32_t v = 0; v < before.points.size(); ++v) {
    if (before.alive_vertex(v) && !after.alive_vertex(v)) change.killed_vertices.push_back(v);
    if (after.alive_vertex(v) && before.points[v] != after.points[v])
      change.moves.push_back({v, before.points[v], after.points[v]});
  }
  for (std::uint32_t f = 0; f < before.facets.size(); ++f) {
    if (before.facets[f].v == after.facets[f].v) continue;
    if (before.facets[f].alive()) change.removed.push_back({f, before.facets[f].v});
    if (after.facets[f].alive()) change.added.push_back({f, after.facets[f].v});
  }
  return change;
}

} // namespace isoscope
