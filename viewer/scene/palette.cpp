// The scene's colours: meaning is the same in every theme, grounds and lines follow it.
#include "scene/palette.h"

#include "scene/meanings.h"

#include <array>

namespace isoscope {

SceneColors scene_colors(ThemeKind theme) {
  SceneColors c;
  c.good = rgb(meaning_color::good);
  c.bad = rgb(meaning_color::bad);
  c.warning = rgb(meaning_color::warning);
  c.misoriented = rgb(meaning_color::misoriented);
  c.gamma = rgb(meaning_color::gamma);
  c.other_zero = rgb(meaning_color::other_zero);
  c.outer = rgb(meaning_color::outer);
  c.inner = rgb(meaning_color::inner);
  c.selection = rgb(0xF0E442);
  c.accent = rgb(0x56B4E9);
  switch (theme) {
  case ThemeKind::dark:
    c.ground_top = rgb(0x242932);
    c.ground_bottom = rgb(0x14161A);
    c.zero_set = rgb(0xF2F2F2);
    c.zero_set_edge = rgb(0x20242B);
    c.input = rgb(0xA7B0BF);
    c.input_edge = rgb(0x343B47);
    c.dropped = rgb(0xD98A6A);
    c.rim = rgb(0xE69F00);
    c.tetrahedron = rgb(0x9FB0C8);
    c.tetrahedron_edge = rgb(0xC4CEDD);
    c.outside_cells = rgb(0x66707F);
    c.inside_cells = rgb(0xB8A678);
    c.section_line = rgb(0x4A5362);
    c.section_zero = rgb(0xF2F2F2);
    break;
  case ThemeKind::light:
    c.ground_top = rgb(0xFBFCFD);
    c.ground_bottom = rgb(0xDDE2E9);
    c.zero_set = rgb(0xF2F2F2);
    c.zero_set_edge = rgb(0x2B3038);
    c.input = rgb(0xC9D0DA);
    c.input_edge = rgb(0x7B8594);
    c.dropped = rgb(0xB0421A);
    c.rim = rgb(0xB36B00);
    c.tetrahedron = rgb(0x6E7F99);
    c.tetrahedron_edge = rgb(0x4D5A6D);
    c.outside_cells = rgb(0x9AA3B0);
    c.inside_cells = rgb(0xB59B55);
    c.section_line = rgb(0xB4BCC8);
    c.section_zero = rgb(0x101216);
    c.selection = rgb(0xB59A00);
    c.accent = rgb(0x1F7FB8);
    break;
  case ThemeKind::paper:
    c.ground_top = c.ground_bottom = rgb(0xFFFFFF);
    c.zero_set = rgb(0xF2F2F2);
    c.zero_set_edge = rgb(0x000000);
    c.input = rgb(0xD4D8DE);
    c.input_edge = rgb(0x8A8F98);
    c.dropped = rgb(0xB0421A);
    c.rim = rgb(0xB36B00);
    c.tetrahedron = rgb(0x8290A6);
    c.tetrahedron_edge = rgb(0x596577);
    c.outside_cells = rgb(0xB0B0B0);
    c.inside_cells = rgb(0xB59B55);
    c.section_line = rgb(0xBDBDBD);
    c.section_zero = rgb(0x000000);
    c.selection = rgb(0xB59A00);
    c.accent = rgb(0x1F7FB8);
    break;
  }
  return c;
}

glm::vec3 side_color(int label, bool rooms, const SceneColors& colors) {
  if (label > 0) return colors.outside_cells;
  return rooms ? room_style(label).color : colors.inside_cells;
}

RoomStyle room_style(int label) {
  if (label > 0) return {rgb(meaning_color::outer), Hatch::none};
  // Six of the eight colours of Okabe and Ito (2008), those of the outside and of lines left out.
  constexpr std::array<std::uint32_t, 6> colors{0xCC79A7, 0xE69F00, 0x009E73, 0x0072B2, 0xF0E442, 0xD55E00};
  constexpr std::array<Hatch, 7> hatches{Hatch::none,  Hatch::rising,  Hatch::falling, Hatch::dots,
                                         Hatch::level, Hatch::upright, Hatch::crossed};
  const auto room = static_cast<std::size_t>(-label - 1);
  return {rgb(colors[room % colors.size()]), hatches[room % hatches.size()]};
}

} // namespace isoscope
