// Everything a run is asked: one struct, and of each of its fields, in one row, all that files, the command
// line, comparisons, scripts and the window's panel say of it.
#pragma once

#include "base/fields.h"
#include "base/status.h"
#include "criteria/topology.h"
#include "journal/journal.h"
#include "run/parameter_values.h"
#include "run/parameter_words.h"
#include "simplify/simplification.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// How containment of Z in Ω is ensured (core/README.md, N2).
enum class Containment : std::uint8_t {
  certified, ///< coarse S, facet certificate (default)
  sampled    ///< the paper to the letter: dense S, α margin, condition 2
};

struct RunParameters {
  std::string input;  ///< a file, or gallery:NAME
  std::string inside; ///< the inner one of two surfaces between which Ω lies, the input being the outer one
  Levels levels;      ///< of an input that is a grid
  std::optional<int> label; ///< of an input that is a segmentation
  Tolerance tolerance;      ///< δ > 0
  double sigma = 0;    ///< σ/δ in (0, 1]; 0: 1/8 in sampled mode, default_sigma_ratio() in certified mode
  double alpha = 0.2;  ///< α in (0, 1)
  double shrink = 0.7; ///< in (0, 1]
  Containment containment = Containment::certified;
  TopologyMode topology = TopologyMode::keep;
  /// Whether parts that are thinner than 2δ everywhere are left out of the input instead of refused.
  bool drop_thin = false;
  FirstZ start = FirstZ::delaunay; ///< where the first Z comes from; others leave T out
  /// How far from the result a point of the input may be, in δ, > 0; absent: as far as it likes, as in the
  /// paper, whose bound is one-sided.
  std::optional<double> cover = 3;
  /// Of points; of triangles, where it is a number, that a sample of their area is taken for them.
  Robust robust;
  BallTestFactor gamma;                                   ///< of points
  SidesMode sides = SidesMode::automatic;                 ///< what tells inside from outside
  Fill fill;                                              ///< holes of open surfaces that are closed
  std::array<bool, 4> conditions{true, true, true, true}; ///< 1 to 4 of §2.3
  std::array<bool, stage_count> skipped{}; ///< stages to leave out: gamma, zero_set, all or improve
  TargetStrategy target = TargetStrategy::constraints; ///< how targets of general collapses are looked for
  CostRing cost_ring = CostRing::one;                  ///< facets of Z whose planes make the error (§2.4)
  int effort = 2;                                      ///< of the improver, 0 to 3; 3 never ends
  ImproverPlace improver = ImproverPlace::free;        ///< on Z alone or inside T
  /// Components of the input whose box has a longest edge below so many δ are left out; 0: none.
  double drop_small = 0;
  unsigned threads = 0;    ///< 0: all cores
  double time_limit = 0;   ///< seconds, 0 none
  double memory_limit = 0; ///< MiB that Ω and S may take, as far as foreseen; 0: two thirds of what there is
  /// The last stage; absent: improve in certified mode, all in sampled mode, where the paper ends.
  std::optional<Stage> until;

  double most_bytes() const; ///< the memory limit in bytes; infinite where nothing is known
  /// `by_default`: what certified mode takes when nothing is given (Scene::default_sigma).
  double sigma_ratio(double by_default = 0.5) const {
    return sigma > 0 ? sigma : (containment == Containment::certified ? by_default : 0.125);
  }
  Stage last_stage() const {
    return until.value_or(containment == Containment::certified ? Stage::improve : Stage::all);
  }
  CriteriaParameters criteria(double delta, double default_sigma = 0.5) const;
  SimplificationParameters simplification() const;
  friend bool operator==(const RunParameters&, const RunParameters&) = default;
};

