// Delaunay insertions of random points, recorded as a refinement would record them.
#include "journal/synthetic.h"

#include "mesh/support.h"

namespace isoscope::test {

namespace {

const Box3 domain{{-2, -2, -2}, {2, 2, 2}};

double side(Vec3 p) {
  return length(p) > 1 ? 1.0 : -1.0;
}

} // namespace

std::shared_ptr<const BoundarySamples> sphere_samples(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  auto samples = std::make_shared<BoundarySamples>();
  while (samples->positions.size() < n) {
    const Vec3 p = random.in({{-1, -1, -1}, {1, 1, 1}});
    if (length(p) < 0.1 || length(p) > 1) continue;
    const std::int8_t label = samples->positions.size() % 2 == 0 ? 1 : -1;
    samples->positions.push_back((1 + 0.1 * label) * normalized(p));
    samples->labels.push_back(label);
    samples->components.push_back(label > 0 ? 0 : 1);
  }
  samples->sigma = 0.1;
  return samples;
}

void record_insertions(Journal& journal, std::size_t insertions, std::size_t samples, std::uint64_t seed,
                       const std::function<void()>& after_each) {
  OpenGate gate;
  Recorder recorder(journal, gate);
  Random random(seed);
  CriteriaParameters criteria;
  criteria.delta = 0.1;
  criteria.sigma = 0.05;
  journal.add_sample_set(sphere_samples(samples, seed + 1));
  journal.add_parameters(criteria);
  Event begin;
  begin.kind = EventKind::stage_begin;
  recorder.event(begin);

  Event box;
  box.kind = EventKind::insertion;
  Grown grown(domain);
  recorder.operation(box, grown.deltas.back(), {});
  if (after_each) after_each();
  for (std::size_t i = 0; i < insertions; ++i) {
    if (i == insertions / 2) {
      Event change;
      change.kind = EventKind::parameter_change;
      Delta delta;
      delta.sample_set =
          Delta::SampleSetChange{0, journal.add_sample_set(sphere_samples(samples / 2, seed + 2))};
      criteria.alpha = 0.4;
      journal.add_parameters(criteria);
      recorder.operation(change, std::move(delta), {});
      if (after_each) after_each();
    }
    const Vec3 p = random.in(domain);
    if (!grown.insert(p, side(p))) continue;
    Event e;
    e.kind = EventKind::insertion;
    e.condition = Condition::classification;
    e.reason = Reason::largest_error;
    e.point = p;
    e.tet = grown.deltas.back().removed.empty() ? TetId() : grown.deltas.back().removed.front().id;
    e.vertex = VertexId(grown.complex.vertices.size() - 1);
    StepFigures figures;
    figures.seconds = static_cast<float>(i);
    recorder.operation(e, grown.deltas.back(), figures);
    if (after_each) after_each();
    if (i % 50 == 0) {
      Event exhausted;
      exhausted.kind = EventKind::exhausted;
      exhausted.condition = Condition::height;
      exhausted.reason = Reason::no_sample_inside;
      recorder.event(exhausted);
    }
  }
  Event end;
  end.kind = EventKind::stage_end;
  end.text = journal.add_text("all points are in");
  recorder.event(end);
}

} // namespace isoscope::test
