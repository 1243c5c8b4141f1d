// A sample's class step by step, backwards and forwards from a known state.
#include "journal/sample_history.h"

#include "mesh/sample_sets.h"

#include <algorithm>
#include <limits>

namespace isoscope {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/// One sample and the tetrahedron that holds it, brought along by deltas.
class Follower {
 public:
  Follower(const Complex& state, Vec3 place, double label)
      : complex_(state), place_{place}, label_(label), set_(place_) {
    set_.assign_all(complex_);
    judge();
  }
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  /// NaN where no tetrahedron holds the sample.
  double error() const { return error_; }
  void move(const Delta& delta, bool forward) {
    const TetId tet = set_.tet_of(SampleId(0));
    const auto& from = forward ? delta.removed : delta.added;
    const auto& to = forward ? delta.added : delta.removed;
    const auto holds = [&](const TetRecord& t) { return t.id == tet; };
    const bool leaves = std::any_of(from.begin(), from.end(), holds);
    const bool relabeled = !delta.values.empty() || delta.form ||
                           std::any_of(delta.sides.begin(), delta.sides.end(),
                                       [&](const Delta::SideChange& s) { return s.tet == tet; });
    if (forward)
      complex_.apply(delta);
    else
      complex_.undo(delta);
    if (leaves)
      set_.redistribute(complex_, from, to);
    else if (!tet.valid() && !to.empty())
      set_.assign_all(complex_);
    if (leaves || relabeled || !tet.valid()) judge();
  }

 private:
  Complex complex_;
  std::vector<Vec3> place_;
  int label_;
  SampleSets set_;
  double error_ = nowhere;

  void judge() {
    const TetId t = set_.tet_of(SampleId(0));
    if (!t.valid() || complex_.form == ZeroForm::free) {
      error_ = nowhere;
      return;
    }
    error_ = sample_error_at(complex_, t, place_[0], label_);
  }
};

bool changes_class(double before, double after) {
  return !std::isnan(before) && !std::isnan(after) && is_bad(before) != is_bad(after);
}

HistoryRow change(HistoryRow::Kind kind, const Journal& journal, Step step, double before, double after) {
  HistoryRow r;
  r.kind = kind;
  r.step = step;
  r.event = journal.operations()[step - 1].event;
  r.reason = journal.events()[r.event].reason;
  r.before = before;
  r.after = after;
  return r;
}

/// A sample with its place and its label.
struct Followed {
  Vec3 place;
  int label = 0;
};

/// Nothing where the set in force at `at` has no such sample.
std::optional<Followed> sample_at(const Journal& journal, SampleId sample, Step at) {
  // The set in force: what the last change up to `at` brought.
  std::uint16_t set = 0;
  Delta delta;
  for (Step k = journal.sample_sets().size() > 1 ? at : 0; k-- > 0;) {
    journal.operations()[k].stored.read(delta);
    if (!delta.sample_set) continue;
    set = delta.sample_set->after;
    break;
  }
  if (set >= journal.sample_sets().size() || !journal.sample_sets()[set]) return std::nullopt;
  const BoundarySamples& samples = *journal.sample_sets()[set];
  if (sample.index() >= samples.size()) return std::nullopt;
  return Followed{samples.positions[sample.index()], samples.labels[sample.index()]};
}

/// Hands every change, away from `at`, to `visit` until that returns false or the set changes.
template <class Visit>
void follow(const Journal& journal, const Followed& sample, const Complex& state, Step at, bool forward,
            const RunControl& control, Visit&& visit) {
  Follower follower(state, sample.place, sample.label);
  Delta delta;
  const Step end = journal.steps();
  for (Step k = at; forward ? k < end : k > 0;) {
    const Step operation = forward ? k : k - 1;
    journal.operations()[operation].stored.read(delta);
    if (delta.sample_set) {
      visit(change(HistoryRow::Kind::other_set, journal, operation + 1, 0, 0));
      return;
    }
    const double now = follower.error();
    follower.move(delta, forward);
    const double before = forward ? now : follower.error(), after = forward ? follower.error() : now;
    if (changes_class(before, after) &&
        !visit(change(is_bad(after) ? HistoryRow::Kind::became_bad : HistoryRow::Kind::became_good, journal,
                      operation + 1, before, after)))
      return;
    k = forward ? k + 1 : k - 1;
    if (k % 256 == 0 && control.cancelled()) return;
  }
}

} // namespace

std::vector<HistoryRow> sample_class_changes(const Journal& journal, SampleId sample, const Complex& state,
                                             Step at, const RunControl& control) {
  std::vector<HistoryRow> rows;
  const auto followed = sample_at(journal, sample, at);
  if (!followed) return rows;
  const auto keep = [&](const HistoryRow& row) {
    rows.push_back(row);
    return true;
  };
  follow(journal, *followed, state, at, false, control, keep);
  std::reverse(rows.begin(), rows.end());
  follow(journal, *followed, state, at, true, control, keep);
  return rows;
}

std::optional<HistoryRow> last_class_change(const Journal& journal, SampleId sample, const Complex& state,
                                            Step at, const RunControl& control) {
  std::optional<HistoryRow> last;
  const auto followed = sample_at(journal, sample, at);
  if (!followed) return last;
  follow(journal, *followed, state, at, false, control, [&](const HistoryRow& row) {
    if (row.step < at) last = row;
    return row.step >= at; // the change that led to `at` itself is shown already
  });
  return last;
}

} // namespace isoscope
