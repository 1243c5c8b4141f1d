// Exact distances, one axis after the other: of parabolas over the samples of a row the lower envelope gives
// the least sum (Felzenszwalb and Huttenlocher 2012).
#include "input/label_grid.h"

#include "base/numbers.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// Replaces f, squared distances along a row, by the least of f(j) + (i - j)² step².
class RowEnvelope {
 public:
  explicit RowEnvelope(std::size_t n) : parabolas_(n), begins_(n + 1), result_(n) {}
  void apply(std::vector<double>& f, double step) {
    const std::size_t n = f.size();
    std::size_t count = 0;
    const auto meet = [&](std::size_t a, std::size_t b) { // a < b: from where on b is the lower one
      const auto x = static_cast<double>(a), y = static_cast<double>(b);
      return 0.5 * ((f[b] - f[a]) / (step * step * (y - x)) + x + y);
    };
    for (std::size_t j = 0; j < n; ++j) {
      if (f[j] == none) continue;
      while (count > 0 && meet(parabolas_[count - 1], j) <= begins_[count - 1]) --count;
      begins_[count] = count == 0 ? -none : meet(parabolas_[count - 1], j);
      parabolas_[count++] = j;
    }
    if (count == 0) return;
    for (std::size_t i = 0, k = 0; i < n; ++i) {
      const auto x = static_cast<double>(i);
      while (k + 1 < count && begins_[k + 1] <= x) ++k;
      const double gap = (x - static_cast<double>(parabolas_[k])) * step;
      result_[i] = f[parabolas_[k]] + gap * gap;
    }
    std::copy(result_.begin(), result_.end(), f.begin());
  }

 private:
  std::vector<std::size_t> parabolas_;
  std::vector<double> begins_, result_;
};

/// Squared distances from every point to the nearest marked one, in lengths of `unit`.
std::vector<float> squared_distances(const ScalarGrid& grid, const std::vector<char>& marked, double unit,
                                     const RunControl& control) {
  std::vector<float> d(grid.values.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = marked[i] ? 0.0F : std::numeric_limits<float>::infinity();
  const std::size_t strides[3] = {1, grid.size[0], grid.size[0] * grid.size[1]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t n = grid.size[axis], u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double step = grid.spacing[static_cast<int>(axis)] / unit;
    parallel_until(grid.size[v], 1, control, [&](std::size_t j) {
      RowEnvelope envelope(n);
      std::vector<double> row(n);
      for (std::size_t i = 0; i < grid.size[u]; ++i) {
        float* first = d.data() + i * strides[u] + j * strides[v];
        for (std::size_t k = 0; k < n; ++k) row[k] = static_cast<double>(first[k * strides[axis]]);
        envelope.apply(row, step);
        for (std::size_t k = 0; k < n; ++k) first[k * strides[axis]] = static_cast<float>(row[k]);
      }
    });
  }
  return d;
}

} // namespace

Result<ScalarGrid> label_distance(const ScalarGrid& labels, double label, const RunControl& control) {
  std::vector<char> inside(labels.values.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside[i] = static_cast<double>(labels.values[i]) == label;
    count += inside[i] ? 1 : 0;
  }
  if (count == 0 || count == inside.size())
    return Error{ErrorCode::bad_input,
                 std::string(count == 0 ? "No voxel" : "Every voxel") + " has the label " +
                     general(label, 10) + ".",
                 "Give a label that some voxels have."};
  const double unit = std::min({labels.spacing.x, labels.spacing.y, labels.spacing.z});
  std::vector<float> to_inside = squared_distances(labels, inside, unit, control);
  for (char& mark : inside) mark = mark ? 0 : 1;
  const std::vector<float> to_outside = squared_distances(labels, inside, unit, control);
  if (control.cancelled()) return Error{ErrorCode::cancelled, "Stopped while the label was measured.", ""};
  ScalarGrid distances = labels;
  for (std::size_t i = 0; i < distances.values.size(); ++i)
    distances.values[i] = to_inside[i] > 0 ? std::sqrt(to_inside[i]) - 0.5F : 0.5F - std::sqrt(to_outside[i]);
  return distances;
}

} // namespace isoscope
