// A gate that compares while the new run goes on, then a walk over the recorded states and back.
#include "run/replay_check.h"

#include "journal/describe.h"
#include "journal/digest.h"
#include "mesh/zero_set.h"
#include "run/branch.h"
#include "run/recorded_run.h"

#include <algorithm>
#include <array>
#include <vector>

namespace isoscope {

namespace {

/// States of up to so many tetrahedra and vertices are compared after every operation.
constexpr std::size_t small_state = 5000;

std::uint64_t digest_of(const Event& event) {
  Digest d;
  d.add(event);
  return d.value();
}

bool same_figures(const StepFigures& a, const StepFigures& b) {
  Digest x, y;
  for (const auto& [digest, f] : {std::pair{&x, &a}, std::pair{&y, &b}}) {
    digest->add(f->bad_samples);
    digest->add(f->zero_set_vertices);
    digest->add(f->tets);
    digest->add(static_cast<double>(f->largest_error));
    digest->add(static_cast<double>(f->smallest_height));
  }
  return x.value() == y.value();
}

bool same_samples(const BoundarySamples& a, const BoundarySamples& b) {
  return a.positions == b.positions && a.labels == b.labels;
}

/// Where the recorded run left another one, or an earlier state of itself.
struct RecordedBranch {
  std::size_t event = 0; ///< that tells of it; all before are the other run's
  BranchPoint point;     ///< without the journal
};

std::vector<RecordedBranch> branches_of(const Journal& recorded) {
  std::vector<RecordedBranch> branches;
  for (std::size_t k = 0; k < recorded.operations().size(); ++k) {
    const std::uint32_t made = recorded.operations()[k].event;
    const Event& e = recorded.events()[made];
    // A collapse by hand begins a branch, right after the line that says so.
    if (e.kind != EventKind::collapse || e.reason != Reason::user || made == 0) continue;
    branches.push_back({made - 1, {nullptr, e.step, e.vertex, e.other, e.point}});
  }
  return branches;
}

/// What differs in an event of both journals, and its operation; empty where nothing does.
std::string difference(const Journal& recorded, const Journal& journal, std::size_t i) {
  const Event &was = recorded.events()[i], &is = journal.events()[i];
  if (digest_of(was) != digest_of(is)) return "its numbers";
  if (recorded.texts()[was.text] != journal.texts()[is.text]) return "its text";
  if (recorded.repairs()[was.detail] != journal.repairs()[is.detail]) return "the sweeps of its repair";
  if (!was.operation) return {};
  const Operation &a = recorded.operations()[was.step], &b = journal.operations()[is.step];
  if (digest(a.delta()) != digest(b.delta())) return "what it changed";
  if (!same_figures(a.figures, b.figures)) return "the figures after it";
  if (const auto set = a.delta().sample_set;
      set && !same_samples(*recorded.sample_sets()[set->after], *journal.sample_sets()[set->after]))
    return "its samples";
  return {};
}

/// Writes down that the next event differs.
void differ(ReplayVerdict& verdict, const Journal& recorded, const Journal& journal,
            const std::string& what) {
  const std::size_t i = verdict.events;
  verdict.same = false;
  verdict.step = recorded.events()[i].step;
  verdict.difference = "Event " + std::to_string(i) + " at step " + std::to_string(verdict.step) +
                       " differs in " + what + ": recorded \"" + describe(recorded, recorded.events()[i]) +
                       "\", now \"" + describe(journal, journal.events()[i]) + "\".";
}

/// Compares each event as the new run makes it, and steers the run as the recorded one was steered.
class ComparingGate : public Gate {
 public:
  ComparingGate(const Journal& recorded, RunControl& control, ReplayVerdict& verdict)
      : recorded_(&recorded), control_(&control), verdict_(&verdict) {
    if (!recorded.parameters().empty()) wanted_ = recorded.parameters()[0].criteria;
  }

  Verdict pass(const Journal& journal, const Event&) override {
    const std::size_t end = branch_ ? branch_->event : recorded_->events().size();
    while (verdict_->same && verdict_->events < journal.events().size() && verdict_->events < end)
      compare_next(journal);
    const bool all = verdict_->events >= end;
    if (!verdict_->same || (all && !branch_ && !ended_)) {
      control_->abandon(); // nobody wants what the new run would end with
      return Verdict::stop;
    }
    // What was left there is complete once the operation after it is there.
    if (all && branch_ && journal.steps() > branch_->point.step) return Verdict::stop;
    return all ? Verdict::go_on : what_was_asked();
  }
  CriteriaParameters wanted_parameters() const override { return wanted_; }
  /// The recorded run came to its end: the new one is let to its own.
  void set_ended(bool ended) { ended_ = ended; }
  /// Compares up to a branch, or to the end.
  void set_branch(std::optional<RecordedBranch> branch) { branch_ = std::move(branch); }

