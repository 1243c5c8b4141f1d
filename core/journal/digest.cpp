// The fields of each record in the order of their declarations.
#include "journal/digest.h"

#include <bit>
#include <cstdio>

namespace isoscope {

void Digest::add(double value) {
  add(std::bit_cast<std::uint64_t>(value));
}

void Digest::add(Vec3 v) {
  add(v.x);
  add(v.y);
  add(v.z);
}

void Digest::add(std::string_view text) {
  add(text.size());
  for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
}

void Digest::add(const Event& e) {
  add(e.kind);
  add(e.stage);
  add(e.condition);
  add(e.reason);
  add(e.step);
  add(e.operation);
  add(e.tet);
  add(e.sample);
  add(e.vertex);
  add(e.other);
  add(e.point);
  add(e.witness);
  add(e.value);
  add(e.limit);
  if (e.facet[0].valid()) // recordings of format 1 have none
    for (const VertexId v : e.facet) add(v);
  add(e.count);
  add(e.text);
  add(e.detail);
}

void Digest::add(const RepairSweep& s) {
  add(s.largest_distance);
  add(s.distance_left);
  for (const Vec3& corner : s.worst_facet) add(corner);
  add(s.energy);
  add(s.moved);
  add(s.flipped);
  add(s.points_added);
}

void Digest::add(const Vertex& v) {
  add(v.position);
  add(v.value);
  add(v.kind);
  add(v.sample_set);
  add(v.sample);
}

void Digest::add(const TetRecord& t) {
  add(t.id);
  for (const VertexId v : t.v) add(v);
  add(t.side);
}

void Digest::add(const FacetRecord& f) {
  add(f.id);
  for (const VertexId v : f.v) add(v);
}

void Digest::add(const Delta& d) {
  for (const Vertex& v : d.added_vertices) add(v);
  for (const VertexId v : d.killed_vertices) add(v);
  for (const auto& c : d.values) {
    add(c.vertex);
    add(c.before);
    add(c.after);
  }
  for (const auto& m : d.moves) {
    add(m.vertex);
    add(m.before);
    add(m.after);
  }
  for (const TetRecord& t : d.removed) add(t);
  for (const TetRecord& t : d.added) add(t);
  for (const auto& s : d.sides) {
    add(s.tet);
    add(s.before);
    add(s.after);
  }
  for (const FacetRecord& f : d.removed_facets) add(f);
  for (const FacetRecord& f : d.added_facets) add(f);
  if (d.sample_set) {
    add(d.sample_set->before);
    add(d.sample_set->after);
  }
  if (d.form) {
    add(d.form->before);
    add(d.form->after);
  }
}

void Digest::add(const Complex& c) {
  for (const Vertex& v : c.vertices) {
    add(v);
    add(v.alive);
  }
  for (const Tet& t : c.tets) {
    for (const VertexId v : t.v) add(v);
    for (const TetId n : t.neighbor) add(n);
    add(t.side);
  }
  for (const ZeroFacet& f : c.facets)
    for (const VertexId v : f.v) add(v);
  add(c.form);
}

std::uint64_t digest(const Complex& complex) {
  Digest d;
  d.add(complex);
  return d.value();
}

std::uint64_t digest(const Delta& delta) {
  Digest d;
  d.add(delta);
  d.add(delta.slots_before);
  d.add(delta.facet_slots_before);
  return d.value();
}

std::string digest_text(std::uint64_t digest) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(digest));
  return text;
}

} // namespace isoscope
