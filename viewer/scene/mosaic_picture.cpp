// Closed bricks and facets in one batch, outlines and marks over them.
#include "scene/mosaic_picture.h"

#include "embedded/shaders.h"
#include "gl/device.h"
#include "gl/program.h"
#include "gl/shader_source.h"
#include "scene/frame_targets.h"
#include "scene/full_screen_passes.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

struct MosaicPrograms {
  gl::Program background, mesh, line, marker, copy;
};

Result<MosaicPrograms> build_mosaic_programs() {
  const gl::ShaderSource source(embedded::shaders(), "");
  MosaicPrograms programs;
  const ProgramEntry entries[] = {{programs.background, "background", "fullscreen.vert", "background.frag"},
                                  {programs.mesh, "mesh_opaque", "mesh.vert", "mesh_opaque.frag"},
                                  {programs.line, "line", "line.vert", "line.frag"},
                                  {programs.marker, "marker", "marker.vert", "marker.frag"},
                                  {programs.copy, "copy", "fullscreen.vert", "copy.frag"}};
  if (const Status built = build_programs(source, entries); !built) return built.error();
  return programs;
}

/// The eight corners; bit k of a number: the upper end of axis k.
std::array<glm::vec3, 8> brick_corners(const Box3& box, const SceneSpace& space) {
  std::array<glm::vec3, 8> corners{};
  for (std::size_t c = 0; c < corners.size(); ++c)
    corners[c] = space.local({(c & 1u) != 0 ? box.hi.x : box.lo.x, (c & 2u) != 0 ? box.hi.y : box.lo.y,
                              (c & 4u) != 0 ? box.hi.z : box.lo.z});
  return corners;
}

void add_brick(MeshBuilder& mesh, const Box3& box, const SceneSpace& space, Color8 tint) {
  const auto c = brick_corners(box, space);
  constexpr std::array<std::array<std::size_t, 4>, 6> sides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& s : sides) mesh.quad({c[s[0]], c[s[1]], c[s[2]], c[s[3]]}, tint);
}

void add_brick_outline(LineBuilder& lines, const Box3& box, const SceneSpace& space, Color8 tint,
                       float width) {
  const auto c = brick_corners(box, space);
  for (std::size_t from = 0; from < c.size(); ++from)
    for (const std::size_t axis : {1u, 2u, 4u})
      if ((from & axis) == 0) lines.segment(c[from], c[from | axis], tint, width);
}

} // namespace

struct MosaicPicture::Impl {
  Impl(MosaicPrograms compiled, const gl::Device& found)
      : programs(std::move(compiled)), most_samples(found.max_samples) {}

  MosaicPrograms programs;
  int most_samples;
  FullScreenPasses passes;
  FrameTargets targets;
  FrameBlock block;
  std::shared_ptr<const MosaicScene> scene;
  ThemeKind theme = ThemeKind::dark;
  SceneColors colors = scene_colors(ThemeKind::dark);
  SceneSpace space;
  MeshBatch mesh;
  LineBatch outlines, lit_lines;
  MarkerBatch frozen;
  std::optional<std::uint32_t> lit;
  bool lit_made = false;

  void upload();
  void upload_lit(std::optional<std::uint32_t> tile);
  void draw(const FrameRequest& request);
};

void MosaicPicture::Impl::upload() {
  MeshBuilder faces;
  LineBuilder lines;
  std::vector<Marker> marks;
  lit_made = false;
  if (scene) {
    if (const Box3 box = scene->bounds(); !box.empty()) space.origin = box.center();
    for (const MosaicScene::Brick& b : scene->bricks) {
      const MosaicScene::Tile& t = scene->tiles[b.tile];
      if (t.closed)
        add_brick(faces, drawn_box(b.box), space, color8(t.color));
      else
        add_brick_outline(lines, drawn_box(b.box), space, color8(t.color, 0.34f), 1);
    }
    for (std::size_t f = 0; f < scene->facets.size(); ++f) {
      const MosaicScene::Tile& t = scene->tiles[scene->tile_of_facet[f]];
      const Triangle3& p = scene->facets[f];
      if (!t.closed) faces.triangle(space.local(p[0]), space.local(p[1]), space.local(p[2]), color8(t.color));
    }
    for (const Vec3 p : scene->frozen)
      marks.push_back({space.local(p), color8(frozen_color(colors)), MarkerShape::disc, 6});
  }
  mesh.upload(faces);
  outlines.upload(lines);
  frozen.upload(marks);
}

