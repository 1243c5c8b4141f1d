// From half of the longest edge downwards, then between the last that closes and the first that does not.
#include "run/closing_tolerance.h"

#include "base/numbers.h"
#include "refine/refinement.h"
#include "run/passing_gate.h"
#include "tolerance/parameter_check.h"
#include "tolerance/thin_parts.h"

#include <cmath>
#include <cstdio>
#include <optional>

namespace isoscope {

namespace {

/// Between the tolerances that are tried first, and how near the answer has to be.
constexpr double step = 1.25, precision = 1.03;
/// The largest tolerance, in longest edges: beyond it nothing has an inside.
constexpr double largest_share = 0.5;
/// Cells of an octree for each δ'² of the input's area, about, and how many all trials may take together.
constexpr double cells_by_area = 40, most_cells = 3e6;
/// How often a larger one is tried where samples or the refinement find an opening that cells do not show: by
/// steps that grow by this factor each.
constexpr int most_attempts = 8;
constexpr double attempt_step = 1.03;
/// Vertices after which a refinement has shown that it runs.
constexpr std::size_t trial_insertions = 3000;
/// Of a tolerance, to see whether the input is taken at less.
constexpr int most_halvings = 3;

class Trials {
 public:
  /// `open`: whether the input may be open at the tolerance sought.
  Trials(const RefusedInput& input, bool open, const RunParameters& parameters, const RunControl& control)
      : input_(&input), open_(open), parameters_(&parameters), control_(&control) {}

  double longest_edge() const { return input_->field->bounds().longest_edge(); }
  /// Whether one more trial is within what all may take; counts it.
  bool affords(double delta) {
    cells_ += cells_by_area * input_->area / (delta * delta);
    return cells_ <= most_cells && !control_->cancelled();
  }
  /// Whether there is Ω at this tolerance with its sides, which samples alone tell of sheets.
  Status served(double delta) const {
    auto volume = build(delta);
    if (!volume) return volume.error();
    if (!open_) return {};
    const auto samples =
        sample_boundary(*volume, default_sigma_ratio(input_->area, delta) * delta, *control_);
    return samples ? Status() : Status(samples.error());
  }
  bool serves(double delta) const { return served(delta).ok(); }
  /// Whether a run at this tolerance comes to its refinement and stays in it.
  bool begins(double delta) const {
    auto volume = build(delta);
    if (!volume) return false;
    const CriteriaParameters criteria =
        parameters_->criteria(delta, default_sigma_ratio(input_->area, delta));
    auto samples = sample_boundary(*volume, criteria.sigma, *control_);
    if (!samples || !volume->check_passages()) return false;
    auto journal = std::make_shared<Journal>();
    const auto shared = std::make_shared<const BoundarySamples>(std::move(*samples));
    journal->add_sample_set(shared);
    journal->add_parameters(criteria);
    PassingGate gate(criteria);
    Recorder recorder(*journal, gate);
    Refinement refinement(*volume, shared, criteria, expected_topology(*volume, parameters_->topology),
                          {trial_insertions, trial_insertions}, recorder, *control_);
    const RefinementOutcome outcome = refinement.run();
    return outcome.end == RefinementOutcome::End::finished || outcome.end == RefinementOutcome::End::limit;
  }

 private:
  Result<ToleranceVolume> build(double delta) const {
    ToleranceVolume::Options options = input_->options;
    options.delta = delta;
    options.open_surfaces = open_;
    auto volume = ToleranceVolume::build(input_->field, input_->topology, options, *control_);
    if (!volume) return volume;
    const std::vector<ThinPart> thin = find_thin_parts(*volume);
    const bool all = thin.size() == volume->volume_component_count();
    if (!thin.empty() && (all || !parameters_->drop_thin)) return thin_parts_error(*volume, thin, {});
    return volume;
  }

