// What a talk is made of: bookmarks of the run as slides, the moments at which playing dwells, the sentence
// of the step shown.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "model/window_state.h"
#include "talk/bookmarks.h"
#include "talk/moments.h"

#include <filesystem>
#include <string>

struct ImVec2;

namespace isoscope {

struct Ui;

class Talk {
 public:
  explicit Talk(WindowState& shared) : window(shared) {}

  WindowState& window;
  Bookmarks bookmarks;
  std::filesystem::path bookmarks_home; ///< the settings file; empty: bookmarks are not kept

  /// Once a frame: looks for the run's moments, lets playing dwell at them.
  void update();
  /// Takes the bookmarks that are kept of the run shown.
  void fetch_bookmarks();
  /// Writes them beside the input, or where they are kept otherwise; tells what fails.
  void keep_bookmarks();
  const Moments& moments() const { return moments_; }

  /// What the presenter mode says: of the chosen event, of the operation that led to the state shown, or of
  /// what the program waits for.
  std::string caption() const;
  /// The event that the caption speaks of; null where there is none. It lives as long as the state shown.
  const Event* caption_event() const;

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);

 private:
  Moments moments_;
  BookmarkFiles files_;             ///< of the run that is open
  std::filesystem::path recording_; ///< that they belong to, if any
  bool told_ = false;               ///< that they cannot lie beside it
};

namespace panels {

/// The sentence of the step shown, and where in the run it is.
void presenter_bar(Ui& ui, const Talk& talk);
/// Number and note of the bookmark that is shown, over the view; `low` is the view's corner.
void slide_title(const Ui& ui, const Bookmarks& bookmarks, ImVec2 low, float width);

} // namespace panels

} // namespace isoscope
