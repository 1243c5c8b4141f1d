// The stages of a run, in order.
#include "run/pipeline.h"

#include "base/memory.h"
#include "base/stopwatch.h"
#include "journal/playback.h"
#include "mesh/zero_set.h"
#include "run/trial_cut.h"
#include "simplify/first_surface.h"
#include "tolerance/region_labels.h"

#include <limits>
#include <utility>

namespace isoscope {

namespace {

/// Lets the refinement end when σ changed, so that S can be replaced before it goes on.
class ResamplingGate : public Gate {
 public:
  ResamplingGate(Gate& outer, double sigma) : outer_(&outer), sigma_(sigma) {}
  Verdict pass(const Journal& journal, const Event& event) override {
    const Verdict verdict = outer_->pass(journal, event);
    if (verdict != Verdict::parameters_changed || outer_->wanted_parameters().sigma == sigma_) return verdict;
    resample_ = true;
    return Verdict::stop;
  }
  CriteriaParameters wanted_parameters() const override { return outer_->wanted_parameters(); }
  bool resample_pending() const { return resample_; }
  void resampled(double sigma) {
    sigma_ = sigma;
    resample_ = false;
  }
  double sigma() const { return sigma_; }

 private:
  Gate* outer_;
  double sigma_;
  bool resample_ = false;
};

} // namespace

int RunResult::exit_status() const {
  if (end != End::finished && !without_end) return 4;
  if (refused()) return 3;
  return certificate.holds() && !failure ? 0 : 1;
}

struct Pipeline::Impl {
  Impl(const RunParameters& wanted, std::shared_ptr<Journal> empty, Gate& outer, RunControl& run)
      : parameters(&wanted), journal(std::move(empty)), gate(&outer), control(&run),
        preparation(wanted, run) {}

  const RunParameters* parameters;
  std::shared_ptr<Journal> journal;
  std::shared_ptr<Journal> scratch; ///< of a branch: what is made once more
  Gate* gate;
  RunControl* control;
  Preparation preparation;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const BoundarySamples> current_samples;
  std::optional<ResamplingGate> resampling;
  std::optional<Recorder> recorder;
  std::unique_ptr<Refinement> refinement; ///< until the simplification begins
  RefinementOutcome refined;              ///< what came out of it
  std::unique_ptr<Simplification> simplification;
  double seconds = 0; ///< of all parts so far
  std::string branched;
  bool further = false; ///< the next run goes on improving

  void record_warning(const std::string& text) {
    Event e;
    e.kind = EventKind::warning;
    e.stage = Stage::setup;
    e.text = journal->add_text(text);
    journal->add_event(e);
  }
  const Complex& complex() const {
    return simplification ? simplification->complex() : refinement->complex();
  }

  Stage last_stage() const {
    Stage last = Stage::setup;
    for (std::size_t i = 0, n = journal->events().size(); i < n; ++i) {
      if (journal->events()[i].kind == EventKind::stage_begin) last = journal->events()[i].stage;
    }
    return last;
  }

  void begin_refinement(SearchedSamples samples, const CriteriaParameters& criteria) {
    ToleranceVolume& volume = preparation.volume();
    const ExpectedTopology& expected = scene->expected;
    const bool tried = criteria.certified && is_tried(volume, expected);
    TrialCut trial;
    if (tried)
      trial = [&volume, expected, this](const Complex& refined) {
        return try_cut(refined, volume, expected, *control);
      };
    refinement = std::make_unique<Refinement>(volume, std::move(samples), criteria,
                                              tried ? expected : expected_before_the_cut(volume, expected),
                                              RefinementLimits{}, *recorder, *control, std::move(trial));
  }

  /// Where the beginning of a branch is made once more, the decisions taken from its journal: scratch holds
  /// what is made meanwhile.
  Status go_on_from(const BranchPoint& branch, std::shared_ptr<Journal> prefix) {
    if (Status can = can_go_on(*branch.from, branch.step); !can) return can;
    const RehearsalStart start = rehearsal_start(*prefix);
    Playback playback(prefix);
    playback.seek(prefix->steps());
    current_samples = playback.samples();
    resampling.emplace(*gate, criteria_before(*prefix, prefix->events().size()).sigma);
    refinement.reset();
    scratch = std::exchange(journal, prefix);
    recorder.emplace(*journal, *resampling);
    recorder->rehearse(*scratch, start.event);
    branched = describe(branch);
    const CriteriaParameters criteria = criteria_before(*journal, start.event);
    if (start.stage == Stage::refinement) {
      begin_refinement(journal->sample_sets()[0], criteria);
      return {};
    }
    // Which regions of the complement are known depends on the places that the refinement asked for.
    for (std::size_t i = 0; i < start.event; ++i)
      if (const Event& e = journal->events()[i];
          e.condition == Condition::containment && e.stage == Stage::refinement)
        preparation.volume().label_at(e.witness, *control);
    playback.seek(start.step);
    simplification = std::make_unique<Simplification>(preparation.volume(), current_samples, criteria,
                                                      parameters->simplification(), *recorder, *control,
                                                      playback.complex());
    refined.end = RefinementOutcome::End::finished;
    if (!start.by_hand) {
      simplification->begin_at(start.stage);
      return {};
    }
    const Event e = journal->events()[start.event];
    const StageAt at = stage_at(*journal, start.step);
    return simplification->begin_with(at.stage, at.open, at.seconds, e.vertex, e.other, e.point);
  }

