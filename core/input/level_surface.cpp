// Marching tetrahedra over Kuhn's subdivision of each cube.
#include "input/level_surface.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace isoscope {
namespace {

/// The corners of the six tetrahedra of a cube, numbered by bits x, y, z: the ways from corner 0 to corner 7.
/// Every second one is mirrored, as `mirrored` tells.
struct KuhnTetrahedron {
  std::array<unsigned, 4> corners;
  bool mirrored;
};
constexpr std::array<KuhnTetrahedron, 6> tetrahedra{{{{0, 1, 3, 7}, false},
                                                     {{0, 1, 5, 7}, true},
                                                     {{0, 2, 3, 7}, true},
                                                     {{0, 2, 6, 7}, false},
                                                     {{0, 4, 5, 7}, false},
                                                     {{0, 4, 6, 7}, true}}};

class Marching {
 public:
  Marching(const ScalarGrid& grid, double level, TriangleSoup& soup)
      : grid_(grid), level_(level), soup_(soup) {}

  void run(const RunControl& control) {
    for (std::size_t z = 0; z + 1 < grid_.size[2]; ++z) {
      if (control.cancelled()) return;
      for (std::size_t y = 0; y + 1 < grid_.size[1]; ++y)
        for (std::size_t x = 0; x + 1 < grid_.size[0]; ++x) march(x, y, z);
      forget_layer();
    }
  }

 private:
  /// A point of the grid, and which side of the level it is on.
  struct Corner {
    std::array<std::size_t, 3> at;
    std::size_t index;
    double value;
    bool above;
  };

  void march(std::size_t x, std::size_t y, std::size_t z) {
    std::array<Corner, 8> corners;
    unsigned above = 0;
    for (unsigned k = 0; k < 8; ++k) {
      const std::array<std::size_t, 3> at{x + (k & 1u), y + ((k >> 1) & 1u), z + (k >> 2)};
      const std::size_t index = grid_.index(at[0], at[1], at[2]);
      const auto value = static_cast<double>(grid_.values[index]);
      corners[k] = {at, index, value, value > level_};
      above += corners[k].above ? 1u : 0u;
    }
    if (above == 0 || above == 8) return;
    for (const KuhnTetrahedron& t : tetrahedra) {
      std::array<const Corner*, 4> c{};
      for (std::size_t i = 0; i < 4; ++i) c[i] = &corners[t.corners[i]];
      cut(c, t.mirrored);
    }
  }

  /// The triangles in one tetrahedron. Corners are swapped in pairs until those above come first: each swap
  /// mirrors it.
  void cut(std::array<const Corner*, 4> c, bool mirrored) {
    std::size_t above = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!c[i]->above) continue;
      if (i != above) std::swap(c[i], c[above]), mirrored = !mirrored;
      ++above;
    }
    if (above == 1) add(between(c[0], c[1]), between(c[0], c[2]), between(c[0], c[3]), !mirrored);
    if (above == 3) add(between(c[3], c[0]), between(c[3], c[1]), between(c[3], c[2]), !mirrored);
    if (above != 2) return;
    const std::uint32_t p = between(c[0], c[2]), q = between(c[0], c[3]), r = between(c[1], c[3]),
                        s = between(c[1], c[2]);
    add(p, q, r, !mirrored);
    add(p, r, s, !mirrored);
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
    if (a == b || b == c || c == a) return;
    soup_.triangles.push_back(turned ? std::array{a, c, b} : std::array{a, b, c});
  }

  /// The zero on the edge between two points, the same for all tetrahedra around it.
  std::uint32_t between(const Corner* a, const Corner* b) {
    if (a->index > b->index) std::swap(a, b);
    const auto [place, fresh] =
        zeros_.try_emplace(std::pair{a->index, b->index}, static_cast<std::uint32_t>(soup_.points.size()));
    if (fresh) {
      const double t = (level_ - a->value) / (b->value - a->value);
      const Vec3 p = grid_.point(a->at[0], a->at[1], a->at[2]), q = grid_.point(b->at[0], b->at[1], b->at[2]);
      soup_.points.push_back(p + t * (q - p));
    }
    return place->second;
  }

  /// Only edges of the upper face of a layer are met again.
  void forget_layer() {
    const std::size_t plane = grid_.size[0] * grid_.size[1];
    std::erase_if(zeros_, [&](const auto& zero) {
      return zero.first.first / plane != zero.first.second / plane || zero.first.first / plane == layer_;
    });
    ++layer_;
  }

  struct Hash {
    std::size_t operator()(const std::pair<std::size_t, std::size_t>& edge) const {
      std::uint64_t h = edge.first * 0x9e3779b97f4a7c15u;
      h = (h ^ (h >> 29) ^ (edge.second - edge.first)) * 0xbf58476d1ce4e5b9u;
      return static_cast<std::size_t>(h ^ (h >> 32));
    }
  };

  const ScalarGrid& grid_;
  double level_;
  TriangleSoup& soup_;
  std::unordered_map<std::pair<std::size_t, std::size_t>, std::uint32_t, Hash> zeros_;
  std::size_t layer_ = 0;
};

} // namespace

void add_level_surface(const ScalarGrid& grid, double level, TriangleSoup& soup, const RunControl& control) {
  Marching(grid, level, soup).run(control);
}

} // namespace isoscope
