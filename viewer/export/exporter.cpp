// Makes pictures, figures and films, a tile a frame.
#include "export/exporter.h"

#include "model/words.h"
#include "scene/picture_view.h"
#include "scene/section_svg.h"
#include "view/scene_key.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>

namespace isoscope {
namespace {

namespace fs = std::filesystem;
constexpr auto at_once = std::chrono::seconds(0);

std::string frame_name(std::size_t frame) {
  std::array<char, 40> name{};
  std::snprintf(name.data(), name.size(), "frame_%04zu.png", frame + 1);
  return name.data();
}

/// ffmpeg reads % in its input as a pattern.
std::string without_patterns(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '%' ? "%%" : std::string(1, c);
  return out;
}

/// The last words of a program's log.
std::string last_words(const fs::path& log) {
  std::ifstream in(log);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  constexpr std::size_t most = 400;
  if (text.size() > most) text = "…" + text.substr(text.size() - most);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text;
}

Status write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    return Error{ErrorCode::io, "The figure " + file.string() + " cannot be written.",
                 "Check that the folder exists, is writable and has room."};
  return {};
}

} // namespace

Exporter::Exporter() = default;

Exporter::~Exporter() {
  if (file_.valid()) file_.wait();
}

void Exporter::fail(Exports& desk, Error error) {
  desk.window.report(error);
  if (desk.window.scripted) std::fprintf(stderr, "isoscope: %s\n", error.line().c_str());
  desk.error = std::move(error);
  finish(desk, "");
}

void Exporter::finish(Exports& desk, const std::string& word) {
  const auto* sequence = std::get_if<SequenceRequest>(&request_);
  if (stage_ != Stage::idle && sequence != nullptr && sequence->kind == SequenceRequest::Kind::steps) {
    if (return_following_)
      desk.window.transport.follow();
    else
      desk.window.transport.jump(return_to_);
  }
  stage_ = Stage::idle;
  picture_.reset();
  film_.reset();
  if (!film_log_.empty()) {
    std::error_code ignored;
    fs::remove(std::exchange(film_log_, {}), ignored);
  }
  desk.busy = false;
  desk.doing.clear();
  desk.part = 0;
  if (!word.empty() && !desk.window.scripted) desk.window.tell(word);
}

Shot Exporter::shot_of(const Exports& desk, const ViewState& state, const PictureFormat& format,
                       const ViewExtent& extent) const {
  Shot shot;
  shot.width = format.width > 0 ? format.width : extent.width;
  shot.height = format.height > 0 ? format.height : extent.height;
  shot.alpha = format.alpha;
  shot.stills = desk.window.stills;
  const double from = static_cast<double>(extent.width) / extent.height,
               to = static_cast<double>(shot.width) / shot.height;
  shot.camera = desk.window.camera;
  shot.camera.set(fitted(state.camera, from, to));
  shot.view = state.view;
  shot.section = state.section;
  shot.section.height *= std::max(1.0, from / to);
  // Discs and lines keep their part of the picture.
  const double factor = std::min(static_cast<double>(shot.width) / extent.width,
                                 static_cast<double>(shot.height) / extent.height);
  shot.pixel_scale = extent.pixel_scale * static_cast<float>(factor);
  shot.selection = desk.window.selection.picked;
  shot.mark = desk.window.selection.mark;
  return shot;
}

void Exporter::begin_figure(Exports& desk, const FigureRequest& request, const ViewExtent& extent) {
  SectionFigure figure;
  figure.section = desk.window.section;
  figure.view = desk.window.shown_view();
  figure.aspect = static_cast<double>(extent.width) / extent.height;
  figure.points = desk.window.run.scene ? input_points(*desk.window.run.scene) : nullptr;
  figure.scene = desk.window.run.scene;
  figure.other = desk.window.other_state;
  figure.xray = desk.probe.xray();
  figure.study = desk.probe.study();
  figure.delta = desk.window.run.scene ? desk.window.run.scene->delta : 0;
  figure.model =
      desk.window.run.scene && desk.window.run.scene->input ? desk.window.run.scene->input->name : "model";
  file_ = std::async(
      std::launch::async,
      [state = desk.window.state(), grid = desk.window.grid.grid(), figure, file = request.file]() -> Status {
        return write_text(file, section_svg(*state, grid.get(), figure));
      });
  stage_ = Stage::writing;
}

