// Counting over events; cells are kept sorted, so that no hash decides an order.
#include "questions/work_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace isoscope {
namespace {

bool tries_edge(const Event& e) {
  return e.kind == EventKind::collapse || e.kind == EventKind::repair || e.kind == EventKind::rejection;
}

bool counts(const Event& e, WorkKind kind) {
  switch (kind) {
  case WorkKind::insertions:
    return e.kind == EventKind::insertion;
  case WorkKind::attempts:
    return tries_edge(e);
  case WorkKind::rejections:
    return e.kind == EventKind::rejection || e.kind == EventKind::exhausted;
  }
  return false;
}

bool is_attempt(const Event& e) {
  return tries_edge(e) || e.kind == EventKind::insertion || e.kind == EventKind::exhausted;
}

bool accepted(const Event& e) {
  return e.operation;
}

/// Counts per cube of space.
class Cells {
 public:
  explicit Cells(double size) : size_(size) {}
  void add(Vec3 p, Reason reason) {
    const auto at = [&](double x) { return static_cast<std::int32_t>(std::floor(x / size_)); };
    ++cells_[{at(p.x), at(p.y), at(p.z)}][static_cast<std::size_t>(reason)];
  }
  WorkMap take() const {
    WorkMap map;
    map.cell_size = size_;
    for (const auto& [cell, reasons] : cells_) {
      WorkCell c;
      c.cell = cell;
      c.center = {(cell[0] + 0.5) * size_, (cell[1] + 0.5) * size_, (cell[2] + 0.5) * size_};
      for (const std::uint32_t n : reasons) c.count += n;
      c.reason = static_cast<Reason>(std::max_element(reasons.begin(), reasons.end()) - reasons.begin());
      map.total += c.count;
      map.cells.push_back(c);
    }
    std::stable_sort(map.cells.begin(), map.cells.end(),
                     [](const WorkCell& a, const WorkCell& b) { return a.count > b.count; });
    return map;
  }

 private:
  double size_;
  std::map<std::array<std::int32_t, 3>, std::array<std::uint32_t, reason_count>> cells_;
};

} // namespace

std::optional<Vec3> EventPlaces::place(std::size_t index) {
  const Event& e = journal_->events()[index];
  for (; step_ < e.step && step_ < journal_->steps(); ++step_) {
    const Delta delta = journal_->operations()[step_].delta();
    for (const Vertex& v : delta.added_vertices) vertices_.push_back(v.position);
    for (const Delta::Move& move : delta.moves)
      if (move.vertex.index() < vertices_.size()) vertices_[move.vertex.index()] = move.after;
  }
  if (e.kind == EventKind::insertion) return e.point;
  if (tries_edge(e)) {
    if (e.vertex.index() < vertices_.size() && e.other.index() < vertices_.size())
      return 0.5 * (vertices_[e.vertex.index()] + vertices_[e.other.index()]);
    return std::nullopt;
  }
  if (e.kind == EventKind::exhausted && is_finite(e.witness)) return e.witness;
  return std::nullopt;
}

WorkMap map_work(const Journal& journal, std::size_t begin, std::size_t end, WorkKind kind,
                 double cell_size) {
  EventPlaces places(journal);
  Cells cells(cell_size);
  end = std::min(end, journal.events().size());
  for (std::size_t i = begin; i < end; ++i) {
    const Event& e = journal.events()[i];
    if (!counts(e, kind)) continue;
    if (const auto p = places.place(i)) cells.add(*p, e.reason);
  }
  return cells.take();
}

StallReport examine_stall(const Journal& journal, std::size_t end, std::size_t most_attempts,
                          double cell_size, std::size_t begin) {
  StallReport report;
  end = std::min(end, journal.events().size());
  std::vector<std::size_t> attempts; ///< newest first
  bool accepted_seen = false;
  for (std::size_t i = end; i-- > begin;) {
    const Event& e = journal.events()[i];
    if (!is_attempt(e)) continue;
    accepted_seen |= accepted(e);
    if (!accepted_seen) ++report.since_accepted;
    if (attempts.size() < most_attempts) attempts.push_back(i);
    if (accepted_seen && attempts.size() >= most_attempts) break;
  }
  std::reverse(attempts.begin(), attempts.end());
  report.attempts = attempts.size();
  report.first_event = attempts.empty() ? end : attempts.front();
  report.over_time.resize(std::min(StallReport::bands, attempts.size()));
  EventPlaces places(journal);
  Cells cells(cell_size);
  for (std::size_t k = 0; k < attempts.size(); ++k) {
    const Event& e = journal.events()[attempts[k]];
    const std::size_t reason = accepted(e) ? 0 : static_cast<std::size_t>(e.reason);
    report.accepted += accepted(e);
    ++report.by_reason[reason];
    ++report.over_time[k * report.over_time.size() / attempts.size()][reason];
    if (accepted(e)) continue;
    if (const auto p = places.place(attempts[k])) cells.add(*p, e.reason);
  }
  report.places = cells.take();
  return report;
}

std::vector<WorkTime> time_by_reason(const Journal& journal, std::size_t begin, std::size_t end) {
  struct Entry {
    std::size_t count = 0;
    double seconds = 0;
  };
  using Key = std::tuple<Stage, EventKind, Reason>;
  std::map<Key, Entry> table;
  std::vector<Key> open; ///< tried since the last time stamp
  const auto share = [&](double seconds) {
    for (const Key& key : open) table[key].seconds += seconds / static_cast<double>(open.size());
    open.clear();
  };
  double stamp = 0; ///< of the last operation, within its stage
  end = std::min(end, journal.events().size());
  for (std::size_t i = 0; i < end; ++i) {
    const Event& e = journal.events()[i];
    if (e.kind == EventKind::stage_begin) {
      open.clear();
      stamp = 0;
    }
    const bool counted = i >= begin && (is_attempt(e) || e.operation);
    if (counted) {
      const Key key{e.stage, e.kind, e.reason};
      ++table[key].count;
      open.push_back(key);
    }
    if (!e.operation || e.step >= journal.steps()) continue;
    const auto now = static_cast<double>(journal.operations()[e.step].figures.seconds);
    share(std::max(now >= stamp ? now - stamp : now, 0.0));
    stamp = now;
  }
  std::vector<WorkTime> out;
  for (const auto& [key, entry] : table)
    out.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), entry.count, entry.seconds});
  std::stable_sort(out.begin(), out.end(), [](const WorkTime& a, const WorkTime& b) {
    return a.stage != b.stage ? a.stage < b.stage : a.seconds > b.seconds;
  });
  return out;
}

} // namespace isoscope
