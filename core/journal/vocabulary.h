// What the journal speaks of: its enumerations, and for every value of them, in one row, its name, its title,
// its words and its mark. Sentences, lists, filters and styles all ask these tables.
//
// A row's texts may hold figures of the event in braces; journal/describe.cpp fills them in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isoscope {

/// The shapes of marks. The numbers are those of shaders/marker.frag; 8 more draws the outline alone.
enum class MarkerShape : std::uint8_t {
  ring,
  disc,
  cross,
  circle, ///< a thin ring
  square,
  diamond,
  triangle,
  plus,
  hollow_square = 12,
  hollow_diamond,
  hollow_triangle
};

/// The stages of a run.
enum class Stage : std::uint8_t {
  setup,
  refinement,
  gamma,        ///< collapses of edges of ∂Γ (§2.4.1)
  tessellation, ///< Z into T (§2.4.2)
  zero_set,     ///< collapses of edges of Z (§2.4.3)
  all,          ///< collapses of edges between Z and Γ, and of Z again (§2.4.4)
  improve,      ///< minimax placement, flips, collapses with repair (core/README.md, N6)
  rim           ///< Z is cut along the rim of open surfaces, after the tessellation (§4.1)
};
constexpr int stage_count = static_cast<int>(Stage::rim) + 1;

/// The order of the stages in a run; their numbers are those of recordings.
inline constexpr std::array<Stage, stage_count> stages_in_order{
    Stage::setup, Stage::refinement, Stage::gamma, Stage::tessellation,
    Stage::rim,   Stage::zero_set,   Stage::all,   Stage::improve};
/// Whether a stage comes after another one in a run.
constexpr bool comes_after(Stage stage, Stage other) {
  for (const Stage s : stages_in_order) {
    if (s == stage) return false;
    if (s == other) return true;
  }
  return false;
}

struct StageWords {
  Stage value;
  std::string_view name, title;
  std::string_view help;  ///< what the stage does, in one sentence
  std::string_view plain; ///< for an audience
};
inline constexpr std::array stage_table{
    StageWords{Stage::setup, "setup", "set-up", "The loose bounding box and the samples. §2.2", "set-up"},
    StageWords{Stage::refinement, "refinement", "refine",
               "Inserts samples until Z has the right topology and keeps inside Ω. §2.3", "refinement"},
    StageWords{Stage::gamma, "gamma", "∂Γ", "Collapses edges of ∂Γ. §2.4.1", "simplifying ∂Γ"},
    StageWords{Stage::tessellation, "tessellation", "tessellate",
               "Puts Z into T: its vertices and facets become those of T. §2.4.2", "tessellation"},
    StageWords{Stage::zero_set, "zero-set", "Z", "Collapses edges of Z. §2.4.3", "simplifying Z"},
    StageWords{Stage::all, "all", "all",
               "Collapses edges between Z and Γ, which make room, and edges of Z again. §2.4.4",
               "simplifying around Z"},
    StageWords{Stage::improve, "improve", "improve",
               "Takes Z out of T, relocates its vertices, flips, and collapses with repair.", "improvement"},
    StageWords{Stage::rim, "rim", "rim", "Cuts Z along the wall over the rim of open surfaces. §4.1",
               "cutting along the rim"},
};

/// What kind of decision.
enum class EventKind : std::uint8_t {
  stage_begin,
  stage_end,
  insertion,        ///< a Steiner point entered T (an operation: it has a delta)
  relabel,          ///< F of vertices changed (an operation)
  exhausted,        ///< a tetrahedron violates a condition and no candidate is left for it
  topology_check,   ///< components and χ of Z against the expected ones
  parameter_change, ///< α, σ, shrink or conditions changed; an operation when S was replaced
  warning,          ///< something the user should know; see Journal::text
  stopped,          ///< the run ended before its goal: cancelled or a limit; see Journal::text
  collapse,         ///< an edge was collapsed (an operation)
  rejection,        ///< an edge could not be collapsed: `reason` is the first check that failed
  tessellation,     ///< Z went into T (an operation)
  departure,        ///< Z left T: its facets are free from here on (an operation)
  relaxation,       ///< a sweep of relocations and flips over Z (an operation)
  repair,           ///< an edge was collapsed and its neighbourhood repaired (an operation)
  shake,            ///< edges of Z were flipped against the energy, with repair (an operation)
  split,            ///< an edge of Z was split to cut it along the rim (an operation)
  cut,              ///< facets of Z beyond the rim were dropped (an operation)
  fill              ///< dropped facets that close a hole became part of Z again (an operation)
};
constexpr int event_kind_count = static_cast<int>(EventKind::fill) + 1;

