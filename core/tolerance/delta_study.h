// Which δ suits a field: how the components of Ω and the regions around it come and go as δ grows.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"
#include "tolerance/field.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace isoscope {

/// A bounded region outside of Ω that lasts: it is cut off where δ reaches `separation` and is gone where δ
/// reaches `depth`.
struct LastingRegion {
  double separation = 0; ///< φ at the saddle
  double depth = 0;      ///< φ at the deepest point
  Vec3 saddle, deepest;
};

/// How far beyond δ a region must reach to be an inside and no pocket.
constexpr double deep_enough = 1.3;

struct DeltaStudy {
  /// What there is at one δ.
  struct Step {
    double delta = 0;
    std::size_t components = 0; ///< of Ω
    std::size_t regions = 0;    ///< of the rest of space, the unbounded one among them
    std::size_t deep = 0;       ///< bounded ones deeper than deep_enough δ
  };
  std::vector<Step> curve;            ///< ascending by δ
  std::vector<LastingRegion> regions; ///< those that last long, deepest first
  std::vector<LastingRegion> insides; ///< those of them that the surface encloses
  double least = 0;                   ///< below it Ω' joins the insides with what is around them
  double most = 0;                    ///< beyond it one of them is closed up
  double proposed = 0;

  /// Whether there is a δ that suits.
  bool found() const { return proposed > 0; }
  /// Where the first of the insides opens as δ shrinks below `least`.
  Vec3 saddle() const;
  /// Where the first of them closes as δ grows beyond `most`.
  Vec3 closing() const;
};

/// Studies φ on an octree whose cells are small compared to φ, down to `finest`, below which it is not looked
/// at. Values are right to about a tenth. Of no use once the control is cancelled. The same on any number of
/// threads.
DeltaStudy study_delta(const ToleranceField& field, double finest, const RunControl& control);

} // namespace isoscope
