// The table of styles.
#include "scene/reason_style.h"

#include <array>

namespace isoscope {
namespace {

constexpr ReasonStyle taken{0x009E73, MarkerShape::disc, "taken", "The target of the collapse."};
constexpr std::array<std::string_view, 21> found{"",
                                                 "largest error",
                                                 "sample near the circumcentre",
                                                 "projected",
                                                 "towards the circumcentre",
                                                 "towards the other side",
                                                 "violating point",
                                                 "witness of a region",
                                                 "crossing element",
                                                 "no sample inside",
                                                 "vertex already",
                                                 "too close",
                                                 "limit of work",
                                                 "asked for",
                                                 "halfedge",
                                                 "sample of S",
                                                 "least error",
                                                 "learnt half-spaces",
                                                 "sampled kernel",
                                                 "octree",
                                                 "minimax"};

// In the order of the enumeration, from Reason::link_condition on.
constexpr std::array<ReasonStyle, 12> rejections{{
    {0xC23FB4, MarkerShape::square, "link in T",
     "Lk(a) ∩ Lk(b) ≠ Lk(ab) in T: the collapse would pinch T. §2.4, Figure 6"},
    {0xE39AD8, MarkerShape::hollow_square, "link in Z",
     "Lk(a) ∩ Lk(b) ≠ Lk(ab) in Z: the collapse would change the topology of Z. §2.4"},
    {0x8C6BD8, MarkerShape::triangle, "kernel empty", "No point sees the whole one-ring. §2.4, Figure 7"},
    {0x8F98A8, MarkerShape::circle, "outside the kernel",
     "No candidate lies where the whole one-ring is seen. §2.4"},
    {0xD55E00, MarkerShape::cross, "misclassified", "A sample of S would change its class. §2.4.1"},
    {0xE69F00, MarkerShape::diamond, "outside Ω", "A facet of Z would have a point with d > δ."},
    {0xB3A24A, MarkerShape::hollow_diamond, "unproven",
     "A facet of Z could be proven neither inside nor outside of Ω."},
    {0x56B4E9, MarkerShape::hollow_triangle, "normals",
     "Condition 3 would be violated where it was not before. §2.4"},
    {0x3D8FD1, MarkerShape::plus, "witness side", "The deepest point of a region would change side."},
    {0xCC4A3A, MarkerShape::cross, "self-intersection", "Z would intersect itself."},
    {0x44AA99, MarkerShape::hollow_triangle, "folded", "A facet of Z would turn over."},
    {0xB97850, MarkerShape::square, "stays above δ", "The repair did not bring every facet below δ."},
}};

constexpr auto quiet = [] {
  std::array<ReasonStyle, found.size()> styles{};
  for (std::size_t i = 0; i < found.size(); ++i)
    styles[i] = {0x009E73, MarkerShape::disc, found[i], "How the target was found."};
  styles[0] = taken;
  return styles;
}();
static_assert(found.size() == static_cast<std::size_t>(first_rejection));
static_assert(found.size() + rejections.size() == static_cast<std::size_t>(reason_count));

} // namespace

const ReasonStyle& reason_style(Reason reason) {
  const auto i = static_cast<std::size_t>(reason);
  return i < found.size() ? quiet.at(i) : rejections.at(i - found.size());
}

const FateStyle& fate_style(OctreeCell::Fate fate) {
  static constexpr std::array<FateStyle, fate_count> styles{
      {{0x7F8896, "split", "Its eight parts were looked at; not drawn itself."},
       {0x8E97A6, "outside the kernel", "Pruned: no point of it sees the whole one-ring."},
       {invalid_color, "inside Ψ", "Pruned: every point of it is known to fail. Figures 9 and 12"},
       {0xE69F00, "costlier", "Pruned: no point of it has less error than a target already found."},
       {0x56B4E9, "last level", "Too deep to be split; its centre was the last candidate there."}}};
  return styles.at(static_cast<std::size_t>(fate));
}

} // namespace isoscope