/// What gives the mark of a kind its colour in lists.
enum class ColorRole : std::uint8_t { condition, stage, reason, good, warning, accent };

struct KindWords {
  EventKind value;
  std::string_view name, title;
  std::string_view one; ///< a single operation, in a word or three
  std::string_view help;
  ColorRole role;
  MarkerShape shape;
  std::uint32_t color; ///< of its lane in the timeline, 0xRRGGBB
  std::string_view sentence, plain;
};
inline constexpr std::array kind_table{
    KindWords{EventKind::stage_begin, "stage-begin", "stage begins", "stage-begin", "A stage begins.",
              ColorRole::stage, MarkerShape::square, 0, "{stage} begins", "{stage} begins"},
    KindWords{EventKind::stage_end, "stage-end", "stage ends", "stage-end", "A stage ends.", ColorRole::stage,
              MarkerShape::square, 0, "{stage} ends", "{stage} is done"},
    KindWords{EventKind::insertion, "insertion", "insertions", "insertion",
              "Points inserted for a condition. §2.3", ColorRole::condition, MarkerShape::disc, 0,
              "{insertion}", "{insertion}"},
    KindWords{EventKind::relabel, "relabel", "relabelling", "relabel", "Vertices whose label changed.",
              ColorRole::condition, MarkerShape::disc, 0, "labels of {n} vertices change side",
              "{n|vertex changes|vertices change} side"},
    KindWords{EventKind::exhausted, "exhausted", "exhausted", "exhausted",
              "A condition stays violated and no point is left to try. §2.3", ColorRole::condition,
              MarkerShape::disc, 0, "{stays}; {why exhausted}", "{stays}"},
    KindWords{EventKind::topology_check, "topology-check", "topology checks", "topology-check",
              "Components and χ of Z against what is expected. §2.3", ColorRole::condition, MarkerShape::disc,
              0, "topology: Z has χ = {χ} in {n|component|components}{expected}",
              "Z has {n|component|components} and χ = {χ}{expected}"},
    KindWords{EventKind::parameter_change, "parameter-change", "parameters", "parameter-change",
              "Parameters changed while the run went on.", ColorRole::condition, MarkerShape::disc, 0,
              "parameters: α = {α}, σ = {σ}, shrink {shrink}", "the parameters change: α = {α}, σ = {σ}"},
    KindWords{EventKind::warning, "warning", "warnings", "warning", "What the user should know.",
              ColorRole::warning, MarkerShape::hollow_triangle, 0, "warning", "a warning"},
    KindWords{EventKind::stopped, "stopped", "stopped", "stopped", "The run ended before its goal.",
              ColorRole::warning, MarkerShape::hollow_triangle, 0, "stopped", "{stage} is stopped"},
    KindWords{EventKind::collapse, "collapse", "collapses", "collapse", "Edges that were collapsed. §2.4",
              ColorRole::good, MarkerShape::disc, 0x009E73, "{edge} collapses to {target}",
              "an edge collapses, one vertex less"},
    KindWords{EventKind::rejection, "rejection", "rejections", "rejection",
              "Edges that could not be collapsed, with the first check that failed. §2.4", ColorRole::reason,
              MarkerShape::disc, 0, "{edge} stays: {why}", "an edge stays: {why}"},
    KindWords{EventKind::tessellation, "tessellation", "tessellation", "mutual tessellation",
              "Z went into T. §2.4.2", ColorRole::stage, MarkerShape::square, 0,
              "mutual tessellation: {n} vertices of Z go into T",
              "Z becomes part of the triangulation, with {n|vertex|vertices}"},
    KindWords{EventKind::departure, "departure", "departure", "Z leaves T",
              "Z left T: its facets are free from here on.", ColorRole::stage, MarkerShape::square, 0,
              "Z leaves T: from here on its own facets are kept inside Ω",
              "Z leaves the triangulation and moves freely inside the tolerance"},
    KindWords{EventKind::relaxation, "relaxation", "relocation sweeps", "relocation sweep",
              "Sweeps of relocations and flips over Z.", ColorRole::accent, MarkerShape::diamond, 0x3D8FD1,
              "{n} vertices relocated in a sweep over Z, largest d = {value δ}",
              "{n|vertex moves|vertices move} to better places, farthest d = {value δ}"},
    KindWords{EventKind::repair, "repair", "collapses with repair", "collapse with repair",
              "Edges that were collapsed with their neighbourhood repaired.", ColorRole::warning,
              MarkerShape::triangle, 0xD9A02B,
              "{edge} collapses, repaired in {sweeps} sweeps, largest d = {value δ}",
              "an edge collapses and its neighbours are moved back into the tolerance"},
    KindWords{EventKind::shake, "shake", "shakes", "shake",
              "Edges of Z flipped against the energy, to leave a minimum.", ColorRole::accent,
              MarkerShape::square, 0xCC79A7,
              "Z shaken: edges flipped against the energy and {n} vertices relocated around them, "
              "largest d = {value δ}",
              "edges of Z are turned to make room for further collapses"},
    KindWords{EventKind::split, "split", "edge splits", "edge split",
              "Edges of Z that were split to cut it along the rim. §4.1", ColorRole::accent,
              MarkerShape::disc, 0x44AA99, "{edge} is split: {place}",
              "an edge is split so that the border follows the rim"},
    KindWords{EventKind::cut, "cut", "cut", "cut along the rim", "What lies beyond the rim was dropped. §4.1",
              ColorRole::stage, MarkerShape::square, 0, "Z is cut along the rim: {n} facets beyond it go",
              "{n|facet|facets} beyond the rim fall away"},
    KindWords{EventKind::fill, "fill", "filling", "filling of holes",
              "Dropped facets that close holes became part of Z again. §4.1", ColorRole::stage,
              MarkerShape::square, 0, "holes are filled with {n} facets, outside of Ω by intent",
              "holes are filled with {n|facet|facets}"},
};

