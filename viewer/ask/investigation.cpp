// Asks workers what the panels show, and takes their answers.
#include "ask/investigation.h"

#include "journal/sample_history.h"
#include "journal/vocabulary.h"
#include "model/words.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::size_t loop_bases = 200;

std::shared_ptr<const ElementHistory> read_history(const HistoryQuestion& q, RunControl& control) {
  if (!q.last_only)
    return std::make_shared<const ElementHistory>(
        element_history(*q.journal, q.element, q.state->complex, q.state->step, control));
  auto history = std::make_shared<ElementHistory>();
  history->element = q.element;
  history->steps = q.journal->steps();
  if (const auto last =
          last_class_change(*q.journal, SampleId(q.element.id), q.state->complex, q.state->step, control))
    history->rows = {*last};
  return history;
}

std::shared_ptr<const WorkAnswer> measure_work(const WorkQuestion& q, RunControl&) {
  auto answer = std::make_shared<WorkAnswer>();
  answer->map = map_work(*q.journal, q.begin, q.end, q.kind, q.cell);
  answer->stall = examine_stall(*q.journal, q.stall_end, q.attempts, q.cell, q.begin);
  answer->times = time_by_reason(*q.journal, q.begin, q.end);
  return answer;
}

std::shared_ptr<const TopologyReport> judge_topology(const TopologyQuestion& q, RunControl& control) {
  return std::make_shared<const TopologyReport>(report_topology(*q.state, *q.scene, loop_bases, control));
}

std::shared_ptr<const Advice> advise(const AdviceQuestion& q, RunControl& control) {
  const NearestSample* nearest = q.index && q.index->set == q.state->samples ? &q.index->nearest : nullptr;
  Advice advice;
  switch (q.element.kind) {
  case ElementRef::Kind::tet:
    advice = advise_tet(*q.state, TetId(q.element.id), nearest);
    break;
  case ElementRef::Kind::sample:
    advice = advise_sample(*q.state, SampleId(q.element.id));
    break;
  case ElementRef::Kind::edge:
    advice = advise_edge(*q.state, {VertexId(q.element.id), VertexId(q.element.other), {}, {}},
                         {*q.scene, *q.journal, q.parameters, nearest, {}}, control);
    break;
  case ElementRef::Kind::vertex:
    break;
  }
  return std::make_shared<const Advice>(std::move(advice));
}

std::shared_ptr<const CheckAnswer> judge_state(const CheckQuestion& q, RunControl& control) {
  auto answer = std::make_shared<CheckAnswer>();
  answer->report = check_state(*q.journal, *q.state, q.scene.get(), control);
  if (q.search && !control.cancelled())
    answer->first = find_first_invalid(q.journal, q.state->step, q.scene.get(), control);
  return answer;
}

/// The answer of a worker where it belongs to the question asked.
template <class Worker, class Question, class Same>
auto answer_of(const Worker& worker, const std::optional<Question>& asked, Same&& same)
    -> decltype(worker.answered()->answer) {
  const auto answered = worker.answered();
  return answered && asked && same(answered->question, *asked) ? answered->answer : nullptr;
}

bool same_history(const HistoryQuestion& a, const HistoryQuestion& b) {
  // Rows of a sample do not depend on the state they are followed from, only on its set.
  if (a.last_only != b.last_only || (a.last_only && a.state != b.state)) return false;
  return a.journal == b.journal && a.element == b.element &&
         (a.element.kind != ElementRef::Kind::sample || a.state->samples == b.state->samples);
}
bool same_work(const WorkQuestion& a, const WorkQuestion& b) {
  return a.journal == b.journal && a.begin == b.begin && a.end == b.end && a.stall_end == b.stall_end &&
         a.kind == b.kind && a.attempts == b.attempts && a.cell == b.cell;
}
bool same_topology(const TopologyQuestion& a, const TopologyQuestion& b) {
  return a.state == b.state && a.scene == b.scene;
}
bool same_advice(const AdviceQuestion& a, const AdviceQuestion& b) {
  return a.state == b.state && a.index == b.index && a.element == b.element;
}

} // namespace

Investigation::Investigation(WindowState& shared, const std::function<void()>& notify)
    : window(shared), history_worker_(read_history, notify), work_worker_(measure_work, notify),
      topology_worker_(judge_topology, notify), advice_worker_(advise, notify), check_(judge_state, notify) {}

std::optional<ElementRef> selected_element(const Selection& selection) {
  const Pick& p = selection.picked;
  switch (p.kind) {
  case Pick::Kind::vertex:
    return ElementRef{ElementRef::Kind::vertex, p.id, 0};
  case Pick::Kind::edge:
    return ElementRef{ElementRef::Kind::edge, p.id, p.other};
  case Pick::Kind::tet:
    return ElementRef{ElementRef::Kind::tet, p.id, 0};
  case Pick::Kind::sample:
    return ElementRef{ElementRef::Kind::sample, p.id, 0};
  case Pick::Kind::facet:
  case Pick::Kind::point:
  case Pick::Kind::over_rim:
  case Pick::Kind::none:
    break;
  }
  return std::nullopt;
}

