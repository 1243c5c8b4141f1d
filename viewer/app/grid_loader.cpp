// The worker that makes distance grids.
#include "app/grid_loader.h"

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

} // namespace

void GridLoader::stop() {
  control_.cancel();
  if (worker_.joinable()) worker_.join();
  control_.reset();
}

void GridLoader::want(const std::shared_ptr<const Scene>& scene) {
  if (scene == scene_) return;
  stop();
  scene_ = scene;
  {
    const std::lock_guard lock(mutex_);
    grid_.reset();
  }
  if (!scene || !scene->index) return;
  working_ = true;
  control_.on_progress([this](std::string_view, double fraction) { fraction_ = fraction; });
  worker_ = std::thread([this, scene] {
    auto made = make_distance_grid(*scene->index, scene->delta, resolution_for(*scene), control_);
    if (made && find_sides(*made, *scene->index, scene->delta, scene->regions, control_)) {
      const std::lock_guard lock(mutex_);
      grid_ = std::make_shared<const DistanceGrid>(*std::move(made));
    }
    working_ = false;
    notify_();
  });
}

std::shared_ptr<const DistanceGrid> GridLoader::grid() const {
  const std::lock_guard lock(mutex_);
  return grid_;
}

} // namespace isoscope
