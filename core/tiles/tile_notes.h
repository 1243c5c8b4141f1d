// What programs say of the tiles they make, each in a file beside the tile's: who has it in hand, how long it
// took, why it could not be made. No result depends on it.
#pragma once

#include "base/status.h"
#include "tiles/tile_folder.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace isoscope {

enum class TileState : std::uint8_t {
  waiting,
  in_hand, ///< a program is at it, or was when it was heard of last: on another machine nobody can tell
  lost,    ///< the program that was at it has ended without it: it waits to be made anew
  failed,  ///< it could not be made: it waits to be tried anew
  made
};
/// "waiting", "in hand", "lost", "failed", "made".
std::string_view name(TileState state);
constexpr std::size_t tile_state_count = 5;

struct TileReport {
  TileState state = TileState::waiting;
  std::string who;    ///< "node7, process 4711"; empty: nobody has said
  bool here = false;  ///< that is this machine
  double seconds = 0; ///< that it took, or since it was begun; 0: not known
  std::string words;  ///< why it failed
};
/// From the files alone.
TileReport report_of(const TileFolder& folder, std::uint32_t round, const GridPlace& tile);

/// Says that this program has a tile in hand; destroyed without more, that nobody has. Where it cannot be
/// written, nobody is told.
class TileInHand {
 public:
  TileInHand(const TileFolder& folder, std::uint32_t round, const GridPlace& tile);
  ~TileInHand();
  TileInHand(const TileInHand&) = delete;
  TileInHand& operator=(const TileInHand&) = delete;

  void made();
  void failed(const Error& why);

 private:
  std::filesystem::path file_;
  std::chrono::steady_clock::time_point begun_;
  bool told_ = false; ///< how it ended
};

} // namespace isoscope