 private:
  const Journal* recorded_;
  RunControl* control_;
  ReplayVerdict* verdict_;
  CriteriaParameters wanted_;
  std::size_t changes_ = 0; ///< of parameters so far
  bool ended_ = false;
  std::optional<RecordedBranch> branch_;

  void compare_next(const Journal& journal) {
    if (const std::string what = difference(*recorded_, journal, verdict_->events); !what.empty())
      return differ(*verdict_, *recorded_, journal, what);
    const Event& was = recorded_->events()[verdict_->events];
    if (was.kind == EventKind::parameter_change) ++changes_;
    if (was.operation) ++verdict_->operations;
    ++verdict_->events;
  }

  /// The recorded run was stopped or given parameters here when the next events say so.
  Verdict what_was_asked() {
    std::size_t changes = 0;
    const std::size_t next = verdict_->events;
    for (std::size_t i = next; i < recorded_->events().size(); ++i) {
      const EventKind kind = recorded_->events()[i].kind;
      if (kind == EventKind::parameter_change)
        ++changes;
      else if (kind != EventKind::stopped && kind != EventKind::stage_begin)
        break;
    }
    const std::size_t record = changes_ + changes;
    if (changes > 0 && record < recorded_->parameters().size()) {
      wanted_ = recorded_->parameters()[record].criteria;
      return Verdict::parameters_changed;
    }
    return recorded_->events()[next].kind == EventKind::stopped ? Verdict::stop : Verdict::go_on;
  }
};

/// Every state on the way to the end and back again: undoing an operation gives the state before it.
void walk_states(const Journal& journal, std::size_t operations, ReplayVerdict& verdict) {
  struct Seen {
    std::size_t step;
    std::uint64_t digest;
  };
  Complex complex;
  std::vector<Seen> seen{{0, digest(complex)}};
  std::size_t touched = 0;
  for (std::size_t k = 0; k < operations; ++k) {
    const Delta delta = journal.operations()[k].delta();
    complex.apply(delta);
    touched += 8 * (1 + delta.removed.size() + delta.added.size() + delta.moves.size());
    const std::size_t size = complex.tets.size() + complex.vertices.size();
    if (size > small_state && touched < size && k + 1 < operations) continue;
    touched = 0;
    seen.push_back({k + 1, digest(complex)});
  }
  for (std::size_t k = operations + 1; k-- > 0;) {
    if (seen.back().step == k) {
      if (digest(complex) != seen.back().digest) {
        verdict.same = false;
        verdict.step = static_cast<Step>(k);
        verdict.difference =
            "Undoing the operations does not give the state of step " + std::to_string(k) + " back.";
        return;
      }
      seen.pop_back();
      ++verdict.states;
      if (seen.empty()) break;
    }
    if (k > 0) complex.undo(journal.operations()[k - 1].delta());
  }
}

void compare_end(const RunResult& result, const Journal& recorded, ReplayVerdict& verdict) {
  const TriangleMesh mesh = triangulate(extract_zero_set(final_state(recorded)));
  verdict.to_the_end = mesh.points == result.mesh.points && mesh.triangles == result.mesh.triangles;
  if (verdict.to_the_end) return;
  verdict.same = false;
  verdict.step = recorded.steps();
  verdict.difference = "The final Z of the new run is not the recorded one.";
}

/// One check: a new run of its own, beside the recorded one.
class Check {
 public:
  Check(const RunParameters& parameters, const Journal& recorded, bool ended, RunControl& control)
      : recorded_(recorded), ended_(ended), control_(control), gate_(recorded, control, verdict_),
        pipeline_(parameters, journal_, gate_, control) {
    gate_.set_ended(ended);
  }

  Result<ReplayVerdict> run(std::shared_ptr<const TriangleSoup> input, std::vector<InputNote> notes,
                            const std::vector<RecordedBranch>& branches) {
    const auto scene = pipeline_.prepare(std::move(input), std::move(notes), ThinParts::accept);
    if (!scene) return scene.error();
    if (!recorded_.sample_sets().empty() && !same_samples(*recorded_.sample_sets()[0], *(*scene)->samples)) {
      verdict_.same = false;
      verdict_.difference = "The samples of the boundary differ before the first operation.";
      return verdict_;
    }
    for (const RecordedBranch& branch : branches) {
      gate_.set_branch(branch);
      if (Status made = run_to(branch.event); !made) return made.error();
      if (!verdict_.same) return verdict_;
      auto next = std::make_shared<Journal>();
      next->take_prefix(*journal_, branch.point.step, branch.event);
      journal_ = next;
      BranchPoint point = branch.point;
      point.from = next;
      gate_.set_branch(std::nullopt);
      if (Status begun = pipeline_.branch(point, next); !begun) return begun.error();
    }
    if (Status made = run_to(recorded_.events().size()); !made) return made.error();
    compare_ends();
    return verdict_;
  }

