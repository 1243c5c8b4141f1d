// Reads the journal's index and the facts of the parameters.
#include "steering/apply_plan.h"

#include "model/words.h"
#include "run/branch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

constexpr std::array<std::string_view, 6> way_names{"nothing",  "wrong", "restart",
                                                    "too-late", "go-on", "branch"};

/// The seconds that following a run takes of those that the run itself took there.
constexpr double share_of_following = 0.15;

bool matters(const LiveChange& change, Stage stage) {
  return !comes_after(stage, change.until);
}

/// The names of fields that a restart needs: "δ, containment".
std::string restart_symbols(const RunParameters& a, const RunParameters& b) {
  std::string all;
  for_each_field<RunParameters>([&](const auto& f) {
    if (f.restart && !(f.value(a) == f.value(b))) all += (all.empty() ? "" : ", ") + std::string(f.symbol);
  });
  return all;
}

std::string symbols(const std::vector<LiveChange>& changes) {
  std::string all;
  for (const LiveChange& c : changes) all += (all.empty() ? "" : ", ") + c.symbol;
  return all;
}

/// The stage that a run which goes on in place is in.
Stage live_stage(const JournalIndex& index) {
  return index.stages().empty() ? Stage::refinement : index.stages().back().stage;
}

/// What can_go_on() says, asked every frame: by the index.
bool can_branch_at(const JournalIndex& index, Step step) {
  const auto improver = index.begin_of(Stage::improve);
  return step > 0 && step <= index.steps() && (!improver || step <= *improver) &&
         index.count(EventKind::fill, 0, step) == 0;
}

/// The last step at which all changes matter.
std::optional<Step> last_step(const JournalIndex& index, const std::vector<LiveChange>& changes) {
  Stage until = changes.front().until;
  for (const LiveChange& c : changes)
    if (comes_after(until, c.until)) until = c.until;
  std::optional<Step> last;
  for (const JournalIndex::StageSpan& span : index.stages())
    if (!comes_after(span.stage, until)) last = span.end;
  return last && can_branch_at(index, *last) ? last : std::nullopt;
}

ApplyPlan refused(ApplyWay way, std::string words, std::string remedy, std::vector<LiveChange> changes = {}) {
  ApplyPlan plan;
  plan.way = way;
  plan.words = words;
  plan.error = Error{ErrorCode::usage, std::move(words), std::move(remedy)};
  plan.changes = std::move(changes);
  return plan;
}

} // namespace

std::string_view name(ApplyWay way) {
  return way_names.at(static_cast<std::size_t>(way));
}

RunParameters used_parameters(const WindowState& window) {
  RunParameters used = window.run.parameters;
  const auto& journal = window.run.journal;
  const auto& scene = window.run.scene;
  if (!journal || !scene || journal->parameters().empty()) return used;
  const CriteriaParameters c = journal->parameters_at(window.transport.step());
  used.alpha = c.alpha;
  used.shrink = c.shrink;
  used.conditions = {c.condition_1, c.condition_2, c.condition_3, c.condition_4};
  // σ is a ratio here and a length there: the one that gives it to all digits that count.
  constexpr double rounding = 1e-12;
  const auto gives = [&](const RunParameters& p) {
    const double sigma = p.criteria(scene->delta, scene->default_sigma).sigma;
    return std::abs(sigma - c.sigma) <= rounding * c.sigma;
  };
  if (!gives(used)) used.sigma = gives(window.draft) ? window.draft.sigma : c.sigma / c.delta;
  return used;
}

Status check_draft(const RunParameters& draft) {
  const Status each = check_fields(draft, [](const FieldFacts& f) { return std::string(f.symbol); });
  return each ? check(draft) : each;
}

