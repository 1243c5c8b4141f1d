// What the stages know of an edge beside its star: its samples, and how they collapse edges of its kind.
#pragma once

#include "collapse/collapse_evaluator.h"
#include "run/parameters.h"
#include "tolerance/boundary_sampler.h"

namespace isoscope {

/// Adds the samples that lie in the star, ascending (sampled mode).
void add_star_samples(EdgeStar& star, const BoundarySamples& samples);
/// How the stages collapse edges of a kind, in the pass of halfedges or in the other one.
CollapseSettings settings_for(EdgeKind kind, bool halfedge, const RunParameters& parameters);

} // namespace isoscope
