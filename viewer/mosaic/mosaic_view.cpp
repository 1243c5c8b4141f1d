// Picture, mouse, and what is said over them.
#include "mosaic/mosaic_view.h"

#include "base/numbers.h"
#include "ui/icons.h"
#include "ui/widgets.h"
#include "view/scene_overlay.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// Bricks fill a box better than the ball that a camera frames it by.
constexpr double mosaic_closer = 0.94;

void mosaic_tip(const Ui& ui, const TileProgress& p, std::uint32_t tile) {
  const TileReport& report = p.tiles[tile];
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::BeginTooltip();
  {
    const widgets::Font bold(ui.fonts.bold);
    ImGui::TextUnformatted(("Tile " + std::to_string(tile) + ", " + std::string(name(report.state))).c_str());
  }
  std::string text = counted(p.round.tiles[tile].facets, "facet") + " before the round";
  if (report.seconds > 0)
    text += (report.state == TileState::made ? "\nmade in " : "\nfor ") + general(report.seconds, 3) + " s";
  if (!report.who.empty()) text += "\n" + report.who;
  if (!report.words.empty()) text += "\n" + report.words;
  text += "\nA click makes it once more, to be stepped through.";
  {
    const widgets::Font small(ui.fonts.small);
    widgets::wrapped_text(text, ui.px(300));
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

} // namespace

// Until somebody moves the camera, all bricks stay in sight.
void MosaicView::frame(float aspect) {
  const auto scene = mosaic_.scene();
  if (!scene || mosaic_.camera.was_set()) return;
  const Box3 box = scene->bounds();
  if (box.empty() || (box.lo == framed_.lo && box.hi == framed_.hi && aspect == framed_aspect_)) return;
  framed_ = box;
  framed_aspect_ = aspect;
  mosaic_.camera.frame(box, false, static_cast<double>(aspect));
  CameraPose pose = mosaic_.camera.goal();
  pose.distance *= mosaic_closer;
  mosaic_.camera.set(pose);
}

void MosaicView::mouse(Ui& ui, ViewArea area) {
  const auto scene = mosaic_.scene();
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 at = ImGui::GetIO().MousePos;
  const auto met = [&]() -> std::optional<MosaicPick> {
    if (!scene) return std::nullopt;
    return pick_mosaic(*scene,
                       mosaic_.camera.ray(at.x - area.low.x, at.y - area.low.y, area.size.x, area.size.y));
  };
  mouse_.update(ui, mosaic_.camera, area, [&] {
    const auto pick = met();
    return pick ? pick->point : mosaic_.camera.pose().target;
  });
  if (!hovered || mouse_.dragged()) {
    if (!ImGui::IsAnyMouseDown() || mouse_.dragged()) mosaic_.hovered.reset();
    if (!hovered) return;
  }
  const auto pick = met();
  if (ImGui::IsItemDeactivated() && !mouse_.dragged() && ImGui::IsMouseReleased(0) && pick)
    ui.commands.post("rerun-tile", {std::to_string(pick->tile)});
  if (ImGui::IsAnyMouseDown()) return;
  mosaic_.hovered = pick ? std::optional(pick->tile) : std::nullopt;
  const auto news = mosaic_.news();
  if (!pick || !news || pick->tile >= news->progress.tiles.size()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  mosaic_tip(ui, news->progress, pick->tile);
}

void MosaicView::words(Ui& ui, ViewArea area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto news = mosaic_.news();
  if (!news || !news->mosaic) {
    const char* text = news ? "No round was begun yet." : "The folder is being read …";
    widgets::draw_text(
        list, ui.fonts.ui,
        {area.low.x + (area.size.x - widgets::width_of(ui.fonts.ui, text)) / 2, area.low.y + area.size.y / 2},
        to_u32(ui.colors.quiet), text);
  }
  const auto rerun = mosaic_.rerun_under_way();
  if (!rerun) return;
  const float width = ui.px(320), high = overlay::progress_box_height(ui, true);
  const ImVec2 at{area.low.x + (area.size.x - width) / 2, area.low.y + area.size.y - high - ui.px(24)};
  overlay::progress_box(ui,
                        "Tile " + std::to_string(rerun->tile) + " of round " + std::to_string(rerun->round) +
                            " is made once more",
                        rerun->fraction, "cancel-rerun", at, width);
}

void MosaicView::draw(Ui& ui) {
  const ViewArea area{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail()};
  if (area.size.x < 1 || area.size.y < 1) return;
  if (!renderer_ && !failed_) {
    auto made = MosaicPicture::create();
    failed_ = !made.ok();
    if (made)
      renderer_ = std::move(*made);
    else
      ui.window.report(made.error());
  }
  ImGui::InvisibleButton("mosaic", area.size, every_button);
  ImGui::SetItemAllowOverlap(); // the controls that lie over the picture come first
  ui.window.scene_area = {area.low.x, area.low.y, area.size.x, area.size.y};
  frame(area.size.x / area.size.y);
  mouse(ui, area);
  if (renderer_) {
    renderer_->set(mosaic_.scene(), ui.window.view.theme);
    ViewPicture::Key key;
    key.pose = mosaic_.camera.pose();
    key.scene = mosaic_.scene().get();
    key.view.theme = ui.window.view.theme;
    if (mosaic_.hovered) key.hover = {Pick::Kind::tet, *mosaic_.hovered, {}};
    picture_.draw(ui, area, key, [&](const FrameRequest& request) {
      return renderer_->render(mosaic_.camera, mosaic_.hovered, request);
    });
  }
  overlay::axes(ui, mosaic_.camera, area.low, area.size);
  if (mosaic_.folder() != nullptr)
    overlay::scale_bar(ui, mosaic_.folder()->manifest().delta, area.low, area.size,
                       mosaic_.camera.height_at_target());
  words(ui, area);
}

} // namespace isoscope
