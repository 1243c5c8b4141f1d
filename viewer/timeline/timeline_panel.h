// The bottom pane: the timeline, the plots and the events over the same range of steps.
#pragma once

#include "ask/investigation.h"
#include "debug/event_list.h"
#include "talk/talk.h"
#include "two_runs/comparison.h"
#include "ui/ui.h"

#include <optional>
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

struct TimelineLane;

class TimelinePane {
 public:
  TimelinePane(const Debugger& debugger, const Talk& talk, Investigation& asked, const Comparison& comparison)
      : debugger_(debugger), talk_(talk), asked_(asked), comparison_(comparison) {}
  void draw(Ui& ui);

 private:
  void tabs(Ui& ui);
  void timeline(Ui& ui);
  void stage_lane(const Ui& ui, ImVec2 low, ImVec2 size) const;
  /// `gutter`: room on the left of the area for the lanes' names.
  void density(Ui& ui, ImVec2 low, ImVec2 size, float gutter);
  /// Where it was asked for: the pane becomes as high as all lanes need, or as at first where they have room.
  /// `high`: of the lanes now.
  static void give_room(Ui& ui, std::size_t lanes, bool some_left_out, float high);
  /// How many lanes have no room; a click gives it to them.
  static void left_out_sign(Ui& ui, const std::vector<TimelineLane>& left_out, ImVec2 at, ImVec2 size);
  /// How often over the steps, part upon part.
  void lane_bars(const Ui& ui, const TimelineLane& row, ImVec2 low, ImVec2 size, float strength) const;
  /// A click on a bar of a lane goes to the nearest event of that lane.
  void lane_click(Ui& ui, ImVec2 low, ImVec2 size);
  void marks(const Ui& ui, ImVec2 low, ImVec2 size, float y) const;
  void ruler(const Ui& ui, ImVec2 low, ImVec2 size) const;
  void plots(Ui& ui);
  struct Plot;
  /// These tell the width of the number that they put beside the title.
  float plot_curve(const Ui& ui, const Plot& plot, ImVec2 low, ImVec2 size) const;
  float plot_rejections(const Ui& ui, ImVec2 low, ImVec2 size) const;
  void stage_marks(const Ui& ui, ImVec2 low, ImVec2 size, bool named) const;
  /// Steps or seconds, for the plots.
  void axis_switch(Ui& ui, float left, float y);
  /// A step's place within the range, in [0, 1], over steps or seconds, and the step at a place.
  double part_of(double step) const;
  /// Seconds of a step, while plots are drawn over them.
  double time_at(double step) const;
  /// " over 12.3 s" or " over 1,234 steps": what the plots' axis spans.
  std::string extent_words() const;
  double from_part(double part) const;
  /// Wheel and drag over an area of the steps; true while scrubbing.
  bool scrub(Ui& ui, const char* id, ImVec2 low, ImVec2 size);
  /// Chooses a range of steps by a drag with Shift or Ctrl; true while it is drawn.
  bool choose_range(Ui& ui, double step);
  /// The chosen range with a cross that clears it; its width and the gap after it, 0 without one.
  float range_chip(Ui& ui, float left, float y) const;
  /// What lies outside of the chosen range steps back.
  void shade_range(const Ui& ui, ImVec2 low, ImVec2 size) const;
  /// From the step at which the panel's parameters would be taken: how long the rest would take.
  void forecast_band(const Ui& ui, ImVec2 low, ImVec2 size) const;
  void breadcrumb_line(const Ui& ui, float left, float y) const;
  void playhead(const Ui& ui, ImVec2 low, ImVec2 size) const;
  float to_x(double step, ImVec2 low, ImVec2 size) const;
  const Debugger& debugger_;
  const Talk& talk_;
  Investigation& asked_;
  const Comparison& comparison_;
  StepRange range_;
  std::optional<double> range_from_;            ///< where a drag for a range began
  const std::vector<float>* seconds_ = nullptr; ///< set while plots are drawn over seconds
  /// Where the lanes were drawn.
  struct LanePlace {
    std::string name;
    float low = 0, high = 0; ///< y
  };
  std::vector<LanePlace> lane_places_;
  EventList events_;
  BreakpointList breakpoints_;
};

} // namespace isoscope
