// Cuts border edges, asks what lies before each piece, and joins the open ones into loops.
#include "tolerance/rim.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "tolerance/sample_grid.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace isoscope {
namespace {

/// A border is open where the distance before it is that share of δ' at least.
constexpr double open_distance = 0.98;
/// Where the cosine of normals is below this, a sheet lies folded on the other.
constexpr double facing = facing_conormals;
/// The cosine from which on a normal counts as that of a wall across the way.
constexpr double across = 0.7;
/// How far beside a sheet the wall that it ends on is looked for, and how near to it that is, in units of
/// δ'.
constexpr double beside = 0.25, on_wall = 0.05;
/// The area of a needle, twice, relative to the square of its longest edge, is at most this.
constexpr double needle = 1e-10;
/// A loop shorter than that many δ' surrounds nothing that Ω leaves open.
constexpr double shortest_loop = 2;
/// Ends of the open rim this near to each other, in units of δ', are those of one loop: Ω closes what is
/// between them.
constexpr double gap = 2;
/// How near to a border a closest point is on it, in units of δ'.
constexpr double on_border = 1e-6;
constexpr double closeness = 1e-9;
/// What is folded back by that much is the end of a sheet whatever is in front of it, in units of δ'.
constexpr double least_flap = 0.25;

Vec3 conormal_of(const Triangle3& t, Vec3 a, Vec3 b) {
  return normalized(cross(b - a, cross(t[1] - t[0], t[2] - t[0])));
}

Vec3 normal_of(const ClosestPointIndex& index, TriangleId id) {
  const Triangle3& t = index.triangle(id);
  return normalized(cross(t[1] - t[0], t[2] - t[0]));
}

/// Whether the input goes on from a place of it to both sides along a direction, as a wall does that a sheet
/// ends on.
bool goes_on_aside(const ClosestPointIndex& index, Vec3 p, Vec3 direction, double boundary) {
  const Vec3 aside = beside * boundary * direction;
  return index.distance(p + aside) <= on_wall * boundary && index.distance(p - aside) <= on_wall * boundary;
}

/// Whether a triangle has no area to speak of, so that it only closes what its neighbours leave between them.
bool is_needle(const Triangle3& t) {
  const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  return length(cross(t[1] - t[0], t[2] - t[0])) <= needle * longest * longest;
}

/// What is joined to a triangle and faces as it does, as far as that matters.
class Flap {
 public:
  explicit Flap(const WeldedMesh& mesh) : mesh_(mesh), uses_(sorted_edge_uses(mesh.triangles)) {}

  /// How far it goes on from a place of its border against the conormal, up to `enough`.
  double depth(const ClosestPointIndex& index, const RimPiece& piece, double enough) const {
    const Vec3 from = 0.5 * (piece.a + piece.b), own = normal_of(index, piece.triangle);
    std::vector<std::uint32_t> found{static_cast<std::uint32_t>(piece.triangle.index())};
    double depth = 0;
    for (std::size_t i = 0; i < found.size() && depth < enough; ++i) {
      for (const Vec3 p : index.triangle(TriangleId(found[i])))
        depth = std::max(depth, dot(from - p, piece.conormal));
      for (std::size_t k = 0; k < 3; ++k)
        for (const std::uint32_t other : around(found[i], k))
          if (dot(normal_of(index, TriangleId(other)), own) > 0 &&
              std::find(found.begin(), found.end(), other) == found.end())
            found.push_back(other);
    }
    return depth;
  }

 private:
  const WeldedMesh& mesh_;
  std::vector<EdgeUse> uses_;

  /// The triangles at an edge of one, with itself.
  std::vector<std::uint32_t> around(std::uint32_t triangle, std::size_t k) const {
    const IndexTriangle& t = mesh_.triangles[triangle];
    const std::uint32_t low = std::min(t[k], t[(k + 1) % 3]), high = std::max(t[k], t[(k + 1) % 3]);
    auto use =
        std::lower_bound(uses_.begin(), uses_.end(), std::pair{low, high}, [](const EdgeUse& e, auto v) {
          return std::pair{e.low, e.high} < v;
        });
    std::vector<std::uint32_t> list;
    for (; use != uses_.end() && use->low == low && use->high == high; ++use) list.push_back(use->triangle);
    return list;
  }
};

} // namespace

