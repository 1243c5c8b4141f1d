// What the workers do: distances, then sides; a quick sketch before what takes long.
#include "model/grid_loader.h"

#include "tolerance/grid_sides.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>

namespace isoscope {
namespace {

/// What voxels smaller than a quarter of the thickness of Ω may take.
constexpr std::size_t fine_bytes = std::size_t{64} << 20;
/// What a finer part may take.
constexpr std::size_t detail_bytes = std::size_t{64} << 20, least_detail_bytes = std::size_t{4} << 20;
/// Of a detail: so many voxels across Ω are never too few, and as many times smaller than the grid's are
/// worth it.
constexpr double always_enough = 8, worth_it = 1.5;
/// A grid of more bytes than that is sketched first, by one of that size.
constexpr std::size_t sketch_bytes = std::size_t{6} << 20;

/// Other tolerances were studied: Ω may be looked at for them too.
constexpr double studied_level = 4;

/// What is wanted of the scene's grid, within so many bytes.
GridWish wish_for(const Scene& scene, double voxel, std::size_t bytes) {
  GridWish wish;
  wish.delta = scene.delta;
  wish.level = scene.study ? studied_level : 1;
  wish.voxel = voxel;
  wish.coarsest = 0.5 * scene.delta; // four across Ω
  wish.most_bytes = bytes;
  // The robust distance is nowhere 0 between the sides, so that these are drawn from a texture of their own.
  wish.side_bytes = scene.points ? 1 : 0;
  return wish;
}

/// About what a grid takes: bricks of 7 cells a side along an area.
double bytes_for(const Scene& scene, double voxel) {
  const double side = DistanceGrid::cells * voxel;
  const double across = 2 * ((scene.study ? studied_level : 1) * scene.delta / voxel + 1.75);
  const double bricks = scene.field->area() / (side * side) * (1.5 + across / DistanceGrid::cells);
  return bricks * static_cast<double>(DistanceGrid::brick_size * sizeof(std::int16_t));
}

/// The size of voxels that is asked for: eight across Ω where that is cheap, else four; never so large that
/// they show in the shape.
double voxel_for(const Scene& scene) {
  const double largest = scene.longest_edge / 128, four = 0.5 * scene.delta;
  double voxel = std::min(0.5 * four, largest);
  while (voxel < std::min(four, largest) && bytes_for(scene, voxel) > static_cast<double>(fine_bytes))
    voxel *= 1.1;
  return std::min({voxel, four, largest});
}

std::shared_ptr<const DistanceGrid> make_grid(const Scene& scene, const GridWish& wish, RunControl& control) {
  auto made = make_distance_grid(*scene.field, wish, control);
  if (!made ||
      (scene.volume && // without one, Ω is looked at for another δ
       !find_sides(*made, {*scene.field, scene.volume->sides(), scene.delta, scene.regions}, control)))
    return nullptr;
  return std::make_shared<const DistanceGrid>(*std::move(made));
}

} // namespace

struct GridLoader::Parts {
  /// A part of Ω, and how finely it is wanted.
  struct Detail {
    std::shared_ptr<const Scene> scene;
    Box3 box;
    double voxel = 0;
    std::size_t most_bytes = 0;
  };
  std::atomic<std::size_t> most_bytes = usual_bytes; ///< of both grids together
  std::mutex mutex;                                  ///< of the sketch
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const DistanceGrid> sketch;
  std::optional<Detail> near; ///< what is wanted
  Worker<Detail, DistanceGrid> detail;

