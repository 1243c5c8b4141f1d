// Sides by rays, and by solid angles where the rays of a soup disagree.
#include "tolerance/input_sides.h"

#include "base/solid_angle.h"

#include <array>
#include <cmath>

namespace isoscope {
namespace {

/// Rays cast to see whether a soup has a defined parity somewhere.
constexpr unsigned ballot_size = 16;

/// A winding number this near a whole number is meant to be one.
constexpr double clear = 0.25;

/// How many of the ballot's rays say that p is inside.
unsigned votes_for_inside(const ClosestPointIndex& index, Vec3 p) {
  const double reach =
      2 * (distance(index.bounds().lo, index.bounds().hi) + distance(p, index.bounds().center()));
  unsigned inside = 0;
  for (unsigned k = 0; k < ballot_size;
       ++k) { // a golden spiral: directions evenly spread and aligned with nothing
    const double z = 1 - (2 * k + 1.0) / ballot_size, r = std::sqrt(1 - z * z),
                 angle = 2.39996322972865332 * k + 0.3;
    const Vec3 direction{r * std::cos(angle), r * std::sin(angle), z};
    inside += static_cast<unsigned>(index.crossings(p, p + reach * direction).size() % 2);
  }
  return inside;
}

} // namespace

std::string_view name(SideRule rule) {
  constexpr std::array<std::string_view, 6> names{"colouring", "parity", "winding",
                                                  "given",     "depth",  "rooms"};
  return names[static_cast<std::size_t>(rule)];
}

InputSides::InputSides(std::shared_ptr<const ClosestPointIndex> index, SideRule rule,
                       std::shared_ptr<const std::vector<std::int8_t>> turns)
    : index_(std::move(index)), turns_(std::move(turns)), rule_(rule) {
  if (turns_ && !known()) angles_of_votes_ = std::make_shared<const SolidAngles>(*index_, *turns_);
}

int InputSides::winding_number(Vec3 p) const {
  if (angles_) return static_cast<int>(std::lround(angles_->winding(p)));
  return index_->winding_number(p, turns());
}

bool InputSides::inside(Vec3 p) const {
  switch (rule_) {
  case SideRule::winding:
    return winding_number(p) != 0;
  case SideRule::parity:
    return turns_ ? winding_number(p) % 2 != 0 : index_->inside_by_parity(p);
  case SideRule::given:
    return field_->side(p) < 0;
  case SideRule::depth:
    return false;
  case SideRule::colouring:
  case SideRule::rooms:
    break;
  }
  const unsigned votes = votes_for_inside(*index_, p);
  if (angles_of_votes_ && votes > 0 && votes < ballot_size) {
    // Parts of a soup run this way or that; layers of two parts alike are no more inside than none.
    const auto winding = whole_winding(angles_of_votes_->winding(p), clear);
    if (winding && (*winding == 0 || *winding % 2 != 0)) return *winding != 0;
  }
  return 2 * votes > ballot_size;
}

std::optional<bool> InputSides::unanimous_parity(Vec3 p) const {
  if (angles_) return inside(p);
  const unsigned votes = votes_for_inside(*index_, p);
  if (votes == 0) return false;
  if (votes == ballot_size) return true;
  return std::nullopt;
}

int InputSides::label_across(Vec3 a, int label, Vec3 b) const {
  if (rule_ == SideRule::given || rule_ == SideRule::depth || rule_ == SideRule::rooms) return label;
  const std::size_t crossings = index_->crossings(a, b).size();
  if (crossings == 0) return label;
  if (rule_ == SideRule::winding || (rule_ == SideRule::parity && turns_)) return this->label(b);
  return crossings % 2 == 1 ? -label : label;
}

} // namespace isoscope