/// In the order of files; the panel has an order of its own.
constexpr auto fields_of(const RunParameters*) {
  using P = RunParameters;
  using JournalChange::none, JournalChange::end;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::tuple{
      field(&P::input,
            {.name = "input",
             .option = "INPUT",
             .symbol = "input",
             .help = "a file of triangles or of points (OFF, OBJ, PLY, STL, XYZ), a grid (NRRD), or "
                     "gallery:NAME for a bundled model"}),
      field(
          &P::inside,
          {.name = "inside",
           .symbol = "inner surface",
           .help =
               "a mesh file: Ω is what lies between it and the outer surface of --outside, and δ is half of "
               "what the two are apart",
           .words = "the inner one of two surfaces between which Ω lies"}),
      field(&P::levels,
            {.name = "levels",
             .symbol = "levels",
             .help =
                 "LO HI: of an input that is a grid (NRRD, or raw with a header), Ω is where its values lie "
                 "between these; with --label in voxels, from the label's boundary outwards",
             .words = "the values of a grid between which Ω lies: LO HI, or none",
             .unreadable = "no two numbers, the smaller first",
             .unreadable_remedy = "Give the lower and the upper level, as --levels 0.8 1.2.",
             .values = 2,
             .place = 6,
             .title = "Levels of a grid",
             .tip = "Ω is where the values of the grid lie between these two. Needs a restart."}),
      field(
          &P::label,
          {.name = "label",
           .symbol = "label",
           .help =
               "of an input that is a segmentation: Ω is the layer between the voxels of this label and all "
               "others",
           .words = "the label of a segmentation around which Ω lies, or none",
           .range = {.low = -16777216, .high = 16777216, .remedy = "Labels are whole numbers."},
           .unreadable = "no whole number",
           .unreadable_remedy = "Labels are whole numbers.",
           .absent = "none",
           .place = 7,
           .title = "Label of a segmentation",
           .tip = "Ω is the layer between the voxels of this label and all others. Needs a restart."}),
      field(&P::tolerance,
            {.name = "tolerance",
             .symbol = "δ",
             .help =
                 "δ: a percentage of the longest edge of the bounding box (0.6%), a length, or auto: found "
                 "from the input; default 0.6%, for bundled models their own, for lists of points auto",
             .words = "δ: a percentage of the longest edge, a length, or auto",
             .range = {.low = 0,
                       .high = 100,
                       .low_included = false,
                       .remedy = "Percentages are of the longest edge of the input's bounding box."},
             .unreadable = "no positive number",
             .unreadable_remedy =
                 "Give a percentage of the longest edge, as 0.6%, a length, as 0.012, or auto.",
             .place = 4,
             .label = "δ tolerance",
             .title = "Tolerance δ",
             .tip = "δ, half the thickness of Ω. In percent of the longest edge of the input's bounding box, "
                    "or as a length of the input's units, above 0; or auto: found from points by what Ω "
                    "encloses. A change needs a restart. §2.1"}),
      field(&P::sigma,
            {.name = "sigma",
             .symbol = "σ/δ",
             .help = "σ/δ, density of the samples, in (0, 1]; default 0.5, or what keeps them to about two "
                     "million, at most 0.95; where there are more than 250,000, 2 in planes; sampled mode "
                     "0.125",
             .words = "σ/δ, density of the samples; 0 is the mode's own",
             .range = {.low = 0,
                       .high = 1,
                       .low_included = false,
                       .remedy = "It is relative to δ: 0.5 means δ/2."},
             .zero_is_default = true,
             .restart = false,
             .until = "refinement",
             .place = 2,
             .label = "σ density",
             .title = "Sampling density σ",
             .tip = "Radius within which every point of ∂Ω has a sample, as a fraction of δ, in (0, 1]. "
                    "Smaller means more samples. It matters until the refinement ends. §2.2",
             .counted_in = " δ",
             .format = "%.3f",
             .slider_from = 0.05,
             .logarithmic = true}),
      field(&P::alpha,
            {.name = "alpha",
             .symbol = "α",
             .help = "α, margin of the classification, in (0, 1); default 0.2",
             .words = "α, margin of condition 1",
             .range = {.low = 0,
                       .high = 1,
                       .low_included = false,
                       .high_included = false,
                       .remedy = "The paper takes 0.2 everywhere."},
             .restart = false,
             .until = "refinement",
             .place = 1,
             .label = "α margin",
             .title = "Margin α",
             .tip = "How far f must be on the right side at every sample: ε(s) ≤ 1 − α. No unit, in (0, 1); "
                    "0.2 in the paper. Larger is safer and asks for more Steiner points. It matters until "
                    "the refinement ends, in sampled mode to the last collapse inside T. §2.3",
             .format = "%.2f"}),
      field(&P::shrink,
            {.name = "shrink",
             .symbol = "shrink",
             .help = "factor of the shrunk copy in condition 3, in (0, 1]; default 0.7",
             .words = "factor of condition 3's copy",
             .range = {.low = 0, .high = 1, .low_included = false, .remedy = "The paper takes 0.7."},
             .restart = false,
             .until = "all",
             .place = 3,
             .title = "Shrink factor of condition 3",
             .tip =
                 "Size of the shrunk copy about its centroid by which condition 3 judges a tetrahedron. No "
                 "unit, in (0, 1]; 0.7 in the paper. It matters until the improver begins. §2.3, Figure 4",
             .format = "%.2f",
             .slider_from = 0.05}),
      field(&P::containment,
            {.name = "containment",
             .symbol = "containment",
             .help = "certified (facets proven inside the volume) or sampled (the paper to the letter)",
             .words = "how Z is kept inside Ω",
             .choices = parameter_words::containment,
             .place = 11,
             .title = "Containment of Z in Ω",
             .tip = "Certified: every facet of Z is proven inside Ω; a coarse S suffices. Sampled: the paper "
                    "to the letter, dense S and condition 2. Needs a restart."}),
      field(&P::topology,
            {.name = "topology",
             .symbol = "topology",
             .help = "keep (the input's) or separate (only the sides)",
             .words = "what is asked of Z where Ω is no thickening",
             .choices = parameter_words::topology,
             .place = 12,
             .title = "Topology mode",
             .tip = "What is asked of Z where Ω is no thickening of a surface: keep the input's topology, or "
                    "only separate the two sides. Needs a restart. §1.2"}),
      field(&P::start,
            {.name = "start",
             .symbol = "start",
             .help = "the first Z: delaunay (refined, the paper's way), input (the input itself, where it is "
                     "closed and does not meet itself) or lattice (from sides on a lattice of 0.95 δ, where "
                     "every point has one); after both the improver alone runs; default delaunay",
             .words = "where the first Z comes from",
             .choices = parameter_words::start,
             .place = 10,
             .title = "The first Z",
             .tip = "Refined in T, the paper's way; the input itself, where it is closed and does not meet "
                    "itself; or from sides on a lattice. Without refinement there is no T, and the improver "
                    "goes on from there at once. Needs a restart."}),
      field(&P::drop_thin,
            {.name = "drop_thin",
             .symbol = "thin parts",
             .help = "leave out parts of the input that are thinner than twice the tolerance everywhere, and "
                     "say so; without it they are refused",
             .words = "parts thinner than twice the tolerance everywhere are left out",
             .choices = parameter_words::drop_thin,
             .place = 13,
             .title = "Parts thinner than 2δ",
             .tip = "Of a part that is thinner than 2δ everywhere Ω leaves no inside that Z could enclose: "
                    "the input is refused, or the part is left out and named. Needs a restart."}),
      field(&P::cover,
            {.name = "cover",
             .symbol = "cover",
             .unit = " δ",
             .help =
                 "how far from the result a point of the input may be, in δ, or off; from 2 on points are "
                 "held in walls and gaps thinner than 2 δ; default 3",
             .words = "how far the input may be from the result, in δ, or off",
             .range = {.low = 0,
                       .high = infinity,
                       .low_included = false,
                       .wrong = "not above 0",
                       .remedy = "It is in δ; off takes the limit away."},
             .unreadable = "neither a positive number nor off",
             .unreadable_remedy =
                 "It is in δ: 3 lets no point of the input be farther than 3 δ from the result.",
             .absent = "off",
             .place = 14,
             .title = "Cover",
             .tip =
                 "How far from the finished mesh a point of the input may be, in δ. From 2 on the refinement "
                 "goes into walls and gaps thinner than 2δ, of which Ω leaves nothing, and Z keeps points "
                 "there. Off: as far as it likes, as in the paper. Needs a restart."}),
      field(&P::robust,
            {.name = "robust",
             .symbol = "robust k",
             .help = "neighbours that each point is averaged with, so that noise evens out and outliers "
                     "vanish: a number, auto (12, or 40 with many outliers) or off; a number for triangles "
                     "takes a sample of their area as points; default auto: points alone",
             .words = "neighbours that each point is averaged with, auto or off",
             .range = {.low = 0, .high = 1000},
             .unreadable = "no whole number from 2 to 1000, auto or off",
             .unreadable_remedy = "12 suits noise, 40 more than a twentieth of outliers.",
             .place = 6,
             .title = "Robust distance",
             .tip = "k of the distance to points: each is averaged with its k nearest, which evens out noise "
                    "and lets outliers vanish. Auto: 12, or 40 where more than 5 % of the points are "
                    "outliers. Off: the plain distance. For triangles a number takes a sample of their area "
                    "as points. Needs a restart."}),
      field(&P::gamma,
            {.name = "gamma",
             .symbol = "γ",
             .help = "γ of points of an open surface, from 1.2 to 8: where the samples in a ball of γδ' "
                     "around a point hang together, the surface ends; auto: 2, or less where sheets are "
                     "narrow, for points that enclose nothing at any tolerance; a number is for loose "
                     "triangles too; off: such input is refused; default auto",
             .words = "γ, radius in δ' of the balls that find where points end, auto or off",
             .range = {.low = 1.2,
                       .high = 8,
                       .remedy = "2 suits most; less where sheets are narrow, more where they are uneven."},
             .unreadable = "no number, auto or off",
             .unreadable_remedy = "2 suits most; auto leaves points that enclose something closed.",
             .place = 9,
             .title = "Ball test γ",
             .tip = "Of points of an open surface: where the samples in a ball of γδ' around a point hang "
                    "together, the surface ends, and they are the boundary samples B. Auto: 2, or less "
                    "where sheets are narrow, for points that enclose nothing at any tolerance. A number is "
                    "for triangles that are not joined too. Off: such input is refused. Needs a restart. "
                    "§4.1",
             .counted_in = " δ'"}),
      field(&P::sides,
            {.name = "sides",
             .symbol = "sides",
             .help = "what tells inside from outside: auto (parity; where closed parts meet, the winding "
                     "number; several insides where walls are shared), winding, parity, or multi (every "
                     "region is an inside of its own; of a grid all labels)",
             .words = "what tells inside from outside",
             .choices = parameter_words::sides,
             .place = 15,
             .title = "What tells inside from outside",
             .tip = "Auto: parity where closed parts do not meet, and the winding number where they overlap "
                    "or touch, so that what lies in several parts is inside. Multi: every region that walls "
                    "enclose is an inside of its own, §4.2. Needs a restart."}),
      field(&P::fill,
            {.name = "fill",
             .symbol = "filled holes",
             .help = "holes of an open surface that are closed, outside of Ω by intent, between the vertices "
                     "of their borders or with what Z has there inside T: none, all, flat, or numbers of the "
                     "loops that the report lists (1,3)",
             .words = "holes of an open surface that are filled: none, all, flat or numbers of loops",
             .unreadable = "not none, all, flat or numbers of loops",
             .unreadable_remedy = "Loops are numbered from 1 on, as the report lists them: 1,3.",
             .place = 8,
             .title = "Holes to be filled",
             .tip =
                 "Holes of an open surface that are closed, between the vertices of their borders or with "
                 "what Z has there inside T: none, all, those in a plane, or by the numbers of their loops, "
                 "as 1,3. What fills lies outside of Ω by intent. Needs a restart. §4.1"}),
      field(&P::conditions, {.name = "conditions",
                             .option = "--no-condition",
                             .symbol = "conditions",
                             .help = "switch a condition of the refinement off: 1, 2, 3 or 4; repeatable",
                             .words = "a condition of the refinement",
                             .prefix = "condition-",
                             .choices = parameter_words::conditions,
                             .numbered = true,
                             .restart = false,
                             .place = 31,
                             .title = "Condition "}),
      field(&P::skipped, {.name = "skip",
                          .symbol = "skipped",
                          .help = "a stage to leave out: gamma, zero-set, all or improve; repeatable",
                          .words = "the stage is left out",
                          .prefix = "skip.",
                          .choices = parameter_words::skipped,
                          .place = 17,
                          .label = "stages",
                          .title = "Stages",
                          .tip = "Those struck through are left out. Needs a restart."}),
      field(&P::target,
            {.name = "target",
             .symbol = "target",
             .help = "how targets of collapses are found: optimum, constraints, sampling or octree (the "
                     "paper's); default constraints, sampled mode sampling",
             .words = "how targets of collapses are looked for",
             .choices = parameter_words::target,
             .place = 18,
             .title = "Target strategy",
             .tip = "How the target of a collapse is looked for in its kernel: the least error alone, again "
                    "under learnt half-spaces, also by points drawn in the kernel, or by the paper's octree "
                    "with invalid regions Ψ. Needs a restart. §2.4, Figures 9 and 12"}),
      field(&P::cost_ring,
            {.name = "cost_ring",
             .symbol = "error over",
             .help = "facets whose planes make the error of a collapse: 1 or 2 rings; default 1",
             .words = "whose planes make the error of a collapse",
             .choices = parameter_words::cost_ring,
             .numbered = true,
             .place = 19,
             .title = "Ring of the error",
             .tip = "Facets of Z whose planes make the error of a collapse; the paper takes two rings. Needs "
                    "a restart. §2.4"}),
      field(&P::effort,
            {.name = "effort",
             .symbol = "effort",
             .help = "of the improver: 0 (least) to 3, which goes on with ever fewer vertices until the time "
                     "limit or Ctrl-C; default 2",
             .words = "of the improver, 0 to 3",
             .choices = parameter_words::effort,
             .range = {.low = 0,
                       .high = 3,
                       .wrong = "not 0, 1, 2 or 3",
                       .remedy = "2 is the default; 3 goes on until it is stopped."},
             .place = 20,
             .title = "Effort of the improver",
             .tip = "0 to 2: more rounds of relocation and repair for fewer vertices; 3 goes on until it is "
                    "stopped. Needs a restart."}),
      field(
          &P::improver,
          {.name = "improver",
           .symbol = "improver",
           .help = "where it works: free (Z leaves T, fewest vertices) or embedded (inside T); default free",
           .words = "on Z alone or inside T",
           .choices = parameter_words::improver,
           .place = 21,
           .title = "Where the improver works",
           .tip = "On Z alone it gets by with fewer vertices; inside T every step keeps the embedding, "
                  "which is the proof where Ω is no thickening. Needs a restart."}),
      field(&P::drop_small,
            {.name = "drop_small",
             .symbol = "drop small",
             .unit = " δ",
             .help = "leave out connected components of the input whose box is smaller than so many δ; "
                     "default 0: none",
             .words = "components of the input smaller than so many δ are left out; 0: none",
             .range = {.low = 0,
                       .high = 1e6,
                       .remedy = "It is in δ: 4 leaves out parts with a box smaller than 4 δ; 0 leaves out "
                                 "none."},
             .place = 5,
             .title = "Small parts of the input",
             .tip = "Connected components of the input whose bounding box is smaller than so many δ are left "
                    "out; 0 leaves out none. Needs a restart."}),
      field(&P::threads,
            {.name = "threads",
             .symbol = "threads",
             .help = "number of threads, 0 for all cores; the result does not depend on it",
             .words = "number of threads, 0 for all cores",
             .range = {.low = 0, .high = 1024, .wrong = "more than 1024", .remedy = "0 takes all cores."},
             .journal = none}),
      field(&P::time_limit, {.name = "time_limit",
                             .symbol = "time limit",
                             .unit = " s",
                             .help = "seconds after which the run stops with what it has; 0: none",
                             .words = "seconds after which a run stops; 0: none",
                             .range = {.low = 0,
                                       .high = infinity,
                                       .wrong = "no time",
                                       .remedy = "Give seconds, at least 0; 0 means none."},
                             .journal = end}),
      field(&P::memory_limit,
            {.name = "memory_limit",
             .symbol = "memory limit",
             .unit = " MiB",
             .help = "MiB that the volume and its samples may take, foreseen before they are made; 0, the "
                     "default: two thirds of the machine's memory",
             .words = "MiB that the volume and its samples may take; 0: two thirds of the memory",
             .range = {.low = 0,
                       .high = infinity,
                       .wrong = "no size",
                       .remedy = "Give MiB, at least 0; 0 means two thirds of the machine's memory."},
             .journal = end}),
      field(&P::until,
            {.name = "until",
             .symbol = "until",
             .help = "the last stage to run: refinement, gamma, tessellation, rim (of open surfaces), "
                     "zero-set, all or improve; default improve, sampled mode all",
             .words = "the last stage; default: improve in certified mode, all in sampled mode",
             .choices = parameter_words::until,
             .absent = "default",
             .place = 16,
             .title = "The last stage",
             .tip = "Where the run ends: a valid mesh is there after every stage. Needs a restart."},
            [](const P& p) { return std::optional(p.last_stage()); }),
  };
}

/// The word of a choice: "embedded".
template <class T> std::string_view word_of(T RunParameters::*member, const RunParameters& p) {
  return field_choice(field_of(member), p.*member).name;
}
/// Checks every range; the error names the option, the value and the range.
Status check(const RunParameters& parameters);

/// What a run that goes on takes of a change.
struct LiveChange {
  std::string symbol; ///< "α", "condition 2"
  std::string was, is;
  Stage until = Stage::all; ///< the last stage that asks for it
};
/// The live parameters that differ; σ as it is in force, by default `default_sigma` times δ.
std::vector<LiveChange> live_changes(const RunParameters& from, const RunParameters& to,
                                     double default_sigma);

} // namespace isoscope
