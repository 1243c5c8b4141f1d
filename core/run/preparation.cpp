// The steps from a file to Ω and S, in order.
#include "run/preparation.h"

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "criteria/outer_offset.h"
#include "run/closing_tolerance.h"
#include "run/coordinate_check.h"
#include "run/cover_witnesses.h"
#include "run/crumbs.h"
#include "run/make_field.h"
#include "run/run_input.h"
#include "run/sample_memory.h"
#include "run/scattered_points.h"
#include "simplify/first_surface.h"
#include "tolerance/facet_copies.h"
#include "tolerance/open_changes.h"
#include "tolerance/region_labels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isoscope {
namespace {

/// How fine triangles that do not close are studied, relative to the longest edge.
constexpr double study_resolution = 0.003;
/// Tolerances of points that are tried, each larger by this factor, and how many of those at which Ω has an
/// inside but is no thickening.
constexpr int near_tolerances = 6, most_tolerances = 12, most_without_thickening = 3;
constexpr double next_tolerance = 1.1, next_far_tolerance = 1.25;
/// Tolerances of open sheets of points that are tried: from so many times what lies between the points.
constexpr double least_sheet_delta = 2, next_sheet_delta = 1.15;
constexpr int most_sheet_deltas = 10, most_sheet_trials = 5;

/// More samples than this are as sparse as so many δ where ∂Ω is a plane. A point of the input has one of
/// each side within `least_flat_cover` δ all the same.
constexpr double many_samples = 250e3, flat_sigma_ratio = 2, least_flat_cover = 2.5;

Error cancelled_error(const RunControl& control) {
  return {ErrorCode::cancelled,
          control.timed_out() ? "The time limit was reached before the refinement began."
                              : "The run was stopped before the refinement began.",
          ""};
}

} // namespace

std::optional<double> expected_genus(const Scene& scene) {
  const ExpectedTopology& e = scene.expected;
  if (!e.euler_characteristic || !e.components) return std::nullopt;
  if (!e.loops_untold.empty()) return std::nullopt;
  const auto loops = static_cast<double>(e.boundary_loops.value_or(0));
  return static_cast<double>(*e.components) - (static_cast<double>(*e.euler_characteristic) + loops) / 2;
}

std::string tolerance_text(const RunParameters& parameters, const Scene& scene) {
  const bool given = scene.input && scene.input->gives_volume();
  return given ? shortest(scene.delta) : parameters.tolerance.text();
}

ToleranceVolume::Options Preparation::volume_options(double delta) const {
  return {delta,
          parameters_.containment == Containment::certified ? ToleranceVolume::Options().boundary_ratio : 1.0,
          parameters_.most_bytes(), true, parameters_.gamma.gamma > BallTestFactor::automatic};
}

Error Preparation::refused(Error error, const Scene& at) const {
  if (at.input && at.input->gives_volume()) {
    // There is no tolerance to choose.
    if (error.remedy.starts_with("Choose a "))
      error.remedy = at.input->grid
                         ? "Take levels farther apart, or smooth the grid: its steepest slope decides."
                         : "Move the surfaces apart where they are nearest: that decides.";
    return error;
  }
  if (at.field->surface() == nullptr) return error;
  const RefusedInput input{at.field, at.input_topology, kept_area_, volume_options(at.delta)};
  if (error.code == ErrorCode::joined_sheets) {
    control_.report("tolerance that parts the sheets", -1);
    return with_separating_tolerance(std::move(error), input, parameters_, control_);
  }
  if (error.code != ErrorCode::open_surface) return error;
  control_.report("tolerance that closes the input", -1);
  const bool gaps = error.remedy == open_surface_near({}).remedy;
  error = with_closing_tolerance(std::move(error), input, parameters_, control_);
  if (gaps && parameters_.gamma.gamma == BallTestFactor::automatic)
    error.remedy += " Loose triangles are taken for an open surface with --gamma 2.";
  return error;
}

Error Preparation::refused_after_refinement(Error error, const Scene& at) const {
  if (volume_->open_sides() == nullptr || at.field->surface() == nullptr) return error;
  control_.report("smaller tolerances", -1);
  return with_smaller_tolerance(std::move(error),
                                {at.field, at.input_topology, kept_area_, volume_options(at.delta)},
                                parameters_, control_);
}

