// Where T crosses the offset of the outside that Z should follow (condition 4, where parts are joined).
#pragma once

#include "base/ids.h"
#include "criteria/outer_offset.h"
#include "refine/misclassified_points.h"

#include <array>
#include <optional>
#include <vector>

namespace isoscope {

/// On every edge and facet of T whose vertices have one label: the point that is farthest on the other side
/// of the offset. Remembers what they told, as T keeps most of them from one call to the next.
class OffsetSearch {
 public:
  struct Limits {
    double level = 0;         ///< points are at least so far beyond
    double smallest_part = 0; ///< parts below it in radius are judged by their middles
    double reach = 0;         ///< of the offset
    friend bool operator==(const Limits&, const Limits&) = default;
  };
  /// Farthest first; their heights are these distances. Some only once the control is cancelled.
  std::vector<MisclassifiedPoint> find(const LiveTriangulation& live, const OuterOffset& offset,
                                       const Limits& limits, const RunControl& control);

 private:
  struct Farthest {
    Vec3 point;
    double beyond = 0;
  };
  /// An edge has its second end twice.
  struct Part {
    std::array<VertexId, 3> vertices;
    std::optional<Farthest> farthest;
  };
  Limits limits_;
  std::vector<Part> known_; ///< by their vertices, ascending
};

} // namespace isoscope
