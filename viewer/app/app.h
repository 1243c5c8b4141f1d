// The program: window, interface, renderer and model, and the loop that makes one frame after the other.
#pragma once

#include "app/app_model.h"
#include "app/imgui_layer.h"
#include "app/options.h"
#include "app/script.h"
#include "app/window_panes.h"
#include "export/exporter.h"

#include <memory>
#include <optional>

namespace isoscope {

class App {
 public:
  /// Opens the window and starts the run that the options ask for. Fails with device, usage or bad_input.
  static Result<std::unique_ptr<App>> create(const ProgramOptions& options);
  ~App();
  /// Runs until the window closes, the script ends or a signal asks for the end; the exit status.
  int run();
  /// Keeps the settings and tells everything under way to end, without waiting for it.
  void close();

 private:
  App() = default;
  Status setup(const ProgramOptions& options);
  void save();
  /// Ends the run and says so in one line: `cause` is a sentence. Settings are saved and a recording is
  /// closed.
  void end_because(const std::string& cause);
  void frame();
  void keys(CommandSink& commands);
  void run_commands(CommandSink& commands);
  void take_requests();
  void take_drops();
  void upload_thumbnails();
  /// Advances the script when the command before is done and shown; false when the program is to end.
  bool advance_script();
  bool at_rest() const;
  /// The script ends because of that.
  void fail_script(const Error& error);
  bool needs_frame(bool changed) const;
  /// The picture in the middle is not yet what it is to be.
  bool unfinished() const;

  std::unique_ptr<Window> window_;
  std::unique_ptr<ImguiLayer> imgui_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<AppModel> model_;
  std::unique_ptr<SceneView> scene_view_; ///< of the active run
  std::unique_ptr<RunViews> run_views_;
  std::unique_ptr<MosaicView> mosaic_view_;
  Exporter exporter_;
  std::optional<TimelinePane> timeline_;
  std::optional<Overlays> overlays_;
  std::optional<WindowPanes> panes_;
  std::optional<ScriptRunner> script_;
  std::filesystem::path settings_path_;
  double last_time_ = 0;
  double waits_since_ = 0; ///< real time at which the script's last command ran
  double hands_until_ = 0; ///< real time until which a script lets a person act
  double active_at_ = 0;   ///< when the last input arrived
  int frames_since_command_ = 0;
  int frames_owed_ = 3; ///< the interface settles over a few frames after an input
  int exit_status_ = 0;
  bool screenshot_only_ =
      false; ///< the command line asks for a picture: a run that fails is the program's failure
  std::string title_;
};

} // namespace isoscope
