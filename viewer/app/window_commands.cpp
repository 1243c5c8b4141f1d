// What the commands on the window do, and their table.
#include "app/app_model.h"

#include "command/commands.h"
#include "ui/bottom_tabs.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

Status toggle_panes(WindowState& m, const Arguments&) {
  PaneLayout& p = m.settings.panes;
  const bool any = p.show_left || p.show_right || p.show_bottom;
  p.show_left = p.show_right = p.show_bottom = !any;
  return {};
}

/// The next pane in that direction that is there, or none: the window has its keys again.
void move_keys(WindowState& m, int direction) {
  const PaneLayout& p = m.settings.panes;
  const std::array<bool, 4> there{true, p.show_left, p.show_right, p.show_bottom};
  auto at = static_cast<std::size_t>(m.pane_of_keys);
  do {
    at = (at + there.size() + static_cast<std::size_t>(direction)) % there.size();
  } while (!there.at(at));
  m.pane_of_keys = static_cast<PaneOfKeys>(at);
  m.keys_moved = true;
}

std::string tab_words() {
  std::string words;
  for (const BottomTabName& tab : bottom_tabs) words += (words.empty() ? "" : " | ") + std::string(tab.word);
  return words;
}

Status choose_tab(WindowState& m, const Arguments& a) {
  const auto found = std::find_if(bottom_tabs.begin(), bottom_tabs.end(),
                                  [&](const BottomTabName& tab) { return !a.empty() && a[0] == tab.word; });
  if (found == bottom_tabs.end()) return wrong_arguments("Which tab?");
  m.open_tab(static_cast<BottomTab>(found - bottom_tabs.begin()));
  return {};
}

Status choose_theme(WindowState& m, const NamedValues& values, const Arguments& a) {
  if (!a.empty()) return values.find("theme")->set(a[0]);
  m.view.theme = static_cast<ThemeKind>((static_cast<int>(m.view.theme) + 1) % 3);
  return {};
}

void change_scale(WindowState& m, int direction) {
  float& scale = m.settings.ui_scale;
  scale = direction == 0
              ? 1.0f
              : std::clamp(std::round((scale + 0.1f * static_cast<float>(direction)) * 10) / 10, 0.5f, 4.0f);
}

struct PaneCommand {
  const char *name, *title, *help;
  int key;
  bool PaneLayout::*shown;
};
constexpr std::array<PaneCommand, 3> panes{
    {{"pane-left", "Layers and parameters", "Shows or hides the left pane.", '1', &PaneLayout::show_left},
     {"pane-right", "Inspector", "Shows or hides the right pane.", '2', &PaneLayout::show_right},
     {"pane-bottom", "Timeline", "Shows or hides the bottom pane.", '3', &PaneLayout::show_bottom}}};

} // namespace

