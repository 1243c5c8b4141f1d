// isoscope-subdivide MODEL TIMES NOISE OUT: makes a large input of a small one. Each triangle becomes four,
// TIMES times; then each vertex is moved by at most NOISE and a tenth of its shortest edge.
#include "base/geometry.h"
#include "input/mesh_io.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace isoscope;

namespace {

constexpr double share_of_edge = 0.1;

/// An edge by its ends, with the corner of a triangle that is opposite to it.
struct Side {
  std::uint32_t low, high, corner;
  bool same_edge(const Side& s) const { return low == s.low && high == s.high; }
};

void divide(TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][(k + 1) % 3], b = mesh.triangles[t][(k + 2) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
  });
  std::vector<std::uint32_t> middle(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || !sides[i].same_edge(sides[i - 1]))
      mesh.points.push_back(0.5 * (mesh.points[sides[i].low] + mesh.points[sides[i].high]));
    middle[sides[i].corner] = static_cast<std::uint32_t>(mesh.points.size() - 1);
  }
  std::vector<std::array<std::uint32_t, 3>> finer;
  finer.reserve(4 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const std::uint32_t bc = middle[3 * t], ca = middle[3 * t + 1], ab = middle[3 * t + 2];
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(finer);
}

void add_noise(TriangleMesh& mesh, double noise) {
  std::vector<double> most(mesh.points.size(), noise);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double limit = share_of_edge * distance(mesh.points[a], mesh.points[b]);
      most[a] = std::min(most[a], limit);
      most[b] = std::min(most[b], limit);
    }
  std::uint64_t random = 1;
  const auto draw = [&random] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(random >> 32) / (1LL << 31) - 1;
  };
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3 way{draw(), draw(), draw()};
    mesh.points[v] += most[v] / std::max(1.0, length(way)) * way;
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("isoscope-subdivide MODEL TIMES NOISE OUT\n", stderr);
    return 2;
  }
  const auto read = read_mesh(argv[1]);
  if (!read) {
    std::fprintf(stderr, "%s\n", read.error().line().c_str());
    return 3;
  }
  TriangleMesh mesh{read->points, read->triangles};
  for (int i = std::atoi(argv[2]); i > 0; --i) divide(mesh);
  add_noise(mesh, std::atof(argv[3]));
  const Status written = write_mesh(argv[4], mesh);
  if (!written) std::fprintf(stderr, "%s\n", written.error().line().c_str());
  return written ? 0 : 1;
}
