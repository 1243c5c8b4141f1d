// Judges two surfaces by their edges, by exact intersection tests and by exact parity.
#include "tolerance/surface_pair.h"

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "tolerance/exact_position.h"
#include "tolerance/facet_turns.h"
#include "tolerance/index_building.h"
#include "tolerance/self_intersections.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace isoscope {
namespace {

constexpr std::array<std::string_view, 2> wall_names{"outer", "inner"};

Error stopped() {
  return {ErrorCode::cancelled, "Stopped while the surfaces were compared.", ""};
}

Error refused(std::size_t wall, const std::string& what, Vec3 where, const std::string& remedy) {
  return {ErrorCode::bad_input,
          "The " + std::string(wall_names[wall]) + " surface " + what + " near " +
              place(where, place_digits) + ".",
          remedy};
}

/// A connected part of a wall.
struct Shell {
  std::size_t wall = 0;
  Vec3 point;
  double volume = 0;                 ///< signed by its orientation, which is the same all over it
  std::vector<std::uint32_t> around; ///< shells that hold it
  bool holds_volume = false;         ///< the volume is on its inner side
  std::uint32_t component_shell = 0; ///< the shell around its component of the volume
};

class Joiner {
 public:
  Joiner(const TriangleSoup& outer, const TriangleSoup& inner, const RunControl& control)
      : soups_{&outer, &inner}, control_(control) {}

  Result<SurfacePair> join() {
    for (std::size_t wall = 0; wall < 2; ++wall)
      if (Status closed = add_wall(wall); !closed) return closed.error();
    if (Status apart = check_intersections(); !apart) return apart.error();
    pair_.index = build_index(pair_.walls, control_);
    if (control_.cancelled()) return stopped();
    collect_shells();
    if (Status nested = nest_shells(); !nested) return nested.error();
    if (control_.cancelled()) return stopped();
    turn_shells();
    pair_.index = build_index(pair_.walls, control_); // with the triangles as they run now
    if (Status whole = number_components(); !whole) return whole.error();
    if (control_.cancelled()) return stopped();
    return std::move(pair_);
  }

 private:
  std::size_t wall_of(std::uint32_t triangle) const { return triangle < pair_.outer ? 0 : 1; }

  /// Appends a closed surface, oriented consistently.
  Status add_wall(std::size_t wall) {
    const TriangleSoup& soup = *soups_[wall];
    WeldedMesh mesh = weld(soup);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (is_collapsed(mesh.triangles[t]))
        return refused(wall, "has a triangle without an area", centroid(soup.triangle(t)), "Remove it.");
    const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
    if (control_.cancelled()) return stopped();
    for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
      while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
      const Vec3 middle = 0.5 * (mesh.points[uses[i].low] + mesh.points[uses[i].high]);
      if (end - i == 1)
        return refused(wall, "is open", middle, "Close it: the walls of a volume have no holes.");
      if (end - i > 2)
        return refused(wall, "is no manifold", middle, "No more than two triangles may meet at an edge.");
    }
    if (const auto v = vertex_of_two_fans(mesh, uses))
      return refused(wall, "touches itself", mesh.points[*v], "Move its parts apart there.");
    const FacetTurns turns = find_facet_turns(mesh, uses);
    if (turns.closedness != Closedness::oriented)
      return refused(wall, "has one side only", turns.unoriented.value_or(mesh.points[0]),
                     "Such a surface crosses itself: give one that does not.");
    if (turns.turns)
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if ((*turns.turns)[t] < 0) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    const auto base = static_cast<std::uint32_t>(pair_.walls.points.size());
    pair_.walls.points.insert(pair_.walls.points.end(), mesh.points.begin(), mesh.points.end());
    for (const IndexTriangle& t : mesh.triangles)
      pair_.walls.triangles.push_back({base + t[0], base + t[1], base + t[2]});
    if (wall == 0) pair_.outer = pair_.walls.triangles.size();
    return {};
  }

  /// Points of the two walls are never merged: where they are equal, the walls touch.
  Status check_intersections() const {
    const auto met = self_intersections(
        pair_.walls.points, pair_.walls.triangles, [&] { return control_.cancelled(); }, 1);
    if (!met) return stopped();
    if (met->empty()) return {};
    const auto [first, second] = met->front();
    const Triangle3 a = pair_.walls.triangle(first), b = pair_.walls.triangle(second);
    const Vec3 where = centroid(area(a) < area(b) ? a : b);
    if (first == second)
      return refused(wall_of(first), "has a triangle without an area", where, "Remove it.");
    if (wall_of(first) == wall_of(second))
      return refused(wall_of(first), "meets itself", where,
                     "Repair it: a wall of a volume does not cross itself.");
    return Error{ErrorCode::bad_input,
                 "The inner and the outer surface touch or cross near " + place(where, place_digits) + ".",
                 "The volume lies between them: move them apart there."};
  }

