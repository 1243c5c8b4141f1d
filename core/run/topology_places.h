// Where to look when a mesh has another topology than it should have.
#pragma once

#include "base/run_control.h"
#include "input/triangle_soup.h"
#include "run/room_certificate.h"

#include <span>
#include <string>

namespace isoscope {

/// One or two sentences with the places of the narrowest handles, one a component and three at most, and of
/// the smallest component where there are several; empty on a single sphere. For closed oriented 2-manifolds.
std::string topology_places(const TriangleMesh& mesh, const RunControl& control);
/// The same of rooms: handles of the boundaries that are closed manifolds, the narrowest first.
std::string topology_places(const TriangleMesh& mesh, std::span<const RegionCertificate> regions,
                            const RunControl& control);

} // namespace isoscope
