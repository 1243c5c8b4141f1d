// The worker behind QueryWorker: one mutex guards the mailbox.
#include "app/query_worker.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace isoscope {

struct QueryWorker::Impl {
  std::function<void()> notify;
  mutable std::mutex mutex;
  std::condition_variable changed;
  // Guarded by the mutex.
  std::optional<QueryRequest> wanted;
  std::optional<QueryAnswer> answer;
  bool working = false, quit = false;
  RunControl control; ///< of the request being answered
  std::thread worker;

  void run();
};

void QueryWorker::Impl::run() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return quit || wanted; });
    if (quit) return;
    working = true;
    control.reset();
    QueryAnswer made{*std::exchange(wanted, std::nullopt), std::nullopt};
    lock.unlock();
    made.match = find(made.request.journal, made.request.search, control);
    lock.lock();
    if (!wanted && !quit) answer = std::move(made);
    working = false;
    lock.unlock();
    if (notify) notify();
    lock.lock();
  }
}

QueryWorker::QueryWorker(std::function<void()> notify) : impl_(std::make_unique<Impl>()) {
  impl_->notify = std::move(notify);
  impl_->worker = std::thread([this] { impl_->run(); });
}

QueryWorker::~QueryWorker() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->quit = true;
    impl_->control.cancel();
  }
  impl_->changed.notify_all();
  impl_->worker.join();
}

void QueryWorker::request(QueryRequest request) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->wanted = std::move(request);
    impl_->answer.reset();
    impl_->control.cancel();
  }
  impl_->changed.notify_all();
}

std::optional<QueryAnswer> QueryWorker::take() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->answer, std::nullopt);
}

bool QueryWorker::idle() const {
  const std::lock_guard lock(impl_->mutex);
  return !impl_->working && !impl_->wanted && !impl_->answer;
}

} // namespace isoscope
