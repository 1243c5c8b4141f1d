// Commands on recordings; `open` opens them as it opens models.
#include "command/command_groups.h"

#include "ui/icons.h"

#include <filesystem>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

/// The model's name in the present folder, numbered where that is taken.
fs::path free_name(const AppModel& model) {
  const std::string name =
      model.run.scene && !model.run.scene->input->name.empty() ? model.run.scene->input->name : "run";
  fs::path file = name + ".isorun";
  for (int i = 2; fs::exists(file); ++i) file = name + "-" + std::to_string(i) + ".isorun";
  return file;
}

Status record(AppModel& model, const Arguments& a) {
  if (a.size() > 1) return Error{ErrorCode::usage, "record takes one file.", "Usage: record [FILE]"};
  const fs::path file = a.empty() ? free_name(model) : fs::path(a[0]);
  if (Status s = model.session.record(file); !s) return s;
  model.tell("The run is recorded to " + fs::absolute(file).string() + ".");
  return {};
}

} // namespace

std::vector<Command> recording_commands() {
  return {
      {"record",
       "Record the run…",
       "[FILE]",
       "Keeps the run from its first event on in a file that opens anywhere, also while it grows.",
       "File",
       icon::record,
       {{'R', true, true}},
       record,
       [](const AppModel& m) { return m.run.journal != nullptr && !m.shows_recording(); },
       [](const AppModel& m) { return m.run.recording && !m.run.recording->opened; }},
  };
}

} // namespace isoscope
