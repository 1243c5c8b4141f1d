// meshoptimizer's collapse, where its library was found.
#include "bench/meshoptimizer.h"

#ifdef ISOSCOPE_MESHOPTIMIZER

#include "tolerance/welded_mesh.h"

#include <meshoptimizer.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace isoscope::bench {

Result<TriangleMesh> meshoptimizer(const TriangleSoup& input, double delta) {
  const WeldedMesh welded = weld(input);
  std::vector<float> positions;
  for (const Vec3 p : welded.points)
    for (const double x : {p.x, p.y, p.z}) positions.push_back(static_cast<float>(x));
  std::vector<unsigned> corners;
  for (const IndexTriangle& t : welded.triangles)
    if (!is_collapsed(t)) corners.insert(corners.end(), t.begin(), t.end());

  const std::size_t stride = 3 * sizeof(float);
  const float scale = meshopt_simplifyScale(positions.data(), welded.points.size(), stride);
  const float error = static_cast<float>(delta) / scale;
  std::vector<unsigned> left(corners.size());
  left.resize(meshopt_simplify(left.data(), corners.data(), corners.size(), positions.data(),
                               welded.points.size(), stride, 0, error, 0, nullptr));

  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(welded.points.size(), unused);
  TriangleMesh mesh;
  for (std::size_t i = 0; i + 2 < left.size(); i += 3) {
    IndexTriangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& n = number[left[i + k]];
      if (n == unused) {
        n = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back(welded.points[left[i + k]]);
      }
      t[k] = n;
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

} // namespace isoscope::bench

#else

namespace isoscope::bench {

Result<TriangleMesh> meshoptimizer(const TriangleSoup&, double) {
  return Error{ErrorCode::unsupported, "This was built without meshoptimizer.",
               "Install libmeshoptimizer-dev and build again."};
}

} // namespace isoscope::bench

#endif
