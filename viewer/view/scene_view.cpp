// Mouse, pictures and what lies over them.
#include "view/scene_view.h"

#include "scene/first_box.h"
#include "scene/pick_geometry.h"
#include "ui/widgets.h"
#include "view/scene_overlay.h"
#include "view/warning_chip.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr double hover_delay = 0.12;

/// A box whose corners are in sight when it is framed: a model's may lie outside of the picture.
Box3 roomy(const Box3& box) {
  return box.empty() ? box : box.grown(0.12 * box.longest_edge());
}

/// Tells what the view shows, where it shows a part of the model alone: `high` scene units from rim to rim.
void look_near(WindowState& m, Vec3 middle, double high, ImVec2 size) {
  constexpr double part = 0.5, pixels_a_voxel = 2;
  const double wide = high * std::max(1.0, static_cast<double>(size.x / size.y));
  if (!m.run.scene || high <= 0 || wide > part * m.run.scene->longest_edge)
    m.grid.look_near(std::nullopt);
  else
    m.grid.look_near(GridFocus{middle, 0.5 * wide, pixels_a_voxel * high / static_cast<double>(size.y)});
}

ImVec2 local(ImVec2 mouse, ImVec2 low) {
  return {mouse.x - low.x, mouse.y - low.y};
}

} // namespace

void SceneView::draw(Ui& ui) {
  WindowState& m = ui.window;
  const bool input_alone = m.input_alone();
  renderer_->set_scene(input_alone ? nullptr : m.run.scene);
  renderer_->set_input(m.run.input);
  renderer_->set_grid(input_alone ? nullptr : m.grid.grid());
  renderer_->set_detail(input_alone ? nullptr : m.grid.detail());
  renderer_->set_state(input_alone ? nullptr : m.state());
  renderer_->set_other(m.other_state);
  xray_ = probe_.xray();
  renderer_->set_xray(xray_);
  // Until the next answer is there, the last one stays: a drag would flicker otherwise.
  if (const auto newest = probe_.study(); newest || !m.selection.what_if || !xray_) study_ = newest;
  renderer_->set_study(study_);
  annotation_ = asked_.annotation();
  renderer_->set_annotation(annotation_);
  preview_ = m.would_violate;
  renderer_->set_preview(preview_);
  zero_map_ = maps_.map();
  renderer_->set_zero_map(zero_map_);
  frame_selection(ui);

  const ImVec2 low = ImGui::GetCursorScreenPos(), all = ImGui::GetContentRegionAvail();
  scene_shown_ = m.view.mode != ViewMode::section;
  section_shown_ = m.view.mode != ViewMode::scene;
  if (!scene_shown_) scene_.rest();
  if (!section_shown_) section_.rest();
  if (m.view.mode == ViewMode::split) {
    const float gap = ui.px(2), half = std::floor((all.x - gap) / 2);
    draw_scene(ui, {low, {half, all.y}});
    draw_section(ui, {{low.x + half + gap, low.y}, {all.x - half - gap, all.y}});
  } else if (scene_shown_) {
    draw_scene(ui, {low, all});
  } else {
    draw_section(ui, {low, all});
  }
  if (!m.presenter.on) {
    overlay::mode_switch(ui, {low.x + all.x, low.y}, all.x);
    const float lower = overlay::caption(ui, low, all);
    const float chip = lower + overlay::warning_chip(ui, {low.x, low.y + lower}, all);
    overlay::preview(ui, {low.x, low.y + chip}, all);
    overlay::key(ui, scene_key(m, maps_, m.shown_view(), xray_, legend_), low, all);
  }
  overlay::progress(ui, m, "stop", low, all);
  overlay::invitation(ui, low, all);
}

