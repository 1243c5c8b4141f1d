// The run's thread, its gate and its commands.
#include "run/session.h"

#include "base/parallel.h"
#include "recording/recording_writer.h"
#include "run/follow_copy.h"
#include "run/recorded_run.h"
#include "run/sample_memory.h"
#include "run/show_recording.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace isoscope {

namespace {

constexpr std::uint32_t unlimited = 0xffffffffu;
/// How long a run that is abandoned may take before its recording is closed without it.
constexpr std::chrono::milliseconds obedience{400};
/// Between two looks at a recording that grows.
constexpr std::chrono::milliseconds follow_interval{250};

std::shared_ptr<const Breakpoint> shared(Breakpoint breakpoint) {
  return breakpoint ? std::make_shared<const Breakpoint>(std::move(breakpoint)) : nullptr;
}

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
  RunParameters started; ///< what the run began with: what its recording must say
  std::shared_ptr<RecordingWriter> writer;
  CriteriaParameters wanted;
  bool parameters_pending = false;
  bool improving_pending = false; ///< the run that has ended is to go on
  bool stop_pending = false;
  bool quit = false;
  bool over = true; ///< nothing runs on the thread any more
  bool pause_pending = false;
  std::uint32_t steps_left = unlimited;              ///< operations until the next pause
  std::shared_ptr<const Breakpoint> standing, until; ///< shared, so that they can be asked without the lock

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
    std::string note = ask_breakpoints(journal, event);
    std::unique_lock lock(mutex);
    if (!note.empty()) until.reset();
    if (event.operation && steps_left != unlimited && steps_left > 0 && --steps_left == 0 && note.empty()) {
      note = "step";
    }
    if (pause_pending && note.empty()) note = "pause";
    if (!note.empty()) wait_paused(lock, note);
    const Verdict answer = verdict();
    update_attention();
    return answer;
  }

  /// What the first breakpoint that speaks says.
  std::string ask_breakpoints(const Journal& journal, const Event& event) const {
    std::array<std::shared_ptr<const Breakpoint>, 2> breakpoints;
    {
      const std::lock_guard lock(mutex);
      breakpoints = {standing, until};
    }
    for (const auto& breakpoint : breakpoints) {
      if (!breakpoint) continue;
      if (std::string note = (*breakpoint)(journal, event); !note.empty()) return note;
    }
    return {};
  }

  /// Holds the run's thread until somebody lets it go on.
  void wait_paused(std::unique_lock<std::mutex>& lock, const std::string& note) {
    pause_pending = true;
    steps_left = unlimited;
    shown.phase = SessionPhase::paused;
    shown.pause_note = note;
    changed.notify_all();
    changed.wait(lock, [this] { return !pause_pending || stop_pending || parameters_pending || quit; });
    if (stop_pending || quit) pause_pending = false;
    if (!pause_pending) show_running();
  }

  /// At once, not when the run's thread wakes: who waits for the next pause must not take the present one for
  /// it.
  void show_running() {
    if (shown.phase != SessionPhase::paused) return;
    shown.phase = SessionPhase::running;
    shown.pause_note.clear();
  }

  /// Lets a paused run go on for `steps` operations, or until the breakpoint speaks.
  void go_on(std::uint32_t steps, std::shared_ptr<const Breakpoint> breakpoint = nullptr) {
    {
      const std::lock_guard lock(mutex);
      if (breakpoint) until = std::move(breakpoint);
      pause_pending = false;
      steps_left = steps;
      show_running();
      update_attention();
    }
    changed.notify_all();
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

  void fail(Error error) {
    publish([&](SessionSnapshot& s) {
      s.error = std::move(error);
      s.phase = SessionPhase::failed;
    });
  }

  /// Starts the writer once the run is prepared, and tells it the end once there is one. Under the mutex.
  void serve_writer() {
    if (!writer || !shown.scene || (shown.phase == SessionPhase::failed && !writer->started())) return;
    if (!writer->started())
      writer->start(recording_header(started, shown.scene->input, shown.scene->notes), shown.journal);
    if (shown.phase == SessionPhase::finished && shown.result)
      writer->end([parameters = started, scene = shown.scene, result = shown.result,
                   journal = shown.journal] { return recording_end(parameters, *scene, *result, *journal); });
  }

  /// The whole life of the run's thread; nothing may escape from it.
  void work(const std::function<void()>& life) {
    try {
      life();
    } catch (const std::bad_alloc&) {
      fail({ErrorCode::internal, "Memory is exhausted.", "Take a larger tolerance or a larger σ."});
    } catch (const std::exception& e) {
      fail({ErrorCode::internal, std::string("The run failed: ") + e.what() + ".", ""});
    }
  }

  void run_pipeline(const RunParameters& parameters, std::shared_ptr<const TriangleSoup> soup,
                    std::vector<InputNote> notes, std::shared_ptr<Journal> journal,
                    const std::optional<BranchPoint>& branch) {
    const ThreadLimit threads(parameters.threads);
    // A branch's journal has its beginning already: what preparing says goes to one that nobody reads.
    const bool follows = branch && !branch->by_hand();
    Pipeline pipeline(follows ? parameters_at_start(parameters, *journal) : parameters,
                      branch ? std::make_shared<Journal>() : journal, *this, control);
    pipeline.on_read([this](std::shared_ptr<const TriangleSoup> read) {
      publish([&](SessionSnapshot& s) { s.input = std::move(read); });
    });
    auto prepared = pipeline.prepare(std::move(soup), std::move(notes));
    if (!prepared) {
      if (const auto examined = pipeline.examined()) publish([&](SessionSnapshot& s) { s.scene = examined; });
      return fail(prepared.error());
    }
    const std::shared_ptr<const Scene> scene = *prepared;
    publish([&](SessionSnapshot& s) {
      s.scene = scene;
      s.phase = SessionPhase::running;
      s.part.clear(); // of the preparation
      wanted = s.parameters.criteria(scene->delta, scene->default_sigma);
      if (follows) {
        parameters_pending = true; // heard once the step is reached
        update_attention();
      }
      serve_writer();
    });
    if (branch)
      if (Status begun = pipeline.branch(*branch, journal); !begun) return fail(begun.error());
    for (;;) {
      auto result = pipeline.run();
      if (!result) return fail(result.error());
      auto shared = std::make_shared<const RunResult>(std::move(*result));
      std::unique_lock lock(mutex);
      shown.result = shared;
      shown.phase = SessionPhase::finished;
      shown.improving = false;
      shown.part.clear();
      shown.fraction = -1;
      serve_writer();
      pause_pending = stop_pending = false;
      steps_left = unlimited;
      until.reset();
      update_attention();
      changed.notify_all();
      changed.wait(lock, [this] { return quit || parameters_pending || improving_pending; });
      if (quit) return;
      if (std::exchange(improving_pending, false))
        static_cast<void>(pipeline.go_on()); // the result said that it can
      parameters_pending = stop_pending = false;
      control.reset();
      update_attention();
      shown.phase = SessionPhase::running;
      shown.result.reset();
    }
  }

  void read_recording(const std::filesystem::path& file, bool copied,
                      const std::shared_ptr<Journal>& journal) {
    const RecordingAudience audience{
        [this](const std::function<void(SessionSnapshot&)>& edit) { publish(edit); },
        [this] {
          std::unique_lock lock(mutex);
          return !changed.wait_for(lock, follow_interval, [this] { return quit || stop_pending; });
        }};
    const auto show = copied ? isoscope::follow_copy : show_recording;
    if (Status read = show(file, journal, control, audience); !read) fail(read.error());
  }

  void open(const std::filesystem::path& file, bool copied) {
    auto journal = begin({}, true);
    {
      const std::lock_guard lock(mutex);
      shown.recording->file = file;
      shown.recording->copied = copied;
    }
    launch([this, file, copied, journal = std::move(journal)] { read_recording(file, copied, journal); });
  }

  /// Ends the present run and begins anew; `recorded`: what is shown is read from a file; the generation is
  /// one more than `after` at least.
  std::shared_ptr<Journal> begin(const RunParameters& parameters, bool recorded, std::uint64_t after = 0) {
    join();
    control.reset();
    control.on_progress([this](std::string_view part, double fraction) {
      const std::lock_guard lock(mutex);
      shown.part = part;
      shown.fraction = fraction;
    });
    auto journal = std::make_shared<Journal>();
    const std::lock_guard lock(mutex);
    const std::uint64_t generation = std::max(shown.generation, after) + 1;
    shown = {};
    shown.generation = generation;
    shown.phase = SessionPhase::preparing;
    shown.parameters = parameters;
    shown.journal = journal;
    if (recorded) shown.recording.emplace().opened = true;
    started = parameters;
    wanted = {};
    quit = stop_pending = parameters_pending = improving_pending = pause_pending = false;
    steps_left = unlimited;
    until.reset();
    return journal;
  }

  void launch(std::function<void()> life) {
    {
      const std::lock_guard lock(mutex);
      over = false;
      update_attention();
    }
    changed.notify_all();
    // An earlier recording may have much left to write: nobody but the new thread waits for it.
    thread = std::thread([this, life = std::move(life), last = std::exchange(writer, nullptr)]() mutable {
      last.reset();
      work(life);
      const std::lock_guard lock(mutex);
      over = true;
      changed.notify_all();
    });
  }

  void join() {
    abandon();
    if (thread.joinable()) thread.join();
  }

  /// The end of the session: a run that does not obey keeps nothing but its thread.
  void end() {
    abandon();
    std::shared_ptr<RecordingWriter> recording;
    {
      std::unique_lock lock(mutex);
      const bool obeyed = changed.wait_for(lock, obedience, [this] { return over; });
      if (!obeyed) recording = std::exchange(writer, nullptr);
    }
    recording.reset();
    if (thread.joinable()) thread.join();
  }

  void abandon() {
    {
      const std::lock_guard lock(mutex);
      quit = true;
      pause_pending = false;
      update_attention();
    }
    control.abandon();
    changed.notify_all();
  }
};

