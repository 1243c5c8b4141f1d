// Computes the distance grid of a scene on a worker, so that Ω appears without holding up the window.
#pragma once

#include "model/worker.h"
#include "run/pipeline.h"
#include "tolerance/distance_grid.h"

#include <functional>
#include <memory>
#include <string>

namespace isoscope {

/// One grid at a time; a new scene cancels the work on the old one. Methods are for one thread, the window's.
class GridLoader {
 public:
  explicit GridLoader(std::function<void()> notify);

  /// Begins unless this scene's grid is there or under way; null clears.
  void want(const std::shared_ptr<const Scene>& scene);
  /// Null until there is something to show: first a coarse one where the fine one takes long.
  std::shared_ptr<const DistanceGrid> grid() const;
  bool working() const { return !worker_->idle(); }
  /// In [0, 1]; negative when unknown.
  double fraction() const { return worker_->fraction(); }
  /// How long the last grid took to be made.
  double seconds() const;

 private:
  struct Sketch; ///< what the worker shows before it is done
  struct Made {
    std::shared_ptr<const DistanceGrid> grid;
    double seconds = 0;
  };
  using GridWorker = Worker<std::shared_ptr<const Scene>, Made>;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<Sketch> sketch_;
  std::unique_ptr<GridWorker> worker_;
};

/// How many voxels lie across Ω, where they are fewer than it is meant to have; else nothing.
std::string coarseness_in_words(const DistanceGrid& grid);

} // namespace isoscope
