// Makes states of a small run from the core's parts, without the pipeline.
#include "scene/fabricate.h"

#include "base/labels.h"
#include "mesh/delaunay.h"
#include "mesh/sample_sets.h"
#include "tolerance/closest_point.h"
#include "tolerance/grid_sides.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isoscope::testing {
namespace {

std::vector<Vertex> box_corners(const Box3& box, double reach) {
  std::vector<Vertex> corners;
  for (int i = 0; i < 8; ++i) {
    Vertex v;
    v.position = {(i & 1) ? box.hi.x : box.lo.x, (i & 2) ? box.hi.y : box.lo.y,
                  (i & 4) ? box.hi.z : box.lo.z};
    v.value = reach;
    v.kind = VertexKind::box;
    corners.push_back(v);
  }
  return corners;
}

/// f at every sample, in the tetrahedra that hold them.
void judge(StateSnapshot& state) {
  const BoundarySamples& samples = *state.samples;
  SampleSets sets{std::span<const Vec3>(samples.positions)};
  sets.assign_all(state.complex);
  state.errors.resize(samples.size());
  state.sample_tets.resize(samples.size());
  state.bad_samples = 0;
  state.largest_error = -1e30f;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const TetId tet = sets.tet_of(SampleId(i));
    state.sample_tets[i] = tet;
    state.errors[i] =
        static_cast<float>(sample_error_at(state.complex, tet, samples.positions[i], samples.labels[i]));
    if (is_bad(static_cast<double>(state.errors[i]))) ++state.bad_samples;
    if (state.errors[i] > state.largest_error) {
      state.largest_error = state.errors[i];
      state.worst_sample = SampleId(i);
    }
  }
}

void describe(StateSnapshot& state) {
  state.zero_set = extract_zero_set(state.complex);
  state.gamma = gamma_boundary(state.complex);
  state.tet_flags.assign(state.complex.tets.size(), 0);
  for (std::size_t i = 0; i < state.complex.tets.size(); ++i) {
    const Tet& tet = state.complex.tets[i];
    if (!tet.alive()) continue;
    std::uint8_t flags = tet_alive;
    for (const VertexId v : tet.v)
      if (state.complex.vertices[v.index()].kind == VertexKind::box) flags |= tet_box;
    if (state.complex.heterogeneous(TetId(i))) flags |= tet_heterogeneous;
    state.tet_flags[i] = flags;
  }
  for (std::size_t i = 0; i < state.errors.size(); ++i)
    if (state.errors[i] > 0.8f) state.tet_flags[state.sample_tets[i].index()] |= tet_violates_1;
  for (const TetId tet : state.added_tets) state.tet_flags[tet.index()] |= tet_changed;
}

template <class T> T take(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().line());
  return std::move(*result);
}