/// Which criterion asked for it (§2.3).
enum class Condition : std::uint8_t {
  none,
  classification, ///< condition 1: ε(s) <= 1 − α
  height,         ///< condition 2: height >= 2σ/α
  orientation,    ///< condition 3: shrunk copy classified well
  topology,       ///< condition 4: components and genus of Z
  containment,    ///< the facet certificate (core/README.md, N4), certified mode
  witness         ///< f has a region's sign at its deepest point
};
constexpr int condition_count = static_cast<int>(Condition::witness) + 1;

struct ConditionWords {
  Condition value;
  std::string_view name, title;
  std::string_view insertion, plain_insertion; ///< a point goes in for it
  std::string_view stays, plain_stays;         ///< it stays violated, no point is left
};
inline constexpr std::array condition_table{
    ConditionWords{Condition::none, "none", "set-up", "a point goes in", "a point goes in",
                   "condition 4: nothing left to try here{in tet}", "no point is left to try here"},
    ConditionWords{Condition::classification, "classification", "1 classification",
                   "condition 1: {sample} with ε = {value} (limit {limit}) goes in",
                   "the sample with the largest error, {value}, goes in",
                   "condition 1 stays violated: ε = {value} (limit {limit}){in tet}",
                   "a sample stays on the wrong side: no point is left to try"},
    ConditionWords{Condition::height, "height", "2 height",
                   "condition 2: {tet} is {value δ} high (at least {limit δ}); {place}",
                   "a tetrahedron is too flat, {value δ} high: a point splits it",
                   "condition 2 stays violated: height {value δ} (at least {limit δ}){in tet}",
                   "a tetrahedron stays too flat: no point is left to try"},
    ConditionWords{Condition::orientation, "orientation", "3 orientation",
                   "condition 3: {tet} is misoriented (f·F = {value} at a nearest sample, must be above 0); "
                   "{place}",
                   "a tetrahedron faces the wrong way: a point splits it",
                   "condition 3 stays violated: misoriented{in tet}",
                   "a tetrahedron keeps facing the wrong way: no point is left to try"},
    ConditionWords{Condition::topology, "topology", "4 topology",
                   "condition 4: Z has not the expected topology; {place}",
                   "Z has too many or too few handles: a point goes in to mend it",
                   "condition 4: nothing left to try here{in tet}", "no point is left to try here"},
    ConditionWords{Condition::containment, "containment", "containment",
                   "containment: Z reaches d = {value δ} (limit {limit δ}) in {tet}; {place}",
                   "Z may leave the tolerance, d = {value δ}: a point pulls it back",
                   "containment stays unproven: d = {value δ} (limit {limit δ}){in tet}",
                   "part of Z stays unproven: no point is left to try"},
    ConditionWords{Condition::witness, "witness", "witness",
                   "witness: a region's deepest point lies on the wrong side of Z; it goes in",
                   "a region lies on the wrong side of Z: its deepest point goes in",
                   "condition 4: nothing left to try here{in tet}", "no point is left to try here"},
};

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
  pinched_border  ///< two parts of Z would meet in its end alone
};
constexpr int reason_count = static_cast<int>(Reason::pinched_border) + 1;

