// A mask of the parts that are there, then each part; ids as differences to the ones before. Every part is
// told once: the same walk writes it or reads it.
#include "recording/delta_codec.h"

#include <limits>
#include <type_traits>

namespace isoscope {

namespace {

/// The parts of a delta, as bits of its first number.
constexpr std::uint64_t part_vertices = 1, part_killed = 2, part_values = 4, part_moves = 8,
                        part_removed = 16, part_added = 32, part_slots = 64, part_sides = 128,
                        part_removed_facets = 256, part_added_facets = 512, part_facet_slots = 1024,
                        part_sample_set = 2048, part_form = 4096, part_dropped = 8192,
                        part_facet_labels = 16384;

/// Slots are handed out densely and each is told with some bytes: what lies beyond this many and so many more
/// a byte is damage, and must not ask for memory.
constexpr std::size_t slots_at_first = 4096, slots_per_byte = 16;

/// Writes what it is shown.
class Writing {
 public:
  static constexpr bool writes = true;
  explicit Writing(ByteWriter& out) : out_(&out) {}
  void fail() const {}
  bool failed() const { return false; }
  void byte(std::uint8_t b) { out_->byte(b); }
  void number(std::uint64_t v) { out_->number(v); }
  void signed_number(std::int64_t v) { out_->signed_number(v); }
  void real(double v) { out_->real(v); }
  template <class List> void length(const List& list, std::size_t) { out_->number(list.size()); }

 private:
  ByteWriter* out_;
};

/// Fills what it is shown.
class Reading {
 public:
  static constexpr bool writes = false;
  explicit Reading(ByteReader& in) : in_(&in) {}
  void fail() { in_->fail(); }
  bool failed() const { return in_->failed(); }
  void byte(std::uint8_t& b) { b = in_->byte(); }
  template <class T> void number(T& v) { v = static_cast<T>(in_->number()); }
  template <class T> void signed_number(T& v) { v = static_cast<T>(in_->signed_number()); }
  void real(double& v) { v = in_->real(); }
  /// `least`: bytes of one element.
  template <class List> void length(List& list, std::size_t least) { list.resize(in_->count(least)); }