Session::Session() : impl_(std::make_unique<Impl>()) {}

Session::~Session() {
  if (impl_) impl_->end();
}

void Session::abandon() {
  impl_->abandon();
}

Session::Session(Session&&) noexcept = default;

// The run of the one that is replaced ends with the other.
Session& Session::operator=(Session&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}

void Session::start(RunParameters parameters, std::shared_ptr<const TriangleSoup> soup, bool paused,
                    std::vector<InputNote> notes) {
  Impl& m = *impl_;
  auto journal = m.begin(parameters, false);
  if (paused) {
    const std::lock_guard lock(m.mutex);
    m.steps_left = 1; // the first operation puts the box there
  }
  m.launch(
      [&m, parameters = std::move(parameters), soup = std::move(soup), notes = std::move(notes),
       journal = std::move(journal)] { m.run_pipeline(parameters, soup, notes, journal, std::nullopt); });
}

void Session::start_branch(const BranchPoint& branch, RunParameters parameters, const Scene& scene,
                           std::uint64_t after) {
  Impl& m = *impl_;
  auto journal = m.begin(parameters, false, after);
  journal->take_prefix(*branch.from, branch.step, common_events(branch));
  m.launch([&m, branch, parameters = std::move(parameters), soup = scene.input, notes = scene.notes,
            journal = std::move(journal)] { m.run_pipeline(parameters, soup, notes, journal, branch); });
}

