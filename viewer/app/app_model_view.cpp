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
  bookmarks_recording_ = shows_recording() ? run.recording->file : std::filesystem::path();
  bookmark_files_ = bookmark_files(bookmarks_home, bookmarks_recording_, run.parameters);
  bookmarks_told_ = false;
  auto kept = kept_bookmarks(bookmark_files_);
  if (!kept) report(kept.error());
  bookmarks = kept ? std::move(*kept) : Bookmarks();
}

void AppModel::keep_bookmarks() {
  const auto file = isoscope::keep_bookmarks(bookmark_files_, bookmarks, run.parameters);
  if (!file) return report(file.error());
  if (bookmark_files_.beside.empty() || *file == bookmark_files_.beside ||
      std::exchange(bookmarks_told_, true))
    return;
  tell("Nothing can be written beside the input: the bookmarks are kept in " + file->string() + ".");
}

} // namespace isoscope
