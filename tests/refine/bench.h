// A refinement set up from a soup in one line, with a gate that tests can script.
#pragma once

#include "refine/refinement.h"

#include "input/triangle_soup.h"

#include <functional>
#include <memory>
#include <string_view>

namespace isoscope::testing {

/// What to run; lengths relative to δ.
struct BenchOptions {
  double percent = 4;
  double sigma_ratio = 1;
  bool certified = true;
  TopologyMode topology = TopologyMode::keep;
  std::function<void(CriteriaParameters&)> adjust = [](CriteriaParameters&) {};
  RefinementLimits limits = {};
};

/// Goes on, unless a script says otherwise.
class ScriptedGate : public Gate {
 public:
  std::function<Verdict(const Journal&, const Event&)> script;
  CriteriaParameters wanted;

  Verdict pass(const Journal& journal, const Event& event) override {
    return script ? script(journal, event) : Verdict::go_on;
  }
  CriteriaParameters wanted_parameters() const override { return wanted; }
};

/// Ω, S, journal and refinement of one input.
class Bench {
 public:
  Bench(const TriangleSoup& soup, const BenchOptions& options);
  static Bench gallery(std::string_view model, const BenchOptions& options);

  RefinementOutcome run() { return refinement->run(); }
  const Complex& complex() const { return refinement->complex(); }
  /// The samples with ε above the limit, counted from scratch.
  std::size_t count_errors_above(double limit) const;
  std::size_t insertions(Condition condition) const;
  std::size_t exhausted(Condition condition) const;

  std::unique_ptr<RunControl> control = std::make_unique<RunControl>();
  std::unique_ptr<ScriptedGate> gate = std::make_unique<ScriptedGate>();
  std::shared_ptr<Journal> journal = std::make_shared<Journal>();
  std::unique_ptr<ToleranceVolume> volume;
  std::shared_ptr<const BoundarySamples> samples;
  ExpectedTopology expected;
  CriteriaParameters criteria;
  std::unique_ptr<Recorder> recorder;
  std::unique_ptr<Refinement> refinement;
};

/// Classified, contained, witnessed, with the expected topology; T valid and Delaunay; figures as counted
/// from scratch.
void check_all(Bench& bench, const RefinementOutcome& outcome);

} // namespace isoscope::testing
