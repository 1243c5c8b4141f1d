// A box of rows; the bar with its ends and its limit comes first.
#include "view/scene_key.h"

#include "model/words.h"
#include "scene/map_colors.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr float pad = 9, row = 19, sign = 20, bar = 150, bar_high = 8; ///< units of the interface

Rgb rgb_of(glm::vec3 color) {
  const auto byte = [](float c) { return static_cast<Rgb>(std::lround(255 * std::clamp(c, 0.0f, 1.0f))); };
  return byte(color.r) << 16 | byte(color.g) << 8 | byte(color.b);
}

std::string number(const ZeroMap& map, float value) {
  const bool whole = map.kind == ZeroMapKind::valence || map.kind == ZeroMapKind::age;
  return whole ? grouped(static_cast<std::size_t>(std::max(std::lround(value), 0l)))
               : short_number(static_cast<double>(value));
}

float bar_rows(const SceneKey& key) {
  return key.map ? 3.0f : key.note.empty() ? 0.0f : 1.0f;
}

/// How many entries fit.
std::size_t fitting(const SceneKey& key, float unit, float most_high) {
  const float room = most_high / unit - 2 * pad - bar_rows(key) * row;
  const auto rows = static_cast<std::size_t>(std::max(room / row, 0.0f));
  return rows >= key.entries.size() ? key.entries.size() : rows > 0 ? rows - 1 : 0;
}

std::string more_words(const SceneKey& key, std::size_t shown) {
  if (shown >= key.entries.size()) return {};
  const std::string left_out = grouped(key.entries.size() - shown);
  return shown > 0 || key.map ? "and " + left_out + " more" : "legend of " + left_out + " entries";
}

std::string range_words(const ZeroMap& map) {
  return "mean " + number(map, map.mean) + ", largest " + number(map, map.largest);
}

void draw_sign(Canvas& canvas, const LegendEntry& entry, ImVec2 middle, float unit) {
  using Sign = LegendEntry::Sign;
  const float r = 5 * unit, thin = 1.6f * unit;
  const Rgb color = rgb_of(entry.color);
  const auto at = [&](float x, float y) { return ImVec2{middle.x + x * r, middle.y + y * r}; };
  switch (entry.sign) {
  case Sign::surface:
    canvas.rect(at(-1, -1), at(1, 1), color);
    break;
  case Sign::line:
    canvas.line(at(-1.4f, 0), at(1.4f, 0), color, thin);
    break;
  case Sign::dashed:
    canvas.line(at(-1.4f, 0), at(-0.4f, 0), color, thin);
    canvas.line(at(0.4f, 0), at(1.4f, 0), color, thin);
    break;
  case Sign::disc:
    canvas.disc(middle, 0.85f * r, color);
    break;
  case Sign::ring:
    canvas.ring(middle, 0.75f * r, color, thin);
    break;
  case Sign::cross:
    canvas.line(at(-0.9f, -0.9f), at(0.9f, 0.9f), color, thin);
    canvas.line(at(-0.9f, 0.9f), at(0.9f, -0.9f), color, thin);
    break;
  case Sign::square:
    for (const float side : {-0.9f, 0.9f}) {
      canvas.line(at(side, -0.9f), at(side, 0.9f), color, thin);
      canvas.line(at(-0.9f, side), at(0.9f, side), color, thin);
    }
    break;
  case Sign::diamond:
  case Sign::cell: {
    const std::array<ImVec2, 4> diamond{at(0, -1), at(1, 0), at(0, 1), at(-1, 0)};
    const std::array<ImVec2, 3> triangle{at(0, -1), at(1, 0.8f), at(-1, 0.8f)};
    const std::span<const ImVec2> corners =
        entry.sign == Sign::cell ? std::span<const ImVec2>(triangle) : std::span<const ImVec2>(diamond);
    for (std::size_t i = 0; i < corners.size(); ++i)
      canvas.line(corners[i], corners[(i + 1) % corners.size()], color, thin);
    break;
  }
  }
}

void draw_bar(Canvas& canvas, const ZeroMap& map, const std::string& title, ImVec2 low, float width,
              float unit, const Palette& colors) {
  canvas.text(low, title, colors.text);
  const float y = low.y + row * unit + 2 * unit, length = width;
  constexpr int parts = 64;
  for (int i = 0; i < parts; ++i) {
    const float from = static_cast<float>(i) / parts, to = static_cast<float>(i + 1) / parts;
    canvas.rect({low.x + from * length, y}, {low.x + to * length, y + bar_high * unit},
                rgb_of(map_color(0.5f * (from + to))));
  }
  if (map.limit && *map.limit < map.high) {
    const float x = low.x + map_part(map, *map.limit) * length;
    canvas.line({x, y - 3 * unit}, {x, y + (bar_high + 3) * unit}, colors.bad_text, 1.6f * unit);
  }
  const float below = y + (bar_high + 2) * unit;
  const std::string high = number(map, map.high), middle = range_words(map);
  canvas.text({low.x, below}, number(map, map.low), colors.quiet);
  canvas.text({low.x + length - canvas.text_width(high), below}, high, colors.quiet);
  canvas.text({low.x + (length - canvas.text_width(middle)) / 2, below}, middle, colors.quiet);
}

} // namespace