Rim::Rim(const ClosestPointIndex& index, std::span<const std::uint8_t> wanted,
         std::span<const std::int8_t> turns, double boundary, const RunControl& control)
    : boundary_(boundary) {
  cut(index, wanted, turns, control);
  if (control.cancelled()) return;
  find_loops();
  describe_loops();
  build_curve();
}

Rim::Rim(std::span<const RimCurve> curves, const ToleranceField& field, double boundary)
    : boundary_(boundary) {
  std::uint32_t first = 0;
  for (const RimCurve& curve : curves) {
    const auto n = static_cast<std::uint32_t>(curve.corners.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t next = (i + 1) % n;
      const Vec3 a = curve.corners[i], b = curve.corners[next], along = normalized(b - a);
      const Vec3 away = curve.away[i] + curve.away[next];
      pieces_.push_back(
          {a, b, normalized(away - dot(away, along) * along), field.closest(0.5 * (a + b)).triangle, true});
      nodes_.push_back({first + i, first + next});
    }
    first += n;
  }
  find_loops();
  describe_loops();
  build_curve();
}

void Rim::cut(const ClosestPointIndex& index, std::span<const std::uint8_t> wanted,
              std::span<const std::int8_t> turns, const RunControl& control) {
  WeldedMesh mesh = weld(index);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (is_needle(index.triangle(TriangleId(t)))) mesh.triangles[t] = {};
  const std::vector<EdgeUse> edges = border_uses(mesh.triangles);
  if (edges.empty()) return;
  std::vector<Segment3> segments;
  std::vector<Vec3> conormals;
  for (const EdgeUse& e : edges) {
    const auto& [from, to] = segments.emplace_back(Segment3{mesh.points[e.from()], mesh.points[e.to()]});
    conormals.push_back(conormal_of(index.triangle(TriangleId(e.triangle)), from, to));
  }
  const ClosestPointIndex all(flat_triangles(segments)); // any border may be what lies before another one

  auto next_node = static_cast<std::uint32_t>(mesh.points.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const EdgeUse& e = edges[i];
    if (wanted[e.triangle] == 0) continue;
    const auto& [from, to] = segments[i];
    const auto n = static_cast<std::uint32_t>(
        std::max(1.0, std::ceil(distance(from, to) / (longest_border_piece * boundary_))));
    for (std::uint32_t k = 0; k < n; ++k) {
      const Vec3 a = from + (static_cast<double>(k) / n) * (to - from);
      const Vec3 b = k + 1 == n ? to : from + (static_cast<double>(k + 1) / n) * (to - from);
      pieces_.push_back({a, b, conormals[i], TriangleId(e.triangle)});
      nodes_.push_back({k == 0 ? e.from() : next_node++, k + 1 == n ? e.to() : next_node});
    }
  }

  const Flap flap(mesh);
  const auto judge = [&](RimPiece& piece) {
    if (piece.conormal == Vec3{}) return; // of a triangle without area
    const Vec3 before = 0.5 * (piece.a + piece.b) + boundary_ * piece.conormal;
    const ClosestPoint closest = index.closest_near(before, piece.triangle);
    const ClosestPoint border = all.closest(closest.point);
    const bool at_border = border.distance() <= on_border * boundary_;
    piece.open = closest.distance() >= open_distance * boundary_ ||
                 (at_border && dot(conormals[border.triangle.index()], piece.conormal) >= facing);
    const Vec3 normal = normal_of(index, closest.triangle), own = normal_of(index, piece.triangle);
    const bool same_way = turns.empty() || turns[closest.triangle.index()] == turns[piece.triangle.index()];
    if (!piece.open && (same_way ? 1 : -1) * dot(normal, own) < facing) {
      // The sheet ends at the fold, unless there is only a splinter that lies the wrong way round.
      const double width = flap.depth(index, piece, least_flap * boundary_);
      const Vec3 beyond = 0.5 * (piece.a + piece.b) - (width + boundary_) * piece.conormal;
      piece.open = width >= least_flap * boundary_ || index.distance(beyond) >= open_distance * boundary_;
    }
    piece.meets_wall =
        !piece.open && !at_border && std::abs(dot(normal, piece.conormal)) > across &&
        goes_on_aside(index, closest.point, 2 * normalized(own - dot(own, normal) * normal), boundary_);
    if (!piece.open || !goes_on_aside(index, 0.5 * (piece.a + piece.b), own, boundary_)) return;
    piece.open = false;
    piece.meets_wall = true;
  };
  parallel_until(pieces_.size(), 64, control, [&](std::size_t i) { judge(pieces_[i]); });
}

