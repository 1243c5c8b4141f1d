// The stages of a run, in order.
#include "run/pipeline.h"

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "input/input_mesh.h"
#include "journal/playback.h"
#include "mesh/zero_set.h"
#include "run/closing_tolerance.h"
#include "run/coordinate_check.h"
#include "run/make_field.h"
#include "run/point_field.h"
#include "run/run_input.h"
#include "tolerance/facet_copies.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>

namespace isoscope {

namespace {

constexpr double certified_boundary_ratio = 0.95;
/// How fine triangles that do not close are studied, relative to the longest edge.
constexpr double study_resolution = 0.003;

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

Error cancelled_error(const RunControl& control) {
  return {ErrorCode::cancelled,
          control.timed_out() ? "The time limit was reached before the refinement began."
                              : "The run was stopped before the refinement began.",
          ""};
}

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

std::optional<double> expected_genus(const Scene& scene) {
  const ExpectedTopology& e = scene.expected;
  if (!e.euler_characteristic || !e.components) return std::nullopt;
  const auto loops = static_cast<double>(e.boundary_loops.value_or(0));
  return static_cast<double>(*e.components) - (static_cast<double>(*e.euler_characteristic) + loops) / 2;
}

std::string tolerance_text(const RunParameters& parameters, const Scene& scene) {
  return scene.input->gives_volume() ? shortest(scene.delta) : parameters.tolerance.text();
}

int RunResult::exit_status() const {
  if (end != End::finished) return 4;
  return certificate.holds() && !failure ? 0 : 1;
}

Status check_memory(const SampleEstimate& estimate, double sigma, double delta, double most_bytes) {
  if (estimate.bytes(sigma) <= most_bytes) return {};
  constexpr double gigabyte = 1e9, sparsest = 0.95, margin = 1.01;
  char message[240], remedy[200];
  std::snprintf(
      message, sizeof message,
      "A density of %.3g δ takes about %.2g samples and %.2g GB of memory, more than the %.2g GB that may "
      "be used.",
      sigma / delta, estimate.samples(sigma), estimate.bytes(sigma) / gigabyte, most_bytes / gigabyte);
  const double least = margin * estimate.smallest_sigma(most_bytes) / delta;
  if (least <= sparsest) {
    const double step = std::pow(10.0, std::floor(std::log10(least)) - 1);
    std::snprintf(remedy, sizeof remedy, "Take --sigma %.3g or more, or give more with --memory-limit.",
                  step * std::ceil(least / step));
  } else {
    // Cells and samples go with 1/δ².
    std::snprintf(remedy, sizeof remedy,
                  "Choose a tolerance about %.2g times as large, or give more with --memory-limit.",
                  margin * std::sqrt(estimate.bytes(sparsest * delta) / most_bytes));
  }
  return Error{ErrorCode::unsupported, message, remedy};
}

struct Pipeline::Impl {
  std::shared_ptr<Journal> journal;
  std::shared_ptr<Journal> scratch; ///< of a branch: what is made once more
  Gate* gate;
  RunControl* control;
  std::shared_ptr<const Scene> scene, examined;
  std::shared_ptr<const BoundarySamples> current_samples;
  std::optional<ToleranceVolume> volume;
  double most_bytes = 0; ///< that the octree and the samples may take
  std::optional<ResamplingGate> resampling;
  std::optional<Recorder> recorder;
  std::unique_ptr<Refinement> refinement; ///< until the simplification begins
  RefinementOutcome refined;              ///< what came out of it
  std::unique_ptr<Simplification> simplification;
  double seconds = 0;   ///< of all parts so far
  double kept_area = 0; ///< of the input without what is left out
  std::string branched;
  MadePointField points; ///< where the field is one of points
  const RunParameters* parameters = nullptr;

