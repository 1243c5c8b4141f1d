// Progress above, the tiles in a list below it.
#include "base/numbers.h"
#include "mosaic/mosaic.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope::panels {
namespace {

constexpr std::array<TileState, tile_state_count> by_progress{
    TileState::made, TileState::in_hand, TileState::lost, TileState::failed, TileState::waiting};

struct StateMark {
  Rgb color;
  MarkerShape shape; ///< says the same as the colour
};

Rgb to_rgb(glm::vec3 c) {
  const auto byte = [](float v) { return static_cast<Rgb>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); };
  return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
}

StateMark state_mark(const Ui& ui, TileState state) {
  constexpr std::array<MarkerShape, tile_state_count> shapes{
      MarkerShape::ring, MarkerShape::diamond, MarkerShape::triangle, MarkerShape::cross, MarkerShape::disc};
  return {to_rgb(state_color(state, scene_colors(ui.theme))), shapes.at(static_cast<std::size_t>(state))};
}

/// A bar of the round's facets by the state of their tiles.
void round_bar(const Ui& ui, const TileProgress& p) {
  std::array<double, tile_state_count> facets{};
  double all = 0;
  for (std::size_t i = 0; i < p.tiles.size(); ++i) {
    const auto n = static_cast<double>(p.round.tiles[i].facets);
    facets.at(static_cast<std::size_t>(p.tiles[i].state)) += n;
    all += n;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, high = ui.px(10);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.line), high / 2);
  list.PushClipRect(at, {at.x + width, at.y + high}, true);
  double from = 0;
  for (const TileState state : by_progress) {
    const double share = all > 0 ? facets.at(static_cast<std::size_t>(state)) / all : 0;
    if (share > 0 && state != TileState::waiting) {
      const float x0 = at.x + width * static_cast<float>(from),
                  x1 = at.x + width * static_cast<float>(from + share);
      const bool first = from <= 0, last = from + share >= 1 - 1e-9;
      list.AddRectFilled({x0, at.y}, {x1, at.y + high}, to_u32(state_mark(ui, state).color), high / 2,
                         first && last ? ImDrawFlags_RoundCornersAll
                         : first       ? ImDrawFlags_RoundCornersLeft
                         : last        ? ImDrawFlags_RoundCornersRight
                                       : ImDrawFlags_RoundCornersNone);
    }
    from += share;
  }
  list.PopClipRect();
  ImGui::Dummy({width, high});
}

std::string round_words(const TileFolder& folder, const TileRound& round) {
  if (round.number == 0) return "No round was begun yet.";
  const std::string tiling =
      round.tiling.whole
          ? "all in one tile"
          : "tiles of " +
                general(std::ldexp(bricks_of_tile * folder.manifest().brick, round.tiling.level), 4) +
                ", moved by " + std::to_string(round.tiling.shift) + "/4";
  return "Round " + std::to_string(round.number) + ": " + tiling + ", effort " + std::to_string(round.effort);
}

void mosaic_head(Ui& ui, Mosaic& m, const TileProgress* p) {
  const TileFolder& folder = *m.folder();
  const TileManifest& manifest = folder.manifest();
  {
    const widgets::Font title(ui.fonts.title);
    const std::filesystem::path path = folder.folder();
    const std::string name =
        path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
    ImGui::TextUnformatted(widgets::fitted(name, ImGui::GetContentRegionAvail().x - ui.px(34)).c_str());
  }
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - ui.px(28));
  if (widgets::icon_button(ui, "close", icon::close)) ui.commands.post("tiles");
  widgets::command_tip(ui, "tiles");
  widgets::quiet_text(ui,
                      std::filesystem::path(manifest.parameters.input).filename().string() +
                          ", δ = " + manifest.parameters.tolerance.text() + ", " +
                          counted(manifest.triangles, "triangle"),
                      true);
  ImGui::Dummy({0, ui.px(6)});
  if (p == nullptr) return;
  round_bar(ui, *p);
  ImGui::Dummy({0, ui.px(2)});
  const std::string made =
      grouped(p->count(TileState::made)) + " of " + counted(p->tiles.size(), "tile") + " made";
  widgets::bold_text(ui, p->finished ? "Done, " + counted(p->round.number, "round") : made);
  const std::string left = time_left_words(*p);
  if (!left.empty()) widgets::quiet_text(ui, left, true);
  widgets::quiet_text(ui, round_words(folder, p->round), true);
  if (!p->finished && p->count(TileState::in_hand) == 0)
    widgets::quiet_text(ui, "Nobody is at work: isoscope-run tiles step goes on.", true);
}

