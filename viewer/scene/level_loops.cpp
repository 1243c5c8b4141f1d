// Closed level curves of values on a planar lattice: marching squares, each crossed edge met once.
#include "scene/level_loops.h"

#include <array>
#include <cstdint>
#include <utility>

namespace isoscope {
namespace {

constexpr std::int64_t none = -1;

/// Edges are numbered by their lower left end: 2 i to the right, 2 i + 1 upwards.
struct Edges {
  const Lattice& lattice;
  std::int64_t cell(int x, int y) const { return static_cast<std::int64_t>(y) * lattice.columns + x; }
  /// Edges of the cell above right of (x, y), counterclockwise from the lower one.
  std::array<std::int64_t, 4> around(int x, int y) const {
    return {2 * cell(x, y), 2 * cell(x + 1, y) + 1, 2 * cell(x, y + 1), 2 * cell(x, y) + 1};
  }
  PlanePoint crossing(std::int64_t edge, float level) const {
    const std::int64_t i = edge / 2, j = i + (edge % 2 == 0 ? 1 : lattice.columns);
    const double a = lattice.values[static_cast<std::size_t>(i)],
                 b = lattice.values[static_cast<std::size_t>(j)];
    const double t = (level - a) / (b - a);
    const auto x = static_cast<double>(i % lattice.columns), y = static_cast<double>(i / lattice.columns);
    return {lattice.origin.u + lattice.spacing * (x + (edge % 2 == 0 ? t : 0)),
            lattice.origin.v + lattice.spacing * (y + (edge % 2 == 0 ? 0 : t))};
  }
};

} // namespace

std::vector<std::vector<PlanePoint>> level_loops(const Lattice& lattice, float level) {
  const Edges edges{lattice};
  std::vector<std::int64_t> next(2 * lattice.values.size(), none);
  const auto below = [&](int x, int y) {
    return lattice.values[static_cast<std::size_t>(edges.cell(x, y))] < level;
  };
  for (int y = 0; y + 1 < lattice.rows; ++y)
    for (int x = 0; x + 1 < lattice.columns; ++x) {
      const std::array<bool, 4> in{below(x, y), below(x + 1, y), below(x + 1, y + 1), below(x, y + 1)};
      const auto edge = edges.around(x, y);
      // From each edge that leaves what is below to the next one that comes back.
      for (std::size_t k = 0; k < 4; ++k) {
        if (!in[k] || in[(k + 1) % 4]) continue;
        std::size_t back = (k + 1) % 4;
        while (in[back] || !in[(back + 1) % 4]) back = (back + 1) % 4;
        next[static_cast<std::size_t>(edge[k])] = edge[back];
      }
    }
  std::vector<std::vector<PlanePoint>> loops;
  for (std::size_t start = 0; start < next.size(); ++start) {
    std::vector<PlanePoint> loop;
    auto at = static_cast<std::int64_t>(start);
    while (next[static_cast<std::size_t>(at)] != none) {
      loop.push_back(edges.crossing(at, level));
      at = std::exchange(next[static_cast<std::size_t>(at)], none);
    }
    if (loop.size() > 2 && at == static_cast<std::int64_t>(start)) loops.push_back(std::move(loop));
  }
  return loops;
}

} // namespace isoscope
