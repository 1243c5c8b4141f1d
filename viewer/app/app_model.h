// Everything the window shows and steers, without the window: commands change it, panels read it, one update
// a frame.
#pragma once

#include "talk/bookmarks.h"
#include "two_runs/comparison.h"
#include "debug/debugger.h"
#include "model/event_filter.h"
#include "export/exports.h"
#include "ask/investigation.h"
#include "talk/moments.h"
#include "edge/probe.h"
#include "model/settings.h"
#include "model/shown_run.h"
#include "model/view_history.h"
#include "model/window_times.h"
#include "model/worker.h"
#include "questions/unlock_search.h"
#include "scene/camera.h"
#include "scene/renderer.h"
#include "scene/view_settings.h"

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// What lies over the window.
enum class Overlay : std::uint8_t { none, gallery, files, help, palette, about, bookmarks, pictures };

/// A line that tells the user something, with what to do about it.
struct Message {
  bool error = false;
  std::string text, remedy;
  double since = 0; ///< on the model's clock
};

/// A picture asked for; taken after the next frame at full quality.
struct ScreenshotRequest {
  std::string file;
  bool view_only = false; ///< the 3D view without the panels
};

/// A mouse position or button change that a script makes, one a frame; window units.
struct MouseStep {
  float x = 0, y = 0;
  int button = -1; ///< -1 none, 0 left, 1 right
  bool down = false;
  float wheel = 0;
  bool shift = false, control = false;
};

/// What commands ask of the program around the model.
struct WindowRequests {
  std::vector<ScreenshotRequest> screenshots;
  std::deque<MouseStep> mouse;
  std::optional<std::string> copy;
  double hands = 0; ///< seconds for which a script lets the real mouse and keys act
  bool paste = false, close = false;
  bool frame_selection = false, frame_all = false;
};

/// What is selected and hovered, and which kinds a pick may hit.
struct Selection {
  Pick picked, hovered;
  unsigned kinds = 15; ///< bit 0 vertices, 1 tetrahedra and facets, 2 samples, 3 edges
  /// An event of the journal whose edge is picked: its own moment is judged.
  std::optional<std::uint32_t> event;
  std::optional<Vec3> mark; ///< a witness that was asked for
  XrayTarget target = XrayTarget::automatic;
  std::optional<Vec3> what_if;                    ///< a target of the edge that is tried
  std::optional<std::uint32_t> candidate;         ///< of the X-ray, where that target is one
  std::optional<std::uint32_t> hovered_candidate; ///< its ghost is shown instead

  void pick(const Pick& other) {
    picked = other;
    event.reset();
    mark.reset();
    try_target({});
  }
  void try_target(std::optional<Vec3> at, std::optional<std::uint32_t> which = {}) {
    what_if = at;
    candidate = which;
    hovered_candidate.reset();
  }
};

/// The window before an audience: one scene, one sentence.
struct Presenter {
  bool on = false;
  bool slow_down = true; ///< playing dwells at moments
};

/// Searches what would unlock the edge of a request; null when cancelled or where the state has no such edge.
std::shared_ptr<const UnlockSearch> unlocks_of(const ProbeRequest& request, RunControl& control);

/// The active run, and all around it.
class AppModel : public ShownRun {
 public:
  /// `notify` is called from workers when something new is ready.
  explicit AppModel(std::function<void()> notify);

  // What is asked of the run and its past.
  Probe probe;
  Worker<ProbeRequest, UnlockSearch> unlocks; ///< what would make the picked collapse possible
  Investigation investigation;
  Debugger debug;
  Comparison comparison; ///< with the second run
  RunParameters draft;   ///< what the parameter panel shows: asked for when applied
  double wait_until = 0; ///< scripts: seconds on the clock until which `wait SECONDS` holds
  enum class Wait : std::uint8_t { time, answers, settled };
  Wait wait_for = Wait::time; ///< scripts: what `wait` waits for

  // The view.
  ViewSettings view;
  Camera camera;
  Renderer::SectionView section;
  bool section_set = false; ///< a person or a script has chosen the section's place
  Selection selection;
  EventFilter filter;     ///< of the event list
  bool plot_time = false; ///< plots over seconds instead of steps
  bool blinking = false;  ///< before and after of the operation in turn
  ViewHistory history;    ///< undo of view, filter, selection and layout
  bool dragging = false;  ///< a mouse button is held: what it changes is one entry of the history
  Bookmarks bookmarks;
  std::filesystem::path bookmarks_home; ///< the settings file; empty: bookmarks are not kept
  Moments moments;
  Presenter presenter;
  Settings settings;
  Overlay overlay = Overlay::none;
  bool files_beside = false; ///< what is chosen among the files opens beside the run
  std::deque<Message> messages;
  WindowRequests requests;
  Exports exports;                   ///< pictures, figures and films
  std::array<float, 4> scene_area{}; ///< where the 3D view lies in the window: low x, y, width, height
  double clock = 0;                  ///< seconds since the start
  WindowTimes times;
  bool scripted = false;             ///< no easing, nothing remembered, following is immediate
  std::string failed_expectation;

