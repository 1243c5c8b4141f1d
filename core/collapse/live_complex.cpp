// Collapses as deltas, and the counters that follow them.
#include "collapse/live_complex.h"

#include "base/sort_unique.h"
#include "mesh/strata.h"

#include <algorithm>
#include <array>
#include <limits>

namespace isoscope {

LiveComplex::LiveComplex(Complex complex, std::shared_ptr<const BoundarySamples> samples)
    : complex_(std::move(complex)), incidence_(complex_), samples_(std::move(samples)),
      changed_(complex_.vertices.size(), 1), alive_tets_(complex_.alive_tets()),
      zero_set_vertices_(extract_zero_set(complex_).vertices.size()) {
  if (!samples_) return;
  sets_ = std::make_unique<SampleSets>(samples_->positions);
  sets_->assign_all(complex_);
}

EdgeStar LiveComplex::star(VertexId a, VertexId b, CostRing ring) const {
  return gather_edge_star(complex_, incidence_, a, b, ring);
}

void LiveComplex::add_samples(EdgeStar& star) const {
  if (!sets_) return;
  std::vector<TetId> tets;
  tets.reserve(star.tets.size());
  for (const EdgeStar::StarTet& t : star.tets) tets.push_back(t.id);
  // In the order of their ids: the first one that goes wrong is named.
  const std::vector<SampleId> samples = sets_->gather(tets);
  star.samples.reserve(samples.size());
  for (const SampleId s : samples)
    star.samples.push_back({s, samples_->positions[s.index()], samples_->labels[s.index()]});
}

std::vector<VertexId> LiveComplex::neighbors(VertexId v) const {
  std::vector<VertexId> found;
  for (const TetId t : incidence_.tets_of(v)) {
    for (const VertexId n : complex_.tet(t).v) {
      if (n != v) found.push_back(n);
    }
  }
  sort_unique(found);
  return found;
}

Delta LiveComplex::collapse(VertexId a, VertexId b, Vec3 target) const {
  return collapse_delta(complex_, incidence_, a, b, target);
}

std::optional<Delta> LiveComplex::split(VertexId a, VertexId b, Vec3 point) const {
  return split_delta(complex_, incidence_, a, b, point);
}

StepFigures LiveComplex::step_figures() const {
  StepFigures figures;
  figures.zero_set_vertices = static_cast<std::uint32_t>(zero_set_vertices_);
  figures.tets = static_cast<std::uint32_t>(alive_tets_);
  figures.smallest_height = std::numeric_limits<float>::infinity();
  return figures;
}

std::size_t LiveComplex::label_changes(const std::vector<TetRecord>& tets) const {
  std::vector<std::array<VertexId, 2>> edges;
  std::vector<std::array<VertexId, 3>> facets;
  std::size_t junctions = 0;
  for (const TetRecord& t : tets) {
    const TetLabels l{complex_.label(t.v[0]), complex_.label(t.v[1]), complex_.label(t.v[2]),
                      complex_.label(t.v[3])};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (l[i] != l[j] && l[i] != 0 && l[j] != 0) {
          edges.push_back({std::min(t.v[i], t.v[j]), std::max(t.v[i], t.v[j])});
        }
      }
    }
    if (label_count(l) < 3) continue;
    ++junctions;
    for (std::size_t i = 0; i < 4; ++i) {
      TetLabels rest = l;
      rest[i] = 0;
      if (label_count(rest) < 3) continue;
      std::array<VertexId, 3> facet{t.v[(i + 1) & 3], t.v[(i + 2) & 3], t.v[(i + 3) & 3]};
      std::sort(facet.begin(), facet.end());
      facets.push_back(facet);
    }
  }
  sort_unique(edges);
  sort_unique(facets);
  return edges.size() + facets.size() + junctions;
}

void LiveComplex::recount(const Delta& delta, std::size_t killed_on_zero_set) {
  alive_tets_ += delta.added.size();
  alive_tets_ -= delta.removed.size();
  if (delta.form || !delta.dropped.empty()) {
    zero_set_vertices_ = extract_zero_set(complex_).vertices.size();
  } else if (complex_.form == ZeroForm::interpolated) {
    // The edges inside the star that change: those on its boundary count on both sides.
    zero_set_vertices_ += label_changes(delta.added);
    zero_set_vertices_ -= label_changes(delta.removed);
  } else {
    zero_set_vertices_ -= killed_on_zero_set;
    for (const Vertex& v : delta.added_vertices) zero_set_vertices_ += v.value == 0;
  }
}

void LiveComplex::apply(const Delta& delta) {
  std::size_t killed_on_zero_set = 0;
  if (complex_.form == ZeroForm::embedded && !delta.form)
    for (const VertexId v : delta.killed_vertices)
      killed_on_zero_set += on_zero_set(complex_, incidence_, v) ? 1u : 0u;
  complex_.apply(delta);
  incidence_.apply(delta);
  if (sets_ && delta.form) {
    sets_->assign_all(complex_);
  } else if (sets_) {
    sets_->redistribute(complex_, delta.removed, delta.added);
  }
  changed_.resize(complex_.vertices.size(), clock_);
  ++clock_;
  for (const auto* tets : {&delta.removed, &delta.added}) {
    for (const TetRecord& t : *tets) {
      for (const VertexId v : t.v) changed_[v.index()] = clock_;
    }
  }
  recount(delta, killed_on_zero_set);
}

} // namespace isoscope
