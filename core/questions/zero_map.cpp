// Polygons are cut into triangles, and these into congruent pieces, kites around their corners, or left
// whole.
#include "questions/zero_map.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace isoscope {
namespace {

constexpr double wanted_pieces = 30000;

/// A triangle of a polygon and which of its edges are the polygon's.
struct Part {
  Triangle3 corners;
  std::array<std::uint32_t, 3> vertices; ///< of Z
  std::uint8_t edges = 7;
};

std::vector<Part> parts_of(const ZeroSet& zero, const ZeroSet::Polygon& polygon) {
  const auto part = [&](std::size_t a, std::size_t b, std::size_t c, std::uint8_t edges) {
    const std::array<std::uint32_t, 3> v{polygon.v[a], polygon.v[b], polygon.v[c]};
    return Part{
        {zero.vertices[v[0]].position, zero.vertices[v[1]].position, zero.vertices[v[2]].position}, v, edges};
  };
  if (polygon.count == 3) return {part(0, 1, 2, 7)};
  return {part(0, 1, 2, 7 & ~2), part(0, 2, 3, 7 & ~4)}; // without the diagonal between 0 and 2
}

/// The k² congruent pieces of a triangle.
void add_pieces(const Part& part, std::size_t k, std::vector<ZeroMap::Piece>& out) {
  const auto n = static_cast<double>(k);
  const auto at = [&](std::size_t u, std::size_t v) {
    return part.corners[0] + static_cast<double>(u) / n * (part.corners[1] - part.corners[0]) +
           static_cast<double>(v) / n * (part.corners[2] - part.corners[0]);
  };
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = 0; i + j < k; ++j) {
      const unsigned on_rim = (i + j + 1 == k ? 1u : 0u) | (i == 0 ? 2u : 0u) | (j == 0 ? 4u : 0u);
      out.push_back(
          {{at(i, j), at(i + 1, j), at(i, j + 1)}, 0, static_cast<std::uint8_t>(on_rim & part.edges)});
      if (i + j + 1 < k) out.push_back({{at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)}, 0, 0});
    }
}

/// A kite around each corner, in two triangles.
void add_kites(const Part& part, const std::vector<std::uint32_t>& valence,
               std::vector<ZeroMap::Piece>& out) {
  const Triangle3& t = part.corners;
  const Vec3 middle = centroid(t);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto value = static_cast<float>(valence[part.vertices[i]]);
    // The edge i–j lies opposite k, the edge i–k opposite j.
    const bool to_j = (part.edges >> k & 1u) != 0, to_k = (part.edges >> j & 1u) != 0;
    out.push_back({{t[i], 0.5 * (t[i] + t[j]), middle}, value, std::uint8_t(to_j ? 4 : 0)});
    out.push_back({{t[i], middle, 0.5 * (t[i] + t[k])}, value, std::uint8_t(to_k ? 2 : 0)});
  }
}

std::vector<std::uint32_t> valences(const ZeroSet& zero) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ZeroSet::Polygon& p : zero.polygons)
    for (std::size_t i = 0; i < p.count; ++i) edges.insert(std::minmax(p.v[i], p.v[(i + 1) % p.count]));
  std::vector<std::uint32_t> counts(zero.vertices.size(), 0);
  for (const auto& [a, b] : edges) ++counts[a], ++counts[b];
  return counts;
}

/// Steps since the cell of each polygon was made; of those that were there from the beginning all steps.
/// Nothing once it is cancelled.
std::optional<std::vector<float>> ages(const StateSnapshot& state, const Journal& journal,
                                       const RunControl& control) {
  const bool free = state.complex.form == ZeroForm::free;
  const auto slot = [&](const ZeroSet::Polygon& p) { return free ? p.facet.index() : p.tet.index(); };
  std::vector<std::int64_t> made(free ? state.complex.facets.size() : state.complex.tets.size(), -1);
  std::vector<std::uint8_t> wanted(made.size(), 0);
  for (const ZeroSet::Polygon& p : state.zero_set.polygons) wanted[slot(p)] = 1;
  auto left = static_cast<std::size_t>(std::count(wanted.begin(), wanted.end(), 1));
  const auto note = [&](std::size_t index, Step at) {
    if (index >= made.size() || wanted[index] == 0 || made[index] >= 0) return;
    made[index] = at;
    --left;
  };
  for (Step k = std::min(state.step, journal.steps()); k > 0 && left > 0; --k) {
    if (control.cancelled()) return std::nullopt;
    const Delta delta = journal.operations()[k - 1].delta();
    if (free)
      for (const FacetRecord& f : delta.added_facets) note(f.id.index(), k);
    else
      for (const TetRecord& t : delta.added) note(t.id.index(), k);
  }
  std::vector<float> out;
  for (const ZeroSet::Polygon& p : state.zero_set.polygons)
    out.push_back(
        static_cast<float>(static_cast<std::int64_t>(state.step) - std::max<std::int64_t>(made[slot(p)], 0)));
  return out;
}

