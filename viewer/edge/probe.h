// A worker that looks at one edge of the state shown: the newest question wins.
#pragma once

#include "model/playhead.h"
#include "questions/edge_xray.h"
#include "questions/target_study.h"

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

/// The index of the samples of a request's state: its own, the known one, or a new one; null without samples.
std::shared_ptr<const SampleIndex> sample_index(const ProbeRequest& request,
                                                std::shared_ptr<const SampleIndex> known = nullptr);
/// What an answer depends on, for as long as request and index live.
XrayContext xray_context(const ProbeRequest& request, const SampleIndex* index);

/// The newest answer; `xray` is null where the state has no such edge.
struct ProbeResult {
  ProbeRequest request;
  std::shared_ptr<const EdgeXray> xray;
  std::shared_ptr<const TargetStudy> study; ///< of the target, where one was asked about
};

/// Methods are for one thread, the window's; the work happens on the worker's.
class Probe {
 public:
  /// `notify` is called from the worker whenever an answer is ready.
  explicit Probe(std::function<void()> notify);
  ~Probe();
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  /// Replaces any question that was not begun yet.
  void request(ProbeRequest request);
  /// The newest answer, null before the first.
  std::shared_ptr<const ProbeResult> result() const;
  bool idle() const;
  /// Blocks until idle; for tests.
  void wait() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
