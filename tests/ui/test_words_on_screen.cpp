// Words that are read from the glyphs of a frame: lines, clipped ones, those of several fonts.
#include "ui/words_on_screen.h"

#include "ui/theme.h"

#include <doctest/doctest.h>

#include <functional>

using namespace isoscope;

namespace {

/// What can be read of a frame of 400 by 300 pixels in which `draw` draws a window.
std::vector<SeenWords> read_frame(const std::function<void(const Fonts&)>& draw) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {400, 300};
  io.DeltaTime = 0.02f;
  const auto fonts = load_fonts(*io.Fonts, 1);
  REQUIRE(fonts.ok());
  io.FontDefault = fonts->ui;
  // The atlas' texture is one of its own, as in the window; any name will do.
  io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(1));
  std::vector<SeenWords> seen;
  for (int frame = 0; frame < 3; ++frame) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({20, 20});
    ImGui::SetNextWindowSize({200, 120});
    ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration);
    draw(*fonts);
    ImGui::End();
    ImGui::Render();
    seen = words_on_screen(*ImGui::GetDrawData(), *io.Fonts);
  }
  ImGui::DestroyContext();
  return seen;
}

} // namespace

TEST_CASE("lines are read as they were drawn, with their places and whose they are") {
  const auto seen = read_frame([](const Fonts& fonts) {
    ImGui::TextUnformatted("δ is 0.98 of δ′");
    ImGui::PushFont(fonts.mono);
    ImGui::TextUnformatted("1,024");
    ImGui::PopFont();
    ImGui::GetWindowDrawList()->AddRectFilled({30, 100}, {60, 120}, 0xffffffff, 4);
    ImGui::GetWindowDrawList()->AddLine({30, 100}, {60, 120}, 0xffffffff, 2);
  });
  REQUIRE(seen.size() == 2);
  CHECK(seen[0].text == "δ is 0.98 of δ′");
  CHECK(seen[0].surface == "pane");
  CHECK(!seen[0].cut);
  CHECK(seen[0].low.x > 20);
  CHECK(seen[0].high.x < 220);
  CHECK(seen[1].text == "1,024");
  CHECK(seen[1].low.y > seen[0].high.y);
  CHECK(can_be_read(seen, "0.98 of δ"));
  CHECK(can_be_read(seen, "of δ′ 1,024")); // over lines
  CHECK(!can_be_read(seen, "0.99"));
}

TEST_CASE("what its pane cuts off is not read, and said to be cut") {
  const auto seen = read_frame([](const Fonts&) {
    ImGui::SetCursorPosX(120);
    ImGui::TextUnformatted("beyond the end of the pane");
    ImGui::SetCursorPosY(500);
    ImGui::TextUnformatted("far below");
  });
  REQUIRE(seen.size() == 1);
  CHECK(seen[0].cut);
  CHECK(seen[0].text.starts_with("beyond"));
  CHECK(!can_be_read(seen, "of the pane"));
  CHECK(!can_be_read(seen, "far below"));
}

TEST_CASE("words that stand alone are found before those among others, and what is in front before all") {
  const auto piece = [](const char* text, float at) {
    return SeenWords{text, {at, 0}, {at + 1, 1}, false, "pane"};
  };
  const std::vector<SeenWords> seen{piece("four", 0), piece("four half-spaces", 1), piece("five", 2),
                                    piece("five", 3)};
  CHECK(find_words(seen, "four")->low.x == 0);
  CHECK(find_words(seen, "half")->low.x == 1);
  CHECK(find_words(seen, "five")->low.x == 3);
  CHECK(find_words(seen, "six") == nullptr);
}