/// Cuts every polygon into so many pieces that there are about as many as wanted, by area.
void cut_evenly(const ZeroSet& zero, ZeroMap& map) {
  double whole = 0;
  for (const ZeroSet::Polygon& polygon : zero.polygons)
    for (const Part& part : parts_of(zero, polygon)) whole += area(part.corners);
  for (const ZeroSet::Polygon& polygon : zero.polygons) {
    map.begin.push_back(static_cast<std::uint32_t>(map.pieces.size()));
    for (const Part& part : parts_of(zero, polygon)) {
      const double share = whole > 0 ? area(part.corners) / whole : 0;
      const double k = std::ceil(std::sqrt(wanted_pieces * share));
      add_pieces(part, static_cast<std::size_t>(std::clamp(k, 1.0, 64.0)), map.pieces);
    }
  }
}

bool measure(const Scene& scene, ZeroMap& map, const RunControl& control) {
  const double delta = scene.delta > 0 ? scene.delta : 1;
  const ClosestPointIndex* const surface = scene.field->surface();
  const bool angles = map.kind == ZeroMapKind::normals;
  return parallel_until(map.pieces.size(), 64, control, [&](std::size_t i) {
    ZeroMap::Piece& piece = map.pieces[i];
    const Vec3 middle = centroid(piece.corners);
    if (!angles) {
      piece.value = static_cast<float>(scene.field->distance(middle) / delta);
      return;
    }
    const Vec3 own = normalized(area_vector(piece.corners)),
               other = normalized(area_vector(surface->triangle(surface->closest(middle).triangle)));
    piece.value = static_cast<float>(std::atan2(length(cross(own, other)), std::abs(dot(own, other))) * 180 /
                                     std::numbers::pi);
  });
}

/// What the colours span, and what is said of the values.
void summarize(ZeroMap& map) {
  double whole = 0, sum = 0;
  map.least = map.pieces.empty() ? 0 : map.pieces[0].value;
  for (const ZeroMap::Piece& piece : map.pieces) {
    const double a = area(piece.corners);
    whole += a;
    sum += a * static_cast<double>(piece.value);
    map.least = std::min(map.least, piece.value);
    map.largest = std::max(map.largest, piece.value);
  }
  map.mean = static_cast<float>(whole > 0 ? sum / whole : 0);
  constexpr float least_angle = 30, few = 3, many = 9;
  switch (map.kind) {
  case ZeroMapKind::distance:
    map.limit = 1.0f;
    map.high = std::max(1.0f, map.largest);
    break;
  case ZeroMapKind::normals:
    map.high = std::clamp(5 * std::ceil(map.largest / 5), least_angle, 90.0f);
    break;
  case ZeroMapKind::valence:
    map.low = few;
    map.high = std::max(many, map.largest);
    break;
  case ZeroMapKind::age:
    map.high = std::max(1.0f, map.largest);
    break;
  case ZeroMapKind::none:
    break;
  }
}

} // namespace

std::optional<ZeroMap> zero_map(const StateSnapshot& state, const Scene& scene, const Journal& journal,
                                ZeroMapKind kind, const RunControl& control) {
  const ZeroSet& zero = state.zero_set;
  ZeroMap map;
  map.kind = kind;
  switch (kind) {
  case ZeroMapKind::none:
    return std::nullopt;
  case ZeroMapKind::distance:
  case ZeroMapKind::normals:
    if (!scene.field || (kind == ZeroMapKind::normals && scene.field->surface() == nullptr))
      return std::nullopt;
    cut_evenly(zero, map);
    if (!measure(scene, map, control)) return std::nullopt;
    break;
  case ZeroMapKind::valence: {
    const std::vector<std::uint32_t> counts = valences(zero);
    for (const ZeroSet::Polygon& polygon : zero.polygons) {
      map.begin.push_back(static_cast<std::uint32_t>(map.pieces.size()));
      for (const Part& part : parts_of(zero, polygon)) add_kites(part, counts, map.pieces);
    }
    break;
  }
  case ZeroMapKind::age: {
    const auto values = ages(state, journal, control);
    if (!values) return std::nullopt;
    for (std::size_t i = 0; i < zero.polygons.size(); ++i) {
      map.begin.push_back(static_cast<std::uint32_t>(map.pieces.size()));
      for (const Part& part : parts_of(zero, zero.polygons[i]))
        map.pieces.push_back({part.corners, (*values)[i], part.edges});
    }
    break;
  }
  }
  map.begin.push_back(static_cast<std::uint32_t>(map.pieces.size()));
  summarize(map);
  return map;
}

} // namespace isoscope
