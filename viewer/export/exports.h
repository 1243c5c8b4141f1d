// Pictures, figures and films that commands ask for, and how far they are; the program makes them.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "edge/probe.h"
#include "model/window_state.h"
#include "view/zero_maps.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>

namespace isoscope {

/// Size and ground of pictures.
struct PictureFormat {
  int width = 0, height = 0; ///< 0: the view's
  bool alpha = false;        ///< without ground
};
constexpr int picture_least = 16, picture_most = 16384; ///< of a side, pixels
/// Whether both sides of a format are of that range.
constexpr bool is_possible(const PictureFormat& f) {
  const auto fits = [](int side) { return side >= picture_least && side <= picture_most; };
  return fits(f.width) && fits(f.height);
}
/// "800x600": into the sides of a format; false where it is no size.
bool read_size(const std::string& word, PictureFormat& format);

/// The view as one PNG.
struct PictureRequest {
  std::string file;
  PictureFormat format;
  std::optional<ViewState> view; ///< instead of the window's
};
/// The section as SVG.
struct FigureRequest {
  std::string file;
};
/// Frames of a turn about the up axis, or of steps, as frame_0001.png ... in a folder.
struct SequenceRequest {
  enum class Kind : std::uint8_t { turntable, steps };
  Kind kind = Kind::turntable;
  std::string folder;
  PictureFormat format;
  std::size_t frames = 0;           ///< of a turntable
  Step from = 0, to = 0, every = 1; ///< of steps; both ends are shown
  std::string film;                 ///< an MP4 to be made of them; empty: none
  int rate = 25;                    ///< of the film, frames a second
  std::size_t count() const { return kind == Kind::turntable ? frames : (to - from + every - 1) / every + 1; }
  Step step(std::size_t frame) const {
    return static_cast<Step>(std::min<std::size_t>(from + frame * every, to));
  }
};
using ExportRequest = std::variant<PictureRequest, FigureRequest, SequenceRequest>;

/// The desk where commands leave what they want and the exporter tells how far it is.
struct Exports {
  Exports(WindowState& shared, const EdgeProbe& looking, const ZeroMaps& colours)
      : window(shared), probe(looking), maps(colours) {}

  WindowState& window;
  const EdgeProbe& probe; ///< the edge at hand is in figures
  const ZeroMaps& maps;   ///< the colour bar is in pictures
  std::deque<ExportRequest> wanted;
  bool cancel = false; ///< asked: what is under way and what waits is dropped
  // Told by the exporter.
  bool busy = false;
  std::string doing;                                            ///< "frame 12 of 120"
  double part = 0;                                              ///< done, in [0, 1]
  std::size_t pictures = 0, figures = 0, frames = 0, films = 0; ///< written since the start
  std::optional<Error> error;                                   ///< of the last request that failed
  bool pending() const { return busy || !wanted.empty(); }

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);
};

} // namespace isoscope
