// Dear ImGui draws no frame around buttons that are drawn by hand: here it is, from where its navigation is.
#include "ui/key_mark.h"

#include <imgui_internal.h>

namespace isoscope {

void mark_keys(const Ui& ui, bool moved) {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  const ImGuiWindow& pane = *ImGui::GetCurrentWindow();
  if (moved) g.NavDisableHighlight = false;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ImU32 color = to_u32(ui.colors.accent);
  const float inset = ui.px(1);
  list.AddRect({pane.Pos.x + inset, pane.Pos.y + inset},
               {pane.Pos.x + pane.Size.x - inset, pane.Pos.y + pane.Size.y - inset}, color, ui.px(3), 0,
               ui.px(1.5f));
  ImGuiWindow* const at = g.NavWindow;
  if (at == nullptr || at->RootWindow != pane.RootWindow || g.NavId == 0 || g.NavDisableHighlight) return;
  const ImRect item = ImGui::WindowRectRelToAbs(at, at->NavRectRel[g.NavLayer]);
  const float around = ui.px(2);
  list.PushClipRect(at->InnerRect.Min, at->InnerRect.Max, true);
  list.AddRect({item.Min.x - around, item.Min.y - around}, {item.Max.x + around, item.Max.y + around}, color,
               ui.px(4), 0, ui.px(2));
  list.PopClipRect();
}

} // namespace isoscope
