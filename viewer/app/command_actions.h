// What the commands do that takes more than a line. Each checks its arguments and fails with usage where they
// are wrong.
#pragma once

#include "command/commands.h"

namespace isoscope::actions {

Status toggle_overlay(AppModel& model, Overlay overlay);
Status open_model(AppModel& model, const Arguments& arguments);
Status export_mesh(AppModel& model, const Arguments& arguments);
Status screenshot(AppModel& model, const Arguments& arguments);

Status play_or_pause(AppModel& model, const Arguments& arguments);
Status step_forward(AppModel& model, const Arguments& arguments);
Status step_back(AppModel& model, const Arguments& arguments);
Status next_change(AppModel& model, const Arguments& arguments);
Status previous_change(AppModel& model, const Arguments& arguments);
Status seek(AppModel& model, const Arguments& arguments);
Status set_speed(AppModel& model, const Arguments& arguments);
Status change_speed(AppModel& model, int direction);
Status hold_or_resume(AppModel& model, const Arguments& arguments);
Status apply_parameters(AppModel& model, const Arguments& arguments);

Status pick_element(AppModel& model, const Arguments& arguments);
Status pick_operation(AppModel& model, const Arguments& arguments);
Status go_to_event(AppModel& model, const Arguments& arguments);
Status next_event(AppModel& model, const Arguments& arguments, int direction);
Status go_to_stage(AppModel& model, const Arguments& arguments);
Status filter_events(AppModel& model, const Arguments& arguments);
Status mark_witness(AppModel& model, const Arguments& arguments);
Status toggle_blink(AppModel& model, const Arguments& arguments);
Status pick_worst(AppModel& model, const Arguments& arguments);
Status clear_selection(AppModel& model, const Arguments& arguments);
Status restrict_kind(AppModel& model, unsigned kind);

Status look_along(AppModel& model, const Arguments& arguments);
Status toggle_orthographic(AppModel& model, const Arguments& arguments);
Status next_clip_shape(AppModel& model, const Arguments& arguments);
Status next_clip_mode(AppModel& model, const Arguments& arguments);
Status change_shrink(AppModel& model, float by);
Status set_view(AppModel& model, const Arguments& arguments);
Status copy_view(AppModel& model, const Arguments& arguments);

Status toggle_panes(AppModel& model, const Arguments& arguments);
Status choose_tab(AppModel& model, const Arguments& arguments);
Status choose_theme(AppModel& model, const Arguments& arguments);
Status change_scale(AppModel& model, int direction);

Status add_bookmark(AppModel& model, const Arguments& arguments);
Status go_to_bookmark(AppModel& model, const Arguments& arguments);
Status turn_slide(AppModel& model, int direction);
Status list_bookmarks(AppModel& model, const Arguments& arguments);
Status note_bookmark(AppModel& model, const Arguments& arguments);
Status move_bookmark(AppModel& model, const Arguments& arguments);
Status delete_bookmark(AppModel& model, const Arguments& arguments);
Status undo_view(AppModel& model, const Arguments& arguments);
Status redo_view(AppModel& model, const Arguments& arguments);

Status set_value(AppModel& model, const Arguments& arguments);
Status expect_value(AppModel& model, const Arguments& arguments);
Status wait_for(AppModel& model, const Arguments& arguments);
Status click(AppModel& model, const Arguments& arguments);
Status drag(AppModel& model, const Arguments& arguments);
Status move(AppModel& model, const Arguments& arguments);
Status wheel(AppModel& model, const Arguments& arguments);
Status give_hands(AppModel& model, const Arguments& arguments);
Status press_key(AppModel& model, const Arguments& arguments);

} // namespace isoscope::actions
