// Words for the status bar.
#include "steering/copy_words.h"

#include "model/words.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace isoscope {

std::optional<double> age_of(const RecordingState& recording) {
  if (!recording.written) return std::nullopt;
  const std::chrono::duration<double> age = std::chrono::system_clock::now() - *recording.written;
  return std::max(age.count(), 0.0);
}

std::string age_text(double seconds) {
  constexpr double minute = 60, hour = 60 * minute, day = 24 * hour;
  const auto whole = [](double n) { return std::to_string(static_cast<long>(std::floor(n))); };
  if (seconds < 2 * minute) return whole(seconds) + " s";
  if (seconds < 2 * hour) return whole(seconds / minute) + " min";
  return seconds < 2 * day ? whole(seconds / hour) + " h" : whole(seconds / day) + " days";
}

std::string copy_text(const RecordingState& recording, SessionPhase phase) {
  const std::string name = recording.file.filename().string();
  const auto age = age_of(recording);
  if (!age) return "waits for " + name;
  const bool under_way = phase == SessionPhase::preparing || phase == SessionPhase::following;
  const std::string text = (recording.error ? "stopped "
                            : under_way     ? "follows "
                                            : "has followed ") +
                           name + " " + bytes_text(recording.bytes);
  if (!under_way) return text;
  return text + ", " + age_text(*age) + " old" + (recording.torn ? ", the rest on its way" : "");
}

} // namespace isoscope
