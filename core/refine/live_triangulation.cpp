// Follows T through its deltas: samples move, figures of the new tetrahedra are measured, Z is counted at its
// changes.
#include "refine/live_triangulation.h"

#include "base/parallel.h"
#include "criteria/height.h"
#include "mesh/label_functions.h"
#include "refine/simplices.h"

#include <algorithm>

namespace isoscope {
namespace {

/// Below this many samples a change is measured by one thread.
constexpr std::size_t parallel_samples = 4096;

/// ε where f could not be computed (a tetrahedron of no volume in floating point): bad, so that the sample
/// goes in.
constexpr double unknown_error = 2;

template <class T> long count_distinct(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  return static_cast<long>(std::unique(items.begin(), items.end()) - items.begin());
}

} // namespace

LiveTriangulation::LiveTriangulation(std::shared_ptr<const BoundarySamples> samples)
    : samples_(std::move(samples)), sets_(std::make_unique<SampleSets>(samples_->positions)),
      blocked_(samples_->size(), false) {}

Delta LiveTriangulation::start(std::span<const Vertex> corners) {
  Delta delta = delaunay_.start(corners);
  complex_.apply(delta);
  add(count_zero_cells(delta.added), +1);
  zero_components_.forget();
  reassign_all();
  return delta;
}

void LiveTriangulation::reassign_all() {
  sets_->assign_all(complex_);
  moves_ += samples_->size();
  gone_.clear();
  changed_.clear();
  bad_ = 0;
  alive_ = 0;
  errors_.clear();
  flatness_.clear();
  for (std::uint32_t i = 0; i < complex_.tets.size(); ++i) {
    if (complex_.tets[i].alive()) changed_.push_back(TetId(i));
  }
  alive_ = changed_.size();
  measure_all(changed_, samples_->size());
}

std::optional<Delta> LiveTriangulation::insert(const Vertex& vertex, TetId hint) {
  std::optional<Delta> delta = delaunay_.insert(vertex, hint);
  if (!delta) return std::nullopt;
  add(count_zero_cells(delta->removed), -1);
  complex_.apply(*delta);
  add(count_zero_cells(delta->added), +1);
  zero_components_.replace(complex_, delta->removed, delta->added);
  gone_.clear();
  changed_.clear();
  for (const TetRecord& t : delta->removed) {
    gone_.push_back(t.id);
    leave(t.id);
  }
  const std::size_t moved = sets_->redistribute(complex_, delta->removed, delta->added);
  moves_ += moved;
  for (const TetRecord& t : delta->added) changed_.push_back(t.id);
  alive_ += delta->added.size();
  alive_ -= delta->removed.size();
  measure_all(changed_, moved);
  return delta;
}

Delta LiveTriangulation::relabel(std::span<const VertexId> vertices) {
  Delta delta;
  std::vector<bool> turned(complex_.vertices.size(), false);
  for (const VertexId v : vertices) {
    turned[v.index()] = true;
    delta.values.push_back({v, complex_.value(v), -complex_.value(v)});
  }
  std::vector<TetRecord> star;
  for (std::uint32_t i = 0; i < complex_.tets.size(); ++i) {
    const Tet& tet = complex_.tets[i];
    if (!tet.alive()) continue;
    if (std::any_of(tet.v.begin(), tet.v.end(), [&](VertexId v) { return turned[v.index()]; })) {
      star.push_back({TetId(i), tet.v});
    }
  }
  add(count_zero_cells(star), -1);
  complex_.apply(delta);
  add(count_zero_cells(star), +1);
  zero_components_.forget();
  gone_.clear();
  changed_.clear();
  for (const TetRecord& t : star) {
    leave(t.id);
    changed_.push_back(t.id);
  }
  measure_all(changed_, 0);
  return delta;
}

Delta LiveTriangulation::replace_samples(std::shared_ptr<const BoundarySamples> samples, std::uint16_t set) {
  Delta delta;
  delta.sample_set = Delta::SampleSetChange{sample_set_, set};
  samples_ = std::move(samples);
  sample_set_ = set;
  sets_ = std::make_unique<SampleSets>(samples_->positions);
  blocked_.assign(samples_->size(), false);
  blocked_count_ = 0;
  reassign_all();
  return delta;
}

LiveTriangulation::ZeroCells LiveTriangulation::count_zero_cells(std::span<const TetRecord> tets) {
  ZeroCells cells;
  edge_scratch_.clear();
  facet_scratch_.clear();
  junction_scratch_.clear();
  for (const TetRecord& t : tets) {
    const TetLabels label{complex_.label(t.v[0]), complex_.label(t.v[1]), complex_.label(t.v[2]),
                          complex_.label(t.v[3])};
    const int labels = label_count(label);
    if (labels < 2) continue;
    long corners = 0, segments = 0; // of what Z has on the facets
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (label[i] == label[j]) continue;
        edge_scratch_.push_back(packed(t.v[i], t.v[j]));
        ++corners;
      }
      TetLabels rest = label;
      rest[i] = 0;
      const int on_facet = label_count(rest);
      if (on_facet < 2) continue;
      std::array<std::uint32_t, 3> facet{};
      for (std::size_t j = 0, k = 0; j < 4; ++j) {
        if (j != i) facet[k++] = t.v[j].value;
      }
      std::sort(facet.begin(), facet.end());
      (on_facet == 2 ? facet_scratch_ : junction_scratch_).push_back(facet);
      segments += on_facet == 2 ? 1 : 3;
      corners += on_facet == 2 ? 0 : 1;
    }
    if (labels == 2) {
      ++cells.polygons;
      continue;
    }
    // A cone from a vertex inside.
    ++cells.vertices;
    cells.edges += corners;
    cells.polygons += segments;
  }
  const long middles = count_distinct(junction_scratch_);
  cells.vertices += count_distinct(edge_scratch_) + middles;
  cells.edges += count_distinct(facet_scratch_) + 3 * middles;
  return cells;
}

