// The run's thread, its gate and its commands.
#include "run/session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace isoscope {

namespace {

constexpr std::uint32_t unlimited = 0xffffffffu;

} // namespace

/// The steering thread writes wishes under the mutex; the run's thread reads them at its gate only when
/// `attention` says so, so that a run nobody steers pays one atomic load an event.
struct Session::Impl : public Gate {
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::thread thread;
  RunControl control;

  // Under the mutex.
  SessionSnapshot shown;
  CriteriaParameters wanted;
  bool parameters_pending = false;
  bool stop_pending = false;
  bool quit = false;
  bool pause_pending = false;
  std::uint32_t steps_left = unlimited; ///< operations until the next pause
  Breakpoint standing, until;

  std::atomic<bool> attention{false};

  ~Impl() override = default;

  void publish(const std::function<void(SessionSnapshot&)>& edit) {
    {
      const std::lock_guard lock(mutex);
      edit(shown);
    }
    changed.notify_all();
  }

  Verdict pass(const Journal& journal, const Event& event) override {
    if (!attention.load(std::memory_order_acquire)) return Verdict::go_on;
    std::unique_lock lock(mutex);
    std::string note;
    for (const Breakpoint* breakpoint : {&standing, &until}) {
      if (*breakpoint && note.empty()) note = (*breakpoint)(journal, event);
    }
    if (!note.empty()) until = {};
    if (event.operation && steps_left != unlimited && steps_left > 0 && --steps_left == 0) note = "step";
    if (pause_pending && note.empty()) note = "pause";
    if (!note.empty()) wait_paused(lock, note);
    return verdict();
  }

  /// Holds the run's thread until somebody lets it go on.
  void wait_paused(std::unique_lock<std::mutex>& lock, const std::string& note) {
    pause_pending = true;
    shown.phase = SessionPhase::paused;
    shown.pause_note = note;
    changed.notify_all();
    changed.wait(lock, [this] { return !pause_pending || stop_pending || parameters_pending || quit; });
    if (stop_pending || quit) pause_pending = false;
    if (!pause_pending) {
      shown.phase = SessionPhase::running;
      shown.pause_note.clear();
    }
    update_attention();
  }

  Verdict verdict() {
    if (stop_pending || quit) {
      stop_pending = false;
      return Verdict::stop;
    }
    if (parameters_pending) {
      parameters_pending = false;
      return Verdict::parameters_changed;
    }
    return Verdict::go_on;
  }

  void update_attention() {
    attention.store(pause_pending || stop_pending || parameters_pending || quit || steps_left != unlimited ||
                        standing || until,
                    std::memory_order_release);
  }

  CriteriaParameters wanted_parameters() const override {
    const std::lock_guard lock(mutex);
    return wanted;
  }

  void work(RunParameters parameters, std::shared_ptr<const TriangleSoup> soup,
            std::shared_ptr<Journal> journal) {
    Pipeline pipeline(parameters, std::move(journal), *this, control);
    auto prepared = pipeline.prepare(std::move(soup));
    if (!prepared) {
      publish([&](SessionSnapshot& s) {
        s.error = prepared.error();
        s.phase = SessionPhase::failed;
      });
      return;
    }
    const std::shared_ptr<const Scene> scene = *prepared;
    publish([&](SessionSnapshot& s) {
      s.scene = scene;
      s.phase = SessionPhase::running;
      wanted = s.parameters.criteria(scene->delta);
    });
    for (;;) {
      auto result = pipeline.run();
      if (!result) {
        publish([&](SessionSnapshot& s) {
          s.error = result.error();
          s.phase = SessionPhase::failed;
        });
        return;
      }
      auto shared = std::make_shared<const RunResult>(std::move(*result));
      std::unique_lock lock(mutex);
      shown.result = shared;
      shown.phase = SessionPhase::finished;
      shown.part.clear();
      changed.notify_all();
      changed.wait(lock, [this] { return quit || parameters_pending; });
      if (quit) return;
      parameters_pending = false;
      stop_pending = false;
      control.reset();
      update_attention();
      shown.phase = SessionPhase::running;
      shown.result.reset();
    }
  }

  void join() {
    {
      const std::lock_guard lock(mutex);
      quit = true;
      pause_pending = false;
      update_attention();
    }
    control.cancel();
    changed.notify_all();
    if (thread.joinable()) thread.join();
  }
};

Session::Session() : impl_(std::make_unique<Impl>()) {}

Session::~Session() {
  impl_->join();
}

void Session::start(RunParameters parameters, std::shared_ptr<const TriangleSoup> soup, bool paused) {
  Impl& m = *impl_;
  m.join();
  m.control.reset();
  m.control.on_progress([&m](std::string_view part, double fraction) {
    const std::lock_guard lock(m.mutex);
    m.shown.part = part;
    m.shown.fraction = fraction;
  });
  auto journal = std::make_shared<Journal>();
  {
    const std::lock_guard lock(m.mutex);
    const std::uint64_t generation = m.shown.generation + 1;
    m.shown = {};
    m.shown.generation = generation;
    m.shown.phase = SessionPhase::preparing;
    m.shown.parameters = parameters;
    m.shown.journal = journal;
    m.wanted = {};
    m.quit = m.stop_pending = m.parameters_pending = false;
    m.pause_pending = paused;
    m.steps_left = unlimited;
    m.until = {};
    m.update_attention();
  }
  m.changed.notify_all();
  m.thread = std::thread([&m, parameters = std::move(parameters), soup = std::move(soup),
                          journal = std::move(journal)]() mutable {
    m.work(std::move(parameters), std::move(soup), std::move(journal));
  });
}

void Session::pause() {
  const std::lock_guard lock(impl_->mutex);
  impl_->pause_pending = true;
  impl_->update_attention();
}

void Session::resume() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->pause_pending = false;
    impl_->steps_left = unlimited;
    impl_->update_attention();
  }
  impl_->changed.notify_all();
}

void Session::step(std::uint32_t n) {
  if (n == 0) return;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->pause_pending = false;
    impl_->steps_left = n;
    impl_->update_attention();
  }
  impl_->changed.notify_all();
}

void Session::run_until(Breakpoint breakpoint) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->until = std::move(breakpoint);
    impl_->pause_pending = false;
    impl_->steps_left = unlimited;
    impl_->update_attention();
  }
  impl_->changed.notify_all();
}

void Session::stop() {
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->shown.phase == SessionPhase::finished || impl_->shown.phase == SessionPhase::failed) return;
    impl_->stop_pending = true;
    impl_->update_attention();
  }
  impl_->control.cancel();
  impl_->changed.notify_all();
}

void Session::apply(const RunParameters& parameters) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->shown.parameters = parameters;
    if (impl_->shown.scene) impl_->wanted = parameters.criteria(impl_->shown.scene->delta);
    impl_->parameters_pending = true;
    impl_->update_attention();
  }
  impl_->changed.notify_all();
}

void Session::set_breakpoint(Breakpoint breakpoint) {
  const std::lock_guard lock(impl_->mutex);
  impl_->standing = std::move(breakpoint);
  impl_->update_attention();
}

SessionSnapshot Session::snapshot() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->shown;
}

bool Session::wait_until_settled(double seconds) const {
  std::unique_lock lock(impl_->mutex);
  return impl_->changed.wait_for(lock, std::chrono::duration<double>(seconds), [this] {
    const SessionPhase phase = impl_->shown.phase;
    return phase == SessionPhase::paused || phase == SessionPhase::finished || phase == SessionPhase::failed;
  });
}

} // namespace isoscope
