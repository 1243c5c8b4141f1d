// The window's own memory: what undo brings back, and the bookmarks of the run that is open.
#include "app/app_model.h"

#include <utility>

namespace isoscope {

ViewMemento AppModel::memento() const {
  ViewMemento m;
  m.view = {camera.goal(), view, section};
  if (blinking) m.view.view.moment = Moment::both;
  m.filter = filter;
  m.condition = debug.filter_text;
  m.picked = selection.picked;
  m.kinds = selection.kinds;
  m.event = selection.event;
  m.panes = settings.panes;
  return m;
}

void AppModel::take(const ViewMemento& m) {
  if (!(m.view.camera == camera.goal())) {
    camera.set(m.view.camera, !scripted);
    camera.mark_set();
  }
  const Moment moment = view.moment;
  view = m.view.view;
  if (blinking) view.moment = moment;
  section = m.view.section;
  filter = m.filter;
  if (m.condition != debug.filter_text) {
    debug.filter_text = m.condition;
    const ParsedQuery parsed = parse_query(m.condition);
    const auto* expression = std::get_if<std::shared_ptr<const Expression>>(&parsed);
    debug.filter = expression != nullptr && !m.condition.empty() ? *expression : nullptr;
  }
  selection.pick(m.picked);
  selection.kinds = m.kinds;
  selection.event = m.event;
  settings.panes = m.panes;
}

// Until somebody moves it, the camera is the program's own, and so are the clip and the section of a new
// model.
void AppModel::watch_view() {
  history.set_window(scripted ? 0 : 0.5);
  unsigned unasked = 0;
  if (!camera.was_set()) unasked |= ViewHistory::camera;
  if (!section_set) unasked |= ViewHistory::section;
  if (std::exchange(clip_placed_, false)) unasked |= ViewHistory::look;
  if (!state()) unasked = ~0u;
  history.observe(memento(), clock, dragging, unasked);
}

// A run that goes on with other parameters keeps the bookmarks it began with.
void AppModel::fetch_bookmarks() {
  bookmarks = {};
  bookmarks_file_ = bookmarks_file(bookmarks_home, run.parameters);
  std::error_code ignored;
  if (bookmarks_file_.empty() || !std::filesystem::exists(bookmarks_file_, ignored)) return;
  if (auto loaded = load_bookmarks(bookmarks_file_))
    bookmarks = std::move(*loaded);
  else
    report(loaded.error());
}

void AppModel::keep_bookmarks() {
  if (bookmarks_file_.empty()) return;
  if (Status s = save_bookmarks(bookmarks_file_, bookmarks, run.parameters); !s) report(s.error());
}

} // namespace isoscope
