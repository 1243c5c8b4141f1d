// Why events came out as they did: every reason with its name, its words and its mark, in one row.
//
// A row's texts may hold figures of the event in braces; journal/describe.cpp fills them in.
#pragma once

#include "journal/word_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isoscope {

/// Why an event came out as it did, beyond its condition.
enum class Reason : std::uint8_t {
  none,
  largest_error,       ///< condition 1: the worst sample of the queue's top tetrahedron
  circumcenter_sample, ///< conditions 2, 3, 4: the sample nearest to the circumcentre
  projected,           ///< containment (a): the violating point projected to d = δ'
  toward_circumcenter, ///< containment (b): first point with d = δ' on the way to the circumcentre
  toward_opposite,     ///< containment (c): traced to a vertex of opposite label
  violating_point,     ///< containment (d): the violating point itself, where all others are taken
  region_witness,      ///< the deepest point of a region
  crossing_simplex,    ///< topology: an edge or facet of one label that crosses the input
  no_sample_inside,    ///< exhausted: no sample strictly inside the circumscribed ball
  already_vertex,      ///< exhausted: the candidate is a vertex of T
  too_close,           ///< exhausted: the candidate is nearer to a vertex than the spacing bound
  budget,              ///< a limit of work was reached
  user,                ///< asked for by the user
  // How the target of a collapse was found (§2.4).
  halfedge,          ///< one of the edge's ends
  sample_candidate,  ///< a sample of S inside the kernel (Figure 8)
  quadric_optimum,   ///< the least error inside the kernel
  lazy_constraints,  ///< the least error under half-spaces learnt from facets that left Ω
  kernel_sampling,   ///< a point drawn inside the kernel
  octree_search,     ///< the octree over the kernel, pruned by Ψ (Figures 9 and 12)
  minimax_placement, ///< the least largest distance (core/README.md, N6)
  // Why an edge was not collapsed.
  link_condition,      ///< Lk(a) ∩ Lk(b) ≠ Lk(ab) in T
  zero_link_condition, ///< the same in Z
  kernel_empty,        ///< no point sees the whole one-ring
  no_candidate,        ///< no candidate point lies in the kernel
  misclassified,       ///< a sample would change class (sampled mode)
  outside_tolerance,   ///< a facet of Z would leave Ω
  unproven,            ///< a facet could be proven neither inside nor outside
  normals,             ///< a facet or tetrahedron would violate condition 3 that did not before
  witness_side,        ///< the deepest point of a region would change side
  intersection,        ///< Z would intersect itself (without T)
  folded,              ///< a facet would turn over (without T)
  stays_above,         ///< the repair did not bring every facet below δ
  ineligible,          ///< the edge is not of the kind that the stage collapses
  border_distance,     ///< the border of Z would leave the rim of the input, or lay it bare (§4.1)
  // Why an edge of Z was split along the rim (§4.1).
  wall_over_rim,  ///< the wall over the rim crosses it
  leaves_volume,  ///< a facet beside it is not proven inside Ω
  border_off_rim, ///< it is on the border of Z and not within δ of the rim
  rim_off_border, ///< a place of the rim is farther than δ from the border of Z
  pinched_border, ///< two parts of Z would meet in its end alone
  // Later ones.
  cut_off,   ///< topology: a place on the way over the largest φ that Z cuts, where sides are told by depth
  thin_part, ///< a point in a wall or a gap thinner than 2δ′, that keeps Z near to the input there
  pocket     ///< topology: vertices that a sphere of Z too many encloses, and that nothing asks for
};
constexpr int reason_count = static_cast<int>(Reason::pocket) + 1;

/// What a reason explains.
enum class ReasonRole : std::uint8_t { none, place, exhaustion, target, rejection };

