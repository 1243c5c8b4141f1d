// In the order of the enumeration.
#include "scene/octree_fates.h"

#include "scene/meanings.h"

#include <array>

namespace isoscope {

const FateStyle& fate_style(OctreeCell::Fate fate) {
  static constexpr std::array<FateStyle, fate_count> styles{
      {{0x7F8896, "split", "Its eight parts were looked at; not drawn itself."},
       {0x8E97A6, "outside the kernel", "Pruned: no point of it sees the whole one-ring."},
       {meaning_color::invalid, "inside Ψ", "Pruned: every point of it is known to fail. Figures 9 and 12"},
       {0xE69F00, "costlier", "Pruned: no point of it has less error than a target already found."},
       {0x56B4E9, "last level", "Too deep to be split; its centre was the last candidate there."}}};
  return styles.at(static_cast<std::size_t>(fate));
}

} // namespace isoscope