void SceneView::render(Ui& ui, Area area, bool section) {
  const WindowState& m = ui.window;
  const ViewSettings view = m.shown_view();
  ViewPicture::Key key;
  key.view = view;
  key.state = m.state().get();
  key.other = m.other_state.get();
  key.grid = m.grid.grid().get();
  key.detail = m.grid.detail().get();
  key.scene = m.run.scene ? static_cast<const void*>(m.run.scene.get()) : m.run.input.get();
  key.xray = xray_.get();
  key.study = study_.get();
  key.annotation = annotation_.get();
  key.preview = preview_.get();
  key.zero_map = zero_map_.get();
  key.mark = m.selection.mark;
  key.selection = m.selection.picked;
  key.hover = m.selection.hovered;
  if (section)
    key.u = m.section.u, key.v = m.section.v, key.height = m.section.height;
  else
    key.pose = m.camera.pose();
  (section ? section_ : scene_).draw(ui, area, key, [&](const FrameRequest& request) {
    return section ? renderer_->render_section(m.section, view, request)
                   : renderer_->render(m.camera, view, request);
  });
}

void SceneView::draw_scene(Ui& ui, Area area) {
  if (area.size.x < 1 || area.size.y < 1) return;
  ImGui::SetCursorScreenPos(area.low);
  ImGui::InvisibleButton("scene", area.size, every_button);
  ImGui::SetItemAllowOverlap(); // the controls that lie over the picture come first
  frame_untouched(ui, area.size.x / area.size.y);
  ui.window.scene_area = {area.low.x, area.low.y, area.size.x, area.size.y};
  scene_mouse(ui, area);
  render(ui, area, false);
  WindowState& m = ui.window;
  const double high = m.camera.height_at_target();
  if (!ImGui::IsAnyMouseDown()) look_near(m, m.camera.pose().target, high, area.size);
  clip_handle_.draw(ui, area);
  overlay::axes(ui, m.camera, area.low, area.size);
  overlay::scale_bar(ui, m.run.scene ? m.run.scene->delta : 0, area.low, area.size, high);
}

void SceneView::draw_section(Ui& ui, Area area) {
  if (area.size.x < 1 || area.size.y < 1) return;
  ImGui::SetCursorScreenPos(area.low);
  ImGui::InvisibleButton("section", area.size, every_button);
  ImGui::SetItemAllowOverlap(); // the controls that lie over the picture come first
  place_untouched_section(ui.window, area.size.x / area.size.y);
  section_mouse(ui, area);
  render(ui, area, true);
  if (!scene_shown_ && !ImGui::IsAnyMouseDown()) {
    const ClipSettings& clip = ui.window.view.clip;
    const PlaneAxes axes = plane_axes(clip.flipped ? -clip.normal : clip.normal);
    const auto& at = ui.window.section;
    look_near(ui.window, clip.point + at.u * axes.u + at.v * axes.v, at.height, area.size);
  }
  overlay::section_caption(ui, area.low, area.size);
  const auto& scene = ui.window.run.scene;
  overlay::scale_bar(ui, scene ? scene->delta : 0, area.low, area.size, ui.window.section.height);
}

void SceneView::picked(Ui& ui, const Pick& pick) {
  ui.window.selection.pick(pick);
  if (pick.kind != Pick::Kind::none) ui.window.settings.panes.show_right = true;
}

Pick SceneView::hover_pick(Ui& ui, Area area, bool section) {
  WindowState& m = ui.window;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MousePos.x != hover_at_.x || io.MousePos.y != hover_at_.y) {
    hover_at_ = io.MousePos;
    hover_since_ = m.clock;
    hover_asked_ = false;
  }
  if (hover_asked_ || m.transport.moving() || m.clock - hover_since_ < hover_delay)
    return m.selection.hovered;
  hover_asked_ = true;
  const ImVec2 at = local(io.MousePos, area.low);
  const int width = static_cast<int>(area.size.x), height = static_cast<int>(area.size.y);
  return section ? renderer_->pick_section(m.section, m.shown_view(), at.x, at.y, width, height,
                                           m.selection.kinds)
                 : renderer_->pick(m.camera, m.shown_view(), at.x, at.y, width, height, m.selection.kinds);
}

