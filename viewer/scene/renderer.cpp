// Draws a state into a framebuffer of its own: keeps the layers up to date and orders the passes.
#include "scene/renderer.h"

#include "embedded/shaders.h"
#include "gl/device.h"
#include "gl/shader_source.h"
#include "scene/first_box.h"
#include "scene/frame_targets.h"
#include "scene/full_screen_passes.h"
#include "scene/overlay.h"
#include "scene/picking.h"
#include "scene/programs.h"
#include "scene/quality_control.h"
#include "scene/scene_layers.h"
#include "scene/section.h"
#include "scene/view_frame.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace isoscope {
namespace {

#ifdef ISOSCOPE_SHADER_FOLDER
constexpr const char* shader_folder = ISOSCOPE_SHADER_FOLDER;
#else
constexpr const char* shader_folder = "";
#endif

} // namespace

struct Renderer::Impl {
  Impl(Programs compiled, gl::ShaderSource shaders, const gl::Device& found)
      : programs(std::move(compiled)), source(std::move(shaders)), device(found), control(found.software) {
    revision = source.revision();
  }

  Programs programs;
  gl::ShaderSource source;
  std::uint64_t revision = 0;
  gl::Device device;
  QualityControl control;
  FrameTargets targets, section_targets, tile_targets;
  FrameBlock block;
  FullScreenPasses passes;

  LayerInputs shown;
  std::shared_ptr<const DistanceGrid> grid;
  SceneSpace space;
  SceneLayers layers;
  SectionLayer section;
  double seconds = 0;

  Box3 bounds() const;
  Box3 visible_bounds(const ViewSettings& view) const;
  void place_origin();
  void upload_grid();
  void reload_shaders();
  void upload_frame(const Camera& camera, const ClipSettings& clip, const FrameRequest& request,
                    const ViewFrame& frame);
  void draw_opaque(const ViewFrame& frame, const FrameRequest& request, const FrameQuality& quality);
  void draw_cells(const FrameTargets& drawn, const ViewFrame& frame);
  void composite(const FrameTargets& drawn, bool with_cells, bool with_volume);
  ViewFrame view_frame(const Camera& camera, const ViewSettings& view, const FrameRequest& request, int width,
                       int height) const;
  /// Takes the result into the average, by that part.
  void average(FrameTargets& drawn, float part) { passes.average(drawn, programs.copy, drawn.result, part); }
  Renderer::Frame finish(FrameTargets& drawn, std::chrono::steady_clock::time_point start,
                         const FrameRequest& request);
  PickScene pick_scene_data() const {
    return {shown.state.get(), shown.input.get(), grid.get(), shown.points.get()};
  }
};

Box3 Renderer::Impl::bounds() const {
  Box3 box;
  if (shown.input) box = shown.input->bounds().grown(shown.scene ? 2 * shown.scene->delta : 0);
  if (box.empty() && grid) box = grid->box;
  if (box.empty() && shown.state)
    for (const Vertex& v : shown.state->complex.vertices)
      if (v.alive && v.kind != VertexKind::box) box.add(v.position);
  return box;
}

Box3 Renderer::Impl::visible_bounds(const ViewSettings& view) const {
  Box3 box = bounds();
  if (shown.state)
    for (const Vertex& v : shown.state->complex.vertices)
      if (v.alive && (v.kind != VertexKind::box || view.tets.box)) box.add(v.position);
  if (shown.state) box.add(first_box(*shown.state));
  return box;
}

void Renderer::Impl::place_origin() {
  const Box3 box = bounds();
  const Vec3 center = box.empty() ? Vec3{} : box.center();
  const double reach = std::max(box.longest_edge(), 1e-300);
  if (distance(center, space.origin) < 0.5 * reach && !box.empty() && space.origin != Vec3{}) return;
  if (center == space.origin) return;
  space.origin = center;
  layers.forget_all();
}

void Renderer::Impl::upload_grid() {
  if (!grid) {
    layers.tolerance.clear();
    return;
  }
  // The robust distance is nowhere 0: what lies between the sides is no zero of a signed function.
  layers.tolerance.set(grid, shown.points == nullptr);
}