void MosaicPicture::Impl::upload_lit(std::optional<std::uint32_t> tile) {
  if (lit_made && lit == tile) return;
  lit = tile;
  lit_made = true;
  LineBuilder lines;
  if (scene && tile && *tile < scene->tiles.size() && !scene->tiles[*tile].box.empty()) {
    for (const MosaicScene::Brick& b : scene->bricks)
      if (b.tile == *tile) add_brick_outline(lines, b.box, space, color8(colors.selection, 0.5f), 1.2f);
    add_brick_outline(lines, scene->tiles[*tile].box, space, color8(colors.selection), 2.5f);
  }
  lit_lines.upload(lines);
}

void MosaicPicture::Impl::draw(const FrameRequest& request) {
  passes.begin_opaque(programs.background, colors, glm::vec2(0, 1), 1);
  MeshStyle style;
  style.back_shade = 0.7f;
  style.edge_color = glm::vec4(colors.zero_set_edge, 0.55f);
  style.edge_width = request.pixel_scale;
  mesh.draw(programs.mesh, style);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  outlines.draw(programs.line, 1);
  frozen.draw(programs.marker, 1);
  lit_lines.draw(programs.line, 1, 3e-3f);
  glDepthFunc(GL_GREATER);
  lit_lines.draw(programs.line, 0.3f);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

MosaicPicture::MosaicPicture() = default;
MosaicPicture::~MosaicPicture() = default;

Result<std::unique_ptr<MosaicPicture>> MosaicPicture::create() {
  const auto device = gl::current_device();
  if (!device) return device.error();
  auto programs = build_mosaic_programs();
  if (!programs) return programs.error();
  std::unique_ptr<MosaicPicture> picture(new MosaicPicture());
  picture->impl_ = std::make_unique<Impl>(std::move(*programs), *device);
  return picture;
}

void MosaicPicture::set(std::shared_ptr<const MosaicScene> scene, ThemeKind theme) {
  Impl& m = *impl_;
  if (m.scene == scene && m.theme == theme) return;
  m.scene = std::move(scene);
  m.theme = theme;
  m.colors = scene_colors(theme);
  m.upload();
}

Renderer::Frame MosaicPicture::render(const Camera& camera, std::optional<std::uint32_t> lit,
                                      const FrameRequest& request) {
  Impl& m = *impl_;
  if (request.width <= 0 || request.height <= 0) return {};
  // Averaging smooths edges without samples.
  const int samples = request.still > 0 ? 1 : std::min(4, m.most_samples);
  if (!m.targets.resize(request.width, request.height, samples, 1, 1)) return {};
  if (request.still == 1) m.passes.average(m.targets, m.programs.copy, m.targets.color, 1);
  m.upload_lit(lit);
  Camera bounded = camera;
  if (m.scene)
    if (const Box3 box = m.scene->bounds(); !box.empty())
      bounded.set_scene_bounds(box.grown(0.01 * box.longest_edge()));
  m.block.upload(moved_uniforms(
      frame_uniforms(bounded, m.space, ClipSettings{}, request.width, request.height, request.pixel_scale),
      still_offset(request.still)));
  (samples > 1 ? m.targets.multisampled : m.targets.opaque).bind(request.width, request.height);
  m.draw(request);
  if (samples > 1) m.targets.multisampled.resolve_into(m.targets.opaque, request.width, request.height, true);
  if (request.still > 0)
    m.passes.average(m.targets, m.programs.copy, m.targets.color, 1 / static_cast<float>(request.still + 1));
  leave_frame();
  return {(request.still > 0 ? m.targets.average : m.targets.color).id(), m.targets.width, m.targets.height};
}

} // namespace isoscope
