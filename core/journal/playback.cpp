// Moves a complex along the journal; samples follow only when somebody asks for them.
#include "journal/playback.h"

#include "base/sort_unique.h"

#include <algorithm>
#include <cstdlib>

namespace isoscope {

namespace {

/// A keyframe is worth its memory once replaying from the last one touches this many tetrahedra, and so many
/// for each tetrahedron of the state to copy (some 20 ms).
constexpr std::size_t work_per_keyframe = 100000;
constexpr std::size_t work_per_copied_tet = 2;
/// Restoring a keyframe copies the complex: about as costly as this many operations.
constexpr Step restore_cost = 200;

Step distance(Step a, Step b) {
  return a > b ? a - b : b - a;
}

} // namespace

Playback::Playback(std::shared_ptr<const Journal> journal, std::size_t keyframe_limit)
    : journal_(std::move(journal)), keyframe_limit_(keyframe_limit) {}

Step Playback::seek(Step step) {
  step = std::min(step, journal_->steps());
  const auto above = keyframes_.upper_bound(step);
  const auto below = above == keyframes_.begin() ? keyframes_.end() : std::prev(above);
  Step best = distance(step_, step);
  const Keyframe* from = nullptr;
  Step at = 0;
  for (const auto it : {below, above}) {
    if (it == keyframes_.end()) continue;
    const Step cost = distance(it->first, step) + restore_cost;
    if (cost < best) {
      best = cost;
      from = &it->second;
      at = it->first;
    }
  }
  if (step + restore_cost < best) {
    complex_ = {};
    sample_set_ = 0;
    step_ = 0;
  } else if (from != nullptr) {
    restore(*from, at);
  }
  while (step_ < step) forward_one();
  while (step_ > step) backward_one();
  return step_;
}

void Playback::restore(const Keyframe& keyframe, Step at) {
  complex_ = keyframe.complex;
  sample_set_ = keyframe.sample_set;
  step_ = at;
}

const Delta& Playback::read(Step operation) {
  journal_->operations()[operation].stored.read(delta_);
  return delta_;
}

void Playback::forward_one() {
  const Delta& delta = read(step_);
  complex_.apply(delta);
  if (delta.sample_set) sample_set_ = delta.sample_set->after;
  ++step_;
  if (keyframes_.empty() || step_ > keyframes_.rbegin()->first) {
    work_since_keyframe_ += delta.removed.size() + delta.added.size();
    if (work_since_keyframe_ > work_per_keyframe + work_per_copied_tet * complex_.tets.size())
      keep_keyframe();
  }
}

void Playback::backward_one() {
  const Delta& delta = read(step_ - 1);
  complex_.undo(delta);
  if (delta.sample_set) sample_set_ = delta.sample_set->before;
  --step_;
}

void Playback::keep_keyframe() {
  if (complex_.memory_bytes() > keyframe_limit_) return;
  Keyframe keyframe{complex_, sample_set_, complex_.memory_bytes()};
  keyframe_bytes_ += keyframe.bytes;
  keyframes_.emplace(step_, std::move(keyframe));
  work_since_keyframe_ = 0;
  thin_keyframes();
}

void Playback::set_keyframe_limit(std::size_t bytes) {
  keyframe_limit_ = bytes;
  thin_keyframes();
}

void Playback::thin_keyframes() {
  while (keyframe_bytes_ > keyframe_limit_) {
    bool drop = true;
    for (auto it = keyframes_.begin(); it != keyframes_.end(); drop = !drop) {
      if (!drop) {
        ++it;
        continue;
      }
      keyframe_bytes_ -= it->second.bytes;
      it = keyframes_.erase(it);
    }
  }
}

std::shared_ptr<const BoundarySamples> Playback::samples() const {
  const auto& sets = journal_->sample_sets();
  return sample_set_ < sets.size() ? sets[sample_set_] : nullptr;
}

const SampleSets& Playback::sample_sets() {
  const auto set = samples();
  if (!sets_ || sets_of_ != set) {
    static constexpr std::span<const Vec3> nothing;
    sets_ = std::make_unique<SampleSets>(set ? std::span<const Vec3>(set->positions) : nothing);
    sets_of_ = set;
    sets_->assign_all(complex_);
    sets_step_ = step_;
    return *sets_;
  }
  if (sets_step_ == step_) return *sets_;
  // Whatever lies between, only slots that some operation touched can hold other samples now.
  const auto [first, last] = std::minmax(sets_step_, step_);
  std::vector<std::uint32_t> touched;
  for (Step k = first; k < last; ++k) {
    const Delta& delta = read(k);
    for (const TetRecord& t : delta.removed) touched.push_back(t.id.value);
    for (const TetRecord& t : delta.added) touched.push_back(t.id.value);
  }
  sort_unique(touched);
  if (2 * touched.size() > complex_.tets.size()) {
    sets_->assign_all(complex_);
  } else {
    std::vector<TetRecord> from, to;
    for (const std::uint32_t slot : touched) {
      from.push_back({TetId(slot), {}});
      if (slot < complex_.tets.size() && complex_.tets[slot].alive()) {
        to.push_back({TetId(slot), complex_.tets[slot].v});
      }
    }
    sets_->redistribute(complex_, from, to);
  }
  sets_step_ = step_;
  return *sets_;
}

std::vector<TetId> Playback::changed_in_last(Step n) const {
  std::vector<TetId> changed;
  Delta delta;
  for (Step k = step_ - std::min(n, step_); k < step_; ++k) {
    journal_->operations()[k].stored.read(delta);
    for (const TetRecord& t : delta.added) {
      const std::size_t slot = t.id.index();
      if (slot < complex_.tets.size() && complex_.tets[slot].v == t.v) changed.push_back(t.id);
    }
  }
  sort_unique(changed);
  return changed;
}

std::size_t Playback::memory_bytes() const {
  return complex_.memory_bytes() + keyframe_bytes_ + (sets_ ? sets_->memory_bytes() : 0);
}

} // namespace isoscope
