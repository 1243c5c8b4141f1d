// Corners of facets are joined across edges: what is joined at a vertex is a fan.
#include "run/room_certificate.h"

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "base/solid_angle.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <set>

namespace isoscope {
namespace {

using Facet = std::array<std::uint32_t, 3>;

/// The facets around the regions of a label, counter-clockwise seen from beyond them.
std::vector<Facet> boundary_of(const TriangleMesh& mesh, int label) {
  std::vector<Facet> facets;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    if (mesh.labels[i].back == label) facets.push_back({a, b, c});
    if (mesh.labels[i].front == label) facets.push_back({a, c, b});
  }
  return facets;
}

/// An edge of a facet: its ends ascending, whether the facet runs up, and the number of the corner at its
/// beginning.
struct FacetEdge {
  std::uint32_t low, high;
  bool up;
  std::uint32_t corner;
  friend auto operator<=>(const FacetEdge&, const FacetEdge&) = default;
};

std::vector<FacetEdge> edge_uses(const std::vector<Facet>& facets) {
  std::vector<FacetEdge> uses;
  uses.reserve(3 * facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = facets[f][k], b = facets[f][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), a < b, 3 * f + k});
    }
  std::sort(uses.begin(), uses.end());
  return uses;
}

constexpr std::uint32_t next_corner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

RegionCertificate certify_region(const TriangleMesh& mesh, int label) {
  const std::vector<Facet> facets = boundary_of(mesh, label);
  const std::vector<FacetEdge> uses = edge_uses(facets);
  RegionCertificate region;
  region.label = label;
  region.facets = facets.size();
  region.closed_manifold = region.oriented = true;
  const auto fail = [&](const char* what, std::uint32_t vertex) {
    if (region.failure.empty())
      region.failure = std::string(what) + " at " + place(mesh.points[vertex], proof_digits);
  };
  DisjointSets fans(3 * facets.size()), pieces(facets.size());
  std::size_t edges = 0;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end, ++edges) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    for (std::size_t k = i + 1; k < end; ++k) pieces.unite(uses[i].corner / 3, uses[k].corner / 3);
    if (end - i != 2) {
      region.closed_manifold = region.oriented = false;
      fail("has an edge without exactly two facets", uses[i].low);
      continue;
    }
    const FacetEdge &a = uses[i], &b = uses[i + 1];
    if (a.up == b.up) {
      region.oriented = false;
      fail("has an edge along which two facets run the same way", a.low);
    }
    const bool opposite = a.up != b.up;
    fans.unite(a.corner, opposite ? next_corner(b.corner) : b.corner);
    fans.unite(next_corner(a.corner), opposite ? b.corner : next_corner(b.corner));
  }
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (std::uint32_t c = 0; c < 3 * facets.size(); ++c) {
    const std::uint32_t v = facets[c / 3][c % 3];
    if (fans.find(c) != c) continue;
    if (used[v] != 0) {
      region.closed_manifold = false;
      fail("has a vertex with several fans", v);
    }
    if (used[v] == 0) ++region.vertices;
    used[v] = 1;
  }
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    region.components += pieces.find(f) == f ? 1 : 0;
    const auto [a, b, c] = facets[f];
    region.volume += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6;
  }
  region.euler_characteristic =
      static_cast<long>(region.vertices) - static_cast<long>(edges) + static_cast<long>(region.facets);
  return region;
}

} // namespace

std::vector<RegionCertificate> certify_regions(const TriangleMesh& mesh) {
  std::set<int, std::greater<>> labels;
  for (const LabelPair pair : mesh.labels) labels.insert({pair.front, pair.back});
  std::vector<RegionCertificate> regions;
  for (const int label : labels) regions.push_back(certify_region(mesh, label));
  return regions;
}

std::vector<double> winding_numbers(const TriangleMesh& mesh, const std::vector<RegionCertificate>& regions,
                                    Vec3 p) {
  std::vector<SolidAngleSum> sums(regions.size());
  const auto of = [&](int label) -> SolidAngleSum& {
    const auto at = std::find_if(regions.begin(), regions.end(),
                                 [label](const RegionCertificate& r) { return r.label == label; });
    return sums[static_cast<std::size_t>(at - regions.begin())];
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Triangle3 corners{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    of(mesh.labels[i].back).add(p, corners);
    of(mesh.labels[i].front).add(p, corners, -1);
  }
  std::vector<double> numbers;
  for (const SolidAngleSum& sum : sums) numbers.push_back(sum.winding());
  return numbers;
}

} // namespace isoscope
