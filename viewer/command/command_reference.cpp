// Writing the page: one table a menu, in the order of the table of commands.
#include "command/commands.h"

#include <algorithm>
#include <vector>

namespace isoscope {
namespace {

std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

void table(std::string& page, std::string_view title, const std::vector<const Command*>& commands) {
  if (commands.empty()) return;
  page += "\n## " + std::string(title) + "\n\n| Command | Key | What it does |\n| --- | --- | --- |\n";
  for (const Command* c : commands) {
    std::string keys;
    for (const Chord& chord : c->keys) keys += (keys.empty() ? "" : ", ") + text(chord);
    const std::string form = c->name + (c->usage.empty() ? "" : " " + c->usage);
    page += "| `" + cell(form) + "` | " + keys + " | " + cell(c->help) + " |\n";
  }
}

} // namespace

std::string command_reference(const CommandTable& commands) {
  std::string page =
      "# Commands and keys\n\nMade from the program's table of commands, as are its menus, the "
      "palette (Ctrl+P) and the help (F1). Scripts use the names on the left.\n";
  std::vector<std::string_view> menus;
  for (const Command& c : commands.all())
    if (!c.menu.empty() && std::find(menus.begin(), menus.end(), c.menu) == menus.end())
      menus.push_back(c.menu);
  const auto take = [&](std::string_view title, auto wanted) {
    std::vector<const Command*> chosen;
    for (const Command& c : commands.all())
      if (wanted(c)) chosen.push_back(&c);
    table(page, title, chosen);
  };
  for (const std::string_view menu : menus) take(menu, [&](const Command& c) { return c.menu == menu; });
  take("In no menu", [](const Command& c) { return c.menu.empty() && !c.for_scripts; });
  take("For scripts", [](const Command& c) { return c.for_scripts; });
  return page;
}

} // namespace isoscope
