// Which tetrahedron holds each sample, f(s) and ε(s): derived from T and S, the same from whichever side a
// step is reached.
#pragma once

#include "mesh/complex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// ε(s) = 1 − f(s)/F(s) (§5); bad when ε >= 1 (§2.2).
constexpr double sample_error(double f, double label) {
  return 1.0 - f / label;
}
constexpr bool is_bad(double error) {
  return error >= 1.0;
}
/// The same once Z is embedded (§2.4.2): what counts is whether the tetrahedron that holds the sample is on
/// its side. There f may vanish on a whole tetrahedron between zero vertices; that leaves the sample good.
constexpr double embedded_sample_error(double error, bool own_side) {
  if (own_side) return error < 1.0 ? error : 1.0 - 0x1p-20;
  return error > 1.0 ? error : 1.0;
}
/// ε at a place in a tetrahedron with this f_i, of a sample of label i (§4.2).
constexpr double sample_error_in(const Tet& tet, double f_i, int label) {
  const double error = sample_error(f_i, 1);
  return tet.side == 0 ? error : embedded_sample_error(error, tet.side == label);
}
/// The same of a sample in T or Γ, by its label.
double sample_error_at(const Complex& complex, TetId t, Vec3 place, int label);

/// Per-tetrahedron sample lists over a fixed sample array. A sample on a shared face belongs to the
/// tetrahedron that holds s + t·e for a fixed generic direction e and all small t > 0 (exact predicates
/// decide), so the assignment depends on T only.
class SampleSets {
 public:
  /// `positions` must outlive this object.
  explicit SampleSets(std::span<const Vec3> positions);

  /// Assigns every sample to the tetrahedra of T from scratch (parallel walks).
  void assign_all(const Complex& complex);
  /// Moves the samples of the `from` tetrahedra (dead by now) into the `to` tetrahedra (alive in `complex`),
  /// for a delta that was just applied: removed to added, or undone: added to removed. Both must fill the
  /// same space; a sample that none of `to` holds is left without tetrahedron. Returns how many moved.
  /// Parallel when many.
  std::size_t redistribute(const Complex& complex, std::span<const TetRecord> from,
                           std::span<const TetRecord> to);

  /// Invalid for a sample outside the hull of T.
  TetId tet_of(SampleId s) const { return tet_of_[s.index()]; }
  /// Calls visit(SampleId) for the samples of t in ascending id order, always: lists are a function of T and
  /// S.
  template <class Visit> void for_each(TetId t, Visit&& visit) const {
    if (t.index() >= head_.size()) return;
    for (std::uint32_t s = head_[t.index()]; s != SampleId::none; s = next_[s]) visit(SampleId(s));
  }
  /// The samples of several tetrahedra, ascending.
  std::vector<SampleId> gather(std::span<const TetId> tets) const;
  std::size_t size() const { return tet_of_.size(); }
  std::size_t memory_bytes() const;

 private:
  std::span<const Vec3> positions_;
  std::vector<TetId> tet_of_;
  std::vector<std::uint32_t> head_; ///< by tetrahedron slot
  std::vector<std::uint32_t> next_; ///< by sample

  void push_front(std::size_t s, TetId t);
};

} // namespace isoscope