 private:
  ByteReader* in_;
};

template <class Io, class T> using Shown = std::conditional_t<Io::writes, const T, T>;
template <class Record> constexpr bool has_side = requires(Record record) {
  record.side;
};

/// Numbers that are differences to the ones before, with flags below them.
template <class Io> class Ids {
 public:
  explicit Ids(Io& io) : io_(&io) {}
  template <class IdType> void pass(IdType& id, unsigned flag_bits, std::uint64_t& flags) {
    std::uint64_t number = 0;
    if constexpr (Io::writes)
      number = fold_sign(std::int64_t{id.value} - std::int64_t{last_}) << flag_bits | flags;
    io_->number(number);
    if constexpr (!Io::writes) {
      flags = number & ((1u << flag_bits) - 1);
      id = IdType(static_cast<std::uint32_t>(moved_by(last_, unfold_sign(number >> flag_bits))));
    }
    last_ = id.value;
  }
  template <class IdType> void pass(IdType& id) {
    std::uint64_t none = 0;
    pass(id, 0, none);
  }

 private:
  Io* io_;
  std::uint32_t last_ = 0;
};

template <class Io> void pass_point(Io& io, Shown<Io, Vec3>& v) {
  io.real(v.x);
  io.real(v.y);
  io.real(v.z);
}

bool same_place(Vec3 a, Vec3 b) {
  return isoscope::same_bits(a.x, b.x) && isoscope::same_bits(a.y, b.y) && isoscope::same_bits(a.z, b.z);
}

/// F is a label nearly always: two bits then.
unsigned value_tag(double value) {
  return value == 1 ? 0 : value == -1 ? 1 : isoscope::same_bits(value, 0) ? 2 : 3;
}

template <class Io> void pass_value(Io& io, Shown<Io, double>& value, std::uint64_t tag) {
  if (tag == 3)
    io.real(value);
  else if constexpr (!Io::writes)
    value = tag == 0 ? 1 : tag == 1 ? -1 : 0;
}

/// Two labels without dropped facets are the rule: two bits then.
constexpr unsigned side_bits = 2;
constexpr std::uint64_t other_side = 3;
std::uint64_t side_tag(const TetRecord& record) {
  const std::uint64_t folded = fold_sign(record.side);
  return folded < other_side && record.dropped == 0 ? folded : other_side;
}

template <class Io> void pass_dropped(Io& io, Shown<Io, std::uint8_t>& dropped) {
  io.byte(dropped);
  if (dropped > 15) io.fail();
}

template <class Io> void pass_side(Io& io, Shown<Io, TetRecord>& record, std::uint64_t tag) {
  if (tag == other_side) {
    io.signed_number(record.side);
    pass_dropped(io, record.dropped);
  } else if constexpr (!Io::writes) {
    record.side = static_cast<std::int8_t>(unfold_sign(tag));
  }
}

template <class Io, class Corners> void pass_corners(Io& io, Corners& v, VertexId& last) {
  std::uint32_t before = last.value;
  for (auto& corner : v) {
    std::int64_t difference = 0;
    if constexpr (Io::writes) difference = std::int64_t{corner.value} - std::int64_t{before};
    io.signed_number(difference);
    if constexpr (!Io::writes) corner = VertexId(static_cast<std::uint32_t>(moved_by(before, difference)));
    before = corner.value;
  }
  last = v[0];
}

/// Above the kind in a vertex's first byte.
constexpr unsigned alive_bit = 8, room_bit = 64;

template <class Io> void pass_vertices(Io& io, Shown<Io, std::vector<Vertex>>& vertices) {
  io.length(vertices, 27);
  for (auto& v : vertices) {
    std::uint8_t head = 0;
    std::uint32_t sample = 0;
    if constexpr (Io::writes) {
      head = static_cast<std::uint8_t>(static_cast<unsigned>(v.kind) | (v.alive ? alive_bit : 0) |
                                       value_tag(v.value) << 4 | (v.room != 1 ? room_bit : 0));
      sample = v.sample.value + 1u;
    }
    io.byte(head);
    pass_point(io, v.position);
    pass_value(io, v.value, head >> 4 & 3);
    io.number(v.sample_set);
    io.number(sample);
    if ((head & room_bit) != 0) io.signed_number(v.room);
    if constexpr (!Io::writes) {
      v.kind = static_cast<VertexKind>(head & 7);
      v.alive = (head & alive_bit) != 0;
      if (v.room < 1) io.fail();
      v.sample = SampleId(sample - 1u);
      if ((head & 7) > static_cast<int>(VertexKind::zero)) io.fail();
    }
  }
}

template <class Io> void pass_killed(Io& io, Shown<Io, std::vector<VertexId>>& killed) {
  io.length(killed, 1);
  Ids ids(io);
  for (auto& v : killed) ids.pass(v);
}

/// What the mirror holds of an element; null, and failed, beyond its end.
template <class Io, class Held, class IdType> Held* held_at(Io& io, std::vector<Held>& all, IdType id) {
  if (id.index() < all.size()) return &all[id.index()];
  io.fail();
  return nullptr;
}

template <class Io>
void pass_values(Io& io, Shown<Io, std::vector<Delta::ValueChange>>& changes, DeltaMirror& mirror) {
  constexpr std::uint64_t known = 4;
  io.length(changes, 1);
  Ids ids(io);
  for (auto& c : changes) {
    std::uint64_t flags = 0;
    if constexpr (Io::writes)
      flags =
          (isoscope::same_bits(mirror.values[c.vertex.index()], c.before) ? known : 0) | value_tag(c.after);
    ids.pass(c.vertex, 3, flags);
    double* const held = held_at(io, mirror.values, c.vertex);
    if (held == nullptr) return;
    if ((flags & known) == 0)
      io.real(c.before);
    else if constexpr (!Io::writes)
      c.before = *held;
    pass_value(io, c.after, flags & 3);
    *held = c.after;
  }
}

template <class Io> void pass_moves(Io& io, Shown<Io, std::vector<Delta::Move>>& moves, DeltaMirror& mirror) {
  io.length(moves, 25);
  Ids ids(io);
  for (auto& m : moves) {
    std::uint64_t known = 0;
    if constexpr (Io::writes) known = same_place(mirror.positions[m.vertex.index()], m.before) ? 1 : 0;
    ids.pass(m.vertex, 1, known);
    Vec3* const held = held_at(io, mirror.positions, m.vertex);
    if (held == nullptr) return;
    if (known == 0)
      pass_point(io, m.before);
    else if constexpr (!Io::writes)
      m.before = *held;
    pass_point(io, m.after);
    *held = m.after;
  }
}

template <class Io>
void pass_sides(Io& io, Shown<Io, std::vector<Delta::SideChange>>& sides, DeltaMirror& mirror) {
  io.length(sides, 2);
  Ids ids(io);
  for (auto& s : sides) {
    std::uint64_t known = 0;
    if constexpr (Io::writes) known = mirror.cells[s.tet.index()].side == s.before ? 1 : 0;
    ids.pass(s.tet, 1, known);
    DeltaMirror::Cell* const held = held_at(io, mirror.cells, s.tet);
    if (held == nullptr) return;
    if (known == 0)
      io.signed_number(s.before);
    else if constexpr (!Io::writes)
      s.before = held->side;
    io.signed_number(s.after);
    held->side = s.after;
  }
}

template <class Io>
void pass_dropped_changes(Io& io, Shown<Io, std::vector<Delta::DroppedChange>>& changes,
                          DeltaMirror& mirror) {
  io.length(changes, 2);
  Ids ids(io);
  for (auto& c : changes) {
    std::uint64_t known = 0;
    if constexpr (Io::writes) known = mirror.cells[c.tet.index()].dropped == c.before ? 1 : 0;
    ids.pass(c.tet, 1, known);
    DeltaMirror::Cell* const held = held_at(io, mirror.cells, c.tet);
    if (held == nullptr) return;
    if (known == 0)
      pass_dropped(io, c.before);
    else if constexpr (!Io::writes)
      c.before = held->dropped;
    pass_dropped(io, c.after);
    held->dropped = c.after;
  }
}

/// Of tetrahedra and of facets.
template <class Io, class List> void pass_removed(Io& io, List& removed, const DeltaMirror& mirror) {
  io.length(removed, 1);
  Ids ids(io);
  VertexId last(0u);
  for (auto& record : removed) {
    std::uint64_t known = 0;
    if constexpr (Io::writes) known = mirror.holds(record) ? 1 : 0;
    ids.pass(record.id, 1, known);
    if (known == 0) {
      pass_corners(io, record.v, last);
      if constexpr (has_side<typename List::value_type>) pass_side(io, record, other_side);
    } else if constexpr (!Io::writes) {
      if (!mirror.recall(record)) return io.fail();
    }
  }
}

/// `least`: bytes of one; `slots`: what their ids are below.
template <class Io, class List>
void pass_added(Io& io, List& added, DeltaMirror& mirror, std::size_t least, std::size_t slots) {
  constexpr bool sided = has_side<typename List::value_type>;
  io.length(added, least);
  Ids ids(io);
  VertexId last(0u);
  for (auto& record : added) {
    std::uint64_t side = 0;
    if constexpr (Io::writes && sided) side = side_tag(record);
    ids.pass(record.id, sided ? side_bits : 0, side);
    if constexpr (sided) pass_side(io, record, side);
    pass_corners(io, record.v, last);
    if (io.failed() || record.id.value >= slots) return io.fail();
    mirror.put(record);
  }
}

std::uint64_t parts_of(const Delta& d) {
  return (d.added_vertices.empty() ? 0 : part_vertices) | (d.killed_vertices.empty() ? 0 : part_killed) |
         (d.values.empty() ? 0 : part_values) | (d.moves.empty() ? 0 : part_moves) |
         (d.removed.empty() ? 0 : part_removed) | (d.added.empty() ? 0 : part_added) |
         (d.slots_before == 0 ? 0 : part_slots) | (d.sides.empty() ? 0 : part_sides) |
         (d.removed_facets.empty() ? 0 : part_removed_facets) |
         (d.added_facets.empty() ? 0 : part_added_facets) |
         (d.facet_slots_before == 0 ? 0 : part_facet_slots) | (d.sample_set ? part_sample_set : 0) |
         (d.form ? part_form : 0) | (d.dropped.empty() ? 0 : part_dropped) |
         (d.facet_labels.empty() ? 0 : part_facet_labels);
}

template <class Io> void pass_form(Io& io, Shown<Io, ZeroForm>& form) {
  auto number = static_cast<std::uint8_t>(form);
  io.byte(number);
  if (number > static_cast<std::uint8_t>(ZeroForm::free)) return io.fail();
  if constexpr (!Io::writes) form = static_cast<ZeroForm>(number);
}

template <class Io> void pass_facet_labels(Io& io, Shown<Io, std::vector<LabelPair>>& labels) {
  io.length(labels, 2);
  for (auto& pair : labels) {
    io.signed_number(pair.front);
    io.signed_number(pair.back);
  }
}

template <class Io> void pass(Io& io, Shown<Io, Delta>& d, DeltaMirror& mirror, std::size_t slots) {
  std::uint64_t parts = 0;
  if constexpr (Io::writes) parts = parts_of(d);
  io.number(parts);
  const auto has = [&](std::uint64_t part) { return (parts & part) != 0; };
  if (has(part_vertices)) pass_vertices(io, d.added_vertices);
  mirror.add(d.added_vertices);
  if (has(part_killed)) pass_killed(io, d.killed_vertices);
  if (has(part_values)) pass_values(io, d.values, mirror);
  if (has(part_moves)) pass_moves(io, d.moves, mirror);
  if (has(part_sides)) pass_sides(io, d.sides, mirror);
  if (has(part_dropped)) pass_dropped_changes(io, d.dropped, mirror);
  if (has(part_removed)) pass_removed(io, d.removed, mirror);
  if (has(part_added)) pass_added(io, d.added, mirror, 5, slots);
  if (has(part_slots)) io.number(d.slots_before);
  if (has(part_removed_facets)) pass_removed(io, d.removed_facets, mirror);
  if (has(part_added_facets)) pass_added(io, d.added_facets, mirror, 4, slots);
  if (has(part_facet_slots)) io.number(d.facet_slots_before);
  if (has(part_sample_set)) {
    if constexpr (!Io::writes) d.sample_set = Delta::SampleSetChange{};
    io.number(d.sample_set->before);
    io.number(d.sample_set->after);
  }
  if (has(part_form)) {
    if constexpr (!Io::writes) d.form = Delta::FormChange{};
    pass_form(io, d.form->before);
    pass_form(io, d.form->after);
  }
  if (has(part_facet_labels)) pass_facet_labels(io, d.facet_labels);
}

} // namespace

void DeltaMirror::add(const std::vector<Vertex>& vertices) {
  for (const Vertex& v : vertices) {
    positions.push_back(v.position);
    values.push_back(v.value);
  }
}

void DeltaMirror::put(const TetRecord& record) {
  if (record.id.index() >= cells.size()) cells.resize(record.id.index() + 1);
  cells[record.id.index()] = {record.v, record.side, record.dropped};
}

void DeltaMirror::put(const FacetRecord& record) {
  if (record.id.index() >= facets.size()) facets.resize(record.id.index() + 1);
  facets[record.id.index()] = record.v;
}

bool DeltaMirror::holds(const TetRecord& record) const {
  return record.id.index() < cells.size() &&
         cells[record.id.index()] == Cell{record.v, record.side, record.dropped};
}

bool DeltaMirror::holds(const FacetRecord& record) const {
  return record.id.index() < facets.size() && facets[record.id.index()] == record.v;
}

bool DeltaMirror::recall(TetRecord& record) const {
  if (record.id.index() >= cells.size()) return false;
  record.v = cells[record.id.index()].v;
  record.side = cells[record.id.index()].side;
  record.dropped = cells[record.id.index()].dropped;
  return true;
}

bool DeltaMirror::recall(FacetRecord& record) const {
  if (record.id.index() >= facets.size()) return false;
  record.v = facets[record.id.index()];
  return true;
}

std::string_view DeltaEncoder::encode(const Delta& d) {
  out_.clear();
  Writing io(out_);
  pass(io, d, mirror_, std::numeric_limits<std::size_t>::max());
  return out_.bytes();
}

bool DeltaDecoder::decode(std::string_view bytes, Delta& d) {
  d = {};
  bytes_ += bytes.size();
  const std::size_t slots = slots_at_first + slots_per_byte * bytes_;
  ByteReader in(bytes);
  Reading io(in);
  pass(io, d, mirror_, slots);
  return in.exhausted() && d.slots_before <= slots && d.facet_slots_before <= slots;
}

} // namespace isoscope
