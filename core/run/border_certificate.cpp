// Branch and bound on the distance fields of two curves; crossings of short segments.
#include "run/border_certificate.h"

#include "base/disjoint_sets.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/place.h"
#include "base/sort_unique.h"
#include "run/proof_budget.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace isoscope {
namespace {

/// Triangles whose sides are asked for, how far beyond δ, and how far from the rim, in units of δ.
constexpr std::size_t most_segments = 4000;
constexpr double beyond = 1.05, off_rim = 3;

/// The distance from one curve to another, proven to be at most δ, or its worst place.
struct OneWay {
  double bound = 0;
  std::size_t failed = 0;
  Vec3 worst;
  bool complete = false;
};

OneWay one_way(std::span<const Segment3> segments, const ClosestPointIndex& to, double delta,
               const std::function<bool()>& stop) {
  std::vector<FacetVerdict> verdicts(segments.size());
  FacetSearch search;
  search.budget = proof_budget;
  search.stop = &stop;
  OneWay result;
  result.complete = parallel_until(segments.size(), 64, stop,
                                   [&](std::size_t i) {
                                     const auto& [a, b] = segments[i];
                                     verdicts[i] = certify_facet(to, {a, b, b}, delta, delta, search);
                                   }) &&
                    !stop();
  double worst = -1;
  for (const FacetVerdict& v : verdicts) {
    if (v.kind == FacetVerdict::Kind::inside) {
      result.bound = std::max(result.bound, v.max_distance);
      continue;
    }
    ++result.failed;
    const double d = to.distance(v.witness);
    if (d > worst) worst = d, result.worst = v.witness;
  }
  result.bound = std::max(result.bound, worst);
  return result;
}

/// From one side of a sheet of points to the other by a place of it, each end where φ is `level`.
Segment3 segment_beside(const ToleranceField& field, const OpenSides& sides, Vec3 p, double level) {
  Segment3 segment = sides.places_beside(p);
  for (Vec3& end : segment) end = field.at_level(end, field.closest(end), level).value_or(end);
  return segment;
}

TriangleMesh fillings(const TriangleMesh& mesh, const FilledHoles& holes) {
  TriangleMesh filling{mesh.points, {}};
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    if (holes.fills(f)) filling.triangles.push_back(mesh.triangles[f]);
  return filling;
}

/// The loops of the rim that are nearest to where facets that fill meet others.
std::vector<std::uint32_t> filled_loops(const TriangleMesh& mesh, const Rim& rim, const FilledHoles& holes) {
  std::vector<std::uint32_t> loops;
  if (holes.facets.empty()) return loops;
  for (const auto& [a, b] : border_edges(fillings(mesh, holes)))
    loops.push_back(rim.loop_near(0.5 * (mesh.points[a] + mesh.points[b])));
  sort_unique(loops);
  return loops;
}

/// The loops of the rim, but for some, that the border is nowhere near to: as words, empty where there are
/// none.
std::string bare_loops(const Rim& rim, const ClosestPointIndex& border, double delta,
                       std::span<const std::uint32_t> but) {
  std::vector<std::uint8_t> bare(rim.loops().size(), 1);
  for (const std::uint32_t loop : but) bare[loop] = 0;
  for (const RimPiece& piece : rim.pieces())
    if (piece.open && bare[piece.loop] != 0 && border.distance(piece.a) <= delta) bare[piece.loop] = 0;
  std::string numbers;
  for (std::size_t i = 0; i < bare.size(); ++i)
    if (bare[i] != 0) numbers += (numbers.empty() ? "" : ", ") + std::to_string(i + 1);
  if (numbers.empty()) return {};
  return " It is nowhere near to loop " + numbers + " of " + std::to_string(bare.size()) +
         ": what is narrower there than Ω is thick was closed or lost.";
}

} // namespace

FilledHoles filled_holes(const Journal& journal, Step step, const Complex& complex, const ZeroSet& zero_set) {
  FilledHoles holes;
  if (step == 0 || complex.form == ZeroForm::interpolated) return holes;
  const Operation& last = journal.operations()[step - 1];
  if (journal.events()[last.event].kind != EventKind::fill) return holes;
  std::vector<std::array<VertexId, 3>> filled;
  for (const Delta::DroppedChange& change : last.delta().dropped)
    for (std::size_t k = 0; k < 4; ++k)
      if (((change.before & ~change.after) >> k & 1) != 0)
        filled.push_back(sorted(complex.tet(change.tet).facet(k)));
  for (const FacetRecord& added : last.delta().added_facets) filled.push_back(sorted(added.v));
  sort_unique(filled);
  for (const ZeroSet::Polygon& p : zero_set.polygons) {
    const auto vertex = [&](std::size_t k) { return zero_set.vertices[p.v[k]].negative; };
    holes.facets.push_back(std::binary_search(filled.begin(), filled.end(),
                                              sorted(std::array{vertex(0), vertex(1), vertex(2)})));
  }
  return holes;
}

ExpectedTopology with_filled_holes(ExpectedTopology expected, const FilledHoles& holes,
                                   const TriangleMesh& mesh) {
  if (holes.facets.empty()) return expected;
  const std::size_t filled = count_loops(border_edges(fillings(mesh, holes)), mesh.points.size());
  if (expected.euler_characteristic) *expected.euler_characteristic += static_cast<long>(filled);
  if (expected.boundary_loops) *expected.boundary_loops -= std::min(*expected.boundary_loops, filled);
  return expected;
}