 private:
  const Journal& recorded_;
  bool ended_;
  RunControl& control_;
  ReplayVerdict verdict_;
  std::shared_ptr<Journal> journal_ = std::make_shared<Journal>();
  ComparingGate gate_;
  Pipeline pipeline_;
  std::optional<RunResult> result_;

  /// The recorded run had ended and went on improving.
  bool went_on_here() const {
    if (verdict_.events >= recorded_.events().size()) return false;
    const Event& next = recorded_.events()[verdict_.events];
    return next.kind == EventKind::stage_begin && next.stage == Stage::improve && next.count > 0;
  }

  /// Runs on until so many events are compared, and says so where the new run has fewer.
  Status run_to(std::size_t events) {
    result_.reset();
    for (std::size_t before = verdict_.events;; before = verdict_.events) {
      if (verdict_.events >= events && result_) break;
      if (result_ && went_on_here()) static_cast<void>(pipeline_.go_on());
      auto run = pipeline_.run();
      if (!run) return run.error();
      result_ = std::move(*run);
      // A run that ended and was given other parameters goes on; one that was cancelled does not.
      if (control_.cancelled() || !verdict_.same || verdict_.events == before) break;
    }
    if (control_.cancelled() && !control_.abandoned())
      return Error{ErrorCode::cancelled, "The check was stopped.", ""};
    if (!verdict_.same || verdict_.events >= events) return {};
    verdict_.same = false;
    verdict_.step = recorded_.events()[verdict_.events].step;
    verdict_.difference = "The new run ends before event " + std::to_string(verdict_.events) + ", \"" +
                          describe(recorded_, recorded_.events()[verdict_.events]) + "\".";
    return {};
  }

  void compare_ends() {
    if (verdict_.same && ended_ && journal_->events().size() != recorded_.events().size()) {
      verdict_.same = false;
      verdict_.step = recorded_.steps();
      verdict_.difference = "The new run has " + std::to_string(journal_->events().size()) + " events, not " +
                            std::to_string(recorded_.events().size()) + ".";
    }
    if (verdict_.same) walk_states(recorded_, recorded_.operations().size(), verdict_);
    if (verdict_.same && ended_ && result_) compare_end(*result_, recorded_, verdict_);
  }
};

/// A branch is recorded with the parameters of its own; what it left began with those of the journal.
bool began_otherwise(const RunParameters& p, const Journal& recorded) {
  if (recorded.parameters().empty()) return false;
  const CriteriaParameters& c = recorded.parameters()[0].criteria;
  const std::array<bool, 4> conditions{c.condition_1, c.condition_2, c.condition_3, c.condition_4};
  // What is taken by default is no less than this.
  const bool other_sigma =
      p.sigma > 0 ? p.sigma * c.delta != c.sigma : c.sigma < p.sigma_ratio() * c.delta * (1 - 1e-9);
  return other_sigma || p.alpha != c.alpha || p.shrink != c.shrink || p.conditions != conditions;
}

} // namespace

Result<ReplayVerdict> check_replay(const RunParameters& parameters, std::shared_ptr<const TriangleSoup> input,
                                   const Journal& recorded, bool ended, RunControl& control,
                                   std::vector<InputNote> notes) {
  const std::vector<RecordedBranch> branches = branches_of(recorded);
  RunParameters unlimited = branches.empty() && !began_otherwise(parameters, recorded)
                                ? parameters
                                : parameters_at_start(parameters, recorded);
  unlimited.time_limit = unlimited.memory_limit = 0;
  return Check(unlimited, recorded, ended, control).run(std::move(input), std::move(notes), branches);
}

ReplayVerdict compare_journals(const Journal& recorded, const Journal& again) {
  ReplayVerdict verdict;
  const std::size_t n = recorded.events().size();
  for (; verdict.events < std::min(n, again.events().size()); ++verdict.events) {
    if (const std::string what = difference(recorded, again, verdict.events); !what.empty()) {
      differ(verdict, recorded, again, what);
      return verdict;
    }
    if (recorded.events()[verdict.events].operation) ++verdict.operations;
  }
  if (n != again.events().size()) {
    verdict.same = false;
    verdict.step = recorded.steps();
    verdict.difference = "The new run has " + std::to_string(again.events().size()) + " events, not " +
                         std::to_string(n) + ".";
    return verdict;
  }
  walk_states(recorded, recorded.operations().size(), verdict);
  verdict.to_the_end = verdict.same;
  return verdict;
}

} // namespace isoscope
