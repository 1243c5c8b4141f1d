// Commands that write pictures, figures and films.
#include "export/exports.h"

#include "command/commands.h"
#include "model/words.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace isoscope {
namespace {

/// What the words of a call say, whatever their order; the rest is told by its place.
struct Words {
  PictureFormat format;
  std::string view, film;
  int rate = 25;
  std::vector<std::string> rest;
};

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() > end.size() && text.ends_with(end);
}

Result<Words> read_words(const Arguments& arguments) {
  Words words;
  for (const std::string& word : arguments) {
    PictureFormat size;
    int rate = 0, used = 0;
    if (read_size(word, size)) {
      if (!is_possible(size))
        return wrong_arguments("A picture's sides have from " + std::to_string(picture_least) + " to " +
                               std::to_string(picture_most) + " pixels, not " + word + ".");
      words.format.width = size.width;
      words.format.height = size.height;
    } else if (word == "alpha") {
      words.format.alpha = true;
    } else if (std::sscanf(word.c_str(), "%dfps%n", &rate, &used) == 1 &&
               static_cast<std::size_t>(used) == word.size()) {
      if (rate < 1 || rate > 240) return wrong_arguments("A film has from 1 to 240 frames a second.");
      words.rate = rate;
    } else if (ends_with(word, ".json")) {
      words.view = word;
    } else if (ends_with(word, ".mp4")) {
      words.film = word;
    } else {
      words.rest.push_back(word);
    }
  }
  if (words.format.alpha && !words.film.empty()) return wrong_arguments("An MP4 has no transparent ground.");
  return words;
}

std::string file_for(const Exports& m, const char* end) {
  const std::string name =
      m.window.run.scene && m.window.run.scene->input ? m.window.run.scene->input->name : "model";
  return name + "-step-" + std::to_string(m.window.transport.step()) + end;
}

Status write_picture(Exports& m, const Arguments& a) {
  const auto words = read_words(a);
  if (!words) return words.error();
  if (words->rest.size() > 1 || !words->film.empty()) return wrong_arguments("One file is written.");
  PictureRequest request{words->rest.empty() ? file_for(m, ".png") : words->rest[0], words->format, {}};
  if (!words->view.empty()) {
    std::ifstream in(words->view);
    if (!in) return Error{ErrorCode::io, "The view " + words->view + " cannot be read.", ""};
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    request.view = view_from_json(text, {m.window.camera.pose(), m.window.shown_view(), m.window.section});
    if (!request.view) return Error{ErrorCode::bad_input, words->view + " is no view.", ""};
  }
  m.wanted.emplace_back(std::move(request));
  return {};
}

Status write_svg(Exports& m, const Arguments& a) {
  if (a.size() > 1) return wrong_arguments("One file is written.");
  m.wanted.emplace_back(FigureRequest{a.empty() ? file_for(m, ".svg") : a[0]});
  return {};
}

constexpr std::size_t most_frames = 100000;

Result<std::size_t> frame_count(const std::string& text, std::size_t least) {
  const auto n = read_number<std::size_t>(text);
  if (!n || *n < least || *n > most_frames)
    return wrong_arguments("\"" + text + "\" is not a count from " + std::to_string(least) + " to 100,000.");
  return *n;
}

Result<SequenceRequest> sequence(const Words& words) {
  if (words.rest.empty()) return wrong_arguments("The folder for the frames is missing.");
  if (!words.view.empty()) return wrong_arguments("Frames are drawn as the window is.");
  SequenceRequest request;
  request.folder = words.rest[0];
  request.format = words.format;
  request.film = words.film;
  request.rate = words.rate;
  return request;
}

Status write_turntable(Exports& m, const Arguments& a) {
  const auto words = read_words(a);
  if (!words) return words.error();
  auto request = sequence(*words);
  if (!request) return request.error();
  const auto frames = frame_count(words->rest.size() > 1 ? words->rest[1] : "120", 2);
  if (!frames) return frames.error();
  request->frames = *frames;
  m.wanted.emplace_back(std::move(*request));
  return {};
}

