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
  EdgeStar star = gather_edge_star(complex_, incidence_, a, b, ring);
  if (!sets_) return star;
  for (const EdgeStar::StarTet& t : star.tets) {
    sets_->for_each(t.id, [&](SampleId s) {
      star.samples.push_back({s, samples_->positions[s.index()], samples_->labels[s.index()]});
    });
  }
  // The first one that goes wrong is named: which one that is must not hang on the history of the lists.
  std::sort(star.samples.begin(), star.samples.end(),
            [](const auto& x, const auto& y) { return x.id < y.id; });
  return star;
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

StepFigures LiveComplex::step_figures() const {
  StepFigures figures;
  figures.zero_set_vertices = static_cast<std::uint32_t>(zero_set_vertices_);
  figures.tets = static_cast<std::uint32_t>(alive_tets_);
  figures.smallest_height = std::numeric_limits<float>::infinity();
  return figures;
}

std::size_t LiveComplex::sign_changes(const std::vector<TetRecord>& tets) const {
  std::vector<std::array<VertexId, 2>> edges;
  for (const TetRecord& t : tets) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (complex_.value(t.v[i]) * complex_.value(t.v[j]) < 0) {
          edges.push_back({std::min(t.v[i], t.v[j]), std::max(t.v[i], t.v[j])});
        }
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

void LiveComplex::recount(const Delta& delta, std::size_t killed_on_zero_set) {
  alive_tets_ += delta.added.size();
  alive_tets_ -= delta.removed.size();
  if (delta.form) {
    zero_set_vertices_ = extract_zero_set(complex_).vertices.size();
  } else if (complex_.form == ZeroForm::interpolated) {
    // The edges inside the star that change: those on its boundary count on both sides.
    zero_set_vertices_ += sign_changes(delta.added);
    zero_set_vertices_ -= sign_changes(delta.removed);
  } else if (!delta.dropped.empty() || !delta.added_vertices.empty()) {
    zero_set_vertices_ = extract_zero_set(complex_).vertices.size();
  } else {
    zero_set_vertices_ -= killed_on_zero_set;
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
