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
  t.add("recording.events", "events written to it, or read from it", [this] {
    return window.run.recording ? std::to_string(window.run.recording->events) : std::string("nan");
  });
  t.add("recording.bytes", "its size on the disk", [this] {
    return window.run.recording ? std::to_string(window.run.recording->bytes) : std::string("nan");
  });
}

} // namespace isoscope
