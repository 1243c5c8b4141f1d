// One index a tile serves both searches.
#include "tiles/tile_anchors.h"

#include "tiles/held_points.h"
#include "tiles/tile_piece.h"
#include "tiles/tile_schedule.h"
#include "tolerance/piece_witnesses.h"

#include <algorithm>

namespace isoscope {
namespace {

/// In δ: of less no points can be held.
constexpr double least_cover = 2;

} // namespace

Result<TileAnchors> find_anchors(const TileFolder& folder, std::optional<double> cover,
                                 const RunControl& control) {
  const double delta = folder.manifest().delta;
  TileAnchors anchors;
  std::optional<HeldPoints> held;
  if (cover && *cover >= least_cover * delta) held.emplace(folder.manifest().box.center(), delta, *cover);
  const auto loads = folder.loads_before(1);
  if (!loads) return loads.error();
  const std::vector<GridPlace> tiles = tiles_met(folder.grid(), Tiling{}, *loads);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    control.report("regions", static_cast<double>(i) / static_cast<double>(tiles.size()));
    const ChangeBox bounds = folder.grid().bounds(Tiling{}, tiles[i]);
    const Box3 box{bounds.lo, bounds.hi};
    const Box3 around = box.grown(std::max(tile_input_reach * delta, held ? held->reach() : 0));
    auto input = folder.input(around);
    if (!input) return input.error();
    keep_meeting(*input, around);
    const ClosestPointIndex index = index_of(std::move(*input), control);
    if (!index.empty()) {
      auto witnesses = witnesses_of_piece(index, delta, box, control);
      if (!witnesses && !control.cancelled()) return witnesses.error();
      if (witnesses) anchors.witnesses.insert(anchors.witnesses.end(), witnesses->begin(), witnesses->end());
      if (held)
        held->look(
            index, [&](Vec3 p) { return bounds.holds(p); }, control);
    }
    if (control.cancelled())
      return Error{ErrorCode::cancelled, "The run was stopped.", "Cut the input again."};
  }
  if (held) anchors.held = held->held();
  return anchors;
}

} // namespace isoscope