void Exporter::begin(Exports& desk, const ViewExtent& extent) {
  request_ = std::move(desk.wanted.front());
  desk.wanted.pop_front();
  desk.busy = true;
  desk.error.reset();
  frame_ = 0;
  const ViewState now{desk.window.camera.pose(), desk.window.shown_view(), desk.window.section};
  if (const auto* figure = std::get_if<FigureRequest>(&request_)) {
    begin_figure(desk, *figure, extent);
  } else if (const auto* picture = std::get_if<PictureRequest>(&request_)) {
    shot_ = shot_of(desk, picture->view.value_or(now), picture->format, extent);
    stage_ = Stage::drawing;
  } else if (const auto* sequence = std::get_if<SequenceRequest>(&request_)) {
    shot_ = shot_of(desk, now, sequence->format, extent);
    return_to_ = desk.window.transport.step();
    return_following_ = desk.window.transport.mode() == Transport::Mode::following;
    std::error_code error;
    fs::create_directories(sequence->folder, error);
    stage_ = Stage::drawing;
    if (error)
      fail(desk, {ErrorCode::io,
                  "The folder " + sequence->folder + " cannot be made: " + error.message() + ".", ""});
    else if (!sequence->film.empty() && !find_program("ffmpeg"))
      fail(desk, {ErrorCode::io, "A film needs the program ffmpeg, which is not on PATH.",
                  "Install ffmpeg, or write the frames alone."});
  }
}

void Exporter::draw(Exports& desk, Renderer& renderer) {
  Shot shot = shot_;
  const auto* sequence = std::get_if<SequenceRequest>(&request_);
  if (!picture_ && sequence != nullptr && sequence->kind == SequenceRequest::Kind::turntable)
    shot.camera.set(turned(shot_.camera.pose(), 2 * std::numbers::pi * static_cast<double>(frame_) /
                                                    static_cast<double>(sequence->frames)));
  if (sequence != nullptr && sequence->kind == SequenceRequest::Kind::steps) {
    const Step step = sequence->step(frame_);
    if (desk.window.transport.step() != step || desk.window.transport.moving()) {
      desk.window.transport.jump(step);
      desk.window.transport.pause();
      return;
    }
    if (!desk.window.settled || desk.window.state() == nullptr || desk.window.state()->step != step) return;
  }
  if (!picture_) picture_ = std::make_unique<TiledPicture>(std::move(shot));
  const auto complete = picture_->advance(renderer);
  if (!complete) return fail(desk, complete.error());
  if (*complete) write(desk, picture_->take());
}

/// The colour bar and the legend, where the view has them, in the bottom right corner.
void Exporter::add_key(const Exports& desk, Image& image) {
  KeptLegend legend;
  const SceneKey key = scene_key(desk.window, desk.maps, shot_.view, desk.probe.xray(), legend);
  if (key.empty()) return;
  const float scale = std::clamp(shot_.pixel_scale, 0.5f, 8.0f);
  if (!key_fonts_ || key_scale_ != scale) {
    key_fonts_ = std::make_unique<ImFontAtlas>();
    key_scale_ = scale;
    key_font_ = nullptr; // the old one went with its atlas
    const auto fonts = load_fonts(*key_fonts_, scale);
    if (!fonts) return desk.window.report(fonts.error());
    key_font_ = fonts->small;
  }
  if (key_font_ == nullptr) return;
  ImageCanvas canvas(image, *key_fonts_, *key_font_);
  const float margin = 10 * scale, room = static_cast<float>(image.height) - 2 * margin;
  const ImVec2 size = key_size(canvas, key, scale, room);
  draw_key(
      canvas, key,
      {static_cast<float>(image.width) - size.x - margin, static_cast<float>(image.height) - size.y - margin},
      scale, room, isoscope::palette(shot_.view.theme));
}

