// What scripts can expect of bookmarks, undo and the presenter mode.
#include "talk/talk.h"

namespace isoscope {

void Talk::add_values(NamedValues& t) {
  const auto of_current = [this]() -> const Bookmark* {
    const auto at = bookmarks.current();
    return at ? &bookmarks.all()[*at] : nullptr;
  };
  t.add("bookmarks.count", "bookmarks of this run", [this] { return std::to_string(bookmarks.size()); });
  t.add("bookmark", "the number of the bookmark shown last, 0 for none", [this] {
    const auto at = bookmarks.current();
    return std::to_string(at ? *at + 1 : 0);
  });
  t.add("bookmark.step", "its step", [of_current] {
    const Bookmark* b = of_current();
    return b ? std::to_string(b->step) : std::string("nan");
  });
  t.add("bookmark.note", "its note", [of_current] {
    const Bookmark* b = of_current();
    return b ? b->note : std::string("none");
  });
  t.add("undo.depth", "changes of the view that undo can take back",
        [this] { return std::to_string(window.history.undo_depth()); });
  t.add("redo.depth", "changes of the view that redo can bring again",
        [this] { return std::to_string(window.history.redo_depth()); });
  t.add("moments", "steps at which a talk dwells",
        [this] { return std::to_string(moments_.steps().size()); });
  t.add("presenter", "whether the window is in presenter mode",
        [this] { return std::string(window.presenter.on ? "on" : "off"); });
  t.add("slow_down", "whether presenting dwells at moments",
        [this] { return std::string(window.presenter.slow_down ? "on" : "off"); });
  t.add("speed", "of the play head in steps a second, 0 for automatic",
        [this] { return text_of(window.transport.speed()); });
  t.add("caption", "the sentence of the step shown", [this] { return caption(); });
}

} // namespace isoscope
