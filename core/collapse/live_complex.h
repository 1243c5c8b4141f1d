// T while it is simplified: the state, what meets at each vertex, and when each neighbourhood last changed.
#pragma once

#include "journal/journal.h"
#include "mesh/complex.h"
#include "mesh/incidence.h"
#include "mesh/sample_sets.h"
#include "mesh/zero_set.h"
#include "tolerance/boundary_sampler.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// The state between two operations. Reading is thread-safe, changing is for one thread.
class LiveComplex {
 public:
  /// `samples` are followed from tetrahedron to tetrahedron when given (sampled mode).
  explicit LiveComplex(Complex complex, std::shared_ptr<const BoundarySamples> samples);

  const Complex& complex() const { return complex_; }
  const Incidence& incidence() const { return incidence_; }
  bool alive(VertexId v) const { return complex_.vertices[v.index()].alive; }
  bool adjacent(VertexId a, VertexId b) const { return incidence_.adjacent(complex_, a, b); }
  /// Grows with every change; the time of the last one that reached a tetrahedron at v.
  std::uint32_t clock() const { return clock_; }
  std::uint32_t changed(VertexId v) const { return changed_[v.index()]; }

  /// The star of an edge, without samples.
  EdgeStar star(VertexId a, VertexId b, CostRing ring) const;
  /// Fills in the samples of a star of the present T where they are followed. They take longer than the star.
  void add_samples(EdgeStar& star) const;
  /// Vertices joined to v by an edge, ascending.
  std::vector<VertexId> neighbors(VertexId v) const;
  /// The delta of collapsing the edge ab to `target`; a stays.
  Delta collapse(VertexId a, VertexId b, Vec3 target) const;
  /// The delta of splitting the edge ab at a point of it; nothing where a tetrahedron would turn over.
  std::optional<Delta> split(VertexId a, VertexId b, Vec3 point) const;
  /// The delta of turning the edge ab of Z within its two facets; nothing where that is not possible.
  std::optional<Delta> flip(VertexId a, VertexId b) const { return flip_delta(complex_, incidence_, a, b); }
  void apply(const Delta& delta);

  std::size_t alive_tets() const { return alive_tets_; }
  /// Vertices of Z: zeros on edges and junctions, or vertices with F = 0 once it is embedded.
  std::size_t zero_set_vertices() const { return zero_set_vertices_; }

  /// The figures of a step, but for its time.
  StepFigures step_figures() const;

 private:
  void recount(const Delta& delta, std::size_t killed_on_zero_set);
  std::size_t label_changes(const std::vector<TetRecord>& tets) const;

  Complex complex_;
  Incidence incidence_;
  std::shared_ptr<const BoundarySamples> samples_;
  std::unique_ptr<SampleSets> sets_;
  std::vector<std::uint32_t> changed_;
  std::uint32_t clock_ = 1;
  std::size_t alive_tets_ = 0, zero_set_vertices_ = 0;
};

} // namespace isoscope
