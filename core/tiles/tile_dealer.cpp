// A round's list of tiles from its end.
#include "tiles/tile_dealer.h"

#include <algorithm>

namespace isoscope {

Result<std::optional<TileRound>> TileDealer::deal() {
  using Dealt = std::optional<TileRound>;
  if (left_.empty() && (in_hand_ > 0 || finished_)) return Dealt();
  while (left_.empty()) { // others may have made all of one meanwhile
    auto next = folder_.round();
    if (!next) return next.error();
    if (!*next) {
      finished_ = true;
      return Dealt();
    }
    round_ = std::move(**next);
    left_ = folder_.pending(round_);
    std::reverse(left_.begin(), left_.end());
  }
  TileRound alone = round_;
  alone.tiles = {round_.tiles[left_.back()]};
  left_.pop_back();
  ++in_hand_;
  return Dealt(std::move(alone));
}

} // namespace isoscope