/// Refines over the samples of a scene that is complete but for them.
Fabricated refine(const std::shared_ptr<Scene>& scene, std::shared_ptr<const BoundarySamples> samples,
                  std::size_t steps, int resolution) {
  RunControl control;
  scene->samples = samples;
  auto state = std::make_shared<StateSnapshot>();
  state->samples = samples;
  Delaunay delaunay;
  const Box3 box = scene->input->bounds().grown(0.6 * scene->longest_edge);
  state->complex.apply(delaunay.start(box_corners(box, 127)));
  judge(*state);
  for (std::size_t step = 0; step < steps && state->largest_error > 0.8f; ++step) {
    // The worst samples of many tetrahedra go in together between two judgements; only pictures depend on it.
    std::vector<std::uint32_t> worst(state->complex.tets.size(), SampleId::none);
    for (std::uint32_t i = 0; i < samples->size(); ++i) {
      std::uint32_t& best = worst[state->sample_tets[i].index()];
      if (state->errors[i] > 0.8f && (best == SampleId::none || state->errors[i] > state->errors[best]))
        best = i;
    }
    std::erase(worst, SampleId::none);
    std::sort(worst.begin(), worst.end(),
              [&](std::uint32_t a, std::uint32_t b) { return state->errors[a] > state->errors[b]; });
    worst.resize(std::min<std::size_t>(worst.size(), std::min<std::size_t>(1 + step / 20, steps - step)));
    for (const std::uint32_t id : worst) {
      Vertex vertex;
      vertex.position = samples->positions[id];
      vertex.value = samples->labels[id] > 0 ? 1 : -1;
      vertex.room = room_of(samples->labels[id]);
      vertex.sample = SampleId(id);
      const auto delta_of_insertion = delaunay.insert(vertex, TetId());
      if (!delta_of_insertion) continue;
      state->removed_tets.clear();
      for (const TetRecord& removed : delta_of_insertion->removed)
        state->removed_tets.push_back(state->complex.positions(removed.id));
      state->violated_tet = state->removed_tets.front();
      state->complex.apply(*delta_of_insertion);
      state->added_tets.clear();
      for (const TetRecord& added : delta_of_insertion->added) state->added_tets.push_back(added.id);
      state->inserted = VertexId(state->complex.vertices.size() - 1);
    }
    step += worst.size() - 1;
    judge(*state);
  }
  describe(*state);
  GridWish wish;
  wish.delta = scene->delta;
  wish.level = 2;
  wish.voxel = (scene->longest_edge + 4 * scene->delta) / resolution;
  auto grid = std::make_shared<DistanceGrid>(take(make_distance_grid(*scene->field, wish, control)));
  const InputSides sides({scene->field, scene->field->surface()}, SideRule::parity, nullptr);
  if (const Status found = find_sides(*grid, {*scene->field, sides, scene->delta, scene->regions}, control);
      !found)
    throw std::runtime_error(found.error().line());
  return {scene, state, grid};
}

/// Points spread evenly over a sphere along a spiral.
void add_sphere(BoundarySamples& samples, Vec3 center, double radius, std::size_t count, int label) {
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double angle = 2.39996322972865332 * static_cast<double>(i), around = std::sqrt(1 - z * z);
    samples.positions.push_back(center +
                                radius * Vec3{around * std::cos(angle), around * std::sin(angle), z});
    samples.labels.push_back(static_cast<std::int8_t>(label));
    samples.components.push_back(label > 0 ? 0 : 1);
  }
}

std::shared_ptr<Scene> prepare(const TriangleSoup& soup, double delta) {
  auto scene = std::make_shared<Scene>();
  scene->input = std::make_shared<TriangleSoup>(soup);
  scene->field = std::make_shared<ClosestPointIndex>(soup);
  scene->longest_edge = soup.bounds().longest_edge();
  scene->delta = delta / 100 * scene->longest_edge;
  return scene;
}

} // namespace

Fabricated fabricate(const TriangleSoup& soup, double delta, double sigma, std::size_t steps,
                     int resolution) {
  RunControl control;
  auto scene = prepare(soup, delta);
  scene->input_topology = analyse_input(soup);
  ToleranceVolume volume =
      take(ToleranceVolume::build(scene->field, scene->input_topology, {scene->delta, 0.95}, control));
  auto samples =
      std::make_shared<BoundarySamples>(take(sample_boundary(volume, sigma * scene->delta, control)));
  scene->thresholds = volume.thresholds();
  scene->regions.assign(volume.regions().begin(), volume.regions().end());
  return refine(scene, samples, steps, resolution);
}

Fabricated fabricate_ball(const TriangleSoup& sphere, double delta, std::size_t count, std::size_t steps,
                          int resolution) {
  auto scene = prepare(sphere, delta);
  const Box3 box = sphere.bounds();
  const double radius = 0.5 * box.longest_edge(), away = 0.95 * scene->delta;
  auto samples = std::make_shared<BoundarySamples>();
  add_sphere(*samples, box.center(), radius + away, count, 1);
  add_sphere(*samples, box.center(), radius - away, count, -1);
  samples->sigma = radius * std::sqrt(12.5 / static_cast<double>(count));
  return refine(scene, samples, steps, resolution);
}

} // namespace isoscope::testing
