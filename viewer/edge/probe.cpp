// What the workers do, and when they are asked.
#include "edge/probe.h"

namespace isoscope {
namespace {

/// The index of the samples of a request's state: its own, the known one, or a new one; null without samples.
std::shared_ptr<const SampleIndex> index_of(const ProbeRequest& request,
                                            std::shared_ptr<const SampleIndex> known = nullptr) {
  const auto samples = request.state->samples;
  if (!samples) return nullptr;
  if (request.index && request.index->set == samples) return request.index;
  if (known && known->set == samples) return known;
  return std::make_shared<const SampleIndex>(samples);
}

/// What an answer depends on, for as long as request and index live.
XrayContext context_of(const ProbeRequest& request, const SampleIndex* index) {
  return {*request.scene, *request.journal, request.parameters, index != nullptr ? &index->nearest : nullptr};
}

/// What one answer leaves for the next.
struct Prober {
  std::shared_ptr<const SampleIndex> index;
  std::shared_ptr<const ProbeResult> last;

  std::shared_ptr<const ProbeResult> answer(const ProbeRequest& request) {
    if (auto own = index_of(request, index)) index = std::move(own);
    const XrayContext context = context_of(request, request.state->samples ? index.get() : nullptr);
    auto made = std::make_shared<ProbeResult>();
    if (last && last->request.same_edge(request)) {
      made->xray = last->xray;
    } else if (auto xray = edge_xray(*request.state, request.question, context)) {
      made->xray = std::make_shared<const EdgeXray>(std::move(*xray));
    }
    if (made->xray && request.target)
      made->study = std::make_shared<const TargetStudy>(study_target(*made->xray, *request.target, context));
    made->request = request;
    last = made;
    return made;
  }
};

/// Null when cancelled or where the state has no such edge.
std::shared_ptr<const UnlockSearch> unlocks_of(const ProbeRequest& request, RunControl& control) {
  const auto index = index_of(request);
  auto search = isoscope::search_unlocks(*request.state, request.question, context_of(request, index.get()),
                                         [&](double done) {
                                           control.report("unlock", done);
                                           return !control.cancelled();
                                         });
  return search && search->complete ? std::make_shared<const UnlockSearch>(std::move(*search)) : nullptr;
}

} // namespace

ProbeWorker::Work probe_work() {
  return [prober = std::make_shared<Prober>()](const ProbeRequest& request, RunControl&) {
    return prober->answer(request);
  };
}

EdgeProbe::EdgeProbe(WindowState& shared, const std::function<void()>& notify)
    : window(shared), worker_(probe_work(), notify, Overtaken::finished), unlocks_(unlocks_of, notify) {}

void EdgeProbe::update() {
  const Selection& selection = window.selection;
  if (selection.picked.kind != Pick::Kind::edge) asked_.reset();
  const auto shown = window.state();
  if (!shown || !window.run.journal || !window.run.scene || selection.picked.kind != Pick::Kind::edge) return;
  ProbeRequest wanted;
  wanted.state = shown;
  wanted.journal = window.run.journal;
  wanted.scene = window.run.scene;
  wanted.index = window.sample_index();
  wanted.parameters = window.run.parameters;
  wanted.question = {VertexId(selection.picked.id), VertexId(selection.picked.other), window.selected_event(),
                     selection.target};
  wanted.target = selection.what_if;
  if (const auto shown_xray = xray(); shown_xray && selection.hovered_candidate)
    if (const auto i = *selection.hovered_candidate; i < shown_xray->attempt.candidates.size())
      wanted.target = shown_xray->attempt.candidates[i].point;
  if (asked_ == wanted) return;
  asked_ = wanted;
  worker_.ask(std::move(wanted));
}

std::shared_ptr<const EdgeXray> EdgeProbe::xray() const {
  const auto newest = worker_.answered();
  return newest && asked_ && newest->question.same_edge(*asked_) && newest->question.state == window.state()
             ? newest->answer->xray
             : nullptr;
}

std::shared_ptr<const TargetStudy> EdgeProbe::study() const {
  const auto newest = worker_.answered();
  return newest && asked_ && newest->question == *asked_ && newest->question.state == window.state()
             ? newest->answer->study
             : nullptr;
}

std::shared_ptr<const UnlockSearch> EdgeProbe::unlock_search() const {
  const auto newest = unlocks_.answered();
  return newest && asked_ && newest->question.same_edge(*asked_) ? newest->answer : nullptr;
}

Status EdgeProbe::search_unlocks() {
  if (!xray() || !asked_) return Error{ErrorCode::usage, "There is no X-ray.", "Select an edge of T first."};
  unlocks_.ask(*asked_);
  window.bring_into_sight(AnswerKind::unlock);
  return {};
}

} // namespace isoscope
