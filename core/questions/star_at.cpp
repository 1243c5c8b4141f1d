// The samples are found by the star's box first.
#include "questions/star_at.h"

#include "collapse/sample_targets.h"
#include "mesh/predicates.h"

#include <algorithm>

namespace isoscope {

void add_star_samples(EdgeStar& star, const BoundarySamples& samples) {
  Box3 box;
  for (const auto& v : star.vertices) box.add(v.position);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 p = samples.positions[i];
    const bool near = p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y &&
                      p.z >= box.lo.z && p.z <= box.hi.z;
    if (!near) continue;
    const bool held = std::any_of(star.tets.begin(), star.tets.end(), [&](const EdgeStar::StarTet& t) {
      return holds_perturbed(star.positions(t), p);
    });
    if (held) star.samples.push_back({SampleId(i), p, samples.labels[i]});
  }
}

CollapseSettings settings_for(EdgeKind kind, bool halfedge, const RunParameters& parameters) {
  CollapseSettings settings;
  settings.kind = kind;
  settings.halfedge = halfedge;
  settings.search.strategy = parameters.target;
  if (kind == EdgeKind::gamma && !halfedge) settings.search.kernel_samples = most_sample_targets;
  return settings;
}

} // namespace isoscope
