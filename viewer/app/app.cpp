// One frame, and when the next one is due.
#include "app/app.h"

#include "app/last_wait.h"
#include "app/welcome.h"
#include "input/gallery.h"
#include "model/chosen_input.h"
#include "platform/endings.h"
#include "platform/image_file.h"
#include "steering/steering.h"

#include <GLFW/glfw3.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace isoscope {
namespace {

constexpr int frames_after_input = 3;
constexpr int stopped_status = 4,
              lost_status = 2;           ///< as when the batch program is stopped; without a display
constexpr double script_step = 1.0 / 60; ///< scripts see an even clock
constexpr double pointer_seconds = 1;    ///< a pointer rests before it goes, presenting
constexpr double hover_seconds = 1.2;    ///< after the last input, for hovers and tooltips that come late
constexpr double idle_wait = 0.25, running_wait = 0.03, script_wait = 0.005;

} // namespace

Result<std::unique_ptr<App>> App::create(const ProgramOptions& options) {
  std::unique_ptr<App> app(new App());
  if (Status s = app->setup(options); !s) return s.error();
  return app;
}

Status App::setup(const ProgramOptions& options) {
  model_ = std::make_unique<AppModel>([] { Window::wake(); });
  AppModel& m = *model_;
  std::vector<ScriptLine> lines;
  if (!options.script.empty()) {
    auto read = read_script(m.commands, options.script);
    if (!read) return read.error();
    lines = std::move(*read);
  }
  screenshot_only_ = !options.screenshot.empty();
  if (screenshot_only_) {
    lines.push_back({0, {"wait", {"settled"}}});
    for (const CommandCall& call : picture_calls(options)) lines.push_back({0, call});
    lines.push_back({0, {"quit", {}}});
  }
  auto window = Window::open("Isoscope", options.window_size());
  if (!window) return window.error();
  window_ = std::move(*window);
  auto imgui = ImguiLayer::create(*window_);
  if (!imgui) return imgui.error();
  imgui_ = std::move(*imgui);
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();
  renderer_ = std::move(*renderer);

  m.scripted = !lines.empty();
  if (m.scripted)
    script_.emplace(std::move(lines));
  else
    settings_path_ = settings_file();
  if (!settings_path_.empty()) m.settings = load_settings(settings_path_);
  if (m.scripted) m.settings.coach_closed = panels::all_coach_marks; // a script asks for them
  m.talk.bookmarks_home = settings_path_;
  m.view.theme = options.theme.value_or(m.settings.theme);
  if (options.ui_scale > 0) m.settings.ui_scale = options.ui_scale / window_->content_scale();
  scene_view_ = std::make_unique<SceneView>(*renderer_, m.probe, m.investigation, m.zero_maps);
  run_views_ = std::make_unique<RunViews>(*scene_view_, m.comparison);
  timeline_.emplace(m.debug, m.talk, m.investigation, m.comparison);
  overlays_.emplace(m);
  m.values.add("gallery.ready", "whether every model of the gallery has its picture",
               [this] { return overlays_->thumbnails().finished(); });
  mosaic_view_ = std::make_unique<MosaicView>(m.mosaic);
  panes_.emplace(m, *run_views_, *mosaic_view_, *timeline_, *overlays_);
  if (options.history_limit > 0) m.settings.history_limit = options.history_limit;
  m.draft = options.run;
  if (m.draft.input.starts_with(lesson_prefix)) {
    const std::string lesson = std::exchange(m.draft.input, "").substr(lesson_prefix.size());
    if (Status begun = m.commands.run({"lesson", {lesson}}); !begun) return begun;
    on_display_lost([this] { end_because("The display is lost."); });
    return {};
  }
  const bool first = m.draft.input.empty() && !m.scripted && !m.settings.greeted;
  if (m.draft.input.empty()) m.draft = for_input(m.draft, gallery_input(gallery().front().name));
  if (options.tolerance_given) m.draft.tolerance = options.run.tolerance;
  if (Status begun = m.steering.begin(options.paused, options.follow); !begun) m.report(begun.error());
  if (first) m.overlay = Overlay::welcome;
  if (!options.recording.empty())
    if (Status recorded = m.session.record(options.recording); !recorded) return recorded.error();
  on_display_lost([this] { end_because("The display is lost."); });
  return {};
}

void App::save() {
  if (!model_ || settings_path_.empty()) return;
  Settings kept = model_->settings;
  kept.theme = model_->view.theme;
  kept.panes = model_->kept_layout();
  save_settings(settings_path_, kept);
}

void App::close() {
  save();
  if (model_) model_->abandon();
}