/// The field of what is kept of the input, and what is known of its surface.
Status Preparation::make_field(Scene& made, const std::shared_ptr<const TriangleSoup>& kept,
                               std::optional<double> delta) {
  auto input = isoscope::make_field(kept, parameters_, delta, control_);
  if (control_.cancelled()) return cancelled_error(control_);
  if (!input) return input.error();
  made.field = std::move(input->field);
  made.input_topology = std::move(input->topology);
  points_ = std::move(input->points);
  if (points_.points) made.study = {points_.points, &points_.points->study};
  for (std::string& note : input->notes) made.warnings.push_back({std::move(note), 0});
  if (!kept->gives_volume()) return {};
  made.delta = input->delta;
  made.input = input->shown ? std::move(input->shown) : kept;
  return {};
}

void Preparation::use_points(Scene& made) const {
  made.field = points_.index;
  made.points = points_.points;
}

/// δ as given, or found from the field, which is made for that.
Result<double> Preparation::find_delta(Scene& made, const std::shared_ptr<const TriangleSoup>& soup) {
  if (!parameters_.tolerance.automatic) return parameters_.tolerance.absolute(made.longest_edge);
  if (Status read = make_field(made, soup, {}); !read) return read.error();
  if (made.input_topology.closed_manifold) return Tolerance().absolute(made.longest_edge);
  if (!made.study)
    made.study = std::make_shared<const DeltaStudy>(
        study_delta(*made.field, study_resolution * made.longest_edge, control_));
  if (control_.cancelled()) return cancelled_error(control_);
  return points_.points && !sheet_gammas().empty() ? find_sheet_delta(made) : proposed_tolerance(*made.study);
}

/// γ to be tried, where parts that enclose nothing are taken for open surfaces though no triangles are joined
/// to sheets; else none.
std::vector<double> Preparation::sheet_gammas() const {
  const double gamma = parameters_.gamma.gamma;
  if (gamma == BallTestFactor::off) return {};
  if (gamma != BallTestFactor::automatic) return {gamma};
  if (!points_.points || points_.points->study.found()) return {};
  return {BallTestFactor::usual.begin(), BallTestFactor::usual.end()};
}

/// The least δ from which on Ω keeps what it is: as few parts, tunnels through sheets and pockets in them as
/// at the next two that are tried. What points leave between them goes with their spacing.
Result<double> Preparation::find_sheet_delta(Scene& made) {
  const double spacing = std::sqrt(made.field->area() / static_cast<double>(made.field->size()));
  double delta = least_sheet_delta * spacing;
  std::vector<long> counts;
  for (int tried = 0; tried < most_sheet_deltas; ++tried, delta *= next_sheet_delta) {
    points_ = with_all_sites(points_, control_);
    made.delta = delta;
    if (Status settled = settle_points(made); !settled) return settled.error();
    const auto built =
        ToleranceVolume::build(made.field, made.input_topology, volume_options(delta), control_);
    if (control_.cancelled()) return cancelled_error(control_);
    if (!built) return built.error();
    const auto parts = static_cast<long>(built->volume_component_count());
    long sum = 0; // of χ of ∂Ω: twice that of Ω
    for (const BoundaryComponent& c : built->boundary_components()) sum += c.euler_characteristic;
    counts.push_back(2 * parts - sum / 2 + 2 * static_cast<long>(built->regions().size()));
    const std::size_t n = counts.size();
    if (n >= 3 && counts[n - 3] <= std::min(counts[n - 2], counts[n - 1])) break;
  }
  points_ = with_all_sites(points_, control_);
  use_points(made);
  return delta / next_sheet_delta;
}

/// Leaves points out that do not belong to the surface at this δ.
Status Preparation::settle_points(Scene& made) {
  const double boundary = volume_options(made.delta).boundary_ratio * made.delta;
  points_ = without_strays(points_, made.delta, boundary, control_);
  if (control_.cancelled()) return cancelled_error(control_);
  use_points(made);
  return {};
}

