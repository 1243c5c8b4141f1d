// What the play head's worker does: the playback belongs to it alone.
#include "model/playhead.h"

#include <utility>

namespace isoscope {

/// Keeps what one answer leaves for the next.
class Playhead::Answerer {
 public:
  std::shared_ptr<const Answer> answer(const Question& question);

 private:
  std::shared_ptr<const PlayheadResult> show(const PlayheadRequest& request);
  const NearestSample* nearest_for(const std::shared_ptr<const BoundarySamples>& samples);

  std::unique_ptr<Playback> playback_;
  std::shared_ptr<const SampleIndex> index_;
  std::shared_ptr<const StateSnapshot> last_; ///< of the playback's journal: near steps are judged from it
  std::shared_ptr<const PlayheadResult> result_;
  std::optional<Preview> preview_;
  std::uint64_t epoch_ = 0;
};

const NearestSample* Playhead::Answerer::nearest_for(const std::shared_ptr<const BoundarySamples>& samples) {
  if (!samples) return nullptr;
  if (!index_ || index_->set != samples) index_ = std::make_shared<const SampleIndex>(samples);
  return &index_->nearest;
}

std::shared_ptr<const PlayheadResult> Playhead::Answerer::show(const PlayheadRequest& request) {
  if (!playback_ || &playback_->journal() != request.journal.get()) {
    playback_ = std::make_unique<Playback>(request.journal);
    index_.reset();
    last_.reset();
  }
  request.journal->keep_within(request.history_limit / 2);
  const std::size_t journal_bytes = request.journal->memory_bytes();
  playback_->set_keyframe_limit(request.history_limit > journal_bytes ? request.history_limit - journal_bytes
                                                                      : 0);
  const NearestSample* nearest = nullptr;
  if (request.options.orientation) {
    playback_->seek(request.step);
    nearest = nearest_for(playback_->samples());
  }
  SnapshotOptions options = request.options;
  options.orientation = options.orientation && nearest != nullptr;
  auto made = std::make_shared<PlayheadResult>();
  made->request = request;
  made->state = make_snapshot(*playback_, request.step, options, nearest, last_.get());
  last_ = made->state;
  made->keyframe_bytes = playback_->keyframe_bytes();
  made->index = index_;
  request.journal->release_read_back();
  return made;
}

std::shared_ptr<const Playhead::Answer> Playhead::Answerer::answer(const Question& question) {
  if (std::exchange(epoch_, question.epoch) != question.epoch) {
    result_.reset();
    preview_.reset();
  }
  if (!result_ || !(result_->request == question.request)) result_ = show(question.request);
  if (question.preview)
    preview_ = Preview{*question.preview, result_->state,
                       std::make_shared<const ViolationPreview>(preview_violations(
                           *result_->state, *question.preview, nearest_for(result_->state->samples)))};
  return std::make_shared<const Answer>(Answer{result_, preview_});
}

Playhead::Playhead(std::function<void()> notify)
    : worker_(std::make_unique<PlayheadWorker>(
          [answerer = std::make_shared<Answerer>()](const Question& question, RunControl&) {
            return answerer->answer(question);
          },
          std::move(notify), Overtaken::finished)) {}

void Playhead::request(PlayheadRequest request) {
  asked_ = request;
  worker_->ask({std::move(request), {}, epoch_});
}

void Playhead::request_preview(const CriteriaParameters& criteria) {
  if (asked_) worker_->ask({*asked_, criteria, epoch_});
}

void Playhead::clear() {
  worker_->stop();
  asked_.reset();
  ++epoch_;
}

std::shared_ptr<const Playhead::Answer> Playhead::newest() const {
  const auto answered = worker_->answered();
  return answered && answered->question.epoch == epoch_ ? answered->answer : nullptr;
}

std::shared_ptr<const PlayheadResult> Playhead::result() const {
  const auto answer = newest();
  return answer ? answer->result : nullptr;
}

std::optional<Preview> Playhead::preview() const {
  const auto answer = newest();
  return answer ? answer->preview : std::nullopt;
}

} // namespace isoscope