  /// Why a branch has not come to the step that it was to go on from.
  Error follow_failed() const {
    if (control->cancelled())
      return {ErrorCode::cancelled, "The run was stopped before it came to the step of its branch.", ""};
    return {ErrorCode::unsupported,
            "What the run did before this step comes out differently now: it cannot go on from there.",
            "Restart with these parameters."};
  }

  Status refine() {
    if (Status refined_now = refine_on(); !refined_now) return refined_now;
    return recorder->rehearsal() != nullptr ? Status(follow_failed()) : Status();
  }

  /// Runs the simplification; one that is repeated goes on where the run that it follows did.
  Result<bool> simplify() {
    for (;;) {
      auto finished = simplification->run();
      if (!finished) return finished;
      if (recorder->rehearsal() == nullptr) {
        scratch.reset();
        return finished;
      }
      if (*finished || recorder->astray() || control->cancelled()) return follow_failed();
    }
  }

  /// Refines, again with other samples as long as σ changes.
  Status refine_on() {
    for (;;) {
      const double wanted_sigma = gate->wanted_parameters().sigma;
      const bool followed = recorder->rehearsal() != nullptr; // σ changes where the journal says so
      if (!followed && wanted_sigma > 0 && wanted_sigma != resampling->sigma()) {
        auto samples = preparation.sample(wanted_sigma);
        if (!samples) return samples.error();
        resampling->resampled(wanted_sigma);
        refinement->replace_samples(*samples);
        current_samples = *samples;
      }
      refined = refinement->run();
      if (refined.end == RefinementOutcome::End::open_input)
        return preparation.refused(joined_sides_near(preparation.volume(), refined.open_at), *scene);
      if (!resampling->resample_pending()) return {};
    }
  }

  /// There is no T: the simplification makes its first Z itself.
  Status begin_outside_of_t(const CriteriaParameters& criteria) {
    const ToleranceVolume& volume = preparation.volume();
    const bool lattice = parameters->start == FirstZ::lattice;
    if (Status can = lattice ? can_start_from_lattice(volume) : can_start_from_input(volume); !can)
      return can;
    FirstSurfaceMaker first = [&volume](const RunControl&) -> Result<FirstSurface> {
      return first_from_input(volume);
    };
    if (lattice)
      first = [&volume, expected = scene->expected, bytes = parameters->most_bytes()](const RunControl& c) {
        return first_from_lattice(volume, expected, bytes, c);
      };
    simplification = std::make_unique<Simplification>(volume, preparation.take_samples(), criteria,
                                                      parameters->simplification(), *recorder, *control,
                                                      Complex(), std::move(first));
    return {};
  }

