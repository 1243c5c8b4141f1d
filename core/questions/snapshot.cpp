// Judges a whole state at once: sample errors, heights, orientations, and what the last operation touched.
#include "questions/snapshot.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "criteria/height.h"
#include "criteria/orientation.h"
#include "mesh/label_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace isoscope {

namespace {

constexpr std::size_t tets_per_task = 512;

/// Slots of tetrahedra that may differ between two steps; nullopt when a scan would not pay or not suffice.
std::optional<std::vector<std::uint32_t>> touched_slots(const Journal& journal, Step a, Step b,
                                                        std::size_t slots) {
  const auto [first, last] = std::minmax(a, b);
  std::vector<std::uint32_t> touched;
  for (Step k = first; k < last; ++k) {
    const Delta delta = journal.operations()[k].delta();
    // Changed values reach tetrahedra that the delta does not name.
    if (!delta.values.empty() || delta.sample_set || delta.form) return std::nullopt;
    for (const Delta::SideChange& side : delta.sides) touched.push_back(side.tet.value);
    for (const Delta::DroppedChange& change : delta.dropped) touched.push_back(change.tet.value);
    for (const TetRecord& t : delta.removed) touched.push_back(t.id.value);
    for (const TetRecord& t : delta.added) touched.push_back(t.id.value);
    if (touched.size() > slots) return std::nullopt;
  }
  sort_unique(touched);
  while (!touched.empty() && touched.back() >= slots) touched.pop_back();
  return touched;
}

std::vector<std::uint32_t> all_slots(std::size_t slots) {
  std::vector<std::uint32_t> all(slots);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// Which slots `previous` does not tell, after everything else was taken over from it.
std::vector<std::uint32_t> take_over(StateSnapshot& s, const StateSnapshot* previous,
                                     const Journal& journal) {
  const std::size_t slots = s.complex.tets.size();
  const std::size_t samples = s.samples ? s.samples->size() : 0;
  std::optional<std::vector<std::uint32_t>> touched;
  if (previous != nullptr && previous->samples == s.samples && previous->criteria == s.criteria &&
      previous->orientation_judged == s.orientation_judged && previous->step <= journal.steps()) {
    touched = touched_slots(journal, previous->step, s.step, slots);
  }
  constexpr float infinite = std::numeric_limits<float>::infinity();
  if (!touched) {
    s.errors.assign(samples, 0);
    s.sample_tets.assign(samples, TetId{});
    s.tet_flags.assign(slots, 0);
    s.heights.assign(slots, infinite);
    return all_slots(slots);
  }
  s.errors = previous->errors;
  s.sample_tets = previous->sample_tets;
  s.tet_flags = previous->tet_flags;
  s.heights = previous->heights;
  s.tet_flags.resize(slots, 0);
  s.heights.resize(slots, infinite);
  for (std::uint8_t& flags : s.tet_flags) flags &= static_cast<std::uint8_t>(~tet_changed);
  for (const std::uint32_t slot : *touched) {
    s.tet_flags[slot] = 0;
    s.heights[slot] = infinite;
  }
  return std::move(*touched);
}

/// ε of the samples of these slots, and the flag of condition 1.
void judge_samples(StateSnapshot& s, const SampleSets& sets, const std::vector<std::uint32_t>& slots) {
  const BoundarySamples& samples = *s.samples;
  const double limit = s.criteria.error_limit();
  parallel_for(slots.size(), tets_per_task, [&](std::size_t i) {
    const TetId t(slots[i]);
    if (!s.complex.tet(t).alive()) return;
    LabelFunctions functions(s.complex, t);
    const int side = s.complex.tet(t).side;
    sets.for_each(t, [&](SampleId id) {
      const int label = samples.labels[id.index()];
      const double f = functions.of(label)(samples.positions[id.index()]);
      const double error = sample_error_in(s.complex.tet(t), f, label);
      s.errors[id.index()] = static_cast<float>(error);
      s.sample_tets[id.index()] = t;
      if (side == 0 ? error > limit : is_bad(error)) s.tet_flags[t.index()] |= tet_violates_1;
    });
  });
}

void judge_tets(StateSnapshot& s, const NearestSample* nearest, const std::vector<std::uint32_t>& slots) {
  const double limit = s.criteria.height_limit(), reach = orientation_reach * s.criteria.delta;
  parallel_for(slots.size(), tets_per_task, [&](std::size_t i) {
    const TetId t(slots[i]);
    if (!s.complex.tet(t).alive()) return;
    std::uint8_t& flags = s.tet_flags[t.index()];
    flags |= tet_alive;
    for (const VertexId v : s.complex.tet(t).v) {
      if (s.complex.vertices[v.index()].kind == VertexKind::box) flags |= tet_box;
    }
    if (s.complex.tet(t).side < 0) flags |= tet_negative;
    if (!s.complex.in_gamma(t)) return;
    flags |= tet_heterogeneous;
    if (s.complex.form != ZeroForm::interpolated) return; // heights are those of the function before
    const auto p = s.complex.positions(t);
    const auto f = s.complex.values(t);
    const TetLabels labels = s.complex.labels(t);
    const double height = tetrahedron_height(p, f, labels).value;
    s.heights[t.index()] = static_cast<float>(height);
    if (height < limit) flags |= tet_violates_2;
    if (s.orientation_judged &&
        check_orientation(p, f, labels, s.criteria.shrink, reach, *nearest).misoriented) {
      flags |= tet_violates_3;
    }
  });
}

void count_violations(StateSnapshot& s) {
  const auto limit = static_cast<float>(s.criteria.error_limit());
  s.largest_error = s.errors.empty() ? 0.0f : -std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < s.errors.size(); ++i) {
    const float error = s.errors[i];
    if (is_bad(error)) ++s.bad_samples;
    if (s.complex.form == ZeroForm::interpolated && error > limit) ++s.beyond_margin;
    if (error > s.largest_error) {
      s.largest_error = error;
      s.worst_sample = SampleId(i);
    }
  }
  for (const std::uint8_t flags : s.tet_flags) {
    if (flags & tet_violates_2) ++s.violating_2;
    if (flags & tet_violates_3) ++s.violating_3;
  }
}

/// Facets of Z among the tetrahedra of a list: between two of them of different sides and not dropped, by
/// sorted corners.
using FacetKey = std::array<VertexId, 3>;

std::vector<FacetKey> embedded_facets(const std::vector<TetRecord>& tets) {
  std::vector<std::pair<FacetKey, int>> sides;
  for (const TetRecord& t : tets) {
    if (t.side == 0) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((t.dropped >> i & 1) != 0) continue;
      const auto& local = outward_facets[i];
      FacetKey key{t.v[local[0]], t.v[local[1]], t.v[local[2]]};
      std::sort(key.begin(), key.end());
      sides.emplace_back(key, t.side);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<FacetKey> facets;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].first == sides[i + 1].first && sides[i].second != sides[i + 1].second)
      facets.push_back(sides[i].first);
  }
  return facets;
}

