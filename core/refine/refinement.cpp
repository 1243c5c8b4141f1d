// The loop "in order": the first violated condition acts, then all are looked at again (§2.3).
#include "refine/refinement.h"

#include "refine/containment.h"
#include "refine/sample_conditions.h"
#include "refine/topology_repair.h"
#include "refine/witnesses.h"

#include <utility>

namespace isoscope {

struct Refinement::Impl {
  Impl(ToleranceVolume& volume, SearchedSamples samples, const CriteriaParameters& criteria,
       const ExpectedTopology& expected, const RefinementLimits& limits, Recorder& recorder,
       const RunControl& control, TrialCut trial)
      : context(volume, std::move(samples), criteria, recorder, control), classification(context),
        height(context), containment(context), witnesses(context), orientation(context),
        topology(context, expected, limits.topology_insertions, std::move(trial)), limit(limits.insertions) {}

  RefinementContext context;
  ClassificationCondition classification;
  HeightCondition height;
  ContainmentCondition containment;
  WitnessCondition witnesses;
  OrientationCondition orientation;
  TopologyCondition topology;
  std::size_t limit;
  bool started = false;

  Turn turn();
  void begin();
  /// Does what the journal that is followed has, to its last event.
  void rehearse();
  void follow(const Event& e, const Rehearsal& ahead);
  /// Goes on under the gate's parameters, when it has any (δ > 0) and they differ.
  void adopt_parameters();
  std::size_t insertion_limit() const;
  bool both_sides() const;
  RefinementOutcome outcome(RefinementOutcome::End end);
  /// Says in words what a finished run could not meet.
  void report_unmet(const RefinementOutcome& result);
};

namespace {

/// Insertions beyond the samples that containment and topology may ask for.
constexpr std::size_t spare_insertions = 200000;

std::string count_in_words(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

Event stage_event(EventKind kind) {
  Event event;
  event.kind = kind;
  return event;
}

} // namespace

Turn Refinement::Impl::turn() {
  const CriteriaParameters& criteria = context.criteria();
  if (criteria.condition_1 && classification.turn() == Turn::acted) return Turn::acted;
  if (criteria.certified) {
    if (criteria.condition_2 && containment.turn() == Turn::acted) return Turn::acted;
    if (witnesses.turn() == Turn::acted) return Turn::acted;
  } else if (criteria.condition_2 && both_sides() && height.turn() == Turn::acted) {
    return Turn::acted;
  }
  const bool mending = criteria.condition_4 && topology.mending();
  if (criteria.condition_3 && !mending && both_sides() && orientation.turn() == Turn::acted)
    return Turn::acted;
  if (criteria.condition_4 && topology.turn() == Turn::acted) return Turn::acted;
  return Turn::satisfied;
}

bool Refinement::Impl::both_sides() const {
  return context.nearest().has(+1) && context.nearest().has(-1);
}

std::size_t Refinement::Impl::insertion_limit() const {
  return limit > 0 ? limit : context.live().samples().size() + spare_insertions;
}

void Refinement::Impl::begin() {
  context.note(stage_event(EventKind::stage_begin));
  if (started) return;
  started = true;
  context.start();
}

void Refinement::Impl::rehearse() {
  Recorder& recorder = context.recorder();
  while (const Rehearsal* ahead = recorder.rehearsal()) {
    if (recorder.astray() || context.cancelled()) return;
    const std::size_t place = ahead->place();
    follow(ahead->event(), *ahead);
    if (recorder.rehearsal() == ahead && ahead->place() == place) recorder.go_astray();
  }
}

void Refinement::Impl::follow(const Event& e, const Rehearsal& ahead) {
  // Which regions of the complement are known depends on the places that were asked for.
  if (e.condition == Condition::containment) context.volume().label_at(e.witness, context.control());
  switch (e.kind) {
  case EventKind::insertion: {
    // Where it looks next depends on what it looked for before: this condition alone has its turns again.
    if (e.condition == Condition::topology) {
      topology.turn();
      return;
    }
    const Delta delta = ahead.delta();
    if (!delta.added_vertices.empty()) context.insert(delta.added_vertices.front(), e.tet, e);
    return;
  }
  case EventKind::relabel:
  case EventKind::topology_check:
    topology.turn();
    return;
  case EventKind::parameter_change:
    if (e.operation) {
      if (const Delta delta = ahead.delta(); delta.sample_set)
        context.replace_samples(ahead.followed().sample_sets()[delta.sample_set->after]);
      return;
    }
    context.set_criteria(ahead.criteria());
    topology.reconsider();
    return;
  case EventKind::exhausted:
    if (e.condition == Condition::classification) context.live().block(e.sample);
    if (e.condition == Condition::height) height.give_up(e.tet);
    if (e.condition == Condition::containment) containment.give_up(e.tet);
    if (e.condition == Condition::witness) witnesses.give_up(e.witness);
    if (e.condition == Condition::orientation) orientation.give_up(e.tet);
    break;
  default:
    break;
  }
  context.note(e);
}

void Refinement::Impl::adopt_parameters() {
  const CriteriaParameters wanted = context.recorder().gate().wanted_parameters();
  if (!(wanted.delta > 0) || wanted == context.criteria()) return;
  context.set_criteria(wanted);
  topology.reconsider();
}

RefinementOutcome Refinement::Impl::outcome(RefinementOutcome::End end) {
  RefinementOutcome result;
  result.end = end;
  result.classified = classification.holds();
  result.uncertified = containment.unproven();
  result.contained = end == RefinementOutcome::End::finished && context.criteria().certified &&
                     context.criteria().condition_2 && result.uncertified == 0;
  result.witnessed = witnesses.holds();
  result.topology = topology.verdict();
  result.unmet_height = context.criteria().certified ? 0 : height.unmet();
  result.unmet_orientation = orientation.unmet();
  result.sample_moves = context.live().sample_moves();
  return result;
}

void Refinement::Impl::report_unmet(const RefinementOutcome& result) {
  const CriteriaParameters& criteria = context.criteria();
  if (criteria.condition_1 && !result.classified) {
    context.warn("Condition 1 stays violated by samples that coincide with vertices of the other label.");
  }
  if (criteria.certified && criteria.condition_2 && !result.contained) {
    context.warn(std::to_string(result.uncertified) + " polygons of Z could not be proven inside Ω.");
  }
  if (criteria.certified && !result.witnessed) {
    context.warn("Z has the deepest point of a region on the wrong side.");
  }
  if (criteria.condition_4 && !result.topology.as_expected) {
    context.warn("Z has χ = " + std::to_string(result.topology.euler_characteristic) + " and " +
                 count_in_words(result.topology.components, "component") + ", not " + topology.expectation() +
                 ".");
  }
}

Refinement::Refinement(ToleranceVolume& volume, SearchedSamples samples, const CriteriaParameters& criteria,
                       const ExpectedTopology& expected, const RefinementLimits& limits, Recorder& recorder,
                       const RunControl& control, TrialCut trial) {
  Journal& journal = recorder.journal();
  if (journal.sample_sets().empty()) journal.add_sample_set(samples.samples);
  if (journal.parameters().empty() || journal.parameters().back().criteria != criteria) {
    journal.add_parameters(criteria);
  }
  impl_ = std::make_unique<Impl>(volume, std::move(samples), criteria, expected, limits, recorder, control,
                                 std::move(trial));
}

Refinement::~Refinement() = default;

const SearchedSamples& Refinement::samples() const {
  return impl_->context.samples();
}

const Complex& Refinement::complex() const {
  return impl_->context.live().complex();
}

const CriteriaParameters& Refinement::criteria() const {
  return impl_->context.criteria();
}

void Refinement::replace_samples(std::shared_ptr<const BoundarySamples> samples) {
  impl_->context.replace_samples(std::move(samples));
}

RefinementOutcome Refinement::run() {
  using End = RefinementOutcome::End;
  Impl& impl = *impl_;
  RefinementContext& context = impl.context;
  context.take_verdict(); // what ended the last run does not end this one
  impl.begin();
  if (context.recorder().rehearsal() != nullptr)
    impl.rehearse();
  else
    impl.adopt_parameters();
  const std::size_t limit = impl.insertion_limit();
  for (;;) {
    const Gate::Verdict verdict = context.take_verdict();
    if (verdict == Gate::Verdict::stop || context.cancelled()) {
      context.warn("Refinement ended before all conditions were met, as it was told to.", EventKind::stopped);
      return impl.outcome(End::stopped);
    }
    if (verdict == Gate::Verdict::parameters_changed) impl.adopt_parameters();
    if (context.live().complex().vertices.size() >= limit) {
      context.warn("Refinement reached its limit of " + std::to_string(limit) + " vertices.",
                   EventKind::stopped);
      return impl.outcome(End::limit);
    }
    if (impl.turn() == Turn::satisfied) break;
    if (const auto open_at = impl.containment.open_at()) {
      RefinementOutcome open = impl.outcome(End::open_input);
      open.open_at = *open_at;
      return open;
    }
  }
  const RefinementOutcome result = impl.outcome(End::finished);
  impl.report_unmet(result);
  context.note(stage_event(EventKind::stage_end));
  return result;
}

} // namespace isoscope
