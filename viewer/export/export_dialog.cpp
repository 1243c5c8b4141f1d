// What is chosen becomes the words of a command.
#include "export/export_dialog.h"

#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cstring>

namespace isoscope {
namespace {

struct Size {
  const char* title;
  int width, height;
};
constexpr std::array<Size, 4> sizes{
    {{"HD", 1280, 720}, {"Full HD", 1920, 1080}, {"4K", 3840, 2160}, {"8000 × 6000", 8000, 6000}}};

void label(Ui& ui, const char* text) {
  ImGui::AlignTextToFramePadding();
  widgets::quiet_text(ui, text);
  ImGui::SameLine(ui.px(120));
}

void whole_number(Ui& ui, const char* id, int& value, int low, int high) {
  ImGui::SetNextItemWidth(ui.px(110));
  if (ImGui::InputInt(id, &value, 0)) value = std::clamp(value, low, high);
}

} // namespace

void ExportDialog::steps(Ui& ui) {
  const int live = static_cast<int>(ui.window.live_step());
  if (fresh_ || to_ > live) to_ = live;
  label(ui, "Steps");
  whole_number(ui, "##from", from_, 0, live);
  ImGui::SameLine();
  ImGui::TextUnformatted("to");
  ImGui::SameLine();
  whole_number(ui, "##to", to_, from_, live);
  ImGui::SameLine();
  ImGui::TextUnformatted("every");
  ImGui::SameLine();
  whole_number(ui, "##every", every_, 1, std::max(live, 1));
}

void ExportDialog::export_button(Ui& ui, const Exports& exports) {
  static constexpr std::array<const char*, 4> commands{"picture", "svg", "turntable", "step-frames"};
  const bool busy = exports.pending(), named = name_[0] != 0;
  if (!widgets::primary_button(ui, "Write", named && !busy, ui.px(120))) return;
  const std::string name = name_.data();
  Arguments words{name};
  if (kind_ == turntable) words.push_back(std::to_string(frames_));
  if (kind_ == step_frames) {
    for (const int n : {from_, to_, every_}) words.push_back(std::to_string(n));
  }
  if (kind_ != figure) {
    words.push_back(std::to_string(width_) + "x" + std::to_string(height_));
    if (alpha_ && !(film_ && kind_ >= turntable)) words.push_back("alpha");
  }
  if (kind_ >= turntable && film_) {
    words.push_back(name + ".mp4");
    words.push_back(std::to_string(rate_) + "fps");
  }
  ui.commands.post("clear");
  ui.commands.post(commands[static_cast<std::size_t>(kind_)], words);
}

void ExportDialog::draw(Ui& ui, const Exports& exports) {
  static constexpr std::array<const char*, 4> kinds{"Picture", "SVG section", "Turntable", "Steps"};
  const int before = kind_;
  widgets::segmented(ui, "kind", kinds, kind_);
  if (fresh_ || kind_ != before) {
    static constexpr std::array<const char*, 4> names{"isoscope.png", "section.svg", "turntable", "steps"};
    name_.fill(0);
    const char* name = names[static_cast<std::size_t>(kind_)];
    std::copy_n(name, std::strlen(name), name_.begin());
  }
  ImGui::Dummy({0, ui.px(6)});
  label(ui, kind_ >= turntable ? "Folder" : "File");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##name", name_.data(), name_.size());
  if (kind_ != figure) {
    label(ui, "Size");
    whole_number(ui, "##width", width_, picture_least, picture_most);
    ImGui::SameLine();
    ImGui::TextUnformatted("×");
    ImGui::SameLine();
    whole_number(ui, "##height", height_, picture_least, picture_most);
    label(ui, "");
    for (const Size& size : sizes) {
      if (widgets::plain_button(ui, size.title)) width_ = size.width, height_ = size.height;
      ImGui::SameLine(0, ui.px(6));
    }
    ImGui::NewLine();
  }
  if (kind_ == turntable) {
    label(ui, "Frames");
    whole_number(ui, "##frames", frames_, 2, 100000);
  }
  if (kind_ == step_frames) steps(ui);
  if (kind_ >= turntable) {
    label(ui, "MP4");
    widgets::toggle(ui, "film", film_);
    ImGui::SameLine();
    whole_number(ui, "##rate", rate_, 1, 240);
    ImGui::SameLine();
    widgets::quiet_text(ui, "frames a second; needs ffmpeg");
  }
  if (kind_ != figure && !(film_ && kind_ >= turntable)) {
    label(ui, "Transparent");
    widgets::toggle(ui, "alpha", alpha_);
  }
  if (kind_ == figure)
    widgets::quiet_text(
        ui, "The 2D section in millimetres, with scale bar and a caption of step and parameters.", true);
  fresh_ = false;
  ImGui::Dummy({0, ui.px(8)});
  export_button(ui, exports);
}

namespace panels {

void export_progress(Ui& ui, const Exports& e, ImVec2 low, float width) {
  if (!e.busy || ui.window.scripted) return;
  const float wide = std::min(width - ui.px(24), ui.px(340)), high = ui.px(58);
  ImGui::SetNextWindowPos({low.x + (width - wide) / 2, low.y - high - ui.px(12)});
  ImGui::SetNextWindowSize({wide, high});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(12), ui.px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(7));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec(ui.colors.raised));
  ImGui::Begin("##export", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextColored(to_vec(ui.colors.accent_text), "%s", icon::camera);
  ImGui::SameLine(0, ui.px(10));
  ImGui::TextUnformatted(e.doing.c_str());
  ImGui::SameLine(wide - ui.px(86));
  if (widgets::plain_button(ui, "Cancel", true, ui.px(74))) ui.commands.post("cancel-export");
  const ImVec2 at{ImGui::GetWindowPos().x + ui.px(12), ImGui::GetWindowPos().y + high - ui.px(12)};
  const float length = wide - ui.px(24);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + length, at.y + ui.px(3)}, to_u32(ui.colors.line), ui.px(2));
  list.AddRectFilled(at, {at.x + length * static_cast<float>(e.part), at.y + ui.px(3)},
                     to_u32(ui.colors.accent), ui.px(2));
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

} // namespace panels
} // namespace isoscope
