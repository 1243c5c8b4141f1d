// Computes the distance grids of a scene on workers, so that Ω appears without holding up the window.
#pragma once

#include "model/worker.h"
#include "run/pipeline.h"
#include "tolerance/distance_grid.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace isoscope {

/// What the camera is near to: a ball, and the size of voxels that a picture of it could show, scene units.
struct GridFocus {
  Vec3 middle;
  double radius = 0, voxel = 0;
};

/// One grid at a time; a new scene cancels the work on the old one. Methods are for one thread, the window's.
class GridLoader {
 public:
  explicit GridLoader(std::function<void()> notify);

  /// Begins unless this scene's grid is there or under way; null clears.
  void want(const std::shared_ptr<const Scene>& scene);
  /// What the textures of the grids may take together; another number than before makes them again.
  void allow(std::size_t most_bytes);
  std::size_t allowed() const;
  static constexpr std::size_t usual_bytes = std::size_t{256} << 20;
  /// Null until there is something to show: first a coarse one where the fine one takes long.
  std::shared_ptr<const DistanceGrid> grid() const;
  bool working() const { return !worker_->idle(); }
  /// Asks for finer voxels there, where those of the grid are coarser than would be seen; once a frame, with
  /// nothing where the camera is far.
  void look_near(const std::optional<GridFocus>& focus);
  /// A part of Ω in finer voxels; null where none was asked for or the first is still made.
  std::shared_ptr<const DistanceGrid> detail() const;
  bool refining() const;
  /// In [0, 1]; negative when unknown.
  double fraction() const { return worker_->fraction(); }
  /// How long the last grid took to be made.
  double seconds() const;

 private:
  struct Parts; ///< what is shown before the grid is there, and beside it
  struct Made {
    std::shared_ptr<const DistanceGrid> grid;
    double seconds = 0;
  };
  using GridWorker = Worker<std::shared_ptr<const Scene>, Made>;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<Parts> parts_;
  std::unique_ptr<GridWorker> worker_;
};

/// How many voxels lie across Ω, where they are fewer than it is meant to have; else nothing. `detail`, which
/// may be null: what is finer.
std::string coarseness_in_words(const DistanceGrid& grid, const DistanceGrid* detail);

} // namespace isoscope