Rim Rim::opened(std::span<const std::uint8_t> more) const {
  Rim rim;
  rim.boundary_ = boundary_;
  rim.pieces_ = pieces_;
  rim.nodes_ = nodes_;
  for (std::size_t i = 0; i < more.size(); ++i)
    if (more[i] != 0) rim.pieces_[i].open = true;
  rim.find_loops();
  rim.describe_loops();
  rim.build_curve();
  return rim;
}

/// Ends of open stretches of the border that go on in each other across what Ω closes: first both ends of one
/// closed stretch, where they are near to each other, then others, the nearest pairs first.
std::vector<std::array<std::uint32_t, 2>> Rim::bridges(std::span<const LoneEnd> lone) const {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  if (lone.empty()) return pairs;
  DisjointSets stretches(pieces_.size()); // pieces in a row that are all open, or all closed
  std::array<std::map<std::uint32_t, std::uint32_t>, 2> at; // by whether it is open: by node, a piece
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    for (const std::uint32_t node : nodes_[i])
      stretches.unite(at[pieces_[i].open ? 1 : 0].emplace(node, i).first->second, i);
  std::vector<double> length(pieces_.size(), 0); // by stretch
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    length[stretches.find(i)] += distance(pieces_[i].a, pieces_[i].b);
  const auto stretch_of = [&](const LoneEnd& e) -> std::optional<std::uint32_t> {
    const auto closed = at[0].find(e.node);
    if (closed == at[0].end()) return std::nullopt;
    return stretches.find(closed->second);
  };
  using Link = std::tuple<bool, double, std::uint32_t, std::uint32_t>;
  std::vector<Link> links;
  SampleGrid grid(lone.front().point, gap * boundary_);
  for (const LoneEnd& e : lone) grid.add(e.point);
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < lone.size(); ++i) {
    near.clear();
    grid.gather(Box3{lone[i].point, lone[i].point}.grown(gap * boundary_), near);
    const auto own = stretch_of(lone[i]);
    for (const std::uint32_t j : near) {
      const double d = distance(lone[i].point, lone[j].point);
      if (i >= j || d > gap * boundary_) continue;
      const bool one_gap = own && stretch_of(lone[j]) == own;
      // A stretch too short for a loop of its own goes on in others, though its ends are near to each other.
      const std::uint32_t open = stretches.find(lone[i].piece);
      if (open != stretches.find(lone[j].piece) || (one_gap && length[open] >= shortest_loop * boundary_))
        links.emplace_back(!one_gap, d, i, j);
    }
  }
  std::sort(links.begin(), links.end());
  std::vector<std::uint8_t> linked(lone.size(), 0);
  for (const auto& [across, d, i, j] : links) {
    if (linked[i] != 0 || linked[j] != 0) continue;
    linked[i] = linked[j] = 1;
    pairs.push_back({lone[i].piece, lone[j].piece});
  }
  return pairs;
}

