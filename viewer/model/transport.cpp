// The play head's motion.
#include "model/transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {
constexpr double automatic_seconds = 10; ///< a whole run is told in this time
constexpr double catch_up_seconds = 0.5; ///< the lag behind a run that is still growing after that
constexpr std::array<double, 15> offered{
    Transport::automatic, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, Transport::unlimited};
} // namespace

std::span<const double> Transport::speeds() {
  return offered;
}

void Transport::restart() {
  mode_ = Mode::following;
  position_ = 0;
  elapsed_ = 0;
  dwell_ = 0;
  began_ = false;
}

void Transport::play() {
  if (mode_ == Mode::paused) elapsed_ = 0;
  mode_ = Mode::playing;
}

void Transport::follow() {
  mode_ = Mode::following;
  // Asked for in the middle of a run, following means being there soon.
  elapsed_ = std::max(elapsed_, automatic_seconds);
}

void Transport::jump(Step step) {
  mode_ = Mode::paused;
  dwell_ = 0;
  began_ = false;
  position_ = step;
}

void Transport::step_by(long steps, Step live) {
  mode_ = Mode::paused;
  dwell_ = 0;
  began_ = false;
  const double wanted = static_cast<double>(step()) + static_cast<double>(steps);
  position_ = std::clamp(wanted, 0.0, static_cast<double>(live));
}

void Transport::set_speed(double steps_per_second) {
  speed_ = std::clamp(steps_per_second, 0.0, unlimited);
}

// position(t) = end (t / T)^2: slow while single operations change the picture, faster where there are
// thousands. Solved for the speed from where the head is, so that an end that moves on is followed smoothly.
double Transport::automatic_speed(double remaining, double end) const {
  const double t = std::max(elapsed_, 0.05), total = automatic_seconds;
  if (t >= total - catch_up_seconds) return std::max(remaining / catch_up_seconds, end / total);
  return std::max(2 * t * remaining / (total * total - t * t), 1.0);
}

// The same with moments: by where the head is, as the time that it spends at them tells nothing.
double Transport::velocity(double remaining, double end) const {
  double v = speed_;
  if (speed_ == automatic)
    v = moments_.empty() ? automatic_speed(remaining, end)
                         : std::max(2 * std::sqrt(position_ * end) / automatic_seconds, 1.0);
  return position_ < static_cast<double>(slow_end_) ? std::min(v, slow_speed_) : v;
}

bool Transport::dwell(Step step) {
  const auto [first, last] = std::equal_range(moments_.begin(), moments_.end(), step);
  if (first == last) return false;
  dwell_end_ = static_cast<std::size_t>(last - moments_.begin());
  dwell_ = dwell_seconds * static_cast<double>(last - first);
  return true;
}

std::optional<std::size_t> Transport::dwelling() const {
  // The moments may have become others meanwhile.
  if (mode_ == Mode::paused || !(dwell_ > 0) || dwell_end_ > moments_.size()) return std::nullopt;
  const auto left = static_cast<std::size_t>(std::ceil(dwell_ / dwell_seconds));
  return dwell_end_ - std::min(left, dwell_end_);
}

// Where the head is after `seconds` when it would go from `from` to `to`: never past a moment, slower the
// nearer it is, and at rest there for a while.
double Transport::advance(double from, double to, double seconds) {
  constexpr double ease = 3, least = 2; // a third of a second from anywhere near; steps a second at least
  if (dwell_ > 0) {
    dwell_ -= seconds;
    return from;
  }
  if (from == 0 && !std::exchange(began_, true) && dwell(0)) return from;
  const auto next = std::upper_bound(moments_.begin(), moments_.end(), from,
                                     [](double at, Step moment) { return at < static_cast<double>(moment); });
  if (next == moments_.end() || to <= from) return to;
  const Step moment = *next;
  const double ahead = static_cast<double>(moment) - from;
  const double slowed = std::min(to, from + std::max(ease * ahead, least) * seconds);
  if (slowed < static_cast<double>(moment)) return slowed;
  dwell(moment);
  return static_cast<double>(moment);
}

void Transport::update(double seconds, Step live, bool growing) {
  const double end = live;
  position_ = std::min(position_, end);
  if (mode_ == Mode::paused) return;
  if (immediate_ && mode_ == Mode::following) {
    dwell_ = 0;
    position_ = end;
    return;
  }
  elapsed_ += seconds;
  const double remaining = end - position_;
  const double wanted = position_ + std::max(velocity(remaining, end), 0.0) * seconds;
  position_ = std::min(end, advance(position_, wanted, seconds));
  // The last fraction of a step would otherwise take for ever.
  if (speed_ == automatic && end - position_ < 0.5) position_ = end;
  if (mode_ == Mode::playing && position_ >= end && !(dwell_ > 0))
    mode_ = growing ? Mode::following : Mode::paused;
}

} // namespace isoscope
