// Judges a whole state at once: sample errors, heights, orientations, and what the last operation touched.
#include "run/snapshot.h"

#include "base/parallel.h"
#include "criteria/height.h"
#include "criteria/orientation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

constexpr std::size_t tets_per_task = 512;

/// ε of every sample, the per-tetrahedron flag of condition 1 and the totals.
void judge_samples(StateSnapshot& s, const SampleSets& sets) {
  const BoundarySamples& samples = *s.samples;
  s.errors.assign(samples.size(), 0);
  s.sample_tets.assign(samples.size(), TetId{});
  const double limit = s.criteria.error_limit();
  parallel_for(s.complex.tets.size(), tets_per_task, [&](std::size_t i) {
    const TetId t(i);
    if (!s.complex.tet(t).alive()) return;
    const AffineFunction f = interpolate(s.complex.positions(t), s.complex.values(t));
    sets.for_each(t, [&](SampleId id) {
      const double error = sample_error(f(samples.positions[id.index()]), samples.labels[id.index()]);
      s.errors[id.index()] = static_cast<float>(error);
      s.sample_tets[id.index()] = t;
      if (error > limit) s.tet_flags[i] |= tet_violates_1;
    });
  });
  s.largest_error = samples.size() == 0 ? 0.0f : -std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < s.errors.size(); ++i) {
    const float error = s.errors[i];
    if (is_bad(error)) ++s.bad_samples;
    if (error > static_cast<float>(limit)) ++s.beyond_margin;
    if (error > s.largest_error) {
      s.largest_error = error;
      s.worst_sample = SampleId(i);
    }
  }
}

void judge_tets(StateSnapshot& s, bool orientation, const NearestSample* nearest) {
  const double limit = s.criteria.height_limit();
  parallel_for(s.complex.tets.size(), tets_per_task, [&](std::size_t i) {
    const TetId t(i);
    if (!s.complex.tet(t).alive()) return;
    std::uint8_t& flags = s.tet_flags[i];
    flags |= tet_alive;
    for (const VertexId v : s.complex.tet(t).v) {
      if (s.complex.vertices[v.index()].kind == VertexKind::box) flags |= tet_box;
    }
    if (!s.complex.heterogeneous(t)) return;
    flags |= tet_heterogeneous;
    const auto p = s.complex.positions(t);
    const auto f = s.complex.values(t);
    const double height = tetrahedron_height(p, f).value;
    s.heights[i] = static_cast<float>(height);
    if (height < limit) flags |= tet_violates_2;
    if (orientation && nearest != nullptr &&
        check_orientation(p, f, s.criteria.shrink, *nearest).misoriented) {
      flags |= tet_violates_3;
    }
  });
  for (const std::uint8_t flags : s.tet_flags) {
    if (flags & tet_violates_2) ++s.violating_2;
    if (flags & tet_violates_3) ++s.violating_3;
  }
}

/// What the operation before `s.step` touched.
void describe_operation(StateSnapshot& s, const Journal& journal) {
  if (s.step == 0) return;
  const Operation& operation = journal.operations()[s.step - 1];
  s.event = journal.events()[operation.event];
  const Delta& delta = *operation.delta;
  if (!delta.added_vertices.empty())
    s.inserted = VertexId(s.complex.vertices.size() - delta.added_vertices.size());
  for (const TetRecord& t : delta.added) s.added_tets.push_back(t.id);
  for (const TetRecord& t : delta.removed) {
    std::array<Vec3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = s.complex.position(t.v[k]);
    for (const Delta::Move& move : delta.moves) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (t.v[k] == move.vertex) corners[k] = move.before;
      }
    }
    s.removed_tets.push_back(corners);
    if (t.id == s.event->tet) s.violated_tet = corners;
  }
}

} // namespace

std::shared_ptr<const StateSnapshot>
make_snapshot(Playback& playback, Step step, const SnapshotOptions& options, const NearestSample* nearest) {
  auto s = std::make_shared<StateSnapshot>();
  s->step = playback.seek(step);
  s->complex = playback.complex();
  s->samples = playback.samples();
  s->criteria = options.criteria.value_or(playback.parameters());
  s->tet_flags.assign(s->complex.tets.size(), 0);
  s->heights.assign(s->complex.tets.size(), std::numeric_limits<float>::infinity());
  if (s->samples) judge_samples(*s, playback.sample_sets());
  judge_tets(*s, options.orientation, nearest);
  s->zero_set = extract_zero_set(s->complex);
  s->gamma = gamma_boundary(s->complex);
  for (const TetId t : playback.changed_in_last(options.recent)) s->tet_flags[t.index()] |= tet_changed;
  describe_operation(*s, playback.journal());
  return s;
}

ViolationPreview preview_violations(const StateSnapshot& state, const CriteriaParameters& criteria,
                                    const NearestSample* nearest) {
  ViolationPreview preview;
  const auto limit = static_cast<float>(criteria.error_limit());
  for (const float error : state.errors) {
    if (is_bad(error)) ++preview.bad_samples;
    if (error > limit) ++preview.beyond_margin;
  }
  const auto height = static_cast<float>(criteria.height_limit());
  std::atomic<std::size_t> misoriented{0};
  for (std::size_t i = 0; i < state.heights.size(); ++i) {
    if ((state.tet_flags[i] & tet_heterogeneous) && state.heights[i] < height) ++preview.too_flat;
  }
  if (nearest != nullptr) {
    parallel_for(state.tet_flags.size(), tets_per_task, [&](std::size_t i) {
      if (!(state.tet_flags[i] & tet_heterogeneous)) return;
      const TetId t(i);
      if (check_orientation(state.complex.positions(t), state.complex.values(t), criteria.shrink, *nearest)
              .misoriented) {
        misoriented.fetch_add(1, std::memory_order_relaxed);
      }
    });
  }
  preview.misoriented = misoriented.load();
  return preview;
}

} // namespace isoscope