void SceneView::scene_mouse(Ui& ui, Area area) {
  WindowState& m = ui.window;
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 at = local(io.MousePos, area.low);
  const int width = static_cast<int>(area.size.x), height = static_cast<int>(area.size.y);
  const auto under = [&] {
    return renderer_->point_under(m.camera, m.shown_view(), at.x, at.y, width, height);
  };
  if (handle_.update(ui, probe_, area.low, area.size, hovered)) {
    mouse_.take();
    return;
  }
  if (clip_handle_.update(ui, area, hovered)) {
    mouse_.take();
    return;
  }
  mouse_.update(ui, m.camera, area, under);
  if (ImGui::IsItemDeactivated() && !mouse_.dragged() && hovered) {
    if (ImGui::IsMouseReleased(0))
      picked(ui, renderer_->pick(m.camera, m.shown_view(), at.x, at.y, width, height, m.selection.kinds));
    if (ImGui::IsMouseReleased(1)) picked(ui, {});
  }
  if (hovered && !ImGui::IsAnyMouseDown() && !m.presenter.on) {
    m.selection.hovered = hover_pick(ui, area, false);
    overlay::hover_tip(ui);
  } else if (scene_shown_ && !section_shown_) {
    m.selection.hovered = {};
  }
}

void SceneView::section_mouse(Ui& ui, Area area) {
  WindowState& m = ui.window;
  ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 at = local(io.MousePos, area.low);
  const int width = static_cast<int>(area.size.x), height = static_cast<int>(area.size.y);
  const double unit = m.section.height / static_cast<double>(area.size.y);
  if (ImGui::IsItemActivated()) dragged_ = false;
  if (ImGui::IsItemActive()) {
    const int button = ImGui::IsMouseDown(0) ? 0 : ImGui::IsMouseDown(1) ? 1 : 2;
    const ImVec2 total = ImGui::GetMouseDragDelta(button, 0);
    dragged_ = dragged_ || std::hypot(total.x, total.y) > ui.px(4);
    if (dragged_) {
      m.section.u -= io.MouseDelta.x * unit;
      m.section.v += io.MouseDelta.y * unit;
      m.section_set = true;
    }
  }
  if (hovered && io.MouseWheel != 0) {
    const double factor = std::pow(0.88, static_cast<double>(io.MouseWheel));
    const double du = (static_cast<double>(at.x) - area.size.x / 2) * unit,
                 dv = (area.size.y / 2 - static_cast<double>(at.y)) * unit;
    m.section.u += du * (1 - factor);
    m.section.v += dv * (1 - factor);
    m.section.height *= factor;
    m.section_set = true;
  }
  if (ImGui::IsItemDeactivated() && !dragged_ && hovered) {
    if (ImGui::IsMouseReleased(0))
      picked(ui, renderer_->pick_section(m.section, m.shown_view(), at.x, at.y, width, height,
                                         m.selection.kinds));
    if (ImGui::IsMouseReleased(1)) picked(ui, {});
  }
  if (hovered && !ImGui::IsAnyMouseDown() && !m.presenter.on) {
    m.selection.hovered = hover_pick(ui, area, true);
    overlay::hover_tip(ui);
  } else if (section_shown_ && !scene_shown_) {
    m.selection.hovered = {};
  }
}

// Until somebody moves the camera, the whole model stays in sight, however narrow the view becomes.
void SceneView::frame_untouched(Ui& ui, float aspect) {
  WindowState& m = ui.window;
  Box3 box = m.scene_bounds();
  if (m.camera.was_set() || box.empty()) return;
  // Before an audience, or where it is drawn, the box that T begins as is seen too.
  const auto state = m.state();
  const Box3 begun = (m.presenter.on || m.view.tets.box) && state ? first_box(*state) : Box3();
  box.add(roomy(begun));
  const CameraPose& goal = m.camera.goal();
  const bool moved = goal.target != framed_.target || goal.distance != framed_.distance;
  if (!moved && aspect == framed_aspect_ && box.lo == framed_box_.lo && box.hi == framed_box_.hi) return;
  const bool left = moved && framed_aspect_ != 0; // somebody had moved it and has let go of it
  framed_aspect_ = aspect;
  framed_box_ = box;
  const bool ease = (m.presenter.on || left) && !m.scripted;
  if (begun.empty())
    m.camera.frame(m.scene_outline(), ease, static_cast<double>(aspect));
  else
    m.camera.frame(box, ease, static_cast<double>(aspect));
  framed_ = m.camera.goal();
}

