// Keeps the tetrahedron of every witness and inserts the witnesses that Z has on the wrong side.
#include "refine/witnesses.h"

#include "mesh/label_functions.h"

namespace isoscope {

std::size_t WitnessCondition::count() const {
  return context_.volume().cover_path().size() + context_.volume().witnesses().size();
}

const Witness& WitnessCondition::witness(std::size_t i) const {
  const auto path = context_.volume().cover_path();
  return i < path.size() ? path[i] : context_.volume().witnesses()[i - path.size()];
}

bool WitnessCondition::good(std::size_t i) {
  LiveTriangulation& live = context_.live();
  Place& place = places_[i];
  if (live.alive(place.tet) && live.generation(place.tet) == place.generation) return place.good;
  const Witness& where = witness(i);
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
  places_.resize(count());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!witness(i).cover && !good(i)) return false;
  }
  return true;
}

void WitnessCondition::give_up(Vec3 point) {
  places_.resize(count());
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (witness(i).point == point) places_[i].given_up = true;
}

Turn WitnessCondition::turn() {
  places_.resize(count());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].given_up || good(i)) continue;
    const Witness& where = witness(i);
    Event event;
    event.condition = Condition::witness;
    event.reason = where.cover ? Reason::thin_part : Reason::region_witness;
    event.tet = places_[i].tet;
    event.witness = where.point;
    event.value = where.depth;
    event.limit = context_.volume().thresholds().delta;
    const Vertex vertex = context_.free_vertex(where.point, where.label, VertexKind::witness);
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
