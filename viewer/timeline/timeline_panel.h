// The bottom pane: the timeline, the plots and the events over the same range of steps.
#pragma once

#include "ui/ui.h"

#include "query/expression.h"

#include <array>
#include <optional>
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

/// Events that pass the filter, with a field for it.
class EventList {
 public:
  void draw(Ui& ui);

 private:
  void filter_field(Ui& ui);
  void row(Ui& ui, std::uint32_t index, float high);
  std::array<char, 256> text_{};
  std::string applied_; ///< the model's text that the field shows
  std::optional<QueryError> error_;
  Step scrolled_to_ = 0;
};

/// The breakpoints with their counts, and a field for another one.
class BreakpointList {
 public:
  void draw(Ui& ui);

 private:
  std::array<char, 256> text_{};
};

/// What is wrong with a condition, below the field it was typed into: a caret below its place and two lines.
void query_error(Ui& ui, const QueryError& error, const std::string& text, float left);
/// The colour of a saved filter's lane; it also has a letter.
Rgb lane_color(std::size_t filter);
std::string lane_letter(std::size_t filter);

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
  /// Chooses a range of steps by a drag with Shift or Ctrl; true while it is drawn.
  bool choose_range(Ui& ui, double step);
  /// The chosen range with a cross that clears it; its width and the gap after it, 0 without one.
  float range_chip(Ui& ui, float left, float y) const;
  /// What lies outside of the chosen range steps back.
  void shade_range(const Ui& ui, ImVec2 low, ImVec2 size) const;
  void breadcrumb_line(const Ui& ui, float left, float y) const;
  void playhead(const Ui& ui, ImVec2 low, ImVec2 size) const;
  float to_x(double step, ImVec2 low, ImVec2 size) const;
  StepRange range_;
  std::optional<double> range_from_;            ///< where a drag for a range began
  const std::vector<float>* seconds_ = nullptr; ///< set while plots are drawn over seconds
  EventList events_;
  BreakpointList breakpoints_;
};

} // namespace isoscope
