// What Z should look like: the input's own topology where it has one, else what the boundaries of Ω tell.
#include "criteria/topology.h"

#include "base/numbers.h"
#include "tolerance/contacts.h"
#include "tolerance/open_changes.h"
#include "tolerance/volume_components.h"

#include <algorithm>
#include <vector>

namespace isoscope {
namespace {

/// The boundary components of one side together.
struct Side {
  long euler_characteristic = 0;
  std::size_t components = 0;

  /// Whether closed surfaces may have these numbers.
  bool resolved() const { return euler_characteristic % 2 == 0 && genus() >= 0; }
  long genus() const { return (2 * static_cast<long>(components) - euler_characteristic) / 2; }
};

Side side_of(const ToleranceVolume& volume, int label) {
  Side side;
  for (const BoundaryComponent& component : volume.boundary_components()) {
    if (component.label != label || volume.regions()[component.region.index()].shallow) continue;
    side.euler_characteristic += component.euler_characteristic;
    ++side.components;
  }
  return side;
}

/// Whether parts of an embedded input are so near each other that nothing passes between them.
bool nearly_touches(const ToleranceVolume& volume) {
  const ToleranceThresholds& t = volume.thresholds();
  const double radius = 0.5 * touching_gap * t.delta;
  return volume.input().components > 1 &&
         find_volume_components(volume.index(), radius).count < volume.input().components &&
         !find_near_contacts(volume.index(), volume.sides(), t.delta, t.boundary, RunControl()).empty();
}

void expect_nothing(ExpectedTopology& expected, const char* why) {
  expected.nothing = why;
  expected.source = "nothing: " + expected.nothing;
}

/// Where there are open surfaces: half of χ of ∂Ω, as Z is what Ω shrinks to and χ(∂Ω) = 2 χ(Ω); a component
/// of Z for each of Ω, a closed curve of its border for each loop of the open rim.
ExpectedTopology expected_of_open(const ToleranceVolume& volume) {
  ExpectedTopology expected;
  const Rim& rim = volume.open_sides()->rim();
  const auto [sum, components, loops, keeps_input] = open_topology(volume);
  expected.components = components;
  // What has no joined triangles has none of its own; every sheet of so many loops has a genus.
  const long twice_genus = 2 * static_cast<long>(components) - static_cast<long>(loops) - sum / 2;
  const bool possible = sum % 2 == 0 && twice_genus >= 0 && twice_genus % 2 == 0;
  const bool told_by_volume = volume.open_sides()->by_samples() && volume.thickening() && possible;
  expected.required = keeps_input || told_by_volume;
  // Where Ω keeps components and loops alone, walls and gaps that it closes have made its χ another one; Z
  // goes through them.
  const InputTopology& input = volume.input();
  const bool of_input = volume.has_surface() && input.manifold && components == input.components &&
                        loops == input.boundary_loops;
  if (of_input || expected.required || (possible && rim.meetings() == 0))
    expected.boundary_loops = loops;
  else
    expected.loops_untold =
        possible ? "the " + counted(loops, "loop") + " of the rim meet each other or themselves in " +
                       counted(rim.meetings(), "point") + ", where Ω parts or joins them"
                 : "no surface with that χ has the " + counted(loops, "loop") + " of the rim: Ω closes some";
  expected.source = of_input ? "the input" : "the boundary of Ω";
  if (of_input)
    expected.euler_characteristic = input.euler_characteristic;
  else if (sum % 2 == 0)
    expected.euler_characteristic = sum / 2;
  return expected;
}

/// Z is a deformation of Ω, and a compact part of space has half the χ of its boundary: sheets, curves and
/// points where several rooms meet need not be known.
void expect_of_rooms(const ToleranceVolume& volume, ExpectedTopology& expected) {
  long sum = 0;
  std::vector<std::size_t> sides(volume.volume_component_count());
  for (const BoundaryComponent& component : volume.boundary_components()) {
    if (volume.regions()[component.region.index()].shallow) continue;
    sum += component.euler_characteristic;
    ++sides[component.volume_component];
  }
  if (sum % 2 != 0) {
    expected.required = false;
    return expect_nothing(expected, "the boundaries of Ω are too close to each other to count");
  }
  expected.euler_characteristic = sum / 2;
  expected.components = static_cast<std::size_t>(
      std::count_if(sides.begin(), sides.end(), [](std::size_t n) { return n > 1; }));
  expected.source = "all boundaries of Ω, by half";
}

} // namespace

ExpectedTopology expected_before_the_cut(const ToleranceVolume& volume, const ExpectedTopology& expected) {
  if (volume.open_sides() == nullptr) return expected;
  ExpectedTopology none;
  expect_nothing(none, "Z is not cut along the rim yet");
  return none;
}

ExpectedTopology expected_topology(const ToleranceVolume& volume, TopologyMode mode) {
  ExpectedTopology expected;
  if (mode == TopologyMode::separate) {
    expected.source = "separation of the sides only";
    return expected;
  }
  if (volume.open_sides() != nullptr) return expected_of_open(volume);
  if (volume.has_rooms()) {
    expect_of_rooms(volume, expected);
    return expected;
  }
  const InputTopology& input = volume.input();
  const bool embedded = input.embedded() && !volume.has_inner_walls() && !nearly_touches(volume);
  const bool thickening = volume.thickening();
  // The topology of parts that overlap or touch is that of the input nowhere near where they do.
  const bool one_surface = input.closed_manifold && input.components == 1 && !volume.has_inner_walls();
  if (input.euler_characteristic && (embedded || (one_surface && !thickening))) {
    expected.euler_characteristic = input.euler_characteristic;
    expected.components = input.components;
    expected.source = "the input";
    expected.required = embedded;
    return expected;
  }
  const Side outer = side_of(volume, +1), inner = side_of(volume, -1);
  if (volume.sides().by_solid_angles() && !thickening && !volume.has_inner_walls() && input.manifold &&
      input.components == 1) {
    expected.euler_characteristic =
        *input.euler_characteristic + static_cast<long>(input.boundary_loops.value_or(0));
    expected.components = 1;
    expected.source = "the input, its holes closed";
    expected.required = outer.components == 1 && outer.euler_characteristic == *expected.euler_characteristic;
    return expected;
  }
  const bool meets_itself = input.sides_known() && !one_surface;
  if (outer.components == 0 || inner.components == 0) {
    expect_nothing(expected, "Ω has no boundary on one side");
    return expected;
  }
  if (thickening) {
    expected.euler_characteristic = outer.euler_characteristic;
    expected.components = outer.components;
    expected.source = "both boundaries of Ω";
    expected.joined = meets_itself;
    return expected;
  }
  if (meets_itself && outer.resolved() && volume.uncounted_depth() <= volume.thresholds().delta) {
    expected.euler_characteristic = outer.euler_characteristic;
    expected.components = outer.components;
    expected.source = "the outer boundary of Ω";
    expected.joined = true;
    return expected;
  }
  expected.required = false;
  if (!outer.resolved() || !inner.resolved()) {
    expect_nothing(expected, "the boundaries of Ω are too close to each other to count");
    return expected;
  }
  const std::size_t components = std::min(outer.components, inner.components);
  const long genus = std::min(outer.genus(), inner.genus());
  expected.components = components;
  expected.euler_characteristic = 2 * static_cast<long>(components) - 2 * genus;
  expected.source = "the boundary of smaller genus";
  return expected;
}

TopologyVerdict check_topology(const ZeroSet& zero_set, const ExpectedTopology& expected) {
  TopologyVerdict verdict;
  verdict.euler_characteristic = zero_set.euler_characteristic();
  verdict.components = zero_set.components.size();
  verdict.boundary_loops = zero_set.boundary_loops();
  verdict.as_expected =
      (!expected.euler_characteristic || *expected.euler_characteristic == verdict.euler_characteristic) &&
      (!expected.components || *expected.components == verdict.components) &&
      (!expected.boundary_loops || *expected.boundary_loops == verdict.boundary_loops);
  return verdict;
}

} // namespace isoscope
