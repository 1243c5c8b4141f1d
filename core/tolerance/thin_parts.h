// Parts of the input that are thinner than twice the tolerance everywhere: of their inside, or of the gap
// that they enclose, nothing is left.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/delta_study.h"
#include "tolerance/tolerance_volume.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace isoscope {

/// A component of Ω' that has a region of one side only: Z has nothing to enclose there. Between rooms it has
/// regions of one label only, as one that is no deeper than 1.3 δ goes with what is around it.
struct ThinPart {
  std::uint32_t volume_component = 0;
  int lost = -1;              ///< the label that no region has: -1 nothing is inside, +1 the gap closes
  Vec3 place;                 ///< midway between two walls where they are farthest apart
  double thickness = 0;       ///< there, as far as probes see; 0: no two walls face each other
  double least_thickness = 0; ///< the same of the thinnest of the closed parts of the input in it
  std::size_t triangles = 0;  ///< of the input
  Box3 box;                   ///< their bounds
  bool room = false;          ///< where there are rooms

  /// What is no thicker than this is lost, in δ.
  double thinnest_kept() const { return room ? 2 * deep_enough : 2; }
};

/// The thin parts of a labelled volume, by component.
std::vector<ThinPart> find_thin_parts(const ToleranceVolume& volume);

/// A tolerance that leaves something inside of every part.
struct KeepingTolerance {
  double value = 0; ///< absolute, to two digits; 0: there is none, walls touch each other
  bool fits = true; ///< whether the volume at it fits into memory
};

/// The largest one, tried by building the volume at it where parts may come apart. Fails with cancelled only.
Result<KeepingTolerance> find_keeping_tolerance(const ToleranceVolume& volume,
                                                std::span<const ThinPart> parts, const RunControl& control);

/// What is said of thin parts, at least one: the thinnest with its place and thickness, and what helps.
Error thin_parts_error(const ToleranceVolume& volume, std::span<const ThinPart> parts,
                       const KeepingTolerance& keeping);

/// What is said of parts that were left out, at least one: how many, where, how large.
std::string left_out_words(std::span<const ThinPart> parts);

/// The input without the triangles of thin parts, in their order; all points stay.
TriangleSoup without_parts(const TriangleSoup& soup, const ToleranceVolume& volume,
                           std::span<const ThinPart> parts);

} // namespace isoscope