  explicit Parts(const std::function<void()>& notify)
      : detail(
            [](const Detail& wanted, RunControl& control) {
              GridWish wish = wish_for(*wanted.scene, wanted.voxel, wanted.most_bytes);
              wish.within = wanted.box;
              return make_grid(*wanted.scene, wish, control);
            },
            notify) {}
};

GridLoader::GridLoader(std::function<void()> notify) : parts_(std::make_shared<Parts>(notify)) {
  auto work = [parts = parts_, notify](const std::shared_ptr<const Scene>& scene, RunControl& control) {
    const auto begun = std::chrono::steady_clock::now();
    const double voxel = voxel_for(*scene);
    if (bytes_for(*scene, voxel) > static_cast<double>(sketch_bytes)) {
      const auto rough = make_grid(*scene, wish_for(*scene, voxel, sketch_bytes), control);
      const std::lock_guard lock(parts->mutex);
      parts->scene = scene;
      parts->sketch = rough;
      if (notify) notify();
    }
    Made made;
    made.grid = make_grid(*scene, wish_for(*scene, voxel, parts->most_bytes), control);
    made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return std::make_shared<const Made>(std::move(made));
  };
  worker_ = std::make_unique<GridWorker>(std::move(work), notify);
}

void GridLoader::want(const std::shared_ptr<const Scene>& scene) {
  if (scene == scene_) return;
  scene_ = scene;
  parts_->near.reset();
  parts_->detail.stop();
  if (scene && scene->field)
    worker_->ask(scene);
  else
    worker_->stop();
}

void GridLoader::allow(std::size_t most_bytes) {
  if (parts_->most_bytes.exchange(most_bytes) == most_bytes || !scene_ || !scene_->field) return;
  parts_->near.reset();
  parts_->detail.stop();
  worker_->ask(scene_);
}

std::size_t GridLoader::allowed() const {
  return parts_->most_bytes;
}

std::shared_ptr<const DistanceGrid> GridLoader::grid() const {
  const auto answered = worker_->answered();
  if (answered && answered->question == scene_ && answered->answer) return answered->answer->grid;
  const std::lock_guard lock(parts_->mutex);
  return parts_->scene == scene_ ? parts_->sketch : nullptr;
}

void GridLoader::look_near(const std::optional<GridFocus>& focus) {
  std::optional<Parts::Detail>& near = parts_->near;
  const auto whole = working() ? nullptr : grid();
  const auto far = [&] {
    if (near) parts_->detail.stop();
    near.reset();
  };
  // Where nothing but what lies beside it tells a point's side, a part does not know its own.
  const bool possible = focus && whole && !whole->empty() && scene_->volume &&
                        SidedInput{*scene_->field, scene_->volume->sides(), scene_->delta, {}}.tells_sides();
  if (!possible) return far();
  const double enough = 2 * whole->delta / always_enough, wanted = std::max(focus->voxel, 0.5 * enough);
  const std::size_t taken = whole->texture_bytes(), most = parts_->most_bytes,
                    room = most > taken ? most - taken : 0;
  if (whole->voxel <= 1.05 * enough || whole->voxel < worth_it * wanted || room < least_detail_bytes)
    return far();
  if (near) {
    // Small moves need no other part.
    const Vec3 to_lo = focus->middle - near->box.lo, to_hi = near->box.hi - focus->middle;
    const bool inside = std::min({to_lo.x, to_lo.y, to_lo.z, to_hi.x, to_hi.y, to_hi.z}) >= focus->radius;
    if (inside && near->voxel <= 1.5 * wanted && near->voxel >= 0.3 * wanted) return;
  }
  const double reach = 1.4 * focus->radius;
  Box3 box;
  box.add(focus->middle);
  near = Parts::Detail{scene_, box.grown(reach), wanted, std::min(room, detail_bytes)};
  parts_->detail.ask(*near);
}

std::shared_ptr<const DistanceGrid> GridLoader::detail() const {
  if (!parts_->near) return nullptr;
  const auto answered = parts_->detail.answered();
  if (!answered || !answered->answer || answered->question.scene != scene_) return nullptr;
  const auto coarse = grid();
  return coarse && !answered->answer->empty() && answered->answer->voxel * 1.2 < coarse->voxel
             ? answered->answer
             : nullptr;
}

bool GridLoader::refining() const {
  return !parts_->detail.idle();
}

double GridLoader::seconds() const {
  const auto answered = worker_->answered();
  return answered && answered->question == scene_ && answered->answer ? answered->answer->seconds : 0;
}

std::string coarseness_in_words(const DistanceGrid& grid, const DistanceGrid* detail) {
  if (!grid.coarsened) return "";
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "Ω is drawn coarser than wanted: %.2g voxels across it, not 4",
                2 * grid.delta / grid.voxel);
  std::string words = text.data();
  if (detail != nullptr) {
    std::snprintf(text.data(), text.size(), "; %.2g near the camera", 2 * detail->delta / detail->voxel);
    words += text.data();
  }
  return words;
}

} // namespace isoscope
