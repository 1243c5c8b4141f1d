// Facets of a closed input that are in it several times.
#pragma once

#include "base/run_control.h"
#include "input/triangle_soup.h"

#include <memory>

namespace isoscope {

/// The soup without triangles that say again what another one says, so that they change nothing; itself where
/// there are none. Of a soup that is open nothing is left out.
std::shared_ptr<const TriangleSoup> without_needless_copies(std::shared_ptr<const TriangleSoup> soup,
                                                            const RunControl& control);

} // namespace isoscope