void App::end_because(const std::string& cause) {
  if (!model_) return;
  close();
  const LastWait wait(display_lost() ? lost_status : stopped_status);
  std::string left = settings_path_.empty() ? "" : " The settings are saved.";
  const SessionSnapshot last = model_->session.snapshot();
  if (last.recording && !last.recording->opened)
    left += " The recording " + last.recording->file.string() + " is closed.";
  // The views' workers use the model; their OpenGL objects go with the program where no display is.
  if (display_lost()) {
    static_cast<void>(mosaic_view_.release());
    static_cast<void>(run_views_.release());
    static_cast<void>(scene_view_.release());
  }
  mosaic_view_.reset();
  run_views_.reset();
  scene_view_.reset();
  model_.reset();
  std::fprintf(stderr, "isoscope: %s%s\n", cause.c_str(), left.c_str());
}

App::~App() {
  on_display_lost({});
  save();
  // Workers wake the window: they end before it does.
  mosaic_view_.reset();
  run_views_.reset();
  scene_view_.reset();
  model_.reset();
}

void App::keys(CommandSink& commands) {
  const bool in_menu = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  for (const KeyPress& press : window_->take_keys()) {
    // Alt alone, or with the first letter of a menu, opens it; within it keys are the menu's.
    if (press.key == GLFW_KEY_LEFT_ALT || press.alt) {
      for (const std::string_view menu : menu_names)
        if (press.key == GLFW_KEY_LEFT_ALT || press.key == menu.front()) {
          commands.post("menu", {std::string(menu)});
          break;
        }
      continue;
    }
    if (in_menu) {
      const auto at = std::find(menu_names.begin(), menu_names.end(), model_->menu);
      if (at != menu_names.end() && (press.key == GLFW_KEY_LEFT || press.key == GLFW_KEY_RIGHT)) {
        const auto n = static_cast<std::ptrdiff_t>(menu_names.size());
        const auto to = (at - menu_names.begin() + (press.key == GLFW_KEY_RIGHT ? 1 : n - 1)) % n;
        commands.post("menu", {std::string(menu_names.at(static_cast<std::size_t>(to)))});
      }
      continue;
    }
    const bool in_pane = model_->pane_of_keys != PaneOfKeys::none;
    if (in_pane && !press.control) imgui_->press(press.key);
    const Command* command = model_->commands.find(Chord{press.key, press.control, press.shift});
    if (command == nullptr) continue;
    // While text is typed or a pane has the keys, only what cannot be text is a command.
    const bool function_key = press.key >= GLFW_KEY_F1 && press.key <= GLFW_KEY_F25;
    const bool text_key = !press.control && press.key != GLFW_KEY_ESCAPE && !function_key;
    constexpr std::array<int, 6> edits{'A', 'C', 'V', 'X', 'Y', 'Z'};
    const bool editing = press.control && std::find(edits.begin(), edits.end(), press.key) != edits.end();
    if (ImGui::GetIO().WantTextInput && (text_key || editing)) continue;
    if (in_pane && text_key) continue;
    if (!command->is_enabled()) continue;
    commands.post(command->name);
  }
}

void App::run_commands(CommandSink& commands) {
  for (const CommandCall& call : commands.take()) {
    const Status status = model_->commands.run(call);
    if (!status) model_->report(status.error());
    frames_owed_ = frames_after_input;
  }
}

void App::take_drops() {
  const std::vector<std::string> paths = window_->take_dropped();
  if (paths.empty()) return;
  if (const Status status = model_->commands.run({"drop", paths}); !status) model_->report(status.error());
}

void App::upload_thumbnails() {
  Thumbnails& thumbnails = overlays_->thumbnails();
  const Overlay over = model_->overlay;
  if (over != Overlay::gallery && over != Overlay::welcome && over != Overlay::lessons) return;
  if (const auto& lessons = bundled_lessons(); lessons && overlays_->lesson_textures.empty())
    for (const Lesson& lesson : *lessons) {
      const auto picture = decode_picture(picture_of(lesson));
      overlays_->lesson_textures.push_back(
          picture ? make_texture(picture->width, picture->height, picture->pixels.data()) : 0);
    }
  thumbnails.begin(480, 300, [] { Window::wake(); });
  for (std::size_t i = 0; i < thumbnails.textures.size(); ++i)
    if (const auto picture = thumbnails.picture(i); picture && thumbnails.textures[i] == 0)
      thumbnails.textures[i] = make_texture(picture->width, picture->height, picture->pixels.data());
}

void App::take_requests() {
  WindowRequests& r = model_->requests;
  if (r.copy) window_->set_clipboard(*std::exchange(r.copy, std::nullopt));
  if (std::exchange(r.paste, false)) {
    const Status status = model_->commands.run({"view", {window_->clipboard()}});
    if (!status) model_->report(status.error());
  }
  if (r.hands > 0) hands_until_ = glfwGetTime() + std::exchange(r.hands, 0.0);
  if (std::exchange(r.close, false)) window_->request_close();
}

