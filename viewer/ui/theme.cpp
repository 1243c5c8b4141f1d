// Colours, style and fonts.
#include "ui/theme.h"

#include "embedded/fonts.h"
#include "scene/meanings.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace isoscope {
namespace {

constexpr Palette dark{.ground = 0x14161A,
                       .panel = 0x1B1E24,
                       .raised = 0x232730,
                       .hover = 0x2D323D,
                       .line = 0x2E3440,
                       .text = 0xE6E9EF,
                       .quiet = 0x8F98A8,
                       .accent = 0x56B4E9,
                       .good = meaning_color::good,
                       .bad = meaning_color::bad,
                       .warning = meaning_color::warning,
                       .gamma = meaning_color::gamma,
                       .other_zero = meaning_color::other_zero,
                       .zero = 0xF2F2F2,
                       .outer = meaning_color::outer,
                       .inner = meaning_color::inner,
                       .misoriented = meaning_color::misoriented,
                       .kernel = meaning_color::kernel,
                       .rim = 0xE69F00,
                       .selection = 0xF0E442,
                       .good_text = 0x2FC598,
                       .bad_text = 0xFF8A3D,
                       .warning_text = 0xF0B429,
                       .accent_text = 0x6CC0F0,
                       .on_accent = 0x0B1116};
constexpr Palette light{.ground = 0xE9ECF1,
                        .panel = 0xF7F8FA,
                        .raised = 0xFFFFFF,
                        .hover = 0xE4E9F0,
                        .line = 0xCDD3DC,
                        .text = 0x1B1F26,
                        .quiet = 0x596273,
                        .accent = 0x1A77AE,
                        .good = meaning_color::good,
                        .bad = meaning_color::bad,
                        .warning = meaning_color::warning,
                        .gamma = meaning_color::gamma,
                        .other_zero = meaning_color::other_zero,
                        .zero = 0x101216,
                        .outer = meaning_color::outer,
                        .inner = meaning_color::inner,
                        .misoriented = meaning_color::misoriented,
                        .kernel = meaning_color::kernel,
                        .rim = 0xB36B00,
                        .selection = 0xB59A00,
                        .good_text = 0x00694C,
                        .bad_text = 0xA84600,
                        .warning_text = 0x7A5400,
                        .accent_text = 0x00629A,
                        .on_accent = 0xFFFFFF};
/// The light one without its tints.
constexpr Palette paper = [] {
  Palette p = light;
  p.ground = 0xF4F4F4;
  p.panel = 0xFFFFFF;
  p.raised = 0xF7F7F7;
  p.hover = 0xEAEAEA;
  p.line = 0xC8C8C8;
  p.text = p.zero = 0x000000;
  p.quiet = 0x555555;
  return p;
}();

double luminance(Rgb color) {
  const auto linear = [](Rgb channel) {
    const double c = static_cast<double>(channel & 0xFF) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color >> 16) + 0.7152 * linear(color >> 8) + 0.0722 * linear(color);
}

// Latin, Greek, punctuation, super- and subscripts, arrows, mathematics, geometric shapes.
constexpr std::array<ImWchar, 17> text_ranges{0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2033,
                                              0x2070, 0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF,
                                              0x2318, 0x2328, 0x25A0, 0x25FF, 0};
constexpr std::array<ImWchar, 3> icon_ranges{0xF000, 0xF2E0, 0};
// ∩, which the font of words does not have.
constexpr std::array<ImWchar, 3> missing_ranges{0x2229, 0x2229, 0};

ImFont* add_font(ImFontAtlas& atlas, const char* role, float size, const ImWchar* ranges, bool merge,
                 float offset) {
  const EmbeddedFile* file = find_embedded(embedded::fonts(), role);
  if (file == nullptr) return nullptr;
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.MergeMode = merge;
  config.PixelSnapH = true;
  config.GlyphOffset.y = offset;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  // The atlas only reads the bytes, but asks for them as writable.
  void* bytes = const_cast<std::byte*>(file->bytes.data());
  return atlas.AddFontFromMemoryTTF(bytes, static_cast<int>(file->bytes.size()), size, &config, ranges);
}

ImFont* add_words(ImFontAtlas& atlas, const char* role, float size) {
  ImFont* font = add_font(atlas, role, size, text_ranges.data(), false, 0);
  if (font == nullptr) return nullptr;
  return add_font(atlas, "mono", size, missing_ranges.data(), true, 0) ? font : nullptr;
}

ImFont* add_with_icons(ImFontAtlas& atlas, const char* role, float size) {
  ImFont* font = add_words(atlas, role, size);
  if (font == nullptr) return nullptr;
  return add_font(atlas, "icons", size * 0.95f, icon_ranges.data(), true, std::round(size * 0.04f)) ? font
                                                                                                    : nullptr;
}

} // namespace

const Palette& palette(ThemeKind theme) {
  switch (theme) {
  case ThemeKind::light:
    return light;
  case ThemeKind::paper:
    return paper;
  case ThemeKind::dark:
    break;
  }
  return dark;
}

