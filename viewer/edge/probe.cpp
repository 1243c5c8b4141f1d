// The worker behind Probe: one mutex guards the mailbox.
#include "edge/probe.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace isoscope {

std::shared_ptr<const SampleIndex> sample_index(const ProbeRequest& request,
                                                std::shared_ptr<const SampleIndex> known) {
  const auto samples = request.state->samples;
  if (!samples) return nullptr;
  if (request.index && request.index->set == samples) return request.index;
  if (known && known->set == samples) return known;
  return std::make_shared<const SampleIndex>(samples);
}

XrayContext xray_context(const ProbeRequest& request, const SampleIndex* index) {
  return {*request.scene, *request.journal, request.parameters, index != nullptr ? &index->nearest : nullptr};
}

struct Probe::Impl {
  std::function<void()> notify;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  // Guarded by the mutex.
  std::optional<ProbeRequest> wanted;
  std::shared_ptr<const ProbeResult> result;
  bool working = false, quit = false;
  // The worker's own.
  std::shared_ptr<const SampleIndex> index;
  std::shared_ptr<const ProbeResult> last;
  std::thread worker;

  void run();
  std::shared_ptr<const ProbeResult> answer(ProbeRequest request);
};

std::shared_ptr<const ProbeResult> Probe::Impl::answer(ProbeRequest request) {
  if (auto own = sample_index(request, index)) index = std::move(own);
  const XrayContext context = xray_context(request, request.state->samples ? index.get() : nullptr);
  auto made = std::make_shared<ProbeResult>();
  // A target that is dragged leaves the edge as it is.
  if (last && last->request.same_edge(request)) {
    made->xray = last->xray;
  } else if (auto xray = edge_xray(*request.state, request.question, context)) {
    made->xray = std::make_shared<const EdgeXray>(std::move(*xray));
  }
  if (made->xray && request.target)
    made->study = std::make_shared<const TargetStudy>(study_target(*made->xray, *request.target, context));
  made->request = std::move(request);
  last = made;
  return made;
}

void Probe::Impl::run() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return quit || wanted; });
    if (quit) return;
    working = true;
    ProbeRequest request = *std::exchange(wanted, std::nullopt);
    lock.unlock();
    auto made = answer(std::move(request));
    lock.lock();
    result = std::move(made);
    working = false;
    changed.notify_all();
    lock.unlock();
    if (notify) notify();
    lock.lock();
  }
}

Probe::Probe(std::function<void()> notify) : impl_(std::make_unique<Impl>()) {
  impl_->notify = std::move(notify);
  impl_->worker = std::thread([this] { impl_->run(); });
}

Probe::~Probe() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->quit = true;
  }
  impl_->changed.notify_all();
  impl_->worker.join();
}

void Probe::request(ProbeRequest request) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->wanted = std::move(request);
  }
  impl_->changed.notify_all();
}

std::shared_ptr<const ProbeResult> Probe::result() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->result;
}

bool Probe::idle() const {
  const std::lock_guard lock(impl_->mutex);
  return !impl_->working && !impl_->wanted;
}

void Probe::wait() const {
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(lock, [&] { return !impl_->working && !impl_->wanted; });
}

} // namespace isoscope
