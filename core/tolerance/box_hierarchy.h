// A hierarchy of boxes, four children a node: what closest triangles and closest weighted points are found
// by.
#pragma once

#include "base/geometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// The boxes of items in the order of its leaves. Slots count the items in that order.
struct BoxHierarchy {
  static constexpr unsigned width = 4;
  static constexpr std::uint8_t empty_child = 0xff;

  /// Boxes of four children in the frame (p - origin) * inverse_scale, rounded outward to float.
  struct alignas(64) Node {
    float lo[3][width];
    float hi[3][width];
    std::uint32_t child[width]; ///< inner: node; leaf: first slot
    std::uint8_t count[width];  ///< leaf: number of slots; 0 for an inner child, empty_child for none
  };

  std::vector<Node> nodes;        ///< nodes[0] is the root; children come behind their parents
  std::vector<std::uint32_t> ids; ///< slot -> item
  Box3 bounds;                    ///< of all items
  Vec3 origin;
  double inverse_scale = 1;

  std::size_t memory_bytes() const {
    return nodes.capacity() * sizeof(Node) + ids.capacity() * sizeof(std::uint32_t);
  }
};

} // namespace isoscope
