// What all features of the window share: the run that is shown, how it is looked at, what is selected, and
// what is told and asked around it.
#pragma once

#include "model/event_filter.h"
#include "model/settings.h"
#include "model/shown_run.h"
#include "model/view_history.h"
#include "questions/edge_xray.h"
#include "scene/camera.h"
#include "scene/renderer.h"
#include "scene/view_settings.h"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// What lies over the window.
enum class Overlay : std::uint8_t {
  none,
  gallery,
  files,
  help,
  palette,
  about,
  bookmarks,
  pictures,
  lessons,
  welcome
};

/// What is done with what is chosen among the files.
enum class FilesFor : std::uint8_t { open, beside, between };

/// A line that tells the user something, with what to do about it.
struct Message {
  bool error = false;
  std::string text, remedy;
  double since = 0;                            ///< on the window's clock
  unsigned times = 1;                          ///< it was told, the same words again
  static constexpr double shown = 8, fade = 1; ///< seconds; what is no error goes away by itself
  /// In [0, 1]: how solid it is drawn.
  float strength(double clock) const;
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

/// What commands ask of the program around the window's state.
struct WindowRequests {
  std::vector<ScreenshotRequest> screenshots;
  std::deque<MouseStep> mouse;
  std::optional<std::string> copy;
  double hands = 0; ///< seconds for which a script lets the real mouse and keys act
  bool paste = false, close = false;
  bool frame_selection = false;
  bool all_lanes = false; ///< room for every lane of the timeline
};

/// What is selected and hovered, and which kinds a pick may hit.
struct Selection {
  Pick picked, hovered;
  PickKinds kinds = PickKinds::all;
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

/// Answers of the inspector that are brought into sight once they are there.
enum class AnswerKind : std::uint8_t { none, unlock, advice, what_if, certificate, topology, check };
std::string_view name(AnswerKind answer);

/// Which one is waited for, and which one flashes because it has come.
struct AnswerInSight {
  AnswerKind wanted = AnswerKind::none, shown = AnswerKind::none;
  bool awaited = false;                ///< where it will come was scrolled to already
  double since = -1e9;                 ///< on the window's clock
  static constexpr double flash = 1.2; ///< seconds
};

/// How deep one steps.
enum class DebugLevel : std::uint8_t {
  stage,
  operation, ///< attempts: operations, and edges or tetrahedra that could not be served
  gate       ///< the checks of a collapse, or the sweeps of a repair
};

/// Where one stands in the tree of stages, operations and gates.
struct StepPlace {
  DebugLevel level = DebugLevel::operation;
  std::size_t gate = 0;
  std::optional<std::uint32_t> gate_event; ///< whose gates are stepped through
  bool at_gate(std::size_t which) const { return level == DebugLevel::gate && gate == which; }
};

/// What going on with the panel's parameters would take.
struct Forecast {
  Step from = 0;      ///< the step at which it begins
  double seconds = 0; ///< to the end of the run, as far as the present one tells
  friend bool operator==(const Forecast&, const Forecast&) = default;
};

/// The window before an audience: one scene, one sentence.
struct Presenter {
  bool on = false;
  bool slow_down = true; ///< playing dwells at moments
};

/// Who shows another layout for a while than the one that is kept.
enum class LayoutGuest : std::uint8_t { lesson = 1, two_views = 2 };

/// The pane that arrows, Enter and letters go to instead of being the window's own.
enum class PaneOfKeys : std::uint8_t { none, left, right, bottom };

/// The active run, and how the window looks at it. Features keep a reference to it; plain settings are
/// changed in place.
class WindowState : public ShownRun {
 public:
  using ShownRun::ShownRun;

  RunParameters draft; ///< what the parameter panel shows: asked for when applied
  std::shared_ptr<const StateSnapshot> other_state; ///< of the run beside this one, where there is one
  /// At the state shown, under the draft; null where that is what the run has.
  std::shared_ptr<const ViolationPreview> would_violate;
  std::optional<Forecast> forecast; ///< for the draft; absent where it would change nothing

