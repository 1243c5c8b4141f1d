// A mask of the parts that are there, then each part; ids as differences to the ones before.
#include "recording/delta_codec.h"

namespace isoscope {

namespace {

/// The parts of a delta, as bits of its first number.
constexpr std::uint64_t part_vertices = 1, part_killed = 2, part_values = 4, part_moves = 8,
                        part_removed = 16, part_added = 32, part_slots = 64, part_sides = 128,
                        part_removed_facets = 256, part_added_facets = 512, part_facet_slots = 1024,
                        part_sample_set = 2048, part_form = 4096;

/// Slots are handed out densely and each is told with some bytes: what lies beyond this many and so many more
/// a byte is damage, and must not ask for memory.
constexpr std::size_t slots_at_first = 4096, slots_per_byte = 16;

/// A number that is a difference to the one before, with flags below it.
class IdWriter {
 public:
  explicit IdWriter(ByteWriter& out) : out_(&out) {}
  void put(std::uint32_t id, unsigned flag_bits = 0, std::uint64_t flags = 0) {
    const std::int64_t difference = std::int64_t{id} - std::int64_t{last_};
    out_->number(fold_sign(difference) << flag_bits | flags);
    last_ = id;
  }

 private:
  ByteWriter* out_;
  std::uint32_t last_ = 0;
};

class IdReader {
 public:
  explicit IdReader(ByteReader& in) : in_(&in) {}
  std::uint32_t get(unsigned flag_bits = 0, std::uint64_t* flags = nullptr) {
    const std::uint64_t number = in_->number();
    if (flags != nullptr) *flags = number & ((1u << flag_bits) - 1);
    last_ = static_cast<std::uint32_t>(moved_by(last_, unfold_sign(number >> flag_bits)));
    return last_;
  }

