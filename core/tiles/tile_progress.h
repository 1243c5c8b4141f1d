// How far the tiles of a folder are, for who looks on: nothing is begun by that.
#pragma once

#include "tiles/tile_notes.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

struct TileProgress {
  TileRound round; ///< that was begun last; number 0 where none was yet
  /// By the round's order.
  std::vector<TileReport> tiles;
  std::array<std::size_t, tile_state_count> counts{}; ///< of tiles, by state
  bool finished = false;                              ///< all rounds are made
  /// That follow this one in any case; how many in all, what they take away decides.
  int rounds_to_come = 0;
  /// Of the round, at the pace of the tiles that were made last and with as many at work as there are.
  std::optional<double> seconds_left;

  std::size_t count(TileState state) const { return counts.at(static_cast<std::size_t>(state)); }
  /// In [0, 1]: facets of tiles that are made, of those of the round.
  double fraction() const;
};

/// "about 40 s of round 3, then at least 2 rounds"; empty where all is made.
std::string time_left_words(const TileProgress& progress);

/// Fails with io or bad_input where a file cannot be read.
Result<TileProgress> progress_of(const TileFolder& folder);

} // namespace isoscope