void Renderer::Impl::reload_shaders() {
  const std::uint64_t now = source.revision();
  if (now == revision) return;
  revision = now;
  // A text that does not compile keeps the programs that did.
  if (auto fresh = Programs::build(source)) programs = std::move(*fresh);
}

ViewFrame Renderer::Impl::view_frame(const Camera& camera, const ViewSettings& view,
                                     const FrameRequest& request, int width, int height) const {
  ViewFrame frame{view, scene_colors(view.theme), space, width, height};
  frame.pixel_scale = request.pixel_scale * static_cast<float>(height) / static_cast<float>(request.height);
  frame.quality = request.quality;
  frame.selection = request.selection;
  frame.hover = request.hover;
  frame.pulse = request.pulse;
  frame.mark = request.mark;
  frame.phase = std::fmod(0.6180339887f * static_cast<float>(request.still), 1.0f);
  frame.pixels_per_unit = pixels_per_unit(camera, request.tile ? request.tile->full_height : height);
  if (request.tile) {
    const auto row = [&](int y) {
      return 1 - static_cast<float>(y) / static_cast<float>(request.tile->full_height);
    };
    frame.rows = {row(request.tile->y + height), row(request.tile->y)};
  }
  frame.eye = camera.eye();
  const Vec3 toward = normalized(camera.eye() - camera.pose().target);
  frame.toward = {static_cast<float>(toward.x), static_cast<float>(toward.y), static_cast<float>(toward.z)};
  return frame;
}

void Renderer::Impl::upload_frame(const Camera& camera, const ClipSettings& clip, const FrameRequest& request,
                                  const ViewFrame& frame) {
  const auto upload = [&](const FrameUniforms& uniforms) {
    block.upload(moved_uniforms(uniforms, still_offset(request.still)));
  };
  if (!request.tile)
    return upload(frame_uniforms(camera, space, clip, frame.width, frame.height, frame.pixel_scale));
  const FrameUniforms whole = frame_uniforms(camera, space, clip, request.tile->full_width,
                                             request.tile->full_height, frame.pixel_scale);
  upload(tile_uniforms(whole, *request.tile, frame.width, frame.height));
}

void Renderer::Impl::draw_opaque(const ViewFrame& frame, const FrameRequest& request,
                                 const FrameQuality& quality) {
  passes.begin_opaque(programs.background, frame.colors, frame.rows,
                      request.transparent_background ? 0.0f : 1.0f);
  layers.draw_opaque(programs, frame, quality);
}

