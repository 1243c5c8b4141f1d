// Compares events by what they decide.
#include "journal/rehearsal.h"

#include "journal/digest.h"

#include <algorithm>

namespace isoscope {
namespace {

std::uint64_t decision(Event e) {
  e.step = 0;
  e.text = e.detail = 0;
  Digest d;
  d.add(e);
  return d.value();
}

/// A record for what the run began with, and one for each event that tells of a change.
CriteriaParameters record(const Journal& journal, std::size_t changes) {
  const auto& all = journal.parameters();
  return all.empty() ? CriteriaParameters() : all[std::min(changes, all.size() - 1)].criteria;
}

std::size_t changes_before(const Journal& journal, std::size_t event) {
  std::size_t changes = 0;
  for (std::size_t i = 0; i < event; ++i)
    changes += journal.events()[i].kind == EventKind::parameter_change ? 1 : 0;
  return changes;
}

} // namespace

Rehearsal::Rehearsal(const Journal& followed, std::size_t next) : followed_(&followed), next_(next) {}

CriteriaParameters Rehearsal::criteria() const {
  return record(*followed_, changes_before(*followed_, next_) + 1);
}

bool Rehearsal::advance(const Event& made) {
  if (over() || decision(made) != decision(event())) return false;
  ++next_;
  return true;
}

CriteriaParameters criteria_before(const Journal& journal, std::size_t event) {
  return record(journal, changes_before(journal, event));
}

} // namespace isoscope
