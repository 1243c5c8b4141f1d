// Finding out what belongs to one entry.
#include "model/view_history.h"

#include <utility>

namespace isoscope {

unsigned difference(const ViewMemento& a, const ViewMemento& b) {
  unsigned parts = 0;
  const auto differ = [&](bool same, unsigned part) { parts |= same ? 0 : part; };
  differ(a.view.camera == b.view.camera, ViewHistory::camera);
  differ(a.view.view == b.view.view, ViewHistory::look);
  differ(a.view.section.u == b.view.section.u && a.view.section.v == b.view.section.v &&
             a.view.section.height == b.view.section.height,
         ViewHistory::section);
  differ(a.filter == b.filter && a.condition == b.condition, ViewHistory::filter);
  differ(a.picked == b.picked && a.kinds == b.kinds && a.event == b.event, ViewHistory::selection);
  differ(a.panes == b.panes, ViewHistory::layout);
  return parts;
}

void ViewHistory::reset() {
  *this = ViewHistory(window_);
}

void ViewHistory::observe(const ViewMemento& now, double clock, bool dragging, unsigned unasked) {
  if (!present_) {
    present_ = now;
    return;
  }
  const unsigned parts = difference(*present_, now);
  if (!dragging && drag_open_) open_ = drag_open_ = false;
  if ((parts & ~unasked) == 0) {
    if (parts != 0) present_ = now;
    return;
  }
  const bool in_time = clock - changed_at_ <= window_ && window_ > 0 && parts == open_parts_;
  if (!(open_ && (drag_open_ || in_time))) {
    past_.push_back(*present_);
    if (past_.size() > limit) past_.pop_front();
    future_.clear();
    open_ = true;
    drag_open_ = dragging;
  }
  open_parts_ = parts;
  changed_at_ = clock;
  present_ = now;
}

std::optional<ViewMemento> ViewHistory::undo() {
  if (past_.empty()) return std::nullopt;
  future_.push_back(*std::exchange(present_, past_.back()));
  past_.pop_back();
  open_ = drag_open_ = false;
  return present_;
}

std::optional<ViewMemento> ViewHistory::redo() {
  if (future_.empty()) return std::nullopt;
  past_.push_back(*std::exchange(present_, future_.back()));
  future_.pop_back();
  open_ = drag_open_ = false;
  return present_;
}

} // namespace isoscope
