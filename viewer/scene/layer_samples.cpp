// Samples as sprites: good discs, bad crosses; full on the outer side, rings on the inner; diamonds over the
// rim.
#include "scene/layer_samples.h"

#include "mesh/sample_sets.h"
#include "scene/sample_scope.h"
#include "scene/thinning.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

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
  using Type = gl::Attribute::Type;
  const std::array<gl::Attribute, 2> attributes{{{0, 3, Type::f32, 0}, {1, 1, Type::u32, 12}}};
  const auto fill = [&](gl::Buffer& buffer, std::initializer_list<Class*> groups,
                        const std::vector<Vec3>& positions, const std::vector<std::int8_t>& labels) {
    std::vector<SampleVertex> vertices(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
      vertices[i] = {space.local(positions[i]), labels[i] > 0 ? 1u : 0u};
    buffer.upload(std::span<const SampleVertex>(vertices));
    for (Class* group : groups) group->array.attach(buffer, sizeof(SampleVertex), attributes);
    return thinning_order(positions, labels);
  };
  order_ = fill(positions_, {&good_, &bad_}, samples_->positions, samples_->labels);
  const std::vector<std::int8_t> one_kind(samples_->over_rim.size(), 1);
  over_rim_order_ = fill(over_rim_positions_, {&over_rim_}, samples_->over_rim, one_kind);
}

void SamplesLayer::update(const StateSnapshot& state, const ViewSettings& view, const Clip& clip,
                          const SceneSpace& space) {
  if (!state.samples) {
    clear();
    return;
  }
  if (state.samples != samples_ || space != space_) upload_positions(state.samples, space);
  classified_ = state.classifies();
  std::vector<std::uint32_t> good, bad, over_rim;
  const bool whole_cells = clip.active() && !clip.cuts();
  const SampleScope scope(state, view);
  for (const std::uint32_t id : order_) {
    const bool is_bad_sample = id < state.errors.size() && is_bad(static_cast<double>(state.errors[id]));
    if (!(is_bad_sample ? view.bad_samples : view.good_samples).shown()) continue;
    if (!is_bad_sample && !scope.shows_good(samples_->positions[id])) continue;
    if (whole_cells) {
      const TetId tet = id < state.sample_tets.size() ? state.sample_tets[id] : TetId();
      const Vec3 p = state.samples->positions[id];
      const bool known = tet.valid() && state.complex.tet(tet).alive();
      if (!(known ? clip.shows_point(p, state.complex.positions(tet)) : clip.keeps(p))) continue;
    }
    (is_bad_sample ? bad : good).push_back(id);
  }
  for (const std::uint32_t id : over_rim_order_)
    if (view.over_rim.shown() && (!whole_cells || clip.keeps(samples_->over_rim[id]))) over_rim.push_back(id);
  const auto upload = [](Class& group, const std::vector<std::uint32_t>& ids) {
    group.count = ids.size();
    if (ids.empty()) return;
    group.indices.upload(std::span<const std::uint32_t>(ids));
    group.array.attach_indices(group.indices);
  };
  upload(good_, good);
  upload(bad_, bad);
  upload(over_rim_, over_rim);
}

void SamplesLayer::clear() {
  good_.count = bad_.count = over_rim_.count = 0;
}

void SamplesLayer::draw_class(gl::Program& program, const ViewFrame& frame, Class& group, std::size_t count,
                              const Look& look) const {
  if (count == 0) return;
  // A thinned set is sparser: its sprites may be as much larger.
  const double kept = static_cast<double>(count) / static_cast<double>(group.count);
  program.set("spacing", static_cast<float>(samples_->sigma / std::sqrt(kept)));
  program.set("tint", look.tint);
  program.set("glyph", look.glyph);
  program.set("size", frame.view.sample_size * look.size);
  program.set("smallest", look.smallest);
  program.set("opacity", look.opacity * frame.view.samples.opacity);
  group.array.bind();
  glDrawElements(GL_POINTS, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
}

void SamplesLayer::draw(gl::Program& program, const ViewFrame& frame, std::size_t budget) {
  if (good_.count + bad_.count + over_rim_.count == 0) return;
  // Sprites closer to each other than this (pixels) would merge into a sheet that hides the rest of the
  // scene.
  constexpr double gap = 5.5;
  const double spacing = samples_->sigma * frame.pixels_per_unit / static_cast<double>(frame.pixel_scale);
  const auto thinned = [&](std::size_t count, std::size_t limit, double apart) {
    const double part = spacing > 0 ? std::min(1.0, spacing * spacing / (apart * apart)) : 1.0;
    return std::min(static_cast<std::size_t>(std::ceil(part * static_cast<double>(count))), limit);
  };
  // Where nearly every sample of a boundary is bad, as before Z is there, each of them tells less.
  constexpr double most_apart = 13;
  const double share =
      static_cast<double>(bad_.count) / static_cast<double>(std::max<std::size_t>(samples_->size(), 1));
  const double bad_gap = std::clamp(6 * gap * share, gap, most_apart);
  const std::size_t bad = thinned(bad_.count, budget, bad_gap);
  const std::size_t good = thinned(good_.count, budget - bad, gap);
  const std::size_t over_rim = thinned(over_rim_.count, budget - bad - good, gap);
  thinned_ = bad_.count + good_.count + over_rim_.count - bad - good - over_rim;
  program.use();
  program.set("ground", 0.5f * (frame.colors.ground_top + frame.colors.ground_bottom));
  glEnable(GL_PROGRAM_POINT_SIZE);
  const ViewSettings& view = frame.view;
  // Without a verdict they are no more than a hint of S.
  const float known = classified_ ? 1.0f : 0.3f;
  const glm::vec3 good_tint = classified_ ? frame.colors.good : frame.colors.tetrahedron;
  draw_class(program, frame, good_, good, {good_tint, 0, 1, 1.6f, view.good_samples.opacity * known});
  draw_class(
      program, frame, bad_, bad,
      {frame.colors.bad, 1, static_cast<float>(1.7 * gap / bad_gap), 4.5f, view.bad_samples.opacity * known});
  draw_class(program, frame, over_rim_, over_rim,
             {frame.colors.rim, 2, 1.5f, 3.0f, view.over_rim.opacity * known});
}

} // namespace isoscope