void App::frame() {
  AppModel& m = *model_;
  const double begun = glfwGetTime();
  // Presenting, everything grows together: text to 26 px, lines and discs with it.
  const float talk = m.presenter.on ? 26.0f / 15.0f : 1.0f;
  const float scale = std::clamp(window_->content_scale() * m.settings.ui_scale * talk, 0.5f, 8.0f);
  if (Status s = imgui_->prepare(scale, m.view.theme); !s) {
    std::fprintf(stderr, "isoscope: %s\n", s.error().line().c_str());
    exit_status_ = 2;
    window_->request_close();
    return;
  }
  const bool hands = glfwGetTime() < hands_until_;
  std::optional<MouseStep> mouse;
  if (!m.requests.mouse.empty()) {
    mouse = m.requests.mouse.front();
    m.requests.mouse.pop_front();
  } else if (m.scripted && !hands) {
    mouse = MouseStep{ImGui::GetIO().MousePos.x,
                      ImGui::GetIO().MousePos.y}; // the real mouse must not disturb a script
  }
  upload_thumbnails();
  imgui_->begin_frame(mouse ? &*mouse : nullptr, m.scripted ? script_step : -1,
                      m.pane_of_keys != PaneOfKeys::none);
  CommandSink commands;
  Ui ui{m, m.commands, commands, palette(m.view.theme), m.view.theme, imgui_->fonts(), scale};
  if (!m.scripted || hands)
    keys(commands);
  else
    window_->take_keys();
  if (imgui_->has_presses()) frames_owed_ = std::max(frames_owed_, 2);
  panes_->draw(ui, m.clock - active_at_ > pointer_seconds);
  m.dragging = ImGui::IsAnyMouseDown();

  const PixelSize size = window_->framebuffer_size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.width, size.height);
  const ImVec4 ground = to_vec(ui.colors.ground);
  glClearColor(ground.x, ground.y, ground.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  imgui_->end_frame();
  ++frames_since_command_;

  const bool complete = !unfinished() && frames_since_command_ >= frames_after_input;
  if (complete && !m.requests.screenshots.empty() && (m.state_is_current() || !m.scripted)) {
    for (const ScreenshotRequest& request : std::exchange(m.requests.screenshots, {})) {
      Image image{size.width, size.height, {}};
      if (request.view_only) {
        const Renderer::Frame& shown = scene_view_->picture();
        image = {shown.width, shown.height, renderer_->read_pixels(shown)};
      } else {
        image.pixels = window_->read_pixels();
      }
      const Status written = write_png(request.file, image);
      if (!written)
        m.report(written.error());
      else if (!m.scripted)
        m.tell("The picture is written to " + request.file + ".");
      if (!written && m.scripted) {
        std::fprintf(stderr, "isoscope: %s\n", written.error().line().c_str());
        exit_status_ = 1;
        window_->request_close();
      }
    }
  }
  const SceneView::Extent extent = scene_view_->extent();
  if (m.exports.pending() && (complete || !m.scripted)) {
    // The section may never have been shown.
    if (m.view.mode == ViewMode::scene && extent.height > 0)
      scene_view_->place_untouched_section(m, static_cast<float>(extent.width) /
                                                  static_cast<float>(extent.height));
    exporter_.advance(m.exports, *renderer_, {extent.width, extent.height, extent.pixel_scale});
    // The step that was shown before comes back over the next frames.
    if (!m.exports.pending()) frames_since_command_ = 0;
  }
  window_->swap();
  m.times.frame(begun, glfwGetTime(), m.state() ? std::optional<Step>(m.state()->step) : std::nullopt,
                m.transport.step());
  run_commands(commands);
  take_requests();
}

bool App::unfinished() const {
  return model_->mosaic.shown() ? mosaic_view_->unfinished() : run_views_->unfinished();
}

bool App::at_rest() const {
  const AppModel& m = *model_;
  if (glfwGetTime() < hands_until_) return false;
  // What is under way can be cancelled; everything else waits for it.
  const bool exporting = m.exports.pending() && !(script_ && script_->next_is("cancel-export"));
  if (!m.requests.screenshots.empty() || !m.requests.mouse.empty() || exporting ||
      frames_since_command_ < frames_after_input)
    return false;
  if (m.clock < m.wait_until) return false;
  if (m.wait_for == AppModel::Wait::answers && !(m.answers_taken() && m.debug.is_current())) return false;
  if (!m.lessons.idle()) return false;
  if (m.wait_for == AppModel::Wait::comparison && !m.values.expect(m.wait_comparison)) return false;
  if (m.wait_for == AppModel::Wait::settled && m.mosaic.shown()) return m.mosaic.idle() && !unfinished();
  if (m.wait_for == AppModel::Wait::settled) // the run too
    return !m.running() && m.run.phase != SessionPhase::idle && m.state_is_current() && !unfinished();
  // A run that goes on need not be waited for; what stands still is shown first.
  return m.running() || (m.answers_taken() && !unfinished());
}

