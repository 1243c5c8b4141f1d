// Journals of random Delaunay insertions, for tests that need operations but no refinement.
#pragma once

#include "journal/recorder.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace isoscope::test {

/// A gate that lets everything pass and remembers what it saw.
class OpenGate : public Gate {
 public:
  Verdict pass(const Journal&, const Event& event) override {
    ++passed;
    last = event;
    return answer;
  }
  CriteriaParameters wanted_parameters() const override { return {}; }
  std::size_t passed = 0;
  Event last;
  Verdict answer = Verdict::go_on;
};

/// Points near the unit sphere with labels by side.
std::shared_ptr<const BoundarySamples> sphere_samples(std::size_t n, std::uint64_t seed);

/// Fills the journal: two sample sets, the corners of a box, `insertions` random points labelled by their
/// side of the unit sphere. Halfway α changes and the second sample set replaces the first. Every 50th
/// operation is followed by an exhausted event. `after_each` hears of every operation.
void record_insertions(Journal& journal, std::size_t insertions, std::size_t samples, std::uint64_t seed,
                       const std::function<void()>& after_each = {});

} // namespace isoscope::test
