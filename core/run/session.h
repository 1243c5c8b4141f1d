// A run on its own thread that others steer by commands and watch through the journal; no call waits for the
// run.
#pragma once

#include "run/pipeline.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace isoscope {

/// What the run's thread is doing.
enum class SessionPhase : std::uint8_t {
  idle,      ///< nothing was started
  preparing, ///< input, Ω, S
  running,
  paused,    ///< at a pause point, between two operations
  following, ///< a recording is read that another program is still writing
  finished,  ///< the goal was reached or the run was stopped; still there to go on with other parameters
  failed     ///< see error
};

/// The file that a run is recorded to or read from.
struct RecordingState {
  std::filesystem::path file;
  std::uint64_t bytes = 0;    ///< on the disk
  std::size_t events = 0;     ///< written, or read
  bool opened = false;        ///< read from the file: nothing computes, parameters cannot be changed
  bool cut_short = false;     ///< read to its end, which is not the run's
  std::optional<Error> error; ///< why it is written or read no further

  // Of a copy that is followed while it grows elsewhere.
  bool copied = false;
  std::optional<std::chrono::system_clock::time_point>
      written;               ///< when it last was; nothing while it is not there
  std::optional<Error> torn; ///< why no more of it can be read yet
};

/// A consistent picture of a session; cheap to take at every frame. All pointers are to immutable things,
/// except the journal, which is append-only and safe to read at any time.
struct SessionSnapshot {
  SessionPhase phase = SessionPhase::idle;
  std::uint64_t generation = 0;              ///< grows with each (re)start: a new journal
  RunParameters parameters;                  ///< as asked for, with later changes
  std::shared_ptr<const Journal> journal;    ///< null when idle
  std::shared_ptr<const TriangleSoup> input; ///< null until read; of a recording null
  std::shared_ptr<const Scene> scene; ///< null until prepared; see Pipeline::examined() where that failed
  std::shared_ptr<const RunResult> result; ///< null until finished
  std::optional<Error> error;
  std::string part;       ///< what is being prepared or certified: "sampling"
  double fraction = -1;   ///< of that part, negative unknown
  bool improving = false; ///< the improver goes on with further rounds, as go_on_improving() asked
  std::string pause_note; ///< why it paused: "step", a breakpoint's text
  std::optional<RecordingState> recording;
};

/// Decides after an event whether to pause; returns the note to show, empty to go on. Called on the run's
/// thread.
using Breakpoint = std::function<std::string(const Journal&, const Event&)>;

/// All methods may be called from one steering thread; each only posts a command.
class Session {
 public:
  Session();
  /// Abandons the run and waits for its end. Where that takes long, the recording is completed and closed
  /// first.
  ~Session();
  /// Tells the run that nobody wants it any more, and waits for nothing. Only its end may follow.
  void abandon();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Starts a run, cancelling the present one. `soup`, with the notes on reading it, overrides
  /// parameters.input when given. `paused`: stop before the first Steiner point.
  void start(RunParameters parameters, std::shared_ptr<const TriangleSoup> soup = nullptr,
             bool paused = false, std::vector<InputNote> notes = {});
  /// Starts a run that goes on from a step of another one; its journal holds what was before. The input is
  /// taken from `scene`; the generation is one more than `after`. Without a collapse it goes on with α, σ,
  /// shrink and conditions of `parameters`; the others must be those of the run that it leaves.
  void start_branch(const BranchPoint& branch, RunParameters parameters, const Scene& scene,
                    std::uint64_t after);
  void pause();
  void resume();
  /// Runs n operations, then pauses.
  void step(std::uint32_t n = 1);
  /// Runs until an event makes the breakpoint speak, then pauses.
  void run_until(Breakpoint breakpoint);
  /// Asks the running stage to stop cleanly; what is there is certified and kept.
  void stop();
  /// Changes α, σ, shrink or the conditions and goes on from the present state, also after the run had
  /// finished. A paused run takes them and stays paused. The other parameters need a start. Fails with
  /// unsupported, and changes nothing, where the samples of this σ would take more memory than they may.
  Status apply(const RunParameters& parameters);
  /// After the run has ended: goes on with further rounds of the improver until stop(). Fails with usage
  /// where that cannot be.
  Status go_on_improving();
  /// Stands for every run of this session, checked after each event; empty removes it.
  void set_breakpoint(Breakpoint breakpoint);

  /// Shows a recording instead of a run; follows it while another program writes it. Pausing and new
  /// parameters have no effect on it.
  void open_recording(const std::filesystem::path& file);
  /// The same of a copy that something brings from another machine, or of a file that lies there: nothing is
  /// locked or written, and a copy that is late, torn or not there yet is waited for.
  void follow_copy(const std::filesystem::path& file);
  /// Records the present run from its first event on, or once it is prepared; an earlier recording of it is
  /// closed. Fails with io or usage when the file cannot be made, and with usage on a recording.
  Status record(const std::filesystem::path& file);

  SessionSnapshot snapshot() const;
  /// Blocks until the run is paused, finished or failed, or the seconds are over; true when it is. For tests
  /// and scripts.
  bool wait_until_settled(double seconds) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
