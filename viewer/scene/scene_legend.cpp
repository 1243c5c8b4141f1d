// Layer by layer; what is shown but not there is left out.
#include "scene/scene_legend.h"

#include "scene/input_points.h"
#include "scene/meanings.h"
#include "scene/octree_fates.h"
#include "scene/tet_visibility.h"

#include <algorithm>

namespace isoscope {
namespace {

/// What the edge at hand was judged by.
void add_xray(std::vector<LegendEntry>& out, const EdgeXray& xray, const ViewSettings& view,
              const SceneColors& colors) {
  using Sign = LegendEntry::Sign;
  using namespace meaning_color;
  const CollapseAttempt& attempt = xray.attempt;
  const auto put = [&](bool shown, Sign sign, glm::vec3 color, std::string words) {
    if (shown) out.push_back({sign, color, std::move(words)});
  };
  put(true, Sign::line, colors.selection, "the edge at hand");
  const bool empty = attempt.kernel && attempt.kernel->empty;
  put(!empty && !xray.kernel.faces.empty(), Sign::surface, rgb(kernel), "its kernel");
  put(empty, Sign::line, rgb(kernel), "half-spaces without a common point");
  put(view.invalid_regions && !xray.invalid.empty(), Sign::surface, rgb(invalid), "Ψ: targets known to fail");
  if (view.octree_cells) {
    std::array<bool, fate_count> seen{};
    for (const OctreeCell& cell : attempt.cells) seen.at(static_cast<std::size_t>(cell.fate)) = true;
    for (std::size_t i = 0; i < fate_count; ++i) {
      const auto fate = static_cast<OctreeCell::Fate>(i);
      put(seen.at(i) && fate != OctreeCell::Fate::split, Sign::square, rgb(fate_style(fate).color),
          "octree cell: " + std::string(fate_style(fate).title));
    }
  }
  const auto refused = std::find_if(attempt.candidates.begin(), attempt.candidates.end(),
                                    [](const CandidateRecord& c) { return c.rejected != Reason::none; });
  put(refused != attempt.candidates.end(), Sign::cross,
      refused != attempt.candidates.end() ? rgb(words(refused->rejected).color) : colors.bad,
      "candidate refused, by its reason");
  put(attempt.kernel && !empty, Sign::diamond, colors.accent, "optimum of the error");
  put(attempt.possible(), Sign::disc, colors.good, "target");
  put(!attempt.link.holds(), Sign::line, rgb(offender), "breaks the link condition");
}

} // namespace

std::vector<LegendEntry> scene_legend(const StateSnapshot& state, const ViewSettings& view, bool section,
                                      const LegendScene& scene) {
  using Sign = LegendEntry::Sign;
  const SceneColors c = scene_colors(view.theme);
  std::vector<LegendEntry> out;
  const auto put = [&](bool shown, Sign sign, glm::vec3 color, const char* words) {
    if (shown) out.push_back({sign, color, words});
  };
  put(view.zero_set.shown() && !state.zero_set.polygons.empty() && view.zero_map == ZeroMapKind::none,
      section ? Sign::line : Sign::surface, section ? c.section_zero : c.zero_set, "Z, the mesh");
  put(view.outer.shown(), Sign::surface, c.outer, "outer boundary of Ω");
  put(view.inner.shown(), Sign::surface, c.inner, "inner boundary of Ω");
  if (scene.xray && view.xray.shown()) add_xray(out, *scene.xray, view, c);
  const bool samples = view.samples.shown() && state.samples != nullptr;
  const bool classified = state.classifies();
  put(samples && view.bad_samples.shown() && state.bad_samples > 0, Sign::cross, c.bad, "bad sample");
  put(samples && view.good_samples.shown(), Sign::disc, classified ? c.good : c.tetrahedron,
      classified ? "good sample, outside" : "sample");
  put(samples && view.good_samples.shown() && classified, Sign::ring, c.good, "good sample, inside");
  put(samples && view.over_rim.shown() && !state.samples->over_rim.empty(), Sign::diamond, c.rim,
      "sample over the rim");
  if (view.tetrahedra.shown() && !section) {
    std::array<bool, 6> seen{};
    for_each_visible_tet(state, view.tets, Clip(view.clip),
                         [&](TetId, TetRole role) { seen.at(static_cast<std::size_t>(role)) = true; });
    const auto role = [&](TetRole r) { return seen.at(static_cast<std::size_t>(r)); };
    put(role(TetRole::violates_1), Sign::cell, c.bad, "violates condition 1");
    put(role(TetRole::violates_2), Sign::cell, c.warning, "violates condition 2: too flat");
    put(role(TetRole::violates_3), Sign::cell, c.misoriented, "violates condition 3: misoriented");
    put(role(TetRole::changed), Sign::cell, c.accent, "changed last");
  }
  put(view.tetrahedra.shown() && section, Sign::line, c.section_line, "T");
  put(view.gamma.shown() && !state.gamma.empty(), Sign::line, c.gamma, "∂Γ");
  put(view.other_zero.shown(), Sign::line, c.other_zero, "Z of the other run");
  put(view.rim.shown() && scene.rim, Sign::line, c.rim, "rim of the input");
  put(view.highlight.shown() && state.event.has_value() && !section, Sign::dashed, c.accent,
      "taken away by the operation");
  put(view.points.shown() && scene.points && !section, Sign::disc, weight_color(view.theme, 0.5f),
      "point of the input, by its weight");
  put(view.points.shown() && scene.points && !section, Sign::cross, c.dropped, "point left out");
  put(view.input.shown() && !section, Sign::surface, c.input, "input");
  return out;
}

} // namespace isoscope