std::vector<TetId> violating_tets(const StateSnapshot& state, ViolationKind kind) {
  if (kind == ViolationKind::misoriented) return misoriented_tets(state);
  std::vector<TetId> out;
  for (const FlatTet& flat : flat_tets(state, state.criteria.height_limit())) out.push_back(flat.tet);
  return out;
}

std::string history_words(const HistoryRow& row, ElementRef::Kind kind) {
  const std::string other = row.other.valid() ? grouped(row.other.value) : std::string();
  switch (row.kind) {
  case HistoryRow::Kind::born:
    return kind == ElementRef::Kind::vertex ? "came into T" : "came to be";
  case HistoryRow::Kind::moved:
    return "moved";
  case HistoryRow::Kind::absorbed:
    return "took in vertex " + other;
  case HistoryRow::Kind::merged:
    return "went into vertex " + other;
  case HistoryRow::Kind::relabeled:
    return "F " + short_number(row.before) + " → " + short_number(row.after);
  case HistoryRow::Kind::sided:
    return row.after < 0 ? "inner side of Z" : "outer side of Z";
  case HistoryRow::Kind::gone:
    return "is gone";
  case HistoryRow::Kind::rejected:
    return "stays: " + std::string(words(row.reason).title);
  case HistoryRow::Kind::collapsed:
    return "collapsed: " + std::string(words(row.reason).title);
  case HistoryRow::Kind::asked:
    return "named: " + std::string(name(row.reason));
  case HistoryRow::Kind::became_bad:
    return "became bad, ε " + short_number(row.before) + " → " + short_number(row.after);
  case HistoryRow::Kind::became_good:
    return "became good, ε " + short_number(row.before) + " → " + short_number(row.after);
  case HistoryRow::Kind::other_set:
    return "another sample set";
  }
  return {};
}

void Investigation::update_history() {
  const auto element = selected_element(window.selection);
  const auto state = window.state();
  const bool wanted = jump_ || window.settings.panes.tab == BottomTab::history;
  if (!element || !state || !window.run.journal || !wanted) {
    history_.reset();
    if (!element) history_asked_.reset(), jump_ = false;
    return;
  }
  const HistoryQuestion question{window.run.journal, *element, state,
                                 element->kind == ElementRef::Kind::sample &&
                                     window.settings.panes.tab != BottomTab::history};
  // Read backwards from the state: it has to be the one from which one goes.
  if (question.last_only && state->step != window.transport.step()) return;
  // A journal that grew is read again when the run rests or the element is asked about anew.
  const bool stale =
      history_ && history_->steps != window.run.journal->steps() && (!window.running() || jump_);
  if (!history_asked_ || !same_history(*history_asked_, question) || stale) {
    history_asked_ = question;
    history_.reset();
    asked_at_ = history_worker_.answered();
    history_worker_.ask(question);
    return;
  }
  const auto answered = history_worker_.answered();
  history_ = answered != asked_at_ ? answer_of(history_worker_, history_asked_, same_history) : nullptr;
}

void Investigation::jump() {
  if (!jump_ || !history_) return;
  jump_ = false;
  const HistoryRow* row = history_->last_change(window.transport.step());
  if (row == nullptr) return window.tell("It did not change before this step.");
  window.transport.jump(row->step);
  window.tell("Step " + grouped(row->step) + ": it " + history_words(*row, history_->element.kind) + ".");
}

void Investigation::update_work() {
  work_.reset();
  if (window.settings.panes.tab != BottomTab::work || !window.run.journal || !window.run.scene) return;
  // A live run is measured again at rests only: the answer would never catch up.
  const bool moving = window.running() || window.playing();
  if (!moving || !work_asked_ || work_asked_->journal != window.run.journal) {
    WorkQuestion q;
    q.journal = window.run.journal;
    const std::size_t events = window.index.events();
    const auto before = [&](Step step) {
      return step > window.live_step() ? events : std::min(events, window.index.first_event_at(step));
    };
    const auto& range = window.range;
    q.begin = range ? before(range->begin) : 0;
    q.end = range ? before(range->end + 1) : events;
    // The attempts before the play head, within the range.
    const Step head = window.transport.step();
    q.stall_end = std::clamp(head >= window.live_step() ? events : before(head + 1), q.begin, q.end);
    q.kind = work_kind;
    q.attempts = stall_attempts;
    q.cell = cell_deltas * window.run.scene->delta;
    if (q.cell > 0 && (!work_asked_ || !same_work(*work_asked_, q))) {
      work_asked_ = q;
      work_worker_.ask(std::move(q));
    }
  }
  work_ = answer_of(work_worker_, work_asked_, same_work);
}

