// Appends events and operations, keeps the byte count, and digests a journal.
#include "journal/journal.h"

#include "journal/digest.h"

#include <algorithm>
#include <string_view>

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

std::uint64_t digest(const Journal& journal) {
  Digest d;
  const std::size_t operations = journal.operations().size();
  for (std::size_t i = 0, n = journal.events().size(); i < n; ++i) d.add(journal.events()[i]);
  for (std::size_t i = 0; i < operations; ++i) d.add(*journal.operations()[i].delta);
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
