// The proof of a mesh with a border: its border and the open rim are near to each other both ways, and the
// sides beside open surfaces are separated (§4.1).
#pragma once

#include "criteria/topology.h"
#include "input/triangle_soup.h"
#include "journal/journal.h"
#include "mesh/zero_set.h"
#include "tolerance/tolerance_volume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isoscope {

/// Facets of a mesh that close holes of an open surface: outside of Ω by intent.
struct FilledHoles {
  std::vector<std::uint8_t> facets; ///< by facet of the mesh: 1 where it fills; empty: none do
  bool fills(std::size_t facet) const { return facet < facets.size() && facets[facet] != 0; }
};

/// Those of a state that the filling of holes led to, by polygon of its Z; no others.
FilledHoles filled_holes(const Journal& journal, Step step, const Complex& complex, const ZeroSet& zero_set);
/// What is expected with holes filled: each of them is a loop less and a disc more.
ExpectedTopology with_filled_holes(ExpectedTopology expected, const FilledHoles& holes,
                                   const TriangleMesh& mesh);

/// Edges with one facet, in the direction of that.
std::vector<std::array<std::uint32_t, 2>> border_edges(const TriangleMesh& mesh);
/// How many closed curves they form.
std::size_t count_loops(std::span<const std::array<std::uint32_t, 2>> border, std::size_t vertices);

/// What was proven of a border.
struct BorderProof {
  double to_rim = 0; ///< upper bound of the distance from the border to the open rim; of the worst place else
  double from_rim = 0; ///< the same from the open rim, without the loops that were filled, to the border
  std::vector<std::string> failures; ///< one sentence each
  bool holds() const { return failures.empty(); }
};
/// Nothing when it was stopped.
std::optional<BorderProof> prove_border(const TriangleMesh& mesh, const ToleranceVolume& volume,
                                        const FilledHoles& holes, const std::function<bool()>& stop);

/// Whether segments from one side of open surfaces to the other cross the mesh an odd number of times, away
/// from the rim. The failure is a sentence, empty where all do; nothing when it was stopped.
std::optional<std::string> unseparated_sheet(const TriangleMesh& mesh, const ToleranceVolume& volume,
                                             const std::function<bool()>& stop);

/// The components of a mesh without border and without facets that fill.
TriangleMesh closed_parts(const TriangleMesh& mesh, const FilledHoles& holes);

} // namespace isoscope
