// What the commands on bookmarks, undo and the presenter mode do.
#include "app/command_actions.h"
#include "command/named_values.h"
#include "command/usage.h"
#include "model/words.h"

#include <algorithm>
#include <cmath>

namespace isoscope::actions {
namespace {

std::string joined(const Arguments& a, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < a.size(); ++i) text += (text.empty() ? "" : " ") + a[i];
  return text;
}

/// An argument as an index from 0 into the list; scripts and people count from 1.
Result<std::size_t> index_of(const AppModel& model, const std::string& command, const Arguments& a,
                             std::size_t argument) {
  if (a.size() <= argument) return usage(command, "The number of a bookmark is missing.");
  const auto n = parse_number(a[argument]);
  if (!n || *n < 1 || *n != std::floor(*n) || *n > static_cast<double>(model.bookmarks.size()))
    return Error{ErrorCode::usage, "There is no bookmark " + a[argument] + ".",
                 model.bookmarks.size() == 0 ? "Ctrl+B makes one." : "Ctrl+Shift+B lists them."};
  return static_cast<std::size_t>(*n) - 1;
}

Status show(AppModel& model, std::size_t at) {
  const Bookmark* b = model.bookmarks.go(at);
  if (b == nullptr) return Error{ErrorCode::usage, "There is no such bookmark.", ""};
  if (b->step > model.live_step())
    return Error{ErrorCode::usage,
                 "Step " + grouped(b->step) + " of bookmark " + std::to_string(at + 1) +
                     " is not reached yet.",
                 "Let the run go on, then come back."};
  model.transport.jump(b->step);
  const ThemeKind theme = model.view.theme;
  model.blinking = false;
  model.view = b->view.view;
  model.view.theme = theme;
  model.section = b->view.section;
  model.section_set = true;
  model.camera.set(b->view.camera, !model.scripted);
  model.camera.mark_set();
  model.selection.pick(b->picked);
  model.selection.event = b->event;
  return {};
}

} // namespace

Status add_bookmark(AppModel& model, const Arguments& a) {
  Bookmark b;
  b.step = model.transport.step();
  const ViewMemento now = model.memento();
  b.picked = now.picked;
  b.event = now.event;
  b.view = now.view;
  b.note = joined(a, 0);
  model.bookmarks.add(std::move(b));
  model.keep_bookmarks();
  if (!model.scripted)
    model.tell("Bookmark " + std::to_string(model.bookmarks.size()) +
               " holds this step, view and selection.");
  return {};
}

Status go_to_bookmark(AppModel& model, const Arguments& a) {
  const auto at = index_of(model, "bookmark-go", a, 0);
  return at ? show(model, *at) : Status(at.error());
}

// Without bookmarks a clicker goes through the moments that matter.
Status turn_slide(AppModel& model, int direction) {
  if (model.bookmarks.size() > 0) {
    const auto next = model.bookmarks.neighbour(direction);
    return next ? show(model, *next) : Status();
  }
  const auto& steps = model.moments.steps();
  const Step at = model.transport.step();
  if (direction > 0) {
    const auto next = std::upper_bound(steps.begin(), steps.end(), at);
    model.transport.jump(next == steps.end() ? model.live_step() : *next);
  } else {
    const auto next = std::lower_bound(steps.begin(), steps.end(), at);
    model.transport.jump(next == steps.begin() ? 0 : *(next - 1));
  }
  return {};
}

Status list_bookmarks(AppModel& model, const Arguments& a) {
  if (a.empty()) return toggle_overlay(model, Overlay::bookmarks);
  if (a.size() != 2 || (a[0] != "save" && a[0] != "load"))
    return usage("bookmarks", "\"" + joined(a, 0) + "\" is not understood.");
  if (a[0] == "save") return save_bookmarks(a[1], model.bookmarks, model.run.parameters);
  auto loaded = load_bookmarks(a[1]);
  if (!loaded) return loaded.error();
  model.bookmarks = std::move(*loaded);
  model.keep_bookmarks();
  return {};
}

Status note_bookmark(AppModel& model, const Arguments& a) {
  const auto at = index_of(model, "bookmark-note", a, 0);
  if (!at) return at.error();
  model.bookmarks.set_note(*at, joined(a, 1));
  model.keep_bookmarks();
  return {};
}

Status move_bookmark(AppModel& model, const Arguments& a) {
  const auto from = index_of(model, "bookmark-move", a, 0), to = index_of(model, "bookmark-move", a, 1);
  if (!from) return from.error();
  if (!to) return to.error();
  model.bookmarks.move(*from, *to);
  model.keep_bookmarks();
  return {};
}

Status delete_bookmark(AppModel& model, const Arguments& a) {
  const auto at = index_of(model, "bookmark-delete", a, 0);
  if (!at) return at.error();
  model.bookmarks.remove(*at);
  model.keep_bookmarks();
  return {};
}

Status undo_view(AppModel& model, const Arguments&) {
  if (const auto before = model.history.undo()) model.take(*before);
  return {};
}

Status redo_view(AppModel& model, const Arguments&) {
  if (const auto after = model.history.redo()) model.take(*after);
  return {};
}

} // namespace isoscope::actions
