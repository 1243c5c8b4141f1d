// Computes the distance grid of a scene on a worker, so that Ω appears without holding up the window.
#pragma once

#include "run/pipeline.h"
#include "tolerance/distance_grid.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace isoscope {

/// One grid at a time; a new scene cancels the work on the old one.
class GridLoader {
 public:
  explicit GridLoader(std::function<void()> notify) : notify_(std::move(notify)) {}
  ~GridLoader() { stop(); }
  GridLoader(const GridLoader&) = delete;
  GridLoader& operator=(const GridLoader&) = delete;

  /// Begins unless this scene's grid is there or under way; null clears.
  void want(const std::shared_ptr<const Scene>& scene);
  /// Null until ready.
  std::shared_ptr<const DistanceGrid> grid() const;
  bool working() const { return working_.load(); }
  double fraction() const { return fraction_.load(); }

 private:
  void stop();
  std::function<void()> notify_;
  std::shared_ptr<const Scene> scene_;
  mutable std::mutex mutex_;
  std::shared_ptr<const DistanceGrid> grid_;
  RunControl control_;
  std::atomic<bool> working_{false};
  std::atomic<double> fraction_{0};
  std::thread worker_;
};

} // namespace isoscope
