// Anchors at the ends of paired stages, straight lines between them.
#include "compare/run_alignment.h"

#include <algorithm>

namespace isoscope {

std::vector<StageStretch> stage_stretches(const Journal& journal) {
  std::vector<StageStretch> stretches;
  const auto steps = static_cast<Step>(journal.operations().size());
  for (std::size_t i = 0, n = journal.stage_marks().size(); i < n; ++i) {
    const Event& e = journal.events()[journal.stage_marks()[i].event];
    if (e.kind != EventKind::stage_begin) continue;
    if (!stretches.empty() && stretches.back().stage == e.stage) continue;
    const Step begin = std::min(e.step, steps);
    if (!stretches.empty()) stretches.back().end = begin;
    stretches.push_back({e.stage, begin, begin});
  }
  if (!stretches.empty()) stretches.back().end = steps;
  return stretches;
}

std::vector<StagePair> pair_stages(const std::vector<Stage>& a, const std::vector<Stage>& b) {
  std::vector<StagePair> pairs;
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto found = std::find(b.begin() + static_cast<std::ptrdiff_t>(j), b.end(), a[i]);
    if (found == b.end()) {
      pairs.emplace_back(i, std::nullopt);
      continue;
    }
    const auto match = static_cast<std::size_t>(found - b.begin());
    for (; j < match; ++j) pairs.emplace_back(std::nullopt, j);
    pairs.emplace_back(i, j++);
  }
  for (; j < b.size(); ++j) pairs.emplace_back(std::nullopt, j);
  return pairs;
}

RunAlignment::RunAlignment(const std::vector<StageStretch>& a, Step steps_a,
                           const std::vector<StageStretch>& b, Step steps_b, Step common)
    : common_(std::min({common, steps_a, steps_b})) {
  add(common_, common_);
  std::vector<Stage> stages_a, stages_b;
  for (const StageStretch& s : a) stages_a.push_back(s.stage);
  for (const StageStretch& s : b) stages_b.push_back(s.stage);
  for (const auto& [i, j] : pair_stages(stages_a, stages_b)) {
    if (!i || !j || a[*i].end < common_ || b[*j].end < common_) continue;
    add(std::max(a[*i].begin, common_), std::max(b[*j].begin, common_));
    add(a[*i].end, b[*j].end);
  }
  add(steps_a, steps_b);
}

void RunAlignment::add(Step a, Step b) {
  const Anchor next{std::max(a, anchors_.back().a), std::max(b, anchors_.back().b)};
  if (!(next == anchors_.back())) anchors_.push_back(next);
}

Step RunAlignment::map(Step from, Step Anchor::*key, Step Anchor::*value) const {
  // Where one run stands still while the other one goes on, what follows decides.
  const auto after = std::upper_bound(anchors_.begin(), anchors_.end(), from,
                                      [key](Step step, const Anchor& anchor) { return step < anchor.*key; });
  if (after == anchors_.end()) return anchors_.back().*value;
  const Anchor& before = *(after - 1);
  const std::uint64_t done = from - before.*key, length = (*after).*key - before.*key;
  const std::uint64_t reach = (*after).*value - before.*value;
  return before.*value + static_cast<Step>(done * reach / length);
}

Step RunAlignment::to_b(Step a) const {
  return map(a, &Anchor::a, &Anchor::b);
}

Step RunAlignment::to_a(Step b) const {
  return map(b, &Anchor::b, &Anchor::a);
}

} // namespace isoscope
