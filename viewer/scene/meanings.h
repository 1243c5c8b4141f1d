// What a colour means, each once and the same in every theme: scene, panels, timeline and figures read this
// table. Grounds, text and lines follow the theme instead (scene/palette.h, ui/theme.h); reasons and kinds of
// the journal have theirs in journal/vocabulary.h.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace isoscope {

namespace meaning_color {
inline constexpr std::uint32_t good = 0x009E73, bad = 0xD55E00, warning = 0xE69F00, gamma = 0x0072B2,
                               outer = 0x56B4E9, inner = 0xCC79A7,
                               misoriented = 0x6647FF, ///< condition 3, and the tetrahedra that violate it
    other_zero = 0x86B300,                             ///< Z of the run beside this one
    kernel = 0xA98BF0, offender = 0xE83FD0, invalid = 0xC0352E; ///< Ψ
} // namespace meaning_color

struct Meaning {
  std::string_view name;
  std::uint32_t color = 0; ///< 0xRRGGBB
};
/// Every two of them are told apart (tests/ui/test_theme.cpp).
inline constexpr std::array meanings{Meaning{"good sample", meaning_color::good},
                                     Meaning{"bad sample, condition 1", meaning_color::bad},
                                     Meaning{"warning, condition 2", meaning_color::warning},
                                     Meaning{"misoriented, condition 3", meaning_color::misoriented},
                                     Meaning{"∂Γ", meaning_color::gamma},
                                     Meaning{"outer boundary of Ω", meaning_color::outer},
                                     Meaning{"inner boundary of Ω", meaning_color::inner},
                                     Meaning{"Z of the other run", meaning_color::other_zero},
                                     Meaning{"kernel of an edge", meaning_color::kernel},
                                     Meaning{"breaks the link condition", meaning_color::offender},
                                     Meaning{"Ψ", meaning_color::invalid}};

} // namespace isoscope