void Investigation::update_topology() {
  const auto state = window.state();
  topology_.reset();
  if (!topology_shown || !state || !window.run.scene) return;
  if (!window.playing() || !topology_asked_) {
    TopologyQuestion q{state, window.run.scene};
    if (!topology_asked_ || !same_topology(*topology_asked_, q)) {
      topology_asked_ = q;
      topology_worker_.ask(std::move(q));
    }
  }
  topology_ = answer_of(topology_worker_, topology_asked_, same_topology);
}

void Investigation::update_advice() {
  const auto element = selected_element(window.selection);
  const auto state = window.state();
  advice_.reset();
  if (!element || element->kind == ElementRef::Kind::vertex ||
      (element->kind == ElementRef::Kind::edge && !edge_advice) || !state || !window.run.scene ||
      !window.run.journal || window.playing())
    return;
  AdviceQuestion q{
      state, window.run.journal, window.run.scene, window.sample_index(), window.run.parameters, *element};
  if (!advice_asked_ || !same_advice(*advice_asked_, q)) {
    advice_asked_ = q;
    advice_worker_.ask(std::move(q));
  }
  advice_ = answer_of(advice_worker_, advice_asked_, same_advice);
}

// One look at all points takes less than a frame.
void Investigation::update_point() {
  const Pick& picked = window.selection.picked;
  if (picked.kind != Pick::Kind::point || !window.run.scene) {
    point_.reset();
    point_scene_.reset();
    return;
  }
  if (point_scene_ == window.run.scene && point_id_ == picked.id) return;
  point_scene_ = window.run.scene;
  point_id_ = picked.id;
  const auto found = inspect_point(*point_scene_, point_id_);
  point_ = found ? std::make_shared<const PointInspection>(*found) : nullptr;
}

void Investigation::ask_check(bool search) {
  if (!window.state() || !window.run.journal) return;
  check_journal_ = window.run.journal;
  check_.ask({window.run.journal, window.state(), window.run.scene, search});
}

std::shared_ptr<const CheckAnswer> Investigation::check() const {
  const auto answered = check_.answered();
  return answered && answered->question.journal == check_journal_ ? answered->answer : nullptr;
}

const Investigation::VertexStar& Investigation::star_of(const std::shared_ptr<const StateSnapshot>& state,
                                                        VertexId vertex) {
  if (star_.state == state && star_.vertex == vertex) return star_;
  star_ = {state, vertex, 0, {}};
  const std::vector<Tet>& tets = state->complex.tets;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (std::find(tets[t].v.begin(), tets[t].v.end(), vertex) == tets[t].v.end()) continue;
    ++star_.degree;
    if (!star_.first) star_.first = TetId(t);
  }
  return star_;
}

bool Investigation::idle() const {
  return history_worker_.idle() && work_worker_.idle() && topology_worker_.idle() && advice_worker_.idle() &&
         check_.idle() && !jump_;
}

/// What the annotation depends on.
struct Investigation::AnnotationKey {
  std::shared_ptr<const void> state, index, history, work, topology, check, result, point;
  Pick picked;
  std::vector<Segment3> loop;
  std::optional<double> shrink;
  BottomTab tab = BottomTab::timeline;
  std::optional<std::uint32_t> event;
  std::size_t gate = 0;
  friend bool operator==(const AnnotationKey&, const AnnotationKey&) = default;
};

void Investigation::abandon() {
  history_worker_.abandon();
  work_worker_.abandon();
  topology_worker_.abandon();
  advice_worker_.abandon();
  check_.abandon();
}

Investigation::~Investigation() = default;

void Investigation::annotate() {
  AnnotationKey key{window.state(),
                    window.sample_index(),
                    history_,
                    work_,
                    topology_,
                    check(),
                    window.run.result,
                    point_,
                    window.selection.picked,
                    loop_shown,
                    shrink,
                    window.settings.panes.tab,
                    window.selected_event(),
                    window.place.level == DebugLevel::gate ? window.place.gate + 1 : 0};
  if (annotated_ && *annotated_ == key) return;
  annotated_ = std::make_unique<AnnotationKey>(std::move(key));
  Annotation made = make_annotation();
  annotation_ = made.empty() ? nullptr : std::make_shared<const Annotation>(std::move(made));
}

bool Investigation::update() {
  if (check_journal_ && check_journal_ != window.run.journal) check_.stop(), check_journal_.reset();
  update_history();
  jump();
  update_work();
  update_topology();
  update_advice();
  update_point();
  update_rim();
  annotate();
  return !idle();
}

} // namespace isoscope
