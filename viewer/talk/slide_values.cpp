// Named values of bookmarks, undo and the presenter mode, and the caption they share.
#include "talk/caption.h"
#include "command/named_table.h"
#include "journal/describe.h"

namespace isoscope {

std::string plain_caption(const AppModel& m) {
  const auto shown = m.state();
  if (!shown || !m.run.journal) return m.running() ? "the model is being prepared" : "no model is open";
  const auto chosen = m.selection.event ? m.selected_event() : std::nullopt;
  if (chosen) return plain_words(*m.run.journal, m.run.journal->events()[*chosen]);
  if (shown->event) return plain_words(*m.run.journal, *shown->event);
  return "a box around the samples, before the first point goes in";
}

void add_slide_values(NamedTable& t) {
  const auto reading = [&](const char* name, const char* help, std::string (*get)(const AppModel&)) {
    t.push_back({name, help, get, nullptr});
  };
  const auto of_current = [](const AppModel& m) -> const Bookmark* {
    const auto at = m.bookmarks.current();
    return at ? &m.bookmarks.all()[*at] : nullptr;
  };
  reading("bookmarks.count", "bookmarks of this run",
          [](const AppModel& m) { return std::to_string(m.bookmarks.size()); });
  reading("bookmark", "the number of the bookmark shown last, 0 for none", [](const AppModel& m) {
    const auto at = m.bookmarks.current();
    return std::to_string(at ? *at + 1 : 0);
  });
  t.push_back({"bookmark.step", "its step",
               [of_current](const AppModel& m) {
                 const Bookmark* b = of_current(m);
                 return b ? std::to_string(b->step) : std::string("nan");
               },
               nullptr});
  t.push_back({"bookmark.note", "its note",
               [of_current](const AppModel& m) {
                 const Bookmark* b = of_current(m);
                 return b ? b->note : std::string("none");
               },
               nullptr});
  reading("undo.depth", "changes of the view that undo can take back",
          [](const AppModel& m) { return std::to_string(m.history.undo_depth()); });
  reading("redo.depth", "changes of the view that redo can bring again",
          [](const AppModel& m) { return std::to_string(m.history.redo_depth()); });
  reading("moments", "steps at which a talk dwells",
          [](const AppModel& m) { return std::to_string(m.moments.steps().size()); });
  reading("presenter", "whether the window is in presenter mode",
          [](const AppModel& m) { return std::string(m.presenter.on ? "on" : "off"); });
  reading("slow_down", "whether presenting dwells at moments",
          [](const AppModel& m) { return std::string(m.presenter.slow_down ? "on" : "off"); });
  reading("speed", "of the play head in steps a second, 0 for automatic",
          [](const AppModel& m) { return text_of(m.transport.speed()); });
  reading("caption", "the sentence of the step shown", plain_caption);
}

} // namespace isoscope