const std::vector<LegendEntry>& KeptLegend::of(const std::shared_ptr<const StateSnapshot>& state,
                                               const ViewSettings& view, const LegendScene& scene) {
  if (state_.lock() == state && view_ == view && scene_ == scene) return entries_;
  entries_ = scene_legend(*state, view, view.mode == ViewMode::section, scene);
  state_ = state;
  view_ = view;
  scene_ = scene;
  return entries_;
}

SceneKey scene_key(const WindowState& window, const ZeroMaps& maps, const ViewSettings& view,
                   const std::shared_ptr<const EdgeXray>& xray, KeptLegend& legend) {
  SceneKey key;
  const auto state = window.state();
  if (!state) return key;
  const bool section = view.mode == ViewMode::section;
  if (view.zero_map != ZeroMapKind::none && view.zero_set.shown() && !section) {
    const ZeroMapWords& w = words(view.zero_map);
    key.map = maps.map();
    if (key.map && key.map->kind != view.zero_map) key.map = nullptr;
    key.title = "Z by " + std::string(w.title) +
                (w.unit.empty() || w.unit == "δ" || w.unit == "edges" ? "" : ", " + std::string(w.unit));
    if (maps.makes_no_sense()) key.note = "nothing to colour Z by: the input is no surface";
  }
  const bool points = window.run.scene && window.run.scene->points;
  if (view.legend) key.entries = legend.of(state, view, {window.rim() != nullptr, points, xray});
  return key;
}

ImVec2 key_size(const Canvas& canvas, const SceneKey& key, float unit, float most_high) {
  float width = key.map ? bar * unit : 0;
  if (key.map) {
    const float ends = canvas.text_width(number(*key.map, key.map->low)) +
                       canvas.text_width(number(*key.map, key.map->high));
    width = std::max(width, canvas.text_width(range_words(*key.map)) + ends + 20 * unit);
    width = std::max(width, canvas.text_width(key.title));
  }
  width = std::max(width, canvas.text_width(key.note));
  const std::size_t shown = fitting(key, unit, most_high);
  for (std::size_t i = 0; i < shown; ++i)
    width = std::max(width, sign * unit + canvas.text_width(key.entries[i].words));
  width = std::max(width, canvas.text_width(more_words(key, shown)));
  const float more = shown < key.entries.size() ? 1.0f : 0.0f;
  return {width + 2 * pad * unit,
          (2 * pad + (bar_rows(key) + static_cast<float>(shown) + more) * row) * unit};
}

void draw_key(Canvas& canvas, const SceneKey& key, ImVec2 low, float unit, float most_high,
              const Palette& colors) {
  const ImVec2 size = key_size(canvas, key, unit, most_high);
  canvas.rect(low, {low.x + size.x, low.y + size.y}, colors.panel, 0.88f);
  const ImVec2 at{low.x + pad * unit, low.y + pad * unit};
  if (key.map)
    draw_bar(canvas, *key.map, key.title, at, size.x - 2 * pad * unit, unit, colors);
  else if (!key.note.empty())
    canvas.text(at, key.note, colors.quiet);
  float y = at.y + bar_rows(key) * row * unit;
  const std::size_t shown = fitting(key, unit, most_high);
  for (std::size_t i = 0; i < shown; ++i) {
    draw_sign(canvas, key.entries[i], {at.x + 7 * unit, y + canvas.text_height() / 2}, unit);
    canvas.text({at.x + sign * unit, y}, key.entries[i].words, colors.text);
    y += row * unit;
  }
  if (shown < key.entries.size()) canvas.text({at.x, y}, more_words(key, shown), colors.quiet);
}

namespace overlay {

void key(const Ui& ui, const SceneKey& key, ImVec2 low, ImVec2 size) {
  if (key.empty()) return;
  WindowCanvas canvas(*ui.fonts.small);
  // In a split view what both halves show is in their middle.
  const bool split = ui.window.view.mode == ViewMode::split;
  const float room = (split ? 0.5f * size.y : size.y) - ui.px(split ? 80 : 100);
  const ImVec2 extent = key_size(canvas, key, ui.scale, room);
  if (extent.x > size.x - ui.px(24) || extent.y > room) return;
  draw_key(canvas, key, {low.x + size.x - extent.x - ui.px(10), low.y + size.y - extent.y - ui.px(50)},
           ui.scale, room, ui.colors);
}

} // namespace overlay

} // namespace isoscope
