// The second run's frame, and when the two are compared anew.
#include "two_runs/comparison.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

constexpr double regrowth = 1.25; ///< a pair of growing journals is compared again once it is so much longer

std::shared_ptr<const RunComparison> compare(const CompareQuestion& q, RunControl& control) {
  return std::make_shared<const RunComparison>(compare_runs(q.a, *q.journal_a, q.b, *q.journal_b, control));
}

bool same_pair(const CompareQuestion& x, const CompareQuestion& y) {
  return x.journal_a == y.journal_a && x.journal_b == y.journal_b;
}

} // namespace

Comparison::Comparison(Debugger& debugger, std::function<void()> notify, std::function<void()> changed)
    : window(debugger.window), debug(debugger), notify_(std::move(notify)), changed_(std::move(changed)),
      worker_(compare, notify_) {}

void Comparison::set_beside(bool beside) {
  beside_ = beside;
  linked_.reset();
}

void Comparison::take(std::unique_ptr<ShownRun> other, bool active_is_b, bool beside) {
  drop();
  other_ = std::move(other);
  active_is_b_ = active_is_b;
  beside_ = beside;
}

void Comparison::drop() {
  worker_.stop();
  if (other_)
    ending_ =
        std::async(std::launch::async,
                   [ending = std::shared_ptr<ShownRun>(std::move(other_))]() mutable { ending.reset(); });
  asked_.reset();
  linked_.reset();
  picked = {};
  row.reset();
  beside_ = active_is_b_ = false;
  error_seen_.clear();
}

void Comparison::exchange() {
  std::swap<ShownRun>(window, *other_);
  ++exchanges_;
  active_is_b_ = !active_is_b_;
  picked = {};
  if (!linked_cameras) std::swap(window.camera, camera);
  keep_steps();
}

CompareQuestion Comparison::question() const {
  const ShownRun &active = window, &a = active_is_b_ ? *other_ : active, &b = active_is_b_ ? active : *other_;
  return {a.run.parameters, b.run.parameters, a.run.journal, b.run.journal,
          a.run.journal->events().size() + b.run.journal->events().size()};
}

bool Comparison::ask() {
  if (!window.run.scene || !other_->run.scene || !window.run.journal || !other_->run.journal) return false;
  CompareQuestion now = question();
  const bool same = asked_ && same_pair(*asked_, now);
  if (same && (now.events == asked_->events || !worker_.idle())) return false;
  const bool resting = !window.running() && !other_->running();
  if (same && !resting && static_cast<double>(now.events) < regrowth * static_cast<double>(asked_->events))
    return false;
  if (!same) row.reset();
  asked_ = now;
  worker_.ask(std::move(now));
  return true;
}

std::shared_ptr<const RunComparison> Comparison::found() const {
  // Another run may have been opened in the place of one of the two.
  if (!asked_ || !other_ || !window.run.journal || !other_->run.journal || !same_pair(*asked_, question()))
    return nullptr;
  const auto answered = worker_.answered();
  return answered && same_pair(answered->question, *asked_) ? answered->answer : nullptr;
}

void Comparison::keep_steps() {
  linked_ = Linked{window.transport.step(), found()};
}

void Comparison::link(double seconds) {
  const auto newest = found();
  if (!linked_steps || !newest) {
    other_->transport.set_immediate(window.scripted);
    other_->transport.update(seconds, other_->live_step(), other_->growing());
    return;
  }
  Linked wanted{window.transport.step(), newest};
  if (linked_ == wanted) return;
  const RunAlignment& alignment = newest->alignment;
  other_->transport.jump(active_is_b_ ? alignment.to_a(wanted.step) : alignment.to_b(wanted.step));
  linked_ = std::move(wanted);
  picked = {};
}

bool Comparison::update(double seconds) {
  window.other_state = nullptr;
  if (!other_) return false;
  ShownRun& o = *other_;
  if (o.take_snapshot()) picked = {};
  if (o.run.error && o.run.error->message != error_seen_) {
    error_seen_ = o.run.error->message;
    window.report(*o.run.error);
  }
  bool changed = o.index.update() || ask();
  if (drawn()) {
    const Step before = o.transport.step();
    link(std::min(seconds, 0.1));
    o.request_state(window.view.tets.recent, history_share(), window.transport.moving());
    changed |= before != o.transport.step();
  }
  changed |= o.take_result();
  window.other_state = o.state();
  return changed || running() || !worker_.idle();
}

bool Comparison::at_rest() const {
  return !drawn() || other_->running() || (other_->result_taken() && worker_.idle());
}

bool Comparison::is_current() const {
  if (!drawn()) return true;
  if (other_->running() || !worker_.idle()) return false;
  if (other_->run.phase == SessionPhase::failed) return true;
  if (!other_->is_current()) return false;
  return !window.run.scene || (asked_ && asked_->events == question().events);
}

HistoryMemory Comparison::history_memory() const {
  HistoryMemory h;
  h.limit = static_cast<std::size_t>(window.settings.history_limit * 1048576.0);
  for (const ShownRun* each : {static_cast<const ShownRun*>(&window), other()}) {
    if (each == nullptr) continue;
    h.journal += each->run.journal ? each->run.journal->memory_bytes() : 0;
    h.keyframes += each->keyframe_bytes();
    h.disk += each->run.journal ? each->run.journal->disk_bytes() : 0;
  }
  return h;
}

std::size_t Comparison::history_share() const {
  return history_memory().limit / (other() ? 2 : 1);
}

} // namespace isoscope
