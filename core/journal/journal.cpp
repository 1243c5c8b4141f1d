// Appends events and operations, keeps the byte count, and digests a journal.
#include "journal/journal.h"

#include "journal/digest.h"

#include <algorithm>
#include <string_view>

namespace isoscope {

Journal::Journal(std::filesystem::path spill_folder)
    : pool_(std::make_unique<SpillPool>(std::move(spill_folder))), events_(*pool_), operations_(*pool_),
      deltas_(*pool_) {
  texts_.push_back({});
  repairs_.push_back({});
}

std::size_t Journal::memory_bytes() const {
  const std::size_t all = bytes_.load(std::memory_order_relaxed), on_disk = pool_->disk_bytes();
  return fixed_bytes_.load(std::memory_order_relaxed) + (all > on_disk ? all - on_disk : 0);
}

void Journal::keep_within(std::size_t bytes) const {
  const std::size_t fixed = fixed_bytes_.load(std::memory_order_relaxed);
  pool_->keep_within(bytes > fixed ? bytes - fixed : 0);
}

CriteriaParameters Journal::parameters_at(Step step) const {
  CriteriaParameters found;
  for (std::size_t i = 0, n = parameters_.size(); i < n && (i == 0 || parameters_[i].step <= step); ++i) {
    found = parameters_[i].criteria;
  }
  return found;
}

std::uint32_t Journal::add_text(std::string text) {
  fixed_bytes_.fetch_add(sizeof(std::string) + text.size(), std::memory_order_relaxed);
  texts_.push_back(std::move(text));
  return static_cast<std::uint32_t>(texts_.size() - 1);
}

std::uint32_t Journal::add_repair(RepairDetail sweeps) {
  fixed_bytes_.fetch_add(sizeof(RepairDetail) + sweeps.capacity() * sizeof(RepairSweep),
                         std::memory_order_relaxed);
  repairs_.push_back(std::move(sweeps));
  return static_cast<std::uint32_t>(repairs_.size() - 1);
}

std::uint16_t Journal::add_sample_set(std::shared_ptr<const BoundarySamples> samples) {
  if (samples) {
    fixed_bytes_.fetch_add(samples->size() * (sizeof(Vec3) + sizeof(std::int8_t) + sizeof(std::uint16_t)),
                           std::memory_order_relaxed);
  }
  sample_sets_.push_back(std::move(samples));
  return static_cast<std::uint16_t>(sample_sets_.size() - 1);
}

void Journal::add_parameters(const CriteriaParameters& criteria) {
  parameters_.push_back({steps(), criteria});
}

double Journal::age() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - made_).count();
}

std::uint32_t Journal::add_event(Event event, std::optional<double> seconds) {
  event.step = steps();
  bytes_.fetch_add(sizeof(Event), std::memory_order_relaxed);
  const auto index = static_cast<std::uint32_t>(events_.size());
  if (event.kind == EventKind::stage_begin || event.kind == EventKind::stage_end ||
      event.kind == EventKind::stopped) {
    stage_marks_.push_back({index, seconds ? *seconds : age()});
  }
  events_.push_back(event);
  return index;
}

void Journal::take_prefix(const Journal& from, Step step, std::size_t events) {
  const std::size_t operations = std::min<std::size_t>(step, from.operations().size());
  const std::size_t end =
      std::min(events, operations < from.operations().size() ? from.operations()[operations].event
                                                             : from.events().size());
  std::size_t mark = 0, next = 0, texts = 1, repairs = 1, sets = 1;
  std::size_t records = 1; // what it began with, and one for each change
  double age = 0;
  for (std::size_t i = 0; i < end; ++i) {
    const Event& event = from.events()[i];
    if (mark < from.stage_marks().size() && from.stage_marks()[mark].event == i) {
      age = from.stage_marks()[mark].seconds;
      stage_marks_.push_back(from.stage_marks()[mark++]);
    }
    records += event.kind == EventKind::parameter_change ? 1 : 0;
    texts = std::max<std::size_t>(texts, event.text + 1);
    repairs = std::max<std::size_t>(repairs, event.detail + 1);
    if (next < operations && from.operations()[next].event == i) {
      const Operation& operation = from.operations()[next++];
      const Delta delta = operation.delta();
      if (delta.sample_set) sets = std::max<std::size_t>(sets, delta.sample_set->after + 1u);
      const StoredDelta stored = deltas_.add(operation.stored);
      bytes_.fetch_add(sizeof(Operation) + stored.size, std::memory_order_relaxed);
      operations_.push_back({operation.event, stored, operation.figures});
    }
    bytes_.fetch_add(sizeof(Event), std::memory_order_relaxed);
    events_.push_back(event);
  }
  for (std::size_t i = 0, n = std::min(sets, from.sample_sets().size()); i < n; ++i)
    add_sample_set(from.sample_sets()[i]);
  for (std::size_t i = 0, n = std::min(records, from.parameters().size()); i < n; ++i)
    parameters_.push_back(from.parameters()[i]);
  for (std::size_t i = 1; i < texts; ++i) add_text(from.texts()[i]);
  for (std::size_t i = 1; i < repairs; ++i) add_repair(from.repairs()[i]);
  // Times go on where the last mark was.
  made_ = std::chrono::steady_clock::now() -
          std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(age));
}

void Journal::add_operation(Event event, const Delta& delta, const StepFigures& figures) {
  event.operation = true;
  const std::uint32_t index = add_event(event);
  const StoredDelta stored = deltas_.add(delta);
  bytes_.fetch_add(sizeof(Operation) + stored.size, std::memory_order_relaxed);
  operations_.push_back({index, stored, figures});
}

std::size_t complete_events(const Journal& journal) {
  const std::size_t n = journal.events().size();
  if (n == 0) return 0;
  const Event& last = journal.events()[n - 1];
  return last.operation && last.step >= journal.operations().size() ? n - 1 : n;
}

std::shared_ptr<Journal> first_events(const Journal& journal, std::size_t events) {
  Step operations = 0;
  while (operations < journal.operations().size() && journal.operations()[operations].event < events)
    ++operations;
  auto first = std::make_shared<Journal>();
  first->take_prefix(journal, operations, events);
  return first;
}

std::uint64_t digest(const Journal& journal) {
  Digest d;
  const std::size_t operations = journal.operations().size();
  for (std::size_t i = 0, n = journal.events().size(); i < n; ++i) d.add(journal.events()[i]);
  Delta delta;
  for (std::size_t i = 0; i < operations; ++i) {
    journal.operations()[i].stored.read(delta);
    d.add(delta);
  }
  for (std::size_t i = 0, n = journal.texts().size(); i < n; ++i) d.add(std::string_view(journal.texts()[i]));
  for (std::size_t i = 0, n = journal.repairs().size(); i < n; ++i) {
    for (const RepairSweep& s : journal.repairs()[i]) d.add(s);
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
