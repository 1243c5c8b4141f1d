// The gate of a run that nobody steers.
#pragma once

#include "journal/recorder.h"

namespace isoscope {

/// Lets everything pass; wants nothing else than what the run began with, which may be left out.
class PassingGate : public Gate {
 public:
  explicit PassingGate(const CriteriaParameters& wanted = {}) : wanted_(wanted) {}
  Verdict pass(const Journal&, const Event&) override { return Verdict::go_on; }
  CriteriaParameters wanted_parameters() const override { return wanted_; }

 private:
  CriteriaParameters wanted_;
};

} // namespace isoscope
