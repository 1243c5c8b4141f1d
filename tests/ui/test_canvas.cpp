// Small drawings on a picture.
#include "ui/canvas.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

using namespace isoscope;

namespace {

using Pixel = std::array<int, 4>;

Pixel pixel(const Image& image, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2], image.pixels[at + 3]};
}

} // namespace

TEST_CASE("shapes and text are drawn onto a picture, smooth and clipped to it") {
  ImFontAtlas atlas;
  const auto fonts = load_fonts(atlas, 1);
  REQUIRE(fonts.ok());
  Image image{64, 32, std::vector<std::uint8_t>(64 * 32 * 4, 0)};
  ImageCanvas canvas(image, atlas, *fonts->small);
  canvas.rect({2, 2}, {10, 10}, 0x102030, 1);
  CHECK(pixel(image, 5, 5) == Pixel{0x10, 0x20, 0x30, 255});
  CHECK(pixel(image, 20, 20)[3] == 0); // nothing there, not even a ground
  canvas.rect({5, 5}, {8, 8}, 0xF0F0F0, 0.5f);
  CHECK(pixel(image, 6, 6)[0] == doctest::Approx(0x80).epsilon(0.05));
  CHECK(pixel(image, 6, 6)[3] == 255);
  canvas.disc({20, 20}, 4, 0xFF0000);
  CHECK(pixel(image, 20, 20)[0] == 255);
  CHECK(pixel(image, 26, 20)[3] == 0);
  canvas.ring({40, 16}, 6, 0x00FF00, 2);
  CHECK(pixel(image, 40, 16)[3] == 0);
  CHECK(pixel(image, 46, 16)[3] > 100);
  canvas.line({-10, 31}, {100, 31}, 0x0000FF, 1);
  CHECK(pixel(image, 63, 31)[2] == 255);
  canvas.disc({500, 500}, 4, 0xFF0000); // outside: nothing happens
  const float width = canvas.text_width("δ = 1");
  CHECK(width > 15);
  Image words{80, 20, std::vector<std::uint8_t>(80 * 20 * 4, 255)};
  ImageCanvas page(words, atlas, *fonts->small);
  page.text({4, 2}, "δ = 1", 0x000000);
  int dark = 0, beyond = 0;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 80; ++x) {
      const bool ink = pixel(words, x, y)[0] < 128;
      dark += ink ? 1 : 0;
      beyond += ink && static_cast<float>(x) > 5 + width ? 1 : 0;
    }
  CHECK(dark > 20);
  CHECK(beyond == 0);
}
