// Gathering events by loop.
#include "debug/loop_events.h"

#include "base/numbers.h"
#include "questions/rim_questions.h"
#include "tolerance/rim.h"

#include <algorithm>
#include <numeric>

namespace isoscope {
namespace {

constexpr std::string_view loop_prefix = "loop-", others_name = "loops-other";

} // namespace

std::string loop_lane_name(std::uint32_t loop) {
  return loop == other_loops ? std::string(others_name) : std::string(loop_prefix) + std::to_string(loop + 1);
}

std::optional<std::uint32_t> loop_of_lane(std::string_view name) {
  if (name == others_name) return other_loops;
  if (!name.starts_with(loop_prefix)) return std::nullopt;
  const auto number = read_number<std::uint32_t>(name.substr(loop_prefix.size()));
  return number && *number > 0 ? std::optional(*number - 1) : std::nullopt;
}

void LoopEvents::restart() {
  rim_ = scene_ ? open_rim(*scene_) : nullptr;
  scanned_ = 0;
  lanes_.clear();
  rows_.clear();
  others_ = {};
  if (rim_ == nullptr) return;
  const auto loops = rim_->loops();
  rows_.resize(loops.size());
  lanes_.resize(loops.size());
  std::iota(lanes_.begin(), lanes_.end(), 0u);
  std::stable_sort(lanes_.begin(), lanes_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return loops[a].length > loops[b].length; });
  single_.assign(loops.size(), 1);
  if (loops.size() <= most_single + 1) return;
  for (std::size_t i = most_single; i < lanes_.size(); ++i) single_[lanes_[i]] = 0;
  lanes_.resize(most_single);
  lanes_.push_back(other_loops);
}

bool LoopEvents::update(const std::shared_ptr<const Journal>& journal,
                        const std::shared_ptr<const Scene>& scene, std::size_t budget) {
  constexpr std::size_t reading_cost = 40; ///< how much dearer an event is whose delta is read
  const bool anew = journal != journal_ || scene != scene_;
  if (anew) {
    journal_ = journal;
    scene_ = scene;
    restart();
  }
  if (!journal_) return anew;
  const auto end = static_cast<std::uint32_t>(complete_events(*journal_));
  if (rim_ == nullptr) {
    scanned_ = end;
    return anew;
  }
  bool changed = anew;
  for (; scanned_ < end && budget > 0; ++scanned_) {
    const Event& event = journal_->events()[scanned_];
    const auto work = loop_work(event.kind);
    budget -= std::min(budget, work && event.operation ? reading_cost : 1);
    if (!work) continue;
    const auto put = [&](Row& row) {
      if (!row.events.empty() && row.events.back() == scanned_) return;
      row.events.push_back(scanned_);
      row.steps.at(static_cast<std::size_t>(*work)).push_back(event.step);
      changed = true;
    };
    for (const std::uint32_t loop : loops_touched(*journal_, event, *rim_)) {
      if (loop >= rows_.size()) continue;
      put(rows_[loop]);
      if (single_[loop] == 0) put(others_);
    }
  }
  return changed;
}

bool LoopEvents::complete() const {
  return !journal_ || scanned_ >= complete_events(*journal_);
}

const LoopEvents::Row* LoopEvents::row(std::uint32_t loop) const {
  if (loop == other_loops) return has(loop) ? &others_ : nullptr;
  return loop < rows_.size() ? &rows_[loop] : nullptr;
}

bool LoopEvents::has(std::uint32_t loop) const {
  return loop == other_loops ? !lanes_.empty() && lanes_.back() == other_loops : loop < rows_.size();
}

std::string LoopEvents::title(std::uint32_t loop) const {
  return loop == other_loops ? grouped(rows_.size() - most_single) + " other holes"
                             : "hole " + std::to_string(loop + 1);
}

const std::vector<std::uint32_t>& LoopEvents::events(std::uint32_t loop) const {
  static const std::vector<std::uint32_t> none;
  const Row* const found = row(loop);
  return found != nullptr ? found->events : none;
}

bool LoopEvents::touches(std::uint32_t loop, std::uint32_t event) const {
  const auto& all = events(loop);
  return std::binary_search(all.begin(), all.end(), event);
}

std::uint32_t LoopEvents::count(std::uint32_t loop, LoopWork work, Step begin, Step end) const {
  const Row* const found = row(loop);
  if (found == nullptr) return 0;
  const auto& steps = found->steps.at(static_cast<std::size_t>(work));
  return static_cast<std::uint32_t>(std::lower_bound(steps.begin(), steps.end(), std::max(begin, end)) -
                                    std::lower_bound(steps.begin(), steps.end(), begin));
}

std::uint32_t LoopEvents::count(std::uint32_t loop, Step begin, Step end) const {
  std::uint32_t all = 0;
  for (int w = 0; w < loop_work_count; ++w) all += count(loop, static_cast<LoopWork>(w), begin, end);
  return all;
}

} // namespace isoscope
