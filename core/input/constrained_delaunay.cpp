// CGAL's triangulation; what is inside follows from the winding of the polygon around each triangle.
#include "input/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>

namespace isoscope {

namespace {

/// Between two looks at the control.
constexpr std::size_t poll_interval = 16;

struct FaceInfo {
  /// How much more often the polygon winds around the neighbour behind each edge than around this face.
  std::array<int, 3> step{};
  int winding = 0;
  bool reached = false;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

class PolygonTriangulation {
 public:
  PolygonTriangulation(std::span<const Vec3> points, std::span<const std::uint32_t> corners, Vec3 area,
                       const RunControl& control)
      : points_(points), corners_(corners), control_(control), flat_(corners.size()), at_(corners.size()) {
    int across = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(area[i]) > std::abs(area[across])) across = i;
    int u = (across + 1) % 3, v = (across + 2) % 3;
    if (area[across] < 0) std::swap(u, v); // so that the polygon runs counter-clockwise
    for (std::size_t i = 0; i < corners.size(); ++i)
      flat_[i] = {points[corners[i]][u], points[corners[i]][v]};
  }

  /// False when it cannot be done or the control says to end.
  bool build() {
    if (!insert_corners() || !insert_edges() || cdt_.dimension() != 2) return false;
    count_steps();
    wind();
    return true;
  }

  void append_inner(std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    for (const Face face : cdt_.finite_face_handles()) {
      const int winding = face->info().winding;
      if (winding == 0) continue;
      std::array<std::uint32_t, 3> t{};
      for (int k = 0; k < 3; ++k) t[static_cast<std::size_t>(k)] = face->vertex(k)->info();
      if (winding < 0) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
  }

 private:
  bool stop_at(std::size_t i) const { return i % poll_interval == 0 && control_.cancelled(); }

  /// In an order in which neighbours follow one another, so that each is found from the one before.
  bool insert_corners() {
    std::vector<std::size_t> order(corners_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto place = CGAL::make_property_map(flat_);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(place)>(place));
    Face near;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (stop_at(i)) return false;
      const std::size_t corner = order[i];
      const std::size_t before = cdt_.number_of_vertices();
      const Vertex vertex = cdt_.insert(flat_[corner], near);
      near = vertex->face();
      if (cdt_.number_of_vertices() > before) vertex->info() = corners_[corner];
      // One above the other: no triangulation of the plane can hold both.
      if (points_[vertex->info()] != points_[corners_[corner]]) return false;
      at_[corner] = vertex;
    }
    return true;
  }

  bool insert_edges() {
    try {
      for (std::size_t i = 0; i < at_.size(); ++i) {
        if (stop_at(i)) return false;
        if (at_[i] != after(i)) cdt_.insert_constraint(at_[i], after(i));
      }
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  Vertex after(std::size_t i) const { return at_[(i + 1) % at_.size()]; }

  /// Walks along the polygon: the winding on the left of each of its edges is one more than on the right.
  void count_steps() {
    for (std::size_t i = 0; i < at_.size(); ++i) {
      for (Vertex from = at_[i], to = after(i); from != to;) {
        Vertex reached;
        Face face;
        int edge = 0;
        cdt_.includes_edge(from, to, reached, face, edge);
        const Face other = face->neighbor(edge);
        const bool left = face->vertex(Triangulation::ccw(edge)) == from;
        face->info().step[static_cast<std::size_t>(edge)] += left ? -1 : 1;
        other->info().step[static_cast<std::size_t>(other->index(face))] += left ? 1 : -1;
        from = reached;
      }
    }
  }

  /// From the outside, around which nothing winds, to all faces.
  void wind() {
    std::vector<Face> open{cdt_.infinite_face()};
    open.back()->info().reached = true;
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (int edge = 0; edge < 3; ++edge) {
        FaceInfo& next = face->neighbor(edge)->info();
        if (next.reached) continue;
        next.reached = true;
        next.winding = face->info().winding + face->info().step[static_cast<std::size_t>(edge)];
        open.push_back(face->neighbor(edge));
      }
    }
  }

  std::span<const Vec3> points_;
  std::span<const std::uint32_t> corners_;
  const RunControl& control_;
  std::vector<Kernel::Point_2> flat_;
  std::vector<Vertex> at_; ///< of each corner
  Triangulation cdt_;
};

} // namespace

bool triangulate_delaunay(std::span<const Vec3> points, std::span<const std::uint32_t> corners, Vec3 area,
                          const RunControl& control, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (area == Vec3{}) return false;
  PolygonTriangulation polygon(points, corners, area, control);
  if (!polygon.build()) return false;
  polygon.append_inner(triangles);
  return true;
}

} // namespace isoscope
