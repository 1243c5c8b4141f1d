// Boundary components belong to the component of Z nearest to most of their samples.
#include "questions/topology_report.h"

#include "base/numbers.h"
#include "base/parallel.h"

#include <algorithm>
#include <limits>

namespace isoscope {
namespace {

constexpr std::size_t voters = 48; ///< samples of a boundary component that are asked
constexpr std::uint32_t nobody = 0xffffffffu;

/// The component of each vertex of Z.
std::vector<std::uint32_t> components_of_vertices(const ZeroSet& z) {
  std::vector<std::uint32_t> component(z.vertices.size(), nobody);
  for (const ZeroSet::Polygon& p : z.polygons)
    for (std::uint8_t i = 0; i < p.count; ++i) component[p.v[i]] = p.component;
  return component;
}

/// For each boundary component the component of Z beside it, or nobody.
std::vector<std::uint32_t> beside(const ZeroSet& z, const BoundarySamples& samples, std::size_t boundaries) {
  const std::vector<std::uint32_t> component = components_of_vertices(z);
  std::vector<std::vector<std::uint32_t>> of_boundary(boundaries);
  for (std::size_t s = 0; s < samples.size(); ++s)
    if (samples.components[s] < boundaries)
      of_boundary[samples.components[s]].push_back(static_cast<std::uint32_t>(s));
  std::vector<std::uint32_t> out(boundaries, nobody);
  if (z.components.empty()) return out;
  parallel_for(boundaries, 1, [&](std::size_t b) {
    const auto& mine = of_boundary[b];
    const std::size_t asked = std::min(voters, mine.size());
    std::vector<std::size_t> votes(z.components.size(), 0);
    for (std::size_t i = 0; i < asked; ++i) {
      const Vec3 p = samples.positions[mine[i * mine.size() / asked]];
      double nearest = std::numeric_limits<double>::infinity();
      std::uint32_t found = nobody;
      for (std::size_t v = 0; v < z.vertices.size(); ++v) {
        const double d = squared_length(z.vertices[v].position - p);
        if (d < nearest && component[v] != nobody) nearest = d, found = component[v];
      }
      if (found != nobody) ++votes[found];
    }
    if (asked > 0)
      out[b] = static_cast<std::uint32_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  });
  return out;
}

std::optional<long> agreed_genus(const std::vector<BoundarySide>& sides) {
  if (sides.empty()) return std::nullopt;
  for (const BoundarySide& side : sides)
    if (side.euler_characteristic != sides[0].euler_characteristic) return std::nullopt;
  return sides[0].genus();
}

std::string words_of(const TopologyReport& r) {
  if (r.components.empty()) return "There is no Z yet.";
  std::string words;
  const std::string source = r.expected.source.empty() ? "" : " of " + r.expected.source;
  if (!r.expected.euler_characteristic && !r.expected.components) {
    words = "Z has " + std::to_string(r.verdict.components) +
            (r.verdict.components == 1 ? " component" : " components") +
            " and χ = " + std::to_string(r.verdict.euler_characteristic) + "; none is expected (" +
            r.expected.source + ").";
  } else if (r.verdict.as_expected) {
    words = (r.expected.boundary_loops ? "Components, χ and boundary loops of Z are those"
                                       : "Components and χ of Z are those") +
            source + ".";
  } else {
    words = "Z has " + counted(r.verdict.components, "component") +
            " and χ = " + std::to_string(r.verdict.euler_characteristic);
    if (r.expected.boundary_loops) words += " with " + counted(r.verdict.boundary_loops, "boundary loop");
    if (r.expected.components && r.expected.euler_characteristic)
      words += "; expected are " + std::to_string(*r.expected.components) + " and " +
               std::to_string(*r.expected.euler_characteristic) +
               (r.expected.boundary_loops ? " with " + counted(*r.expected.boundary_loops, "loop") : "") +
               ", those" + source;
    words += ".";
  }
  if (r.wrong_components > 0)
    words += " " + std::to_string(r.wrong_components) +
             (r.wrong_components == 1 ? " component has" : " components have") +
             " another topology than the boundaries beside.";
  if (!r.thickening)
    words += " The boundaries of Ω differ: Ω is no thickening of a surface, and the guarantee of §3 does not "
             "hold here.";
  return words;
}

} // namespace

TopologyReport report_topology(const StateSnapshot& state, const Scene& scene, std::size_t bases,
                               const RunControl& control) {
  TopologyReport report;
  report.expected = scene.expected;
  report.verdict = check_topology(state.zero_set, scene.expected);
  report.thickening = scene.thickening_note.empty();
  report.components.resize(state.zero_set.components.size());
  for (std::size_t c = 0; c < report.components.size(); ++c)
    report.components[c].counts = state.zero_set.components[c];
  const auto& samples = state.samples ? state.samples : scene.samples;
  if (samples) {
    const auto of = beside(state.zero_set, *samples, scene.boundary_components.size());
    for (std::size_t b = 0; b < of.size(); ++b)
      if (of[b] != nobody)
        report.components[of[b]].sides.push_back({static_cast<std::uint32_t>(b),
                                                  scene.boundary_components[b].label,
                                                  scene.boundary_components[b].euler_characteristic});
  }
  const bool rooms = scene.volume != nullptr && scene.volume->has_rooms();
  for (std::size_t c = 0; c < report.components.size(); ++c) {
    ComponentReport& component = report.components[c];
    if (rooms) {
      long sum = 0;
      for (const BoundarySide& side : component.sides)
        if (!scene.regions[scene.boundary_components[side.boundary].region.index()].shallow)
          sum += side.euler_characteristic;
      component.expected_characteristic = sum / 2;
    } else {
      component.expected_genus = agreed_genus(component.sides);
    }
    report.wrong_components += !component.as_expected();
    if (!rooms && component.counts.euler_characteristic() < 2 && !control.cancelled())
      component.loop = shortest_handle_loop(state.zero_set, static_cast<std::uint32_t>(c), bases, control);
  }
  report.words = words_of(report);
  return report;
}

} // namespace isoscope