void mosaic_states(Ui& ui, const TileProgress& p) {
  for (const TileState state : by_progress) {
    widgets::Row row(ui, 22);
    const bool any = p.count(state) > 0;
    const StateMark mark = state_mark(ui, state);
    row.glyph(8, any ? mark.color : ui.colors.line, mark.shape, 5);
    row.text(ui.fonts.ui, 24, any ? ui.colors.text : ui.colors.quiet, name(state));
    row.value(any ? ui.colors.text : ui.colors.quiet, grouped(p.count(state)));
    row.item();
  }
}

void mosaic_look_rows(Ui& ui, Mosaic& m, const TileMosaic& mosaic) {
  int chosen = static_cast<int>(m.look);
  if (widgets::segmented(ui, "look", mosaic_looks, chosen))
    ui.commands.post("tiles-look", {std::string(name(static_cast<MosaicLook>(chosen)))});
  ImGui::Dummy({0, ui.px(2)});
  widgets::value_row(ui, "Facets of Z", grouped(mosaic.facet_count));
  if (mosaic.facets.empty()) {
    widgets::quiet_text(ui, "Too many to be drawn: bricks stand for them.", true);
    return;
  }
  const ImVec2 at = ImGui::GetCursorPos();
  widgets::toggle(ui, "frozen", m.mark_frozen);
  ImGui::SetCursorPos({at.x + ui.px(36), at.y});
  widgets::Row row(ui, 20);
  row.glyph(8, to_rgb(frozen_color(scene_colors(ui.theme))), MarkerShape::disc, 3.5f);
  row.text(ui.fonts.small, 20, ui.colors.quiet, "Frozen vertices");
  row.value(ui.colors.text, grouped(mosaic.frozen.size()));
  row.item();
}

std::string row_value(const TileReport& report) {
  if (report.seconds <= 0) return {};
  const double s = report.seconds;
  return s < 600 ? general(s, s < 1 ? 2 : 3) + " s" : general(s / 60, 3) + " min";
}

void mosaic_row(Ui& ui, Mosaic& m, const TileProgress& p, std::size_t i) {
  widgets::Row line(ui, 24);
  const TileReport& report = p.tiles[i];
  const bool pressed = line.button(i);
  const auto tile = static_cast<std::uint32_t>(i);
  if (line.hovered()) m.hovered = tile;
  if (m.hovered == tile) line.ground(ui.colors.hover, 1, 4);
  if (line.hovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const StateMark mark = state_mark(ui, report.state);
  line.glyph(8, mark.color, mark.shape, 4.5f);
  line.text(ui.fonts.ui, 24, ui.colors.text, "Tile " + std::to_string(i));
  line.text(ui.fonts.small, 92, ui.colors.quiet, counted(p.round.tiles[i].facets, "facet"));
  line.value(ui.colors.quiet, row_value(report));
  std::string more = report.words.empty() ? report.who : report.words;
  widgets::tip(ui, "Tile " + std::to_string(i) + ", " + std::string(name(report.state)),
               more + (more.empty() ? "" : "\n") + "A click makes it once more, to be stepped through.");
  if (pressed) ui.commands.post("rerun-tile", {std::to_string(i)});
}

} // namespace

void mosaic(Ui& ui, Mosaic& m) {
  const auto news = m.news();
  const TileProgress* p = news ? &news->progress : nullptr;
  mosaic_head(ui, m, p);
  if (p == nullptr || p->round.number == 0) return;
  ImGui::Dummy({0, ui.px(4)});
  mosaic_states(ui, *p);
  ImGui::Dummy({0, ui.px(6)});
  if (news->mosaic) mosaic_look_rows(ui, m, *news->mosaic);
  ImGui::Dummy({0, ui.px(4)});
  widgets::subtitle(ui, "Tiles, heaviest first");
  if (ImGui::BeginChild("tiles", {0, 0}))
    widgets::rows_in_sight(p->tiles.size(), ui.px(24), [&](std::size_t i) { mosaic_row(ui, m, *p, i); });
  ImGui::EndChild();
}

} // namespace isoscope::panels
