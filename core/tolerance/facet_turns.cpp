// Orients the patches between edges of two triangles, after deciding which copies of a triangle count.
#include "tolerance/facet_turns.h"

#include "base/solid_angle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace isoscope {
namespace {

using Turns = std::vector<std::int8_t>;

/// The share of a patch's area that must run one way for it to be meant.
constexpr double clear_majority = 0.75;
/// Vertices of a patch that are asked whether another one encloses it, and triangles looked at for that in
/// all, beyond which patches count as not enclosed.
constexpr std::size_t nesting_points = 8, nesting_budget = 200'000'000;
constexpr int toggle_rounds = 8;
/// The share of the sides of triangles that must have a neighbour for an open soup to be oriented.
constexpr double oriented_share = 0.9;

/// Calls visit(first, last) for the sides of each edge between two different vertices.
template <class Visit> void for_each_edge(const std::vector<EdgeUse>& uses, Visit&& visit) {
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first;
    while (last != uses.end() && last->low == first->low && last->high == first->high) ++last;
    if (first->low != first->high) visit(first, last);
    first = last;
  }
}

/// The middle of an edge along which the triangles do not cancel.
std::optional<Vec3> uncancelled(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses,
                                const Turns& turns) {
  std::optional<Vec3> place;
  for_each_edge(uses, [&](auto first, auto last) {
    long sum = 0;
    for (auto use = first; use != last; ++use)
      sum += use->ascends ? turns[use->triangle] : -turns[use->triangle];
    if (sum != 0 && !place) place = 0.5 * (mesh.points[first->low] + mesh.points[first->high]);
  });
  return place;
}

bool has_even_edges(const std::vector<EdgeUse>& uses, const Turns& turns) {
  bool result = true;
  for_each_edge(uses, [&](auto first, auto last) {
    const auto counts = [&](const EdgeUse& use) { return turns[use.triangle] != 0; };
    result = result && std::count_if(first, last, counts) % 2 == 0;
  });
  return result;
}

/// Triangles with the same vertices, ascending by id.
using Copies = std::vector<std::uint32_t>;

/// Whether t runs like s, which has the same vertices.
bool runs_alike(const IndexTriangle& s, const IndexTriangle& t) {
  const auto at = static_cast<std::size_t>(std::find(t.begin(), t.end(), s[0]) - t.begin());
  return t[(at + 1) % 3] == s[1];
}

std::vector<Copies> find_copies(const WeldedMesh& mesh) {
  std::vector<std::pair<IndexTriangle, std::uint32_t>> keys;
  keys.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_collapsed(mesh.triangles[t])) continue;
    IndexTriangle key = mesh.triangles[t];
    std::sort(key.begin(), key.end());
    keys.emplace_back(key, t);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Copies> groups;
  for (std::size_t i = 0, end = 0; i < keys.size(); i = end) {
    while (end < keys.size() && keys[end].first == keys[i].first) ++end;
    if (end - i < 2) continue;
    Copies& group = groups.emplace_back();
    for (std::size_t k = i; k < end; ++k) group.push_back(keys[k].second);
  }
  return groups;
}

/// A patch: triangles joined across edges of two, and the way round that they have together.
struct Patch {
  std::vector<std::uint32_t> triangles;
  double agreeing = 0, area = 0; ///< of the triangles that run as they are given, and of all that tell
  bool flip = false;
  bool meant() const { return std::max(agreeing, area - agreeing) >= clear_majority * area && area > 0; }
};

class Orienter {
 public:
  Orienter(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses, const std::vector<Copies>& copies,
           Turns& turns)
      : mesh_(mesh), uses_(uses), copies_(copies), turns_(turns) {}

  /// Orients the triangles whose turn is not 0; a place where that is impossible.
  std::optional<Vec3> run() {
    link();
    if (const std::optional<Vec3> one_sided = spread()) return one_sided;
    weigh();
    for (std::size_t p = 0; p < patches_.size(); ++p) decide(p);
    for (const Patch& patch : patches_)
      for (const std::uint32_t t : patch.triangles)
        if (patch.flip) turns_[t] = static_cast<std::int8_t>(-turns_[t]);
    return std::nullopt;
  }

  /// The share of the sides of triangles across which one neighbour lies.
  double linked_share() const {
    std::size_t counting = 0;
    for (const Patch& patch : patches_) counting += patch.triangles.size();
    return static_cast<double>(links_.size()) / static_cast<double>(std::max<std::size_t>(1, 3 * counting));
  }

 private:
  struct Link {
    std::uint32_t from, to;
    bool same_way; ///< along their edge
  };