void Session::open_recording(const std::filesystem::path& file) {
  impl_->open(file, false);
}

void Session::follow_copy(const std::filesystem::path& file) {
  impl_->open(file, true);
}

Status Session::record(const std::filesystem::path& file) {
  Impl& m = *impl_;
  std::shared_ptr<RecordingWriter> last;
  {
    const std::lock_guard lock(m.mutex);
    if (m.shown.recording && m.shown.recording->opened)
      return Error{ErrorCode::usage, "What is shown is a recording itself.", "Copy its file."};
    if (m.shown.phase == SessionPhase::idle || m.shown.phase == SessionPhase::failed)
      return Error{ErrorCode::usage, "There is no run to record.", "Open a model first."};
  }
  auto created = RecordingWriter::create(file);
  if (!created) return created.error();
  {
    const std::lock_guard lock(m.mutex);
    last = std::exchange(m.writer, std::shared_ptr<RecordingWriter>(std::move(*created)));
    m.serve_writer();
  }
  return {};
}

void Session::pause() {
  const std::lock_guard lock(impl_->mutex);
  impl_->pause_pending = true;
  impl_->update_attention();
}

void Session::resume() {
  impl_->go_on(unlimited);
}

void Session::step(std::uint32_t n) {
  if (n > 0) impl_->go_on(n);
}

