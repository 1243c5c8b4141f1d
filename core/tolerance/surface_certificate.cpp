// Pieces are proven from the triangles that are nearest to their corners.
#include "tolerance/surface_certificate.h"

#include "tolerance/flat_parts.h"
#include "tolerance/rounding.h"
#include "tolerance/triangle_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace isoscope {
namespace {

using Kind = FacetVerdict::Kind;

/// A corner of pieces with the triangle nearest to it. Vectors lead to it from points of convex sites: of
/// triangles by their ids, of flat parts by their numbers behind these.
struct PieceCorner {
  Vec3 point;
  Vec3 away; ///< from the closest point
  double squared = 0;
  std::uint32_t triangle = 0, part = 0; ///< part: the triangle again where it lies in none
  /// From points of other sites, the last that were asked.
  struct Other {
    std::uint32_t site;
    Vec3 away;
  };
  static constexpr std::uint32_t most_others = 6;
  std::uint32_t asked = 0;
  std::array<Other, most_others> others;
};

/// Triangles and flat parts.
struct ConvexSites {
  const ClosestPointIndex* surface;
  const FlatParts* parts;
  double rough_limit; ///< of d², from parts

  std::uint32_t part_of(TriangleId t) const {
    const std::uint32_t part = parts != nullptr ? parts->part_of(t) : FlatParts::none;
    return static_cast<std::uint32_t>(part != FlatParts::none ? surface->size() + part : t.index());
  }
  const Vec3& away(std::uint32_t site, PieceCorner& corner) const {
    if (site == corner.triangle) return corner.away;
    for (std::uint32_t i = 0; i < std::min(corner.asked, PieceCorner::most_others); ++i)
      if (corner.others[i].site == site) return corner.others[i].away;
    PieceCorner::Other& made = corner.others[corner.asked++ % PieceCorner::most_others];
    made.site = site;
    if (site < surface->size())
      made.away = corner.point - closest_point_inlined(corner.point, surface->triangle(TriangleId(site)));
    else
      made.away = parts->away_from(static_cast<std::uint32_t>(site - surface->size()), corner.point)
                      .value_or(Vec3{1e100, 1e100, 1e100});
    return made.away;
  }
};

/// A piece by its corners' places in a list.
struct CornerPiece {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t depth;
};

/// Bisections beyond this cannot make a piece of doubles smaller.
constexpr std::uint32_t most_bisections = 120;
constexpr std::size_t pieces_between_stops = 256;
/// Pieces of more bisections are also asked without flat parts.
constexpr std::uint32_t few_bisections = 8;
constexpr std::size_t usual_corners = 64, usual_pieces = 16;

/// d² at most on a piece, from a site for each of its corners; more than `limit` where it is not proven.
/// Points of a site that are near to two corners lead to a point on the way between these along the edge, and
/// all vectors change linearly: each site gives a convex bound.
double bound_of_piece(const ConvexSites& sites, const std::array<PieceCorner*, 3>& c,
                      const std::array<std::uint32_t, 3>& site, double limit) {
  // Vectors from the site of one corner to another corner, as they are needed.
  std::array<std::array<Vec3, 3>, 3> away;
  std::array<std::array<double, 3>, 3> squared;
  squared.fill({-1, -1, -1});
  const auto look = [&](std::size_t i, std::size_t k) {
    if (squared[i][k] < 0) {
      away[i][k] = sites.away(site[i], *c[k]);
      squared[i][k] = squared_length(away[i][k]);
    }
    return squared[i][k];
  };
  double own = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    own = std::max(own, look(i, i));
    if (own > limit) return own;
    // What failed at a corner before fails again.
    if (i > 0 && (site[i] == site[0] || site[i] == site[i - 1])) continue;
    if (look(i, j) <= limit && look(i, k) <= limit)
      return std::max({squared[i][i], squared[i][j], squared[i][k]});
  }
  // The piece is cut into one part for each corner, in which that corner's triangle is near: parts end on
  // edges, where both triangles are about as far, and meet inside.
  const auto between = [](Vec3 a, Vec3 b, double t) { return a + t * (b - a); };
  double largest = own;
  std::array<double, 3> middle{};
  int cuts = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (site[i] == site[j]) continue;
    const double at_start = look(j, i) - squared[i][i], at_end = look(i, j) - squared[j][j];
    const double sum = at_start + at_end;
    const double t = sum > 0 ? std::clamp(at_start / sum, 0., 1.) : 0.5;
    for (const std::size_t from : {i, j})
      largest = std::max(largest, squared_length(between(away[from][i], away[from][j], t)));
    if (largest > limit) return largest;
    middle[i] += 1 - t;
    middle[j] += t;
    ++cuts;
  }
  if (cuts < 3) return largest; // two triangles: their parts meet along a line between two cuts
  for (const auto& from : away)
    largest = std::max(largest, squared_length((1. / 3) * (middle[0] * from[0] + middle[1] * from[1] +
                                                           middle[2] * from[2])));
  return largest;
}

