// Samples that are held on their side near to places of the input.
#pragma once

#include "base/run_control.h"
#include "criteria/nearest_sample.h"
#include "run/kept_points.h"
#include "tolerance/tolerance_volume.h"

#include <span>
#include <vector>

namespace isoscope {

/// Adds samples of a side to what is held, one within `reach` (absolute) of every place, where there is one
/// and nothing of the side that is held is as near. By the end of the refinement all samples are on their
/// side. Fewer once the control is cancelled.
inline void hold_samples(const ToleranceVolume& volume, const NearestSample& samples, int label,
                         std::span<const Vec3> places, double reach, std::vector<Witness>& held,
                         const RunControl& control) {
  KeptPoints chosen(volume.index().bounds().lo, reach);
  for (const Witness& w : held)
    if (w.label == label) chosen.add(w.point);
  for (const Vec3 p : places) {
    if (control.cancelled()) return;
    if (chosen.has_near(p)) continue;
    const SampleId nearest = samples.nearest_of(p, label, reach);
    if (!nearest.valid()) continue;
    const Vec3 sample = samples.positions()[nearest.index()];
    chosen.add(sample);
    held.push_back({sample, label, volume.field().distance(sample), true});
  }
}

} // namespace isoscope
