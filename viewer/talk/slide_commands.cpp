// Commands for talks: bookmarks as slides, the presenter mode.
#include "talk/talk.h"

#include "command/commands.h"
#include "model/words.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

namespace isoscope {
namespace {

/// An argument as an index from 0 into the list; scripts and people count from 1.
Result<std::size_t> index_of(const Talk& talk, const Arguments& a, std::size_t argument) {
  if (a.size() <= argument) return wrong_arguments("The number of a bookmark is missing.");
  const auto n = whole_argument(a, argument, 1, talk.bookmarks.size());
  if (!n)
    return Error{ErrorCode::usage, "There is no bookmark " + a[argument] + ".",
                 talk.bookmarks.size() == 0 ? "Ctrl+B makes one." : "Ctrl+Shift+B lists them."};
  return *n - 1;
}

Status show(Talk& talk, std::size_t at) {
  const Bookmark* b = talk.bookmarks.go(at);
  if (b == nullptr) return usage("There is no such bookmark.");
  if (b->step > talk.window.live_step())
    return Error{ErrorCode::usage,
                 "Step " + grouped(b->step) + " of bookmark " + std::to_string(at + 1) +
                     " is not reached yet.",
                 "Let the run go on, then come back."};
  talk.window.transport.jump(b->step);
  talk.window.blinking = false;
  talk.window.show(b->view);
  talk.window.selection.pick(b->picked);
  talk.window.selection.event = b->event;
  return {};
}

Status add_bookmark(Talk& talk, const Arguments& a) {
  Bookmark b;
  b.step = talk.window.transport.step();
  const ViewMemento now = talk.window.memento();
  b.picked = now.picked;
  b.event = now.event;
  b.view = now.view;
  b.note = joined(a);
  talk.bookmarks.add(std::move(b));
  talk.keep_bookmarks();
  if (!talk.window.scripted)
    talk.window.tell("Bookmark " + std::to_string(talk.bookmarks.size()) +
                     " holds this step, view and selection.");
  return {};
}

Status go_to_bookmark(Talk& talk, const Arguments& a) {
  const auto at = index_of(talk, a, 0);
  return at ? show(talk, *at) : Status(at.error());
}

// Without bookmarks a clicker goes through the moments that matter.
Status turn_slide(Talk& talk, int direction) {
  if (talk.bookmarks.size() > 0) {
    const auto next = talk.bookmarks.neighbour(direction);
    return next ? show(talk, *next) : Status();
  }
  talk.turn_to_moment(direction);
  return {};
}

Status list_bookmarks(Talk& talk, const Arguments& a) {
  if (a.empty()) {
    talk.window.toggle(Overlay::bookmarks);
    return {};
  }
  if (a.size() != 2 || (a[0] != "save" && a[0] != "load"))
    return wrong_arguments("\"" + joined(a) + "\" is not understood.");
  if (a[0] == "save") return save_bookmarks(a[1], talk.bookmarks, talk.window.run.parameters);
  auto loaded = load_bookmarks(a[1]);
  if (!loaded) return loaded.error();
  talk.bookmarks = std::move(*loaded);
  talk.keep_bookmarks();
  return {};
}

Status note_bookmark(Talk& talk, const Arguments& a) {
  const auto at = index_of(talk, a, 0);
  if (!at) return at.error();
  talk.bookmarks.set_note(*at, joined(a, 1));
  talk.keep_bookmarks();
  return {};
}

Status move_bookmark(Talk& talk, const Arguments& a) {
  const auto from = index_of(talk, a, 0), to = index_of(talk, a, 1);
  if (!from) return from.error();
  if (!to) return to.error();
  talk.bookmarks.move(*from, *to);
  talk.keep_bookmarks();
  return {};
}

Status delete_bookmark(Talk& talk, const Arguments& a) {
  const auto at = index_of(talk, a, 0);
  if (!at) return at.error();
  talk.bookmarks.remove(*at);
  talk.keep_bookmarks();
  return {};
}

} // namespace

void Talk::add_commands(CommandTable& table) {
  const auto has_run = [this] { return window.has_run(); };
  const auto has_bookmarks = [this] { return bookmarks.size() > 0; };
  add_group(
      table, {.menu = "Talk"},
      {{.name = "presenter",
        .title = "Presenter mode",
        .help = "One scene with large text and a sentence on what happens; Esc ends it.",
        .icon = icon::square,
        .keys = {{'P'}},
        .run = does([this] {
          window.presenter.on = !window.presenter.on;
          window.overlay = Overlay::none;
        }),
        .checked = is_on(window.presenter.on)},
       {.name = "slow-down",
        .title = "Slow down at moments",
        .help = "Presenting, playing goes through the first thirty steps slowly and dwells at what is new: "
                "stages, conditions, changes of the topology, reasons for which edges stay.",
        .run = flips(window.presenter.slow_down),
        .checked = is_on(window.presenter.slow_down)},
       {.name = "bookmark",
        .title = "Add a bookmark",
        .usage = "[NOTE…]",
        .help = "Keeps step, view and selection, with a note.",
        .icon = icon::star,
        .keys = {{'B', true}},
        .run = on(*this, add_bookmark),
        .enabled = has_run},
       {.name = "bookmarks",
        .title = "Bookmarks…",
        .usage = "[save FILE | load FILE]",
        .help =
            "Lists the bookmarks: notes, order, removal; or writes them to a file or reads them from one.",
        .icon = icon::list,
        .keys = {{'B', true, true}},
        .run = on(*this, list_bookmarks)},
       {.name = "next-slide",
        .title = "Next slide",
        .help = "Shows the next bookmark; without bookmarks the next moment that matters.",
        .icon = icon::forward,
        .keys = {{GLFW_KEY_PAGE_DOWN}},
        .run = [this](const Arguments&) { return turn_slide(*this, 1); },
        .enabled = has_run},
       {.name = "previous-slide",
        .title = "Previous slide",
        .help = "Shows the bookmark before; without bookmarks the moment before.",
        .icon = icon::back,
        .keys = {{GLFW_KEY_PAGE_UP}},
        .run = [this](const Arguments&) { return turn_slide(*this, -1); },
        .enabled = has_run}});
  add_group(table, {.enabled = has_bookmarks},
            {{.name = "bookmark-go",
              .title = "Go to bookmark…",
              .usage = "N",
              .help = "Shows a bookmark's step, view and selection.",
              .run = on(*this, go_to_bookmark)},
             {.name = "bookmark-note",
              .title = "Note a bookmark…",
              .usage = "N NOTE…",
              .help = "Gives a bookmark another note.",
              .run = on(*this, note_bookmark)},
             {.name = "bookmark-move",
              .title = "Move a bookmark…",
              .usage = "N TO",
              .help = "Gives a bookmark another place in the order.",
              .run = on(*this, move_bookmark)},
             {.name = "bookmark-delete",
              .title = "Delete a bookmark…",
              .usage = "N",
              .help = "Removes a bookmark from the list.",
              .run = on(*this, delete_bookmark)}});
  // Ctrl+1 to Ctrl+9, and Ctrl+0 for the tenth.
  for (int i = 0; i < 10; ++i) {
    const std::string number = std::to_string(i + 1);
    table.add({{.name = "bookmark-" + number,
                .title = "Go to bookmark " + number,
                .help = "Shows its step, view and selection.",
                .keys = {{'0' + (i + 1) % 10, true}},
                .run = [this, number](const Arguments&) { return go_to_bookmark(*this, {number}); },
                .enabled = [this, i] { return bookmarks.size() > static_cast<std::size_t>(i); }}});
  }
}

} // namespace isoscope
