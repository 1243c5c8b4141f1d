// A recording commit by commit, with what is shown of it meanwhile.
#include "run/show_recording.h"

#include "recording/recording_reader.h"
#include "run/parameters_json.h"
#include "run/recorded_run.h"

#include <utility>

namespace isoscope {
namespace {

class RecordingShow {
 public:
  RecordingShow(RecordingReader& reader, Journal& journal, const RunControl& control,
                const RecordingAudience& audience)
      : reader_(reader), journal_(journal), control_(control), audience_(audience) {}

  void show_read() const {
    audience_.publish([&](SessionSnapshot& s) {
      s.recording->bytes = reader_.file_bytes();
      s.recording->events = journal_.events().size();
    });
  }

  /// Reads what there is; false when something is damaged, which the snapshot then says.
  bool read_on() {
    while (!control_.cancelled()) {
      const auto more = reader_.read_commit(journal_);
      if (!more) {
        audience_.publish([&](SessionSnapshot& s) {
          s.recording->error = more.error();
          s.recording->cut_short = true;
        });
        return false;
      }
      if (!*more) break;
      show_read();
    }
    return true;
  }

  /// How the recorded run ended, waiting for it while another program writes it.
  std::optional<RecordingEnd> follow() {
    bool wanted = true;
    while (read_on()) {
      const auto end = reader_.end();
      if (end.ok() && *end) return *end;
      const std::size_t before = journal_.events().size();
      const bool growing = reader_.growing();
      if (!read_on()) break;
      if (journal_.events().size() != before) continue;
      if (const auto last = reader_.end(); last.ok() && *last) return *last;
      if (!growing || !wanted) {
        audience_.publish([](SessionSnapshot& s) { s.recording->cut_short = true; });
        break;
      }
      audience_.publish([](SessionSnapshot& s) { s.phase = SessionPhase::following; });
      wanted = audience_.wait();
    }
    return std::nullopt;
  }

 private:
  RecordingReader& reader_;
  Journal& journal_;
  const RunControl& control_;
  const RecordingAudience& audience_;
};

} // namespace

Status show_recording(const std::filesystem::path& file, const std::shared_ptr<Journal>& journal,
                      RunControl& control, const RecordingAudience& audience) {
  auto opened = RecordingReader::open(file);
  if (!opened) return opened.error();
  const auto reader = std::move(*opened);
  auto parameters = parse_parameters(reader->header().parameters);
  if (!parameters) return parameters.error();
  audience.publish([&](SessionSnapshot& s) { s.parameters = *parameters; });
  control.report("the recording", -1);
  RecordingShow show(*reader, *journal, control, audience);
  const bool sound = show.read_on();
  const auto scene =
      rebuild_scene(*parameters, reader->header().input, *journal, control, reader->header().notes);
  if (!scene) return scene.error();
  audience.publish([&](SessionSnapshot& s) {
    s.scene = *scene;
    s.part.clear();
    s.fraction = -1;
  });
  std::shared_ptr<const RunResult> result;
  if (const auto end = sound ? show.follow() : std::nullopt) {
    auto read = recorded_result(*end, *journal);
    if (read)
      result = std::make_shared<const RunResult>(std::move(*read));
    else
      audience.publish([&](SessionSnapshot& s) { s.recording->error = read.error(); });
  }
  // A reader that is the last to use the file takes its log into it.
  [[maybe_unused]] const bool growing = reader->growing();
  show.show_read();
  audience.publish([&](SessionSnapshot& s) {
    s.result = result;
    s.phase = SessionPhase::finished;
  });
  return {};
}

} // namespace isoscope
