// How long a person waits for what the debugger answers: distributions over random places of one recorded
// run.
#pragma once

#include "base/quantiles.h"
#include "base/status.h"
#include "run/parameters.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace isoscope::bench {

/// Times of one kind of request: on the wall, which other programs stretch, and of all threads together.
class Distribution {
 public:
  enum class Clock { wall, processor };
  explicit Distribution(std::string what) : what_(std::move(what)) {}
  /// Does the work once and takes its times.
  void measure(const std::function<void()>& work);
  void add(double wall_seconds, double processor_seconds);
  const std::string& what() const { return what_; }
  std::size_t size() const { return seconds_[0].size(); }
  /// The smallest time, in seconds, that `part` of them do not exceed, part in (0, 1]; 0 when there is none.
  double quantile(Clock clock, double part) const {
    return seconds_[static_cast<std::size_t>(clock)].at(part);
  }

 private:
  std::string what_;
  std::array<Quantiles, 2> seconds_; ///< by clock
};

/// Runs a model to the end and records it. Fails as the run or its recording does.
Status record_run(const std::string& model, const Tolerance& tolerance, const std::filesystem::path& file);

/// What is measured of a recording.
struct LatencyOptions {
  std::size_t repeats = 100; ///< of what takes milliseconds; what takes longer is done less often
  std::uint64_t seed = 1;    ///< of the places
  std::size_t history_limit = std::size_t{2048} << 20; ///< of journal and keyframes together, bytes
};

/// Opens the recording and asks it everything, the way the window's workers do. Fails as opening does.
Result<std::vector<Distribution>> measure_latencies(const std::filesystem::path& recording,
                                                    const LatencyOptions& options);

/// One line each: what, how often, median, 95 % and the largest by both clocks, in milliseconds.
std::string table(const std::vector<Distribution>& rows);

} // namespace isoscope::bench
