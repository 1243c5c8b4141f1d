// The worker behind Playhead: one mutex guards the mailbox, the playback belongs to the worker alone.
#include "model/playhead.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace isoscope {

struct Playhead::Impl {
  std::function<void()> notify;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  // Guarded by the mutex.
  std::optional<PlayheadRequest> wanted;
  std::optional<CriteriaParameters> wanted_preview;
  std::shared_ptr<const PlayheadResult> result;
  std::optional<Preview> preview;
  std::uint64_t epoch = 0; ///< grows with clear(): an answer begun before is dropped
  bool working = false, quit = false;
  // The worker's own.
  std::unique_ptr<Playback> playback;
  std::shared_ptr<const SampleIndex> index;
  std::shared_ptr<const StateSnapshot> last; ///< of the playback's journal: near steps are judged from it
  std::thread worker;

  void run();
  std::shared_ptr<const PlayheadResult> answer(const PlayheadRequest& request);
  const NearestSample* nearest_for(const std::shared_ptr<const BoundarySamples>& samples);
};

const NearestSample* Playhead::Impl::nearest_for(const std::shared_ptr<const BoundarySamples>& samples) {
  if (!samples) return nullptr;
  if (!index || index->set != samples) index = std::make_shared<const SampleIndex>(samples);
  return &index->nearest;
}

std::shared_ptr<const PlayheadResult> Playhead::Impl::answer(const PlayheadRequest& request) {
  if (!playback || &playback->journal() != request.journal.get()) {
    playback = std::make_unique<Playback>(request.journal);
    index.reset();
    last.reset();
  }
  request.journal->keep_within(request.history_limit / 2);
  const std::size_t journal_bytes = request.journal->memory_bytes();
  playback->set_keyframe_limit(request.history_limit > journal_bytes ? request.history_limit - journal_bytes
                                                                     : 0);
  const NearestSample* nearest = nullptr;
  if (request.options.orientation) {
    playback->seek(request.step);
    nearest = nearest_for(playback->samples());
  }
  SnapshotOptions options = request.options;
  options.orientation = options.orientation && nearest != nullptr;
  auto made = std::make_shared<PlayheadResult>();
  made->request = request;
  made->state = make_snapshot(*playback, request.step, options, nearest, last.get());
  last = made->state;
  made->keyframe_bytes = playback->keyframe_bytes();
  made->index = index;
  request.journal->release_read_back();
  return made;
}

void Playhead::Impl::run() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return quit || wanted || (wanted_preview && result); });
    if (quit) return;
    working = true;
    const std::uint64_t begun = epoch;
    if (wanted) {
      const PlayheadRequest request = *std::exchange(wanted, std::nullopt);
      lock.unlock();
      auto made = answer(request);
      lock.lock();
      if (begun == epoch) result = std::move(made);
    } else {
      const CriteriaParameters criteria = *std::exchange(wanted_preview, std::nullopt);
      const auto state = result->state;
      lock.unlock();
      const NearestSample* nearest = nearest_for(state->samples);
      const Preview made{criteria, preview_violations(*state, criteria, nearest)};
      lock.lock();
      if (begun == epoch) preview = made;
    }
    working = false;
    changed.notify_all();
    lock.unlock();
    if (notify) notify();
    lock.lock();
  }
}

Playhead::Playhead(std::function<void()> notify) : impl_(std::make_unique<Impl>()) {
  impl_->notify = std::move(notify);
  impl_->worker = std::thread([impl = impl_.get()] { impl->run(); });
}

Playhead::Playhead(Playhead&&) noexcept = default;

// The worker of the one that is replaced ends with the other.
Playhead& Playhead::operator=(Playhead&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}

Playhead::~Playhead() {
  if (!impl_) return;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->quit = true;
  }
  impl_->changed.notify_all();
  impl_->worker.join();
}

void Playhead::request(PlayheadRequest request) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->wanted = std::move(request);
  }
  impl_->changed.notify_all();
}

void Playhead::request_preview(const CriteriaParameters& criteria) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->wanted_preview = criteria;
  }
  impl_->changed.notify_all();
}

void Playhead::clear() {
  const std::lock_guard lock(impl_->mutex);
  impl_->wanted.reset();
  impl_->wanted_preview.reset();
  impl_->result.reset();
  impl_->preview.reset();
  ++impl_->epoch;
}

std::shared_ptr<const PlayheadResult> Playhead::result() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->result;
}

std::optional<Preview> Playhead::preview() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->preview;
}

bool Playhead::idle() const {
  const std::lock_guard lock(impl_->mutex);
  return !impl_->working && !impl_->wanted && !(impl_->wanted_preview && impl_->result);
}

void Playhead::wait() const {
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(
      lock, [&] { return !impl_->working && !impl_->wanted && !(impl_->wanted_preview && impl_->result); });
}

} // namespace isoscope
