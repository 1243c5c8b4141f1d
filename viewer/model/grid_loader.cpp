// What the worker does: distances, then sides.
#include "model/grid_loader.h"

#include "tolerance/grid_sides.h"

#include <algorithm>

namespace isoscope {
namespace {

/// Voxels along the longest side: Ω is 2δ thick and wants at least four voxels across, within what memory and
/// time allow.
int resolution_for(const Scene& scene) {
  const double voxels = 4 * scene.longest_edge / std::max(2 * scene.delta, 1e-300);
  return static_cast<int>(std::clamp(voxels, 96.0, 224.0));
}

std::shared_ptr<const DistanceGrid> grid_of(const std::shared_ptr<const Scene>& scene, RunControl& control) {
  auto made = make_distance_grid(*scene->field, scene->delta, resolution_for(*scene), control);
  if (!made ||
      !find_sides(*made, *scene->field, scene->volume->sides(), scene->delta, scene->regions, control))
    return nullptr;
  return std::make_shared<const DistanceGrid>(*std::move(made));
}

} // namespace

GridLoader::GridLoader(std::function<void()> notify)
    : worker_(std::make_unique<GridWorker>(grid_of, std::move(notify))) {}

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
  return answered && answered->question == scene_ ? answered->answer : nullptr;
}

} // namespace isoscope
