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
  void row(Ui& ui, std::uint32_t index, float high);
  std::array<char, 128> text_{};
  std::string applied_;
  EventFilter filter_; ///< what the rows passed
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
  struct Plot;
  void plot_curve(const Ui& ui, const Plot& plot, ImVec2 low, ImVec2 size) const;
  void plot_rejections(const Ui& ui, ImVec2 low, ImVec2 size) const;
  void stage_marks(const Ui& ui, ImVec2 low, ImVec2 size, bool named) const;
  /// Steps or seconds, for the plots.
  void axis_switch(Ui& ui, float left, float y);
  /// A step's place within the range, in [0, 1], over steps or seconds, and the step at a place.
  double part_of(double step) const;
  double from_part(double part) const;
  /// Wheel and drag over an area of the steps; true while scrubbing.
  bool scrub(Ui& ui, const char* id, ImVec2 low, ImVec2 size);
  void playhead(const Ui& ui, ImVec2 low, ImVec2 size) const;
  float to_x(double step, ImVec2 low, ImVec2 size) const;
  StepRange range_;
  const std::vector<float>* seconds_ = nullptr; ///< set while plots are drawn over seconds
  EventList events_;
};

} // namespace isoscope