/// The same from parts, then from triangles where parts are too rough or their corners are in the way.
double bound_of_piece(const ConvexSites& sites, const std::array<PieceCorner*, 3>& c, bool is_small,
                      double limit) {
  const std::array<std::uint32_t, 3> triangles{c[0]->triangle, c[1]->triangle, c[2]->triangle};
  const std::array<std::uint32_t, 3> parts{c[0]->part, c[1]->part, c[2]->part};
  if (parts == triangles) return bound_of_piece(sites, c, triangles, limit);
  const double bound = bound_of_piece(sites, c, parts, sites.rough_limit);
  if (bound <= sites.rough_limit) {
    const double d = std::sqrt(bound) + sites.parts->roughness();
    return std::min(d * d, limit);
  }
  const double own = std::max({c[0]->squared, c[1]->squared, c[2]->squared});
  // What is known by then is no bound: it was left once it exceeded what parts may prove.
  return is_small || own > sites.rough_limit ? bound_of_piece(sites, c, triangles, limit)
                                             : std::numeric_limits<double>::infinity();
}

} // namespace

FacetVerdict certify_on_surface(const ToleranceField& field, const ClosestPointIndex& surface,
                                const Triangle3& facet, double accept, double reject,
                                const FacetSearch& search) {
  FacetVerdict verdict;
  Box3 box;
  for (const Vec3 p : facet) box.add(p);
  const double rounding = rounding_bound(field.bounds(), box, bound_roundings);
  const double limit = accept - rounding;
  const double squared_limit = limit > 0 ? limit * limit : -1;
  const auto prove = [&](double squared) {
    verdict.max_distance = std::max(verdict.max_distance, std::sqrt(squared) + rounding);
  };
  // Whoever brings a guess asks for speed: then a bound from the guess is good enough, if looser.
  if (search.guess.valid()) {
    double largest = 0;
    for (std::size_t k = 0; k < 3 && largest <= squared_limit; ++k)
      largest = std::max(largest, surface.at_site(facet[k], search.guess).squared_distance);
    if (largest <= squared_limit) {
      verdict.pieces = 1;
      verdict.kind = Kind::inside;
      prove(largest);
      return verdict;
    }
  }
  const double rough = search.parts != nullptr ? limit - search.parts->roughness() : -1;
  const ConvexSites sites{&surface, search.parts, rough > 0 ? rough * rough : -1};
  std::vector<PieceCorner> corners;
  corners.reserve(usual_corners);
  /// Adds a corner; false where it violates.
  const auto add_corner = [&](Vec3 p, TriangleId guess) {
    const ClosestPoint closest = field.closest_near(p, guess);
    PieceCorner& corner = corners.emplace_back();
    corner.point = p;
    corner.away = p - closest.point;
    corner.squared = closest.squared_distance;
    corner.triangle = static_cast<std::uint32_t>(closest.triangle.index());
    corner.part = sites.part_of(closest.triangle);
    if (!(closest.distance() - rounding > reject)) return true;
    if (verdict.kind != Kind::outside || closest.squared_distance > verdict.closest.squared_distance) {
      verdict.witness = p;
      verdict.closest = closest;
    }
    verdict.kind = Kind::outside;
    if (search.witnesses != nullptr) search.witnesses->push_back(p);
    return false;
  };
  const auto enough = [&] {
    return verdict.kind == Kind::outside &&
           (search.witnesses == nullptr || search.witnesses->size() >= search.most_witnesses);
  };
  const auto undecided = [&](Vec3 where) {
    if (verdict.kind == Kind::outside) return;
    verdict.kind = Kind::undecided;
    verdict.witness = where;
  };

  TriangleId guess = search.guess;
  verdict.pieces = 1;
  for (std::size_t k = 0; k < 3 && !enough(); ++k) {
    add_corner(facet[k], guess);
    guess = TriangleId(corners.back().triangle);
  }
  if (verdict.kind == Kind::outside) return verdict;
  verdict.pieces = 0;
  std::vector<CornerPiece> stack;
  stack.reserve(usual_pieces);
  stack.push_back({{0, 1, 2}, 0});
  while (!stack.empty()) {
    const CornerPiece piece = stack.back();
    stack.pop_back();
    ++verdict.pieces;
    const std::array<PieceCorner*, 3> c{&corners[piece.corners[0]], &corners[piece.corners[1]],
                                        &corners[piece.corners[2]]};
    const bool stopped =
        search.stop != nullptr && verdict.pieces % pieces_between_stops == 0 && (*search.stop)();
    if (stopped || verdict.pieces > search.budget || piece.depth > most_bisections) {
      undecided((1. / 3) * (c[0]->point + c[1]->point + c[2]->point));
      return verdict;
    }
    const double squared = bound_of_piece(sites, c, piece.depth > few_bisections, squared_limit);
    if (squared <= squared_limit) {
      prove(squared);
      continue;
    }
    for (const PieceCorner* corner : c)
      if (corner->squared > squared_limit) { // no piece that has it is ever proven
        undecided(corner->point);
        return verdict;
      }
    std::size_t longest = 0;
    double l2 = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double e2 = squared_length(c[(i + 1) % 3]->point - c[i]->point);
      if (e2 > l2) l2 = e2, longest = i;
    }
    const std::size_t next = (longest + 1) % 3;
    const auto middle = static_cast<std::uint32_t>(corners.size());
    if (!add_corner(0.5 * (c[longest]->point + c[next]->point), TriangleId(c[longest]->triangle))) {
      if (enough()) return verdict;
      continue;
    }
    CornerPiece first = piece, second = piece;
    first.corners[longest] = second.corners[next] = middle;
    ++first.depth, ++second.depth;
    stack.push_back(first);
    stack.push_back(second);
  }
  if (verdict.kind != Kind::outside) verdict.kind = Kind::inside;
  return verdict;
}

} // namespace isoscope