struct ReasonWords {
  Reason value;
  std::string_view name, title;
  ReasonRole role;
  std::string_view
      sentence; ///< as its role asks: where a point goes in, why none is left, what a target is, why not
  std::string_view plain = {}; ///< of a rejection
  std::string_view help = "How the target was found.";
  std::uint32_t color = 0x009E73; ///< 0xRRGGBB, told apart on dark and light grounds
  MarkerShape shape = MarkerShape::disc;
  Measure measure = Measure::none;
  std::string_view why = {};    ///< of a rejection: why it has to be one, for an audience
  std::string_view figure = {}; ///< of the paper
};
inline constexpr std::array reason_table{
    ReasonWords{Reason::none, "none", "taken", ReasonRole::none, "", "", "The target of the collapse."},
    ReasonWords{Reason::largest_error, "largest-error", "largest error", ReasonRole::none, ""},
    ReasonWords{Reason::circumcenter_sample, "circumcenter-sample", "sample near the circumcentre",
                ReasonRole::place, "the sample nearest to the circumcentre goes in"},
    ReasonWords{Reason::projected, "projected", "projected", ReasonRole::place,
                "the violating point, projected to d = δ′, goes in"},
    ReasonWords{Reason::toward_circumcenter, "toward-circumcenter", "towards the circumcentre",
                ReasonRole::place, "the first point with d = δ′ towards the circumcentre goes in"},
    ReasonWords{Reason::toward_opposite, "toward-opposite", "towards the other side", ReasonRole::place,
                "a point traced from a vertex of the other side goes in"},
    ReasonWords{Reason::violating_point, "violating-point", "violating point", ReasonRole::place,
                "the violating point itself goes in, as every place at d = δ′ is taken"},
    ReasonWords{Reason::region_witness, "region-witness", "witness of a region", ReasonRole::place,
                "the region's deepest point goes in"},
    ReasonWords{Reason::crossing_simplex, "crossing-simplex", "crossing element", ReasonRole::place,
                "a point where an element of one side crosses the input goes in"},
    ReasonWords{Reason::no_sample_inside, "no-sample-inside", "no sample inside", ReasonRole::exhaustion,
                "no sample lies strictly inside its circumscribed ball"},
    ReasonWords{Reason::already_vertex, "already-vertex", "vertex already", ReasonRole::exhaustion,
                "the candidate is a vertex already"},
    ReasonWords{Reason::too_close, "too-close", "too close", ReasonRole::exhaustion,
                "the candidate is too close to a vertex"},
    ReasonWords{.value = Reason::budget,
                .name = "budget",
                .title = "limit of work",
                .role = ReasonRole::exhaustion,
                .sentence = "a limit of work was reached",
                .why = "The search ends somewhere; nothing is said of what was not looked at."},
    ReasonWords{Reason::user, "user", "asked for", ReasonRole::none, ""},
    ReasonWords{Reason::halfedge, "halfedge", "halfedge", ReasonRole::target, "one of its ends"},
    ReasonWords{Reason::sample_candidate, "sample-candidate", "sample of S", ReasonRole::target,
                "a sample of S in its kernel"},
    ReasonWords{Reason::quadric_optimum, "quadric-optimum", "least error", ReasonRole::target,
                "the least error in its kernel"},
    ReasonWords{Reason::lazy_constraints, "lazy-constraints", "learnt half-spaces", ReasonRole::target,
                "the least error under learnt half-spaces"},
    ReasonWords{Reason::kernel_sampling, "kernel-sampling", "sampled kernel", ReasonRole::target,
                "a point drawn in its kernel"},
    ReasonWords{Reason::octree_search, "octree-search", "octree", ReasonRole::target,
                "a point of the octree over its kernel"},
    ReasonWords{Reason::minimax_placement, "minimax-placement", "minimax", ReasonRole::target,
                "the least largest distance"},
    ReasonWords{Reason::link_condition, "link-condition", "link in T", ReasonRole::rejection,
                "the link condition fails in T", "collapsing it would pinch the triangulation",
                "Lk(a) ∩ Lk(b) ≠ Lk(ab) in T: the collapse would pinch T. §2.4, Figure 6", 0xC23FB4,
                MarkerShape::square, Measure::none,
                "Parts that are apart would be pressed together, and the topology would change.", "Figure 6"},
    ReasonWords{Reason::zero_link_condition, "zero-link-condition", "link in Z", ReasonRole::rejection,
                "the link condition fails in Z", "collapsing it would pinch Z",
                "Lk(a) ∩ Lk(b) ≠ Lk(ab) in Z: the collapse would change the topology of Z. §2.4", 0xE39AD8,
                MarkerShape::hollow_square, Measure::none,
                "T may allow what Z forbids: as a surface it would be pinched.", "Figure 6"},
    ReasonWords{Reason::kernel_empty, "kernel-empty", "kernel empty", ReasonRole::rejection,
                "its kernel is empty: no point sees the whole one-ring",
                "no place sees its whole surroundings", "No point sees the whole one-ring. §2.4, Figure 7",
                0x8C6BD8, MarkerShape::triangle, Measure::depth,
                "Wherever the target was put, a tetrahedron would turn over. A neighbour may open the way.",
                "Figure 7"},
    ReasonWords{Reason::no_candidate, "no-candidate", "outside the kernel", ReasonRole::rejection,
                "no candidate point lies in its kernel", "no target was found that sees its surroundings",
                "No candidate lies where the whole one-ring is seen. §2.4", 0x8F98A8, MarkerShape::circle,
                Measure::none, "Where all tetrahedra stay upright, none of the points that were asked lies.",
                "Figure 7"},
    ReasonWords{Reason::misclassified, "misclassified", "misclassified", ReasonRole::rejection,
                "a sample would change class, ε = {value} (limit {limit})",
                "a sample would end up on the wrong side", "A sample of S would change its class. §2.4.1",
                0xD55E00, MarkerShape::cross, Measure::error,
                "A sample that changes sides would mean that Z has crossed a boundary of Ω.", "Figure 9"},
    ReasonWords{Reason::outside_tolerance, "outside-tolerance", "outside Ω", ReasonRole::rejection,
                "Z would leave Ω{at facet}, d = {value δ} (limit {limit δ})", "Z would leave the tolerance",
                "A facet of Z would have a point with d > δ.", 0xE69F00, MarkerShape::diamond,
                Measure::length, "Here δ decides: a larger tolerance would let this edge go.", "Figure 12"},
    ReasonWords{Reason::unproven, "unproven", "unproven", ReasonRole::rejection,
                "a facet could be proven neither inside nor outside of Ω",
                "Z could not be proven to stay in the tolerance",
                "A facet of Z could be proven neither inside nor outside of Ω.", 0xB3A24A,
                MarkerShape::hollow_diamond, Measure::length, "What cannot be proven is not done."},
    ReasonWords{Reason::normals, "normals", "normals", ReasonRole::rejection,
                "a normal would turn from the samples around it (condition 3)",
                "a facet would turn too far from the surface",
                "Condition 3 would be violated where it was not before. §2.4", 0x56B4E9,
                MarkerShape::hollow_triangle, Measure::alignment,
                "Z would lie in Ω, but its facets would stand across the surface.", "Figure 4"},
    ReasonWords{Reason::witness_side, "witness-side", "witness side", ReasonRole::rejection,
                "a witness of a region or of a thin part would change side", "a region would change side",
                "The deepest point of a region, or one that holds Z in a thin part, would change side.",
                0x3D8FD1, MarkerShape::plus, Measure::none,
                "A whole region would end up on the other side of Z, between all samples."},
    ReasonWords{Reason::intersection, "intersection", "self-intersection", ReasonRole::rejection,
                "Z would intersect itself", "Z would cut itself", "Z would intersect itself.", 0xCC4A3A,
                MarkerShape::cross, Measure::none, "A mesh that cuts itself bounds nothing."},
    ReasonWords{Reason::folded, "folded", "folded", ReasonRole::rejection, "{facet} would turn over",
                "a facet would fold over", "A facet of Z would turn over.", 0x44AA99,
                MarkerShape::hollow_triangle, Measure::none,
                "Facets that lie over each other hide that Z has turned back."},
    ReasonWords{Reason::stays_above, "stays-above", "stays above δ", ReasonRole::rejection,
                "the repair was rolled back, {facet} stays at d = {value δ} (limit {limit δ}), "
                "{excess δ} too far",
                "the repair did not come back into the tolerance",
                "The repair did not bring every facet below δ.", 0xB97850, MarkerShape::square,
                Measure::length,
                "A collapse may leave Ω for a moment, but not for good: all of it is taken back."},
    ReasonWords{Reason::ineligible, "ineligible", "not eligible", ReasonRole::rejection,
                "it is not of the kind that the stage collapses", "this stage collapses other edges",
                "The edge is not of the kind that the stage collapses. §2.4", 0x7FA83C, MarkerShape::plus,
                Measure::none, "Another stage looks at this edge."},
    ReasonWords{Reason::border_distance, "border-distance", "border and rim", ReasonRole::rejection,
                "the border of Z and the rim of the input would be {value δ} apart (limit {limit δ})",
                "the border would leave the rim of the input",
                "The border of Z would come to lie farther than δ from the rim, or leave a part of it bare. "
                "§4.1",
                0x2FA39A, MarkerShape::hollow_square, Measure::length,
                "Border and rim must be near each other both ways, or a part would be lost.", "Figure 15"},
    ReasonWords{.value = Reason::wall_over_rim,
                .name = "wall-over-rim",
                .title = "wall over the rim",
                .role = ReasonRole::place,
                .sentence = "the wall over the rim crosses it",
                .measure = Measure::length},
    ReasonWords{.value = Reason::leaves_volume,
                .name = "leaves-volume",
                .title = "facet leaves Ω",
                .role = ReasonRole::place,
                .sentence = "a facet beside it is not proven inside Ω",
                .measure = Measure::length},
    ReasonWords{.value = Reason::border_off_rim,
                .name = "border-off-rim",
                .title = "border off the rim",
                .role = ReasonRole::place,
                .sentence = "it is on the border of Z and not within δ of the rim",
                .measure = Measure::length},
    ReasonWords{.value = Reason::rim_off_border,
                .name = "rim-off-border",
                .title = "rim off the border",
                .role = ReasonRole::place,
                .sentence = "a place of the rim is farther than δ from the border of Z",
                .measure = Measure::length},
    ReasonWords{.value = Reason::pinched_border,
                .name = "pinched-border",
                .title = "pinched border",
                .role = ReasonRole::place,
                .sentence = "two parts of Z would meet in its end alone",
                .measure = Measure::length},
    ReasonWords{.value = Reason::cut_off,
                .name = "cut-off",
                .title = "cut-off place",
                .role = ReasonRole::place,
                .sentence = "a place goes in that Z cuts off from the region it belongs to"},
    ReasonWords{.value = Reason::thin_part,
                .name = "thin-part",
                .title = "thin part",
                .role = ReasonRole::place,
                .sentence = "a point in a wall or gap thinner than 2δ′ goes in, so that Z stays near there"},
    ReasonWords{.value = Reason::pocket,
                .name = "pocket",
                .title = "sphere too many",
                .role = ReasonRole::place,
                .sentence = "a sphere of Z that nothing asks for goes: its inside changes sides"},
};
static_assert(is_complete(reason_table, reason_count));

constexpr const ReasonWords& words(Reason value) {
  return reason_table[static_cast<std::size_t>(value)];
}
/// As filters, reports and scripts spell it.
constexpr std::string_view name(Reason value) {
  return words(value).name;
}
/// Whether it tells why an edge was not collapsed.
constexpr bool rejects(Reason value) {
  return words(value).role == ReasonRole::rejection;
}

/// All that do, in their order.
inline constexpr auto rejecting_reasons = [] {
  constexpr auto is_one = [](const ReasonWords& row) { return rejects(row.value); };
  std::array<Reason, std::count_if(reason_table.begin(), reason_table.end(), is_one)> all{};
  std::size_t n = 0;
  for (const ReasonWords& row : reason_table)
    if (is_one(row)) all.at(n++) = row.value;
  return all;
}();
static_assert(std::all_of(rejecting_reasons.begin(), rejecting_reasons.end(), [](Reason r) {
  return !words(r).plain.empty() && !words(r).help.empty() && !words(r).why.empty();
}));

} // namespace isoscope
