// The tolerance volume Ω = {φ <= δ} of a field: its distance, the regions outside of it and their
// labels (§2.1, §2.2).
#pragma once

#include "base/ids.h"
#include "base/run_control.h"
#include "base/segment.h"
#include "base/status.h"
#include "input/triangle_soup.h"
#include "tolerance/closest_point.h"
#include "tolerance/input_sides.h"
#include "tolerance/open_sides.h"
#include "tolerance/witnesses.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isoscope {

class BorderGate;
class Regions;
struct DepthLabels;

using RegionId = Id<struct RegionTag>;

/// A connected component of the complement of Ω' = {φ <= δ'}: what lies behind one boundary component.
struct Region {
  RegionId id;
  int label = +1; ///< of its side: +1 outside, -1 inside (§2.2), or -1, -2, … in several insides (§4.2)
  bool unbounded = false;
  Vec3 deepest;      ///< a point of the region far from the input: the witness of its side
  double depth = 0;  ///< φ(deepest), same units as δ
  double volume = 0; ///< lower bound from the octree; infinite for the unbounded region
  /// Of points and rooms: it is a pocket in Ω, and on the side of the deep region that it is joined to first.
  bool shallow = false;
  /// How often the input winds around it, where that is what tells its side.
  int winding_number = 0;
};

/// A connected component of ∂Ω', as far as the octree resolves it (thin crevices below its cells have no
/// component). Since every closed surface separates space, a region and a component of Ω share one boundary
/// component at most.
struct BoundaryComponent {
  RegionId region;
  std::uint32_t volume_component = 0; ///< the component of Ω' on its other side
  int label = +1;
  /// Whether χ is sure. It is not where walls or gaps of little more than 2 δ leave regions that are too thin
  /// for the lattice on which it is counted.
  bool told = true;
  long euler_characteristic = 0;
};

/// Thresholds (core/README.md, N1.1): labels and samples live on d = δ', a facet is accepted below δ and
/// rejected above δ_r. δ_r is halfway between δ' and δ, but at least δ' + 0.01 δ: labels must be decidable at
/// finite depth also where δ' = δ. There δ_r exceeds δ and is only where labels are sure; a certificate then
/// rejects at δ itself.
struct ToleranceThresholds {
  double delta = 0;    ///< δ, what containment is proven against
  double reject = 0;   ///< δ_r: a point farther than this has a label and, where δ_r < δ, is a violation
  double boundary = 0; ///< δ': where ∂Ω is sampled. 0.95 δ in certified mode, δ in sampled mode
};

/// What the input looks like as a surface; found from Ω alone and, where it is an indexed mesh, from its
/// connectivity.
struct InputTopology {
  bool closed_manifold =
      false; ///< after merging equal points: every edge has two triangles, every vertex one fan
  bool self_intersection_free = false; ///< only tested when closed_manifold
  bool consistently_oriented = false;  ///< closed_manifold, and neighbours agree on their sides
  bool manifold = false; ///< the same, but edges may have one triangle: a surface with or without border
  std::optional<long> euler_characteristic;  ///< when manifold
  std::optional<std::size_t> boundary_loops; ///< closed curves that its border consists of; when manifold
  std::size_t components = 0;                ///< connected components of the input triangles
  std::optional<Vec3> border; ///< a point of an edge that does not have two triangles, if there is one
  SideRule side_rule = SideRule::colouring; ///< what tells the sides
  bool may_wind_open = false; ///< it does not close, and its solid angles may tell the sides all the same
  bool every_region = false;  ///< asked for: each region that walls enclose is an inside
  std::shared_ptr<const std::vector<std::int8_t>>
      turns;                      ///< how each triangle counts for that; null: as it is
  std::vector<std::string> notes; ///< what the user should know about the sides, one sentence each

  /// Whether the input is a surface that has two sides and does not cross itself.
  bool embedded() const { return closed_manifold && self_intersection_free; }
  /// Whether the side of every point of the input's surface is told, also where Ω has no boundary, and is
  /// what the user means: parity does not say it where parts intersect each other.
  bool sides_known() const {
    return side_rule != SideRule::rooms && (side_rule == SideRule::winding ||
                                            (closed_manifold && (self_intersection_free || components == 1)));
  }
};

/// What is said where a region of the complement of Ω' lies on both sides of an input that has no rim there.
Error open_surface_near(Vec3 p);
/// What is said of an open surface that has one side only.
Error one_sided_near(Vec3 p);

/// Ω with everything the algorithm asks of it. Distance queries are const and thread-safe; label_at may
/// refine the octree and is for one thread only.
class ToleranceVolume {
 public:
  struct Options {
    double delta = 0;                                            ///< absolute, > 0
    double boundary_ratio = 0.95;                                ///< δ'/δ in (0, 1]
    double most_bytes = std::numeric_limits<double>::infinity(); ///< that the octree's main cells may take
    bool open_surfaces = true; ///< false: they are refused, as by those who look for a δ that closes them
    /// Whether open parts whose triangles are not joined are taken: what builds it gives it their sides, by
    /// open().
    bool loose_sheets = false;
  };