  void link() {
    for_each_edge(uses_, [&](auto first, auto last) {
      std::array<const EdgeUse*, 2> two{};
      std::size_t n = 0;
      for (auto use = first; use != last; ++use) {
        if (turns_[use->triangle] == 0) continue;
        if (n < 2) two[n] = &*use;
        ++n;
      }
      if (n != 2) return;
      const bool same = two[0]->ascends == two[1]->ascends;
      links_.push_back({two[0]->triangle, two[1]->triangle, same});
      links_.push_back({two[1]->triangle, two[0]->triangle, same});
    });
    std::sort(links_.begin(), links_.end(),
              [](const Link& a, const Link& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  }

  /// Gives the triangles of each patch the same way round as its first.
  std::optional<Vec3> spread() {
    std::vector<char> seen(mesh_.triangles.size(), 0);
    for (std::uint32_t start = 0; start < mesh_.triangles.size(); ++start) {
      if (seen[start] || turns_[start] == 0) continue;
      turns_[start] = 1;
      seen[start] = 1;
      std::vector<std::uint32_t>& patch = patches_.emplace_back().triangles;
      patch.push_back(start);
      for (std::size_t done = 0; done < patch.size(); ++done) {
        const std::uint32_t s = patch[done];
        auto link = std::lower_bound(links_.begin(), links_.end(), s,
                                     [](const Link& l, std::uint32_t t) { return l.from < t; });
        for (; link != links_.end() && link->from == s; ++link) {
          const auto turn = static_cast<std::int8_t>(link->same_way ? -turns_[s] : turns_[s]);
          if (seen[link->to]) {
            if (turns_[link->to] != turn) return centroid(s);
            continue;
          }
          turns_[link->to] = turn;
          seen[link->to] = 1;
          patch.push_back(link->to);
        }
      }
    }
    return std::nullopt;
  }

  void weigh() {
    std::vector<std::int8_t> vote(mesh_.triangles.size(), 1);
    for (const Copies& group : copies_) {
      int net = 0;
      for (const std::uint32_t t : group)
        net += runs_alike(mesh_.triangles[group.front()], mesh_.triangles[t]) ? 1 : -1;
      vote[group.front()] = static_cast<std::int8_t>(net > 0 ? 1 : (net < 0 ? -1 : 0));
    }
    for (Patch& patch : patches_)
      for (const std::uint32_t t : patch.triangles) {
        const Triangle3 corners = triangle(t);
        const double area = length(cross(corners[1] - corners[0], corners[2] - corners[0]));
        if (vote[t] == 0) continue;
        patch.area += area;
        if (vote[t] == turns_[t]) patch.agreeing += area;
      }
  }

  void decide(std::size_t p) {
    Patch& patch = patches_[p];
    if (patch.meant()) {
      patch.flip = patch.agreeing < 0.5 * patch.area;
      return;
    }
    double volume = 0;
    const Vec3 origin = mesh_.points[mesh_.triangles[patch.triangles.front()][0]];
    for (const std::uint32_t t : patch.triangles) {
      const Triangle3 c = triangle(t);
      volume += turns_[t] * dot(c[0] - origin, cross(c[1] - origin, c[2] - origin));
    }
    patch.flip = (volume < 0) != (enclosing(p) % 2 == 1);
  }

  /// How many other patches enclose patch p.
  std::size_t enclosing(std::size_t p) {
    std::vector<Vec3> points;
    const auto& own = patches_[p].triangles;
    for (std::size_t k = 0; k < std::min(nesting_points, own.size()); ++k)
      points.push_back(mesh_.points[mesh_.triangles[own[k * own.size() / nesting_points % own.size()]][0]]);
    std::size_t count = 0;
    for (std::size_t q = 0; q < patches_.size(); ++q) {
      if (q == p) continue;
      looked_at_ += points.size() * patches_[q].triangles.size();
      if (looked_at_ > nesting_budget) return count;
      const auto inside = [&](Vec3 x) {
        SolidAngleSum sum;
        for (const std::uint32_t t : patches_[q].triangles)
          if (turns_[t] != 0) sum.add(x, triangle(t), turns_[t]);
        return std::abs(sum.winding()) > 0.5;
      };
      if (std::all_of(points.begin(), points.end(), inside)) ++count;
    }
    return count;
  }

  Triangle3 triangle(std::uint32_t t) const {
    const IndexTriangle& v = mesh_.triangles[t];
    return {mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]]};
  }
  Vec3 centroid(std::uint32_t t) const { return isoscope::centroid(triangle(t)); }

  const WeldedMesh& mesh_;
  const std::vector<EdgeUse>& uses_;
  const std::vector<Copies>& copies_;
  Turns& turns_;
  std::vector<Link> links_; ///< ascending
  std::vector<Patch> patches_;
  std::size_t looked_at_ = 0;
};

/// Each triangle once, whatever its copies.
Turns once_each(const WeldedMesh& mesh, const std::vector<Copies>& copies) {
  Turns turns(mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < turns.size(); ++t)
    if (is_collapsed(mesh.triangles[t])) turns[t] = 0;
  for (const Copies& group : copies)
    for (std::size_t k = 1; k < group.size(); ++k) turns[group[k]] = 0;
  return turns;
}

