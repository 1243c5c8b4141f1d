// The strata of a surface between rooms: sheets, the curves where they meet, the points where curves do
// (§4.2, core/README.md, N8).
#pragma once

#include "base/geometry.h"
#include "mesh/strata.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

struct FacetComplex;
struct SurfacePatch;

/// Where a vertex of a surface between rooms lies.
struct VertexStratum {
  Stratum stratum = Stratum::sheet;
  bool rigid = false; ///< sheets end or touch there: it stays where it is, and no flip takes facets from it
  std::vector<std::uint32_t> curves; ///< the other ends of its edges on curves, ascending

  bool on_curve() const { return stratum < Stratum::sheet; }
  bool leads_to(std::uint32_t vertex) const;
  friend bool operator==(const VertexStratum&, const VertexStratum&) = default;
};

/// The strata of all vertices, from facets with their labels and stars.
std::vector<VertexStratum> find_strata(const FacetComplex& complex);
/// Those of some vertices (ascending) by their places among them; curves lead to these alone.
std::vector<VertexStratum> take_strata(const FacetComplex& surface, std::span<const std::uint32_t> vertices);
/// Finds the strata of some vertices anew, whose stars must be complete.
void renew_strata(FacetComplex& complex, std::span<const std::uint32_t> vertices);

/// Whether a collapse leaves the boundary of each region the surface that it is, which is the link condition
/// of surfaces for each that has both ends, and no two facets become one. Sheets and curves may vanish, and
/// points merge, where they are smaller than Ω tells: the input may have four rooms along an edge, as Z has
/// not until then. The stars of a and b must be complete.
bool strata_link_condition(const FacetComplex& complex, std::uint32_t a, std::uint32_t b);
/// After b was merged into a, whose star must be complete: the strata of both, and their neighbours' curves.
void merge_strata(FacetComplex& complex, std::uint32_t a, std::uint32_t b);
/// The end of the edge ab at which their merged vertex has to lie; nothing where it may move.
std::optional<std::uint32_t> pinned_end(const FacetComplex& complex, std::uint32_t a, std::uint32_t b);

/// The first witness that comes to lie in another region with a change of a patch's facets, each region being
/// enclosed by the facets with its label.
std::optional<Vec3> swept_witness_between_rooms(std::span<const Vec3> witnesses, const SurfacePatch& patch);

} // namespace isoscope
