// The field, the menus of what may pass, the rows.
#include "debug/event_list.h"

#include "journal/describe.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <optional>

namespace isoscope {
namespace {

constexpr float event_row_units = 22;

/// How an event is marked: reasons of rejections by their own glyphs, the rest by kind.
struct EventStyle {
  Rgb color;
  MarkerShape shape;
};
EventStyle style_of(const Ui& ui, const Event& e) {
  const KindWords& kind = words(e.kind);
  switch (kind.role) {
  case ColorRole::reason:
    return {words(e.reason).color, words(e.reason).shape};
  case ColorRole::good:
    return {ui.colors.good, kind.shape};
  case ColorRole::warning:
    return {ui.colors.warning, kind.shape};
  case ColorRole::accent:
    return {ui.colors.accent, kind.shape};
  case ColorRole::stage:
    return {stage_color(ui.theme, e.stage), kind.shape};
  case ColorRole::condition:
    break;
  }
  return {condition_color(ui.theme, static_cast<int>(e.condition)),
          e.operation ? kind.shape : MarkerShape::hollow_square};
}

/// Where the columns of numbers end, from the right; narrow lists have fewer.
struct Columns {
  Columns(const Ui& ui, float width) : left(width) {
    constexpr std::array<float, 4> widths{150, 78, 96, 110}; // element, ms, limit, value
    constexpr std::array<EventColumn, 4> order{EventColumn::element, EventColumn::milliseconds,
                                               EventColumn::limit, EventColumn::value};
    constexpr float words = 420; // what the sentence keeps
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (left - ui.px(widths.at(i)) < ui.px(words)) break;
      ends[static_cast<std::size_t>(order.at(i))] = left - ui.px(10);
      left -= ui.px(widths.at(i));
    }
  }
  std::optional<float> right(EventColumn column) const { return ends[static_cast<std::size_t>(column)]; }
  float left; ///< where they begin
  std::array<std::optional<float>, event_column_names.size()> ends{};
};

std::string element_text(const Event& e) {
  if (e.vertex.valid() && e.other.valid())
    return std::to_string(e.vertex.value) + "–" + std::to_string(e.other.value);
  if (e.sample.valid()) return "sample " + std::to_string(e.sample.value);
  return e.tet.valid() ? "tet " + std::to_string(e.tet.value) : "";
}

/// A button that opens a list of what may pass; lit when it holds something back. True when changed.
template <std::size_t n, class Title>
bool filter_menu(const Ui& ui, const char* label, std::bitset<n>& set, const std::bitset<n>& offered,
                 Title&& title) {
  const std::string shown = std::string(label) + "  " + icon::down;
  const ImVec2 extent = widgets::text_size(shown), at = ImGui::GetCursorScreenPos();
  const ImVec2 size{extent.x + ui.px(20), ui.px(24)};
  ImGui::PushID(label);
  if (ImGui::InvisibleButton("filter", size)) ImGui::OpenPopup("entries");
  const bool hot = ImGui::IsItemHovered(), active = (set & offered) != offered;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(
      at, {at.x + size.x, at.y + size.y},
      active ? to_u32(ui.colors.accent, 0.24f) : to_u32(hot ? ui.colors.hover : ui.colors.raised), ui.px(5));
  widgets::draw_text(list, ImGui::GetFont(), {at.x + ui.px(10), at.y + (size.y - extent.y) / 2},
                     to_u32(active ? ui.colors.accent_text : ui.colors.text), shown);
  bool changed = false;
  if (ImGui::BeginPopup("entries")) {
    if (ImGui::Selectable("all", false, ImGuiSelectableFlags_DontClosePopups)) {
      set.set();
      changed = true;
    }
    ImGui::Separator();
    for (std::size_t i = 0; i < n; ++i) {
      if (!offered[i]) continue;
      const bool lit = active && set[i];
      if (!ImGui::Selectable((std::string(title(i)) + "##" + std::to_string(i)).c_str(), lit,
                             ImGuiSelectableFlags_DontClosePopups))
        continue;
      // The first choice is that one alone, further ones add up.
      if (!active) set.reset();
      set.flip(i);
      if (active && (set & offered).none()) set.set();
      changed = true;
    }
    ImGui::EndPopup();
  }
  ImGui::PopID();
  return changed;
}

} // namespace