  // The view.
  ViewSettings view;
  Camera camera;
  Renderer::SectionView section;
  bool section_set = false; ///< a person or a script has chosen the section's place
  Selection selection;
  ListFilter filter;             ///< of the event list
  EventSort event_sort;          ///< and its order
  std::optional<StepSpan> range; ///< limits lanes, plots, lists and maps
  StepPlace place;
  std::optional<double> preview_delta; ///< Ω is drawn at this tolerance instead of the run's; absolute
  bool plot_time = false;              ///< plots over seconds instead of steps
  bool blinking = false;               ///< before and after of the operation in turn
  bool warnings_open = false;          ///< the chip of warnings shows them in full
  ViewHistory history;                 ///< undo of view, filter, selection and layout
  bool dragging = false; ///< a mouse button is held: what it changes is one entry of the history
  Presenter presenter;
  AnswerInSight answer;
  PaneOfKeys pane_of_keys = PaneOfKeys::none;
  bool keys_moved = false;    ///< to another pane since the last frame
  std::string open_menu;      ///< asked for by a key: opened in the next frame
  std::string menu;           ///< that is open
  float inspector_scroll = 0; ///< pixels; told by the inspector
  Pick inspected;             ///< what it told of in the last frame, and of which event
  std::optional<std::uint32_t> inspected_event;
  bool inspected_end = false; ///< it was asked about at the end of the run

  // The window.
  Settings settings;
  Overlay overlay = Overlay::none;
  FilesFor files_for = FilesFor::open;
  std::string first_wall; ///< chosen among the files, while the other one is looked for
  std::deque<Message> messages;
  WindowRequests requests;
  std::array<float, 4> scene_area{}; ///< where the 3D view lies in the window: low x, y, width, height
  int stills = 8;        ///< frames that are averaged in pictures and where a view rests, at least 1
  double clock = 0;      ///< seconds since the start
  bool scripted = false; ///< no easing, nothing remembered, following is immediate
  /// A run has begun of which a scene is to be made: until then nothing of it is shown.
  bool scene_awaited = false;
  /// After the last update: the state shown is the one asked for, and nothing under way would change it.
  bool settled = false;

  void report(const Error& error);
  void tell(std::string text);
  /// Lays it over the window, or takes it away where it lies there.
  void toggle(Overlay which);
  void open_tab(BottomTab tab);
  /// From now on the panes of the settings are only what is shown: the layout that was there stays the one
  /// that is kept, until the last guest has left. A guest that is there already changes nothing.
  void lend_layout(LayoutGuest guest);
  void end_loan(LayoutGuest guest);
  /// The first layout, also where another one is kept meanwhile.
  void reset_layout();
  bool has_guest(LayoutGuest guest) const { return (guests_ & static_cast<unsigned>(guest)) != 0; }
  /// The layout that is remembered between sessions.
  const PaneLayout& kept_layout() const { return kept_layout_ ? *kept_layout_ : settings.panes; }
  /// Asks the mouse to drag what appears at a place in the scene by so many pixels; false where it is not in
  /// sight.
  bool drag_in_scene(Vec3 point, float dx, float dy);
  /// Opens the inspector, which brings the answer into sight.
  void bring_into_sight(AnswerKind which);

  /// The clip goes to the middle of the model.
  void center_clip();
  /// The whole model is seen, by camera and section, also as panes come and go, until somebody moves them.
  void frame_all();
  /// What undo would bring back of the present window, and bringing it back.
  ViewMemento memento() const;
  void take(const ViewMemento& memento);
  /// Shows a stored view; the theme stays.
  void show(const ViewState& state);
  /// The view as it is drawn and picked: what hides a selected edge steps back, and so do samples once they
  /// are no longer asked.
  ViewSettings shown_view() const;
  /// The tolerances at which Ω can be shown: what the grid of the scene holds, within what was studied.
  std::optional<std::array<double, 2>> preview_range() const;
  /// The event that the selection speaks of at the step shown, if any.
  std::optional<std::uint32_t> selected_event() const;

  /// Whether the input is all there is to see yet: its run is being prepared, a scene that is prepared is not
  /// made yet, or Ω is not filled that is shown alone.
  bool input_alone() const;

  bool has_run() const { return run.journal != nullptr; }
  bool has_state() const { return state() != nullptr; }

 private:
  void add(Message message);
  std::optional<PaneLayout> kept_layout_; ///< while there are guests
  unsigned guests_ = 0;                   ///< as bits
};

} // namespace isoscope
