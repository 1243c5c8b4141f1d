// The improver's decisions as events of the journal.
#pragma once

#include "improve/surface_collapses.h"
#include "journal/stage_log.h"

namespace isoscope {

/// Writes operations and rejections; how a change of Z changes the state is told by those who derive.
class ImproverLog : public ImproverObserver {
 public:
  ImproverLog(double delta, StageLog& log) : delta_(delta), log_(log) {}
  bool accepted(const SurfaceChange& change, const ImproverVerdict& verdict) final;
  bool rejected(const ImproverVerdict& verdict) final;

 protected:
  /// The vertex of the state that is this vertex of the improver's surface.
  virtual VertexId vertex(std::uint32_t v) const = 0;
  /// Brings the state to the change; what turned it into what it is now.
  virtual Delta follow(const SurfaceChange& change) = 0;
  /// Of the state after that.
  virtual StepFigures figures() const = 0;

 private:
  Event event(const ImproverVerdict& verdict);

  double delta_;
  StageLog& log_;
};

} // namespace isoscope
