// How many pieces of a facet the proofs of a result look at.
#pragma once

#include <cstddef>

namespace isoscope {

/// So many that a proof does not fail for lack of them.
constexpr std::size_t proof_budget = 200000;

} // namespace isoscope
