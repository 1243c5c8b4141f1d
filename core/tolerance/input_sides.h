// On which side of the input a point lies: the one place that knows.
#pragma once

#include "tolerance/closest_point.h"
#include "tolerance/solid_angles.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace isoscope {

/// What the user lets decide about sides.
enum class SidesMode : std::uint8_t {
  automatic, ///< parity where closed parts do not meet, else the winding number where it is defined
  winding,   ///< the winding number
  parity,    ///< parity
  multi      ///< every region that walls enclose is an inside of its own (§4.2)
};

/// What tells sides.
enum class SideRule : std::uint8_t {
  colouring, ///< nothing but Ω: regions alternate (open soups)
  parity,    ///< the number of layers around a point: odd is inside
  winding,   ///< how often the input winds around a point: 0 is outside
  given,     ///< the field itself, which knows what lies behind its boundaries
  depth,     ///< what is deep and not joined to the outside is inside (points)
  rooms      ///< several insides: regions are told apart by the walls between them
};

/// "colouring", "parity", "winding", "given", "depth" or "rooms".
std::string_view name(SideRule rule);

/// The sides of the input. Const and thread-safe.
class InputSides {
 public:
  InputSides() = default;
  /// `turns`: how each triangle counts, by id (see FacetTurns); null: once, as it runs, and for soups that
  /// nothing is known about that.
  InputSides(std::shared_ptr<const ClosestPointIndex> index, SideRule rule,
             std::shared_ptr<const std::vector<std::int8_t>> turns);

  /// Of a soup whose solid angles tell how often it winds around a point.
  InputSides(std::shared_ptr<const ClosestPointIndex> index, std::shared_ptr<const SolidAngles> angles)
      : index_(std::move(index)), angles_(std::move(angles)), rule_(SideRule::winding) {}

  /// Of a field without a surface: it knows them, or they go with the depth of regions.
  explicit InputSides(std::shared_ptr<const ToleranceField> field, SideRule rule)
      : field_(std::move(field)), rule_(rule) {}

  SideRule rule() const { return rule_; }
  /// Whether the input does not close, and winds clearly all the same.
  bool by_solid_angles() const { return angles_ != nullptr; }
  /// Whether every point off the input has a side that is known.
  bool known() const {
    return rule_ != SideRule::colouring && rule_ != SideRule::depth && rule_ != SideRule::rooms;
  }

  /// Whether p, which is outside of Ω where the field gives the sides, is inside. Of soups only a guess: what
  /// many rays say; where they disagree, the winding number if there are turns and it is near a whole number,
  /// else most of the rays. Not told for the sides of points, which only regions have: false.
  bool inside(Vec3 p) const;
  /// F of p: -1 inside, +1 outside.
  int label(Vec3 p) const { return inside(p) ? -1 : +1; }
  /// How often the input winds around p, as it is oriented; only meaningful where that closes.
  int winding_number(Vec3 p) const;
  /// Whether all of many rays say that p is inside (true), none does (false), or some do only (nothing).
  std::optional<bool> unanimous_parity(Vec3 p) const;
  /// The label of b, when that of a is `label`: by what the segment between them crosses, if there is a
  /// surface.
  int label_across(Vec3 a, int label, Vec3 b) const;

 private:
  std::shared_ptr<const ClosestPointIndex> index_;
  std::shared_ptr<const SolidAngles> angles_;   ///< where the input winds without closing
  std::shared_ptr<const ToleranceField> field_; ///< where there is no surface
  std::shared_ptr<const std::vector<std::int8_t>> turns_;
  std::shared_ptr<const SolidAngles> angles_of_votes_; ///< of soups of which turns are known
  SideRule rule_ = SideRule::colouring;

  std::span<const std::int8_t> turns() const {
    return turns_ ? std::span<const std::int8_t>(*turns_) : std::span<const std::int8_t>();
  }
};

} // namespace isoscope