  ToleranceVolume::Options volume_options(double delta) const {
    return {delta, parameters->containment == Containment::certified ? certified_boundary_ratio : 1.0,
            most_bytes};
  }
  /// What is wrong with the input; when it is open, with the tolerance that would close it.
  Error refused(Error error, const Scene& at, const ToleranceVolume::Options& options) const {
    if (at.input && at.input->gives_volume()) {
      // There is no tolerance to choose.
      if (error.remedy.starts_with("Choose a "))
        error.remedy = at.input->grid
                           ? "Take levels farther apart, or smooth the grid: its steepest slope decides."
                           : "Move the surfaces apart where they are nearest: that decides.";
      return error;
    }
    if (error.code != ErrorCode::open_surface || at.field->surface() == nullptr) return error;
    control->report("tolerance that closes the input", -1);
    return with_closing_tolerance(std::move(error), {at.field, at.input_topology, kept_area, options},
                                  *parameters, *control);
  }

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
      refinement = std::make_unique<Refinement>(*volume, journal->sample_sets()[0], criteria,
                                                expected_before_the_cut(*volume, scene->expected),
                                                RefinementLimits{}, *recorder, *control);
      return {};
    }
    // Which regions of the complement are known depends on the places that the refinement asked for.
    for (std::size_t i = 0; i < start.event; ++i)
      if (const Event& e = journal->events()[i];
          e.condition == Condition::containment && e.stage == Stage::refinement)
        volume->label_at(e.witness, *control);
    playback.seek(start.step);
    simplification =
        std::make_unique<Simplification>(*volume, current_samples, criteria, parameters->simplification(),
                                         *recorder, *control, playback.complex());
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
        auto samples = sample(wanted_sigma);
        if (!samples) return samples.error();
        resampling->resampled(wanted_sigma);
        refinement->replace_samples(*samples);
        current_samples = *samples;
      }
      refined = refinement->run();
      if (refined.end == RefinementOutcome::End::open_input)
        return refused(open_surface_near(refined.open_at), *scene, volume_options(scene->delta));
      if (!resampling->resample_pending()) return {};
    }
  }

  /// T goes from the refinement, which is not needed any more, to the simplification.
  void begin_simplification(const SimplificationParameters& wanted) {
    simplification = std::make_unique<Simplification>(*volume, current_samples, refinement->criteria(),
                                                      wanted, *recorder, *control, refinement->complex());
    refinement.reset();
  }

  /// The field of what is kept of the input, and what is known of its surface.
  Status make_field(Scene& made, const std::shared_ptr<const TriangleSoup>& kept,
                    std::optional<double> delta) {
    auto input = isoscope::make_field(kept, *parameters, delta, *control);
    if (control->cancelled()) return cancelled_error(*control);
    if (!input) return input.error();
    made.field = std::move(input->field);
    made.input_topology = std::move(input->topology);
    points = std::move(input->points);
    if (points.points) made.study = {points.points, &points.points->study};
    for (std::string& note : input->notes) made.warnings.push_back({std::move(note), 0});
    if (!kept->gives_volume()) return {};
    made.delta = input->delta;
    made.input = input->shown ? std::move(input->shown) : kept;
    return {};
  }

  void use_points(Scene& made, MadePointField kept) const {
    made.field = kept.index;
    made.points = kept.points;
  }

  /// δ as given, or found from the field, which is made for that.
  Result<double> find_delta(Scene& made, const std::shared_ptr<const TriangleSoup>& soup) {
    if (!parameters->tolerance.automatic) return parameters->tolerance.absolute(made.longest_edge);
    if (Status read = make_field(made, soup, {}); !read) return read.error();
    if (made.input_topology.closed_manifold) return Tolerance().absolute(made.longest_edge);
    if (!made.study)
      made.study = std::make_shared<const DeltaStudy>(
          study_delta(*made.field, study_resolution * made.longest_edge, *control));
    if (control->cancelled()) return cancelled_error(*control);
    return proposed_tolerance(*made.study);
  }

  /// Leaves points out that do not belong to the surface at this δ.
  Status settle_points(Scene& made) {
    if (!points.points) return {};
    points = without_outliers(points, made.delta, *control);
    if (control->cancelled()) return cancelled_error(*control);
    use_points(made, points);
    return {};
  }

  /// Ω of what is kept of the input; without its thin parts, one after the other, where they are to be
  /// dropped.
  Status build_volume(Scene& made, std::shared_ptr<const TriangleSoup> kept,
                      const ToleranceVolume::Options& options, ThinParts thin) {
    const bool drop = parameters->drop_thin;
    for (;;) {
      kept_area = made.field->area();
      auto built = ToleranceVolume::build(made.field, made.input_topology, options, *control);
      if (!built) return built.error();
      if (points.points) {
        auto rest = without_blobs(points, *built, *control);
        if (!rest) return rest.error();
        if (rest->index == points.index) {
          volume.emplace(std::move(*built));
          return {};
        }
        points = std::move(*rest);
        use_points(made, points);
        if (control->cancelled()) return cancelled_error(*control);
        continue;
      }
      const std::vector<ThinPart> parts = find_thin_parts(*built);
      const bool all = parts.size() == built->volume_component_count();
      if (!parts.empty() && thin == ThinParts::refuse && (!drop || all)) {
        const auto keeping = find_keeping_tolerance(*built, parts, *control);
        return keeping ? thin_parts_error(*built, parts, *keeping) : keeping.error();
      }
      if (parts.empty() || !drop || all) {
        volume.emplace(std::move(*built));
        return {};
      }
      kept = std::make_shared<const TriangleSoup>(without_parts(*kept, *built, parts));
      if (Status read = make_field(made, kept, made.delta); !read) return read;
      made.left_out.insert(made.left_out.end(), parts.begin(), parts.end());
    }
  }

  /// Keeps what was studied, for the choice of another δ: the proposed one, where there is one.
  void examine(const Scene& made) {
    if (!made.study) return;
    auto kept = std::make_shared<Scene>(made);
    if (made.study->found()) kept->delta = made.study->proposed;
    examined = std::move(kept);
  }

  Result<std::shared_ptr<const BoundarySamples>> sample(double sigma) {
    const Status fits =
        check_memory(estimate_samples(*volume), sigma, volume->thresholds().delta, most_bytes);
    if (!fits) return fits.error();
    auto samples = sample_boundary(*volume, sigma, *control);
    if (!samples) return samples.error();
    return std::make_shared<const BoundarySamples>(std::move(*samples));
  }
};

