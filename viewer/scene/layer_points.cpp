// Points of the input as sprites in the colour of their weight.
#include "scene/layer_points.h"

#include "scene/mesh_batch.h"
#include "scene/thinning.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

/// 16 bytes.
struct PointVertex {
  glm::vec3 position;
  Color8 tint;
};

} // namespace

void PointsLayer::upload(const SceneColors& colors, const ViewFrame& frame) {
  const std::size_t count = points_->size();
  std::vector<PointVertex> vertices(count);
  for (std::size_t i = 0; i < count; ++i)
    vertices[i] = {space_.local(points_->position(i)),
                   points_->dropped(i) ? color8(colors.dropped, 0)
                                       : color8(weight_color(frame.view.theme, points_->weights[i]))};
  vertices_.upload(std::span<const PointVertex>(vertices));
  using Type = gl::Attribute::Type;
  const std::array<gl::Attribute, 2> attributes{{{0, 3, Type::f32, 0}, {1, 4, Type::u8_normalized, 12}}};
  for (Class* group : {&kept_, &dropped_}) group->array.attach(vertices_, sizeof(PointVertex), attributes);
}

void PointsLayer::update(std::shared_ptr<const InputPoints> points, const Clip& clip,
                         const SceneColors& colors, const ViewFrame& frame) {
  if (points != points_) {
    const std::vector<std::int8_t> one_kind(points->size(), 1);
    order_ = thinning_order(points->soup->points, one_kind);
  }
  if (points != points_ || frame.space != space_ || frame.view.theme != theme_) {
    points_ = std::move(points);
    space_ = frame.space;
    theme_ = frame.view.theme;
    upload(colors, frame);
  }
  std::vector<std::uint32_t> kept, dropped;
  const bool whole_cells = clip.active() && !clip.cuts();
  for (const std::uint32_t id : order_) {
    if (whole_cells && !clip.keeps(points_->position(id))) continue;
    (points_->dropped(id) ? dropped : kept).push_back(id);
  }
  const auto set = [](Class& group, const std::vector<std::uint32_t>& ids) {
    group.count = ids.size();
    if (ids.empty()) return;
    group.indices.upload(std::span<const std::uint32_t>(ids));
    group.array.attach_indices(group.indices);
  };
  set(kept_, kept);
  set(dropped_, dropped);
}

void PointsLayer::draw(gl::Program& program, const ViewFrame& frame, std::size_t budget) {
  if (kept_.count + dropped_.count == 0) return;
  // Sprites closer to each other than this (pixels) would merge into a sheet.
  constexpr double gap = 3.5;
  const double spacing = points_->spacing * frame.pixels_per_unit / static_cast<double>(frame.pixel_scale);
  const double part = spacing > 0 ? std::min(1.0, spacing * spacing / (gap * gap)) : 1.0;
  const std::size_t dropped = std::min(dropped_.count, budget / 2);
  const std::size_t kept = std::min(
      static_cast<std::size_t>(std::ceil(part * static_cast<double>(kept_.count))), budget - dropped);
  program.use();
  program.set("ground", 0.5f * (frame.colors.ground_top + frame.colors.ground_bottom));
  program.set("size", 1.1f * frame.view.sample_size);
  program.set("opacity", frame.view.points.opacity);
  // A thinned set is sparser: its sprites may be as much larger.
  const double shown = kept_.count > 0 ? static_cast<double>(kept) / static_cast<double>(kept_.count) : 1;
  program.set("spacing", static_cast<float>(points_->spacing / std::sqrt(std::max(shown, 1e-9))));
  glEnable(GL_PROGRAM_POINT_SIZE);
  const auto run = [](Class& group, std::size_t count) {
    if (count == 0) return;
    group.array.bind();
    glDrawElements(GL_POINTS, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
  };
  run(kept_, kept);
  run(dropped_, dropped);
}

} // namespace isoscope
