// Lessons as cards with their pictures: the first row of the gallery.
#pragma once

#include "ui/ui.h"

#include <cstdint>
#include <span>

namespace isoscope::panels {

/// The first lessons and the way to all of them, over the width that is left. `textures`: the pictures of
/// bundled_lessons(), 0 where there is none.
void lesson_cards(Ui& ui, std::span<const std::uint32_t> textures);

} // namespace isoscope::panels