  const RefusedInput* input_;
  bool open_;
  const RunParameters* parameters_;
  const RunControl* control_;
  double cells_ = 0;
};

/// The next percentage with three digits that is not below.
double rounded_up(double percent) {
  const double unit = std::pow(10.0, std::floor(std::log10(percent)) - 2);
  return std::ceil(percent / unit - 1e-9) * unit;
}

std::string percent_text(double percent) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g%%", percent);
  return text;
}

/// What was found of a range of tolerances.
struct Found {
  std::optional<double> percent; ///< of the longest edge, at which a run begins
  bool smallest = false;         ///< whether none clearly below does
  bool all = false;              ///< whether the whole range was looked at
  double tried = 0;              ///< the smallest tolerance that was, in percent
};

Found search(Trials& trials, double from, bool open, const RunControl& control) {
  const double edge = trials.longest_edge();
  double tried = largest_share * edge; // the smallest so far
  double serving = 0, failing = 0;     // 0: none yet
  for (double delta = tried; delta > from * precision && trials.affords(delta); delta /= step) {
    if (trials.serves(delta)) {
      serving = delta;
      failing = 0;
    } else if (serving > 0 && failing == 0) {
      failing = delta;
      if (!open) break; // gaps do not close again at less
    }
    tried = delta;
  }
  Found found;
  found.tried = 100 * tried / edge;
  found.all = tried <= from * precision * step;
  if (found.all && serving > 0 && failing == 0) failing = from;
  while (serving > 0 && failing > 0 && serving > failing * precision) {
    const double middle = std::sqrt(serving * failing);
    if (!trials.affords(middle)) break;
    (trials.serves(middle) ? serving : failing) = middle;
  }
  // What octrees took for closed, samples and the refinement may find to be open by a hair.
  int attempts = 0;
  for (int attempt = 0; serving > 0 && !found.percent && attempt < most_attempts && !control.cancelled();
       ++attempt) {
    const double larger = std::pow(attempt_step, attempt * (attempt + 1) / 2);
    const double candidate = rounded_up(100 * serving / edge * larger);
    ++attempts;
    if (trials.begins(candidate / 100 * edge)) found.percent = candidate;
  }
  found.smallest = attempts > 1 || (failing > 0 && serving <= failing * precision);
  return found;
}

std::string share_text(double percent, double edge) {
  return percent_text(percent) + " of the longest edge (" +
         general(Tolerance{percent, true}.absolute(edge), 4) + ")";
}

std::string none_text(const Found& found) {
  return "No tolerance " + (found.all ? std::string("up") : "from " + percent_text(found.tried)) + " to " +
         percent_text(100 * largest_share) + " of the longest edge ";
}

} // namespace

Error with_closing_tolerance(Error open, const RefusedInput& input, const RunParameters& parameters,
                             const RunControl& control) {
  Trials trials(input, false, parameters, control);
  const Found found = search(trials, input.options.delta, false, control);
  if (control.cancelled()) return open;
  if (found.percent)
    open.remedy = (found.smallest ? "The smallest tolerance that closes it is about "
                                  : "It is closed by a tolerance of ") +
                  share_text(*found.percent, trials.longest_edge()) + ".";
  else
    open.remedy = none_text(found) + "closes it.";
  return open;
}

Error with_separating_tolerance(Error refused, const RefusedInput& input, const RunParameters& parameters,
                                const RunControl& control) {
  Trials trials(input, true, parameters, control);
  const Found found = search(trials, input.options.delta, true, control);
  refused.remedy += " ";
  if (control.cancelled())
    refused.remedy += "A larger tolerance takes in what is short.";
  else if (found.percent)
    refused.remedy += (found.smallest ? "The smallest larger tolerance at which a run begins is about "
                                      : "A run begins at a tolerance of ") +
                      share_text(*found.percent, trials.longest_edge()) + ".";
  else
    refused.remedy += none_text(found) + "takes it in.";
  return refused;
}

Error with_smaller_tolerance(Error refused, const RefusedInput& input, const RunParameters& parameters,
                             const RunControl& control) {
  Trials trials(input, true, parameters, control);
  double delta = input.options.delta;
  for (int i = 0; i < most_halvings && trials.affords(delta / 2); ++i) {
    delta /= 2;
    const Status served = trials.served(delta);
    if (served || control.cancelled()) continue;
    refused.remedy = "Mend the input: a smaller tolerance does not help, as at " +
                     share_text(100 * delta / trials.longest_edge(), trials.longest_edge()) +
                     " this is found: " + served.error().line();
    break;
  }
  return refused;
}

} // namespace isoscope
