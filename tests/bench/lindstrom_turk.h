// The tool to beat: CGAL's Lindstrom–Turk edge collapse, as it is or kept within δ of its input by a filter.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"

#include <cstddef>

namespace isoscope::bench {

/// What a collapse must pass besides the link condition. Neither filter prevents self-intersections.
enum class CollapseFilter {
  certificate, ///< each new triangle is proven within δ of the input (certify_facet)
  envelope     ///< CGAL's Polyhedral_envelope with half-width δ: conservative, slow
};

/// What the collapse leaves.
struct Simplified {
  TriangleMesh mesh;
  bool intersects_itself = false; ///< exact
};

/// Collapses edges of the input until the filter lets none pass. `delta` is absolute. Fails with unsupported
/// where the soup is no oriented 2-manifold, with or without border, after merging equal points.
Result<Simplified> lindstrom_turk(const TriangleSoup& input, double delta, CollapseFilter filter);
/// The same without a filter, down to a number of vertices, which a closed surface is left with exactly: no
/// error is bounded.
Result<Simplified> lindstrom_turk_to(const TriangleSoup& input, std::size_t vertices);

} // namespace isoscope::bench
