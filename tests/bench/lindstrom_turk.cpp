// Edge collapse on a CGAL surface mesh with two filters.
#include "bench/lindstrom_turk.h"

#include "tolerance/border_gate.h"
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

std::vector<Segment3> border_of(const SurfaceMesh& mesh) {
  std::vector<Segment3> border;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      border.push_back({vector_of(mesh.point(mesh.source(h))), vector_of(mesh.point(mesh.target(h)))});
  return border;
}

/// Lets a collapse pass when the fan about the new vertex is proven within δ, and where the border changes it
/// and the input's stay within δ of each other.
class CertificateFilter {
 public:
  CertificateFilter(const ClosestPointIndex& index, const BorderGate& gate, double delta)
      : index_(&index), gate_(&gate), delta_(delta) {}
  template <class Profile>
  boost::optional<Point> operator()(const Profile& profile, const boost::optional<Point>& placement) const {
    if (!placement) return placement;
    const Vec3 target = vector_of(*placement);
    for (const auto& t : profile.triangles()) {
      int ends = 0;
      Triangle3 facet;
      std::size_t k = 0;
      for (const auto v : {t.v0, t.v1, t.v2}) {
        const bool end = v == profile.v0() || v == profile.v1();
        ends += end ? 1 : 0;
        facet[k++] = end ? target : vector_of(get(profile.vertex_point_map(), v));
      }
      if (ends == 1 && certify_facet(*index_, facet, delta_, delta_).kind != FacetVerdict::Kind::inside)
        return boost::none;
    }
    return keeps_border(profile, target) ? placement : boost::none;
  }

 private:
  template <class Profile> bool keeps_border(const Profile& profile, Vec3 target) const {
    constexpr int most_beyond = 40;
    const SurfaceMesh& mesh = profile.surface_mesh();
    const auto at = [&](auto v) { return vector_of(mesh.point(v)); };
    std::vector<Segment3> before, after;
    for (const auto v : {profile.v0(), profile.v1()}) {
      const auto other = v == profile.v0() ? profile.v1() : profile.v0();
      for (const auto h : CGAL::halfedges_around_target(v, mesh)) {
        if (!mesh.is_border(h) && !mesh.is_border(mesh.opposite(h))) continue;
        const auto u = mesh.source(h);
        if (u == other && v == profile.v1()) continue;
        before.push_back({at(v), at(u)});
        if (u == other) continue;
        const Segment3 edge{target, at(u)};
        if (!gate_->keeps_to_rim(edge).proven) return false;
        after.push_back(edge);
        const bool forwards = mesh.is_border(mesh.opposite(h));
        auto walk = forwards ? mesh.opposite(h) : h;
        for (int i = 0; i < most_beyond; ++i) {
          walk = forwards ? mesh.next(walk) : mesh.prev(walk);
          const auto s = mesh.source(walk), e = mesh.target(walk);
          if (s == profile.v0() || s == profile.v1() || e == profile.v0() || e == profile.v1()) break;
          after.push_back({at(s), at(e)});
        }
      }
    }
    return before.empty() || gate_->covers_rim(before, after).proven;
  }

  const ClosestPointIndex* index_;
  const BorderGate* gate_;
  double delta_;
};

/// The soup as a halfedge mesh; as it is where that works, so that ties are broken by its own order.
std::unique_ptr<SurfaceMesh> surface_of(const TriangleSoup& soup) {
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
    if (CGAL::is_closed(*mesh) || repaired) return mesh;
  }
  return nullptr;
}

Error no_manifold() {
  return {ErrorCode::unsupported, "The input is no oriented 2-manifold.", ""};
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
  const std::unique_ptr<SurfaceMesh> mesh = surface_of(input);
  if (!mesh) return no_manifold();
  const sms::Count_stop_predicate<SurfaceMesh> never(0);
  if (filter == CollapseFilter::certificate) {
    const ClosestPointIndex index(input);
    const BorderGate gate(border_of(*mesh), delta);
    sms::edge_collapse(*mesh, never, CGAL::parameters::filter(CertificateFilter(index, gate, delta)));
  } else {
    sms::edge_collapse(*mesh, never,
                       CGAL::parameters::filter(sms::Polyhedral_envelope_filter<Kernel>(delta)));
  }
  return Simplified{plain(*mesh), pmp::does_self_intersect(*mesh)};
}

Result<Simplified> lindstrom_turk_to(const TriangleSoup& input, std::size_t vertices) {
  const std::unique_ptr<SurfaceMesh> mesh = surface_of(input);
  if (!mesh) return no_manifold();
  // Each collapse takes a vertex and three edges of a closed surface; the predicate stops below its number.
  const std::size_t used = mesh->number_of_vertices(), edges = mesh->number_of_edges();
  const std::size_t gone = used > vertices ? 3 * (used - vertices) : 0;
  const sms::Count_stop_predicate<SurfaceMesh> enough(edges >= gone ? edges + 1 - gone : 0);
  sms::edge_collapse(*mesh, enough);
  return Simplified{plain(*mesh), pmp::does_self_intersect(*mesh)};
}

} // namespace isoscope::bench
