// χ, components and boundary loops of Z, followed from delta to delta in time proportional to what an
// operation changes.
#pragma once

#include "mesh/complex.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace isoscope {

/// χ is kept by counting the polygons at each corner and edge of Z. Components are counted anew only where
/// what an operation took away or put there is not one connected piece; otherwise they stay what they were.
/// Loops of a border are counted anew with them, and where its edges become more or fewer.
class ZeroTopology {
 public:
  /// Counts Z of the whole state.
  void count(const Complex& complex);
  /// Between before() and after() the delta is applied to the complex.
  void before(const Complex& complex, const Delta& delta);
  void after(const Complex& complex, const Delta& delta);
  long euler_characteristic() const { return corners_ - edges_ + polygons_; }
  std::size_t components() const { return components_; }
  std::size_t boundary_loops() const { return loops_; }
  /// How often components had to be counted anew.
  std::size_t recounts() const { return recounts_; }

 private:
  /// A corner of Z by the vertices of T around it, ascending: those of an edge, or of a facet or tetrahedron
  /// of three labels or more, or the vertex itself twice.
  struct Corner {
    std::uint64_t ends = 0, others = 0;
    friend auto operator<=>(const Corner&, const Corner&) = default;
  };
  /// A polygon of Z by its corners; the fourth is empty where there are three.
  struct Polygon {
    std::array<Corner, 4> corner{};
    std::size_t count = 0;
    friend auto operator<=>(const Polygon&, const Polygon&) = default;
  };
  struct EdgeKey {
    Corner a, b;
    friend bool operator==(const EdgeKey&, const EdgeKey&) = default;
  };
  struct Hash {
    std::size_t operator()(const Corner& c) const {
      return static_cast<std::size_t>(c.ends * 0x9e3779b97f4a7c15u ^ c.others * 0xd6e8feb86659fd93u);
    }
    std::size_t operator()(const EdgeKey& e) const {
      return (*this)(e.a) ^ ((*this)(e.b) + 0x7f4a7c15u) * 0xc2b2ae3d27d4eb4fu;
    }
  };
  static Corner corner_of(std::array<VertexId, 4> around, std::size_t count);
  /// Appends the polygons of a tetrahedron of three labels or more.
  static void add_junction(const Complex& complex, TetId t, std::vector<Polygon>& out);
  static std::vector<Polygon> patch(const Complex& complex, const std::vector<TetRecord>& tets,
                                    const std::vector<FacetRecord>& facets);
  static std::size_t pieces(const std::vector<Polygon>& polygons);
  void change(const std::vector<Polygon>& polygons, int by);
  void count_components(const Complex& complex);

  std::unordered_map<Corner, std::uint32_t, Hash> at_corner_; ///< looked up only, never iterated
  std::unordered_map<EdgeKey, std::uint32_t, Hash> at_edge_;
  long corners_ = 0, edges_ = 0, polygons_ = 0;
  long border_edges_ = 0, border_edges_before_ = 0; ///< with one polygon
  std::size_t loops_ = 0;
  std::size_t components_ = 0, recounts_ = 0;
  std::size_t pieces_before_ = 0;
};

} // namespace isoscope
