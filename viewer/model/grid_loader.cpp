// What the worker does: distances, then sides; a quick sketch before what takes long.
#include "model/grid_loader.h"

#include "tolerance/grid_sides.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <mutex>

namespace isoscope {
namespace {

constexpr std::size_t most_bytes = std::size_t{256} << 20;
/// What voxels smaller than a quarter of the thickness of Ω may take.
constexpr std::size_t fine_bytes = std::size_t{64} << 20;
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

struct GridLoader::Sketch {
  std::mutex mutex;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const DistanceGrid> grid;
};

GridLoader::GridLoader(std::function<void()> notify) : sketch_(std::make_shared<Sketch>()) {
  auto work = [sketch = sketch_, notify](const std::shared_ptr<const Scene>& scene, RunControl& control) {
    const auto begun = std::chrono::steady_clock::now();
    const double voxel = voxel_for(*scene);
    if (bytes_for(*scene, voxel) > static_cast<double>(sketch_bytes)) {
      const auto rough = make_grid(*scene, wish_for(*scene, voxel, sketch_bytes), control);
      const std::lock_guard lock(sketch->mutex);
      sketch->scene = scene;
      sketch->grid = rough;
      if (notify) notify();
    }
    Made made;
    made.grid = make_grid(*scene, wish_for(*scene, voxel, most_bytes), control);
    made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return std::make_shared<const Made>(std::move(made));
  };
  worker_ = std::make_unique<GridWorker>(std::move(work), notify);
}

void GridLoader::want(const std::shared_ptr<const Scene>& scene) {
  if (scene == scene_) return;
  scene_ = scene;
  if (scene && scene->field)
    worker_->ask(scene);
  else
    worker_->stop();
}

std::shared_ptr<const DistanceGrid> GridLoader::grid() const {
  const auto answered = worker_->answered();
  if (answered && answered->question == scene_ && answered->answer) return answered->answer->grid;
  const std::lock_guard lock(sketch_->mutex);
  return sketch_->scene == scene_ ? sketch_->grid : nullptr;
}

double GridLoader::seconds() const {
  const auto answered = worker_->answered();
  return answered && answered->question == scene_ && answered->answer ? answered->answer->seconds : 0;
}

std::string coarseness_in_words(const DistanceGrid& grid) {
  if (!grid.coarsened) return "";
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "Ω is drawn coarser than wanted: %.2g voxels across it, not 4",
                2 * grid.delta / grid.voxel);
  return text.data();
}

} // namespace isoscope
