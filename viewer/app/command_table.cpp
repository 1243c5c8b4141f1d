// The table itself.
#include "app/commands.h"

#include "app/command_actions.h"
#include "app/icons.h"
#include "app/named_values.h"

#include <GLFW/glfw3.h>

namespace isoscope {
namespace {

using namespace actions;
using M = AppModel;
using A = Arguments;

std::vector<Command> file_commands() {
  return {
      {"open", "Open…", "[FILE | gallery:NAME] [paused]", "Opens a model and starts refining it; without a name it shows the files.", "File",
       icon::folder_open, {{'O', true}}, open_model},
      {"gallery", "Gallery", "", "Shows the bundled models and what each teaches.", "File", icon::gallery, {{'G', true}},
       [](M& m, const A&) { return toggle_overlay(m, Overlay::gallery); }},
      {"export", "Export Z…", "[FILE]", "Writes the zero set shown as OFF, OBJ, PLY or STL.", "File", icon::disk, {{'E', true}},
       export_mesh, [](const M& m) { return m.state() != nullptr; }},
      {"screenshot", "Screenshot", "[FILE] [view]", "Writes a picture of the window, or of the view alone, as PNG.", "File", icon::camera,
       {{GLFW_KEY_F12}}, screenshot},
      {"quit", "Quit", "", "Ends the program.", "File", nullptr, {{'Q', true}},
       [](M& m, const A&) { m.requests.close = true; return Status(); }},
  };
}

std::vector<Command> run_commands() {
  const auto has_run = [](const M& m) { return m.run.journal != nullptr; };
  return {
      {"play", "Play / pause", "", "Lets the play head run, or holds it.", "Run", icon::play, {{GLFW_KEY_SPACE}}, play_or_pause, has_run,
       [](const M& m) { return m.transport.moving(); }},
      {"step", "Next operation", "[N]", "Goes N operations on; at the live end of a held run it makes them happen.", "Run",
       icon::forward, {{GLFW_KEY_RIGHT}}, step_forward, has_run},
      {"back", "Previous operation", "[N]", "Goes N operations back.", "Run", icon::back, {{GLFW_KEY_LEFT}}, step_back, has_run},
      {"next-change", "To the next change", "", "Goes on until another condition or stage asks for the operation.", "Run",
       icon::next_change, {{GLFW_KEY_RIGHT, true}}, next_change, has_run},
      {"previous-change", "To the previous change", "", "Goes back to where the present condition or stage began.", "Run", nullptr,
       {{GLFW_KEY_LEFT, true}}, previous_change, has_run},
      {"first", "To the start", "", "Goes to step 0.", "Run", icon::first, {{GLFW_KEY_HOME}},
       [](M& m, const A&) { m.transport.jump(0); return Status(); }, has_run},
      {"end", "Follow the live end", "", "Goes to the newest step and stays there.", "Run", icon::last, {{GLFW_KEY_END}},
       [](M& m, const A&) { m.transport.follow(); return Status(); }, has_run,
       [](const M& m) { return m.transport.mode() == Transport::Mode::following; }},
      {"seek", "Go to step…", "STEP", "Goes to a step.", "", nullptr, {}, seek, has_run},
      {"speed", "Speed", "automatic | unlimited | STEPS", "Sets the play head's speed in steps a second.", "", nullptr, {}, set_speed},
      {"faster", "Faster", "", "Takes the next higher speed.", "Run", nullptr, {{GLFW_KEY_PERIOD}},
       [](M& m, const A&) { return change_speed(m, 1); }},
      {"slower", "Slower", "", "Takes the next lower speed.", "Run", nullptr, {{GLFW_KEY_COMMA}},
       [](M& m, const A&) { return change_speed(m, -1); }},
      {"hold", "Hold or let go the run", "", "Stops the computation between two operations, or lets it go on.", "Run", icon::pause,
       {{GLFW_KEY_SPACE, false, true}}, hold_or_resume,
       [](const M& m) { return m.run.phase == SessionPhase::running || m.run.phase == SessionPhase::paused; },
       [](const M& m) { return m.run.phase == SessionPhase::paused; }},
      {"apply", "Apply parameters", "", "Goes on with the parameters of the panel from the present state.", "Run", icon::check,
       {{GLFW_KEY_ENTER, true}}, apply_parameters, has_run},
      {"restart", "Restart", "", "Runs again from the beginning with the parameters of the panel.", "Run", icon::restart, {{'R', true}},
       [](M& m, const A&) { m.restart(); return Status(); }, [](const M& m) { return !m.draft.input.empty(); }},
      {"stop", "Stop", "", "Ends the run; what is there is kept and certified.", "Run", icon::stop, {},
       [](M& m, const A&) { m.session.stop(); return Status(); },
       [](const M& m) { return m.running() || m.run.phase == SessionPhase::paused; }},
  };
}

std::vector<Command> select_commands() {
  const auto has_state = [](const M& m) { return m.state() != nullptr; };
  return {
      {"pick", "Select…", "vertex | tet | sample ID", "Selects an element by its number.", "", nullptr, {}, pick_element, has_state},
      {"pick-worst", "Select the worst sample", "", "Selects the sample with the largest ε.", "Select", icon::target, {{'W'}}, pick_worst,
       has_state},
      {"clear", "Clear the selection", "", "Selects nothing; closes what lies over the window.", "Select", nullptr, {{GLFW_KEY_ESCAPE}},
       clear_selection},
      {"frame", "Frame the selection", "", "Moves the camera to what is selected, or to everything.", "Select", icon::search, {{'F'}},
       [](M& m, const A&) { m.requests.frame_selection = true; return Status(); }},
      {"kind-vertex", "Pick vertices only", "", "A click selects vertices alone; again for all kinds.", "Select", nullptr, {{'1'}},
       [](M& m, const A&) { return restrict_kind(m, 1); }, nullptr, [](const M& m) { return m.selection.kinds == 1; }},
      {"kind-tet", "Pick tetrahedra only", "", "A click selects tetrahedra alone; again for all kinds.", "Select", nullptr, {{'2'}},
       [](M& m, const A&) { return restrict_kind(m, 2); }, nullptr, [](const M& m) { return m.selection.kinds == 2; }},
      {"kind-sample", "Pick samples only", "", "A click selects samples alone; again for all kinds.", "Select", nullptr, {{'3'}},
       [](M& m, const A&) { return restrict_kind(m, 4); }, nullptr, [](const M& m) { return m.selection.kinds == 4; }},
      {"kind-all", "Pick every kind", "", "A click selects whatever is nearest.", "Select", nullptr, {{'4'}},
       [](M& m, const A&) { m.selection.kinds = 7; return Status(); }, nullptr,
       [](const M& m) { return m.selection.kinds == 7; }},
  };
}

std::vector<Command> view_commands() {
  return {
      {"scene", "3D view", "", "Shows the scene in space.", "View", icon::cube, {{'3', true}},
       [](M& m, const A&) { m.view.mode = ViewMode::scene; return Status(); }, nullptr,
       [](const M& m) { return m.view.mode == ViewMode::scene; }},
      {"section", "2D section", "", "Shows the section by the clip's plane, drawn like the paper's figures.", "View", icon::square,
       {{'2', true}}, [](M& m, const A&) { m.view.mode = ViewMode::section; return Status(); }, nullptr,
       [](const M& m) { return m.view.mode == ViewMode::section; }},
      {"split", "3D and section", "", "Shows both beside each other.", "View", icon::split, {{'4', true}},
       [](M& m, const A&) { m.view.mode = ViewMode::split; return Status(); }, nullptr,
       [](const M& m) { return m.view.mode == ViewMode::split; }},
      {"frame-all", "Frame everything", "", "Moves the camera so that the whole model is seen.", "View", icon::home, {{'A'}},
       [](M& m, const A&) { m.requests.frame_all = true; return Status(); }},
      {"look", "Look along an axis", "x | y | z | -x | -y | -z", "Looks along an axis.", "", nullptr, {}, look_along},
      {"front", "Front view", "", "Looks along z.", "View", nullptr, {{GLFW_KEY_KP_1}}, [](M& m, const A&) { return look_along(m, {"z"}); }},
      {"right", "Right view", "", "Looks along x.", "View", nullptr, {{GLFW_KEY_KP_3}}, [](M& m, const A&) { return look_along(m, {"x"}); }},
      {"top", "Top view", "", "Looks along y.", "View", nullptr, {{GLFW_KEY_KP_7}}, [](M& m, const A&) { return look_along(m, {"y"}); }},
      {"orthographic", "Orthographic", "", "Switches between perspective and parallel projection.", "View", nullptr,
       {{GLFW_KEY_KP_5}, {'5'}}, toggle_orthographic, nullptr, [](const M& m) { return m.camera.pose().orthographic; }},
      {"clip-next", "Next clip shape", "", "Cuts by nothing, plane, slab or ball in turn.", "View", icon::scissors, {{'X'}}, next_clip_shape},
      {"clip-mode", "Next clip mode", "", "Cuts cells, keeps them whole, or shows those that straddle the cut.", "View", nullptr, {{'C'}},
       next_clip_mode},
      {"clip-flip", "Flip the clip", "", "Cuts the other side away.", "View", icon::flip, {{'X', false, true}},
       [](M& m, const A&) { m.view.clip.flipped = !m.view.clip.flipped; return Status(); }, nullptr,
       [](const M& m) { return m.view.clip.flipped; }},
      {"shrink-less", "Grow tetrahedra", "", "Shows tetrahedra larger.", "", nullptr, {{GLFW_KEY_RIGHT_BRACKET}},
       [](M& m, const A&) { return change_shrink(m, 0.05f); }},
      {"shrink-more", "Shrink tetrahedra", "", "Shows tetrahedra smaller.", "", nullptr, {{GLFW_KEY_LEFT_BRACKET}},
       [](M& m, const A&) { return change_shrink(m, -0.05f); }},
      {"view", "Set the view", "JSON", "Takes camera, layers, filter and clip from JSON.", "", nullptr, {}, set_view},
      {"copy-view", "Copy the view", "", "Copies camera, layers, filter and clip as JSON.", "View", nullptr, {{'C', true}}, copy_view},
      {"paste-view", "Paste a view", "", "Takes the view from the clipboard.", "View", nullptr, {{'V', true}},
       [](M& m, const A&) { m.requests.paste = true; return Status(); }},
  };
}

std::vector<Command> window_commands() {
  return {
      {"pane-left", "Layers and parameters", "", "Shows or hides the left pane.", "Window", nullptr, {{'1', true, true}},
       [](M& m, const A&) { m.settings.panes.show_left = !m.settings.panes.show_left; return Status(); }, nullptr,
       [](const M& m) { return m.settings.panes.show_left; }},
      {"pane-right", "Inspector", "", "Shows or hides the right pane.", "Window", nullptr, {{'2', true, true}},
       [](M& m, const A&) { m.settings.panes.show_right = !m.settings.panes.show_right; return Status(); }, nullptr,
       [](const M& m) { return m.settings.panes.show_right; }},
      {"pane-bottom", "Timeline", "", "Shows or hides the bottom pane.", "Window", nullptr, {{'3', true, true}},
       [](M& m, const A&) { m.settings.panes.show_bottom = !m.settings.panes.show_bottom; return Status(); }, nullptr,
       [](const M& m) { return m.settings.panes.show_bottom; }},
      {"only-view", "Only the view", "", "Hides all panes, or shows them again.", "Window", nullptr, {{'P'}}, toggle_panes},
      {"tab", "Bottom tab", "timeline | plots | events", "Chooses what the bottom pane shows.", "", nullptr, {}, choose_tab},
      {"theme", "Theme", "[dark | light | paper]", "Sets the colours; without a name it takes the next.", "Window", nullptr, {{'T', true}},
       choose_theme},
      {"larger", "Larger interface", "", "Enlarges text and controls.", "Window", nullptr, {{GLFW_KEY_EQUAL, true}, {GLFW_KEY_KP_ADD, true}},
       [](M& m, const A&) { return change_scale(m, 1); }},
      {"smaller", "Smaller interface", "", "Makes text and controls smaller.", "Window", nullptr,
       {{GLFW_KEY_MINUS, true}, {GLFW_KEY_KP_SUBTRACT, true}}, [](M& m, const A&) { return change_scale(m, -1); }},
      {"normal-size", "Normal size", "", "Text and controls in the monitor's own scale.", "Window", nullptr, {{'0', true}},
       [](M& m, const A&) { return change_scale(m, 0); }},
      {"palette", "Command palette", "", "Finds a command by typing.", "Help", icon::search, {{'P', true}},
       [](M& m, const A&) { return toggle_overlay(m, Overlay::palette); }},
      {"help", "Help", "", "Lists every key, command and value.", "Help", icon::help, {{GLFW_KEY_F1}},
       [](M& m, const A&) { return toggle_overlay(m, Overlay::help); }},
      {"about", "About Isoscope", "", "Says what this is, its licence and its sources.", "Help", icon::info, {},
       [](M& m, const A&) { return toggle_overlay(m, Overlay::about); }},
  };
}

std::vector<Command> script_commands() {
  const auto only = [](Command command) {
    command.for_scripts = true;
    return command;
  };
  return {
      {"set", "Set a value", "NAME VALUE", "Sets a named value; parameters take effect with apply or restart.", "", nullptr, {}, set_value},
      only({"expect", "Expect", "NAME OP VALUE [and ...]", "Stops the script unless the comparison holds.", "", nullptr, {}, expect_value}),
      only({"wait", "Wait", "[settled | SECONDS]", "Waits until the run is at rest and shown, or for a time.", "", nullptr, {}, wait_for}),
      only({"click", "Click", "X Y [left | right]", "Clicks at a place of the window.", "", nullptr, {}, click}),
      only({"drag", "Drag", "X1 Y1 X2 Y2 [left | right] [shift]", "Drags from one place of the window to another.", "", nullptr, {}, drag}),
      only({"move", "Move", "X Y", "Moves the mouse to a place of the window.", "", nullptr, {}, move}),
      only({"wheel", "Wheel", "X Y STEPS", "Turns the wheel at a place of the window.", "", nullptr, {}, wheel}),
      only({"key", "Key", "CHORD", "Does what a key does: Ctrl+P, Right, F1.", "", nullptr, {}, press_key}),
      only({"dismiss", "Dismiss", "", "Removes all messages.", "", nullptr, {}, [](M& m, const A&) { m.messages.clear(); return Status(); }}),
  };
}

} // namespace

std::span<const Command> command_table() {
  static const std::vector<Command> table = [] {
    std::vector<Command> all;
    for (auto group : {file_commands(), run_commands(), select_commands(), view_commands(), window_commands(), script_commands()})
      all.insert(all.end(), group.begin(), group.end());
    return all;
  }();
  return table;
}

} // namespace isoscope