/// The first and the last reason for a collapse that was not made.
constexpr Reason first_rejection = Reason::link_condition;
constexpr Reason last_rejection = Reason::border_distance;
constexpr bool rejects(Reason reason) {
  return reason >= first_rejection && reason <= last_rejection;
}

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
    ReasonWords{Reason::budget, "budget", "limit of work", ReasonRole::exhaustion,
                "a limit of work was reached"},
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
                MarkerShape::square},
    ReasonWords{Reason::zero_link_condition, "zero-link-condition", "link in Z", ReasonRole::rejection,
                "the link condition fails in Z", "collapsing it would pinch Z",
                "Lk(a) ∩ Lk(b) ≠ Lk(ab) in Z: the collapse would change the topology of Z. §2.4", 0xE39AD8,
                MarkerShape::hollow_square},
    ReasonWords{Reason::kernel_empty, "kernel-empty", "kernel empty", ReasonRole::rejection,
                "its kernel is empty: no point sees the whole one-ring",
                "no place sees its whole surroundings", "No point sees the whole one-ring. §2.4, Figure 7",
                0x8C6BD8, MarkerShape::triangle},
    ReasonWords{Reason::no_candidate, "no-candidate", "outside the kernel", ReasonRole::rejection,
                "no candidate point lies in its kernel", "no target was found that sees its surroundings",
                "No candidate lies where the whole one-ring is seen. §2.4", 0x8F98A8, MarkerShape::circle},
    ReasonWords{Reason::misclassified, "misclassified", "misclassified", ReasonRole::rejection,
                "a sample would change class, ε = {value} (limit {limit})",
                "a sample would end up on the wrong side", "A sample of S would change its class. §2.4.1",
                0xD55E00, MarkerShape::cross},
    ReasonWords{Reason::outside_tolerance, "outside-tolerance", "outside Ω", ReasonRole::rejection,
                "Z would leave Ω{at facet}, d = {value δ} (limit {limit δ})", "Z would leave the tolerance",
                "A facet of Z would have a point with d > δ.", 0xE69F00, MarkerShape::diamond},
    ReasonWords{Reason::unproven, "unproven", "unproven", ReasonRole::rejection,
                "a facet could be proven neither inside nor outside of Ω",
                "Z could not be proven to stay in the tolerance",
                "A facet of Z could be proven neither inside nor outside of Ω.", 0xB3A24A,
                MarkerShape::hollow_diamond},
    ReasonWords{Reason::normals, "normals", "normals", ReasonRole::rejection,
                "a normal would turn from the samples around it (condition 3)",
                "a facet would turn too far from the surface",
                "Condition 3 would be violated where it was not before. §2.4", 0x56B4E9,
                MarkerShape::hollow_triangle},
    ReasonWords{Reason::witness_side, "witness-side", "witness side", ReasonRole::rejection,
                "the deepest point of a region would change side", "a region would change side",
                "The deepest point of a region would change side.", 0x3D8FD1, MarkerShape::plus},
    ReasonWords{Reason::intersection, "intersection", "self-intersection", ReasonRole::rejection,
                "Z would intersect itself", "Z would cut itself", "Z would intersect itself.", 0xCC4A3A,
                MarkerShape::cross},
    ReasonWords{Reason::folded, "folded", "folded", ReasonRole::rejection, "{facet} would turn over",
                "a facet would fold over", "A facet of Z would turn over.", 0x44AA99,
                MarkerShape::hollow_triangle},
    ReasonWords{Reason::stays_above, "stays-above", "stays above δ", ReasonRole::rejection,
                "the repair was rolled back, {facet} stays at d = {value δ} (limit {limit δ}), "
                "{excess δ} too far",
                "the repair did not come back into the tolerance",
                "The repair did not bring every facet below δ.", 0xB97850, MarkerShape::square},
    ReasonWords{Reason::ineligible, "ineligible", "not eligible", ReasonRole::rejection,
                "it is not of the kind that the stage collapses", "this stage collapses other edges",
                "The edge is not of the kind that the stage collapses. §2.4", 0x7FA83C, MarkerShape::plus},
    ReasonWords{Reason::border_distance, "border-distance", "border and rim", ReasonRole::rejection,
                "the border of Z and the rim of the input would be {value δ} apart (limit {limit δ})",
                "the border would leave the rim of the input",
                "The border of Z would come to lie farther than δ from the rim, or leave a part of it bare. "
                "§4.1",
                0x2FA39A, MarkerShape::hollow_square},
    ReasonWords{Reason::wall_over_rim, "wall-over-rim", "wall over the rim", ReasonRole::place,
                "the wall over the rim crosses it"},
    ReasonWords{Reason::leaves_volume, "leaves-volume", "facet leaves Ω", ReasonRole::place,
                "a facet beside it is not proven inside Ω"},
    ReasonWords{Reason::border_off_rim, "border-off-rim", "border off the rim", ReasonRole::place,
                "it is on the border of Z and not within δ of the rim"},
    ReasonWords{Reason::rim_off_border, "rim-off-border", "rim off the border", ReasonRole::place,
                "a place of the rim is farther than δ from the border of Z"},
    ReasonWords{Reason::pinched_border, "pinched-border", "pinched border", ReasonRole::place,
                "two parts of Z would meet in its end alone"},
};