/// Copies in pairs cancel, as the common face of two boxes does, unless two edges of the triangle need it.
Turns pairs_cancelled(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses,
                      const std::vector<Copies>& copies) {
  Turns turns = once_each(mesh, copies);
  for (const Copies& group : copies) turns[group.front()] = static_cast<std::int8_t>(group.size() % 2);
  for (int round = 0; round < toggle_rounds; ++round) {
    std::vector<std::uint8_t> odd_edges(mesh.triangles.size(), 0);
    for_each_edge(uses, [&](auto first, auto last) {
      const auto counts = [&](const EdgeUse& use) { return turns[use.triangle] != 0; };
      if (std::count_if(first, last, counts) % 2 == 0) return;
      for (auto use = first; use != last; ++use) ++odd_edges[use->triangle];
    });
    bool changed = false;
    for (const Copies& group : copies) {
      if (odd_edges[group.front()] < 2) continue;
      turns[group.front()] = static_cast<std::int8_t>(1 - turns[group.front()]);
      changed = true;
    }
    if (!changed) break;
  }
  return turns;
}

/// Whether the triangles do more than cancel out: a body and the same body turned inside out bound nothing.
bool bounds_something(const WeldedMesh& mesh, const std::vector<Copies>& copies) {
  std::size_t in_groups = 0;
  for (const Copies& group : copies) {
    in_groups += group.size();
    long net = 0;
    for (const std::uint32_t t : group)
      net += runs_alike(mesh.triangles[group.front()], mesh.triangles[t]) ? 1 : -1;
    if (net != 0) return true;
  }
  const auto collapsed =
      static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), is_collapsed));
  return in_groups + collapsed < mesh.triangles.size();
}

} // namespace

FacetTurns find_facet_turns(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses) {
  FacetTurns result;
  const Turns all(mesh.triangles.size(), 1);
  const std::vector<Copies> copies = find_copies(mesh);
  if (!uncancelled(mesh, uses, all) && bounds_something(mesh, copies)) {
    result.closedness = Closedness::oriented;
    result.as_given = true;
    return result;
  }
  std::vector<Turns> choices{once_each(mesh, copies)};
  if (!copies.empty()) choices.push_back(pairs_cancelled(mesh, uses, copies));
  for (Turns turns : choices) {
    if (!has_even_edges(uses, turns)) continue;
    const Turns once = turns;
    std::optional<Vec3> place = Orienter(mesh, uses, copies, turns).run();
    if (!place) place = uncancelled(mesh, uses, turns);
    if (!place) {
      result.closedness = Closedness::oriented;
      result.turns = std::make_shared<const Turns>(std::move(turns));
      result.unoriented.reset();
      return result;
    }
    if (result.closedness == Closedness::parity) continue;
    result.closedness = Closedness::parity;
    result.turns = std::make_shared<const Turns>(once);
    result.unoriented = place;
  }
  if (result.closedness == Closedness::open) {
    Orienter orienter(mesh, uses, copies, choices.front());
    if (!orienter.run() && orienter.linked_share() >= oriented_share)
      result.turns = std::make_shared<const Turns>(std::move(choices.front()));
  }
  return result;
}

std::vector<std::uint32_t> needless_copies(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses) {
  const std::vector<Copies> copies = find_copies(mesh);
  Turns turns = once_each(mesh, copies);
  if (copies.empty() || !has_even_edges(uses, turns)) return {};
  const auto alike = [&](std::uint32_t s, std::uint32_t t) {
    return runs_alike(mesh.triangles[s], mesh.triangles[t]);
  };
  const bool both_ways = std::any_of(copies.begin(), copies.end(), [&](const Copies& group) {
    return std::any_of(group.begin(), group.end(), [&](std::uint32_t t) { return !alike(group.front(), t); });
  });
  if (both_ways && !uncancelled(mesh, uses, Turns(mesh.triangles.size(), 1)) &&
      bounds_something(mesh, copies))
    return {};
  const bool oriented = !Orienter(mesh, uses, copies, turns).run();
  std::vector<std::uint32_t> needless;
  for (const Copies& group : copies) {
    std::uint32_t kept = group.front();
    if (oriented && turns[kept] < 0) {
      const auto turned =
          std::find_if(group.begin(), group.end(), [&](std::uint32_t t) { return !alike(group.front(), t); });
      if (turned != group.end()) kept = *turned;
    }
    for (const std::uint32_t t : group)
      if (t != kept) needless.push_back(t);
  }
  std::sort(needless.begin(), needless.end());
  return needless;
}

PatchTurns orient_patches(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses) {
  const std::vector<Copies> copies = find_copies(mesh);
  PatchTurns result{once_each(mesh, copies), {}};
  result.one_sided = Orienter(mesh, uses, copies, result.turns).run();
  return result;
}

} // namespace isoscope