void EventList::filter_field(Ui& ui) {
  ListFilter& f = ui.window.filter;
  if (applied_ != f.condition) {
    // Somebody else has set it.
    applied_ = f.condition;
    const std::size_t length = std::min(applied_.size(), text_.size() - 1);
    std::copy_n(applied_.begin(), length, text_.begin());
    text_[length] = 0;
    error_.reset();
  }
  ImGui::SetNextItemWidth(ui.px(300));
  if (!ImGui::InputTextWithHint(
          "##filter", (std::string(icon::search) + "  +reject +(kernel normals), value > limit …").c_str(),
          text_.data(), text_.size()))
    return;
  ParsedQuery parsed = parse_query(text_.data());
  error_.reset();
  if (const auto* error = std::get_if<QueryError>(&parsed)) {
    error_ = *error;
    return;
  }
  applied_ = text_.data();
  f.condition = applied_;
  f.expression = applied_.empty() ? nullptr : std::get<std::shared_ptr<const Expression>>(parsed);
}

void EventList::row(Ui& ui, std::uint32_t index) {
  WindowState& m = ui.window;
  const Journal& journal = *m.run.journal;
  const Event& event = journal.events()[index];
  const Step target = step_showing(event);
  widgets::Row row(ui, event_row_units);
  if (row.button(index)) ui.commands.post("event", {std::to_string(index)});
  const bool chosen = m.selection.event == index;
  const bool here = chosen || (target == m.transport.step() && event.operation);
  if (here || row.hovered())
    row.ground(here ? ui.colors.accent : ui.colors.hover, chosen ? 0.3f : here ? 0.16f : 1.0f);
  row.step(target);
  const EventStyle style = style_of(ui, event);
  row.glyph(80, style.color, style.shape);
  const Columns columns(ui, row.width);
  row.fitted(ui.fonts.small, 94, ui.colors.text, describe_event(journal, event), columns.left - ui.px(100),
             event.kind == EventKind::rejection ? 0.8f : 1.0f);
  const EventNumbers n = event_numbers(journal, m.index, index);
  const auto put = [&](EventColumn column, const std::string& text) {
    const auto right = columns.right(column);
    if (!right || text.empty()) return;
    const float extent = widgets::width_of(ui.fonts.mono, text);
    widgets::draw_text(row.list, ui.fonts.mono, {row.at.x + *right - extent, row.y(ui.fonts.mono)},
                       to_u32(ui.colors.text, 0.85f), text);
  };
  const std::string unit = n.unit.empty() ? "" : " " + std::string(n.unit);
  put(EventColumn::value, n.value ? number_beside(*n.value, n.limit.value_or(*n.value)) + unit : "");
  put(EventColumn::limit, n.limit ? short_number(*n.limit) + unit : "");
  put(EventColumn::milliseconds, n.milliseconds ? short_number(*n.milliseconds) : "");
  put(EventColumn::element, element_text(event));
}

void EventList::head(Ui& ui) {
  const widgets::Row row(ui, event_row_units);
  const Columns columns(ui, row.width);
  const EventSort sort = ui.window.event_sort;
  const auto title = [&](EventColumn column, float right, bool from_left) {
    const std::string_view word = event_column_names.at(static_cast<std::size_t>(column));
    const bool lit = sort.column == column && (column != EventColumn::step || sort.descending);
    const std::string text =
        std::string(word) + (lit ? std::string(" ") + (sort.descending ? icon::down : icon::up) : "");
    const float extent = widgets::width_of(ui.fonts.small, text);
    const float x = from_left ? right : right - extent;
    ImGui::SetCursorScreenPos({row.at.x + x - ui.px(6), row.at.y});
    ImGui::PushID(static_cast<int>(column));
    if (ImGui::InvisibleButton("head", {extent + ui.px(12), row.high}))
      ui.commands.post("sort-events", {std::string(word)});
    ImGui::PopID();
    const bool hot = ImGui::IsItemHovered();
    widgets::tip(ui, "Sort by this column", "The largest first; a second click the other way round.");
    widgets::draw_text(row.list, ui.fonts.small, {row.at.x + x, row.y(ui.fonts.small)},
                       to_u32(hot || lit ? ui.colors.text : ui.colors.quiet), text);
  };
  title(EventColumn::step, ui.px(20), true);
  for (const EventColumn column :
       {EventColumn::value, EventColumn::limit, EventColumn::milliseconds, EventColumn::element})
    if (const auto right = columns.right(column)) title(column, *right, false);
  row.below();
}

