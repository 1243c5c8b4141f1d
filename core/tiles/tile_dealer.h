// Deals out the tiles of a folder to workers that have no state of their own.
#pragma once

#include "tiles/tile_folder.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace isoscope {

/// One hand that deals for all: no tile is given twice, and none of a round before all of the one before are
/// there.
class TileDealer {
 public:
  /// The folder must outlive it.
  explicit TileDealer(const TileFolder& folder) : folder_(folder) {}

  /// The heaviest tile that is left, as a round that has it alone; nothing while all that are left are in
  /// hand, or when all rounds are made. Fails as TileFolder::round().
  Result<std::optional<TileRound>> deal();
  /// One that was dealt is there.
  void done() { --in_hand_; }

  std::size_t in_hand() const { return in_hand_; }
  /// No tile is left in any round.
  bool finished() const { return finished_; }
  /// The round that is dealt.
  const TileRound& round() const { return round_; }

 private:
  const TileFolder& folder_;
  TileRound round_;
  std::vector<std::size_t> left_; ///< of the round, the next one last
  std::size_t in_hand_ = 0;
  bool finished_ = false;
};

} // namespace isoscope