void Exporter::write(const Exports& desk, Image image) {
  picture_.reset();
  add_key(desk, image);
  fs::path file;
  if (const auto* sequence = std::get_if<SequenceRequest>(&request_))
    file = fs::path(sequence->folder) / frame_name(frame_);
  else if (const auto* picture = std::get_if<PictureRequest>(&request_))
    file = picture->file;
  file_ = std::async(std::launch::async,
                     [file, image = std::move(image)]() -> Status { return write_png(file, image); });
  stage_ = Stage::writing;
}

void Exporter::written(Exports& desk) {
  if (const Status status = file_.get(); !status) return fail(desk, status.error());
  if (const auto* picture = std::get_if<PictureRequest>(&request_)) {
    ++desk.pictures;
    return finish(desk, "The picture is written to " + picture->file + ".");
  }
  if (const auto* figure = std::get_if<FigureRequest>(&request_)) {
    ++desk.figures;
    return finish(desk, "The section is written to " + figure->file + ".");
  }
  const auto& sequence = std::get<SequenceRequest>(request_);
  ++desk.frames;
  stage_ = Stage::drawing;
  if (++frame_ < sequence.count()) return;
  if (sequence.film.empty())
    return finish(desk, grouped(frame_) + " frames are written to " + sequence.folder + ".");
  start_film(desk);
}

void Exporter::start_film(Exports& desk) {
  const auto& sequence = std::get<SequenceRequest>(request_);
  const auto ffmpeg = find_program("ffmpeg");
  if (!ffmpeg) return fail(desk, {ErrorCode::io, "The program ffmpeg is no longer on PATH.", ""});
  const fs::path folder = fs::absolute(sequence.folder);
  film_log_ = folder / "ffmpeg.log";
  // An even size is what the usual codec wants.
  auto started = ChildProcess::start(
      *ffmpeg,
      {"-y", "-loglevel", "error", "-framerate", std::to_string(sequence.rate), "-i",
       without_patterns(folder.string()) + "/frame_%04d.png", "-frames:v", std::to_string(sequence.count()),
       "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", fs::absolute(sequence.film).string()},
      film_log_);
  if (!started) return fail(desk, started.error());
  film_ = std::move(*started);
  stage_ = Stage::filming;
}

void Exporter::watch_film(Exports& desk) {
  const auto status = film_->poll();
  if (!status) return;
  const auto& sequence = std::get<SequenceRequest>(request_);
  if (*status != 0) {
    const std::string words = last_words(film_log_);
    return fail(desk, {ErrorCode::io, "ffmpeg could not make the film" + (words.empty() ? "." : ": " + words),
                       "The frames are in " + sequence.folder + "."});
  }
  ++desk.films;
  finish(desk, "The film is written to " + sequence.film + ".");
}

bool Exporter::advance(Exports& desk, Renderer& renderer, const ViewExtent& extent) {
  if (desk.cancel) {
    desk.wanted.clear();
    if (file_.valid() && file_.wait_for(at_once) != std::future_status::ready) return true;
    desk.cancel = false;
    file_ = {};
    if (stage_ != Stage::idle) finish(desk, "The export is cancelled.");
    return true;
  }
  if (stage_ == Stage::idle) {
    if (desk.wanted.empty() || extent.width <= 0 || extent.height <= 0 || !desk.window.state()) return false;
    if (desk.window.scripted && !desk.window.settled) return false;
    begin(desk, extent);
  } else if (stage_ == Stage::drawing) {
    draw(desk, renderer);
  } else if (stage_ == Stage::writing) {
    if (file_.wait_for(at_once) == std::future_status::ready) written(desk);
  } else {
    watch_film(desk);
  }
  if (stage_ == Stage::idle) return true;
  const double inner = picture_ ? picture_->part() : stage_ == Stage::writing ? 1 : 0;
  if (const auto* sequence = std::get_if<SequenceRequest>(&request_)) {
    const auto count = static_cast<double>(sequence->count());
    desk.part = (static_cast<double>(frame_) + (stage_ == Stage::filming ? 0 : inner)) / count;
    desk.doing = stage_ == Stage::filming
                     ? "ffmpeg makes the film"
                     : "frame " + grouped(frame_ + 1) + " of " + grouped(sequence->count());
  } else {
    desk.part = inner;
    desk.doing = stage_ == Stage::writing ? "writing the file" : "drawing the picture";
  }
  return true;
}

} // namespace isoscope
