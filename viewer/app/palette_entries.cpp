// Commands by any letters in order, the rest by the text itself.
#include "app/palette_entries.h"

#include "base/folded.h"
#include "command/command_search.h"
#include "input/gallery.h"
#include "model/words.h"
#include "ui/icons.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

/// The rest comes behind commands, at most so many of a kind.
constexpr std::size_t most_of_a_kind = 12;

bool holds_text(std::string_view text, std::string_view part) {
  return !part.empty() && contains_folded(text, part);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

class Finder {
 public:
  Finder(const AppModel& model, const std::string& typed)
      : model_(model), typed_(typed), text_(trimmed(typed)) {}

  void commands() {
    for (const Command* command : search_commands(model_.commands, typed_)) {
      // What is typed after the name are its arguments: "seek 120".
      const CommandCall call = model_.commands.parse(typed_);
      out.push_back({command->title + (command->usage.empty() ? "" : "  " + command->usage),
                     command->help,
                     command->keys.empty() ? "" : text(command->keys.front()),
                     command->icon,
                     command->is_enabled(),
                     {command->name, call.name == command->name ? call.arguments : Arguments{}}});
    }
  }

  void elements() {
    const CommandCall call = model_.commands.parse(text_);
    constexpr std::array<std::string_view, 7> kinds{"vertex", "edge",  "tet",     "facet",
                                                    "sample", "point", "over-rim"};
    const bool named = std::find(kinds.begin(), kinds.end(), call.name) != kinds.end();
    if (named && call.arguments.size() == (call.name == "edge" ? 2u : 1u))
      put("Select " + text_, "Selects it at this step.", icon::target,
          {"pick", call.name == "edge" ? Arguments{"edge", call.arguments[0], call.arguments[1]}
                                       : Arguments{call.name, call.arguments[0]}});
    const auto number = read_number(text_);
    if (!number || *number < 0 || *number != static_cast<double>(static_cast<std::size_t>(*number))) return;
    const auto n = static_cast<std::size_t>(*number);
    const auto& journal = model_.run.journal;
    if (n <= model_.live_step())
      put("Step " + grouped(n), "Goes there.", icon::clock, {"seek", {std::to_string(n)}});
    if (journal && n < journal->events().size())
      put("Event " + grouped(n), "Goes there and selects what it names.", icon::list,
          {"event", {std::to_string(n)}});
    const auto state = model_.state();
    if (!state) return;
    const auto element = [&](const char* kind, bool there) {
      if (there)
        put(std::string("Select ") + kind + " " + grouped(n), "At this step.", icon::target,
            {"pick", {kind, std::to_string(n)}});
    };
    element("vertex", n < state->complex.vertices.size() && state->complex.vertices[n].alive);
    element("tet", n < state->complex.tets.size() && state->complex.tets[n].alive());
    element("sample", state->samples && n < state->samples->size());
    element("facet", n < state->complex.facets.size() && state->complex.facets[n].alive());
  }

  void lessons() {
    const auto& all = bundled_lessons();
    if (!all) return;
    for (const Lesson& lesson : *all)
      if (matches(lesson.title + " lesson " + std::to_string(lesson.number)))
        put("Lesson " + std::to_string(lesson.number) + ": " + lesson.title, "Begins the lesson.",
            icon::graduation, {"lesson", {lesson.name}});
  }

  void models() {
    for (const GalleryEntry& entry : gallery())
      if (matches(entry.title))
        put("Model: " + std::string(entry.title), std::string(entry.lesson), icon::gallery,
            {"open", {gallery_input(entry.name)}});
  }

  /// The next event of a kind, a condition or a reason, called as lanes and lists call it.
  void events() {
    const JournalIndex& index = model_.index;
    const auto next = [&](std::string_view title, std::string_view name, std::string_view help) {
      put("Next event: " + std::string(title), std::string(help), icon::list,
          {"next-event", {std::string(name)}});
    };
    for (const ReasonWords& r : reason_table)
      if (rejects(r.value) && !index.rejections(r.value).empty() && matches(r.title))
        next(r.title, r.name, r.help);
    for (const KindWords& k : kind_table)
      if (index.count(k.value, 0, index.steps()) > 0 && matches(k.title)) next(k.title, k.name, k.help);
  }

  void settings() {
    std::size_t found = 0;
    for (const NamedValue& value : model_.values.all()) {
      if (!value.set || found == most_of_a_kind) continue;
      if (!matches(value.help) && !matches(value.name)) continue;
      ++found;
      const std::string now = value.get();
      const bool is_switch = now == "on" || now == "off";
      PaletteEntry entry{"Setting: " + value.help,
                         is_switch ? "Now " + now + "; switches it."
                                   : "Now " + now + "; Enter writes its name, then type a value.",
                         "",
                         icon::sliders,
                         true,
                         {"set", {value.name, now == "on" ? "off" : "on"}}};
      if (!is_switch) entry.complete = "set " + value.name + " ";
      out.push_back(std::move(entry));
    }
  }

  std::vector<PaletteEntry> out;

 private:
  bool matches(std::string_view words) const { return text_.size() > 1 && holds_text(words, text_); }
  void put(std::string title, std::string help, const char* icon, CommandCall call) {
    const Command* command = model_.commands.find(call.name);
    out.push_back({std::move(title), std::move(help), "", icon, command != nullptr && command->is_enabled(),
                   std::move(call)});
  }

  const AppModel& model_;
  const std::string& typed_;
  std::string text_;
};

} // namespace

std::vector<PaletteEntry> palette_entries(const AppModel& model, const std::string& typed) {
  Finder finder(model, typed);
  // A number or an element is meant as such; else commands come first.
  finder.elements();
  finder.commands();
  finder.lessons();
  finder.models();
  finder.events();
  finder.settings();
  return std::move(finder.out);
}

} // namespace isoscope
