// Asking breakpoints and counting their hits.
#include "query/breakpoints.h"

#include <algorithm>
#include <utility>

namespace isoscope {

namespace {

template <class Entry> void set_to_zero(std::vector<Entry>& entries) {
  for (Entry& e : entries) {
    e.state.hits = 0;
    e.state.last_event.reset();
  }
}

} // namespace

std::string BreakpointHit::note() const {
  return "breakpoint " + std::to_string(id) + " (" + text + ") at event " + std::to_string(event) +
         ", step " + std::to_string(step);
}

void BreakpointSet::set_expected(ExpectedGenus expected) {
  const std::lock_guard lock(mutex_);
  expected_ = std::move(expected);
  watch_.reset();
}

std::variant<unsigned, QueryError> BreakpointSet::add(std::string_view text) {
  ParsedQuery parsed = parse_query(text);
  if (auto* error = std::get_if<QueryError>(&parsed)) return std::move(*error);
  if (std::all_of(text.begin(), text.end(), [](char c) { return c == ' '; }))
    return QueryError{text.size(), "A breakpoint needs a condition.", "For every event write all."};
  const std::lock_guard lock(mutex_);
  Entry entry;
  entry.state.id = next_id_++;
  entry.state.text = text;
  entry.expression = std::get<std::shared_ptr<const Expression>>(std::move(parsed));
  entries_.push_back(std::move(entry));
  return entries_.back().state.id;
}

BreakpointSet::Entry* BreakpointSet::find(unsigned id) {
  const auto at =
      std::find_if(entries_.begin(), entries_.end(), [id](const Entry& e) { return e.state.id == id; });
  return at == entries_.end() ? nullptr : &*at;
}

bool BreakpointSet::remove(unsigned id) {
  const std::lock_guard lock(mutex_);
  return std::erase_if(entries_, [id](const Entry& e) { return e.state.id == id; }) > 0;
}

bool BreakpointSet::enable(unsigned id, bool on) {
  const std::lock_guard lock(mutex_);
  Entry* entry = find(id);
  if (entry != nullptr) entry->state.enabled = on;
  return entry != nullptr;
}

bool BreakpointSet::ignore(unsigned id, std::size_t hits) {
  const std::lock_guard lock(mutex_);
  Entry* entry = find(id);
  if (entry != nullptr) entry->state.ignore = hits;
  return entry != nullptr;
}

void BreakpointSet::remove_all() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
}

void BreakpointSet::forget_hits() {
  const std::lock_guard lock(mutex_);
  set_to_zero(entries_);
  last_hit_.reset();
  watch_.reset();
}

std::vector<BreakpointState> BreakpointSet::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<BreakpointState> states;
  for (const Entry& e : entries_) states.push_back(e.state);
  return states;
}

bool BreakpointSet::any_enabled() const {
  const std::lock_guard lock(mutex_);
  return std::any_of(entries_.begin(), entries_.end(), [](const Entry& e) { return e.state.enabled; });
}

std::vector<std::shared_ptr<const Expression>> BreakpointSet::enabled() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<const Expression>> expressions;
  for (const Entry& e : entries_)
    if (e.state.enabled) expressions.push_back(e.expression);
  return expressions;
}

std::optional<BreakpointHit> BreakpointSet::last_hit() const {
  const std::lock_guard lock(mutex_);
  return last_hit_;
}

std::optional<BreakpointHit> BreakpointSet::ask(const Journal& journal) {
  const std::lock_guard lock(mutex_);
  if (journal.events().size() == 0) return std::nullopt;
  const auto event = static_cast<std::uint32_t>(journal.events().size() - 1);
  // Another run begins: what was counted is of the one before.
  if (watch_ && &watch_->journal() != &journal) {
    set_to_zero(entries_);
    last_hit_.reset();
  }
  QueryNeeds needs;
  for (const Entry& e : entries_)
    if (e.state.enabled && e.expression->needs().any()) needs.add(e.expression->needs());
  // Where what is asked for changes, the journal is followed anew from its beginning.
  if (!watch_ || &watch_->journal() != &journal || watch_->needs() != needs)
    watch_ = std::make_unique<JournalWatch>(journal, needs, expected_);
  watch_->go_to(event);
  std::optional<BreakpointHit> spoken;
  for (Entry& e : entries_) {
    if (!e.state.enabled || !holds(*e.expression, journal, event, watch_.get())) continue;
    e.state.last_event = event;
    if (++e.state.hits <= e.state.ignore || spoken) continue;
    spoken = BreakpointHit{e.state.id, e.state.text, event, journal.events()[event].step};
  }
  if (spoken) last_hit_ = spoken;
  return spoken;
}

} // namespace isoscope
