// Text is readable on every ground of every theme, and meanings keep their colours.
#include "ui/theme.h"

#include <doctest/doctest.h>

using namespace isoscope;

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

TEST_CASE("the embedded fonts load at several scales") {
  for (const float scale : {1.0f, 2.0f}) {
    ImFontAtlas atlas;
    const auto fonts = load_fonts(atlas, scale);
    REQUIRE(fonts.ok());
    CHECK(fonts->ui->FontSize == doctest::Approx(15 * scale));
    for (const ImWchar letter :
         {ImWchar(0x03B1), ImWchar(0x03A9), ImWchar(0x2202), ImWchar(0x2264), ImWchar(0xF04B)})
      CHECK(fonts->ui->FindGlyphNoFallback(letter) != nullptr);
    for (const ImWchar letter : {ImWchar(0x03B4), ImWchar('0')})
      CHECK(fonts->mono->FindGlyphNoFallback(letter) != nullptr);
  }
}
