// How many pieces of a facet the proofs of a result look at, and how many facets at once.
#pragma once

#include <cstddef>

namespace isoscope {

/// So many that a proof does not fail for lack of them.
constexpr std::size_t proof_budget = 200000;

/// Verdicts take as much as triangles: where many facets are judged so many of them are in memory.
constexpr std::size_t verdicts_at_once = 1 << 16;

} // namespace isoscope