ApplyPlan plan_apply(const WindowState& window) {
  ApplyPlan plan;
  if (const Status right = check_draft(window.draft); !right) {
    plan.way = ApplyWay::wrong;
    plan.words = right.error().message;
    plan.error = right.error();
    return plan;
  }
  if (!window.run.journal || !window.run.scene) {
    plan.words = "There is no run yet.";
    return plan;
  }
  const RunParameters used = used_parameters(window);
  if (const std::string belong = restart_symbols(window.draft, used); !belong.empty())
    return refused(ApplyWay::restart,
                   belong + " belong" + (belong.find(',') == std::string::npos ? "s" : "") +
                       " to the whole run: restart.",
                   "Use Restart (Ctrl+R).");
  plan.changes = live_changes(used, window.draft, window.run.scene->default_sigma);
  if (plan.changes.empty()) {
    plan.words = "These are the run's parameters.";
    return plan;
  }
  const JournalIndex& index = window.index;
  const Step step = window.transport.step();
  const auto some_matter = [&](Stage stage) {
    return std::any_of(plan.changes.begin(), plan.changes.end(),
                       [&](const LiveChange& c) { return matters(c, stage); });
  };
  plan.step = step;
  plan.step_known = true;
  const bool live = window.transport.at_live_end(window.live_step()) && !window.shows_recording() &&
                    window.run.phase != SessionPhase::failed;
  if (live && some_matter(live_stage(index))) {
    plan.way = ApplyWay::go_on;
    plan.words = "Apply goes on from here, the run's end so far.";
    return plan;
  }
  if (can_branch_at(index, step) && some_matter(stage_to_go_on(*window.run.journal, step))) {
    plan.way = ApplyWay::branch;
    plan.words = "Apply branches at step " + grouped(step) + ".";
    return plan;
  }
  if (step == 0)
    return refused(ApplyWay::restart, "Nothing is done at this step yet: restart.", "Use Restart (Ctrl+R).",
                   std::move(plan.changes));
  const auto last = last_step(index, plan.changes);
  const bool refined = std::any_of(plan.changes.begin(), plan.changes.end(),
                                   [](const LiveChange& c) { return c.until == Stage::refinement; });
  std::string until = symbols(plan.changes) + (plan.changes.size() == 1 ? " matters" : " matter") +
                      " until " + (refined ? "the refinement ends" : "the improver begins") +
                      (last ? ", step " + grouped(*last) + "." : ".");
  plan = refused(ApplyWay::too_late, std::move(until),
                 last ? "Branch there (apply-earlier), or restart (Ctrl+R)." : "Restart (Ctrl+R).",
                 std::move(plan.changes));
  plan.step = last.value_or(0);
  plan.step_known = last.has_value();
  return plan;
}

std::optional<Forecast> forecast(const WindowState& window, const ApplyPlan& plan) {
  const auto& scene = window.run.scene;
  const auto& seconds = window.index.values(Figure::seconds);
  if (!scene || seconds.empty() || window.run.phase != SessionPhase::finished || !window.index.complete())
    return std::nullopt;
  if (plan.way == ApplyWay::nothing || plan.way == ApplyWay::wrong || plan.way == ApplyWay::go_on)
    return std::nullopt;
  const bool whole = plan.way == ApplyWay::restart || !plan.step_known;
  const Step from = whole ? 0 : std::min<Step>(plan.step, static_cast<Step>(seconds.size()));
  const auto spent = [&](Step step) { return step == 0 ? 0.0 : static_cast<double>(seconds[step - 1]); };
  // What is done goes with the samples, and they with 1/σ²; all of it with 1/δ² where that is another.
  const RunParameters used = used_parameters(window);
  const auto ratio = [&](const RunParameters& p) { return p.sigma_ratio(scene->default_sigma); };
  const Tolerance& t = window.draft.tolerance;
  const bool volume = scene->input && scene->input->gives_volume();
  const double delta = t.automatic || volume ? scene->delta : t.absolute(scene->longest_edge);
  const double finer = delta > 0 ? std::pow(scene->delta / delta, 2) : 1;
  const double more = std::pow(ratio(used) / ratio(window.draft), 2) * finer;
  Step refined = 0;
  for (const JournalIndex::StageSpan& span : window.index.stages())
    if (span.stage == Stage::refinement) refined = span.end;
  refined = std::clamp<Step>(refined, from, static_cast<Step>(seconds.size()));
  const double prepared =
      (scene->input_seconds + scene->volume_seconds) * finer + scene->sampling_seconds * more;
  Forecast found;
  found.from = from;
  found.seconds = prepared + share_of_following * spent(from) + (spent(refined) - spent(from)) * more +
                  (spent(static_cast<Step>(seconds.size())) - spent(refined)) * finer;
  return found;
}

} // namespace isoscope
