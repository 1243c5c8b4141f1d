// One mutex guards the mailbox; what is under way hears of the end through an atomic.
#include "app/unlock_worker.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace isoscope {

struct UnlockWorker::Impl {
  std::function<void()> notify;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  // Guarded by the mutex.
  std::optional<ProbeRequest> wanted;
  std::shared_ptr<const UnlockResult> result;
  bool working = false, quit = false;
  std::atomic<bool> ended{false}; ///< what is under way is no longer wanted
  std::atomic<double> fraction{0};
  std::thread worker;

  std::shared_ptr<const UnlockResult> answer(ProbeRequest request) {
    const auto samples = request.state->samples;
    std::shared_ptr<const SampleIndex> index = request.index;
    if (samples && (!index || index->set != samples)) index = std::make_shared<const SampleIndex>(samples);
    const XrayContext context{*request.scene, *request.journal, request.parameters,
                              samples ? &index->nearest : nullptr};
    auto search = search_unlocks(*request.state, request.question, context, [this](double done) {
      fraction = done;
      if (notify) notify();
      return !ended;
    });
    auto made = std::make_shared<UnlockResult>();
    made->request = std::move(request);
    if (search && search->complete) made->search = std::make_shared<const UnlockSearch>(std::move(*search));
    return made;
  }

  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return quit || wanted; });
      if (quit) return;
      working = true;
      ended = false;
      fraction = 0;
      ProbeRequest request = *std::exchange(wanted, std::nullopt);
      lock.unlock();
      auto made = answer(std::move(request));
      lock.lock();
      if (!ended) result = std::move(made);
      working = false;
      lock.unlock();
      if (notify) notify();
      lock.lock();
    }
  }

  void replace(std::optional<ProbeRequest> next, bool end) {
    {
      const std::lock_guard lock(mutex);
      wanted = std::move(next);
      quit = quit || end;
      ended = true;
    }
    changed.notify_all();
  }
};

UnlockWorker::UnlockWorker(std::function<void()> notify) : impl_(std::make_unique<Impl>()) {
  impl_->notify = std::move(notify);
  impl_->worker = std::thread([this] { impl_->run(); });
}

UnlockWorker::~UnlockWorker() {
  impl_->replace(std::nullopt, true);
  impl_->worker.join();
}

void UnlockWorker::request(ProbeRequest request) {
  impl_->replace(std::move(request), false);
}

void UnlockWorker::cancel() {
  impl_->replace(std::nullopt, false);
}

std::shared_ptr<const UnlockResult> UnlockWorker::result() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->result;
}

bool UnlockWorker::idle() const {
  const std::lock_guard lock(impl_->mutex);
  return !impl_->working && !impl_->wanted;
}

double UnlockWorker::fraction() const {
  return impl_->fraction;
}

} // namespace isoscope
