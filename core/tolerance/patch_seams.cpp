// Votes of border pieces, and a forest of seams over the patches.
#include "tolerance/patch_seams.h"

#include "base/disjoint_sets.h"
#include "base/segment.h"
#include "tolerance/rim.h"
#include "tolerance/sample_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace isoscope {
namespace {

/// Borders meet at creases too: where they are this near to each other, in units of δ'.
constexpr double touching = 0.05;
/// The share of the votes at a seam that tells how it runs.
constexpr double clear_majority = 0.75;

/// A part of a border edge, as its triangle runs when turned.
struct Piece {
  Segment3 ends;
  Vec3 direction, conormal;
  std::uint32_t patch = 0;
  Vec3 middle() const { return 0.5 * (ends[0] + ends[1]); }
  double length() const { return distance(ends[0], ends[1]); }
};

/// Votes at a seam.
struct Seam {
  double agree = 0, disagree = 0;
  bool clear() const { return std::max(agree, disagree) >= clear_majority * (agree + disagree); }
};

DisjointSets find_patches(const std::vector<EdgeUse>& uses, const std::vector<std::int8_t>& turns) {
  DisjointSets patches(turns.size());
  std::vector<std::uint32_t> at;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    at.clear();
    for (; end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high; ++end)
      if (turns[uses[end].triangle] != 0) at.push_back(uses[end].triangle);
    if (at.size() == 2) patches.unite(at[0], at[1]);
  }
  return patches;
}

std::vector<Piece> cut_borders(const ClosestPointIndex& index, const WeldedMesh& mesh,
                               const std::vector<std::int8_t>& turns, DisjointSets& patches, double longest) {
  std::vector<Piece> pieces;
  for (const EdgeUse& e : border_uses(mesh.triangles)) {
    const Triangle3& t = index.triangle(TriangleId(e.triangle));
    const Vec3 from = mesh.points[e.from()], to = mesh.points[e.to()];
    const Vec3 conormal = normalized(cross(to - from, cross(t[1] - t[0], t[2] - t[0])));
    const double length = distance(from, to);
    if (turns[e.triangle] == 0 || conormal == Vec3{} || length == 0) continue;
    const auto n = static_cast<std::uint32_t>(std::max(1., std::ceil(length / longest)));
    for (std::uint32_t k = 0; k < n; ++k)
      pieces.push_back({{point_on({from, to}, double(k) / n), point_on({from, to}, (k + 1.) / n)},
                        (turns[e.triangle] / length) * (to - from),
                        conormal,
                        patches.find(e.triangle)});
  }
  return pieces;
}

using Seams = std::map<std::pair<std::uint32_t, std::uint32_t>, Seam>;

/// Each piece votes with the nearest one of another patch.
Seams find_seams(const std::vector<Piece>& pieces, double boundary) {
  Seams seams;
  if (pieces.empty()) return seams;
  SampleGrid grid(pieces.front().middle(), boundary);
  for (const Piece& p : pieces) grid.add(p.middle());
  std::vector<std::uint32_t> near;
  for (const Piece& p : pieces) {
    near.clear();
    const Vec3 middle = p.middle();
    grid.gather(Box3{middle, middle}.grown(boundary), near);
    const Piece* nearest = nullptr;
    double least = boundary;
    for (const std::uint32_t i : near) {
      const Piece& q = pieces[i];
      const double d = distance_to(q.ends, middle);
      if (q.patch == p.patch || d > least || (d == least && nearest != nullptr)) continue;
      if (dot(p.conormal, q.conormal) < facing_conormals || d <= touching * boundary) least = d, nearest = &q;
    }
    if (nearest == nullptr) continue;
    const double along = p.length() * dot(p.direction, nearest->direction);
    Seam& seam = seams[std::minmax(p.patch, nearest->patch)];
    (along < 0 ? seam.agree : seam.disagree) += std::abs(along);
  }
  return seams;
}

/// Patches that are joined, each with whether it runs the other way than the first of them.
class Joined {
 public:
  explicit Joined(std::size_t n) : sets_(n), opposite_(n, 0), members_(n) {
    for (std::uint32_t i = 0; i < n; ++i) members_[i].push_back(i);
  }
  void join(std::uint32_t a, std::uint32_t b, bool opposite) {
    const std::uint32_t of_a = sets_.find(a), of_b = sets_.find(b);
    if (!sets_.unite(a, b)) return;
    const bool turn = (opposite_[a] != opposite_[b]) != opposite;
    const std::uint32_t stays = std::min(of_a, of_b), goes = std::max(of_a, of_b);
    for (const std::uint32_t m : members_[goes]) {
      if (turn) opposite_[m] ^= 1;
      members_[stays].push_back(m);
    }
    members_[goes].clear();
  }
  bool opposite(std::uint32_t i) const { return opposite_[i] != 0; }
  std::uint32_t first(std::uint32_t i) { return sets_.find(i); }

 private:
  DisjointSets sets_;
  std::vector<std::uint8_t> opposite_;
  std::vector<std::vector<std::uint32_t>> members_; ///< by the first of a set
};

} // namespace

void turn_along_seams(const ClosestPointIndex& index, const WeldedMesh& mesh,
                      const std::vector<EdgeUse>& uses, double boundary, std::vector<std::int8_t>& turns) {
  DisjointSets patches = find_patches(uses, turns);
  const Seams seams =
      find_seams(cut_borders(index, mesh, turns, patches, longest_border_piece * boundary), boundary);
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t, bool>> order;
  for (const auto& [ends, seam] : seams)
    if (seam.clear())
      order.emplace_back(-std::abs(seam.agree - seam.disagree), ends.first, ends.second,
                         seam.disagree > seam.agree);
  std::sort(order.begin(), order.end());
  Joined joined(turns.size());
  for (const auto& [weight, a, b, opposite] : order) joined.join(a, b, opposite);
  std::vector<double> balance(turns.size(), 0); // by the first patch of what is joined: area as it runs
  const auto is_opposite = [&](std::uint32_t t) { return joined.opposite(patches.find(t)); };
  for (std::uint32_t t = 0; t < turns.size(); ++t) {
    const Triangle3& corners = index.triangle(TriangleId(t));
    const double area = length(cross(corners[1] - corners[0], corners[2] - corners[0]));
    balance[joined.first(patches.find(t))] += is_opposite(t) ? -area : area;
  }
  for (std::uint32_t t = 0; t < turns.size(); ++t)
    if (is_opposite(t) != (balance[joined.first(patches.find(t))] < 0))
      turns[t] = static_cast<std::int8_t>(-turns[t]);
}

} // namespace isoscope
