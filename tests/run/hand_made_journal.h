// A journal of a whole run written by hand, so that every statistic is known.
#pragma once

#include "journal/journal.h"

#include <memory>

namespace isoscope::test {

/// Every stage, each with a few events (test_statistics.cpp tells their figures); Z leaves T in the last one.
std::shared_ptr<const Journal> hand_made_journal();

} // namespace isoscope::test
