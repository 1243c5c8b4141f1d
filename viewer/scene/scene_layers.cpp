// The layers of the 3D view: keeps their buffers up to date and draws them in their passes.
#include "scene/scene_layers.h"

#include "questions/rim_questions.h"

#include <glad/gl.h>

namespace isoscope {
namespace {

/// A clip that cuts fragments leaves the buffers alone.
ClipSettings clip_of_cells(const ClipSettings& clip) {
  if (clip.shape == ClipSettings::Shape::none || clip.mode == ClipSettings::Mode::cut) return {};
  return clip;
}

bool solid(const LayerSettings& layer) {
  return layer.visible && layer.opacity >= 1;
}
bool thin(const LayerSettings& layer) {
  return layer.shown() && layer.opacity < 1;
}

} // namespace

const Rim* LayerInputs::rim() const {
  return scene ? open_rim(*scene) : nullptr;
}

void SceneLayers::forget_scene() {
  input_.built = rim_.built = points_.built = {};
}

void SceneLayers::forget_state() {
  zero_set_.built = curves_.built = dropped_.built = gamma_.built = tetrahedra_.built = samples_.built = {};
}

void SceneLayers::forget_all() {
  forget_scene();
  forget_state();
  forget_other();
}

void SceneLayers::update(const LayerInputs& inputs, const ViewFrame& frame) {
  const ViewSettings& view = frame.view;
  const Clip clip(view.clip);
  const auto refresh = [](const LayerSettings& shown, const Built& wanted, auto& kept, auto update) {
    if (!shown.shown() || kept.built == wanted) return;
    kept.built = wanted;
    if (wanted.source != nullptr)
      update(kept.layer);
    else
      kept.layer.clear();
  };
  Built wanted;
  wanted.made = true;
  wanted.clip = clip_of_cells(view.clip);
  wanted.theme = view.theme;
  wanted.source = inputs.input.get();
  refresh(view.input, wanted, input_,
          [&](InputLayer& layer) { layer.update(*inputs.input, clip, frame.colors, frame.space); });
  wanted.source = inputs.rim();
  refresh(view.rim, wanted, rim_,
          [&](RimLayer& layer) { layer.update(*inputs.rim(), clip, frame.colors, frame.space); });
  wanted.source = inputs.points.get();
  refresh(view.points, wanted, points_,
          [&](PointsLayer& layer) { layer.update(inputs.points, clip, frame.colors, frame); });
  wanted.source = inputs.other.get();
  refresh(view.other_zero, wanted, other_zero_,
          [&](OtherZeroLayer& layer) { layer.update(*inputs.other, clip, frame.colors, frame.space); });
  wanted.source = inputs.state.get();
  const StateSnapshot* state = inputs.state.get();
  Built zero_wanted = wanted;
  zero_wanted.moment = view.moment;
  // A picture may have another view than the window, whose map this is.
  if (inputs.zero_map && inputs.zero_map->kind == view.zero_map) zero_wanted.map = inputs.zero_map;
  refresh(view.zero_set, zero_wanted, zero_set_, [&](ZeroSetLayer& layer) {
    layer.update(*state, view.moment, zero_wanted.map.get(), clip, frame.colors, frame.space);
  });
  refresh(view.curves, wanted, curves_,
          [&](CurvesLayer& layer) { layer.update(*state, clip, frame.colors, frame.space); });
  refresh(view.dropped, wanted, dropped_,
          [&](DroppedLayer& layer) { layer.update(*state, clip, frame.colors, frame.space); });
  Built gamma_wanted = wanted;
  gamma_wanted.tets.box = view.tets.box;
  refresh(view.gamma, gamma_wanted, gamma_,
          [&](GammaLayer& layer) { layer.update(*state, view.tets.box, clip, frame.colors, frame.space); });
  Built sample_wanted = wanted;
  sample_wanted.good = view.good_samples.shown();
  sample_wanted.bad = view.bad_samples.shown();
  sample_wanted.over_rim = view.over_rim.shown();
  sample_wanted.near_samples = view.near_samples;
  refresh(view.samples, sample_wanted, samples_,
          [&](SamplesLayer& layer) { layer.update(*state, view, clip, frame.space); });
  // Cut tetrahedra depend on the clip too: only those that it touches or keeps are uploaded.
  wanted.clip = view.clip;
  wanted.tets = view.tets;
  wanted.good = view.side_tint;
  refresh(view.tetrahedra, wanted, tetrahedra_, [&](TetrahedraLayer& layer) {
    layer.update(*state, view.tets, view.side_tint, clip, frame.colors, frame.space);
  });
  if (CutLayer::shown(frame)) cut_.update(inputs.state, inputs.scene ? 3e-3 * inputs.scene->delta : 0, frame);
  highlight_.update(state, frame);
  attempt_.update(view.xray.shown() ? inputs.xray.get() : nullptr, inputs.study.get(), frame);
  annotations_.update(inputs.annotation.get(), frame);
  preview_.update(state, inputs.preview.get(), frame);
}

void SceneLayers::draw_opaque(Programs& programs, const ViewFrame& frame, const FrameQuality& quality) {
  const ViewSettings& view = frame.view;
  if (solid(view.input)) input_.layer.draw(programs.mesh_opaque, frame);
  if (solid(view.zero_set)) zero_set_.layer.draw(programs.mesh_opaque, frame);
  if (solid(view.dropped)) dropped_.layer.draw(programs.mesh_opaque, frame);
  if (solid(view.tetrahedra)) tetrahedra_.layer.draw_solid(programs.mesh_opaque, frame);
  // Coverage smooths the sprites' edges; what is covered is opaque.
  const bool smooth = quality.samples > 1;
  if (smooth) {
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  }
  if (view.points.shown()) {
    programs.point.use();
    programs.point.set("smooth_edges", smooth ? 1 : 0);
    points_.layer.draw(programs.point, frame, quality.sprites);
  }
  if (view.samples.shown()) {
    programs.sample.use();
    programs.sample.set("smooth_edges", smooth ? 1 : 0);
    samples_.layer.draw(programs.sample, frame, quality.sprites);
  }
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glDisable(GL_SAMPLE_ALPHA_TO_ONE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (view.gamma.shown()) gamma_.layer.draw(programs.line, frame);
  if (view.other_zero.shown()) other_zero_.layer.draw(programs.line, frame);
  if (view.rim.shown()) rim_.layer.draw(programs.line, frame);
  if (view.curves.shown()) curves_.layer.draw(programs, frame);
  glDisable(GL_BLEND);
}

bool SceneLayers::has_cells(const ViewSettings& view) const {
  return thin(view.input) || thin(view.zero_set) || thin(view.dropped) ||
         (view.tetrahedra.shown() && (tetrahedra_.layer.has_faint() || view.tetrahedra.opacity < 1));
}

void SceneLayers::draw_cells(Programs& programs, const ViewFrame& frame) {
  const ViewSettings& view = frame.view;
  if (thin(view.input)) input_.layer.draw(programs.mesh_translucent, frame);
  if (thin(view.zero_set)) zero_set_.layer.draw(programs.mesh_translucent, frame);
  if (thin(view.dropped)) dropped_.layer.draw(programs.mesh_translucent, frame);
  if (!view.tetrahedra.shown()) return;
  if (thin(view.tetrahedra)) tetrahedra_.layer.draw_solid(programs.mesh_translucent, frame);
  tetrahedra_.layer.draw_faint(programs.mesh_translucent, frame);
}

void SceneLayers::draw_over(Programs& programs, const ViewFrame& frame) {
  if (CutLayer::shown(frame)) cut_.draw(programs, frame);
  preview_.draw(programs);
  highlight_.draw(programs, frame);
  attempt_.draw(programs, frame);
  annotations_.draw(programs, frame);
}

} // namespace isoscope