/// Whether a table has one row for each of so many values, in their order.
template <class Row, std::size_t n> constexpr bool is_complete(const std::array<Row, n>& table, int count) {
  for (std::size_t i = 0; i < n; ++i)
    if (static_cast<std::size_t>(table[i].value) != i || table[i].name.empty() || table[i].title.empty())
      return false;
  return n == static_cast<std::size_t>(count);
}
static_assert(is_complete(stage_table, stage_count));
static_assert(is_complete(kind_table, event_kind_count));
static_assert(is_complete(condition_table, condition_count));
static_assert(is_complete(reason_table, reason_count));

/// Whether a row has that name, or that title: what the screen calls a thing may be typed too.
template <class Row> constexpr bool is_called(const Row& row, std::string_view word) {
  return row.name == word || row.title == word;
}

constexpr const StageWords& words(Stage value) {
  return stage_table[static_cast<std::size_t>(value)];
}
constexpr const KindWords& words(EventKind value) {
  return kind_table[static_cast<std::size_t>(value)];
}
constexpr const ConditionWords& words(Condition value) {
  return condition_table[static_cast<std::size_t>(value)];
}
constexpr const ReasonWords& words(Reason value) {
  return reason_table[static_cast<std::size_t>(value)];
}

/// As filters, reports and scripts spell it.
constexpr std::string_view name(Stage value) {
  return words(value).name;
}
constexpr std::string_view name(EventKind value) {
  return words(value).name;
}
constexpr std::string_view name(Condition value) {
  return words(value).name;
}
constexpr std::string_view name(Reason value) {
  return words(value).name;
}

} // namespace isoscope
