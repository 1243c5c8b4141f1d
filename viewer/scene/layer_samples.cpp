// Samples as sprites: good discs, bad crosses; full on the outer side, rings on the inner.
#include "scene/layer_samples.h"

#include "mesh/sample_sets.h"
#include "scene/thinning.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

struct SampleVertex {
  glm::vec3 position;
  std::uint32_t outer;
};

} // namespace

void SamplesLayer::upload_positions(std::shared_ptr<const BoundarySamples> samples, const SceneSpace& space) {
  samples_ = std::move(samples);
  space_ = space;
  const std::size_t count = samples_->size();
  std::vector<SampleVertex> vertices(count);
  for (std::size_t i = 0; i < count; ++i)
    vertices[i] = {space.local(samples_->positions[i]), samples_->labels[i] > 0 ? 1u : 0u};
  positions_.upload(std::span<const SampleVertex>(vertices));
  order_ = thinning_order(samples_->positions, samples_->labels);
  using Type = gl::Attribute::Type;
  const std::array<gl::Attribute, 2> attributes{{{0, 3, Type::f32, 0}, {1, 1, Type::u32, 12}}};
  good_.array.attach(positions_, sizeof(SampleVertex), attributes);
  bad_.array.attach(positions_, sizeof(SampleVertex), attributes);
}

void SamplesLayer::update(const StateSnapshot& state, const ViewSettings& view, const Clip& clip,
                          const SceneSpace& space) {
  if (!state.samples) {
    clear();
    return;
  }
  if (state.samples != samples_ || space != space_) upload_positions(state.samples, space);
  classified_ = state.complex.form != ZeroForm::free;
  std::vector<std::uint32_t> good, bad;
  const bool whole_cells = clip.active() && !clip.cuts();
  for (const std::uint32_t id : order_) {
    const bool is_bad_sample = id < state.errors.size() && is_bad(static_cast<double>(state.errors[id]));
    if (!(is_bad_sample ? view.bad_samples : view.good_samples).shown()) continue;
    if (whole_cells) {
      const TetId tet = id < state.sample_tets.size() ? state.sample_tets[id] : TetId();
      const Vec3 p = state.samples->positions[id];
      const bool known = tet.valid() && state.complex.tet(tet).alive();
      if (!(known ? clip.shows_point(p, state.complex.positions(tet)) : clip.keeps(p))) continue;
    }
    (is_bad_sample ? bad : good).push_back(id);
  }
  const auto upload = [](Class& group, const std::vector<std::uint32_t>& ids) {
    group.count = ids.size();
    if (ids.empty()) return;
    group.indices.upload(std::span<const std::uint32_t>(ids));
    group.array.attach_indices(group.indices);
  };
  upload(good_, good);
  upload(bad_, bad);
}

void SamplesLayer::clear() {
  good_.count = bad_.count = 0;
}

void SamplesLayer::draw_class(gl::Program& program, const ViewFrame& frame, Class& group, std::size_t count,
                              bool bad) {
  if (count == 0) return;
  const LayerSettings& layer = bad ? frame.view.bad_samples : frame.view.good_samples;
  // A thinned set is sparser: its sprites may be as much larger.
  const double kept = static_cast<double>(count) / static_cast<double>(group.count);
  program.set("spacing", static_cast<float>(samples_->sigma / std::sqrt(kept)));
  program.set("tint", bad ? frame.colors.bad : classified_ ? frame.colors.good : frame.colors.tetrahedron);
  program.set("cross_glyph", bad ? 1 : 0);
  program.set("size", frame.view.sample_size * (bad ? 1.7f : 1.0f));
  program.set("smallest", bad ? 4.5f : 1.6f);
  // Without a verdict they are no more than a hint of S.
  program.set("opacity", layer.opacity * frame.view.samples.opacity * (classified_ ? 1.0f : 0.3f));
  group.array.bind();
  glDrawElements(GL_POINTS, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
}

void SamplesLayer::draw(gl::Program& program, const ViewFrame& frame, std::size_t budget) {
  if (good_.count + bad_.count == 0) return;
  // Sprites closer to each other than this (pixels) would merge into a sheet that hides the rest of the
  // scene.
  constexpr double good_gap = 5.5, bad_gap = 5.5;
  const double spacing = samples_->sigma * frame.pixels_per_unit / static_cast<double>(frame.pixel_scale);
  const auto thinned = [&](std::size_t count, double gap, std::size_t limit) {
    const double part = spacing > 0 ? std::min(1.0, spacing * spacing / (gap * gap)) : 1.0;
    return std::min(static_cast<std::size_t>(std::ceil(part * static_cast<double>(count))), limit);
  };
  const std::size_t bad = thinned(bad_.count, bad_gap, budget);
  const std::size_t good = thinned(good_.count, good_gap, budget - bad);
  thinned_ = bad_.count + good_.count - bad - good;
  program.use();
  program.set("ground", 0.5f * (frame.colors.ground_top + frame.colors.ground_bottom));
  glEnable(GL_PROGRAM_POINT_SIZE);
  draw_class(program, frame, good_, good, false);
  draw_class(program, frame, bad_, bad, true);
}

} // namespace isoscope
