// One worker looks at the folder twice a second, another makes a tile once more.
#include "mosaic/mosaic.h"

#include "base/pending_file.h"

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <system_error>

namespace isoscope {
namespace {

namespace fs = std::filesystem;

constexpr double between_looks = 0.5; ///< seconds
/// Facets of a Z that is drawn; of a larger one bricks alone.
constexpr std::uint64_t most_facets = 400000;
constexpr std::size_t most_frozen = 50000; ///< marks

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Whether two states of a folder have the same bricks: no tile was made between them.
bool same_tiles(const TileProgress& a, const TileProgress& b) {
  if (a.round.number != b.round.number || a.tiles.size() != b.tiles.size()) return false;
  for (std::size_t i = 0; i < a.tiles.size(); ++i)
    if ((a.tiles[i].state == TileState::made) != (b.tiles[i].state == TileState::made)) return false;
  return true;
}

std::shared_ptr<const MosaicNews> news_of(const TileFolder& folder, const MosaicNews* before,
                                          const RunControl& control) {
  auto news = before != nullptr ? std::make_shared<MosaicNews>(*before) : std::make_shared<MosaicNews>();
  news->error.reset();
  auto progress = progress_of(folder);
  if (!progress) {
    news->error = progress.error();
    return news;
  }
  const bool known = before != nullptr && before->mosaic && same_tiles(before->progress, *progress);
  if (!known && progress->round.number > 0) {
    auto mosaic = mosaic_of(folder, progress->round, most_facets, control);
    if (!mosaic) { // a round that ended while it was read is looked at again
      if (!folder.is_over(progress->round.number)) news->error = mosaic.error();
      return news;
    }
    news->mosaic = std::make_shared<const TileMosaic>(std::move(*mosaic));
  }
  news->progress = std::move(*progress);
  return news;
}

/// Where a recording of a tile goes: into the folder, or where that is only read, among temporary files.
Result<fs::path> recording_file(const TileFolder& folder, std::uint32_t round, std::size_t tile) {
  const std::string name = "round-" + std::to_string(round) + "-tile-" + std::to_string(tile);
  std::error_code failed;
  for (const fs::path& place : {folder.folder() / "recordings", fs::temp_directory_path(failed)}) {
    fs::create_directories(place, failed);
    for (int i = 1; i < 1000; ++i) {
      const fs::path file = place / (name + (i > 1 ? "-" + std::to_string(i) : "") + ".isorun");
      if (fs::exists(file, failed)) continue;
      PendingFile trial;
      if (!trial.open(file)) break;
      return file;
    }
  }
  return Error{ErrorCode::io, "No recording can be written in " + folder.folder().string() + ".",
               "Is the disk full?"};
}

} // namespace

std::string_view name(MosaicLook look) {
  constexpr std::array<std::string_view, 3> words{"bricks", "opened", "mesh"};
  return words.at(static_cast<std::size_t>(look));
}

glm::vec3 state_color(TileState state, const SceneColors& colors) {
  switch (state) {
  case TileState::waiting:
    return 0.5f * (colors.tetrahedron + colors.input);
  case TileState::in_hand:
    return colors.accent;
  case TileState::lost:
    return colors.warning;
  case TileState::failed:
    return colors.bad;
  case TileState::made:
    return colors.good;
  }
  return colors.tetrahedron;
}

struct Mosaic::Begun {
  std::mutex mutex;
  std::optional<std::string> file;
};

Mosaic::Mosaic(WindowState& state, const std::function<void()>& notify)
    : window(state), begun_(std::make_shared<Begun>()),
      looker_([](const Look& q, RunControl& control) { return news_of(*q.folder, q.before.get(), control); },
              notify, Overtaken::finished),
      maker_(
          [begun = begun_, notify](const Again& q, RunControl& control) {
            auto made = std::make_shared<Made>();
            const auto tell = [&] {
              const std::lock_guard lock(begun->mutex);
              begun->file = q.file.string();
              if (notify) notify();
            };
            const auto recorded = record_tile(*q.folder, q.round, q.tile, q.file, control, tell);
            if (recorded)
              made->as_made = recorded->as_made;
            else
              made->error = recorded.error();
            return made;
          },
          notify) {
  camera.set(turned_pose(0.62, -0.5, 30));
}

Status Mosaic::open(const std::string& path) {
  auto found = TileFolder::open(path);
  if (!found) return found.error();
  cancel_rerun();
  folder_ = std::make_shared<const TileFolder>(std::move(*found));
  news_.reset();
  scene_.reset();
  drawn_ = {};
  hovered.reset();
  Camera fresh;
  fresh.set(camera.pose());
  camera = fresh;
  looked_at_ = -1e9;
  shown_ = true;
  return {};
}

void Mosaic::show(bool on) {
  shown_ = on;
  hovered.reset();
}

Status Mosaic::rerun(std::size_t tile) {
  if (!folder_ || !news_ || news_->progress.round.number == 0) return usage("There are no tiles yet.");
  const TileRound& round = news_->progress.round;
  if (Status there = check_tile(round, tile); !there) return there;
  const auto file = recording_file(*folder_, round.number, tile);
  if (!file) return file.error();
  const auto seen = maker_.answered();
  answer_seen_ = seen.get();
  const Box3 box = scene_ && tile < scene_->tiles.size() ? scene_->tiles[tile].box : Box3{};
  rerun_ = TileRerun{round.number, tile, file->string(), box};
  maker_.ask({folder_, round, tile, *file});
  return {};
}

void Mosaic::cancel_rerun() {
  maker_.stop();
  rerun_.reset();
}

std::optional<TileRerun> Mosaic::rerun_under_way() const {
  auto found = rerun_;
  if (found) found->fraction = maker_.fraction();
  return found;
}

std::optional<TileRerun> Mosaic::take_recording() {
  const std::lock_guard lock(begun_->mutex);
  const auto begun = std::exchange(begun_->file, std::nullopt);
  // One that was left meanwhile is wanted no more.
  return rerun_ && begun == rerun_->file ? rerun_ : std::nullopt;
}

void Mosaic::take_made() {
  if (!rerun_) return;
  const auto answered = maker_.answered();
  if (!answered || answered.get() == answer_seen_) return;
  answer_seen_ = answered.get();
  const TileRerun was = *std::exchange(rerun_, std::nullopt);
  const std::string which = "Tile " + std::to_string(was.tile) + " of round " + std::to_string(was.round);
  if (answered->answer->error)
    window.report(*answered->answer->error);
  else if (answered->answer->as_made == false)
    window.report({ErrorCode::internal, which + " comes out otherwise than its file has it.",
                   "Was the file made by another version of the program?"});
  else if (answered->answer->as_made == true)
    window.tell(which + " comes out as its file has it. " + text(tiles_chord) + " leads back to the tiles.");
  else
    window.tell(which + " is made. " + text(tiles_chord) + " leads back to the tiles.");
}

bool Mosaic::update() {
  if (!folder_) return false;
  const auto before = scene_;
  const auto rerun_before = rerun_.has_value();
  if (const auto answered = looker_.answered(); answered && answered->question.folder == folder_) {
    if (news_ != answered->answer && answered->answer) {
      const auto error = answered->answer->error;
      const bool told = news_ && news_->error && error && news_->error->message == error->message;
      news_ = answered->answer;
      if (error && !told && shown()) window.report(*error);
    }
  }
  // Once nothing changes any more there is no need to look twice a second.
  const bool finished = news_ && news_->progress.finished;
  const double pause = finished || !shown() ? 8 * between_looks : between_looks;
  if (looker_.idle() && seconds_now() - looked_at_ > pause) {
    looked_at_ = seconds_now();
    looker_.ask({folder_, news_});
  }
  // The end of one that was begun comes after its beginning was taken.
  bool waits = false;
  {
    const std::lock_guard lock(begun_->mutex);
    waits = begun_->file.has_value();
  }
  if (!waits) take_made();
  const Drawn wanted{news_.get(), look, mark_frozen, window.view.theme};
  if (news_ && wanted != drawn_) {
    drawn_ = wanted;
    scene_ = draw(*news_);
  }
  const bool moved = camera.update(window.scripted ? 1.0 : 1.0 / 60);
  return scene_ != before || rerun_before != rerun_.has_value() || rerun_ || moved;
}

bool Mosaic::idle() const {
  return !folder_ || ((news_ || !shown_) && !rerun_);
}

void Mosaic::abandon() {
  looker_.abandon();
  maker_.abandon();
}

std::shared_ptr<const MosaicScene> Mosaic::draw(const MosaicNews& news) const {
  if (!news.mosaic) return nullptr;
  const TileMosaic& mosaic = *news.mosaic;
  const SceneColors colors = scene_colors(window.view.theme);
  auto scene = std::make_shared<MosaicScene>();
  for (std::size_t i = 0; i < news.progress.tiles.size(); ++i) {
    const TileState state = news.progress.tiles[i].state;
    MosaicScene::Tile tile;
    // Neighbours of one state are told apart.
    const float shade = 0.86f + 0.14f * static_cast<float>((i * 5) % 4) / 3;
    tile.color = shade * state_color(state, colors);
    tile.closed = mosaic.facets.empty() || look == MosaicLook::bricks ||
                  (look == MosaicLook::opened && state != TileState::made);
    scene->tiles.push_back(tile);
  }
  for (const MosaicBrick& b : mosaic.bricks) {
    if (b.tile >= scene->tiles.size()) continue;
    const Box3 box = bounds_of(b.place, mosaic.brick);
    scene->bricks.push_back({box, b.tile});
    scene->tiles[b.tile].box.add(box);
  }
  scene->facets = mosaic.facets;
  scene->tile_of_facet = mosaic.tile_of_facet;
  const std::size_t step = mosaic.frozen.size() / most_frozen + 1;
  for (std::size_t i = 0; mark_frozen && i < mosaic.frozen.size(); i += step)
    scene->frozen.push_back(mosaic.frozen[i]);
  return scene;
}

} // namespace isoscope
