// A bundled model refined and ready to be simplified, in one line.
#pragma once

#include "refine/bench.h"
#include "simplify/simplification.h"

#include <memory>
#include <string_view>

namespace isoscope::testing {

/// A refined gallery model with a simplification over it; its own gate and recorder.
struct Simplified {
  Simplified(std::string_view model, const BenchOptions& options, const SimplificationParameters& parameters);
  /// Runs to the end of the last stage; true when nothing stopped it.
  bool run();
  const Complex& complex() const { return simplification->complex(); }
  std::size_t events(EventKind kind) const;

  Bench bench;
  std::unique_ptr<Simplification> simplification;
};

/// Every facet of Z proven inside Ω, Z a closed oriented 2-manifold with the expected χ; T valid where there
/// is one.
void check_zero_set(const Simplified& s);

} // namespace isoscope::testing