void Renderer::Impl::draw_cells(const FrameTargets& drawn, const ViewFrame& frame) {
  if (!layers.has_cells(frame.view)) return;
  drawn.cells.bind(drawn.width, drawn.height);
  constexpr std::array<float, 4> none{0, 0, 0, 0}, clear_part{1, 1, 1, 1};
  glClearBufferfv(GL_COLOR, 0, none.data());
  glClearBufferfv(GL_COLOR, 1, clear_part.data());
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunci(0, GL_ONE, GL_ONE);
  glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
  layers.draw_cells(programs, frame);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void Renderer::Impl::composite(const FrameTargets& drawn, bool with_cells, bool with_volume) {
  drawn.output.bind(drawn.width, drawn.height);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  gl::Program& program = programs.composite;
  program.use();
  const struct {
    const char* name;
    const gl::Texture& texture;
  } inputs[] = {{"opaque_colour", drawn.color},
                {"cell_sum", drawn.cell_sum},
                {"cell_cover", drawn.cell_cover},
                {"volume_colour", drawn.volume_color},
                {"volume_depth", drawn.volume_depth}};
  int unit = 0;
  for (const auto& input_texture : inputs) {
    input_texture.texture.bind(unit);
    program.set(input_texture.name, unit++);
  }
  program.set("with_cells", with_cells ? 1 : 0);
  program.set("with_volume", with_volume ? 1 : 0);
  passes.draw();
  glDepthMask(GL_TRUE);
}

Renderer::Frame Renderer::Impl::finish(FrameTargets& drawn, std::chrono::steady_clock::time_point start,
                                       const FrameRequest& request) {
  if (request.still > 0 && request.strip + 1 == request.strips)
    average(drawn, 1 / static_cast<float>(request.still + 1));
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  leave_frame();
  glFinish();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  control.took(request.quality, seconds);
  return {(request.still > 0 ? drawn.average : drawn.result).id(), drawn.width, drawn.height};
}

Renderer::Renderer() = default;
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create() {
  const auto device = gl::current_device();
  if (!device) return device.error();
  gl::ShaderSource source(embedded::shaders(), shader_folder);
  auto programs = Programs::build(source);
  if (!programs) return programs.error();
  std::unique_ptr<Renderer> renderer(new Renderer());
  renderer->impl_ = std::make_unique<Impl>(std::move(*programs), std::move(source), *device);
  return renderer;
}

void Renderer::set_scene(std::shared_ptr<const Scene> scene) {
  LayerInputs& shown = impl_->shown;
  if (shown.scene == scene) return;
  // The address alone does not tell two scenes apart once the first is gone.
  impl_->layers.forget_scene();
  shown.scene = std::move(scene);
  shown.input = shown.scene ? shown.scene->input : nullptr;
  shown.points = shown.scene ? input_points(*shown.scene) : nullptr;
  impl_->place_origin();
  impl_->upload_grid();
}

void Renderer::set_input(std::shared_ptr<const TriangleSoup> input) {
  LayerInputs& shown = impl_->shown;
  if (shown.scene || shown.input == input) return;
  impl_->layers.forget_scene();
  shown.input = std::move(input);
  shown.points = shown.input ? input_points(shown.input) : nullptr;
  impl_->place_origin();
  impl_->upload_grid();
}

void Renderer::set_other(std::shared_ptr<const StateSnapshot> other) {
  if (impl_->shown.other == other) return;
  impl_->layers.forget_other();
  impl_->shown.other = std::move(other);
}

void Renderer::set_grid(std::shared_ptr<const DistanceGrid> grid) {
  if (impl_->grid == grid) return;
  impl_->grid = std::move(grid);
  impl_->place_origin();
  impl_->upload_grid();
}

void Renderer::set_detail(std::shared_ptr<const DistanceGrid> detail) {
  if (impl_->layers.tolerance.present()) impl_->layers.tolerance.set_detail(std::move(detail));
}

void Renderer::set_state(std::shared_ptr<const StateSnapshot> state) {
  if (impl_->shown.state == state) return;
  impl_->layers.forget_state();
  impl_->shown.state = std::move(state);
  if (!impl_->shown.scene && !impl_->grid) impl_->place_origin();
}

void Renderer::set_xray(std::shared_ptr<const EdgeXray> xray) {
  impl_->shown.xray = std::move(xray);
}

void Renderer::set_study(std::shared_ptr<const TargetStudy> study) {
  impl_->shown.study = std::move(study);
}

void Renderer::set_annotation(std::shared_ptr<const Annotation> annotation) {
  impl_->shown.annotation = std::move(annotation);
}

void Renderer::set_preview(std::shared_ptr<const ViolationPreview> preview) {
  impl_->shown.preview = std::move(preview);
}

void Renderer::set_zero_map(std::shared_ptr<const ZeroMap> map) {
  impl_->shown.zero_map = std::move(map);
}

Box3 Renderer::bounds() const {
  return impl_->bounds();
}

Renderer::Frame Renderer::render(const Camera& camera, const ViewSettings& view,
                                 const FrameRequest& request) {
  Impl& r = *impl_;
  if (request.width <= 0 || request.height <= 0) return {};
  r.reload_shaders();
  const auto start = std::chrono::steady_clock::now();
  FrameQuality quality = r.control.choose(request.quality);
  // Averaging smooths edges without samples.
  quality.samples = request.still > 0 ? 1 : std::min(quality.samples, r.device.max_samples);
  const auto scaled = [](int pixels, double scale) {
    return std::max(1, static_cast<int>(std::lround(pixels * scale)));
  };
  const int width = scaled(request.width, quality.scale), height = scaled(request.height, quality.scale);
  const int volume_width = scaled(width, quality.volume_scale),
            volume_height = scaled(height, quality.volume_scale);
  FrameTargets& targets = request.tile ? r.tile_targets : r.targets;
  if (!targets.resize(width, height, quality.samples, volume_width, volume_height)) return {};

  const bool first_strip = request.strip == 0, last_strip = request.strip + 1 == request.strips;
  if (request.still == 1 && first_strip) r.average(targets, 1);
  const ViewFrame frame = r.view_frame(camera, view, request, width, height);
  r.layers.update(r.shown, frame);
  Camera bounded = camera;
  bounded.set_scene_bounds(r.visible_bounds(view));
  r.upload_frame(bounded, view.clip, request, frame);

  if (first_strip) {
    const bool multisampled = quality.samples > 1;
    (multisampled ? targets.multisampled : targets.opaque).bind(width, height);
    r.draw_opaque(frame, request, quality);
    if (multisampled) targets.multisampled.resolve_into(targets.opaque, width, height, true);
    r.draw_cells(targets, frame);
  }
  const bool with_cells = r.layers.has_cells(view), with_volume = r.layers.tolerance.shown(view);
  if (with_volume) {
    targets.volume.bind(volume_width, volume_height);
    glDisable(GL_DEPTH_TEST);
    r.passes.bind();
    const auto row = [&](int strip) { return volume_height * strip / request.strips; };
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, row(request.strip), volume_width, row(request.strip + 1) - row(request.strip));
    r.layers.tolerance.march(r.programs, frame, targets.depth, quality);
    glDisable(GL_SCISSOR_TEST);
  }
  if (!last_strip) return r.finish(targets, start, request);
  r.composite(targets, with_cells, with_volume);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  r.layers.draw_over(r.programs, frame);
  return r.finish(targets, start, request);
}

