// Go to one, note it, move it, remove it.
#include "talk/bookmarks_panel.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

namespace isoscope {
namespace {

std::string selection_words(const Pick& picked) {
  if (picked.kind == Pick::Kind::none) return "nothing selected";
  std::string text = std::string(pick_word(picked.kind)) + " " + std::to_string(picked.id);
  if (picked.kind == Pick::Kind::edge) text += "–" + std::to_string(picked.other);
  return text;
}

} // namespace

// Notes are typed into a buffer of their own and taken over when typing ends: files are not written at every
// letter.
void BookmarkList::row(Ui& ui, const Bookmarks& bookmarks, std::size_t at) {
  const Bookmark& b = bookmarks.all()[at];
  const std::size_t count = bookmarks.size();
  const std::string number = std::to_string(at + 1);
  const bool current = bookmarks.current() == at;
  ImGui::PushID(static_cast<int>(at));
  ImGui::TableNextRow(0, ui.px(40));
  if (current) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, to_u32(ui.colors.accent, 0.14f));
  const auto icons = [&] { ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ui.px(2)); };
  ImGui::TableNextColumn();
  icons();
  if (widgets::icon_button(ui, "go", current ? icon::star : icon::right))
    ui.commands.post("bookmark-go", {number});
  widgets::tip(ui, "Show bookmark " + number, at < 10 ? "Ctrl+" + std::to_string((at + 1) % 10) : "");
  ImGui::SameLine(0, ui.px(6));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(number.c_str());

  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(ui.fonts.mono);
  ImGui::TextUnformatted(grouped(b.step).c_str());
  ImGui::PopFont();

  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  widgets::quiet_text(ui, selection_words(b.picked));

  ImGui::TableNextColumn();
  const bool typing = editing_ == at;
  if (!typing) {
    shown_.fill(0);
    b.note.copy(shown_.data(), shown_.size() - 1);
  }
  ImGui::SetNextItemWidth(-1);
  auto& text = typing ? text_ : shown_;
  ImGui::InputTextWithHint("note", "a note", text.data(), text.size());
  if (ImGui::IsItemActivated() && !typing) {
    editing_ = at;
    text_ = shown_;
  }
  if (ImGui::IsItemDeactivated() && editing_ == at) {
    editing_.reset();
    if (b.note != text.data()) ui.commands.post("bookmark-note", {number, text.data()});
  }

  ImGui::TableNextColumn();
  icons();
  if (widgets::icon_button(ui, "up", icon::up, false, at > 0))
    ui.commands.post("bookmark-move", {number, std::to_string(at)});
  ImGui::SameLine(0, ui.px(2));
  if (widgets::icon_button(ui, "down", icon::down, false, at + 1 < count))
    ui.commands.post("bookmark-move", {number, std::to_string(at + 2)});
  ImGui::SameLine(0, ui.px(2));
  if (widgets::icon_button(ui, "delete", icon::close)) ui.commands.post("bookmark-delete", {number});
  widgets::tip(ui, "Delete bookmark " + number);
  ImGui::PopID();
}

void BookmarkList::draw(Ui& ui, const Talk& talk) {
  const std::size_t count = talk.bookmarks.size();
  if (editing_ && *editing_ >= count) editing_.reset();
  ImGui::BeginChild("rows", {0, -ui.px(48)});
  if (count == 0)
    widgets::quiet_text(ui, "None yet. Ctrl+B keeps the step, the view and the selection that are shown.");
  if (count > 0 && ImGui::BeginTable("bookmarks", 5, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthFixed, ui.px(62));
    ImGui::TableSetupColumn("step", ImGuiTableColumnFlags_WidthFixed, ui.px(80));
    ImGui::TableSetupColumn("selection", ImGuiTableColumnFlags_WidthFixed, ui.px(150));
    ImGui::TableSetupColumn("note", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("buttons", ImGuiTableColumnFlags_WidthFixed, ui.px(100));
    for (std::size_t i = 0; i < count; ++i) row(ui, talk.bookmarks, i);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::Dummy({0, ui.px(4)});
  if (widgets::primary_button(ui, "Add this step", ui.window.run.journal != nullptr, ui.px(150)))
    ui.commands.post("bookmark");
}

} // namespace isoscope
