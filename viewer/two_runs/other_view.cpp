// Moves its camera, becomes active when clicked.
#include "two_runs/run_views.h"

#include "journal/describe.h"
#include "view/scene_overlay.h"

#include <cmath>

namespace isoscope {

bool OtherView::prepare(Ui& ui) {
  if (renderer_) return true;
  auto made = Renderer::create();
  if (made) {
    renderer_ = std::move(*made);
    return true;
  }
  ui.window.report(made.error());
  ui.commands.post("close-other");
  return false;
}

void OtherView::release() {
  if (!renderer_) return;
  renderer_.reset();
  picture_ = {};
}

void OtherView::draw(Ui& ui, Comparison& comparison) {
  WindowState& m = ui.window;
  const ShownRun* run = comparison.other();
  if (run == nullptr || !prepare(ui)) return;
  const auto state = run->state();
  const auto grid = run->grid.grid();
  renderer_->set_scene(run->run.scene);
  renderer_->set_input(run->run.input);
  renderer_->set_grid(grid);
  renderer_->set_detail(run->grid.detail());
  renderer_->set_state(state);

  const ViewArea area{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail()};
  if (area.size.x < 1 || area.size.y < 1) return;
  ImGui::InvisibleButton("other", area.size, every_button);
  const bool section = m.view.mode == ViewMode::section;
  Camera& camera = comparison.linked_cameras ? m.camera : comparison.camera;
  const ViewSettings view = m.shown_view();
  if (!section) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    mouse_.update(ui, camera, area, [&] {
      return renderer_->point_under(camera, view, mouse.x - area.low.x, mouse.y - area.low.y,
                                    static_cast<int>(area.size.x), static_cast<int>(area.size.y));
    });
  } else if (ImGui::IsItemActivated()) {
    mouse_ = {};
  }
  if (ImGui::IsItemDeactivated() && ImGui::IsItemHovered() && ImGui::IsMouseReleased(0) && !mouse_.dragged())
    ui.commands.post("other-run");

  ViewPicture::Key key;
  key.view = view;
  key.state = state.get();
  key.grid = grid.get();
  key.detail = run->grid.detail().get();
  key.scene = run->run.scene.get();
  key.selection = comparison.picked;
  if (section)
    key.u = m.section.u, key.v = m.section.v, key.height = m.section.height;
  else
    key.pose = camera.pose();
  picture_.draw(ui, area, key, [&](const FrameRequest& request) {
    return section ? renderer_->render_section(m.section, view, request)
                   : renderer_->render(camera, view, request);
  });

  const double delta = run->run.scene ? run->run.scene->delta : 0;
  if (section) {
    overlay::scale_bar(ui, delta, area.low, area.size, m.section.height);
  } else {
    overlay::axes(ui, camera, area.low, area.size);
    overlay::scale_bar(ui, delta, area.low, area.size, camera.height_at_target());
  }
  if (state && run->run.journal && state->event)
    overlay::sentence(ui, &*state->event, describe(*run->run.journal, *state->event), area.low,
                      area.size.x - ui.px(64));
  overlay::progress(ui, *run, "close-other", area.low, area.size);
}

} // namespace isoscope