void EventList::draw(Ui& ui, const Debugger& debugger) {
  WindowState& m = ui.window;
  const widgets::Font font(ui.fonts.small);
  const float left = ImGui::GetCursorScreenPos().x;
  filter_field(ui);
  EventFilter& f = m.filter.chosen;
  widgets::beside_or_below(ui, "stage   ", 10);
  filter_menu(ui, "stage", f.stages, std::bitset<stage_count>().set(),
              [](std::size_t i) { return words(static_cast<Stage>(i)).title; });
  widgets::beside_or_below(ui, "kind   ", 5);
  filter_menu(ui, "kind", f.kinds, std::bitset<event_kind_count>().set(),
              [](std::size_t i) { return words(static_cast<EventKind>(i)).title; });
  widgets::beside_or_below(ui, "condition   ", 5);
  filter_menu(ui, "condition", f.conditions, std::bitset<condition_count>().set(),
              [](std::size_t i) { return i == 0 ? "none" : words(static_cast<Condition>(i)).title; });
  widgets::beside_or_below(ui, "reason   ", 5);
  std::bitset<reason_count> rejections;
  for (const Reason reason : rejecting_reasons) rejections.set(static_cast<std::size_t>(reason));
  filter_menu(ui, "reason", f.reasons, rejections,
              [](std::size_t i) { return words(static_cast<Reason>(i)).title; });
  if (!m.filter.condition.empty() || !f.everything()) {
    widgets::beside_or_below(ui, "show all", 10);
    if (widgets::plain_button(ui, "show all", true, 0, ui.px(24))) ui.commands.post("filter");
  }
  if (m.filter.expression) {
    widgets::beside_or_below(ui, "save as lane", 5);
    if (widgets::plain_button(ui, "save as lane", true, 0, ui.px(24))) ui.commands.post("save-filter");
  }
  const std::vector<std::uint32_t>& rows = debugger.listed_rows();
  const std::string number = counted(rows.size(), "event");
  widgets::beside_or_below(ui, number.c_str(), 14);
  widgets::quiet_text(ui, number);
  if (error_) query_error(ui, *error_, text_.data(), left);
  const Journal* journal = m.run.journal.get();

  if (rows.size() > EventOrder::most && !(m.event_sort == EventSort())) {
    ImGui::SameLine(0, ui.px(10));
    widgets::quiet_text(ui, "too many to be sorted: filter them first");
  }
  head(ui);
  if (ImGui::BeginChild("rows", {0, 0}) && journal != nullptr && debugger.listed.journal() == m.run.journal) {
    const float high = ui.px(event_row_units);
    // The row of the play head or of the chosen event comes into sight when it moved.
    const Step step = m.transport.step();
    const std::uint32_t place = m.selection.event.value_or(step);
    if (place != scrolled_to_) {
      scrolled_to_ = place;
      const bool sorted = !(m.event_sort == EventSort());
      const auto current =
          sorted ? std::find(rows.begin(), rows.end(), static_cast<std::uint32_t>(debugger.current_event()))
          : m.selection.event ? std::lower_bound(rows.begin(), rows.end(), *m.selection.event)
                              : std::partition_point(rows.begin(), rows.end(), [&](std::uint32_t row) {
                                  const Event& e = journal->events()[row];
                                  return step_showing(e) < step;
                                });
      const float y = static_cast<float>(current - rows.begin()) * high;
      const float scroll = ImGui::GetScrollY(), visible = ImGui::GetWindowHeight();
      const bool known = !sorted || current != rows.end();
      if (known && (y < scroll || y + high > scroll + visible))
        ImGui::SetScrollY(std::max(0.0f, y - visible / 2));
    }
    widgets::rows_in_sight(rows.size(), high, [&](std::size_t i) { row(ui, rows[i]); });
  }
  ImGui::EndChild();
}

} // namespace isoscope
