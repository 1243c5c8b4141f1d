// Dropped facets joined across their edges; an edge that only one of them has is where Z goes on.
#include "simplify/hole_filling.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <system_error>

namespace isoscope {
namespace {

using Edge = std::array<VertexId, 2>;

struct EdgeOfFacet {
  Edge edge;
  std::uint32_t facet;
  friend auto operator<=>(const EdgeOfFacet&, const EdgeOfFacet&) = default;
};

std::array<VertexId, 3> sorted_corners(const Complex& complex, const DroppedFacet& f) {
  return sorted(complex.tet(f.tet).facet(f.facet));
}

} // namespace

bool HoleChoice::wants(std::uint32_t loop, const RimLoop& description) const {
  switch (rule) {
  case Rule::none:
    return false;
  case Rule::flat:
    return description.flatness <= flat;
  case Rule::all:
    return true;
  case Rule::listed:
    return std::binary_search(loops.begin(), loops.end(), loop);
  }
  return false;
}

std::vector<Cap> find_caps(const Complex& complex, const ToleranceVolume& volume) {
  const std::vector<DroppedFacet> facets = dropped_facets(complex);
  std::vector<EdgeOfFacet> edges;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const auto v = sorted_corners(complex, facets[f]);
    for (const Edge& e : {Edge{v[0], v[1]}, Edge{v[0], v[2]}, Edge{v[1], v[2]}}) edges.push_back({e, f});
  }
  std::sort(edges.begin(), edges.end());
  DisjointSets sets(facets.size());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].edge == edges[i - 1].edge) sets.unite(edges[i].facet, edges[i - 1].facet);

  std::map<std::uint32_t, std::size_t> numbers;
  std::vector<Cap> caps;
  std::vector<std::vector<VertexId>> corners;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const auto [at, fresh] = numbers.emplace(sets.find(f), caps.size());
    if (fresh) caps.emplace_back(), corners.emplace_back();
    caps[at->second].facets.push_back(facets[f]);
    const auto v = sorted_corners(complex, facets[f]);
    corners[at->second].insert(corners[at->second].end(), v.begin(), v.end());
  }
  const Rim& rim = volume.open_sides()->rim();
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].edge == edges[i].edge) ++end;
    Cap& cap = caps[numbers.at(sets.find(edges[i].facet))];
    --cap.euler_characteristic;
    if (end - i > 1) continue;
    const Vec3 middle = 0.5 * (complex.position(edges[i].edge[0]) + complex.position(edges[i].edge[1]));
    cap.loops.push_back(rim.loop_near(middle));
  }
  for (std::size_t c = 0; c < caps.size(); ++c) {
    sort_unique(corners[c]);
    sort_unique(caps[c].loops);
    caps[c].euler_characteristic += static_cast<long>(corners[c].size() + caps[c].facets.size());
  }
  return caps;
}

std::string loops_in_words(const std::vector<std::uint32_t>& loops) {
  std::string words = "loops";
  for (std::size_t i = 0; i < loops.size(); ++i)
    words += (i == 0 ? " " : ", ") + std::to_string(loops[i] + 1);
  return words;
}

std::vector<std::uint32_t> loops_in_words(std::string_view words) {
  std::vector<std::uint32_t> loops;
  for (auto at = words.find(' '); at != std::string_view::npos; at = words.find(' ', at + 1)) {
    std::uint32_t number = 0;
    const char* const end = words.data() + words.size();
    if (std::from_chars(words.data() + at + 1, end, number).ec == std::errc{} && number > 0)
      loops.push_back(number - 1);
  }
  sort_unique(loops);
  return loops;
}

Delta fill_delta(const Complex& complex, const std::vector<DroppedFacet>& facets) {
  std::map<TetId, std::uint8_t> after;
  const auto clear = [&](TetId t, std::size_t k) {
    const auto at = after.emplace(t, complex.tet(t).dropped).first;
    at->second = static_cast<std::uint8_t>(at->second & ~(1u << k));
  };
  for (const DroppedFacet& f : facets) {
    clear(f.tet, f.facet);
    const TetId n = complex.tet(f.tet).neighbor[f.facet];
    const auto& back = complex.tet(n).neighbor;
    clear(n, static_cast<std::size_t>(std::find(back.begin(), back.end(), f.tet) - back.begin()));
  }
  Delta delta;
  for (const auto& [tet, bits] : after) delta.dropped.push_back({tet, complex.tet(tet).dropped, bits});
  return delta;
}

} // namespace isoscope
