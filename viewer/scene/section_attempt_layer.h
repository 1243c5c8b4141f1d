// Puts the edge at hand into the batches of the 2D section.
#pragma once

#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/section_attempt.h"
#include "scene/view_frame.h"

#include <vector>

namespace isoscope {

void add_attempt(const AttemptSection& section, const SectionPlane& plane, const ViewFrame& frame,
                 MeshBuilder& faces, LineBuilder& lines, std::vector<Marker>& marks);

} // namespace isoscope