Pipeline::Pipeline(RunParameters parameters, std::shared_ptr<Journal> journal, Gate& gate,
                   RunControl& control)
    : parameters_(std::move(parameters)), impl_(std::make_unique<Impl>()) {
  impl_->journal = std::move(journal);
  impl_->gate = &gate;
  impl_->control = &control;
  impl_->parameters = &parameters_;
}

Pipeline::~Pipeline() = default;

Result<std::shared_ptr<const Scene>> Pipeline::prepare(std::shared_ptr<const TriangleSoup> soup,
                                                       std::vector<InputNote> notes, ThinParts thin) {
  Impl& m = *impl_;
  if (Status valid = check(parameters_); !valid) return valid.error();
  m.control->cancel_after(parameters_.time_limit);
  m.most_bytes = parameters_.most_bytes();
  const Stopwatch watch;
  auto scene = std::make_shared<Scene>();

  m.control->report("input", -1);
  if (!soup) {
    auto loaded = read_run_input(parameters_, *m.control);
    if (!loaded) return m.control->cancelled() ? cancelled_error(*m.control) : loaded.error();
    soup = std::make_shared<const TriangleSoup>(std::move(loaded->soup));
    notes = std::move(loaded->notes);
  }
  if (Status fits = check_volume(*soup, parameters_); !fits) return fits.error();
  if (soup->gives_volume()) {
    if (Status read = m.make_field(*scene, soup, {}); !read) return read.error();
    soup = scene->input;
  }
  if (soup->points.empty())
    return Error{ErrorCode::bad_input, "The input has neither triangles nor points.", "Give a surface."};
  scene->input = soup;
  scene->longest_edge = soup->bounds().longest_edge();
  if (!is_field_of_points(*soup, parameters_)) soup = without_needless_copies(soup, *m.control);
  if (!soup->gives_volume()) {
    const auto delta = m.find_delta(*scene, soup);
    if (!delta) return delta.error();
    scene->delta = *delta;
  }
  if (!(scene->delta > 1e-9 * scene->longest_edge) || !(scene->delta < 100 * scene->longest_edge)) {
    return Error{ErrorCode::usage,
                 "--tolerance " + parameters_.tolerance.text() + " does not fit the size of the input.",
                 "Its longest edge is " + general(scene->longest_edge, 6) + "."};
  }
  if (Status fine = check_coordinates(*soup, scene->delta); !fine) return fine.error();
  scene->notes = std::move(notes);
  for (const InputNote& note : scene->notes) scene->warnings.push_back({told(note, scene->delta), 0});
  auto rest = without_crumbs(soup, soup->is_point_set() || soup->gives_volume() ? 0 : parameters_.drop_small,
                             scene->delta, *m.control);
  if (m.control->cancelled()) return cancelled_error(*m.control);
  if (!rest) return rest.error();
  if (!rest->note.empty()) scene->warnings.push_back({rest->note, 0});
  if (rest->soup != soup) scene->field.reset();
  soup = rest->soup;
  if (auto note = coordinate_note(*soup, scene->delta)) scene->warnings.push_back({std::move(*note), 0});
  if (!scene->field)
    if (Status read = m.make_field(*scene, soup, scene->delta); !read) return read.error();
  if (Status settled = m.settle_points(*scene); !settled) return settled.error();
  scene->input_seconds = watch.seconds();

  const ToleranceVolume::Options options = m.volume_options(scene->delta);
  if (Status built = m.build_volume(*scene, soup, options, thin); !built) {
    if (m.control->cancelled()) return cancelled_error(*m.control);
    m.examine(*scene);
    return m.refused(built.error(), *scene, options);
  }
  scene->volume_seconds = watch.seconds() - scene->input_seconds;

  scene->default_sigma = default_sigma_ratio(m.kept_area, scene->delta);
  const CriteriaParameters criteria = parameters_.criteria(scene->delta, scene->default_sigma);
  auto samples = m.sample(criteria.sigma);
  if (m.control->cancelled()) return cancelled_error(*m.control);
  if (!samples) return m.refused(samples.error(), *scene, options);
  if (Status closed = m.volume->check_passages(); !closed) return m.refused(closed.error(), *scene, options);
  scene->samples = *samples;
  scene->sample_estimate = estimate_samples(*m.volume);
  scene->sampling_seconds = watch.seconds() - scene->input_seconds - scene->volume_seconds;

  scene->volume = std::make_shared<const ToleranceVolume>(m.volume->without_octree());
  scene->thresholds = m.volume->thresholds();
  scene->regions.assign(m.volume->regions().begin(), m.volume->regions().end());
  scene->boundary_components.assign(m.volume->boundary_components().begin(),
                                    m.volume->boundary_components().end());
  scene->expected = expected_topology(*m.volume, parameters_.topology);
  scene->thickening_note = m.volume->thickening_note(*m.control);
  for (ParameterWarning& warning : check_parameters(criteria.sigma, criteria.alpha, criteria.delta,
                                                    criteria.condition_2 && !criteria.certified))
    scene->warnings.push_back(std::move(warning));
  if (criteria.certified && parameters_.sigma == 0 && criteria.sigma > 0.5 * scene->delta) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "The tolerance is small for the area of the input: the samples are %.2f δ dense instead of "
                  "δ/2, which keeps them to about two million.",
                  scene->default_sigma);
    scene->warnings.push_back({text, 0});
  }

  if (!scene->left_out.empty()) scene->warnings.push_back({left_out_words(scene->left_out), 0});
  for (const std::string& note : m.volume->side_notes()) scene->warnings.push_back({note, 0});
  if (scene->points)
    for (std::string& note : scene->points->notes(scene->delta, scene->longest_edge))
      scene->warnings.push_back({std::move(note), 0});

  m.journal->add_sample_set(scene->samples);
  m.journal->add_parameters(criteria);
  for (const ParameterWarning& warning : scene->warnings) m.record_warning(warning.message);
  if (!scene->thickening_note.empty()) m.record_warning(scene->thickening_note);

  m.resampling.emplace(*m.gate, criteria.sigma);
  m.recorder.emplace(*m.journal, *m.resampling);
  m.refinement = std::make_unique<Refinement>(*m.volume, scene->samples, criteria,
                                              expected_before_the_cut(*m.volume, scene->expected),
                                              RefinementLimits{}, *m.recorder, *m.control);
  m.scene = scene;
  m.current_samples = scene->samples;
  m.seconds = watch.seconds();
  return m.scene;
}

