// Asks workers what the panels show, and takes their answers.
#include "ask/investigation.h"

#include "app/app_model.h"
#include "model/words.h"
#include "journal/describe.h"
#include "journal/sample_history.h"
#include "scene/reason_style.h"

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

Investigation::Investigation(const std::function<void()>& notify)
    : history_worker_(read_history, notify), work_worker_(measure_work, notify),
      topology_worker_(judge_topology, notify), advice_worker_(advise, notify), check_(judge_state, notify) {}

std::optional<ElementRef> selected_element(const AppModel& model) {
  const Pick& p = model.selection.picked;
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
    return "stays: " + std::string(reason_style(row.reason).title);
  case HistoryRow::Kind::collapsed:
    return "collapsed: " + std::string(reason_style(row.reason).title);
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

void Investigation::update_history(AppModel& model) {
  const auto element = selected_element(model);
  const auto state = model.state();
  const bool wanted = jump_ || model.settings.panes.tab == history_tab;
  if (!element || !state || !model.run.journal || !wanted) {
    history_.reset();
    if (!element) history_asked_.reset(), jump_ = false;
    return;
  }
  const HistoryQuestion question{model.run.journal, *element, state,
                                 element->kind == ElementRef::Kind::sample &&
                                     model.settings.panes.tab != history_tab};
  // Read backwards from the state: it has to be the one from which one goes.
  if (question.last_only && state->step != model.transport.step()) return;
  // A journal that grew is read again when the run rests or the element is asked about anew.
  const bool stale = history_ && history_->steps != model.run.journal->steps() && (!model.running() || jump_);
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

void Investigation::jump(AppModel& model) {
  if (!jump_ || !history_) return;
  jump_ = false;
  const HistoryRow* row = history_->last_change(model.transport.step());
  if (row == nullptr) return model.tell("It did not change before this step.");
  model.transport.jump(row->step);
  model.tell("Step " + grouped(row->step) + ": it " + history_words(*row, history_->element.kind) + ".");
}

void Investigation::update_work(const AppModel& model) {
  work_.reset();
  if (model.settings.panes.tab != work_tab || !model.run.journal || !model.run.scene) return;
  // A live run is measured again at rests only: the answer would never catch up.
  const bool moving = model.running() || model.playing();
  if (!moving || !work_asked_ || work_asked_->journal != model.run.journal) {
    WorkQuestion q;
    q.journal = model.run.journal;
    const std::size_t events = model.index.events();
    const auto before = [&](Step step) {
      return step > model.live_step() ? events : std::min(events, model.index.first_event_at(step));
    };
    const auto& range = model.debug.range;
    q.begin = range ? before(range->begin) : 0;
    q.end = range ? before(range->end + 1) : events;
    // The attempts before the play head, within the range.
    const Step head = model.transport.step();
    q.stall_end = std::clamp(head >= model.live_step() ? events : before(head + 1), q.begin, q.end);
    q.kind = work_kind;
    q.attempts = stall_attempts;
    q.cell = cell_deltas * model.run.scene->delta;
    if (q.cell > 0 && (!work_asked_ || !same_work(*work_asked_, q))) {
      work_asked_ = q;
      work_worker_.ask(std::move(q));
    }
  }
  work_ = answer_of(work_worker_, work_asked_, same_work);
}

void Investigation::update_topology(const AppModel& model) {
  const auto state = model.state();
  topology_.reset();
  if (!topology_shown || !state || !model.run.scene) return;
  if (!model.playing() || !topology_asked_) {
    TopologyQuestion q{state, model.run.scene};
    if (!topology_asked_ || !same_topology(*topology_asked_, q)) {
      topology_asked_ = q;
      topology_worker_.ask(std::move(q));
    }
  }
  topology_ = answer_of(topology_worker_, topology_asked_, same_topology);
}

void Investigation::update_advice(const AppModel& model) {
  const auto element = selected_element(model);
  const auto state = model.state();
  advice_.reset();
  if (!element || element->kind == ElementRef::Kind::vertex ||
      (element->kind == ElementRef::Kind::edge && !edge_advice) || !state || !model.run.scene ||
      !model.run.journal || model.playing())
    return;
  AdviceQuestion q{state,   model.run.journal, model.run.scene, model.sample_index(), model.run.parameters,
                   *element};
  if (!advice_asked_ || !same_advice(*advice_asked_, q)) {
    advice_asked_ = q;
    advice_worker_.ask(std::move(q));
  }
  advice_ = answer_of(advice_worker_, advice_asked_, same_advice);
}

void Investigation::ask_check(const AppModel& model, bool search) {
  if (!model.state() || !model.run.journal) return;
  check_journal_ = model.run.journal;
  reveal_check = true;
  check_.ask({model.run.journal, model.state(), model.run.scene, search});
}

std::shared_ptr<const CheckAnswer> Investigation::check() const {
  const auto answered = check_.answered();
  return answered && answered->question.journal == check_journal_ ? answered->answer : nullptr;
}

bool Investigation::idle() const {
  return history_worker_.idle() && work_worker_.idle() && topology_worker_.idle() && advice_worker_.idle() &&
         check_.idle() && !jump_;
}

/// What the annotation depends on.
struct Investigation::AnnotationKey {
  std::shared_ptr<const void> state, index, history, work, topology, check, result;
  Pick picked;
  std::optional<double> shrink;
  int tab = 0;
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

void Investigation::annotate(const AppModel& model) {
  AnnotationKey key{model.state(),
                    model.sample_index(),
                    history_,
                    work_,
                    topology_,
                    check(),
                    model.run.result,
                    model.selection.picked,
                    shrink,
                    model.settings.panes.tab,
                    model.selected_event(),
                    model.debug.level == DebugLevel::gate ? model.debug.gate + 1 : 0};
  if (annotated_ && *annotated_ == key) return;
  annotated_ = std::make_unique<AnnotationKey>(std::move(key));
  Annotation made = make_annotation(model);
  annotation_ = made.empty() ? nullptr : std::make_shared<const Annotation>(std::move(made));
}

bool Investigation::update(AppModel& model) {
  if (check_journal_ && check_journal_ != model.run.journal) check_.stop(), check_journal_.reset();
  update_history(model);
  jump(model);
  update_work(model);
  update_topology(model);
  update_advice(model);
  annotate(model);
  return !idle();
}

} // namespace isoscope
