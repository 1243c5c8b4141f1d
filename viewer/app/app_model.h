// The sum of the features: everything the window shows and steers, without the window. Commands change it,
// panels read it, one update a frame.
#pragma once

#include "ask/investigation.h"
#include "debug/debugger.h"
#include "edge/probe.h"
#include "export/exports.h"
#include "lesson/lessons.h"
#include "model/window_times.h"
#include "mosaic/mosaic.h"
#include "steering/steering.h"
#include "talk/talk.h"
#include "two_runs/comparison.h"
#include "view/zero_maps.h"

#include <atomic>
#include <functional>
#include <memory>

namespace isoscope {

class AppModel : public WindowState {
 public:
  /// `notify` is called from workers when something new is ready.
  explicit AppModel(const std::function<void()>& notify);

  EdgeProbe probe;
  Debugger debug;
  Investigation investigation;
  ZeroMaps zero_maps;
  Talk talk;
  Exports exports;
  Comparison comparison; ///< with the second run
  Mosaic mosaic;
  Steering steering;
  CommandTable commands;
  NamedValues values;
  Lessons lessons;

  WindowTimes times;
  double wait_until = 0; ///< scripts: seconds on the clock until which `wait SECONDS` holds
  enum class Wait : std::uint8_t { time, answers, settled, comparison };
  Wait wait_for = Wait::time;  ///< scripts: what `wait` waits for
  std::string wait_comparison; ///< "recording.events > 100"
  /// Scripts: seconds of real time within which it is to hold.
  static constexpr double usual_patience = 600;
  double wait_patience = usual_patience;

  /// Once a frame: takes what the workers have, moves the play head, asks for what is missing. True when
  /// something changed.
  bool update(double seconds);
  /// Tells everything that runs or is asked to end, and waits for nothing.
  void abandon();
  /// The state shown is the one the play head asks for and nothing is under way that would change it.
  bool state_is_current() const;
  /// Every worker has answered, and the answers are the ones shown.
  bool answers_taken() const;

 private:
  void add_commands();
  void add_values();
  /// Drops what was asked, selected and remembered of the run that was active.
  void forget_run();
  void watch_history();
  void meet_input();
  void place_view();
  void blink();
  void watch_view();
  /// The genus that the active run's Z should have, NaN where nothing is known; the run's thread asks it.
  std::shared_ptr<std::atomic<double>> expected_genus_;
  bool camera_was_set_ = false, section_was_set_ = false; ///< in the update before
  bool clip_placed_ = false;                              ///< by the program, in this update
  Box3 met_;                                              ///< of the input that was shown last
  CameraPose pose_before_;                                ///< when the present run began
  std::uint64_t met_generation_ = 0;
  std::size_t exchanges_met_ = 0;
  std::uint64_t exchanged_to_ = 0;      ///< the run that was beside the one before it
  std::uint64_t framed_generation_ = 0; ///< the run whose bounds the camera knows
  std::uint64_t history_warned_ = 0;    ///< the run whose journal was found too large
};

/// Made for scripts, and how long the window takes, which they measure.
void add_script_commands(AppModel& model);
void add_time_values(AppModel& model);

/// On panes, tabs and the look of the window, and on what lies over it. Both must outlive the table.
void add_window_commands(CommandTable& table, WindowState& window, const NamedValues& values);
void add_window_values(NamedValues& values, WindowState& window);

} // namespace isoscope
