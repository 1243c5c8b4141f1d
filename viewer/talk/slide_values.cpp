// What scripts can expect of bookmarks, undo and the presenter mode.
#include "talk/talk.h"

namespace isoscope {

void Talk::add_values(NamedValues& t) {
  const auto of_current = [this]() -> const Bookmark* {
    const auto at = bookmarks.current();
    return at ? &bookmarks.all()[*at] : nullptr;
  };
  t.add("bookmarks.count", "bookmarks of this run", [this] { return bookmarks.size(); });
  t.add("bookmark", "the number of the bookmark shown last, 0 for none", [this] {
    const auto at = bookmarks.current();
    return at ? *at + 1 : 0;
  });
  t.readings("bookmark.", of_current, "nan")("step", "its step", &Bookmark::step);
  t.readings("bookmark.", of_current)("note", "its note", &Bookmark::note);
  t.add("undo.depth", "changes of the view that undo can take back",
        [this] { return window.history.undo_depth(); });
  t.add("redo.depth", "changes of the view that redo can bring again",
        [this] { return window.history.redo_depth(); });
  t.add("moments", "moments at which a talk dwells", [this] { return moments_.all().size(); });
  t.add("moment.told", "the one that is told, from 1, 0 for none", [this] {
    const TalkMoment* told = moment();
    return told != nullptr ? static_cast<std::size_t>(told - moments_.all().data()) + 1 : 0;
  });
  t.add("presenter", "whether the window is in presenter mode", [this] { return window.presenter.on; });
  t.add("slow_down", "whether presenting dwells at moments", [this] { return window.presenter.slow_down; });
  t.add("speed", "of the play head in steps a second, 0 for automatic",
        [this] { return window.transport.speed(); });
  t.add("caption", "the sentence of the step shown", [this] { return caption(); });
  const auto or_none = [](std::string text) { return text.empty() ? std::string("none") : text; };
  t.add("caption.why", "why that matters", [=, this] { return or_none(caption_why()); });
  t.add("caption.figure", "the paper's figure of the like", [=, this] { return or_none(caption_figure()); });
}

} // namespace isoscope