  /// Builds the octree, joins fake pockets, labels the regions and two-colours them from the unbounded one.
  /// A component of Ω that does not separate two regions is an open surface, where it has a rim (§4.1); fails
  /// with open_surface where it has none or one side only, with joined_sheets on rooms with fins, naming the
  /// place, with unsupported where the octree takes too much memory; with cancelled when told to. Parts that
  /// are thinner than 2δ' everywhere are built: find_thin_parts() tells them.
  static Result<ToleranceVolume> build(std::shared_ptr<const ToleranceField> field,
                                       const InputTopology& input, const Options& options,
                                       const RunControl& control);
  ToleranceVolume(ToleranceVolume&&) noexcept;
  ToleranceVolume& operator=(ToleranceVolume&&) noexcept;
  ~ToleranceVolume();

  const ToleranceThresholds& thresholds() const { return thresholds_; }
  const ToleranceField& field() const { return *field_; }
  const std::shared_ptr<const ToleranceField>& shared_field() const { return field_; }
  /// Whether the field is the distance to triangles: normals, crossings and parity exist.
  bool has_surface() const { return field_->surface() != nullptr; }
  /// The triangles, where has_surface().
  const ClosestPointIndex& index() const { return *field_->surface(); }
  std::shared_ptr<const ClosestPointIndex> shared_index() const { return {field_, field_->surface()}; }
  const InputTopology& input() const { return input_; }
  /// The same as build() was given it: before Ω decided what tells the sides.
  InputTopology given_input() const {
    InputTopology given = input_;
    given.side_rule = given_rule_;
    return given;
  }
  /// Which side of the input a point is on.
  const InputSides& sides() const { return sides_; }
  /// The sides of its open surfaces; null where there are none.
  const OpenSides* open_sides() const { return open_sides_.get(); }
  /// As they were found first, by normals alone.
  const std::shared_ptr<const OpenSides>& open_sides_found() const { return open_sides_found_; }
  /// Takes them, and has the border keep to their rim.
  void settle_open_sides(std::shared_ptr<const OpenSides> sides);
  /// By component of Ω', 1 for those that are open and whose triangles are not joined; empty where there are
  /// none, or the options do not take them.
  const std::vector<std::uint8_t>& loose_sheets() const { return loose_sheets_; }
  /// Takes the sides of parts that enclose nothing and of which no triangles tell them. `control`: of what is
  /// found anew for that.
  void open(std::shared_ptr<const OpenSides> sides, const RunControl& control);
  /// The open rim of the input, to which the border of Z keeps (§4.1); null where Z is closed.
  const BorderGate* border_gate() const { return border_gate_.get(); }
  void keep_border_to(std::vector<Segment3> rim);
  /// The cube that holds Ω and the octree.
  Box3 domain() const;

  /// Regions ascending by id; the first is the unbounded one. Grows when label_at meets a region too small
  /// for the octree.
  std::span<const Region> regions() const { return regions_; }
  /// Points that decide whether Z separates the sides, and those that hold() added. Grows with regions().
  std::span<const Witness> witnesses() const { return witnesses_; }
  /// Points that are on their side by the end of the refinement and need not stay there.
  std::span<const Witness> cover_path() const { return cover_path_; }
  /// Adds points to both, so that Z stays near to what is thin.
  void hold(std::span<const Witness> held, std::vector<Witness> path);
  /// How many of the witnesses were added by it.
  std::size_t held() const;
  std::span<const BoundaryComponent> boundary_components() const { return boundary_components_; }
  /// Whether regions are told apart by the walls between them: there may be more than one inside (§4.2).
  bool has_rooms() const { return sides_.rule() == SideRule::rooms; }
  /// Whether the boundary components of each side have the same Euler characteristic, so that Ω may be a
  /// thickening (§1.2); of rooms whether nothing deep goes uncounted.
  bool thickening() const;
  /// Whether what the boundary components are is sure.
  bool topology_told() const;
  /// Regions that no boundary component counts: they were too small to be seen before somebody asked for a
  /// point in them.
  std::size_t pockets() const;
  /// The depth of the deepest of them, 0 when there are none.
  double uncounted_depth() const;
  /// Fails with unsupported, naming the place, where questions asked since create() found regions of
  /// different sides to be one: a passage between them is wider than 2 δ' but narrower than the main cells
  /// show.
  Status check_passages() const;
  /// What Ω closes or cuts, in one sentence for the user; empty when it is a thickening.
  /// Without its cause once the control is cancelled.
  std::string thickening_note(const RunControl& control = {}) const;
  /// Whether the input has walls with inside on both sides, as it has where closed parts overlap: a region
  /// that it winds around more than once.
  bool has_inner_walls() const;
  /// What the user should know about the sides, one sentence each: inner walls, odd orientation.
  std::vector<std::string> side_notes() const;

  /// F of the region that holds p, or 0 when p lies in Ω' or in a crevice too thin to tell. φ(p) > δ_r always
  /// has a label, unless the control is cancelled before it is known: then it is 0 too. Near open surfaces it
  /// is the side of theirs that p is on, 0 over their rim.
  int label_at(Vec3 p, const RunControl& control = {});
  /// The region that holds p, invalid where label_at would be 0, visiting at most `budget` cells before what
  /// was found counts as a region of its own.
  RegionId region_at(Vec3 p, std::size_t budget = 200000, const RunControl& control = {});