/// Ω of what is kept of the input; without its thin parts, one after the other, where they are to be
/// dropped.
Status Preparation::build_volume(Scene& made, std::shared_ptr<const TriangleSoup> kept, ThinParts thin) {
  const bool drop = parameters_.drop_thin;
  for (;;) {
    kept_area_ = made.field->area();
    auto built =
        ToleranceVolume::build(made.field, made.input_topology, volume_options(made.delta), control_);
    if (!built) return built.error();
    if (points_.points) {
      auto rest = without_blobs(points_, *built, !sheet_gammas().empty(), control_);
      if (!rest) return rest.error();
      if (rest->index == points_.index) {
        if (!sheet_gammas().empty())
          if (auto error = scattered(points_, *built, control_)) return std::move(*error);
        if (Status open = open_sheets(made, *built, sheets_among(*built)); !open) return open;
        volume_.emplace(std::move(*built));
        return {};
      }
      points_ = std::move(*rest);
      use_points(made);
      if (control_.cancelled()) return cancelled_error(control_);
      continue;
    }
    if (Status open = open_sheets(made, *built, built->loose_sheets()); !open) return open;
    const std::vector<ThinPart> parts = find_thin_parts(*built);
    const bool all = parts.size() == built->volume_component_count();
    if (!parts.empty() && thin == ThinParts::refuse && (!drop || all)) {
      const auto keeping = find_keeping_tolerance(*built, parts, control_);
      return keeping ? thin_parts_error(*built, parts, *keeping) : keeping.error();
    }
    if (parts.empty() || !drop || all) {
      volume_.emplace(std::move(*built));
      return {};
    }
    kept = std::make_shared<const TriangleSoup>(without_parts(*kept, *built, parts));
    if (Status read = make_field(made, kept, made.delta); !read) return read;
    made.left_out.insert(made.left_out.end(), parts.begin(), parts.end());
  }
}

/// Finds the sides of what encloses nothing.
Status Preparation::open_sheets(Scene& made, ToleranceVolume& volume,
                                const std::vector<std::uint8_t>& sheets) const {
  made.sheets.reset();
  if (std::find(sheets.begin(), sheets.end(), 1) == sheets.end()) return {};
  auto found = find_point_sheets(volume, sheets, sheet_gammas(), control_);
  if (control_.cancelled()) return cancelled_error(control_);
  if (!found) return found.error();
  made.sheets = std::move(*found);
  volume.open(made.sheets->sides, control_);
  return {};
}

/// Where δ is to be found, larger ones are tried: pinholes between points are narrower than the cells show
/// that it was found from.
Status Preparation::build_volume_of_sheets(Scene& made, const std::shared_ptr<const TriangleSoup>& soup) {
  const double given = made.delta;
  Status first;
  for (int tried = 0; tried < most_sheet_trials; ++tried, made.delta *= next_sheet_delta) {
    points_ = with_all_sites(points_, control_);
    if (Status settled = settle_points(made); !settled) return settled;
    Status built = build_volume(made, soup, ThinParts::accept);
    if (built) return {};
    if (tried == 0) first = std::move(built);
    if (!parameters_.tolerance.automatic || first.error().code != ErrorCode::open_surface) break;
  }
  made.delta = given;
  return first;
}

/// What the study says of δ is right to about a tenth: a hole may be open that it takes for closed, or a neck
/// closed. Where δ is to be found, larger ones are tried; where it is given, for what to do instead.
Status Preparation::build_volume_of_points(Scene& made, const std::shared_ptr<const TriangleSoup>& soup) {
  if (!sheet_gammas().empty()) return build_volume_of_sheets(made, soup);
  const double given = made.delta;
  struct Found {
    double delta;
    MadePointField points;
    ToleranceVolume volume;
  };
  std::optional<Found> found;
  Status first;
  DeltaStudy study = points_.points->study;
  const std::string advice = enclosing_remedy(study);
  double last = given;
  const bool too_small = given < study.least;
  int without_thickening = 0;
  for (int tried = 0; tried < most_tolerances && (tried == 0 || made.delta < study.most); ++tried) {
    points_ = with_all_sites(points_, control_);
    last = made.delta;
    Status built = settle_points(made);
    if (built) built = build_volume(made, soup, ThinParts::accept);
    if (control_.cancelled()) return cancelled_error(control_);
    if (!parameters_.tolerance.automatic && tried == 0 && built) return {};
    if (tried == 0 && !built) first = built;
    if (!built && (built.error().code != ErrorCode::open_surface || too_small)) break;
    if (built) {
      const bool thickening = volume_->thickening() || !volume_->topology_told();
      if (!found || thickening) found = Found{made.delta, points_, std::move(*volume_)};
      if (thickening || !parameters_.tolerance.automatic || ++without_thickening == most_without_thickening)
        break;
    } else if (!found) {
      study.least = made.delta;
    }
    made.delta *= tried + 1 < near_tolerances ? next_tolerance : next_far_tolerance;
  }
  made.delta = given;
  volume_.reset();
  if (!found) points_ = with_all_sites(points_, control_);
  if (found) { // nothing but this field has seen the study yet
    study.proposed = found->delta;
    points_ = std::move(found->points);
    points_.points->study = std::move(study);
  }
  use_points(made);
  made.study = {points_.points, &points_.points->study};
  if (!found && !first && parameters_.tolerance.automatic && first.error().remedy == advice)
    return nothing_inside_between(given, last);
  if (!found) return first;
  if (!parameters_.tolerance.automatic)
    return Error{first.error().code, first.error().message,
                 "At δ = " + general(found->delta, 4) + " Ω encloses something: choose --tolerance " +
                     general(found->delta, 4) + " or auto."};
  made.delta = found->delta;
  kept_area_ = made.field->area();
  volume_.emplace(std::move(found->volume));
  return {};
}

