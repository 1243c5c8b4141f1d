// A folder of tiles in the window: what is known of it while programs elsewhere work on it, and tiles that
// are made once more to be stepped through.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "model/window_state.h"
#include "model/worker.h"
#include "scene/mosaic_scene.h"
#include "tiles/tile_mosaic.h"
#include "tiles/tile_progress.h"
#include "tiles/tile_run.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace isoscope {

struct Ui;

/// What bricks show: all closed, those of tiles that are made open, or all open.
enum class MosaicLook : std::uint8_t { bricks, opened, mesh };
std::string_view name(MosaicLook look);
constexpr std::array<const char*, 3> mosaic_looks{"Bricks", "Opened", "Mesh"};

/// The colour of a state in the view.
glm::vec3 state_color(TileState state, const SceneColors& colors);

/// Of the command that shows tiles and the run in turn.
constexpr Chord tiles_chord{'T', true, true};

/// A folder at one moment.
struct MosaicNews {
  TileProgress progress;
  std::shared_ptr<const TileMosaic> mosaic; ///< null where no round was begun
  std::optional<Error> error;               ///< why nothing newer is known
};

/// A tile that is being made once more.
struct TileRerun {
  std::uint32_t round = 0;
  std::size_t tile = 0;
  std::string file;     ///< the recording
  Box3 box;             ///< of its bricks
  double fraction = -1; ///< of what is being prepared; negative: not known
};

class Mosaic {
 public:
  /// `notify` is called from workers when something new is ready.
  Mosaic(WindowState& state, const std::function<void()>& notify);

  WindowState& window;
  Camera camera;
  MosaicLook look = MosaicLook::opened;
  bool mark_frozen = true;
  std::optional<std::uint32_t> hovered; ///< tile under the mouse, in the view or the list

  /// Shows a folder and looks at it anew again and again. Fails as TileFolder::open().
  Status open(const std::string& folder);
  bool is_open() const { return folder_ != nullptr; }
  const TileFolder* folder() const { return folder_.get(); }
  /// Instead of the run.
  bool shown() const { return shown_ && is_open(); }
  void show(bool on);
  /// The newest; null before the first.
  std::shared_ptr<const MosaicNews> news() const { return news_; }
  /// As it is drawn; null before the first.
  std::shared_ptr<const MosaicScene> scene() const { return scene_; }

  /// Begins to make a tile of the round shown once more, instead of one that is being made.
  Status rerun(std::size_t tile);
  void cancel_rerun();
  std::optional<TileRerun> rerun_under_way() const;
  /// The tile that is being made once more, once, as soon as its recording can be opened.
  std::optional<TileRerun> take_recording();

  /// Once a frame; true when something changed.
  bool update();
  /// Nothing that was asked is under way, and what is shown is what was found.
  bool idle() const;
  /// Begins the end of what is asked, and waits for nothing.
  void abandon();

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);

 private:
  struct Look { ///< a question of the worker that looks
    std::shared_ptr<const TileFolder> folder;
    std::shared_ptr<const MosaicNews> before;
  };
  struct Again { ///< a question of the worker that makes
    std::shared_ptr<const TileFolder> folder;
    TileRound round;
    std::size_t tile = 0;
    std::filesystem::path file;
  };
  struct Made {
    std::optional<Error> error;
    std::optional<bool> as_made;
  };
  struct Begun; ///< what the maker's thread tells
  std::shared_ptr<const MosaicScene> draw(const MosaicNews& news) const;
  void take_made();

  std::shared_ptr<const TileFolder> folder_;
  bool shown_ = false;
  std::shared_ptr<const MosaicNews> news_;
  std::shared_ptr<const MosaicScene> scene_;
  /// What the scene was drawn from.
  struct Drawn {
    const MosaicNews* news = nullptr;
    MosaicLook look = MosaicLook::opened;
    bool frozen = true;
    ThemeKind theme = ThemeKind::dark;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  } drawn_;
  double looked_at_ = -1e9; ///< seconds of a steady clock
  std::shared_ptr<Begun> begun_;
  std::optional<TileRerun> rerun_;
  const void* answer_seen_ = nullptr;
  Worker<Look, MosaicNews> looker_;
  Worker<Again, Made> maker_;
};

namespace panels {

/// The right pane: how far the tiles are, and each of them.
void mosaic(Ui& ui, Mosaic& mosaic);

} // namespace panels

} // namespace isoscope
