// The bottom pane: the timeline, the plots and the events over the same range of steps.
#pragma once

#include "panels/ui.h"

#include <array>
#include <string>
#include <vector>

namespace isoscope {

/// The range of steps that timeline and plots show; follows the run until somebody zooms.
struct StepRange {
  double begin = 0, end = 1;
  bool fits = true;
  void fit(Step steps);
  void zoom(double factor, double around, Step steps);
  void pan(double by, Step steps);
};

/// Events that pass the filter, gathered a little every frame, so that a hundred thousand cost nothing.
class EventList {
 public:
  void draw(Ui& ui);

 private:
  bool passes(const Journal& journal, const Event& event) const;
  void gather(const AppModel& model);
  std::array<char, 128> text_{};
  std::array<bool, condition_count> conditions_{true, true, true, true, true, true, true};
  bool operations_ = true, others_ = true;
  std::string applied_;
  const Journal* journal_ = nullptr;
  std::size_t scanned_ = 0;
  std::vector<std::uint32_t> rows_;
  Step scrolled_to_ = 0;
};

class TimelinePane {
 public:
  void draw(Ui& ui);

 private:
  void tabs(Ui& ui);
  void timeline(Ui& ui);
  void stage_lane(const Ui& ui, ImVec2 low, ImVec2 size) const;
  /// `gutter`: room on the left of the area for the lanes' names.
  void density(const Ui& ui, ImVec2 low, ImVec2 size, float gutter) const;
  void marks(const Ui& ui, ImVec2 low, ImVec2 size, float y) const;
  void ruler(const Ui& ui, ImVec2 low, ImVec2 size) const;
  void plots(Ui& ui);
  /// Wheel and drag over an area of the steps; true while scrubbing.
  bool scrub(Ui& ui, const char* id, ImVec2 low, ImVec2 size);
  void playhead(const Ui& ui, ImVec2 low, ImVec2 size) const;
  float to_x(double step, ImVec2 low, ImVec2 size) const;
  StepRange range_;
  EventList events_;
};

} // namespace isoscope
