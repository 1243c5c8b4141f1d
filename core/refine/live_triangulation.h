// T, the samples in it and the figures of each tetrahedron, kept together through every insertion.
#pragma once

#include "journal/journal.h"
#include "mesh/complex.h"
#include "mesh/delaunay.h"
#include "mesh/sample_sets.h"
#include "refine/steiner_queue.h"
#include "refine/zero_components.h"

#include <memory>
#include <span>
#include <vector>

namespace isoscope {

/// What a tetrahedron's samples and vertices say of it.
struct TetFigures {
  double largest_error = 0; ///< over its samples that are not blocked; valid with `worst`
  SampleId worst;           ///< the sample of that error, the smallest id of several; invalid without samples
  std::uint32_t bad = 0;    ///< samples with ε >= 1
  double height = 0;        ///< of condition 2; infinite when it does not carry Z
};

/// The Delaunay triangulation under refinement. One thread.
class LiveTriangulation {
 public:
  explicit LiveTriangulation(std::shared_ptr<const BoundarySamples> samples);

  /// Starts from the corners of the loose box.
  Delta start(std::span<const Vertex> corners);
  /// Inserts a vertex; nullopt when it is a vertex already or outside the box.
  std::optional<Delta> insert(const Vertex& vertex, TetId hint);
  /// Turns F of these vertices to the other side.
  Delta relabel(std::span<const VertexId> vertices);
  /// Exchanges S; `set` is its number in the journal.
  Delta replace_samples(std::shared_ptr<const BoundarySamples> samples, std::uint16_t set);

  /// What the last change did: slots whose tetrahedron died, and living ones whose figures are new.
  std::span<const TetId> gone() const { return gone_; }
  std::span<const TetId> changed() const { return changed_; }

  const Complex& complex() const { return complex_; }
  const Delaunay& delaunay() const { return delaunay_; }
  const SampleSets& sample_sets() const { return *sets_; }
  const BoundarySamples& samples() const { return *samples_; }
  std::uint16_t sample_set() const { return sample_set_; }
  const TetFigures& figures(TetId t) const { return figures_[t.index()]; }
  bool alive(TetId t) const {
    return t.valid() && t.index() < complex_.tets.size() && complex_.tet(t).alive();
  }
  /// Whether t carries Z.
  bool heterogeneous(TetId t) const { return figures_[t.index()].height < Box3::inf; }
  /// Grows whenever the slot changes hands or its values change.
  std::uint32_t generation(TetId t) const { return generations_[t.index()]; }

  /// Tetrahedra by their largest ε.
  const SteinerQueue& errors() const { return errors_; }
  /// A sample that cannot become a vertex is not offered again.
  void block(SampleId s);
  std::size_t blocked() const { return blocked_count_; }

  std::size_t bad_samples() const { return bad_; }
  std::size_t zero_set_vertices() const { return static_cast<std::size_t>(zero_.vertices); }
  /// χ of Z.
  long euler_characteristic() const { return zero_.vertices - zero_.edges + zero_.polygons; }
  std::size_t zero_components() { return zero_components_.count(complex_, delaunay_); }
  std::size_t sample_moves() const { return moves_; }
  /// The figures of a step, but for its time.
  StepFigures step_figures() const;
  void set_delta(double delta) { delta_ = delta; }

 private:
  struct ZeroCells {
    long vertices = 0, edges = 0, polygons = 0;
  };
  /// The cells of Z in some tetrahedra.
  ZeroCells count_zero_cells(std::span<const TetRecord> tets);
  void add(const ZeroCells& cells, long factor);
  void leave(TetId t);
  void measure_all(std::span<const TetId> tets, std::size_t samples_in_them);
  TetFigures measure(TetId t) const;
  void reassign_all();

  std::shared_ptr<const BoundarySamples> samples_;
  std::uint16_t sample_set_ = 0;
  Delaunay delaunay_;
  Complex complex_;
  std::unique_ptr<SampleSets> sets_;
  std::vector<TetFigures> figures_;
  std::vector<std::uint32_t> generations_;
  std::vector<bool> blocked_;
  std::size_t blocked_count_ = 0;
  SteinerQueue errors_, flatness_;
  std::vector<TetId> gone_, changed_;
  std::size_t bad_ = 0, alive_ = 0, moves_ = 0;
  ZeroCells zero_;
  ZeroComponents zero_components_;
  double delta_ = 1;
  std::vector<std::uint64_t> edge_scratch_;
  std::vector<std::array<std::uint32_t, 3>> facet_scratch_, junction_scratch_;
};

} // namespace isoscope
