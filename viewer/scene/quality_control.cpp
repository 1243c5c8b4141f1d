// Chooses how finely frames are drawn while something moves.
#include "scene/quality_control.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

constexpr double too_slow = 0.075, quick = 0.028;
constexpr std::size_t software_sprites = 200000; // about a microsecond each
constexpr std::array<FrameQuality, 5> levels{{{1.0, 0.6, 1.5f, 4, 1000000},
                                              {1.0, 0.5, 2.0f, 1, 200000},
                                              {1.0, 0.4, 2.5f, 1, 40000},
                                              {0.7, 0.5, 2.5f, 1, 20000},
                                              {0.5, 0.5, 3.0f, 1, 10000}}};

constexpr double quick_at_rest = 0.02, longest_rest = 2;

} // namespace

int resting_frames(int asked, double seconds) {
  if (seconds < quick_at_rest) return 4 * asked;
  return std::clamp(static_cast<int>(longest_rest / seconds), 1, asked);
}

FrameQuality QualityControl::choose(Quality quality) const {
  if (quality == Quality::moving) return levels[static_cast<std::size_t>(level_)];
  FrameQuality full;
  if (software_) full.sprites = software_sprites;
  return full;
}

void QualityControl::took(Quality quality, double seconds) {
  if (quality != Quality::moving) return;
  if (seconds > too_slow) level_ = std::min(level_ + 1, static_cast<int>(levels.size()) - 1);
  if (seconds < quick) level_ = std::max(level_ - 1, 0);
}

} // namespace isoscope
