// The border before a collapse, from what its delta removes.
#include "questions/loop_events.h"

#include "base/sort_unique.h"
#include "simplify/hole_filling.h"
#include "tolerance/rim.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace isoscope {
namespace {

/// Whether an edge that collapses has one facet of Z: the delta removes all at it.
bool is_of_border(const Delta& delta, VertexId a, VertexId b) {
  const auto has_edge = [&](const auto& v) {
    return std::find(v.begin(), v.end(), a) != v.end() && std::find(v.begin(), v.end(), b) != v.end();
  };
  std::size_t facets = 0;
  for (const FacetRecord& f : delta.removed_facets) facets += has_edge(f.v) ? 1u : 0u;
  // Of T each facet at the edge is one of two of its tetrahedra.
  std::map<std::array<VertexId, 3>, std::int8_t> first_sides;
  for (const TetRecord& t : delta.removed) {
    if (!has_edge(t.v)) continue;
    for (std::size_t i = 0; i < t.v.size(); ++i) {
      std::array<VertexId, 3> facet;
      for (std::size_t k = 0; k < 3; ++k) facet.at(k) = t.v.at(outward_facets.at(i).at(k));
      if ((t.dropped >> i & 1u) != 0 || !has_edge(facet)) continue;
      const auto [other, first] = first_sides.emplace(sorted(facet), t.side);
      facets += !first && other->second != t.side ? 1u : 0u;
    }
  }
  return facets == 1;
}

} // namespace

std::optional<LoopWork> loop_work(EventKind kind) {
  switch (kind) {
  case EventKind::split:
  case EventKind::cut:
    return LoopWork::cutting;
  case EventKind::collapse:
  case EventKind::repair:
    return LoopWork::simplifying;
  case EventKind::fill:
    return LoopWork::filling;
  default:
    return std::nullopt;
  }
}

std::vector<std::uint32_t> loops_touched(const Journal& journal, const Event& event, const Rim& rim) {
  const auto work = loop_work(event.kind);
  if (!work || !event.operation || rim.empty()) return {};
  if (work == LoopWork::filling) return loops_in_words(journal.texts()[event.text]);
  if (event.kind == EventKind::cut) {
    std::vector<std::uint32_t> all(rim.loops().size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  // Before the cut Z has no border.
  if (work == LoopWork::simplifying &&
      (!comes_after(event.stage, Stage::rim) ||
       !is_of_border(journal.operations()[event.step].delta(), event.vertex, event.other)))
    return {};
  return {rim.loop_near(event.point)};
}

} // namespace isoscope
