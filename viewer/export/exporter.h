// Makes the pictures, figures and films that were asked for, a tile a frame; files are written on a worker.
#pragma once

#include "app/app_model.h"
#include "export/tiled_picture.h"
#include "platform/child_process.h"

#include <future>
#include <memory>

namespace isoscope {

/// The view in the window: pictures without a size of their own take it, and lines keep their look.
struct ViewExtent {
  int width = 0, height = 0; ///< pixels
  float pixel_scale = 1;
};

class Exporter {
 public:
  ~Exporter();
  /// Does a frame's worth of work. The renderer holds the model's state. True when something changed.
  bool advance(AppModel& model, Renderer& renderer, const ViewExtent& extent);

 private:
  void begin(AppModel& model, const ViewExtent& extent);
  void begin_figure(AppModel& model, const FigureRequest& request, const ViewExtent& extent);
  void draw(AppModel& model, Renderer& renderer);
  void write(AppModel& model, Image image);
  void written(AppModel& model);
  void start_film(AppModel& model);
  void watch_film(AppModel& model);
  void finish(AppModel& model, const std::string& word);
  void fail(AppModel& model, Error error);
  Shot shot_of(const AppModel& model, const ViewState& state, const PictureFormat& format,
               const ViewExtent& extent) const;

  enum class Stage : std::uint8_t { idle, drawing, writing, filming };
  Stage stage_ = Stage::idle;
  ExportRequest request_;
  Shot shot_;
  std::unique_ptr<TiledPicture> picture_;
  std::size_t frame_ = 0;
  std::future<Status> file_;
  std::optional<ChildProcess> film_;
  std::filesystem::path film_log_;
  Step return_to_ = 0;
  bool return_following_ = false;
};

} // namespace isoscope
