// CGAL's Delaunay triangulation with the slots of a Complex in its cells.
#include "mesh/delaunay.h"

#include "mesh/predicates.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cassert>

namespace isoscope {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexId, Kernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<TetId, Kernel,
                                                           CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
using Cell = Triangulation::Cell_handle;
using VertexHandle = Triangulation::Vertex_handle;

Point point(Vec3 v) {
  return {v.x, v.y, v.z};
}
Vec3 vec(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

/// Vertex ids of a cell in the order of Tet.
std::array<VertexId, 4> canonical_vertices(Cell c) {
  return canonical_order(
      {c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
}

/// Ascending vertex ids: the order in which added tetrahedra get their slots.
std::array<VertexId, 4> ascending(std::array<VertexId, 4> v) {
  if (v[3] < v[2]) std::swap(v[2], v[3]);
  return v;
}

} // namespace

struct Delaunay::Impl {
  Triangulation triangulation;
  std::vector<Cell> cell_of; ///< by slot; null when dead
  std::vector<std::uint32_t> free_slots;
  std::uint32_t vertices = 0;

  std::vector<std::pair<TetRecord, Cell>> fresh;
  std::vector<Cell> cells;
  std::vector<Triangulation::Facet> boundary;

  bool finite(Cell c) const { return !triangulation.is_infinite(c); }

  Cell cell(TetId t) const { return t.valid() && t.index() < cell_of.size() ? cell_of[t.index()] : Cell(); }

  /// Gives the fresh cells their slots and appends them to the delta.
  void hand_out_slots(Delta& delta) {
    std::sort(fresh.begin(), fresh.end(),
              [](const auto& a, const auto& b) { return ascending(a.first.v) < ascending(b.first.v); });
    delta.added.reserve(fresh.size());
    for (auto& [record, c] : fresh) {
      if (free_slots.empty()) {
        free_slots.push_back(static_cast<std::uint32_t>(cell_of.size()));
        cell_of.emplace_back();
      }
      record.id = TetId(free_slots.back());
      free_slots.pop_back();
      cell_of[record.id.index()] = c;
      c->info() = record.id;
      delta.added.push_back(record);
    }
    fresh.clear();
  }

  /// The finite cell of smallest slot among those that hold the located point on their boundary.
  Cell canonical_cell(Cell c, Triangulation::Locate_type type, int i, int j) const {
    Cell best = finite(c) ? c : Cell();
    const auto offer = [&](Cell d) {
      if (finite(d) && (best == Cell() || d->info() < best->info())) best = d;
    };
    if (type == Triangulation::FACET) {
      offer(c->neighbor(i));
    } else if (type == Triangulation::EDGE) {
      auto around = triangulation.incident_cells(c, i, j);
      const auto first = around;
      do {
        offer(around);
      } while (++around != first);
    } else if (type == Triangulation::VERTEX) {
      std::vector<Cell> star;
      triangulation.finite_incident_cells(c->vertex(i), std::back_inserter(star));
      for (const Cell d : star) offer(d);
    }
    return best;
  }
};

Delaunay::Delaunay() : impl_(std::make_unique<Impl>()) {}
Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

Delta Delaunay::start(std::span<const Vertex> corners) {
  impl_ = std::make_unique<Impl>();
  Impl& m = *impl_;
  Delta delta;
  delta.added_vertices.assign(corners.begin(), corners.end());
  for (const Vertex& corner : corners) {
    const VertexHandle v = m.triangulation.insert(point(corner.position));
    v->info() = VertexId(m.vertices++);
  }
  if (m.triangulation.dimension() < 3) return delta;
  for (const Cell c : m.triangulation.finite_cell_handles())
    m.fresh.push_back({{{}, canonical_vertices(c)}, c});
  m.hand_out_slots(delta);
  return delta;
}

std::optional<Delta> Delaunay::insert(const Vertex& vertex, TetId hint) {
  Impl& m = *impl_;
  if (m.triangulation.dimension() < 3 || !is_finite(vertex.position)) return std::nullopt;
  const Point p = point(vertex.position);
  Triangulation::Locate_type type{};
  int i = 0, j = 0;
  const Cell located = m.triangulation.locate(p, type, i, j, m.cell(hint));
  if (type == Triangulation::VERTEX || type == Triangulation::OUTSIDE_CONVEX_HULL) return std::nullopt;

  m.cells.clear();
  m.boundary.clear();
  m.triangulation.find_conflicts(p, located, std::back_inserter(m.boundary), std::back_inserter(m.cells));

  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(m.cell_of.size());
  delta.added_vertices.push_back(vertex);
  delta.removed.reserve(m.cells.size());
  for (const Cell c : m.cells) {
    if (m.finite(c)) delta.removed.push_back({c->info(), canonical_vertices(c)});
  }
  std::sort(delta.removed.begin(), delta.removed.end(),
            [](const TetRecord& a, const TetRecord& b) { return a.id < b.id; });
  for (const TetRecord& r : delta.removed) {
    m.cell_of[r.id.index()] = Cell();
    m.free_slots.push_back(r.id.value);
  }

  const auto& [facet_cell, facet_index] = m.boundary.front();
  const VertexHandle v =
      m.triangulation.insert_in_hole(p, m.cells.begin(), m.cells.end(), facet_cell, facet_index);
  v->info() = VertexId(m.vertices++);

  m.cells.clear();
  m.triangulation.finite_incident_cells(v, std::back_inserter(m.cells));
  for (const Cell c : m.cells) m.fresh.push_back({{{}, canonical_vertices(c)}, c});
  m.hand_out_slots(delta);
  return delta;
}

bool Delaunay::strictly_inside_circumsphere(TetId t, Vec3 p) const {
  const Cell c = impl_->cell(t);
  assert(c != Cell());
  return side_of_sphere(vec(c->vertex(0)->point()), vec(c->vertex(1)->point()), vec(c->vertex(2)->point()),
                        vec(c->vertex(3)->point()), p) > 0;
}

Vec3 Delaunay::circumcenter(TetId t) const {
  const Cell c = impl_->cell(t);
  assert(c != Cell());
  std::array<VertexHandle, 4> v{c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)};
  std::sort(v.begin(), v.end(), [](VertexHandle a, VertexHandle b) { return a->info() < b->info(); });
  const Vec3 o = vec(v[0]->point());
  const Vec3 a = vec(v[1]->point()) - o, b = vec(v[2]->point()) - o, d = vec(v[3]->point()) - o;
  const Vec3 bd = cross(b, d), da = cross(d, a), ab = cross(a, b);
  const Vec3 sum = squared_length(a) * bd + squared_length(b) * da + squared_length(d) * ab;
  return o + sum / (2 * dot(a, bd));
}

TetId Delaunay::locate(Vec3 p, TetId hint) const {
  const Impl& m = *impl_;
  if (m.triangulation.dimension() < 3 || !is_finite(p)) return {};
  Triangulation::Locate_type type{};
  int i = 0, j = 0;
  const Cell c = m.triangulation.locate(point(p), type, i, j, m.cell(hint));
  if (type == Triangulation::OUTSIDE_CONVEX_HULL) return {};
  return m.canonical_cell(c, type, i, j)->info();
}

VertexId Delaunay::nearest_vertex(Vec3 p, TetId hint) const {
  const Impl& m = *impl_;
  if (m.triangulation.number_of_vertices() == 0 || !is_finite(p)) return {};
  const Point q = point(p);
  // Vertices at the same distance form one connected part of the Delaunay graph: visit it and take the
  // smallest id.
  std::vector<VertexHandle> nearest{m.triangulation.nearest_vertex(q, m.cell(hint))}, around;
  for (std::size_t k = 0; k < nearest.size() && m.triangulation.dimension() == 3; ++k) {
    around.clear();
    m.triangulation.finite_adjacent_vertices(nearest[k], std::back_inserter(around));
    for (const VertexHandle v : around) {
      if (CGAL::compare_distance_to_point(q, v->point(), nearest[0]->point()) == CGAL::EQUAL &&
          std::find(nearest.begin(), nearest.end(), v) == nearest.end()) {
        nearest.push_back(v);
      }
    }
  }
  VertexId best = nearest[0]->info();
  for (const VertexHandle v : nearest) best = std::min(best, v->info());
  return best;
}

std::array<TetId, 4> Delaunay::neighbours(TetId t) const {
  const Cell c = impl_->cell(t);
  assert(c != Cell());
  const std::array<VertexId, 4> order = canonical_vertices(c);
  std::array<TetId, 4> result;
  for (int i = 0; i < 4; ++i) {
    const auto at = std::find(order.begin(), order.end(), c->vertex(i)->info()) - order.begin();
    if (impl_->finite(c->neighbor(i))) result[static_cast<std::size_t>(at)] = c->neighbor(i)->info();
  }
  return result;
}

} // namespace isoscope
