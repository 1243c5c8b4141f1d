// What scripts can expect of recordings.
#include "command/named_table.h"

namespace isoscope {

namespace {

std::string state_word(const AppModel& m) {
  if (!m.run.recording) return "none";
  const RecordingState& r = *m.run.recording;
  if (r.error) return "failed";
  if (r.cut_short) return "cut-short";
  if (!r.opened) return "writing";
  return m.run.phase == SessionPhase::following ? "following" : "opened";
}

} // namespace

void add_recording_readings(NamedTable& t) {
  t.push_back({"recording", "none, writing, opened, following, cut-short or failed", state_word, nullptr});
  t.push_back({"recording.events", "events written to it, or read from it",
               [](const AppModel& m) {
                 return m.run.recording ? std::to_string(m.run.recording->events) : std::string("nan");
               },
               nullptr});
  t.push_back({"recording.bytes", "its size on the disk",
               [](const AppModel& m) {
                 return m.run.recording ? std::to_string(m.run.recording->bytes) : std::string("nan");
               },
               nullptr});
}

} // namespace isoscope
