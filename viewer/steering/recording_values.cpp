// What scripts can expect of recordings.
#include "steering/steering.h"

namespace isoscope {

namespace {

std::string state_word(const WindowState& m) {
  if (!m.run.recording) return "none";
  const RecordingState& r = *m.run.recording;
  if (r.error) return "failed";
  if (r.cut_short) return "cut-short";
  if (!r.opened) return "writing";
  return m.run.phase == SessionPhase::following ? "following" : "opened";
}

} // namespace

void Steering::add_recording_values(NamedValues& t) {
  t.add("recording", "none, writing, opened, following, cut-short or failed",
        [this] { return state_word(window); });
  const auto of = t.readings(
      "recording.", [this] { return window.run.recording; }, "nan");
  of("events", "events written to it, or read from it", &RecordingState::events);
  of("bytes", "its size on the disk", &RecordingState::bytes);
}

} // namespace isoscope
