// The fields of each record in the order of their declarations.
#include "journal/digest.h"

#include <bit>
#include <cstdio>

namespace isoscope {

void Digest::add(double value) {
  add(std::bit_cast<std::uint64_t>(value));
}

void Digest::add(Vec3 v) {
  add(v.x, v.y, v.z);
}

void Digest::add(std::string_view text) {
  add(text.size());
  for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
}

void Digest::add(const Event& e) {
  add(e.kind, e.stage, e.condition, e.reason, e.step, e.operation, e.tet, e.sample, e.vertex, e.other,
      e.point, e.witness, e.value, e.limit);
  if (e.facet[0].valid()) each(e.facet); // recordings of format 1 have none
  add(e.count, e.text, e.detail);
}

void Digest::add(const RepairSweep& s) {
  add(s.largest_distance, s.distance_left);
  each(s.worst_facet);
  add(s.energy, s.moved, s.flipped, s.points_added);
}

void Digest::add(const Vertex& v) {
  add(v.position, v.value, v.kind, v.sample_set, v.sample);
  if (v.room != 1) add(v.room); // two labels keep the digests that they had without it
}

void Digest::add(const TetRecord& t) {
  add(t.id);
  each(t.v);
  add(t.side);
  if (t.dropped != 0) add(t.dropped); // closed surfaces keep the digests that they had without it
}

void Digest::add(const FacetRecord& f) {
  add(f.id);
  each(f.v);
}

void Digest::add(const Delta& d) {
  each(d.added_vertices);
  each(d.killed_vertices);
  for (const auto& c : d.values) add(c.vertex, c.before, c.after);
  for (const auto& m : d.moves) add(m.vertex, m.before, m.after);
  each(d.removed);
  each(d.added);
  for (const auto& s : d.sides) add(s.tet, s.before, s.after);
  for (const auto& c : d.dropped) add(c.tet, c.before, c.after);
  each(d.removed_facets);
  each(d.added_facets);
  if (d.sample_set) add(d.sample_set->before, d.sample_set->after);
  if (d.form) add(d.form->before, d.form->after);
  for (const LabelPair labels : d.facet_labels) add(labels.front, labels.back);
}

void Digest::add(const Complex& c) {
  for (const Vertex& v : c.vertices) add(v, v.alive);
  for (const Tet& t : c.tets) {
    each(t.v);
    each(t.neighbor);
    add(t.side);
    if (t.dropped != 0) add(t.dropped);
  }
  for (const ZeroFacet& f : c.facets) each(f.v);
  for (const LabelPair labels : c.facet_labels) add(labels.front, labels.back);
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
