// Keeps the tetrahedron of every witness and inserts the witnesses that Z has on the wrong side.
#include "refine/witnesses.h"

namespace isoscope {
namespace {

/// Regions that hardly rise above δ may be swallowed by Ω.
constexpr double depth_margin = 1.0001;

} // namespace

bool WitnessCondition::good(std::size_t region) {
  LiveTriangulation& live = context_.live();
  Place& place = places_[region];
  if (live.alive(place.tet) && live.generation(place.tet) == place.generation) return place.good;
  const Region& where = context_.volume().regions()[region];
  place.tet = live.delaunay().locate(where.deepest, context_.hint());
  if (!place.tet.valid()) {
    place.good = where.unbounded;
    return place.good;
  }
  place.generation = live.generation(place.tet);
  const AffineFunction f = interpolate(live.complex().positions(place.tet), live.complex().values(place.tet));
  place.good = f(where.deepest) * where.label > 0;
  return place.good;
}

bool WitnessCondition::holds() {
  const auto regions = context_.volume().regions();
  places_.resize(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (regions[i].depth > depth_margin * context_.volume().thresholds().delta && !good(i)) return false;
  }
  return true;
}

Turn WitnessCondition::turn() {
  const auto regions = context_.volume().regions();
  places_.resize(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const Region& region = regions[i];
    if (region.depth <= depth_margin * context_.volume().thresholds().delta) continue;
    if (places_[i].given_up || good(i)) continue;
    Event event;
    event.condition = Condition::witness;
    event.reason = Reason::region_witness;
    event.tet = places_[i].tet;
    event.witness = region.deepest;
    event.value = region.depth;
    event.limit = context_.volume().thresholds().delta;
    const Vertex vertex = context_.free_vertex(region.deepest, region.label, VertexKind::witness);
    if (context_.insert(vertex, places_[i].tet, event)) return Turn::acted;
    places_[i].given_up = true;
    event.kind = EventKind::exhausted;
    event.reason = Reason::already_vertex;
    context_.note(event);
    return Turn::acted;
  }
  return Turn::satisfied;
}

} // namespace isoscope
