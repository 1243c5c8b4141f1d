// Where the play head is and how it moves: paused, playing at a speed, or following the live end.
#pragma once

#include "base/ids.h"

#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Pure bookkeeping over step numbers; the run itself is elsewhere and goes on while one looks at its past.
class Transport {
 public:
  enum class Mode { paused, playing, following };

  /// Speeds that the window offers, steps a second; 0 is automatic (a whole run in about ten seconds).
  static std::span<const double> speeds();
  static constexpr double automatic = 0, unlimited = 1e12;

  Mode mode() const { return mode_; }
  double speed() const { return speed_; }
  Step step() const { return static_cast<Step>(position_); }
  bool moving() const { return mode_ != Mode::paused; }

  /// Back to step 0, following from the start.
  void restart();
  void pause() { mode_ = Mode::paused; }
  void play();
  void follow();
  void jump(Step step);
  void step_by(long steps, Step live);
  void set_speed(double steps_per_second);
  /// Whether following jumps to the live end at once instead of playing up to it (scripts).
  void set_immediate(bool immediate) { immediate_ = immediate; }

  /// Steps, ascending, that playing slows down for and dwells at, once for each time that it is among them;
  /// none: it never does. With some the automatic speed does not make up for the time spent there.
  void dwell_at(std::span<const Step> moments) { moments_.assign(moments.begin(), moments.end()); }
  static constexpr double dwell_seconds = 2.5; ///< for each of them
  /// Which of them it dwells for, from 0; nullopt while it goes on.
  std::optional<std::size_t> dwelling() const;
  /// Before `step` playing makes at most so many steps a second; step 0: it is never held back.
  void slow_before(Step step, double steps_per_second) {
    slow_end_ = step;
    slow_speed_ = steps_per_second;
  }

  /// Moves by `seconds` of real time towards `live`, the last step there is; `growing`: more may come.
  void update(double seconds, Step live, bool growing);
  /// Whether the head is where new steps appear.
  bool at_live_end(Step live) const { return step() >= live; }

 private:
  double automatic_speed(double remaining, double end) const;
  double velocity(double remaining, double end) const;
  /// Dwells for the moments at a step, where there are some.
  bool dwell(Step step);
  Mode mode_ = Mode::following;
  double position_ = 0;
  double speed_ = automatic;
  double elapsed_ = 0; ///< seconds of automatic play, for its gentle start
  bool immediate_ = false;
  double advance(double from, double to, double seconds);
  std::vector<Step> moments_;
  std::size_t dwell_end_ = 0; ///< behind the last of the moments it dwells for
  double dwell_ = 0;          ///< seconds still to be spent at them
  bool began_ = false;        ///< the moments at step 0 are behind it
  Step slow_end_ = 0;
  double slow_speed_ = 0;
};

} // namespace isoscope