Renderer::Frame Renderer::render_section(const SectionView& section, const ViewSettings& view,
                                         const FrameRequest& request) {
  Impl& r = *impl_;
  if (request.width <= 0 || request.height <= 0) return {};
  r.reload_shaders();
  const auto start = std::chrono::steady_clock::now();
  FrameTargets& targets = request.tile ? r.tile_targets : r.section_targets;
  if (!targets.resize(request.width, request.height, 1, 1, 1)) return {};
  const Camera camera = section_camera(section, view.clip);
  if (request.still == 1) r.average(targets, 1);
  const ViewFrame frame = r.view_frame(camera, view, request, request.width, request.height);
  if (request.still == 0) r.section.update(r.shown, frame);
  ClipSettings plane = view.clip;
  plane.shape = ClipSettings::Shape::none;
  r.upload_frame(camera, plane, request, frame);
  targets.output.bind(request.width, request.height);
  r.passes.bind();
  r.section.draw(r.programs, frame, r.layers.tolerance, request.transparent_background ? 0.0f : 1.0f);
  return r.finish(targets, start, request);
}

Pick Renderer::pick(const Camera& camera, const ViewSettings& view, double x, double y, int width, int height,
                    PickKinds kinds, int depth_index) const {
  return pick_scene(impl_->pick_scene_data(), camera, view, {x, y, width, height}, kinds, depth_index);
}

Pick Renderer::pick_section(const SectionView& section, const ViewSettings& view, double x, double y,
                            int width, int height, PickKinds kinds) const {
  if (!impl_->shown.state) return {};
  return pick_section_scene(*impl_->shown.state, impl_->shown.points.get(), section, view,
                            {x, y, width, height}, kinds);
}

Vec3 Renderer::point_under(const Camera& camera, const ViewSettings& view, double x, double y, int width,
                           int height) const {
  return surface_point(impl_->pick_scene_data(), camera, view, {x, y, width, height});
}

std::vector<std::uint8_t> Renderer::read_pixels(const Frame& frame) const {
  return read_picture(frame.texture, frame.width, frame.height);
}

double Renderer::last_frame_seconds() const {
  return impl_->seconds;
}
std::size_t Renderer::thinned_samples() const {
  return impl_->layers.thinned_samples();
}

} // namespace isoscope