void LiveTriangulation::add(const ZeroCells& cells, long factor) {
  zero_.vertices += factor * cells.vertices;
  zero_.edges += factor * cells.edges;
  zero_.polygons += factor * cells.polygons;
}

void LiveTriangulation::leave(TetId t) {
  bad_ -= figures_[t.index()].bad;
  errors_.erase(t);
  flatness_.erase(t);
}

void LiveTriangulation::measure_all(std::span<const TetId> tets, std::size_t samples_in_them) {
  figures_.resize(std::max(figures_.size(), complex_.tets.size()));
  generations_.resize(figures_.size(), 0);
  parallel_for(tets.size(), samples_in_them >= parallel_samples ? 1 : tets.size(),
               [&](std::size_t i) { figures_[tets[i].index()] = measure(tets[i]); });
  for (const TetId t : tets) {
    const TetFigures& figures = figures_[t.index()];
    ++generations_[t.index()];
    bad_ += figures.bad;
    if (figures.worst.valid()) errors_.set(t, figures.largest_error);
    if (heterogeneous(t)) flatness_.set(t, -figures.height);
  }
}

TetFigures LiveTriangulation::measure(TetId t) const {
  const Height height = tetrahedron_height(complex_.positions(t), complex_.values(t), complex_.labels(t));
  TetFigures figures;
  figures.height = height.split == Height::Split::none ? Box3::inf : height.value;
  LabelFunctions functions(complex_, t);
  sets_->for_each(t, [&](SampleId s) {
    double error = sample_error(functions.of(samples_->labels[s.index()])(samples_->positions[s.index()]), 1);
    if (!std::isfinite(error)) error = unknown_error;
    if (is_bad(error)) ++figures.bad;
    if (blocked_[s.index()]) return;
    if (!figures.worst.valid() || error > figures.largest_error) {
      figures.largest_error = error;
      figures.worst = s;
    }
  });
  return figures;
}

void LiveTriangulation::block(SampleId s) {
  if (blocked_[s.index()]) return;
  blocked_[s.index()] = true;
  ++blocked_count_;
  const TetId t = sets_->tet_of(s);
  if (!alive(t)) return;
  figures_[t.index()] = measure(t);
  if (figures_[t.index()].worst.valid())
    errors_.set(t, figures_[t.index()].largest_error);
  else
    errors_.erase(t);
}

StepFigures LiveTriangulation::step_figures() const {
  StepFigures figures;
  figures.bad_samples = static_cast<std::uint32_t>(bad_);
  figures.zero_set_vertices = static_cast<std::uint32_t>(zero_.vertices);
  figures.tets = static_cast<std::uint32_t>(alive_);
  figures.largest_error = errors_.empty() ? 0 : static_cast<float>(errors_.top_key());
  figures.smallest_height = flatness_.empty() ? std::numeric_limits<float>::infinity()
                                              : static_cast<float>(-flatness_.top_key() / delta_);
  return figures;
}

} // namespace isoscope