  /// T goes from the refinement, which is not needed any more, to the simplification.
  void begin_simplification(const SimplificationParameters& wanted) {
    simplification =
        std::make_unique<Simplification>(preparation.volume(), refinement->samples(), refinement->criteria(),
                                         wanted, *recorder, *control, refinement->complex());
    refinement.reset();
  }
};

Pipeline::Pipeline(RunParameters parameters, std::shared_ptr<Journal> journal, Gate& gate,
                   RunControl& control)
    : parameters_(std::move(parameters)),
      impl_(std::make_unique<Impl>(parameters_, std::move(journal), gate, control)) {}

Pipeline::~Pipeline() = default;

void Pipeline::on_read(Preparation::Read read) {
  impl_->preparation.on_read(std::move(read));
}

Result<std::shared_ptr<const Scene>> Pipeline::prepare(std::shared_ptr<const TriangleSoup> soup,
                                                       std::vector<InputNote> notes, ThinParts thin) {
  Impl& m = *impl_;
  const Stopwatch watch;
  auto prepared = m.preparation.make(std::move(soup), std::move(notes), thin);
  if (!prepared) return prepared;
  m.scene = *prepared;
  m.current_samples = m.scene->samples;
  const CriteriaParameters criteria = parameters_.criteria(m.scene->delta, m.scene->default_sigma);
  m.journal->add_sample_set(m.scene->samples);
  m.journal->add_parameters(criteria);
  for (const ParameterWarning& warning : m.scene->warnings) m.record_warning(warning.message);
  if (!m.scene->thickening_note.empty()) m.record_warning(m.scene->thickening_note);
  m.resampling.emplace(*m.gate, criteria.sigma);
  m.recorder.emplace(*m.journal, *m.resampling);
  if (parameters_.start == FirstZ::delaunay)
    m.begin_refinement(m.preparation.take_samples(), criteria);
  else if (Status begun = m.begin_outside_of_t(criteria); !begun)
    return begun.error();
  m.seconds = watch.seconds();
  return prepared;
}

std::shared_ptr<const Scene> Pipeline::examined() const {
  return impl_->preparation.examined();
}

Status Pipeline::branch(const BranchPoint& branch, std::shared_ptr<Journal> journal) {
  Impl& m = *impl_;
  if (!branch.by_hand()) return m.go_on_from(branch, std::move(journal));
  if (Status can = can_branch(*branch.from, branch.step); !can) return can;
  Playback playback(branch.from);
  playback.seek(branch.step);
  const StageAt at = stage_at(*branch.from, branch.step);
  m.refinement.reset();
  m.journal = std::move(journal);
  m.recorder.emplace(*m.journal, *m.resampling);
  m.current_samples = playback.samples();
  m.simplification = std::make_unique<Simplification>(m.preparation.volume(), m.current_samples,
                                                      playback.parameters(), parameters_.simplification(),
                                                      *m.recorder, *m.control, playback.complex());
  m.refined.end = RefinementOutcome::End::finished;
  m.branched = describe(branch);
  Event e;
  e.kind = EventKind::warning;
  e.stage = at.stage;
  e.text = m.journal->add_text(m.branched);
  m.journal->add_event(e);
  return m.simplification->begin_with(at.stage, at.open, at.seconds, branch.a, branch.b, branch.target);
}

Status Pipeline::go_on() {
  if (!impl_->simplification || !impl_->simplification->can_go_on())
    return Error{ErrorCode::usage, "There is no Z that the improver has begun with and that no holes fill.",
                 "Let the run come to the improver, with --fill none."};
  impl_->further = true;
  return {};
}

Result<RunResult> Pipeline::run() {
  using End = RefinementOutcome::End;
  Impl& m = *impl_;
  const Stopwatch watch;
  RunResult result;
  bool stopped = false;
  if (!m.simplification) {
    if (Status refined = m.refine(); !refined) return refined.error();
    m.scratch.reset();
    stopped = m.refined.end == End::stopped;
    if (m.refined.end == End::finished && !m.control->cancelled() &&
        parameters_.last_stage() > Stage::refinement) {
      m.begin_simplification(parameters_.simplification());
    }
  }
  if (m.simplification) {
    m.simplification->go_on(std::exchange(m.further, false));
    const Result<bool> finished = m.simplify();
    if (!finished && m.recorder->rehearsal() != nullptr) return finished.error();
    if (!finished) result.failure = finished.error();
    stopped = finished && !*finished;
  }
  if (m.control->cancelled() || stopped) {
    result.end = m.control->timed_out() ? RunResult::End::limit : RunResult::End::stopped;
  }
  if (m.simplification) {
    result.without_end = m.simplification->without_end();
    if (result.without_end && !m.control->abandoned()) {
      // What it has come to is the result: nothing of its proof is left out.
      m.control->reset();
      m.simplification->finish();
    }
    result.can_go_on = m.simplification->can_go_on();
  }
  result.refinement = m.refined;
  result.branch = m.branched;
  result.last_stage = m.last_stage();
  if (result.refused()) result.failure = m.preparation.refused_after_refinement(*result.failure, *m.scene);
  result.form = m.complex().form;
  const ZeroSet zero_set = extract_zero_set(m.complex());
  result.mesh = triangulate(zero_set);
  result.holes = filled_holes(*m.journal, m.journal->steps(), m.complex(), zero_set);
  result.certificate = certify(
      result.mesh, m.preparation.volume(), with_filled_holes(m.scene->expected, result.holes, result.mesh),
      *m.control, {parameters_.cover, parameters_.topology == TopologyMode::separate, true}, result.holes);
  result.crumbs = count_small_parts(result.mesh, crumb_size * m.scene->delta);
  if (m.preparation.volume().has_surface())
    result.normals = measure_normal_deviation(result.mesh, m.preparation.volume(), *m.control);
  if (m.scene->points) {
    const double limit = parameters_.cover.value_or(std::numeric_limits<double>::infinity()) * m.scene->delta;
    result.points = measure_points(*m.scene->points, result.mesh, limit, *m.control);
  }
  result.curve = vertex_curve(*m.journal);
  m.seconds += watch.seconds();
  result.seconds = m.seconds;
  result.peak_memory_bytes = peak_memory_bytes();
  return result;
}

} // namespace isoscope
