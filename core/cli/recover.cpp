// Saves what the pages hold, proves what no checksum proves by running it again, and writes the rest of it.
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/pending_file.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/interruptible.h"
#include "cli/progress_line.h"
#include "cli/verbs.h"
#include "recording/recording_writer.h"
#include "recording/salvage.h"
#include "run/parameters_json.h"
#include "run/recorded_run.h"
#include "run/replay_check.h"
#include "run/run_input.h"

#include <filesystem>
#include <string>

namespace isoscope {

namespace {

struct RecoverOptions {
  std::string file, output;
  bool quick = false, quiet = false;
  unsigned threads = 0;
};

/// A computation that tells how far it is and that a signal ends.
class Watched {
 public:
  explicit Watched(const RecoverOptions& options) : progress_(!options.quiet), signals_(control) {
    control.on_progress([this](std::string_view part, double fraction) { progress_.part(part, fraction); });
  }
  ~Watched() { progress_.finish(); }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  RunControl control;

 private:
  ProgressLine progress_;
  Interruptible signals_;
};

/// How many events from the first on are what the run decides, and in which words this is known.
struct Proof {
  std::size_t events = 0;
  std::string words;
};

Proof prove(const RecoverOptions& options, const RunParameters& parameters, const Salvage& found) {
  const std::size_t all = found.journal->events().size(), behind = all - found.proven;
  Proof proof{found.proven, counted(found.proven, "event") + " by the checksums"};
  if (behind == 0) return proof;
  if (options.quick) {
    proof.words += "; " + counted(behind, "event") + " behind them left out (--quick)";
    return proof;
  }
  const auto verdict = [&] {
    Watched watched(options);
    return check_replay(parameters, found.header.input, *found.journal, false, watched.control);
  }();
  if (!verdict) {
    proof.words += "; " + counted(behind, "event") + " behind them left out: " + verdict.error().message;
    return proof;
  }
  const std::size_t same = verdict->same ? all : verdict->events;
  if (same < found.proven) {
    proof.words += "; running it again differs at event " + grouped(same) +
                   ": the parameters are damaged, or another version recorded it";
    return proof;
  }
  proof.events = same;
  proof.words += ", " + counted(same - found.proven, "event") + " by running again";
  return proof;
}

Error nothing(const RecoverOptions& options, const std::string& why) {
  return {ErrorCode::bad_input, "Nothing of " + options.file + " can be saved: " + why + ".",
          "Take another copy, or record the run again."};
}

/// What can be saved, and the parameters of the run.
struct Found {
  Salvage salvage;
  RunParameters parameters;
};

/// Where the input or the first samples are damaged, they are read and made again: checksums tell whether
/// they are the recorded ones.
Result<Found> find(const RecoverOptions& options) {
  SalvageSubstitutes substitutes;
  auto salvage = salvage_recording(options.file, substitutes);
  if (!salvage) return salvage.error();
  auto parameters = parse_parameters(salvage->header.parameters);
  if (!parameters) return nothing(options, "the run's parameters are damaged or missing");
  if (!salvage->header.input) {
    const std::string& name = parameters->input;
    if (auto soup = load_input(*parameters)) {
      substitutes.input = std::make_shared<const TriangleSoup>(std::move(*soup));
      salvage = salvage_recording(options.file, substitutes);
      if (!salvage) return salvage.error();
    }
    if (!salvage->header.input)
      return nothing(options,
                     "its input is damaged, and " + name + " is not there to take its place, or another");
  }
  if (salvage->proven == 0) {
    const auto scene = [&] {
      Watched watched(options);
      return rebuild_scene(*parameters, salvage->header.input, Journal(), watched.control);
    }();
    if (!scene) return scene.error();
    substitutes.samples = (*scene)->samples;
    salvage = salvage_recording(options.file, substitutes);
    if (!salvage) return salvage.error();
  }
  return Found{std::move(*salvage), std::move(*parameters)};
}

Status write(const RecoverOptions& options, const Salvage& found, std::shared_ptr<const Journal> journal) {
  auto writer = RecordingWriter::create(options.output);
  if (!writer) return writer.error();
  (*writer)->start(found.header, std::move(journal));
  if (found.end) (*writer)->end([&] { return *found.end; });
  return (*writer)->finish();
}

std::string summary(const RecoverOptions& options, const Salvage& found, const Proof& proof,
                    const Journal& journal) {
  const std::size_t lost = found.journal->events().size() - proof.events + found.rows_behind;
  std::string text = line("Saved", counted(journal.events().size(), "event") + " and " +
                                       counted(journal.operations().size(), "operation") + ", up to step " +
                                       grouped(journal.steps()));
  text += line("Proven", proof.words);
  std::string loss = "nothing that the file holds";
  if (lost > 0)
    loss = counted(lost, "event") + " that the file still holds behind them";
  else if (!found.damage.empty())
    loss = "what the run did afterwards";
  text += line("Lost", loss + (found.end ? "; the run's end is there too" : "; how the run ended"));
  if (!found.damage.empty()) text += line("Damage", found.damage);
  return text + line("Recording", options.output);
}

bool are_one_file(const std::string& a, const std::string& b) {
  std::error_code failure;
  return std::filesystem::equivalent(behind_links(a), behind_links(b), failure);
}

} // namespace

int recover(int argc, char** argv) {
  RecoverOptions options;
  CommandLine app{
      "Saves what is sound in a recording that is damaged or cut short, up to the first event that is "
      "missing or wrong, and writes a recording that opens and replays. The damaged file is left alone.",
      "isoscope-run recover"};
  app.option("BROKEN", options.file, "a recording, with its -wal file beside it where there is one", true);
  app.option("-o,--output", options.output, "the new recording, OUT.isorun", true);
  app.flag("--quick", options.quick,
           "keep only what checksums prove; without it what lies behind them is proven by running again, "
           "which takes as long as the run did (Ctrl-C leaves it out)");
  app.option("--threads", options.threads, "number of threads, 0 for all cores");
  app.flag("--quiet", options.quiet, "print nothing but errors");
  app.exit_status("0 the new recording is written, whatever had to be left out; 1 it cannot be written; 2 "
                  "usage; 3 nothing can be saved; 4 stopped by the user before anything was.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  if (are_one_file(options.file, options.output)) {
    return fail({ErrorCode::usage, "-o " + options.output + " is the damaged recording itself.",
                 "Give another file: the damaged one is left as it is."},
                2);
  }
  const ThreadLimit threads(options.threads);
  const auto both = find(options);
  if (!both) return fail(both.error(), both.error().code == ErrorCode::cancelled ? 4 : 3);
  const Salvage* const found = &both->salvage;
  const Proof proof = prove(options, both->parameters, *found);
  if (proof.events == 0) return fail(nothing(options, "not one event of it is sound"), 3);
  const auto journal = first_events(*found->journal, proof.events);
  if (Status written = write(options, *found, journal); !written) return fail(written.error(), 1);
  if (!options.quiet)
    if (Status printed = print(summary(options, *found, proof, *journal)); !printed)
      return fail(printed.error(), 1);
  return 0;
}

} // namespace isoscope
