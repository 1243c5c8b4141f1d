// Appends events and operations, keeps the byte count, and digests a journal.
#include "journal/journal.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <type_traits>

namespace isoscope {

Journal::Journal() {
  texts_.push_back({});
  repairs_.push_back({});
}

CriteriaParameters Journal::parameters_at(Step step) const {
  CriteriaParameters found;
  for (std::size_t i = 0, n = parameters_.size(); i < n && (i == 0 || parameters_[i].step <= step); ++i) {
    found = parameters_[i].criteria;
  }
  return found;
}

std::uint32_t Journal::add_text(std::string text) {
  bytes_.fetch_add(sizeof(std::string) + text.size(), std::memory_order_relaxed);
  texts_.push_back(std::move(text));
  return static_cast<std::uint32_t>(texts_.size() - 1);
}

std::uint32_t Journal::add_repair(RepairDetail sweeps) {
  bytes_.fetch_add(sizeof(RepairDetail) + sweeps.capacity() * sizeof(RepairSweep), std::memory_order_relaxed);
  repairs_.push_back(std::move(sweeps));
  return static_cast<std::uint32_t>(repairs_.size() - 1);
}

std::uint16_t Journal::add_sample_set(std::shared_ptr<const BoundarySamples> samples) {
  if (samples) {
    bytes_.fetch_add(samples->size() * (sizeof(Vec3) + sizeof(std::int8_t) + sizeof(std::uint16_t)),
                     std::memory_order_relaxed);
  }
  sample_sets_.push_back(std::move(samples));
  return static_cast<std::uint16_t>(sample_sets_.size() - 1);
}

void Journal::add_parameters(const CriteriaParameters& criteria) {
  parameters_.push_back({steps(), criteria});
}

std::uint32_t Journal::add_event(Event event) {
  event.step = steps();
  bytes_.fetch_add(sizeof(Event), std::memory_order_relaxed);
  const auto index = static_cast<std::uint32_t>(events_.size());
  if (event.kind == EventKind::stage_begin || event.kind == EventKind::stage_end ||
      event.kind == EventKind::stopped) {
    const std::chrono::duration<double> age = std::chrono::steady_clock::now() - made_;
    stage_marks_.push_back({index, age.count()});
  }
  events_.push_back(event);
  return index;
}

void Journal::take_prefix(const Journal& from, Step step) {
  const std::size_t operations = std::min<std::size_t>(step, from.operations().size());
  const std::size_t end =
      operations < from.operations().size() ? from.operations()[operations].event : from.events().size();
  std::size_t mark = 0, next = 0;
  double age = 0;
  for (std::size_t i = 0; i < end; ++i) {
    events_.push_back(from.events()[i]);
    if (mark < from.stage_marks().size() && from.stage_marks()[mark].event == i) {
      age = from.stage_marks()[mark].seconds;
      stage_marks_.push_back(from.stage_marks()[mark++]);
    }
    if (next < operations && from.operations()[next].event == i)
      operations_.push_back(from.operations()[next++]);
  }
  for (std::size_t i = 0, n = from.sample_sets().size(); i < n; ++i)
    sample_sets_.push_back(from.sample_sets()[i]);
  for (std::size_t i = 0, n = from.parameters().size(); i < n && from.parameters()[i].step <= operations; ++i)
    parameters_.push_back(from.parameters()[i]);
  for (std::size_t i = 1, n = from.texts().size(); i < n; ++i) texts_.push_back(from.texts()[i]);
  for (std::size_t i = 1, n = from.repairs().size(); i < n; ++i) repairs_.push_back(from.repairs()[i]);
  bytes_.fetch_add(events_.size() * sizeof(Event) + operations_.size() * sizeof(Operation),
                   std::memory_order_relaxed);
  // Times go on where the last mark was.
  made_ = std::chrono::steady_clock::now() -
          std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(age));
}

void Journal::add_operation(Event event, Delta delta, const StepFigures& figures) {
  event.operation = true;
  const std::uint32_t index = add_event(event);
  bytes_.fetch_add(sizeof(Operation) + delta.memory_bytes(), std::memory_order_relaxed);
  operations_.push_back({index, std::make_shared<const Delta>(std::move(delta)), figures});
}

namespace {

/// FNV-1a over values, field by field: padding never enters.
class Digest {
 public:
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i, bits >>= 8) add_byte(static_cast<std::uint8_t>(bits & 0xff));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(Vec3 v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  template <class Tag> void add(Id<Tag> id) { add(id.value); }
  void add(std::string_view text) {
    add(text.size());
    for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
  }
  void add(const Event& e) {
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
    add(e.count);
    add(e.text);
    add(e.detail);
  }
  void add(const TetRecord& t) {
    add(t.id);
    for (const VertexId v : t.v) add(v);
    add(t.side);
  }
  void add(const FacetRecord& f) {
    add(f.id);
    for (const VertexId v : f.v) add(v);
  }
  void add(const Delta& d) {
    for (const Vertex& v : d.added_vertices) {
      add(v.position);
      add(v.value);
      add(v.kind);
      add(v.sample_set);
      add(v.sample);
    }
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
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
  void add_byte(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
};

} // namespace

std::uint64_t digest(const Journal& journal) {
  Digest d;
  const std::size_t operations = journal.operations().size();
  for (std::size_t i = 0, n = journal.events().size(); i < n; ++i) d.add(journal.events()[i]);
  for (std::size_t i = 0; i < operations; ++i) d.add(*journal.operations()[i].delta);
  for (std::size_t i = 0, n = journal.texts().size(); i < n; ++i) d.add(std::string_view(journal.texts()[i]));
  for (std::size_t i = 0, n = journal.repairs().size(); i < n; ++i) {
    for (const RepairSweep& s : journal.repairs()[i]) {
      d.add(s.largest_distance);
      d.add(s.energy);
      d.add(s.moved);
      d.add(s.flipped);
      d.add(s.points_added);
    }
  }
  for (std::size_t i = 0, n = journal.sample_sets().size(); i < n; ++i) {
    const auto& set = journal.sample_sets()[i];
    if (!set) continue;
    for (const Vec3& p : set->positions) d.add(p);
    for (const std::int8_t l : set->labels) d.add(l);
  }
  return d.value();
}

} // namespace isoscope
