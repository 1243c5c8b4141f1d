// Text is readable on every ground of every theme, and meanings keep their colours.
#include "ui/theme.h"

#include "journal/vocabulary.h"
#include "model/words.h"
#include "scene/meanings.h"
#include "scene/octree_fates.h"
#include "scene/palette.h"

#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace isoscope;

namespace {

/// How far apart two colours look: their distance in Oklab, where black and white are 1 apart.
double difference(Rgb a, Rgb b) {
  const auto lab = [](Rgb color) {
    std::array<double, 3> c{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double v = static_cast<double>((color >> (16 - 8 * i)) & 0xFF) / 255;
      c[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const double l = std::cbrt(0.4122214708 * c[0] + 0.5363325363 * c[1] + 0.0514459929 * c[2]),
                 m = std::cbrt(0.2119034982 * c[0] + 0.6806995451 * c[1] + 0.1073969566 * c[2]),
                 s = std::cbrt(0.0883024619 * c[0] + 0.2817188376 * c[1] + 0.6299787005 * c[2]);
    return std::array{0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
                      1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                      0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
  };
  const auto p = lab(a), q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

} // namespace

TEST_CASE("contrast of text is at least 4.5 to 1") {
  for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::paper}) {
    const Palette& c = palette(theme);
    CAPTURE(static_cast<int>(theme));
    for (const Rgb ground : {c.ground, c.panel, c.raised})
      for (const Rgb ink : {c.text, c.quiet, c.good_text, c.bad_text, c.warning_text, c.accent_text}) {
        CAPTURE(ground);
        CAPTURE(ink);
        CHECK(contrast(ink, ground) >= 4.5);
      }
    CHECK(contrast(c.text, c.hover) >= 4.5);
    CHECK(contrast(c.on_accent, c.accent) >= 4.5);
  }
}

TEST_CASE("contrast has its known extremes") {
  CHECK(contrast(0x000000, 0xFFFFFF) == doctest::Approx(21));
  CHECK(contrast(0x808080, 0x808080) == doctest::Approx(1));
  CHECK(contrast(0x123456, 0xFEDCBA) == doctest::Approx(contrast(0xFEDCBA, 0x123456)));
}

TEST_CASE("meanings have the same colours everywhere") {
  for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::paper}) {
    const Palette& c = palette(theme);
    CHECK(c.good == 0x009E73);
    CHECK(c.bad == 0xD55E00);
    CHECK(c.warning == 0xE69F00);
    CHECK(c.gamma == 0x0072B2);
  }
}

TEST_CASE("every two meanings are told apart") {
  CHECK(difference(0x000000, 0xFFFFFF) == doctest::Approx(1).epsilon(0.01));
  for (std::size_t i = 0; i < meanings.size(); ++i)
    for (std::size_t j = i + 1; j < meanings.size(); ++j) {
      CAPTURE(std::string(meanings[i].name));
      CAPTURE(std::string(meanings[j].name));
      CHECK(difference(meanings[i].color, meanings[j].color) > 0.035);
    }
}

TEST_CASE("misoriented tetrahedra, condition 3 and their layer have one colour, and nothing else has it") {
  constexpr int orientation = static_cast<int>(Condition::orientation);
  for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::paper}) {
    const Palette& c = palette(theme);
    const SceneColors scene = scene_colors(theme);
    CHECK(condition_color(theme, orientation) == meaning_color::misoriented);
    CHECK(c.misoriented == meaning_color::misoriented);
    CHECK(scene.misoriented == rgb(meaning_color::misoriented));
    CHECK(scene.good == rgb(c.good));
    CHECK(scene.bad == rgb(c.bad));
    CHECK(scene.outer == rgb(c.outer));
    CHECK(scene.inner == rgb(c.inner));
    std::vector<Rgb> others{c.quiet, c.accent, c.good, c.bad,    c.warning,  c.gamma,
                            c.outer, c.inner,  c.rim,  c.kernel, c.selection};
    for (int i = 0; i < condition_count; ++i)
      if (i != orientation) others.push_back(condition_color(theme, i));
    for (const Stage stage : stages_in_order) others.push_back(stage_color(theme, stage));
    for (const ReasonWords& reason : reason_table) others.push_back(reason.color);
    for (const KindWords& kind : kind_table) others.push_back(kind.color);
    for (std::size_t i = 0; i < fate_count; ++i)
      others.push_back(fate_style(static_cast<OctreeCell::Fate>(i)).color);
    for (const Rgb other : others) {
      CAPTURE(other);
      CHECK(difference(meaning_color::misoriented, other) > 0.1);
    }
  }
}

TEST_CASE("tetrahedra outside and inside of Z are not coloured like Ω") {
  for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::paper}) {
    const SceneColors c = scene_colors(theme);
    for (const int label : {1, -1}) {
      CHECK(side_color(label, false, c) != c.outer);
      CHECK(side_color(label, false, c) != c.inner);
    }
    CHECK(side_color(1, true, c) == side_color(1, false, c));
    CHECK(side_color(-2, true, c) == room_style(-2).color);
  }
}

TEST_CASE("the embedded fonts load at several scales") {
  for (const float scale : {1.0f, 2.0f}) {
    ImFontAtlas atlas;
    const auto fonts = load_fonts(atlas, scale);
    REQUIRE(fonts.ok());
    CHECK(fonts->ui->FontSize == doctest::Approx(15 * scale));
    for (const ImWchar letter :
         {ImWchar(0x03B1), ImWchar(0x03A9), ImWchar(0x2202), ImWchar(0x2264), ImWchar(0xF04B)})
      CHECK(fonts->ui->FindGlyphNoFallback(letter) != nullptr);
    // Whatever a reason or a layer is told by is told whole, in words and in lessons.
    std::string told;
    for (const ReasonWords& r : reason_table) told += std::string(r.title) + std::string(r.help);
    for (const LayerName& layer : layer_names()) told += std::string(layer.title) + std::string(layer.tip);
    for (const ImFont* font : {fonts->ui, fonts->bold, fonts->small, fonts->reading})
      for (const char* at = told.data(); at < told.data() + told.size();) {
        unsigned letter = 0;
        at += ImTextCharFromUtf8(&letter, at, told.data() + told.size());
        CAPTURE(letter);
        CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr);
      }
    for (const ImWchar letter : {ImWchar(0x03B4), ImWchar('0')})
      CHECK(fonts->mono->FindGlyphNoFallback(letter) != nullptr);
  }
}