  /// Where certified steps away from the input lead: the region behind a point, and the farthest point
  /// reached.
  struct Escape {
    RegionId region;     ///< invalid when no OUT cell was met: a crevice as far as the existing cells tell
    Vec3 reached;        ///< connected with the start outside of Ω'
    double distance = 0; ///< φ(reached)
  };
  /// Steps from p, whose closest point is given and whose φ is at least δ' up to rounding. Thread-safe.
  Escape escape(Vec3 p, const ClosestPoint& closest) const;
  /// The component of Ω' that a site lies in: below volume_component_count(), or VolumeComponents::none.
  std::uint32_t volume_component(TriangleId t) const { return volume_components_[t.index()]; }
  std::size_t volume_component_count() const { return volume_component_count_; }
  /// The component of Ω' that is met first on the way down from a point outside of it, whose answer is given;
  /// VolumeComponents::none where the way ends before.
  std::uint32_t component_below(Vec3 p, const ClosestPoint& closest) const;
  /// Index into boundary_components() of what lies between a region and a component of Ω', if the octree saw
  /// it.
  std::optional<std::uint16_t> boundary_component(RegionId region, std::uint32_t volume_component) const;

  /// By cell of the octree, as many as there were when sides were told by depth (N1): the side of the deep
  /// region to which the way over the largest φ leads from there, 0 where none does. Empty where sides are
  /// told otherwise.
  std::span<const std::int8_t> basins() const { return basins_; }

  /// A copy that knows distances, thresholds and regions and has no octree to ask for more: for those who
  /// look at a run from another thread.
  ToleranceVolume without_octree() const;

  /// The octree, for the sampler.
  const Regions& octree() const { return *octree_; }
  Regions& octree() { return *octree_; }
  std::size_t memory_bytes() const;

 private:
  ToleranceVolume();
  void join_pockets(const RunControl& control);
  void collect_regions(const RunControl& control);
  void collect_boundary_components(const RunControl& control);
  void find_thin_regions(const RunControl& control);
  void add_seeded_regions(const RunControl& control);
  bool touches(Vec3 p, double d, std::uint32_t component) const;
  void deepen(Region& region) const;
  Status label_regions(const RunControl& control);
  Status count_boundary_topology(const RunControl& control);
  /// Whether each component of Ω has as many boundaries as a thickening has.
  bool has_paired_boundaries() const;
  /// Whether those of each have the same Euler characteristic.
  bool has_equal_characteristics() const;
  /// Several insides, where there are some: whether there are.
  Result<bool> label_rooms_of_input(const RunControl& control);
  void adopt(DepthLabels labels);
  bool is_uncounted(const Region& r) const;
  /// Whether winding numbers mean something: the triangles cancel along every edge.
  bool winds() const { return sides_.rule() == SideRule::winding || input_.consistently_oriented; }
  /// The side that a pocket at p goes with.
  int basin_at(Vec3 p) const;
  std::string overlap_in_words() const;
  std::string cause_in_words(const RunControl& control) const;
  Vec3 first_corner() const;
  bool joins_another(std::uint32_t root, std::uint32_t deepest);
  RegionId add_region(std::uint32_t cell, Vec3 deepest, double depth, double volume);

  std::shared_ptr<const ToleranceField> field_;
  InputTopology input_;
  SideRule given_rule_ = SideRule::colouring;
  InputSides sides_;
  std::shared_ptr<const OpenSides> open_sides_, open_sides_found_;
  ToleranceThresholds thresholds_;
  std::shared_ptr<const BorderGate> border_gate_;
  std::unique_ptr<Regions> octree_;
  std::vector<Region> regions_;
  std::vector<Witness> witnesses_, cover_path_;
  std::vector<BoundaryComponent> boundary_components_; ///< ascending by region, then component of Ω'
  std::vector<std::uint32_t> volume_components_;       ///< by site
  std::size_t volume_component_count_ = 0;
  std::vector<std::int8_t> basins_; ///< by cell
  std::vector<std::uint8_t> loose_sheets_;
};

/// What pieces of Z beyond Ω count for until Z is cut along the rim of open surfaces; empty where there are
/// none. The volume must outlive it.
inline PieceJudge outside_judge(const ToleranceVolume& volume) {
  const OpenSides* sides = volume.open_sides();
  if (sides == nullptr) return {};
  return [sides, delta = volume.thresholds().delta](const Triangle3& piece, Vec3 center,
                                                    const ClosestPoint& closest, double radius) {
    return sides->judge_outside(piece, center, closest, radius, delta);
  };
}

/// Connectivity of a soup after merging bitwise equal points, and what tells its sides; the self-intersection
/// test is exact (CGAL). What was not found out before the control was cancelled is false.
InputTopology analyse_input(const TriangleSoup& soup, SidesMode mode = SidesMode::automatic,
                            const RunControl& control = {});

} // namespace isoscope
