// What the journal speaks of: its enumerations, and for every value of them, in one row, its name, its title,
// its words and its mark; reasons are in journal/reasons.h. Sentences, lists, filters and styles all ask
// these tables.
//
// A row's texts may hold figures of the event in braces; journal/describe.cpp fills them in.
#pragma once

#include "journal/reasons.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isoscope {

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
  std::string_view help;        ///< what the stage does, in one sentence
  std::string_view plain;       ///< for an audience
  std::string_view why;         ///< what the stage is for, for an audience
  std::string_view figure = {}; ///< of the paper that shows the like
};
inline constexpr std::array stage_table{
    StageWords{Stage::setup, "setup", "set-up", "The loose bounding box and the samples. §2.2", "set-up",
               "The samples of both boundaries say on which side each point has to come to lie.", "Figure 1"},
    StageWords{Stage::refinement, "refinement", "refine",
               "Inserts samples until Z has the right topology and keeps inside Ω. §2.3", "refinement",
               "Points go in where f is most wrong, until Z lies in Ω with the right topology.",
               "Figures 2 to 5"},
    StageWords{Stage::gamma, "gamma", "∂Γ", "Collapses edges of ∂Γ. §2.4.1", "simplifying ∂Γ",
               "Points around Z that no sample needs go away; what follows has more room then.", "Figure 8"},
    StageWords{Stage::tessellation, "tessellation", "tessellate",
               "Puts Z into T: its vertices and facets become those of T. §2.4.2", "tessellation",
               "Z is only a level of f so far; as facets of T its own edges can collapse.", "Figure 10"},
    StageWords{Stage::zero_set, "zero-set", "Z", "Collapses edges of Z. §2.4.3", "simplifying Z",
               "Here most vertices go, the cheapest first, and nothing may leave Ω.", "Figures 11 and 12"},
    StageWords{Stage::all, "all", "all",
               "Collapses edges between Z and Γ, which make room, and edges of Z again. §2.4.4",
               "simplifying around Z",
               "Collapses between Z and Γ leave Z as it is and make room for edges that were stuck.",
               "Figure 13"},
    StageWords{Stage::improve, "improve", "improve",
               "Takes Z out of T, relocates its vertices, flips, and collapses with repair.", "improvement",
               "Without T around it Z can move freely, and more edges can go; each change is proven."},
    StageWords{Stage::rim, "rim", "rim", "Cuts Z along the wall over the rim of open surfaces. §4.1",
               "cutting along the rim",
               "Nobody asks anything beyond the rim: Z has to be cut where the surface ends.", "Figure 15"},
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
  fill,             ///< dropped facets that close a hole became part of Z again (an operation)
  start             ///< Z begins outside of T, as a surface that is known already (an operation)
};
constexpr int event_kind_count = static_cast<int>(EventKind::start) + 1;

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
  Measure measure = Measure::none;
  std::string_view why = {}, figure = {}; ///< see StageWords; empty where the event says all itself
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
              ColorRole::condition, MarkerShape::disc, 0, "labels of {n|vertex|vertices} change side",
              "{n|vertex changes|vertices change} side"},
    KindWords{EventKind::exhausted, "exhausted", "exhausted", "exhausted",
              "A condition stays violated and no point is left to try. §2.3", ColorRole::condition,
              MarkerShape::disc, 0, "{stays}; {why exhausted}", "{stays}", Measure::none,
              "It stays as it is; the certificate judges it at the end."},
    KindWords{EventKind::topology_check, "topology-check", "topology checks", "topology-check",
              "Components and χ of Z against what is expected. §2.3", ColorRole::condition, MarkerShape::disc,
              0, "topology: Z has χ = {χ} in {n|component|components}{expected}",
              "Z has {n|component|components} and χ = {χ}{expected}", Measure::none,
              "With the right handles and parts Z can be deformed into the input within Ω."},
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
              "mutual tessellation: {n|vertex|vertices} of Z go into T",
              "Z becomes part of the triangulation, with {n|vertex|vertices}"},
    KindWords{EventKind::departure, "departure", "departure", "Z leaves T",
              "Z left T: its facets are free from here on.", ColorRole::stage, MarkerShape::square, 0,
              "Z leaves T: from here on its own facets are kept inside Ω",
              "Z leaves the triangulation and moves freely inside the tolerance", Measure::none,
              "Tetrahedra no longer limit what may move; facets are proven inside Ω themselves."},
    KindWords{EventKind::relaxation, "relaxation", "relocation sweeps", "relocation sweep",
              "Sweeps of relocations and flips over Z.", ColorRole::accent, MarkerShape::diamond, 0x3D8FD1,
              "{n|vertex|vertices} relocated in a sweep over Z, largest d = {value δ}",
              "{n|vertex moves|vertices move} to better places, farthest d = {value δ}", Measure::length,
              "Farther from the boundary of Ω there is more room for collapses."},
    KindWords{EventKind::repair, "repair", "collapses with repair", "collapse with repair",
              "Edges that were collapsed with their neighbourhood repaired.", ColorRole::warning,
              MarkerShape::triangle, 0xD9A02B,
              "{edge} collapses, repaired in {sweeps} sweeps, largest d = {value δ}",
              "an edge collapses and its neighbours are moved back into the tolerance", Measure::length,
              "It left Ω for a moment; as its neighbours could be moved back, it stays."},
    KindWords{EventKind::shake, "shake", "shakes", "shake",
              "Edges of Z flipped against the energy, to leave a minimum.", ColorRole::accent,
              MarkerShape::square, 0xCC79A7,
              "Z shaken: edges flipped against the energy and {n|vertex|vertices} relocated around them, "
              "largest d = {value δ}",
              "edges of Z are turned to make room for further collapses", Measure::length,
              "Where nothing collapses any more, a detour over a worse mesh leads to a coarser one."},
    KindWords{EventKind::split, "split", "edge splits", "edge split",
              "Edges of Z that were split to cut it along the rim. §4.1", ColorRole::accent,
              MarkerShape::disc, 0x44AA99, "{edge} is split: {place}",
              "an edge is split so that the border follows the rim", Measure::none,
              "Only where edges follow the wall over the rim can Z be cut along it.", "Figure 15"},
    KindWords{EventKind::cut, "cut", "cut", "cut along the rim", "What lies beyond the rim was dropped. §4.1",
              ColorRole::stage, MarkerShape::square, 0,
              "Z is cut along the rim: {n|facet|facets} beyond it go",
              "{n|facet|facets} beyond the rim fall away", Measure::none,
              "Beyond the rim Z approximated nothing.", "Figure 15"},
    KindWords{EventKind::fill, "fill", "filling", "filling of holes",
              "Dropped facets that close holes became part of Z again. §4.1", ColorRole::stage,
              MarkerShape::square, 0, "holes are filled with {n|facet|facets}, outside of Ω by intent",
              "holes are filled with {n|facet|facets}", Measure::none,
              "Outside of Ω by intent: the hole is closed as it was asked for.", "Figure 16"},
    KindWords{EventKind::start, "start", "start", "first Z",
              "Z begins outside of T, as a surface that is known already.", ColorRole::stage,
              MarkerShape::square, 0, "the first Z has {n|vertex|vertices}",
              "Z begins with {n|vertex|vertices}", Measure::none,
              "A surface inside Ω that separates its sides is known: no T has to find one."},
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
  std::string_view cause;                      ///< what points go in for, in many words
  Measure measure;
  std::string_view why;         ///< why a point has to go in, for an audience
  std::string_view figure = {}; ///< of the paper
};
inline constexpr std::array condition_table{
    ConditionWords{Condition::none, "none", "set-up", "a point goes in", "a point goes in",
                   "condition 4: nothing left to try here{in tet}", "no point is left to try here",
                   "the set-up", Measure::none,
                   "f is positive at all corners: there is no Z yet, and all samples inside are wrong."},
    ConditionWords{Condition::classification, "classification", "1 classification",
                   "condition 1: {sample} with ε = {value} (limit {limit}) goes in",
                   "the sample with the largest error, {value}, goes in",
                   "condition 1 stays violated: ε = {value} (limit {limit}){in tet}",
                   "a sample stays on the wrong side: no point is left to try", "samples on the wrong side",
                   Measure::error,
                   "Where a sample is on the wrong side, Z has left Ω. At the new point f is right.",
                   "Figure 3"},
    ConditionWords{Condition::height, "height", "2 height",
                   "condition 2: {tet} is {value δ} high (at least {limit δ}); {place}",
                   "a tetrahedron is too flat, {value δ} high: a point splits it",
                   "condition 2 stays violated: height {value δ} (at least {limit δ}){in tet}",
                   "a tetrahedron stays too flat: no point is left to try", "flat tetrahedra", Measure::depth,
                   "A flat tetrahedron makes f steep: between samples Z could leave Ω unseen.", "Figure 5"},
    ConditionWords{Condition::orientation, "orientation", "3 orientation",
                   "condition 3: {tet} is misoriented (f·F = {value} at a nearest sample, must be above 0); "
                   "{place}",
                   "a tetrahedron faces the wrong way: a point splits it",
                   "condition 3 stays violated: misoriented{in tet}",
                   "a tetrahedron keeps facing the wrong way: no point is left to try",
                   "tetrahedra that face the wrong way", Measure::alignment,
                   "All samples may be right while Z runs across Ω instead of along it.", "Figure 4"},
    ConditionWords{Condition::topology, "topology", "4 topology",
                   "condition 4: Z has not the expected topology; {place}",
                   "Z has too many or too few handles: a point goes in to mend it",
                   "condition 4: nothing left to try here{in tet}", "no point is left to try here",
                   "the topology of Z", Measure::none,
                   "Collapses will keep the topology, so it has to be right before them."},
    ConditionWords{Condition::containment, "containment", "containment",
                   "containment: Z reaches d = {value δ} (limit {limit δ}) in {tet}; {place}",
                   "Z may leave the tolerance, d = {value δ}: a point pulls it back",
                   "containment stays unproven: d = {value δ} (limit {limit δ}){in tet}",
                   "part of Z stays unproven: no point is left to try",
                   "places where Z may leave the tolerance", Measure::length,
                   "Samples are only points: it takes a proof for whole facets to keep Z in Ω."},
    ConditionWords{Condition::witness, "witness", "witness",
                   "witness: a region's deepest point lies on the wrong side of Z; it goes in",
                   "a region lies on the wrong side of Z: its deepest point goes in",
                   "condition 4: nothing left to try here{in tet}", "no point is left to try here",
                   "regions on the wrong side", Measure::none,
                   "A thin region may lie between all samples; its deepest point speaks for it."},
};

static_assert(is_complete(stage_table, stage_count));
static_assert(is_complete(kind_table, event_kind_count));
static_assert(is_complete(condition_table, condition_count));

constexpr const StageWords& words(Stage value) {
  return stage_table[static_cast<std::size_t>(value)];
}
constexpr const KindWords& words(EventKind value) {
  return kind_table[static_cast<std::size_t>(value)];
}
constexpr const ConditionWords& words(Condition value) {
  return condition_table[static_cast<std::size_t>(value)];
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

} // namespace isoscope
