// A dense symmetric positive definite system: its upper half, solved in place.
#pragma once

#include <cstddef>
#include <vector>

namespace isoscope {

/// A x = b of n unknowns, for a few hundred of them.
class SymmetricSystem {
 public:
  explicit SymmetricSystem(std::size_t n) : n_(n), a_(n * n), b_(n) {}
  void clear();
  std::size_t size() const { return n_; }
  /// Row at most column.
  double& a(std::size_t row, std::size_t column) { return a_[row * n_ + column]; }
  double& b(std::size_t row) { return b_[row]; }
  /// Replaces b by x, and the matrix by what is of no use; false where it is not positive definite.
  bool solve();

 private:
  std::size_t n_;
  std::vector<double> a_, b_;
};

} // namespace isoscope