// The same for the section: what the plane cuts of the input is centred.
void SceneView::place_untouched_section(WindowState& m, float aspect) {
  ClipSettings plane;
  plane.point = m.view.clip.point;
  plane.normal = m.view.clip.normal;
  plane.flipped = m.view.clip.flipped;
  if (m.section_set || !m.run.scene || !m.run.scene->input) return;
  if (plane == placed_clip_ && placed_scene_ == m.run.scene.get() && placed_aspect_ == aspect &&
      m.section == placed_)
    return;
  placed_clip_ = plane;
  placed_scene_ = m.run.scene.get();
  placed_aspect_ = aspect;
  const PlaneAxes axes = plane_axes(plane.flipped ? -plane.normal : plane.normal);
  Box3 box; // in the plane's coordinates
  const TriangleSoup& soup = *m.run.scene->input;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle3 t = soup.triangle(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = t[k] - plane.point, b = t[(k + 1) % 3] - plane.point;
      const double da = dot(a, plane.normal), db = dot(b, plane.normal);
      if ((da < 0) == (db < 0)) continue;
      const Vec3 p = a + da / (da - db) * (b - a);
      box.add(Vec3{dot(p, axes.u), dot(p, axes.v), 0});
    }
  }
  if (soup.is_point_set())
    for (const Vec3& point : soup.points) {
      const Vec3 p = point - plane.point;
      if (std::abs(dot(p, plane.normal)) <= m.run.scene->delta)
        box.add(Vec3{dot(p, axes.u), dot(p, axes.v), 0});
    }
  if (box.empty()) return;
  const Vec3 extent = box.extent(), middle = box.center();
  const double margin = 8 * m.run.scene->delta;
  m.section = {middle.x, middle.y, 1.1 * std::max(extent.y, extent.x / static_cast<double>(aspect)) + margin};
  placed_ = m.section;
}

void SceneView::frame_selection(Ui& ui) {
  WindowState& m = ui.window;
  // What is selected may belong to a step that is still being made.
  if (!m.requests.frame_selection || !(m.settled || m.running())) return;
  m.requests.frame_selection = false;
  const Pick& pick = m.selection.picked;
  const auto state = m.state();
  if (pick.kind == Pick::Kind::none || !state) return m.frame_all();
  // Where δ is large, what is selected is still looked at from nearer than the whole.
  const double margin = m.run.scene ? std::min(4 * m.run.scene->delta, 0.12 * m.scene_bounds().longest_edge())
                                    : 0.02 * renderer_->bounds().longest_edge();
  Box3 box = pick_bounds(*state, pick);
  if (box.empty()) box.add(pick.point);
  // Tetrahedra at the corners of the first box are looked at where they meet the model.
  if (const Box3 model = m.scene_bounds(); box.longest_edge() > model.longest_edge() && box.meets(model))
    for (int i = 0; i < 3; ++i) {
      box.lo[i] = std::max(box.lo[i], model.lo[i]);
      box.hi[i] = std::min(box.hi[i], model.hi[i]);
    }
  if (m.selection.mark) box.add(*m.selection.mark);
  // What is nearly as large as the model needs no more around it than the model has.
  const double around =
      m.run.scene ? std::min(box.longest_edge(), 0.3 * m.scene_bounds().longest_edge()) : box.longest_edge();
  box = box.grown(margin + 0.5 * around);
  // What lies on the far side of the model or in a fold of it would be framed from within.
  const Vec3 now = normalized(m.camera.eye() - m.camera.pose().target);
  const double reach = 2 * box.longest_edge(); // about the distance of the camera once it is framed
  const Vec3 normal = surface_normal(*state, pick);
  const Vec3 from = squared_length(normal) > 0
                        ? unhidden_direction(state->zero_set, box.center(), now, normal, reach)
                        : now;
  if (from != now) m.camera.look_from(from, false);
  m.camera.frame(box, !m.scripted,
                 m.scene_area[3] > 0 ? static_cast<double>(m.scene_area[2] / m.scene_area[3]) : 1);
  m.camera.mark_set();
  const PlaneAxes axes = plane_axes(m.view.clip.normal);
  const Vec3 offset = box.center() - m.view.clip.point;
  m.section = {dot(offset, axes.u), dot(offset, axes.v), 1.15 * box.longest_edge()};
  m.section_set = true;
}

} // namespace isoscope