std::shared_ptr<const Scene> Pipeline::examined() const {
  return impl_->examined;
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
  m.simplification = std::make_unique<Simplification>(*m.volume, m.current_samples, playback.parameters(),
                                                      parameters_.simplification(), *m.recorder, *m.control,
                                                      playback.complex());
  m.refined.end = RefinementOutcome::End::finished;
  m.branched = describe(branch);
  Event e;
  e.kind = EventKind::warning;
  e.stage = at.stage;
  e.text = m.journal->add_text(m.branched);
  m.journal->add_event(e);
  return m.simplification->begin_with(at.stage, at.open, at.seconds, branch.a, branch.b, branch.target);
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
    const Result<bool> finished = m.simplify();
    if (!finished && m.recorder->rehearsal() != nullptr) return finished.error();
    if (!finished) result.failure = finished.error();
    stopped = finished && !*finished;
  }
  if (m.control->cancelled() || stopped) {
    result.end = m.control->timed_out() ? RunResult::End::limit : RunResult::End::stopped;
  }
  result.refinement = m.refined;
  result.branch = m.branched;
  result.last_stage = m.last_stage();
  result.form = m.complex().form;
  const ZeroSet zero_set = extract_zero_set(m.complex());
  result.mesh = triangulate(zero_set);
  result.holes = filled_holes(*m.journal, m.journal->steps(), m.complex(), zero_set);
  result.certificate = certify(
      result.mesh, *m.volume, with_filled_holes(m.scene->expected, result.holes, result.mesh), *m.control,
      {parameters_.cover, parameters_.topology == TopologyMode::separate, true}, result.holes);
  result.crumbs = count_small_parts(result.mesh, crumb_size * m.scene->delta);
  if (m.volume->has_surface()) result.normals = measure_normal_deviation(result.mesh, *m.volume, *m.control);
  if (m.scene->points) result.points = measure_points(*m.scene->points, result.mesh, *m.control);
  m.seconds += watch.seconds();
  result.seconds = m.seconds;
  result.peak_memory_bytes = peak_memory_bytes();
  return result;
}

} // namespace isoscope
