// Crumbs in the input and in Z: what is told about parts that are small against δ.
#pragma once

#include "base/status.h"
#include "input/small_components.h"

#include <cstddef>
#include <memory>
#include <string>

namespace isoscope {

/// Parts of Z whose box is smaller than so many δ are called crumbs.
constexpr double crumb_size = 4;

/// The input that a run works on, and a sentence on what was left out; empty when nothing was.
struct InputWithoutCrumbs {
  std::shared_ptr<const TriangleSoup> soup;
  std::string note;
};

/// Leaves out the components of the input smaller than `limit` δ; 0: none. Fails with bad_input when nothing
/// is left. Meaningless once the control is cancelled.
Result<InputWithoutCrumbs> without_crumbs(std::shared_ptr<const TriangleSoup> soup, double limit,
                                          double delta, const RunControl& control);

/// How many of the vertices of Z went to crumbs and what helps; empty when there are none, or nothing else.
std::string crumbs_note(const SmallParts& crumbs, std::size_t vertices);

} // namespace isoscope