void Rim::find_loops() {
  DisjointSets sets(pieces_.size());
  // Pieces that share an end; an end of one open piece alone is where the loop goes on across a gap.
  std::vector<LoneEnd> ends;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].open) continue;
    ends.push_back({nodes_[i][0], i, pieces_[i].a});
    ends.push_back({nodes_[i][1], i, pieces_[i].b});
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const LoneEnd& x, const LoneEnd& y) { return x.node < y.node; });
  std::vector<LoneEnd> lone;
  for (std::size_t i = 0, end = 0; i < ends.size(); i = end) {
    while (end < ends.size() && ends[end].node == ends[i].node) sets.unite(ends[end++].piece, ends[i].piece);
    if (end - i == 1) lone.push_back(ends[i]);
    if (end - i > 2) ++meetings_;
  }
  for (const auto& [one, other] : bridges(lone)) sets.unite(one, other);
  std::map<std::uint32_t, double> lengths; // by the first piece
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    if (pieces_[i].open) lengths[sets.find(i)] += distance(pieces_[i].a, pieces_[i].b);
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (const auto& [first, length] : lengths)
    if (length >= shortest_loop * boundary_)
      numbers.emplace(first, static_cast<std::uint32_t>(numbers.size()));
  loops_.resize(numbers.size());
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].open) continue;
    const auto number = numbers.find(sets.find(i));
    pieces_[i].open = number != numbers.end();
    if (!pieces_[i].open) continue;
    pieces_[i].loop = number->second;
    ++loops_[number->second].pieces;
    loops_[number->second].length += distance(pieces_[i].a, pieces_[i].b);
  }
}

void Rim::describe_loops() {
  for (const RimPiece& p : pieces_)
    if (p.open) loops_[p.loop].center += (distance(p.a, p.b) / loops_[p.loop].length) * (0.5 * (p.a + p.b));
  // The area that the loop spans, seen from its centre, is largest along the normal of its plane.
  for (const RimPiece& p : pieces_)
    if (p.open) loops_[p.loop].normal += cross(p.a - loops_[p.loop].center, p.b - loops_[p.loop].center);
  for (RimLoop& loop : loops_) loop.normal = normalized(loop.normal);
  std::vector<double> height(loops_.size(), 0);
  for (const RimPiece& p : pieces_) {
    if (!p.open) continue;
    RimLoop& loop = loops_[p.loop];
    const Vec3 offset = p.a - loop.center;
    loop.diameter = std::max(loop.diameter, 2 * length(offset));
    height[p.loop] = std::max(height[p.loop], std::abs(dot(offset, loop.normal)));
  }
  for (std::size_t i = 0; i < loops_.size(); ++i)
    if (loops_[i].normal != Vec3{} && loops_[i].diameter > 0)
      loops_[i].flatness = height[i] / loops_[i].diameter;
}

void Rim::build_curve() {
  std::vector<Segment3> open;
  for (const RimPiece& p : pieces_) {
    if (!p.open) continue;
    open.push_back({p.a, p.b});
    loop_of_.push_back(p.loop);
  }
  curve_ = std::make_shared<const ClosestPointIndex>(flat_triangles(open));
}

bool Rim::is_nearest(Vec3 p, double d) const {
  if (empty()) return false;
  return curve_->closest_within(p, d * (1 + closeness) + closeness * boundary_).triangle.valid();
}

std::size_t Rim::memory_bytes() const {
  return pieces_.capacity() * sizeof(RimPiece) + nodes_.capacity() * sizeof(nodes_[0]) +
         loops_.capacity() * sizeof(RimLoop) + loop_of_.capacity() * sizeof(loop_of_[0]) +
         (curve_ ? curve_->memory_bytes() : 0);
}

TriangleSoup flat_triangles(std::span<const Segment3> segments) {
  TriangleSoup soup;
  for (const auto& [a, b] : segments) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), {a, b});
    soup.triangles.push_back({first, first + 1, first + 1});
  }
  return soup;
}

} // namespace isoscope