void App::fail_script(const Error& error) {
  std::fprintf(stderr, "isoscope: %s\n", error.line().c_str());
  exit_status_ = 1;
}

bool App::advance_script() {
  if (!script_) return true;
  if (model_->wait_for == AppModel::Wait::comparison && glfwGetTime() - waits_since_ > model_->wait_patience)
    if (const Status holds = model_->values.expect(model_->wait_comparison); !holds) {
      std::array<char, 32> within{};
      std::snprintf(within.data(), within.size(), " within %g s: ", model_->wait_patience);
      fail_script({ErrorCode::cancelled,
                   script_->place() + "\"" + model_->wait_comparison + "\" did not hold" + within.data() +
                       holds.error().message,
                   "wait until ... within SECONDS gives it longer"});
      return false;
    }
  if (!at_rest()) return true;
  model_->wait_until = 0;
  model_->wait_for = AppModel::Wait::time;
  if (script_->done()) return false;
  // What only asks leaves nothing to show.
  if (!script_->next_only_asks()) frames_since_command_ = 0;
  const Status status = script_->next(model_->commands);
  waits_since_ = glfwGetTime();
  if (status) return true;
  fail_script(status.error());
  return false;
}

bool App::needs_frame(bool changed) const {
  const AppModel& m = *model_;
  const bool asked =
      frames_owed_ > 0 || !m.requests.mouse.empty() || !m.requests.screenshots.empty() || m.exports.pending();
  // A script that waits for a run has no eyes: drawing would only slow the run down.
  if (m.scripted && m.running() && glfwGetTime() > hands_until_)
    return m.wait_for != AppModel::Wait::settled && (asked || frames_since_command_ < frames_after_input);
  return changed || asked || (m.scripted && frames_since_command_ < frames_after_input) || unfinished() ||
         m.transport.mode() == Transport::Mode::playing || ImGui::GetIO().WantTextInput ||
         ImGui::IsAnyMouseDown();
}

int App::run() {
  last_time_ = glfwGetTime();
  bool changed = true;
  while (!window_->should_close() && noted_signal() == 0) {
    AppModel& m = *model_;
    if (needs_frame(changed) && !window_->minimised())
      window_->poll();
    else
      window_->wait(m.scripted                              ? script_wait
                    : m.running() || m.comparison.running() ? running_wait
                                                            : idle_wait);
    const double now = glfwGetTime(), seconds = now - last_time_;
    last_time_ = now;
    m.clock += m.scripted ? script_step : seconds;
    if (window_->take_activity()) {
      frames_owed_ = frames_after_input;
      active_at_ = m.clock;
    }
    take_drops();
    const auto state = m.state();
    const std::size_t messages = m.messages.size();
    changed = m.update(m.scripted ? script_step : seconds);
    changed =
        changed || state != m.state() || messages != m.messages.size() || (m.grid.working() && !m.scripted);
    if (changed) frames_owed_ = std::max(frames_owed_, 2);
    // How old a copy is, is told in seconds.
    const bool ages = m.running() && m.run.recording && m.run.recording->copied;
    if (ages && std::floor(now) > std::floor(now - seconds)) frames_owed_ = std::max(frames_owed_, 1);
    // A resting mouse still owes a hover and a tooltip.
    if (frames_owed_ == 0 && ImGui::IsMousePosValid() && m.clock - active_at_ < hover_seconds)
      frames_owed_ = 1;
    if (needs_frame(changed)) {
      frame();
      if (frames_owed_ > 0) --frames_owed_;
    }
    if (!advance_script()) break;
    m.times.stands_at(m.transport.step(), glfwGetTime());
    const std::string shown =
        m.mosaic.shown() ? m.mosaic.folder()->folder().string() : m.run.parameters.input;
    const std::string title = shown.empty() ? "Isoscope" : shown + " – Isoscope";
    if (title != title_) window_->set_title(title_ = title);
  }
  if (const int signal = noted_signal()) {
    end_because("Ended by " + std::string(signal_name(signal)) + ".");
    return stopped_status;
  }
  const auto& error = model_->run.error;
  if (screenshot_only_ && error) {
    std::fprintf(stderr, "isoscope: %s\n", error->line().c_str());
    return refuses_input(error->code) ? 3 : 2;
  }
  return exit_status_;
}

} // namespace isoscope
