// Keeps the tetrahedron of every witness and inserts the witnesses that Z has on the wrong side.
#include "refine/witnesses.h"

#include "mesh/label_functions.h"

namespace isoscope {

bool WitnessCondition::good(std::size_t witness) {
  LiveTriangulation& live = context_.live();
  Place& place = places_[witness];
  if (live.alive(place.tet) && live.generation(place.tet) == place.generation) return place.good;
  const Witness& where = context_.volume().witnesses()[witness];
  place.tet = live.delaunay().locate(where.point, context_.hint());
  if (!place.tet.valid()) {
    place.good = where.label == context_.volume().regions().front().label; // outside of the box
    return place.good;
  }
  place.generation = live.generation(place.tet);
  place.good = LabelFunctions(live.complex(), place.tet).of(where.label)(where.point) > 0;
  return place.good;
}

bool WitnessCondition::holds() {
  const auto witnesses = context_.volume().witnesses();
  places_.resize(witnesses.size());
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    if (!good(i)) return false;
  }
  return true;
}

void WitnessCondition::give_up(Vec3 point) {
  const auto witnesses = context_.volume().witnesses();
  places_.resize(witnesses.size());
  for (std::size_t i = 0; i < witnesses.size(); ++i)
    if (witnesses[i].point == point) places_[i].given_up = true;
}

Turn WitnessCondition::turn() {
  const auto witnesses = context_.volume().witnesses();
  places_.resize(witnesses.size());
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    const Witness& witness = witnesses[i];
    if (places_[i].given_up || good(i)) continue;
    Event event;
    event.condition = Condition::witness;
    event.reason = Reason::region_witness;
    event.tet = places_[i].tet;
    event.witness = witness.point;
    event.value = witness.depth;
    event.limit = context_.volume().thresholds().delta;
    const Vertex vertex = context_.free_vertex(witness.point, witness.label, VertexKind::witness);
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