double contrast(Rgb a, Rgb b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

ImVec4 to_vec(Rgb color, float alpha) {
  const auto channel = [&](int shift) { return static_cast<float>((color >> shift) & 0xFF) / 255.0f; };
  return {channel(16), channel(8), channel(0), alpha};
}
ImU32 to_u32(Rgb color, float alpha) {
  return ImGui::ColorConvertFloat4ToU32(to_vec(color, alpha));
}

Rgb condition_color(ThemeKind theme, int condition) {
  const Palette& c = palette(theme);
  const std::array<Rgb, 7> colors{c.quiet, c.bad, c.warning, c.misoriented, c.gamma, c.accent, c.good};
  return colors.at(static_cast<std::size_t>(std::clamp(condition, 0, 6)));
}

Rgb stage_color(ThemeKind theme, Stage stage) {
  const Palette& c = palette(theme);
  const std::array<Rgb, stage_count> colors{c.quiet, c.accent, 0x3D8FD1, 0xA0679E,
                                            c.good,  0x7FA83C, 0xD9A02B, 0x44AA99};
  return colors.at(static_cast<std::size_t>(stage));
}

Result<Fonts> load_fonts(ImFontAtlas& atlas, float scale) {
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.TexGlyphPadding = 1;
  const auto size = [&](float px) { return std::round(px * scale); };
  Fonts fonts;
  fonts.ui = add_with_icons(atlas, "ui", size(15));
  fonts.bold = add_with_icons(atlas, "ui-bold", size(15));
  fonts.small = add_with_icons(atlas, "ui", size(13));
  fonts.title = add_words(atlas, "ui-bold", size(22));
  fonts.mono = add_font(atlas, "mono", size(13.5f), text_ranges.data(), false, 0);
  fonts.reading = add_words(atlas, "ui", size(18));
  fonts.reading_bold = add_words(atlas, "ui-bold", size(18));
  const std::array all{fonts.ui,   fonts.bold,    fonts.small,       fonts.title,
                       fonts.mono, fonts.reading, fonts.reading_bold};
  if (std::find(all.begin(), all.end(), nullptr) != all.end() || !atlas.Build())
    return Error{
        ErrorCode::device, "The user interface's fonts cannot be loaded.",
        "Build again with fonts-inter, fonts-jetbrains-mono and fonts-font-awesome installed (scripts/run)."};
  return fonts;
}

void apply_style(ImGuiStyle& style, ThemeKind theme, float scale) {
  const Palette& c = palette(theme);
  style = ImGuiStyle();
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 3};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 10;
  style.WindowRounding = 0;
  style.ChildRounding = 6;
  style.FrameRounding = 5;
  style.PopupRounding = 7;
  style.ScrollbarRounding = 5;
  style.GrabRounding = 5;
  style.TabRounding = 5;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = 1;
  style.AntiAliasedLines = style.AntiAliasedFill = true;

  const auto set = [&](ImGuiCol slot, Rgb color, float alpha = 1.0f) {
    style.Colors[slot] = to_vec(color, alpha);
  };
  for (int i = 0; i < ImGuiCol_COUNT; ++i) set(i, c.line);
  set(ImGuiCol_Text, c.text);
  set(ImGuiCol_TextDisabled, c.quiet);
  set(ImGuiCol_WindowBg, c.panel);
  set(ImGuiCol_ChildBg, c.panel, 0);
  set(ImGuiCol_PopupBg, c.raised);
  set(ImGuiCol_Border, c.line);
  set(ImGuiCol_BorderShadow, c.ground, 0);
  set(ImGuiCol_FrameBg, theme == ThemeKind::dark ? c.raised : c.hover);
  set(ImGuiCol_FrameBgHovered, c.hover);
  set(ImGuiCol_FrameBgActive, c.line);
  set(ImGuiCol_MenuBarBg, c.panel);
  set(ImGuiCol_ScrollbarBg, c.panel, 0);
  set(ImGuiCol_ScrollbarGrab, c.line);
  set(ImGuiCol_ScrollbarGrabHovered, c.quiet, 0.6f);
  set(ImGuiCol_ScrollbarGrabActive, c.quiet);
  set(ImGuiCol_CheckMark, c.accent);
  set(ImGuiCol_SliderGrab, c.accent);
  set(ImGuiCol_SliderGrabActive, c.accent_text);
  set(ImGuiCol_Button, theme == ThemeKind::dark ? c.raised : c.hover);
  set(ImGuiCol_ButtonHovered, c.hover);
  set(ImGuiCol_ButtonActive, c.line);
  set(ImGuiCol_Header, c.accent, 0.16f);
  set(ImGuiCol_HeaderHovered, c.accent, 0.22f);
  set(ImGuiCol_HeaderActive, c.accent, 0.30f);
  set(ImGuiCol_Separator, c.line);
  set(ImGuiCol_TextSelectedBg, c.accent, 0.35f);
  set(ImGuiCol_NavHighlight, c.accent, 0.0f);
  set(ImGuiCol_TableRowBg, c.panel, 0);
  set(ImGuiCol_TableRowBgAlt, c.text, 0.02f);
  set(ImGuiCol_TableHeaderBg, c.panel);
  set(ImGuiCol_ModalWindowDimBg, c.ground, 0.6f);
}

} // namespace isoscope
