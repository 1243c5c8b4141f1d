// What the stages of the simplification share: the one way to write operations and rejections into the
// journal, and to hear when to stop.
#pragma once

#include "base/run_control.h"
#include "journal/recorder.h"

#include <chrono>
#include <functional>

namespace isoscope {

/// Records for one stage at a time; remembers whether the gate said stop.
class StageLog {
 public:
  StageLog(Recorder& recorder, const RunControl& control) : recorder_(&recorder), control_(&control) {}

  /// `further`: for the improver, that it is to go on after its end; the event counts 1 then.
  void begin(Stage stage, bool further = false);
  /// Goes on in a stage that the journal has begun, `seconds` ago.
  void rejoin(Stage stage, double seconds);
  /// What ended the last run does not end this one.
  void resume() { stopped_ = false; }
  /// Ends the stage; one that was told to stop ends with a `stopped` event instead.
  void end();
  void event(Event event);
  void operation(Event event, Delta delta, StepFigures figures);
  std::uint32_t repair(RepairDetail sweeps) { return recorder_->journal().add_repair(std::move(sweeps)); }
  void warn(std::string text);

  bool stopped() const { return stopped_ || control_->cancelled(); }
  /// Where the run repeats what its journal has: the next event; null outside.
  const Rehearsal* rehearsal() const { return recorder_->rehearsal(); }
  void go_astray() {
    recorder_->go_astray();
    stopped_ = true;
  }
  /// Called with the gate's parameters when it says that they changed.
  void on_parameters(std::function<void(const CriteriaParameters&)> adopt) { adopt_ = std::move(adopt); }
  Journal& journal() { return recorder_->journal(); }
  const RunControl& control() const { return *control_; }
  Stage stage() const { return stage_; }

 private:
  void hear(Gate::Verdict verdict);
  /// A run that is repeated was stopped or given parameters where its next event says so.
  void hear_followed();

  Recorder* recorder_;
  const RunControl* control_;
  Stage stage_ = Stage::gamma;
  bool stopped_ = false;
  std::function<void(const CriteriaParameters&)> adopt_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

} // namespace isoscope
