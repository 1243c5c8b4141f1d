// Commands for talks: bookmarks as slides, the presenter mode; and undo of the view.
#include "app/command_actions.h"
#include "command/command_groups.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <array>
#include <string>
#include <utility>

namespace isoscope {
namespace {

using namespace actions;
using M = AppModel;
using A = Arguments;

/// Ctrl+1 to Ctrl+9 and Ctrl+0 for the tenth.
template <std::size_t... I> std::vector<Command> numbered(std::index_sequence<I...>) {
  constexpr std::array<std::string_view, 10> names{"bookmark-1", "bookmark-2", "bookmark-3", "bookmark-4",
                                                   "bookmark-5", "bookmark-6", "bookmark-7", "bookmark-8",
                                                   "bookmark-9", "bookmark-10"};
  constexpr std::array<std::string_view, 10> titles{
      "Go to bookmark 1", "Go to bookmark 2", "Go to bookmark 3", "Go to bookmark 4", "Go to bookmark 5",
      "Go to bookmark 6", "Go to bookmark 7", "Go to bookmark 8", "Go to bookmark 9", "Go to bookmark 10"};
  return {Command{names[I],
                  titles[I],
                  "",
                  "Shows its step, view and selection.",
                  "",
                  nullptr,
                  {{static_cast<int>('0' + (I + 1) % 10), true}},
                  [](M& m, const A&) { return go_to_bookmark(m, {std::to_string(I + 1)}); },
                  [](const M& m) { return m.bookmarks.size() > I; }}...};
}

} // namespace

std::vector<Command> slide_commands() {
  const auto has_run = [](const M& m) { return m.run.journal != nullptr; };
  const auto has_bookmarks = [](const M& m) { return m.bookmarks.size() > 0; };
  std::vector<Command> all{
      {"undo",
       "Undo the view",
       "",
       "Takes back the last change of view, filter, selection or layout; never of the run.",
       "View",
       nullptr,
       {{'Z', true}},
       undo_view,
       [](const M& m) { return m.history.undo_depth() > 0; }},
      {"redo",
       "Redo the view",
       "",
       "Brings again what was undone.",
       "View",
       nullptr,
       {{'Y', true}, {'Z', true, true}},
       redo_view,
       [](const M& m) { return m.history.redo_depth() > 0; }},
      {"presenter",
       "Presenter mode",
       "",
       "One scene with large text and a sentence on what happens; Esc ends it.",
       "Talk",
       icon::square,
       {{'P'}},
       [](M& m, const A&) {
         m.presenter.on = !m.presenter.on;
         m.overlay = Overlay::none;
         return Status();
       },
       nullptr,
       [](const M& m) { return m.presenter.on; }},
      {"slow-down",
       "Slow down at moments",
       "",
       "Presenting, playing dwells where a stage begins, the topology of Z changes or a collapse comes "
       "through "
       "at last.",
       "Talk",
       nullptr,
       {},
       [](M& m, const A&) {
         m.presenter.slow_down = !m.presenter.slow_down;
         return Status();
       },
       nullptr,
       [](const M& m) { return m.presenter.slow_down; }},
      {"bookmark",
       "Add a bookmark",
       "[NOTE…]",
       "Keeps step, view and selection, with a note.",
       "Talk",
       icon::star,
       {{'B', true}},
       add_bookmark,
       has_run},
      {"bookmarks",
       "Bookmarks…",
       "[save FILE | load FILE]",
       "Lists the bookmarks: notes, order, removal; or writes them to a file or reads them from one.",
       "Talk",
       icon::list,
       {{'B', true, true}},
       list_bookmarks},
      {"next-slide",
       "Next slide",
       "",
       "Shows the next bookmark; without bookmarks the next moment that matters.",
       "Talk",
       icon::forward,
       {{GLFW_KEY_PAGE_DOWN}},
       [](M& m, const A&) { return turn_slide(m, 1); },
       has_run},
      {"previous-slide",
       "Previous slide",
       "",
       "Shows the bookmark before; without bookmarks the moment before.",
       "Talk",
       icon::back,
       {{GLFW_KEY_PAGE_UP}},
       [](M& m, const A&) { return turn_slide(m, -1); },
       has_run},
      {"bookmark-go",
       "Go to bookmark…",
       "N",
       "Shows a bookmark's step, view and selection.",
       "",
       nullptr,
       {},
       go_to_bookmark,
       has_bookmarks},
      {"bookmark-note",
       "Note a bookmark…",
       "N NOTE…",
       "Gives a bookmark another note.",
       "",
       nullptr,
       {},
       note_bookmark,
       has_bookmarks},
      {"bookmark-move",
       "Move a bookmark…",
       "N TO",
       "Gives a bookmark another place in the order.",
       "",
       nullptr,
       {},
       move_bookmark,
       has_bookmarks},
      {"bookmark-delete",
       "Delete a bookmark…",
       "N",
       "Removes a bookmark from the list.",
       "",
       nullptr,
       {},
       delete_bookmark,
       has_bookmarks},
  };
  for (Command& command : numbered(std::make_index_sequence<10>())) all.push_back(std::move(command));
  return all;
}

} // namespace isoscope
