// Edge collapse on a CGAL surface mesh with two filters.
#include "bench/lindstrom_turk.h"

#include "tolerance/closest_point.h"
#include "tolerance/facet_certificate.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Polyhedral_envelope_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace isoscope::bench {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

Vec3 vector_of(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

/// Lets a collapse pass when the fan about the new vertex is proven within δ.
class CertificateFilter {
 public:
  CertificateFilter(const ClosestPointIndex& index, double delta) : index_(&index), delta_(delta) {}
  template <class Profile>
  boost::optional<Point> operator()(const Profile& profile, const boost::optional<Point>& placement) const {
    if (!placement) return placement;
    const auto& link = profile.link();
    for (std::size_t i = 0, last = link.size() - 1; i < link.size(); last = i++) {
      const Triangle3 facet{vector_of(*placement), vector_of(get(profile.vertex_point_map(), link[last])),
                            vector_of(get(profile.vertex_point_map(), link[i]))};
      if (certify_facet(*index_, facet, delta_, delta_).kind != FacetVerdict::Kind::inside)
        return boost::none;
    }
    return placement;
  }

 private:
  const ClosestPointIndex* index_;
  double delta_;
};

/// The soup as a closed halfedge mesh; as it is where that works, so that ties are broken by its own order.
std::unique_ptr<SurfaceMesh> closed_surface(const TriangleSoup& soup) {
  std::vector<Point> points;
  for (const Vec3 p : soup.points) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& t : soup.triangles) polygons.push_back({t[0], t[1], t[2]});
  for (const bool repaired : {false, true}) {
    if (repaired) {
      pmp::repair_polygon_soup(points, polygons);
      if (!pmp::orient_polygon_soup(points, polygons)) return nullptr;
    }
    if (!pmp::is_polygon_soup_a_polygon_mesh(polygons)) continue;
    auto mesh = std::make_unique<SurfaceMesh>();
    pmp::polygon_soup_to_polygon_mesh(points, polygons, *mesh);
    if (CGAL::is_closed(*mesh)) return mesh;
  }
  return nullptr;
}

TriangleMesh plain(SurfaceMesh& mesh) {
  mesh.collect_garbage();
  TriangleMesh result;
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v)) result.points.push_back(vector_of(mesh.point(v)));
  std::vector<std::uint32_t> number(mesh.number_of_vertices(), 0);
  std::uint32_t next = 0;
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v)) number[v.idx()] = next++;
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) t[k++] = number[v.idx()];
    result.triangles.push_back(t);
  }
  return result;
}

} // namespace

Result<Simplified> lindstrom_turk(const TriangleSoup& input, double delta, CollapseFilter filter) {
  const std::unique_ptr<SurfaceMesh> mesh = closed_surface(input);
  if (!mesh) return Error{ErrorCode::unsupported, "The input is no closed 2-manifold.", ""};
  const sms::Count_stop_predicate<SurfaceMesh> never(0);
  if (filter == CollapseFilter::certificate) {
    const ClosestPointIndex index(input);
    sms::edge_collapse(*mesh, never, CGAL::parameters::filter(CertificateFilter(index, delta)));
  } else {
    sms::edge_collapse(*mesh, never,
                       CGAL::parameters::filter(sms::Polyhedral_envelope_filter<Kernel>(delta)));
  }
  return Simplified{plain(*mesh), pmp::does_self_intersect(*mesh)};
}

} // namespace isoscope::bench