 private:
  ByteReader* in_;
  std::uint32_t last_ = 0;
};

void write(ByteWriter& out, Vec3 v) {
  out.real(v.x);
  out.real(v.y);
  out.real(v.z);
}

Vec3 read_point(ByteReader& in) {
  Vec3 v;
  v.x = in.real();
  v.y = in.real();
  v.z = in.real();
  return v;
}

bool same_bits(Vec3 a, Vec3 b) {
  return isoscope::same_bits(a.x, b.x) && isoscope::same_bits(a.y, b.y) && isoscope::same_bits(a.z, b.z);
}

/// F is a label nearly always: two bits then.
unsigned value_tag(double value) {
  return value == 1 ? 0 : value == -1 ? 1 : isoscope::same_bits(value, 0) ? 2 : 3;
}

void write_value(ByteWriter& out, double value, unsigned tag) {
  if (tag == 3) out.real(value);
}

double read_value(ByteReader& in, std::uint64_t tag) {
  return tag == 0 ? 1 : tag == 1 ? -1 : tag == 2 ? 0 : in.real();
}

template <std::size_t N>
void write_corners(ByteWriter& out, const std::array<VertexId, N>& v, VertexId& last) {
  std::uint32_t before = last.value;
  for (const VertexId corner : v) {
    out.signed_number(std::int64_t{corner.value} - std::int64_t{before});
    before = corner.value;
  }
  last = v[0];
}

template <std::size_t N> void read_corners(ByteReader& in, std::array<VertexId, N>& v, VertexId& last) {
  std::uint32_t before = last.value;
  for (VertexId& corner : v) {
    before = static_cast<std::uint32_t>(moved_by(before, in.signed_number()));
    corner = VertexId(before);
  }
  last = v[0];
}

void write_vertices(ByteWriter& out, const std::vector<Vertex>& vertices) {
  out.number(vertices.size());
  for (const Vertex& v : vertices) {
    const unsigned tag = value_tag(v.value);
    out.byte(static_cast<std::uint8_t>(static_cast<unsigned>(v.kind) | (v.alive ? 8u : 0u) | tag << 4));
    write(out, v.position);
    write_value(out, v.value, tag);
    out.number(v.sample_set);
    out.number(v.sample.value + 1u);
  }
}

void read_vertices(ByteReader& in, std::vector<Vertex>& vertices) {
  vertices.resize(in.count(27));
  for (Vertex& v : vertices) {
    const unsigned head = in.byte();
    v.kind = static_cast<VertexKind>(head & 7);
    v.alive = (head & 8) != 0;
    v.position = read_point(in);
    v.value = read_value(in, head >> 4 & 3);
    v.sample_set = static_cast<std::uint16_t>(in.number());
    v.sample = SampleId(static_cast<std::uint32_t>(in.number()) - 1u);
    if ((head & 7) > static_cast<unsigned>(VertexKind::zero)) in.fail();
  }
}

void write_killed(ByteWriter& out, const std::vector<VertexId>& killed) {
  out.number(killed.size());
  IdWriter ids(out);
  for (const VertexId v : killed) ids.put(v.value);
}

void read_killed(ByteReader& in, std::vector<VertexId>& killed) {
  killed.resize(in.count(1));
  IdReader ids(in);
  for (VertexId& v : killed) v = VertexId(ids.get());
}

void write_values(ByteWriter& out, const std::vector<Delta::ValueChange>& changes, DeltaMirror& mirror) {
  out.number(changes.size());
  IdWriter ids(out);
  for (const auto& c : changes) {
    double& held = mirror.values[c.vertex.index()];
    const bool known = isoscope::same_bits(held, c.before);
    const unsigned tag = value_tag(c.after);
    ids.put(c.vertex.value, 3, (known ? 4u : 0u) | tag);
    if (!known) out.real(c.before);
    write_value(out, c.after, tag);
    held = c.after;
  }
}

void read_values(ByteReader& in, std::vector<Delta::ValueChange>& changes, DeltaMirror& mirror) {
  changes.resize(in.count(1));
  IdReader ids(in);
  for (auto& c : changes) {
    std::uint64_t flags = 0;
    c.vertex = VertexId(ids.get(3, &flags));
    if (c.vertex.index() >= mirror.values.size()) return in.fail();
    double& held = mirror.values[c.vertex.index()];
    c.before = (flags & 4) != 0 ? held : in.real();
    c.after = read_value(in, flags & 3);
    held = c.after;
  }
}

void write_moves(ByteWriter& out, const std::vector<Delta::Move>& moves, DeltaMirror& mirror) {
  out.number(moves.size());
  IdWriter ids(out);
  for (const auto& m : moves) {
    Vec3& held = mirror.positions[m.vertex.index()];
    const bool known = same_bits(held, m.before);
    ids.put(m.vertex.value, 1, known ? 1 : 0);
    if (!known) write(out, m.before);
    write(out, m.after);
    held = m.after;
  }
}

void read_moves(ByteReader& in, std::vector<Delta::Move>& moves, DeltaMirror& mirror) {
  moves.resize(in.count(25));
  IdReader ids(in);
  for (auto& m : moves) {
    std::uint64_t known = 0;
    m.vertex = VertexId(ids.get(1, &known));
    if (m.vertex.index() >= mirror.positions.size()) return in.fail();
    Vec3& held = mirror.positions[m.vertex.index()];
    m.before = known != 0 ? held : read_point(in);
    m.after = read_point(in);
    held = m.after;
  }
}

void write_sides(ByteWriter& out, const std::vector<Delta::SideChange>& sides, DeltaMirror& mirror) {
  out.number(sides.size());
  IdWriter ids(out);
  for (const auto& s : sides) {
    std::int8_t& held = mirror.cells[s.tet.index()].side;
    const bool known = held == s.before;
    ids.put(s.tet.value, 1, known ? 1 : 0);
    if (!known) out.signed_number(s.before);
    out.signed_number(s.after);
    held = s.after;
  }
}

void read_sides(ByteReader& in, std::vector<Delta::SideChange>& sides, DeltaMirror& mirror) {
  sides.resize(in.count(2));
  IdReader ids(in);
  for (auto& s : sides) {
    std::uint64_t known = 0;
    s.tet = TetId(ids.get(1, &known));
    if (s.tet.index() >= mirror.cells.size()) return in.fail();
    std::int8_t& held = mirror.cells[s.tet.index()].side;
    s.before = known != 0 ? held : static_cast<std::int8_t>(in.signed_number());
    s.after = static_cast<std::int8_t>(in.signed_number());
    held = s.after;
  }
}

void write_removed(ByteWriter& out, const std::vector<TetRecord>& removed, const DeltaMirror& mirror) {
  out.number(removed.size());
  IdWriter ids(out);
  VertexId last(0u);
  for (const TetRecord& t : removed) {
    const bool known =
        t.id.index() < mirror.cells.size() && mirror.cells[t.id.index()] == DeltaMirror::Cell{t.v, t.side};
    ids.put(t.id.value, 1, known ? 1 : 0);
    if (known) continue;
    write_corners(out, t.v, last);
    out.signed_number(t.side);
  }
}

void read_removed(ByteReader& in, std::vector<TetRecord>& removed, const DeltaMirror& mirror) {
  removed.resize(in.count(1));
  IdReader ids(in);
  VertexId last(0u);
  for (TetRecord& t : removed) {
    std::uint64_t known = 0;
    t.id = TetId(ids.get(1, &known));
    if (known != 0) {
      if (t.id.index() >= mirror.cells.size()) return in.fail();
      t.v = mirror.cells[t.id.index()].v;
      t.side = mirror.cells[t.id.index()].side;
      continue;
    }
    read_corners(in, t.v, last);
    t.side = static_cast<std::int8_t>(in.signed_number());
  }
}

void write_added(ByteWriter& out, const std::vector<TetRecord>& added, DeltaMirror& mirror) {
  out.number(added.size());
  IdWriter ids(out);
  VertexId last(0u);
  for (const TetRecord& t : added) {
    ids.put(t.id.value, 2, fold_sign(t.side));
    write_corners(out, t.v, last);
    mirror.put(t);
  }
}

void read_added(ByteReader& in, std::vector<TetRecord>& added, DeltaMirror& mirror, std::size_t slots) {
  added.resize(in.count(5));
  IdReader ids(in);
  VertexId last(0u);
  for (TetRecord& t : added) {
    std::uint64_t side = 0;
    t.id = TetId(ids.get(2, &side));
    t.side = static_cast<std::int8_t>(unfold_sign(side));
    read_corners(in, t.v, last);
    if (in.failed() || t.id.value >= slots) return in.fail();
    mirror.put(t);
  }
}

void write_removed_facets(ByteWriter& out, const std::vector<FacetRecord>& removed,
                          const DeltaMirror& mirror) {
  out.number(removed.size());
  IdWriter ids(out);
  VertexId last(0u);
  for (const FacetRecord& f : removed) {
    const bool known = f.id.index() < mirror.facets.size() && mirror.facets[f.id.index()] == f.v;
    ids.put(f.id.value, 1, known ? 1 : 0);
    if (!known) write_corners(out, f.v, last);
  }
}

void read_removed_facets(ByteReader& in, std::vector<FacetRecord>& removed, const DeltaMirror& mirror) {
  removed.resize(in.count(1));
  IdReader ids(in);
  VertexId last(0u);
  for (FacetRecord& f : removed) {
    std::uint64_t known = 0;
    f.id = FacetId(ids.get(1, &known));
    if (known == 0) {
      read_corners(in, f.v, last);
      continue;
    }
    if (f.id.index() >= mirror.facets.size()) return in.fail();
    f.v = mirror.facets[f.id.index()];
  }
}

void write_added_facets(ByteWriter& out, const std::vector<FacetRecord>& added, DeltaMirror& mirror) {
  out.number(added.size());
  IdWriter ids(out);
  VertexId last(0u);
  for (const FacetRecord& f : added) {
    ids.put(f.id.value);
    write_corners(out, f.v, last);
    mirror.put(f);
  }
}

void read_added_facets(ByteReader& in, std::vector<FacetRecord>& added, DeltaMirror& mirror,
                       std::size_t slots) {
  added.resize(in.count(4));
  IdReader ids(in);
  VertexId last(0u);
  for (FacetRecord& f : added) {
    f.id = FacetId(ids.get());
    read_corners(in, f.v, last);
    if (in.failed() || f.id.value >= slots) return in.fail();
    mirror.put(f);
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
         (d.form ? part_form : 0);
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
  cells[record.id.index()] = {record.v, record.side};
}

void DeltaMirror::put(const FacetRecord& record) {
  if (record.id.index() >= facets.size()) facets.resize(record.id.index() + 1);
  facets[record.id.index()] = record.v;
}

std::string_view DeltaEncoder::encode(const Delta& d) {
  out_.clear();
  const std::uint64_t parts = parts_of(d);
  out_.number(parts);
  if ((parts & part_vertices) != 0) write_vertices(out_, d.added_vertices);
  mirror_.add(d.added_vertices);
  if ((parts & part_killed) != 0) write_killed(out_, d.killed_vertices);
  if ((parts & part_values) != 0) write_values(out_, d.values, mirror_);
  if ((parts & part_moves) != 0) write_moves(out_, d.moves, mirror_);
  if ((parts & part_sides) != 0) write_sides(out_, d.sides, mirror_);
  if ((parts & part_removed) != 0) write_removed(out_, d.removed, mirror_);
  if ((parts & part_added) != 0) write_added(out_, d.added, mirror_);
  if ((parts & part_slots) != 0) out_.number(d.slots_before);
  if ((parts & part_removed_facets) != 0) write_removed_facets(out_, d.removed_facets, mirror_);
  if ((parts & part_added_facets) != 0) write_added_facets(out_, d.added_facets, mirror_);
  if ((parts & part_facet_slots) != 0) out_.number(d.facet_slots_before);
  if ((parts & part_sample_set) != 0) {
    out_.number(d.sample_set->before);
    out_.number(d.sample_set->after);
  }
  if ((parts & part_form) != 0) {
    out_.byte(static_cast<std::uint8_t>(d.form->before));
    out_.byte(static_cast<std::uint8_t>(d.form->after));
  }
  return out_.bytes();
}

bool DeltaDecoder::decode(std::string_view bytes, Delta& d) {
  d = {};
  bytes_ += bytes.size();
  const std::size_t slots = slots_at_first + slots_per_byte * bytes_;
  ByteReader in(bytes);
  const std::uint64_t parts = in.number();
  if ((parts & part_vertices) != 0) read_vertices(in, d.added_vertices);
  mirror_.add(d.added_vertices);
  if ((parts & part_killed) != 0) read_killed(in, d.killed_vertices);
  if ((parts & part_values) != 0) read_values(in, d.values, mirror_);
  if ((parts & part_moves) != 0) read_moves(in, d.moves, mirror_);
  if ((parts & part_sides) != 0) read_sides(in, d.sides, mirror_);
  if ((parts & part_removed) != 0) read_removed(in, d.removed, mirror_);
  if ((parts & part_added) != 0) read_added(in, d.added, mirror_, slots);
  if ((parts & part_slots) != 0) d.slots_before = static_cast<std::uint32_t>(in.number());
  if ((parts & part_removed_facets) != 0) read_removed_facets(in, d.removed_facets, mirror_);
  if ((parts & part_added_facets) != 0) read_added_facets(in, d.added_facets, mirror_, slots);
  if ((parts & part_facet_slots) != 0) d.facet_slots_before = static_cast<std::uint32_t>(in.number());
  if ((parts & part_sample_set) != 0) {
    Delta::SampleSetChange change;
    change.before = static_cast<std::uint16_t>(in.number());
    change.after = static_cast<std::uint16_t>(in.number());
    d.sample_set = change;
  }
  if ((parts & part_form) != 0) {
    const std::uint8_t before = in.byte(), after = in.byte();
    if (before > static_cast<std::uint8_t>(ZeroForm::free) ||
        after > static_cast<std::uint8_t>(ZeroForm::free))
      in.fail();
    d.form = Delta::FormChange{static_cast<ZeroForm>(before), static_cast<ZeroForm>(after)};
  }
  return in.exhausted() && d.slots_before <= slots && d.facet_slots_before <= slots;
}

} // namespace isoscope
