// What the model does about a picked edge beyond its X-ray: chosen targets, unlocking, branches.
#include "app/app_model.h"

namespace isoscope {

std::shared_ptr<const UnlockSearch> unlocks_of(const ProbeRequest& request, RunControl& control) {
  const auto index = sample_index(request);
  auto search =
      search_unlocks(*request.state, request.question, xray_context(request, index.get()), [&](double done) {
        control.report("unlock", done);
        return !control.cancelled();
      });
  return search && search->complete ? std::make_shared<const UnlockSearch>(std::move(*search)) : nullptr;
}

std::shared_ptr<const TargetStudy> AppModel::study() const {
  const auto newest = probe.result();
  return newest && xray_asked_ && newest->request == *xray_asked_ && newest->request.state == state()
             ? newest->study
             : nullptr;
}

std::shared_ptr<const UnlockSearch> AppModel::unlock_search() const {
  const auto newest = unlocks.answered();
  return newest && xray_asked_ && newest->question.same_edge(*xray_asked_) ? newest->answer : nullptr;
}

Status AppModel::search_unlocks() {
  if (!xray() || !xray_asked_)
    return Error{ErrorCode::usage, "There is no X-ray.", "Select an edge of T first."};
  unlocks.ask(*xray_asked_);
  return {};
}

Status AppModel::branch_here() {
  const auto shown = xray();
  const auto tried = study();
  if (!shown || !tried)
    return Error{ErrorCode::usage, "No target is tried.", "Select an edge of T and choose a target first."};
  const Step step = state()->step - (shown->before ? 1 : 0);
  if (Status can = can_branch(*run.journal, step); !can) return can;
  if (!tried->attempt.possible())
    return Error{ErrorCode::usage,
                 "The edge cannot be collapsed there: " + std::string(name(tried->attempt.rejected)) + ".",
                 "Move the target until every check passes."};
  auto branch = std::make_unique<ShownRun>(notify_);
  branch->session.start_branch({run.journal, step, shown->star.a(), shown->star.b(), tried->target},
                               run.parameters, *run.scene, run.generation);
  // The branch becomes the active run; what it leaves is A.
  comparison.take(std::move(branch), false, comparison.beside());
  return change_run();
}

} // namespace isoscope
