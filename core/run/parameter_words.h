// The words of parameters that are one of several: in files, in the window, in comparisons and in scripts.
#pragma once

#include "base/fields.h"
#include "journal/vocabulary.h"

#include <array>
#include <cstddef>

namespace isoscope::parameter_words {

inline constexpr std::array<Choice, 2> containment{{{"certified"}, {"sampled"}}};
inline constexpr std::array<Choice, 2> topology{{{"keep"}, {"separate"}}};
inline constexpr std::array<Choice, 4> sides{{{"auto"}, {"winding"}, {"parity"}, {"multi"}}};
inline constexpr std::array<Choice, 2> drop_thin{{{.name = "off", .shown = "refuse", .told = "refused"},
                                                  {.name = "on", .shown = "leave out", .told = "left out"}}};
inline constexpr std::array<Choice, 4> target{{{"optimum"}, {"constraints"}, {"sampling"}, {"octree"}}};
inline constexpr std::array<Choice, 2> cost_ring{
    {{.name = "1", .shown = "1-ring", .told = "1-ring", .script = "one"},
     {.name = "2", .shown = "2-ring", .told = "2-ring", .script = "two"}}};
inline constexpr std::array<Choice, 3> start{{{.name = "delaunay", .shown = "Delaunay"},
                                              {.name = "input", .shown = "the input"},
                                              {.name = "lattice"}}};
inline constexpr std::array<Choice, 2> improver{
    {{.name = "free", .shown = "Z alone"}, {.name = "embedded", .shown = "inside T"}}};
inline constexpr std::array<Choice, 4> effort{{{"0"}, {"1"}, {"2"}, {"3"}}};
inline constexpr std::array<Choice, 4> conditions{
    {{.name = "1",
      .shown = "1  classification",
      .words = "classification",
      .tip = "ε(s) ≤ 1 − α for every sample s: f classifies S with a margin. §2.3",
      .until = "refinement"},
     {.name = "2",
      .shown = "2  height",
      .words = "heights",
      .tip = "Every tetrahedron that carries Z is at least 2σ/α high. §2.3, Figure 5",
      .until = "refinement"},
     {.name = "3",
      .shown = "3  orientation",
      .words = "orientation",
      .tip = "The shrunk copy of a tetrahedron that carries Z classifies its nearest samples. §2.3, Figure 4",
      .until = "all"},
     {.name = "4",
      .shown = "4  topology",
      .words = "topology",
      .tip = "Z has the components and the genus that are expected. §2.3",
      .until = "refinement"}}};

/// The stages by name, those offered that a run may be asked for.
constexpr std::array<Choice, stage_count> stages(bool (*is_offered)(Stage)) {
  std::array<Choice, stage_count> all{};
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {.name = stage_table[i].name,
              .shown = stage_table[i].title,
              .offered = is_offered(stage_table[i].value)};
  return all;
}
inline constexpr auto until = stages([](Stage s) { return s != Stage::setup; });
inline constexpr auto skipped =
    stages([](Stage s) { return comes_after(s, Stage::tessellation) ? s != Stage::rim : s == Stage::gamma; });

} // namespace isoscope::parameter_words
