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

  /// The moment that is told at the step shown: the one that playing dwells for, or that a slide turned to.
  const TalkMoment* moment() const;
  /// Shows the next moment (direction 1) or the one before (-1), with what it speaks of selected.
  void turn_to_moment(int direction);

  /// What the presenter mode says: of the chosen event, of the moment, of the operation that led to the state
  /// shown or of all those like it before, or of what the program waits for.
  std::string caption() const;
  /// Why that matters: a second sentence, which may be empty.
  std::string caption_why() const;
  /// "Figure 7" of the paper; empty where it has none.
  std::string caption_figure() const;
  /// The event that the caption speaks of; null where there is none. It lives as long as the state shown.
  const Event* caption_event() const;

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);

 private:
  void show_moment(const TalkMoment& moment);
  /// How many operations of one kind, for one condition, in one stage end with the one that led here.
  std::uint32_t alike() const;
  Moments moments_;
  std::optional<std::size_t> turned_;  ///< the moment that a slide turned to
  std::optional<std::size_t> dwelled_; ///< the one that playing showed last
  BookmarkFiles files_;                ///< of the run that is open
  std::filesystem::path recording_;    ///< that they belong to, if any
  bool told_ = false;                  ///< that they cannot lie beside it
};

namespace panels {

/// The sentences of the step shown, and where in the run it is; made once a frame.
class PresenterBar {
 public:
  /// `width` is that of its pane.
  PresenterBar(const Ui& ui, const Talk& talk, float width);
  /// How high its pane has to be, so that all of the sentences stand in it.
  float height(const Ui& ui) const;
  /// Fills the pane it is in.
  void draw(const Ui& ui) const;

 private:
  const Talk& talk_;
  std::string what_, why_, place_; ///< as lines
  float text_x_ = 0, place_x_ = 0, what_high_ = 0, why_high_ = 0;
};
/// Stage and figure over the view, and what the marks in it mean; returns where it ends below.
float presenter_legend(const Ui& ui, const Talk& talk, ImVec2 low);
/// Number and note of the bookmark that is shown, over the view; `low` is the view's corner.
void slide_title(const Ui& ui, const Bookmarks& bookmarks, ImVec2 low, float width);

} // namespace panels

} // namespace isoscope
