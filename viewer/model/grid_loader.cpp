// What the worker does: distances, then sides.
#include "model/grid_loader.h"

#include "tolerance/grid_sides.h"

#include <algorithm>

namespace isoscope {
namespace {

/// Around the field's box, in δ: where other tolerances were studied, Ω may be looked at for them too.
double margin_for(const Scene& scene) {
  return scene.study ? 4 : 2;
}

/// Voxels along the longest side: Ω is 2δ thick and wants at least four voxels across, within what memory and
/// time allow; more where a smaller one may be looked at.
int resolution_for(const Scene& scene) {
  const double least = scene.study ? 144 : 96;
  const double edge = scene.longest_edge + 2 * (margin_for(scene) - 2) * scene.delta;
  return static_cast<int>(std::clamp(4 * edge / std::max(2 * scene.delta, 1e-300), least, 224.0));
}

std::shared_ptr<const DistanceGrid> grid_of(const std::shared_ptr<const Scene>& scene, RunControl& control) {
  auto made =
      make_distance_grid(*scene->field, scene->delta, resolution_for(*scene), control, margin_for(*scene));
  if (!made ||
      (scene->volume && // without one, Ω is looked at for another δ
       !find_sides(*made, *scene->field, scene->volume->sides(), scene->delta, scene->regions, control)))
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