/// Keeps what was studied, for the choice of another δ: the proposed one, where there is one.
void Preparation::examine(const Scene& made) {
  if (!made.study) return;
  auto kept = std::make_shared<Scene>(made);
  if (made.study->found()) kept->delta = made.study->proposed;
  examined_ = std::move(kept);
}

/// Whether no T is refined for the samples, and nothing of the input is so thin that they must be near it.
bool Preparation::few_samples_do() const {
  return parameters_.start != FirstZ::delaunay && parameters_.containment == Containment::certified &&
         volume_->thickening();
}

double Preparation::default_sigma(double delta) const {
  return few_samples_do() ? sparsest_sigma_ratio : default_sigma_ratio(kept_area_, delta);
}

/// Where nothing is asked for, facet certificates stand for samples in planes, once there are many.
double Preparation::flat_sigma(double sigma) const {
  const double delta = volume_->thresholds().delta;
  const bool may = parameters_.sigma == 0 && parameters_.containment == Containment::certified &&
                   parameters_.cover.value_or(least_flat_cover) >= least_flat_cover && volume_->thickening();
  const bool helps = few_samples_do() || estimate_samples(*volume_).samples(sigma) > many_samples;
  return may && helps ? flat_sigma_ratio * delta : 0;
}

Result<std::shared_ptr<const BoundarySamples>> Preparation::sample(SampleDensity density) {
  const Status fits = check_memory(estimate_samples(*volume_), density.sigma, volume_->thresholds().delta,
                                   parameters_.most_bytes());
  if (!fits) return fits.error();
  auto samples = sample_boundary(*volume_, density, control_);
  if (!samples) return samples.error();
  return std::make_shared<const BoundarySamples>(std::move(*samples));
}

/// Where parts are joined in Ω, what can be made of its outer boundary is counted with the samples.
void Preparation::count_joined(Scene& made, const CriteriaParameters& criteria) const {
  if (auto counted = outer_offset_topology(*volume_, *samples_->nearest, criteria.sigma, control_)) {
    made.expected = std::move(*counted);
  } else {
    made.expected.required = false;
    made.expected.source += ", as coarsely as it could be counted";
  }
}

/// Z need not go into what is thinner than 2δ, but for the cover that is asked for.
void Preparation::hold_thin_parts(const CriteriaParameters& criteria) {
  if (!criteria.certified || !parameters_.cover || parameters_.topology == TopologyMode::separate) return;
  CoverWitnesses found =
      find_cover_witnesses(*volume_, *samples_, *parameters_.cover * volume_->thresholds().delta, control_);
  volume_->hold(found.held, std::move(found.path));
}

/// What is said before the first operation, once Ω and S are there.
void Preparation::warn(Scene& made, const CriteriaParameters& criteria) const {
  for (ParameterWarning& warning : check_parameters(criteria.sigma, criteria.alpha, criteria.delta,
                                                    criteria.condition_2 && !criteria.certified))
    made.warnings.push_back(std::move(warning));
  if (criteria.certified && parameters_.sigma == 0 && criteria.sigma > 0.5 * made.delta &&
      !few_samples_do()) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "The tolerance is small for the area of the input: the samples are %.2f δ dense instead of "
                  "δ/2, which keeps them to about two million.",
                  made.default_sigma);
    made.warnings.push_back({text, 0});
  }

  if (!made.left_out.empty()) made.warnings.push_back({left_out_words(made.left_out), 0});
  for (const std::string& note : volume_->side_notes()) made.warnings.push_back({note, 0});
  if (auto note = open_changes(*volume_, *made.samples, control_))
    made.warnings.push_back({std::move(*note), 0});
  if (made.points)
    for (std::string& note : made.points->notes(made.delta, made.longest_edge, made.sheets.has_value()))
      made.warnings.push_back({std::move(note), 0});
}