std::vector<std::array<std::uint32_t, 2>> border_edges(const TriangleMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> border;
  for (const EdgeUse& use : border_uses(mesh.triangles)) border.push_back({use.from(), use.to()});
  return border;
}

std::size_t count_loops(std::span<const std::array<std::uint32_t, 2>> border, std::size_t vertices) {
  DisjointSets sets(vertices);
  std::vector<std::uint8_t> on_border(vertices, 0);
  for (const auto& [a, b] : border) {
    sets.unite(a, b);
    on_border[a] = on_border[b] = 1;
  }
  std::size_t loops = 0;
  for (std::uint32_t v = 0; v < vertices; ++v) loops += on_border[v] != 0 && sets.find(v) == v;
  return loops;
}

std::optional<BorderProof> prove_border(const TriangleMesh& mesh, const ToleranceVolume& volume,
                                        const FilledHoles& holes, const std::function<bool()>& stop) {
  BorderProof proof;
  const double delta = volume.thresholds().delta;
  const Rim& rim = volume.open_sides()->rim();
  const std::vector<std::uint32_t> filled = filled_loops(mesh, rim, holes);
  std::vector<Segment3> border, open;
  for (const auto& [a, b] : border_edges(mesh)) border.push_back({mesh.points[a], mesh.points[b]});
  for (const RimPiece& piece : rim.pieces())
    if (piece.open && !std::binary_search(filled.begin(), filled.end(), piece.loop))
      open.push_back({piece.a, piece.b});
  if (border.empty() != open.empty()) {
    proof.failures.emplace_back(border.empty() ? "The mesh has no border, and the input has an open rim."
                                               : "The mesh has a border, and the input has no open rim.");
    return proof;
  }
  const auto judge = [&](const OneWay& way, const char* from, const char* to) {
    if (way.failed > 0)
      proof.failures.push_back(std::string(from) + " is " + general(way.bound / delta, 4) + " δ from " + to +
                               " at " + place(way.worst, proof_digits) + ".");
    return way.bound;
  };
  const OneWay to_rim = one_way(border, rim.curve(), delta, stop);
  if (!to_rim.complete) return std::nullopt;
  proof.to_rim = judge(to_rim, "The border of the mesh", "the open rim");
  const ClosestPointIndex mesh_border(flat_triangles(border));
  const OneWay from_rim = one_way(open, mesh_border, delta, stop);
  if (!from_rim.complete) return std::nullopt;
  proof.from_rim = judge(from_rim, "The open rim", "the border of the mesh");
  if (from_rim.failed > 0) proof.failures.back() += bare_loops(rim, mesh_border, delta, filled);
  return proof;
}

std::optional<std::string> unseparated_sheet(const TriangleMesh& mesh, const ToleranceVolume& volume,
                                             const std::function<bool()>& stop) {
  const ClosestPointIndex facets(TriangleSoup{mesh.points, mesh.triangles, {}});
  const ToleranceField& input = volume.field();
  const OpenSides& sides = *volume.open_sides();
  const double delta = volume.thresholds().delta;
  const std::size_t stride = input.size() / most_segments + 1, count = (input.size() + stride - 1) / stride;
  std::vector<std::uint8_t> unseparated(count, 0);
  const auto segment = [&](TriangleId t) {
    if (!volume.has_surface()) return segment_beside(input, sides, input.place_of(t), beyond * delta);
    const Triangle3& c = volume.index().triangle(t);
    const Vec3 n = beyond * delta * normalized(cross(c[1] - c[0], c[2] - c[0]));
    return Segment3{centroid(c) - n, centroid(c) + n};
  };
  const auto side = [&](Vec3 p) {
    const ClosestPoint closest = input.closest(p);
    return closest.distance() > delta && sides.is_open(closest.triangle) ? sides.side(p, closest) : 0;
  };
  const bool complete = parallel_until(count, 16, stop, [&](std::size_t i) {
    const TriangleId t(i * stride);
    if (!sides.is_open(t) || sides.rim().curve().distance(input.place_of(t)) < off_rim * delta) return;
    const auto [a, b] = segment(t);
    if (side(a) * side(b) >= 0) return;
    unseparated[i] = facets.crossings(a, b).size() % 2 == 0;
  });
  if (!complete || stop()) return std::nullopt;
  const auto first = std::find(unseparated.begin(), unseparated.end(), 1);
  if (first == unseparated.end()) return std::string();
  const auto n = static_cast<std::size_t>(std::count(first, unseparated.end(), 1));
  const TriangleId at(static_cast<std::size_t>(first - unseparated.begin()) * stride);
  return "The mesh does not lie between the two sides of the input at " +
         place(input.place_of(at), proof_digits) +
         (n == 1 ? "." : " and in " + counted(n - 1, "other place") + ".");
}

TriangleMesh closed_parts(const TriangleMesh& mesh, const FilledHoles& holes) {
  DisjointSets parts(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }
  std::vector<std::uint8_t> open(mesh.points.size(), 0);
  for (const auto& edge : border_edges(mesh)) open[parts.find(edge[0])] = 1;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    if (holes.fills(f)) open[parts.find(mesh.triangles[f][0])] = 1;
  TriangleMesh closed;
  closed.points = mesh.points;
  for (const auto& t : mesh.triangles)
    if (open[parts.find(t[0])] == 0) closed.triangles.push_back(t);
  return closed;
}

} // namespace isoscope