void add_window_commands(CommandTable& table, WindowState& m, const NamedValues& values) {
  for (const PaneCommand& pane : panes) {
    bool& shown = m.settings.panes.*pane.shown;
    table.add({{.name = pane.name,
                .title = pane.title,
                .help = pane.help,
                .menu = "Window",
                .keys = {{pane.key, true, true}},
                .run = flips(shown),
                .checked = is_on(shown)}});
  }
  table.add(
      {{.name = "only-view",
        .title = "Only the view",
        .help = "Hides all panes, or shows them again.",
        .menu = "Window",
        .keys = {{'P', false, true}},
        .run = on(m, toggle_panes)},
       {.name = "next-pane",
        .title = "Keys to the next pane",
        .help = "Arrows, Enter and Tab go through the left, the right and the bottom pane in turn; after "
                "the last, or with Esc, they are the window's again.",
        .menu = "Window",
        .keys = {{GLFW_KEY_F6}},
        .run = does([&m] { move_keys(m, 1); })},
       {.name = "previous-pane",
        .title = "Keys to the previous pane",
        .help = "The same backwards.",
        .keys = {{GLFW_KEY_F6, false, true}},
        .run = does([&m] { move_keys(m, -1); })},
       {.name = "reset-layout",
        .title = "Reset layout",
        .help = "All panes in the sizes and places that they had at first.",
        .menu = "Window",
        .run = does([&m] { m.reset_layout(); })},
       {.name = "all-lanes",
        .title = "Room for every lane",
        .help = "Makes the timeline as high as all of its lanes need; again as high as at first.",
        .menu = "Window",
        .run = does([&m] {
          m.open_tab(BottomTab::timeline);
          m.requests.all_lanes = true;
        })},
       {.name = "tab",
        .title = "Bottom tab",
        .usage = tab_words(),
        .help = "Chooses what the bottom pane shows.",
        .run = on(m, choose_tab)}});
  add_group(table, {.menu = "Window"},
            {{.name = "theme",
              .title = "Theme",
              .usage = "[dark | light | paper]",
              .help = "Sets the colours; without a name it takes the next.",
              .keys = {{'T', true}},
              .run = [&m, &values](const Arguments& a) { return choose_theme(m, values, a); }},
             {.name = "larger",
              .title = "Larger interface",
              .help = "Enlarges text and controls.",
              .keys = {{GLFW_KEY_EQUAL, true}, {GLFW_KEY_KP_ADD, true}},
              .run = does([&m] { change_scale(m, 1); })},
             {.name = "smaller",
              .title = "Smaller interface",
              .help = "Makes text and controls smaller.",
              .keys = {{GLFW_KEY_MINUS, true}, {GLFW_KEY_KP_SUBTRACT, true}},
              .run = does([&m] { change_scale(m, -1); })},
             {.name = "normal-size",
              .title = "Normal size",
              .help = "Text and controls in the monitor's own scale.",
              .keys = {{'0', true, true}},
              .run = does([&m] { change_scale(m, 0); })}});
  table.add({{.name = "menu",
              .title = "Open a menu",
              .usage = "[File | Run | Select | Ask | View | Talk | Window | Help]",
              .help = "Opens a menu, as Alt with its first letter does; Alt alone the first one. Arrows go "
                      "through it.",
              .run = [&m](const Arguments& a) -> Status {
                const std::string_view wanted = a.empty() ? menu_names.front() : std::string_view(a[0]);
                if (std::find(menu_names.begin(), menu_names.end(), wanted) == menu_names.end())
                  return wrong_arguments("There is no such menu.");
                m.open_menu = wanted;
                return {};
              }}});
  add_group(table, {.menu = "Help"},
            {{.name = "palette",
              .title = "Command palette",
              .help = "Finds a command by typing.",
              .icon = icon::search,
              .keys = {{'P', true}},
              .run = does([&m] { m.toggle(Overlay::palette); })},
             {.name = "help",
              .title = "Help",
              .help = "Lists every key, command and value.",
              .icon = icon::help,
              .keys = {{GLFW_KEY_F1}},
              .run = does([&m] { m.toggle(Overlay::help); })},
             {.name = "welcome",
              .title = "Where to begin…",
              .help = "Three ways in: watch it work, why did it fail, your own model.",
              .icon = icon::home,
              .run = does([&m] { m.toggle(Overlay::welcome); })},
             {.name = "coach-marks",
              .title = "First hints again",
              .help = "Brings back the marks that say what the parts of the window are for.",
              .run = does([&m] { m.settings.coach_closed = 0; })},
             {.name = "about",
              .title = "About Isoscope",
              .help = "Says what this is, its licence and its sources.",
              .icon = icon::info,
              .run = does([&m] { m.toggle(Overlay::about); })}});
}

void add_window_values(NamedValues& values, WindowState& m) {
  values.add("overlay", "what lies over the window", [&m] {
    constexpr std::array<std::string_view, 10> names{"none",  "gallery",   "files",    "help",    "palette",
                                                     "about", "bookmarks", "pictures", "lessons", "welcome"};
    return names.at(static_cast<std::size_t>(m.overlay));
  });
  for (const PaneCommand& pane : panes) {
    const std::string name(pane.name);
    values.add(name, "whether that pane is shown",
               [&m, shown = pane.shown] { return m.settings.panes.*shown; });
    values.add(name + ".kept", "whether it is shown in the layout that is remembered",
               [&m, shown = pane.shown] { return m.kept_layout().*shown; });
  }
  values.add("menu", "the menu that is open", [&m] { return m.menu.empty() ? std::string("none") : m.menu; });
  values.add("keys", "the pane that arrows and Enter go through: none, left, right or bottom", [&m] {
    constexpr std::array<std::string_view, 4> names{"none", "left", "right", "bottom"};
    return names.at(static_cast<std::size_t>(m.pane_of_keys));
  });
  values.add("coach.closed", "first hints that are closed, as bits",
             [&m] { return int{m.settings.coach_closed}; });
}

} // namespace isoscope