  /// Starts a run of a file or gallery:NAME with the draft's parameters; a gallery model brings its own δ, a
  /// recording (.isorun) all its parameters.
  void open(const std::string& input, bool paused = false);
  /// Runs again from the beginning with the draft's parameters.
  void restart();
  /// Goes on with the draft's parameters.
  Status apply();
  /// Whether the draft differs from what the run was asked, and whether that needs a restart.
  bool draft_differs() const;
  bool draft_needs_restart() const;

  /// Tells everything that runs or is asked to end, and waits for nothing.
  void abandon();
  void report(const Error& error);
  void tell(std::string text);

  /// What undo would bring back of the present window, and bringing it back.
  ViewMemento memento() const;
  void take(const ViewMemento& memento);
  /// Writes the bookmarks beside the input, or where they are kept otherwise; tells what fails.
  void keep_bookmarks();

  /// Once a frame: takes what the workers have, moves the play head, asks for what is missing. True when
  /// something changed.
  bool update(double seconds);
  /// The view as it is drawn and picked: what hides a selected edge steps back, and so do samples once they
  /// are no longer asked.
  ViewSettings shown_view() const;
  /// The X-ray of the picked edge at the state shown; null while it is made and where there is none.
  std::shared_ptr<const EdgeXray> xray() const;
  /// What the target that is tried would do; null while it is made and where none is.
  std::shared_ptr<const TargetStudy> study() const;
  /// What unlocks the picked edge at the state shown; null where nobody asked or it is not known yet.
  std::shared_ptr<const UnlockSearch> unlock_search() const;
  /// Asks for it.
  Status search_unlocks();
  /// Begins a run at the state shown with the edge collapsed to the target that is tried.
  Status branch_here();
  /// Begins a run of the same input with the draft's parameters beside this one; the draft is this run's
  /// again.
  Status run_beside();
  /// Opens a model with the draft's parameters, or a recording, beside this run.
  Status open_beside(const std::string& input);
  /// Makes the other run the active one.
  Status change_run();
  /// Ends the run that is not active; one view is left.
  void close_other();
  /// The event that the selection speaks of at the step shown, if any.
  std::optional<std::uint32_t> selected_event() const;
  /// Bytes of the journal and of the play head's keyframes in memory, what they may take together, and the
  /// bytes of the journal that are on the disk.
  struct HistoryMemory {
    std::size_t journal = 0, keyframes = 0, limit = 0, disk = 0;
    std::size_t bytes() const { return journal + keyframes; }
  };
  HistoryMemory history_memory() const;
  /// Bytes that one run may take of it.
  std::size_t history_share() const;
  /// The state shown is the one the play head asks for and nothing is under way that would change it.
  bool state_is_current() const;
  /// Every worker has answered, and the answers are the ones shown.
  bool answers_taken() const {
    return result_taken() && probe.idle() && unlocks.idle() && investigation.idle() && comparison.at_rest();
  }
  /// The live preview for the draft, absent while it is computed.
  std::optional<ViolationPreview> draft_preview() const;
  /// The draft as criteria, in the units of the present scene.
  CriteriaParameters draft_criteria() const;

 private:
  void take_run();
  /// Drops what was asked, selected and remembered of the run that was active.
  void forget_run();
  void show_second(std::unique_ptr<ShownRun> second);
  void take_recording();
  void request_xray();
  void blink();
  void place_view();
  void watch_view();
  void fetch_bookmarks();
  bool clip_placed_ = false;                  ///< by the program, in this update
  BookmarkFiles bookmark_files_;              ///< of the run that is open
  std::filesystem::path bookmarks_recording_; ///< the recording they belong to, if any
  bool bookmarks_told_ = false;               ///< that they cannot lie beside it
  void watch_history();
  std::function<void()> notify_;
  std::uint64_t framed_generation_ = 0;
  std::optional<ProbeRequest> xray_asked_;
  std::optional<CriteriaParameters> preview_asked_;
  std::shared_ptr<const StateSnapshot> preview_state_;
  /// The genus that the active run's Z should have, NaN where nothing is known; the run's thread asks it.
  std::shared_ptr<std::atomic<double>> expected_genus_;
  std::string error_seen_, recording_error_seen_;
  std::uint64_t draft_generation_ = 0; ///< the recording whose parameters the draft has taken
  std::uint64_t history_warned_ = 0;   ///< the run whose journal was found too large
};

} // namespace isoscope
