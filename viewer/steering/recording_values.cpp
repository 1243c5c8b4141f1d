// What scripts can expect of recordings.
#include "steering/copy_words.h"
#include "steering/steering.h"

namespace isoscope {

namespace {

std::string state_word(const WindowState& m) {
  if (!m.run.recording) return "none";
  const RecordingState& r = *m.run.recording;
  if (r.error) return "failed";
  if (r.cut_short) return "cut-short";
  if (!r.opened) return "writing";
  if (r.copied && !m.run.scene) return "awaited";
  return m.run.phase == SessionPhase::following ? "following" : "opened";
}

} // namespace

void Steering::add_recording_values(NamedValues& t) {
  t.add("recording", "none, writing, opened, awaited, following, cut-short or failed",
        [this] { return state_word(window); });
  const auto of = t.readings(
      "recording.", [this] { return window.run.recording; }, "nan");
  of("events", "events written to it, or read from it", &RecordingState::events);
  t.add("recording.whole", "whether it has every event so far", [this] {
    const auto& run = window.run;
    return run.recording && run.journal && run.recording->events >= run.journal->events().size();
  });
  of("bytes", "its size on the disk", &RecordingState::bytes);
  of("copied", "whether it is followed as a copy", &RecordingState::copied);
  of("age", "of a copy: seconds since it was written", [](const RecordingState& r) { return age_of(r); });
  of("torn", "whether the copy has an end that cannot be read yet",
     [](const RecordingState& r) { return r.torn.has_value(); });
}

} // namespace isoscope
