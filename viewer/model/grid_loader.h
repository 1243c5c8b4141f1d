// Computes the distance grid of a scene on a worker, so that Ω appears without holding up the window.
#pragma once

#include "model/worker.h"
#include "run/pipeline.h"
#include "tolerance/distance_grid.h"

#include <functional>
#include <memory>

namespace isoscope {

/// One grid at a time; a new scene cancels the work on the old one. Methods are for one thread, the window's.
class GridLoader {
 public:
  explicit GridLoader(std::function<void()> notify);

  /// Begins unless this scene's grid is there or under way; null clears.
  void want(const std::shared_ptr<const Scene>& scene);
  /// Null until ready.
  std::shared_ptr<const DistanceGrid> grid() const;
  bool working() const { return !worker_->idle(); }
  /// In [0, 1]; negative when unknown.
  double fraction() const { return worker_->fraction(); }

 private:
  using GridWorker = Worker<std::shared_ptr<const Scene>, DistanceGrid>;
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<GridWorker> worker_;
};

} // namespace isoscope
