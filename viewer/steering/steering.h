// Opening, restarting and recording runs, and going on with other parameters.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "debug/debugger.h"
#include "mosaic/mosaic.h"
#include "steering/apply_plan.h"
#include "steering/wall_order.h"
#include "two_runs/comparison.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

struct ImVec2;

namespace isoscope {

struct Ui;
struct HistoryMemory;

class Steering {
 public:
  /// `notify` is called from the worker that tells walls apart.
  Steering(Debugger& debugger, Comparison& comparison, Mosaic& mosaic, const std::function<void()>& notify)
      : window(debugger.window), debug(debugger), runs(comparison), tiles(mosaic), walls_(notify) {}

  WindowState& window;
  Debugger& debug;
  Comparison& runs;
  Mosaic& tiles;

  /// Starts a run of a file or gallery:NAME with the draft's parameters; a gallery model brings its own δ,
  /// points ask for theirs to be found, a recording (.isorun) all its parameters. `inside`: the inner one of
  /// two surfaces between which Ω lies. A folder of tiles is shown. Fails as open_tiles().
  Status open(const std::string& input, bool paused = false, const std::string& inside = {});
  /// Shows a copy of a recording that grows on another machine, and goes on as more of it comes.
  void follow(const std::string& copy);
  /// Starts a run of what lies between two closed surfaces, once it is known which is the outer one.
  void open_between(const std::string& one, const std::string& other, bool paused = false);
  /// Shows a folder of tiles instead of the run. Fails as TileFolder::open().
  Status open_tiles(const std::string& folder);
  /// Starts a run with the draft as it is, or shows the folder of tiles that its input is; `follow`: where it
  /// is a recording, as a copy that grows elsewhere, which one on a network's file system is always. Fails as
  /// open_tiles().
  Status begin(bool paused = false, bool follow = false);
  bool idle() const { return walls_.idle(); }
  /// Begins the end of what is asked, and waits for nothing.
  void abandon() { walls_.abandon(); }
  /// Runs again from the beginning with the draft's parameters.
  Status restart();
  /// Goes on with the draft's parameters from the step shown: the run itself at its live end, else a branch
  /// of it. Refused with the plan's error.
  Status apply();
  /// Branches at the last step at which what was changed matters.
  Status apply_earlier();
  /// Puts a number or a text into the draft as if it were typed: out of its range, too.
  Status type_parameter(const std::string& parameter, const std::string& text);
  ApplyPlan plan() const { return plan_apply(window); }
  /// Whether the draft differs from what the run has at the step shown.
  bool draft_differs() const;
  /// The live preview for the draft, null while it is computed.
  std::shared_ptr<const ViolationPreview> draft_preview() const;

  /// Once a frame: takes the parameters of a recording that was opened, tells what failed, asks for the
  /// preview.
  void take_run();
  void ask_preview();
  /// Of a run that is not shown any more.
  void forget();

  void add_file_commands(CommandTable& table);
  void add_recording_commands(CommandTable& table);
  void add_run_commands(CommandTable& table);
  void add_tolerance_commands(CommandTable& table);
  void add_parameter_commands(CommandTable& table);
  void add_parameter_values(NamedValues& values);
  void add_plan_values(NamedValues& values);
  void add_tolerance_values(NamedValues& values);
  void add_recording_values(NamedValues& values);

 private:
  /// The draft as criteria, in the units of the present scene.
  CriteriaParameters draft_criteria() const;
  /// Refused where the input itself tells what the parameter would be.
  Status may_set(const std::string& parameter) const;
  void take_walls();
  /// Opens the recording of a tile that is made once more, and looks at the tile.
  void show_tile(const TileRerun& rerun);
  WallOrder walls_;
  bool walls_paused_ = false;
  std::optional<CriteriaParameters> preview_asked_;
  std::shared_ptr<const StateSnapshot> preview_state_;
  std::shared_ptr<const StateSnapshot> marked_state_; ///< whose ids `would_violate` has
  std::uint64_t draft_generation_ = 0;                ///< the recording whose parameters the draft has taken
  std::string error_seen_, recording_error_seen_;
};

/// From step to step.
void add_transport_commands(CommandTable& table, WindowState& window);
/// To a step, and how fast.
void add_pace_commands(CommandTable& table, WindowState& window);

/// Of the run, the state and the selection.
void add_run_values(NamedValues& values, const WindowState& window);

namespace panels {

/// Menus, the model and δ, stage chips, transport, LIVE; of tiles the menus and the folder.
void top_bar(Ui& ui, const Mosaic& mosaic);
/// The left pane's section of the parameters, but for those below.
void parameters(Ui& ui);
/// What stays in sight below the left pane: α, σ and shrink, what would violate, what Apply would do, the
/// buttons. Its height in pixels, and the content.
float parameters_foot_height(const Ui& ui);
void parameters_foot(Ui& ui, const Steering& steering);
/// The line at the bottom, and the messages over the view.
void status_bar(Ui& ui, const HistoryMemory& memory);
void messages(Ui& ui, ImVec2 low, float width);

} // namespace panels

} // namespace isoscope