Result<std::shared_ptr<const Scene>> Preparation::make(std::shared_ptr<const TriangleSoup> soup,
                                                       std::vector<InputNote> notes, ThinParts thin) {
  if (Status valid = check(parameters_); !valid) return valid.error();
  control_.cancel_after(parameters_.time_limit);
  const Stopwatch watch;
  auto scene = std::make_shared<Scene>();

  control_.report("input", -1);
  if (!soup) {
    auto loaded = read_run_input(parameters_, control_);
    if (!loaded) return control_.cancelled() ? cancelled_error(control_) : loaded.error();
    soup = std::make_shared<const TriangleSoup>(std::move(loaded->soup));
    notes = std::move(loaded->notes);
  }
  if (Status fits = check_volume(*soup, parameters_); !fits) return fits.error();
  if (soup->gives_volume()) {
    if (Status read = make_field(*scene, soup, {}); !read) return read.error();
    soup = scene->input;
  }
  if (soup->points.empty())
    return Error{ErrorCode::bad_input, "The input has neither triangles nor points.", "Give a surface."};
  scene->input = soup;
  if (read_) read_(soup);
  scene->longest_edge = soup->bounds().longest_edge();
  if (!is_field_of_points(*soup, parameters_)) soup = without_needless_copies(soup, control_);
  if (!soup->gives_volume()) {
    const auto delta = find_delta(*scene, soup);
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
                             scene->delta, control_);
  if (control_.cancelled()) return cancelled_error(control_);
  if (!rest) return rest.error();
  if (!rest->note.empty()) scene->warnings.push_back({rest->note, 0});
  if (rest->soup != soup) scene->field.reset();
  soup = rest->soup;
  if (auto note = coordinate_note(*soup, scene->delta)) scene->warnings.push_back({std::move(*note), 0});
  if (!scene->field)
    if (Status read = make_field(*scene, soup, scene->delta); !read) return read.error();
  if (parameters_.start == FirstZ::input && !parameters_.drop_thin)
    if (Status can = can_start_from_input(*scene->field, scene->input_topology); !can) return can.error();
  scene->input_seconds = watch.seconds();

  const bool of_points = points_.points != nullptr;
  const Status built = of_points ? build_volume_of_points(*scene, soup) : build_volume(*scene, soup, thin);
  if (!built) {
    if (control_.cancelled()) return cancelled_error(control_);
    examine(*scene);
    return refused(built.error(), *scene);
  }
  scene->volume_seconds = watch.seconds() - scene->input_seconds;

  scene->default_sigma = default_sigma(scene->delta);
  const CriteriaParameters criteria = parameters_.criteria(scene->delta, scene->default_sigma);
  auto samples = sample({criteria.sigma, flat_sigma(criteria.sigma)});
  if (control_.cancelled()) return cancelled_error(control_);
  if (!samples) return refused(samples.error(), *scene);
  if (Status closed = volume_->check_passages(); !closed) return refused(closed.error(), *scene);
  scene->samples = *samples;
  samples_.emplace(*samples);
  scene->expected = expected_topology(*volume_, parameters_.topology);
  if (scene->expected.joined && !volume_->thickening()) count_joined(*scene, criteria);
  hold_thin_parts(criteria);
  if (control_.cancelled()) return cancelled_error(control_);
  scene->sample_estimate = estimate_samples(*volume_);
  scene->sampling_seconds = watch.seconds() - scene->input_seconds - scene->volume_seconds;

  scene->volume = std::make_shared<const ToleranceVolume>(volume_->without_octree());
  scene->input_size = {scene->input->points.size(), scene->input->triangles.size()};
  scene->held = volume_->held();
  scene->thresholds = volume_->thresholds();
  scene->regions.assign(volume_->regions().begin(), volume_->regions().end());
  scene->boundary_components.assign(volume_->boundary_components().begin(),
                                    volume_->boundary_components().end());
  const InputTopology& topology = scene->input_topology;
  if (!of_points && !soup->gives_volume() && topology.embedded() && topology.consistently_oriented &&
      topology.euler_characteristic)
    scene->optimum = asymptotic_count(*soup, *topology.euler_characteristic, scene->delta);
  scene->thickening_note = volume_->thickening_note(control_);
  warn(*scene, criteria);
  return std::shared_ptr<const Scene>(scene);
}

} // namespace isoscope