/// The facets of Z that a delta took away and put there, those in both left out.
void describe_facets(StateSnapshot& s, const Delta& delta) {
  const auto position_before = [&](VertexId v) {
    for (const Delta::Move& m : delta.moves) {
      if (m.vertex == v) return m.before;
    }
    return s.complex.position(v);
  };
  std::vector<FacetKey> before = embedded_facets(delta.removed), after = embedded_facets(delta.added);
  for (const FacetRecord& f : delta.removed_facets) before.push_back(f.v);
  for (const FacetRecord& f : delta.added_facets) after.push_back(f.v);
  // At its departure Z has the same facets, only told apart from T.
  if (delta.form && delta.form->before == ZeroForm::embedded) return;
  for (const FacetKey& f : before) {
    s.removed_facets.push_back({position_before(f[0]), position_before(f[1]), position_before(f[2])});
  }
  for (const FacetKey& f : after) {
    s.added_facets.push_back({s.complex.position(f[0]), s.complex.position(f[1]), s.complex.position(f[2])});
  }
}

/// What the operation before `s.step` touched.
void describe_operation(StateSnapshot& s, const Journal& journal) {
  if (s.step == 0) return;
  const Operation& operation = journal.operations()[s.step - 1];
  s.event = journal.events()[operation.event];
  const Delta delta = operation.delta();
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
  for (const Delta::Move& m : delta.moves) s.moves.push_back({m.vertex, m.before, m.after});
  describe_facets(s, delta);
}

} // namespace

std::shared_ptr<const StateSnapshot> make_snapshot(Playback& playback, Step step,
                                                   const SnapshotOptions& options,
                                                   const NearestSample* nearest,
                                                   const StateSnapshot* previous) {
  auto s = std::make_shared<StateSnapshot>();
  s->step = playback.seek(step);
  s->complex = playback.complex();
  s->samples = playback.samples();
  s->criteria = options.criteria.value_or(playback.parameters());
  s->orientation_judged = options.orientation && nearest != nullptr;
  const std::vector<std::uint32_t> slots = take_over(*s, previous, playback.journal());
  if (s->complex.form == ZeroForm::free) {
    s->errors.clear();
    s->sample_tets.clear();
  } else if (s->samples) {
    judge_samples(*s, playback.sample_sets(), slots);
  }
  judge_tets(*s, nearest, slots);
  count_violations(*s);
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
  for (std::size_t i = 0; i < state.errors.size(); ++i) {
    const float error = state.errors[i];
    if (is_bad(error)) ++preview.bad_samples;
    // The margin is asked of the function before Z is embedded.
    if (state.complex.form == ZeroForm::interpolated && error > limit) preview.samples.push_back(SampleId(i));
  }
  preview.beyond_margin = preview.samples.size();
  const auto height = static_cast<float>(criteria.height_limit());
  const double reach = orientation_reach * criteria.delta;
  for (std::size_t i = 0; i < state.heights.size(); ++i) {
    if ((state.tet_flags[i] & tet_heterogeneous) && state.heights[i] < height)
      preview.flat_tets.push_back(TetId(i));
  }
  preview.too_flat = preview.flat_tets.size();
  if (nearest != nullptr) {
    std::vector<std::uint8_t> misoriented(state.tet_flags.size(), 0);
    parallel_for(state.tet_flags.size(), tets_per_task, [&](std::size_t i) {
      if (!(state.tet_flags[i] & tet_heterogeneous)) return;
      const TetId t(i);
      if (check_orientation(state.complex.positions(t), state.complex.values(t), state.complex.labels(t),
                            criteria.shrink, reach, *nearest)
              .misoriented) {
        misoriented[i] = 1;
      }
    });
    for (std::size_t i = 0; i < misoriented.size(); ++i)
      if (misoriented[i] != 0) preview.misoriented_tets.push_back(TetId(i));
  }
  preview.misoriented = preview.misoriented_tets.size();
  return preview;
}

} // namespace isoscope
