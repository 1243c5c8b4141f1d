// A whole run of the pipeline without a session, for tests.
#pragma once

#include "run/pipeline.h"

#include <functional>
#include <memory>
#include <string>

namespace isoscope::test {

/// Hands out what a test wants handed out.
class TestGate : public Gate {
 public:
  Verdict pass(const Journal& journal, const Event& event) override {
    return decide ? decide(journal, event) : Verdict::go_on;
  }
  CriteriaParameters wanted_parameters() const override { return wanted; }
  std::function<Verdict(const Journal&, const Event&)> decide;
  CriteriaParameters wanted;
};

/// Everything a run leaves behind; keeps the pipeline so that a test can go on.
struct CompleteRun {
  RunParameters parameters;
  std::shared_ptr<const TriangleSoup> soup; ///< instead of parameters.input, where set
  std::vector<InputNote> notes = {};        ///< on reading it
  std::shared_ptr<Journal> journal = std::make_shared<Journal>();
  TestGate gate;
  RunControl control;
  std::unique_ptr<Pipeline> pipeline;
  std::shared_ptr<const Scene> scene;
  std::optional<RunResult> result;
  std::optional<Error> error;

  explicit CompleteRun(RunParameters p) : parameters(std::move(p)) {}
  /// On a soup, with an absolute δ.
  CompleteRun(TriangleSoup input, double delta);
  /// Ω and S; false, with `error` set, when that failed.
  bool prepare();
  /// From where it is to the end, prepared before when it was not.
  bool run();
};

/// A bundled model with its own tolerance, refined and no further.
RunParameters gallery_parameters(const std::string& name);
/// The same to the end of the last stage.
RunParameters complete_parameters(const std::string& name);
/// The complex made by all operations from nothing.
Complex replayed(const Journal& journal);

} // namespace isoscope::test
