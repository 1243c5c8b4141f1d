// The lines that a bench prints: text for a terminal or Markdown for a note, each as soon as it is known.
#pragma once

#include "bench/cases.h"
#include "bench/measure.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace isoscope::bench {

/// One case with what came out of it.
struct Row {
  Case asked;
  Measured ours, lindstrom_turk;
  std::optional<Measured> envelope;    ///< Lindstrom–Turk under the envelope filter
  std::uint32_t seed = 0;              ///< of what ours was given
  std::optional<Measured> on_two = {}; ///< ours on two threads
  /// Our vertices over those of Lindstrom–Turk, where both results count.
  std::optional<double> ratio() const;
  /// Our CPU time over its, under the same conditions.
  std::optional<double> cpu_ratio() const;
  /// Our CPU time over that within the envelope, where both results count.
  std::optional<double> envelope_cpu_ratio() const;
  /// How many times faster the improver ends on two threads.
  std::optional<double> speed_up() const;
};

/// The middle value, or the mean of the two; of at least one.
double median(std::vector<double> values);

class Table {
 public:
  explicit Table(bool markdown) : markdown_(markdown) {}
  std::string head() const;
  std::string line(const Row& row) const;
  /// Sums over all rows with a ratio, the worst one, and how many rows of ours do not count.
  std::string summary(const std::vector<Row>& rows) const;

 private:
  std::string cells(const std::vector<std::string>& texts) const;
  bool markdown_;
};

} // namespace isoscope::bench
