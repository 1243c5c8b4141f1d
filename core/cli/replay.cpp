// Reads the whole recording, prints a summary, and runs it again when asked to.
#include "base/numbers.h"
#include "base/parallel.h"
#include "cli/command_line.h"
#include "cli/compare_table.h"
#include "cli/exit_status.h"
#include "cli/progress_line.h"
#include "cli/recorded_file.h"
#include "cli/verbs.h"
#include "input/mesh_io.h"
#include "journal/digest.h"
#include "mesh/zero_set.h"
#include "run/recorded_run.h"
#include "run/replay_check.h"
#include "run/statistics.h"
#include "tiles/tile_run.h"

#include <cstdio>
#include <string>

namespace isoscope {

namespace {

struct ReplayOptions {
  std::string file, mesh;
  bool check = false, quiet = false;
  unsigned threads = 0;
};

std::string end_words(const RecordedRun& r) {
  if (r.end) return r.end->state + (r.end->certified ? ", certified" : ", not certified");
  return "ended without finishing: " + counted(r.journal->events().size(), "event") +
         " up to the last commit";
}

int recorded_status(const RecordedRun& r) {
  if (!r.end) return 4;
  if (const auto result = recorded_result(*r.end, *r.journal); result && result->without_end)
    return result->exit_status();
  if (r.end->state != "finished") return 4;
  return r.end->certified ? 0 : 1;
}

std::string summary(const ReplayOptions& options, const RecordedRun& r, const TriangleMesh& mesh) {
  const RecordingHeader& header = r.reader->header();
  const Journal& j = *r.journal;
  const std::string size = fixed(static_cast<double>(r.reader->file_bytes()) / 1e6, 1) + " MB";
  std::string text;
  text += line("Recording", options.file + ": " + size + ", written by " + header.program);
  text += line("Input", r.parameters.input + ": " + counted(header.input->points.size(), "point") + ", " +
                            counted(header.input->triangles.size(), "triangle") + ", digest " +
                            digest_text(r.reader->input_digest()) + "; tolerance " +
                            r.parameters.tolerance.text());
  for (std::size_t i = 0; i < j.events().size(); ++i) {
    const Event& e = j.events()[i];
    if (e.kind == EventKind::warning && e.stage == Stage::setup) text += line("Note", j.texts()[e.text]);
  }
  text += line("Run", end_words(r));
  text +=
      line("Journal", counted(j.events().size(), "event") + ", " +
                          counted(j.operations().size(), "operation") + ", digest " + digest_text(digest(j)));
  text += line("Z", counted(mesh.points.size(), "point") + ", " + counted(mesh.triangles.size(), "triangle"));
  return text + "\n" + compare_table(gather_statistics(j));
}

int check_it(const ReplayOptions& options, const RecordedRun& r) {
  RunControl control;
  ProgressLine progress(!options.quiet);
  control.on_progress([&](std::string_view part, double fraction) { progress.part(part, fraction); });
  const RecordingHeader& header = r.reader->header();
  auto tile = tile_start(r.parameters, header.input, *r.journal);
  const auto verdict =
      tile ? check_tile_replay(std::move(*tile), *r.journal, r.end.has_value(), control)
           : check_replay(r.parameters, header.input, *r.journal, r.end.has_value(), control, header.notes);
  progress.finish();
  if (!verdict) return fail(verdict.error());
  if (!verdict->same) {
    std::fprintf(stderr, "isoscope-run: It does not replay. %s\n", verdict->difference.c_str());
    return 1;
  }
  if (options.quiet) return 0;
  const std::string ended =
      r.end ? verdict->to_the_end ? "; the final Z is the same" : "" : "; it ends there without finishing";
  const Status printed = print(
      "Replays: " + counted(verdict->events, "event") + " and " + counted(verdict->operations, "operation") +
      " are the same, " + counted(verdict->states, "state") + (verdict->states == 1 ? " comes" : " come") +
      " back when undone" + ended + ".\n");
  return printed.ok() ? 0 : fail(printed.error(), 1);
}

} // namespace

int replay(int argc, char** argv) {
  ReplayOptions options;
  CommandLine app{"Reads a recording: what it holds, its last Z, and whether it replays.",
                  "isoscope-run replay"};
  app.option("RUN", options.file, "a recording, RUN.isorun, also of a killed run", true);
  app.flag("--check", options.check,
           "run it again from the input it holds and compare every event, operation and state");
  app.option("-o,--output", options.mesh, "write Z as it is after the last operation");
  app.option("--threads", options.threads, "number of threads, 0 for all cores");
  app.flag("--quiet", options.quiet, "print nothing but errors");
  app.exit_status("that of the recorded run, 4 when it ended without finishing; with --check 0 when "
                  "it replays and 1 when it does not; 2 usage; 3 a file that cannot be read.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  if (!options.mesh.empty())
    if (Status writable = check_writable_mesh(options.mesh); !writable) return fail(writable.error(), 2);
  const ThreadLimit threads(options.threads);
  const auto recorded = read_recorded_run(options.file);
  if (!recorded)
    return fail(recorded.error(),
                recorded.error().code == ErrorCode::io ? 3 : exit_status(recorded.error().code));
  const TriangleMesh mesh = triangulate(extract_zero_set(final_state(*recorded->journal)));
  if (!options.mesh.empty())
    if (Status written = write_mesh(options.mesh, mesh); !written) return fail(written.error(), 1);
  if (options.check) return check_it(options, *recorded);
  if (!options.quiet)
    if (Status printed = print(summary(options, *recorded, mesh)); !printed) return fail(printed.error(), 1);
  return recorded_status(*recorded);
}

} // namespace isoscope
