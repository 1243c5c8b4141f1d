// The proof of a mesh between several rooms: that of each region's boundary (§4.2).
#pragma once

#include "input/triangle_soup.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// The boundary of the regions of one label.
struct RegionCertificate {
  int label = +1;
  std::size_t vertices = 0, facets = 0, components = 0;
  long euler_characteristic = 0;
  bool closed_manifold = false; ///< every edge has two facets, every vertex one fan a component
  bool oriented = false;        ///< every facet has the region on the side that its labels say
  double volume = 0;            ///< signed: what an inside encloses, less what the outside does
  std::string failure;          ///< which of the two fails and where; else empty
};

/// By label, the outside first. Where each boundary is a closed manifold, sheets of the mesh end where others
/// do: edges have two facets or as many as regions meet there.
std::vector<RegionCertificate> certify_regions(const TriangleMesh& mesh);

/// How often the boundary of each region winds around p, in their order; 1 inside of it.
std::vector<double> winding_numbers(const TriangleMesh& mesh, const std::vector<RegionCertificate>& regions,
                                    Vec3 p);

} // namespace isoscope
