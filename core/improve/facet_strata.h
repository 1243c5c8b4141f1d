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
  /// In lists of a patch: added to the surface's id of a vertex that is not in the patch.
  static constexpr std::uint32_t elsewhere = 0x80000000u;

  Stratum stratum = Stratum::sheet;
  bool rigid = false; ///< sheets end or touch there: it stays where it is, and no flip takes facets from it
  std::vector<std::uint32_t> curves; ///< the other ends of its edges on curves, ascending

  bool on_curve() const { return stratum < Stratum::sheet; }
  bool leads_to(std::uint32_t vertex) const;
  friend bool operator==(const VertexStratum&, const VertexStratum&) = default;
};

/// The strata of all vertices, from facets with their labels and stars.
std::vector<VertexStratum> find_strata(const FacetComplex& complex);
/// Those of some vertices (ascending) by their places among them.
std::vector<VertexStratum> take_strata(const FacetComplex& surface, std::span<const std::uint32_t> vertices);
/// Carries what has changed in the strata of a patch to the surface.
void commit_strata(const SurfacePatch& patch, FacetComplex& surface);

/// The link conditions among facets, with a dummy vertex joined to the curves, and among the curves, with one
/// joined to the points. The stars of a and b must be complete.
bool strata_link_condition(const FacetComplex& complex, std::uint32_t a, std::uint32_t b);
/// b's place on curves becomes a's; for FacetComplex::collapse.
void merge_strata(std::vector<VertexStratum>& strata, std::uint32_t a, std::uint32_t b);
/// The end of the edge ab at which their merged vertex has to lie; nothing where it may move.
std::optional<std::uint32_t> pinned_end(const FacetComplex& complex, std::uint32_t a, std::uint32_t b);

/// The first witness that comes to lie in another region with a change of a patch's facets, each region being
/// enclosed by the facets with its label.
std::optional<Vec3> swept_witness_between_rooms(std::span<const Vec3> witnesses, const SurfacePatch& patch);

} // namespace isoscope