  void collect_shells() {
    const TriangleSoup& walls = pair_.walls;
    DisjointSets sets(walls.points.size());
    for (const auto& t : walls.triangles) {
      sets.unite(t[0], t[1]);
      sets.unite(t[0], t[2]);
    }
    std::vector<std::uint32_t> number(walls.points.size(), 0);
    shell_of_.reserve(walls.triangles.size());
    for (std::uint32_t t = 0; t < walls.triangles.size(); ++t) {
      const std::uint32_t root = sets.find(walls.triangles[t][0]);
      if (number[root] == 0) {
        shells_.push_back({wall_of(t), walls.points[walls.triangles[t][0]], 0, {}, false, 0});
        number[root] = static_cast<std::uint32_t>(shells_.size());
      }
      shell_of_.push_back(number[root] - 1);
      Shell& shell = shells_[shell_of_.back()];
      const Triangle3 c = walls.triangle(t);
      shell.volume += dot(c[0] - shell.point, cross(c[1] - shell.point, c[2] - shell.point));
    }
    for (const Shell& shell : shells_) pair_.seeds.push_back(shell.point);
  }

  /// Which shells hold which, and on which side of each the volume lies: inside the outer surface and not
  /// inside the inner one.
  Status nest_shells() {
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (control_.cancelled()) return stopped();
      Shell& shell = shells_[s];
      const auto crossed = crossed_on_the_way_out(shell.point, *pair_.index,
                                                  [&](TriangleId t) { return shell_of_[t.index()] != s; });
      if (!crossed) return refused(shell.wall, "touches another part", shell.point, "Move them apart.");
      std::vector<std::uint32_t> passed;
      for (const TriangleId t : *crossed) passed.push_back(shell_of_[t.index()]);
      std::sort(passed.begin(), passed.end());
      std::array<std::size_t, 2> around{};
      for (auto i = passed.begin(); i != passed.end();) {
        const auto next = std::upper_bound(i, passed.end(), *i);
        if ((next - i) % 2 != 0) {
          shell.around.push_back(*i);
          ++around[shells_[*i].wall];
        }
        i = next;
      }
      const bool in_outer = around[0] % 2 != 0, in_inner = around[1] % 2 != 0;
      if (shell.wall == 1 ? !in_outer : in_inner)
        return refused(1, shell.wall == 1 ? "is not inside the outer one" : "holds the outer one",
                       shell.point,
                       "The larger surface is the outer one, and all of the inner one must lie in it.");
      shell.holds_volume = shell.wall == 0 ? !in_outer : in_inner;
    }
    return {};
  }

  /// Triangles get their front where the volume is not.
  void turn_shells() {
    for (std::uint32_t t = 0; t < pair_.walls.triangles.size(); ++t) {
      const Shell& shell = shells_[shell_of_[t]];
      if ((shell.volume > 0) == shell.holds_volume) continue;
      auto& corners = pair_.walls.triangles[t];
      std::swap(corners[1], corners[2]);
    }
  }

  /// A part of the volume is named after the shell around it: that of a shell which has the volume outside is
  /// the innermost one that holds it.
  Status number_components() {
    std::vector<std::array<bool, 2>> has(shells_.size());
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      Shell& shell = shells_[s];
      shell.component_shell = s;
      if (!shell.holds_volume)
        shell.component_shell = *std::max_element(
            shell.around.begin(), shell.around.end(), [&](std::uint32_t a, std::uint32_t b) {
              return shells_[a].around.size() < shells_[b].around.size();
            });
      has[shell.component_shell][shell.wall] = true;
    }
    std::vector<std::uint32_t> number(shells_.size(), 0);
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (shells_[s].component_shell != s) continue;
      if (!has[s][0] || !has[s][1])
        return refused(shells_[s].wall,
                       has[s][0] ? "has a part that holds nothing of the inner one"
                                 : "has a cavity that holds nothing of the outer one",
                       shells_[s].point, "Nothing is to be separated there: remove it.");
      number[s] = static_cast<std::uint32_t>(pair_.components++);
    }
    for (const std::uint32_t s : shell_of_) pair_.component.push_back(number[shells_[s].component_shell]);
    return {};
  }

  std::array<const TriangleSoup*, 2> soups_;
  const RunControl& control_;
  SurfacePair pair_;
  std::vector<Shell> shells_;
  std::vector<std::uint32_t> shell_of_; ///< by triangle
};

} // namespace

Result<SurfacePair> join_surfaces(const TriangleSoup& outer, const TriangleSoup& inner,
                                  const RunControl& control) {
  return Joiner(outer, inner, control).join();
}

} // namespace isoscope
