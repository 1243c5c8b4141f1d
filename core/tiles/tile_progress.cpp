// The files that are there, what their makers say, and a pace from it.
#include "tiles/tile_progress.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// Facets and the seconds that they took.
struct Pace {
  double facets = 0, seconds = 0;
  void add(const TileWork& tile, const TileReport& report) {
    if (report.state != TileState::made || report.seconds <= 0) return;
    facets += static_cast<double>(tile.facets);
    seconds += report.seconds;
  }
};

std::optional<double> time_left(const TileProgress& p, const Pace& pace) {
  if (p.finished) return 0;
  if (pace.facets <= 0) return std::nullopt;
  double left = 0, longest = 0;
  for (std::size_t i = 0; i < p.tiles.size(); ++i) {
    if (p.tiles[i].state == TileState::made) continue;
    double seconds = static_cast<double>(p.round.tiles[i].facets) * pace.seconds / pace.facets;
    if (p.tiles[i].state == TileState::in_hand) seconds = std::max(0.0, seconds - p.tiles[i].seconds);
    left += seconds;
    longest = std::max(longest, seconds);
  }
  const auto at_work = static_cast<double>(std::max<std::size_t>(p.count(TileState::in_hand), 1));
  return std::max(left / at_work, longest); // no tile is made by two
}

} // namespace

double TileProgress::fraction() const {
  if (finished) return 1;
  double made = 0, all = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const auto facets = static_cast<double>(round.tiles[i].facets);
    all += facets;
    if (tiles[i].state == TileState::made) made += facets;
  }
  return all > 0 ? made / all : 0;
}

std::string time_left_words(const TileProgress& p) {
  if (p.finished) return {};
  const std::string round = "round " + std::to_string(p.round.number);
  std::string words;
  if (p.seconds_left) {
    const double s = *p.seconds_left;
    words = "about " +
            (s < 90     ? general(std::ceil(s), 3) + " s"
             : s < 5400 ? general(std::round(s / 60), 3) + " min"
                        : general(s / 3600, 2) + " h") +
            " of " + round;
  }
  if (p.rounds_to_come == 0) return words;
  return words + (words.empty() ? "" : ", then ") + "at least " +
         counted(static_cast<std::size_t>(p.rounds_to_come), "round") +
         (words.empty() ? " after " + round : "");
}

Result<TileProgress> progress_of(const TileFolder& folder) {
  TileProgress progress;
  auto begun = folder.last_begun();
  if (!begun) return begun.error();
  if (!*begun) return progress;
  progress.round = std::move(**begun);
  const TileRound& round = progress.round;
  Pace pace;
  for (const TileWork& tile : round.tiles) {
    const TileReport& report = progress.tiles.emplace_back(report_of(folder, round.number, tile.tile));
    ++progress.counts.at(static_cast<std::size_t>(report.state));
    pace.add(tile, report);
  }
  if (progress.count(TileState::made) == round.tiles.size()) {
    const auto last = folder.is_last(round);
    if (!last) return last.error();
    progress.finished = *last;
  }
  if (!progress.finished && !round.tiling.whole) progress.rounds_to_come = shifts - 1 - round.tiling.shift;
  progress.seconds_left = time_left(progress, pace);
  return progress;
}

} // namespace isoscope
