// Elimination by rows, which leaves out what is zero.
#include "improve/symmetric_system.h"

#include <algorithm>

namespace isoscope {

void SymmetricSystem::clear() {
  std::fill(a_.begin(), a_.end(), 0.);
  std::fill(b_.begin(), b_.end(), 0.);
}

bool SymmetricSystem::solve() {
  for (std::size_t k = 0; k < n_; ++k) {
    const double* pivot = &a_[k * n_];
    if (!(pivot[k] > 0)) return false;
    for (std::size_t i = k + 1; i < n_; ++i) {
      if (pivot[i] == 0) continue;
      const double factor = pivot[i] / pivot[k];
      double* row = &a_[i * n_];
      for (std::size_t j = i; j < n_; ++j) row[j] -= factor * pivot[j];
      b_[i] -= factor * b_[k];
    }
  }
  for (std::size_t k = n_; k-- > 0;) {
    const double* row = &a_[k * n_];
    double sum = b_[k];
    for (std::size_t j = k + 1; j < n_; ++j) sum -= row[j] * b_[j];
    b_[k] = sum / row[k];
  }
  return true;
}

} // namespace isoscope