void Session::run_until(Breakpoint breakpoint) {
  impl_->go_on(unlimited, shared(std::move(breakpoint)));
}

void Session::stop() {
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->shown.phase == SessionPhase::finished || impl_->shown.phase == SessionPhase::failed) return;
    impl_->stop_pending = true;
    impl_->show_running();
    impl_->update_attention();
  }
  impl_->control.cancel();
  impl_->changed.notify_all();
}

Status Session::apply(const RunParameters& parameters) {
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->shown.recording && impl_->shown.recording->opened) return {};
    if (const auto& scene = impl_->shown.scene) {
      const CriteriaParameters wanted = parameters.criteria(scene->delta, scene->default_sigma);
      const double most = parameters.most_bytes();
      if (Status fits = check_memory(scene->sample_estimate, wanted.sigma, scene->delta, most); !fits)
        return fits;
      impl_->wanted = wanted;
    }
    impl_->shown.parameters = parameters;
    impl_->parameters_pending = true;
    if (impl_->shown.phase == SessionPhase::finished) impl_->shown.phase = SessionPhase::running;
    impl_->update_attention();
  }
  impl_->changed.notify_all();
  return {};
}

Status Session::go_on_improving() {
  {
    const std::lock_guard lock(impl_->mutex);
    const SessionSnapshot& shown = impl_->shown;
    if (shown.phase != SessionPhase::finished || !shown.result || !shown.result->can_go_on)
      return Error{ErrorCode::usage, "There is nothing to go on improving.",
                   "It takes a run that has come to its end in the improver, without holes that are filled."};
    impl_->improving_pending = impl_->shown.improving = true;
    impl_->shown.phase = SessionPhase::running;
    impl_->update_attention();
  }
  impl_->changed.notify_all();
  return {};
}

void Session::set_breakpoint(Breakpoint breakpoint) {
  const std::lock_guard lock(impl_->mutex);
  impl_->standing = shared(std::move(breakpoint));
  impl_->update_attention();
}

SessionSnapshot Session::snapshot() const {
  const std::lock_guard lock(impl_->mutex);
  SessionSnapshot snapshot = impl_->shown;
  if (impl_->writer) {
    const RecordingProgress progress = impl_->writer->progress();
    RecordingState& state = snapshot.recording.emplace();
    state.file = progress.file;
    state.bytes = progress.bytes;
    state.events = progress.events;
    state.error = progress.error;
  }
  return snapshot;
}

bool Session::wait_until_settled(double seconds) const {
  std::unique_lock lock(impl_->mutex);
  return impl_->changed.wait_for(lock, std::chrono::duration<double>(seconds), [this] {
    const SessionPhase phase = impl_->shown.phase;
    return phase == SessionPhase::paused || phase == SessionPhase::finished || phase == SessionPhase::failed;
  });
}

} // namespace isoscope
