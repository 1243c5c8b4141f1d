// A thread that answers questions of one kind: the newest question wins.
#pragma once

#include "base/run_control.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace isoscope {

/// What becomes of the question under way when a newer one is asked: its answer is not wanted any more, or it
/// is worth showing until the next is there. One that was not begun is replaced.
enum class Overtaken : std::uint8_t { cancelled, finished };

/// Methods are for one thread, the window's. Questions are cheap to copy and hold immutable things only.
template <class Question, class Answer> class Worker {
 public:
  using Work = std::function<std::shared_ptr<const Answer>(const Question&, RunControl&)>;

  /// `notify` is called from the worker whenever an answer is ready.
  Worker(Work work, std::function<void()> notify, Overtaken overtaken = Overtaken::cancelled)
      : work_(std::move(work)), notify_(std::move(notify)), overtaken_(overtaken) {}
  ~Worker() {
    abandon();
    if (thread_.joinable()) thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void ask(Question question) {
    {
      const std::lock_guard lock(mutex_);
      wanted_ = std::move(question);
      if (control_ && overtaken_ == Overtaken::cancelled) control_->abandon();
      if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    }
    changed_.notify_all();
  }
  /// Drops what is wanted, cancels what is under way; the answer stays.
  void stop() {
    const std::lock_guard lock(mutex_);
    wanted_.reset();
    if (control_) control_->abandon();
  }
  /// Begins its end, and waits for nothing.
  void abandon() {
    {
      const std::lock_guard lock(mutex_);
      quit_ = true;
      if (control_) control_->abandon();
    }
    changed_.notify_all();
  }
  /// The newest question that was answered and its answer; null before the first and after a cancelled one.
  struct Answered {
    Question question;
    std::shared_ptr<const Answer> answer;
  };
  std::shared_ptr<const Answered> answered() const {
    const std::lock_guard lock(mutex_);
    return answered_;
  }
  bool idle() const {
    const std::lock_guard lock(mutex_);
    return !wanted_ && !control_;
  }
  /// Blocks until idle; for tests.
  void wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !wanted_ && !control_; });
  }
  /// Of the question under way, in [0, 1]; negative when unknown.
  double fraction() const {
    const std::lock_guard lock(mutex_);
    return fraction_;
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return quit_ || wanted_; });
      if (quit_) return;
      const Question question = *std::exchange(wanted_, std::nullopt);
      const auto control = std::make_shared<RunControl>();
      control->on_progress([this](std::string_view, double fraction) {
        const std::lock_guard guard(mutex_);
        fraction_ = fraction;
      });
      control_ = control;
      fraction_ = -1;
      lock.unlock();
      auto answer = work_(question, *control);
      lock.lock();
      control_.reset();
      if (!control->cancelled())
        answered_ = std::make_shared<const Answered>(Answered{question, std::move(answer)});
      changed_.notify_all();
      lock.unlock();
      if (notify_) notify_();
      lock.lock();
    }
  }

  Work work_;
  std::function<void()> notify_;
  Overtaken overtaken_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  // Guarded by the mutex.
  std::optional<Question> wanted_;
  std::shared_ptr<RunControl> control_; ///< of the question under way
  std::shared_ptr<const Answered> answered_;
  double fraction_ = -1;
  bool quit_ = false;
  std::thread thread_; ///< begun with the first question
};

} // namespace isoscope
