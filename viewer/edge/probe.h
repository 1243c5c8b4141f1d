// The picked edge under the X-ray: what its collapse would do, what a target that is tried would, and what
// would unlock it. Workers answer; the newest question wins.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "model/window_state.h"
#include "model/worker.h"
#include "questions/edge_xray.h"
#include "questions/target_study.h"
#include "questions/unlock_search.h"

#include <functional>
#include <memory>
#include <optional>

namespace isoscope {

/// What is asked; everything in it is immutable.
struct ProbeRequest {
  std::shared_ptr<const StateSnapshot> state;
  std::shared_ptr<const Journal> journal;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const SampleIndex> index; ///< of the state's samples, if there is one already
  RunParameters parameters;
  EdgeQuestion question;
  std::optional<Vec3> target; ///< to be studied beside
  /// The parameters belong to the journal.
  bool same_edge(const ProbeRequest& other) const {
    return state == other.state && journal == other.journal && question == other.question;
  }
  friend bool operator==(const ProbeRequest& a, const ProbeRequest& b) {
    return a.same_edge(b) && a.target == b.target;
  }
};

/// The newest answer; `xray` is null where the state has no such edge.
struct ProbeResult {
  ProbeRequest request;
  std::shared_ptr<const EdgeXray> xray;
  std::shared_ptr<const TargetStudy> study; ///< of the target, where one was asked about
};

/// Answers edge after edge; a target that is dragged leaves the edge as it is.
using ProbeWorker = Worker<ProbeRequest, ProbeResult>;
ProbeWorker::Work probe_work();

/// Methods are for one thread, the window's.
class EdgeProbe {
 public:
  /// `notify` is called from workers whenever an answer is ready.
  EdgeProbe(WindowState& shared, const std::function<void()>& notify);

  WindowState& window;

  /// Once a frame: asks about the picked edge at the state shown.
  void update();
  /// Of a run that is not shown any more.
  void forget() { asked_.reset(); }
  /// The X-ray of the picked edge at the state shown; null while it is made and where there is none.
  std::shared_ptr<const EdgeXray> xray() const;
  /// What the target that is tried would do; null while it is made and where none is.
  std::shared_ptr<const TargetStudy> study() const;
  /// Asks what unlocks the picked edge.
  Status search_unlocks();
  /// The answer at the state shown; null where nobody asked or it is not known yet.
  std::shared_ptr<const UnlockSearch> unlock_search() const;
  bool unlocking() const { return !unlocks_.idle(); }
  double unlock_fraction() const { return unlocks_.fraction(); }
  void stop_unlocking() { unlocks_.stop(); }

  bool looking() const { return !worker_.idle(); }
  bool idle() const { return worker_.idle() && unlocks_.idle(); }
  /// Begins the end of what is asked for long, and waits for nothing.
  void abandon() { unlocks_.abandon(); }

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);

 private:
  ProbeWorker worker_;
  Worker<ProbeRequest, UnlockSearch> unlocks_;
  std::optional<ProbeRequest> asked_;
};

} // namespace isoscope
