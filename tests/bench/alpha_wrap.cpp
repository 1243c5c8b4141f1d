// CGAL's alpha wrap, where CGAL has it.
#include "bench/alpha_wrap.h"

#if __has_include(<CGAL/alpha_wrap_3.h>)

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace isoscope::bench {

Result<TriangleMesh> alpha_wrap(const TriangleSoup& input, double delta) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  for (const Vec3 p : input.points) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::array<std::size_t, 3>> faces;
  for (const auto& t : input.triangles) faces.push_back({t[0], t[1], t[2]});
  CGAL::Surface_mesh<Point> wrap;
  CGAL::alpha_wrap_3(points, faces, delta, delta / 2, wrap);

  TriangleMesh mesh;
  wrap.collect_garbage();
  for (const auto v : wrap.vertices()) {
    const Point& p = wrap.point(v);
    mesh.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : wrap.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t k = 0;
    for (const auto v : CGAL::vertices_around_face(wrap.halfedge(f), wrap)) t[k++] = v.idx();
    mesh.triangles.push_back(t);
  }
  return mesh;
}

} // namespace isoscope::bench

#else

namespace isoscope::bench {

Result<TriangleMesh> alpha_wrap(const TriangleSoup&, double) {
  return Error{ErrorCode::unsupported, "This was built with a CGAL that has no alpha wrap.",
               "Build with CGAL 5.5."};
}

} // namespace isoscope::bench

#endif