Status write_step_frames(Exports& m, const Arguments& a) {
  const auto words = read_words(a);
  if (!words) return words.error();
  auto request = sequence(*words);
  if (!request) return request.error();
  request->kind = SequenceRequest::Kind::steps;
  if (words->rest.size() < 3) return wrong_arguments("The first and the last step are missing.");
  std::array<std::size_t, 3> n{0, 0, 1};
  for (std::size_t i = 0; i < 3 && i + 1 < words->rest.size(); ++i) {
    if (i == 1 && words->rest[2] == "end") {
      n[1] = m.window.live_step();
      continue;
    }
    const auto value = whole_argument(words->rest, i + 1, i == 2 ? 1 : 0);
    if (!value) return wrong_arguments("\"" + words->rest[i + 1] + "\" is no step.");
    n[i] = *value;
  }
  if (n[0] > n[1] || n[1] > m.window.live_step())
    return wrong_arguments("The steps go upwards and end at " + grouped(m.window.live_step()) + " at most.");
  request->from = static_cast<Step>(n[0]);
  request->to = static_cast<Step>(n[1]);
  request->every = static_cast<Step>(n[2]);
  if (request->count() > most_frames) return wrong_arguments("These are more than 100,000 frames.");
  m.wanted.emplace_back(std::move(*request));
  return {};
}

} // namespace

bool read_size(const std::string& word, PictureFormat& format) {
  int used = 0;
  return std::sscanf(word.c_str(), "%dx%d%n", &format.width, &format.height, &used) == 2 &&
         static_cast<std::size_t>(used) == word.size();
}

void Exports::add_commands(CommandTable& table) {
  const auto has_state = [this] { return window.has_state(); };
  add_group(
      table, {.menu = "File", .enabled = has_state},
      {{.name = "pictures",
        .title = "Pictures and films…",
        .help = "Chooses size and ground of pictures and films and writes them.",
        .icon = icon::camera,
        .keys = {{GLFW_KEY_F12, true}},
        .run = does([this] { window.toggle(Overlay::pictures); })},
       {.name = "picture",
        .title = "Picture of the view",
        .usage = "[FILE] [WIDTHxHEIGHT] [alpha] [VIEW.json]",
        .help = "Writes the view without panels as PNG at any size; alpha leaves the ground transparent.",
        .icon = icon::camera,
        .keys = {{GLFW_KEY_F12, false, true}},
        .run = on(*this, write_picture)},
       {.name = "svg",
        .title = "Section as SVG",
        .usage = "[FILE]",
        .help = "Writes the 2D section as a vector figure with scale and caption.",
        .icon = icon::disk,
        .run = on(*this, write_svg)}});
  table.add(
      {{.name = "turntable",
        .title = "Turntable",
        .usage = "FOLDER [FRAMES] [WIDTHxHEIGHT] [alpha] [FILM.mp4] [25fps]",
        .help = "Writes frames of a turn about the up axis, and a film of them where ffmpeg is there.",
        .run = on(*this, write_turntable),
        .enabled = has_state},
       {.name = "step-frames",
        .title = "Frames of steps",
        .usage = "FOLDER FROM TO|end [EVERY] [WIDTHxHEIGHT] [alpha] [FILM.mp4] [25fps]",
        .help =
            "Writes a frame of each step, or of every so manyth, and a film of them where ffmpeg is there.",
        .run = on(*this, write_step_frames),
        .enabled = has_state},
       {.name = "cancel-export",
        .title = "Cancel the export",
        .help = "Drops the picture or film that is being made and those that wait.",
        .menu = "File",
        .icon = icon::close,
        .run = does([this] { cancel = true; }),
        .enabled = [this] { return pending(); }}});
}

} // namespace isoscope
