// Look, show, wait.
#include "run/follow_copy.h"

#include "recording/copy_reader.h"
#include "run/parameters_json.h"
#include "run/recorded_run.h"

namespace isoscope {

namespace {

class Following {
 public:
  Following(const std::filesystem::path& file, const std::shared_ptr<Journal>& journal, RunControl& control,
            const RecordingAudience& audience)
      : file_(file), reader_(file), journal_(journal), control_(control), audience_(audience) {}

  Status run() {
    for (bool wanted = true; wanted && !control_.cancelled();) {
      const auto more = reader_.look(*journal_, control_);
      show_read();
      if (!more) return more.error();
      if (Status begun = begin(); !begun) return begun;
      if (reader_.end()) return finish();
      wanted = audience_.wait();
    }
    if (begun_) return leave(nullptr, true);
    return Error{ErrorCode::cancelled, file_.string() + " has not come far enough to be shown.",
                 "Open it again once there is more of it."};
  }

 private:
  void show_read() const {
    audience_.publish([&](SessionSnapshot& s) {
      s.recording->bytes = reader_.bytes();
      s.recording->events = journal_->events().size();
      s.recording->written = reader_.written();
      s.recording->torn = reader_.torn();
    });
  }

  /// Makes Ω as soon as the run's beginning is there.
  Status begin() {
    if (begun_ || reader_.header() == nullptr) return {};
    auto parameters = parse_parameters(reader_.header()->parameters);
    if (!parameters) return parameters.error();
    audience_.publish([&](SessionSnapshot& s) { s.parameters = *parameters; });
    const auto scene =
        rebuild_scene(*parameters, reader_.header()->input, *journal_, control_, reader_.header()->notes);
    if (!scene) return scene.error();
    begun_ = true;
    audience_.publish([&](SessionSnapshot& s) {
      s.scene = *scene;
      s.part.clear();
      s.fraction = -1;
      s.phase = SessionPhase::following;
    });
    return {};
  }

  Status finish() const {
    auto read = recorded_result(*reader_.end(), *journal_);
    if (!read) {
      audience_.publish([&](SessionSnapshot& s) { s.recording->error = read.error(); });
      return leave(nullptr, false);
    }
    return leave(std::make_shared<const RunResult>(std::move(*read)), false);
  }

  Status leave(const std::shared_ptr<const RunResult>& result, bool cut_short) const {
    audience_.publish([&](SessionSnapshot& s) {
      s.recording->cut_short = cut_short;
      s.result = result;
      s.phase = SessionPhase::finished;
    });
    return {};
  }

  std::filesystem::path file_;
  CopyReader reader_;
  std::shared_ptr<Journal> journal_;
  RunControl& control_;
  const RecordingAudience& audience_;
  bool begun_ = false;
};

} // namespace

Status follow_copy(const std::filesystem::path& file, const std::shared_ptr<Journal>& journal,
                   RunControl& control, const RecordingAudience& audience) {
  control.report("waiting for the copy", -1);
  return Following(file, journal, control, audience).run();
}

} // namespace isoscope
