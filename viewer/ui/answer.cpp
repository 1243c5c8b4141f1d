// What is partly in sight is left where it is while its beginning is.
#include "ui/answer.h"

#include <algorithm>

namespace isoscope::widgets {

AnswerRegion::AnswerRegion(Ui& ui, AnswerKind which, bool ready)
    : ui_(ui), which_(which), ready_(ready), at_(ImGui::GetCursorScreenPos()),
      width_(ImGui::GetContentRegionAvail().x) {}

AnswerRegion::~AnswerRegion() {
  AnswerInSight& answer = ui_.window.answer;
  const float end = ImGui::GetCursorScreenPos().y;
  if (answer.wanted == which_) {
    const float low = ImGui::GetWindowPos().y, high = low + ImGui::GetWindowHeight();
    // The line of the verdict that is pinned covers the top.
    const float pinned = ui_.px(44), needed = std::min(end - at_.y, high - low - 2 * pinned);
    if ((ready_ || !answer.awaited) && (at_.y < low + pinned || at_.y + needed > high))
      ImGui::SetScrollFromPosY(at_.y - low - pinned, 0);
    answer.awaited = true; // until it has come, the wheel stays free
    if (ready_) {
      answer.wanted = AnswerKind::none;
      answer.shown = which_;
      answer.since = ui_.window.clock;
    }
  }
  const double age = ui_.window.clock - answer.since;
  if (answer.shown != which_ || age > AnswerInSight::flash) return;
  const auto strength = static_cast<float>(1 - age / AnswerInSight::flash);
  const ImVec2 low{at_.x - ui_.px(6), at_.y - ui_.px(2)}, high{at_.x + width_ + ui_.px(6), end};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, to_u32(ui_.colors.accent, 0.16f * strength), ui_.px(5));
  list.AddRect(low, high, to_u32(ui_.colors.accent, 0.9f * strength), ui_.px(5), 0, ui_.px(1.5f));
}

} // namespace isoscope::widgets
