// Commands on the tiles shown, and what scripts expect of them.
#include "mosaic/mosaic.h"

#include "ui/icons.h"

#include <cmath>

namespace isoscope {
namespace {

Status rerun_tile(Mosaic& m, const Arguments& a) {
  const auto tile = whole_argument(a, 0, 0);
  if (a.size() != 1 || !tile) return wrong_arguments("Which tile?");
  return m.rerun(*tile);
}

Status set_mosaic_look(Mosaic& m, const Arguments& a) {
  for (std::size_t i = 0; i < mosaic_looks.size(); ++i)
    if (a.size() == 1 && a[0] == name(static_cast<MosaicLook>(i))) {
      m.look = static_cast<MosaicLook>(i);
      return {};
    }
  return wrong_arguments("It is bricks, opened or mesh.");
}

} // namespace

void Mosaic::add_commands(CommandTable& table) {
  const auto open = [this] { return is_open(); };
  table.add({{.name = "tiles",
              .title = "Tiles",
              .help = "Shows the folder of tiles that was opened last instead of the run, and the run again.",
              .menu = "View",
              .icon = icon::cubes,
              .keys = {tiles_chord},
              .run = does([this] { show(!shown()); }),
              .enabled = open,
              .checked = [this] { return shown(); }},
             {.name = "rerun-tile",
              .title = "Make a tile once more",
              .usage = "K",
              .help = "Makes a tile of the round shown once more, records it and opens the recording, to be "
                      "stepped through; the tiles stay as they are.",
              .run = on(*this, rerun_tile),
              .enabled = open},
             {.name = "cancel-rerun",
              .title = "Leave the tile that is made once more",
              .help = "Ends it; its recording keeps what there is.",
              .run = does([this] { cancel_rerun(); }),
              .enabled = [this] { return rerun_.has_value(); }},
             {.name = "tiles-look",
              .title = "Look of the tiles",
              .usage = "bricks | opened | mesh",
              .help = "Bricks closed, those of tiles that are made open, or all open, with Z in them.",
              .run = on(*this, set_mosaic_look),
              .enabled = open}});
}

void Mosaic::add_values(NamedValues& t) {
  t.add("tiles.shown", "whether a folder of tiles is shown instead of the run", [this] { return shown(); });
  t.add("tiles.look", "bricks, opened or mesh", [this] { return look; });
  t.add(
      "tiles.frozen-marks", "whether frozen vertices are marked", [this] { return mark_frozen; },
      [this](const std::string& text) -> Status {
        const auto on = read_switch(text);
        if (!on) return wrong_value(text, "on, off");
        mark_frozen = *on;
        return {};
      });
  const auto progress = [this] { return news_ ? &news_->progress : nullptr; };
  const auto of = t.readings("tiles.", progress, "nan");
  of("round", "the round that was begun last, from 1 on; 0 before the first",
     [](const TileProgress& p) { return p.round.number; });
  of("count", "tiles of the round", [](const TileProgress& p) { return p.tiles.size(); });
  of("finished", "whether all rounds are made", &TileProgress::finished);
  of("done", "facets of tiles that are made, of those of the round, in [0, 1]", &TileProgress::fraction);
  of("left", "seconds that are left of the round", &TileProgress::seconds_left);
  for (const auto& [word, state] :
       {std::pair{"waiting", TileState::waiting}, std::pair{"in-hand", TileState::in_hand},
        std::pair{"lost", TileState::lost}, std::pair{"failed", TileState::failed},
        std::pair{"made", TileState::made}})
    of(word, "tiles of the round in that state",
       [state = state](const TileProgress& p) { return p.count(state); });
  const auto in_mosaic = t.readings(
      "tiles.", [this] { return news_ ? news_->mosaic.get() : nullptr; }, "nan");
  in_mosaic("bricks", "bricks that have facets", [](const TileMosaic& m) { return m.bricks.size(); });
  in_mosaic("facets", "of Z as far as it is made", [](const TileMosaic& m) { return m.facet_count; });
  in_mosaic("frozen", "vertices of Z that the round leaves where they are",
            [](const TileMosaic& m) { return m.frozen.size(); });
  t.add("tiles.hovered", "the tile under the mouse", [this] { return hovered; });
  t.add("tiles.rerun", "the tile that is being made once more",
        [this] { return rerun_ ? std::optional(rerun_->tile) : std::nullopt; });
}

} // namespace isoscope
