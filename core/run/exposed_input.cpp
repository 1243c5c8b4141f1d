// Cuts triangles until nothing crosses a piece, and asks for the sides beside it.
#include "run/exposed_input.h"

#include "base/parallel.h"

#include <algorithm>
#include <vector>

namespace isoscope {
namespace {

/// Bisections of one triangle; those beyond are kept uncut.
constexpr std::size_t most_cuts = 200000;
/// A piece is shrunk by this share before others are looked for: its neighbours touch it at its border alone.
constexpr double border = 1e-6;
/// Triangles nearer than this share of a piece touch it.
constexpr double contact = 1e-9;

Vec3 centroid(const Triangle3& t) {
  return (t[0] + t[1] + t[2]) / 3.0;
}

/// What lies on another triangle altogether, as where faces touch, is not crossed by it.
bool is_crossed(const ClosestPointIndex& index, TriangleId own, const Triangle3& piece) {
  const Vec3 c = centroid(piece);
  Triangle3 inner;
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    inner[i] = piece[i] + border * (c - piece[i]);
    box.add(inner[i]);
  }
  const double touching = contact * box.longest_edge();
  for (const TriangleId id : index.triangles_in(box.grown(touching))) {
    const Triangle3& other = index.triangle(id);
    if (id == own || !triangles_within(inner, other, touching)) continue;
    const auto on_other = [&](Vec3 p) {
      return distance(p, closest_point_on_triangle(p, other)) <= touching;
    };
    if (!std::all_of(inner.begin(), inner.end(), on_other)) return true;
  }
  return false;
}

/// The side of the input that one comes to from p, a point of it, along a direction: that of the place midway
/// to the next wall.
int side_along(const ToleranceVolume& volume, Vec3 p, Vec3 direction) {
  const ClosestPointIndex& index = volume.index();
  const double reach = 2 * (distance(index.bounds().lo, index.bounds().hi) + volume.thresholds().delta);
  const Vec3 start = p + (1e-9 * reach) * direction, end = p + reach * direction;
  const std::vector<double> hits = index.crossings(start, end);
  return hits.empty() ? +1 : volume.sides().label(start + (0.5 * hits.front()) * (end - start));
}

bool bounds_inside(const ToleranceVolume& volume, const Triangle3& piece, Vec3 normal) {
  return side_along(volume, centroid(piece), normal) != side_along(volume, centroid(piece), -normal);
}

std::vector<Triangle3> exposed_pieces(const ToleranceVolume& volume, TriangleId t, double finest) {
  const Triangle3& whole = volume.index().triangle(t);
  const Vec3 normal = normalized(cross(whole[1] - whole[0], whole[2] - whole[0]));
  if (normal == Vec3{}) return {whole};
  std::vector<Triangle3> kept, open{whole};
  for (std::size_t cuts = 0; !open.empty(); ++cuts) {
    const Triangle3 piece = open.back();
    open.pop_back();
    if (!is_crossed(volume.index(), t, piece)) {
      if (bounds_inside(volume, piece, normal)) kept.push_back(piece);
      continue;
    }
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (distance(piece[i], piece[(i + 1) % 3]) > distance(piece[longest], piece[(longest + 1) % 3]))
        longest = i;
    const Vec3 a = piece[longest], b = piece[(longest + 1) % 3];
    if (distance(a, b) <= finest) {
      if (bounds_inside(volume, piece, normal)) kept.push_back(piece);
      continue;
    }
    if (cuts >= most_cuts) {
      kept.push_back(piece);
      continue;
    }
    Triangle3 first = piece, second = piece;
    first[longest] = second[(longest + 1) % 3] = 0.5 * (a + b);
    open.push_back(first);
    open.push_back(second);
  }
  return kept;
}

/// Whether parts of the input may lie inside of others.
bool may_have_inner_walls(const ToleranceVolume& volume) {
  const InputTopology& input = volume.input();
  const bool one_surface = input.closed_manifold && input.components == 1;
  return volume.has_inner_walls() || (volume.sides().known() && !input.embedded() && !one_surface);
}

} // namespace

std::shared_ptr<const ClosestPointIndex> exposed_input(const ToleranceVolume& volume, double finest,
                                                       const RunControl& control) {
  const ClosestPointIndex& index = volume.index();
  if (!may_have_inner_walls(volume)) return volume.shared_index();
  std::vector<std::vector<Triangle3>> pieces(index.size());
  parallel_for(index.size(), 16, [&](std::size_t i) {
    if (!control.out_of_grace()) pieces[i] = exposed_pieces(volume, TriangleId(i), finest);
  });
  TriangleSoup exposed;
  for (const auto& list : pieces)
    for (const Triangle3& t : list) {
      const auto first = static_cast<std::uint32_t>(exposed.points.size());
      exposed.points.insert(exposed.points.end(), t.begin(), t.end());
      exposed.triangles.push_back({first, first + 1, first + 2});
    }
  if (exposed.triangles.empty()) return volume.shared_index();
  return std::make_shared<const ClosestPointIndex>(exposed);
}

} // namespace isoscope
