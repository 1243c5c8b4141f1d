// Makes the pictures, figures and films that were asked for, a tile a frame; files are written on a worker.
#pragma once

#include "export/exports.h"
#include "export/tiled_picture.h"
#include "platform/child_process.h"

#include <future>
#include <memory>

struct ImFont;
struct ImFontAtlas;

namespace isoscope {

/// The view in the window: pictures without a size of their own take it, and lines keep their look.
struct ViewExtent {
  int width = 0, height = 0; ///< pixels
  float pixel_scale = 1;
};

class Exporter {
 public:
  Exporter();
  ~Exporter();
  /// Does a frame's worth of work. The renderer holds the state shown. True when something changed.
  bool advance(Exports& desk, Renderer& renderer, const ViewExtent& extent);

 private:
  void begin(Exports& desk, const ViewExtent& extent);
  void begin_figure(Exports& desk, const FigureRequest& request, const ViewExtent& extent);
  void draw(Exports& desk, Renderer& renderer);
  void write(const Exports& desk, Image image);
  void add_key(const Exports& desk, Image& image);
  void written(Exports& desk);
  void start_film(Exports& desk);
  void watch_film(Exports& desk);
  void finish(Exports& desk, const std::string& word);
  void fail(Exports& desk, Error error);
  Shot shot_of(const Exports& desk, const ViewState& state, const PictureFormat& format,
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
  std::unique_ptr<ImFontAtlas> key_fonts_; ///< at the scale of the pictures
  ImFont* key_font_ = nullptr;
  float key_scale_ = 0;
};

} // namespace isoscope
