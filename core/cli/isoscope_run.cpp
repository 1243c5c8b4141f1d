// The batch program: the whole run without a display, a mesh and a report at its end.
#include "base/parallel.h"
#include "cli/compare_table.h"
#include "cli/exit_status.h"
#include "cli/interruptible.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/progress_line.h"
#include "cli/summary.h"
#include "cli/tiles.h"
#include "cli/verbs.h"
#include "improve/improver.h"
#include "input/mesh_io.h"
#include "journal/describe.h"
#include "recording/recording_writer.h"
#include "run/approximate.h"
#include "run/pipeline.h"
#include "run/recorded_run.h"
#include "run/report.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace isoscope;

/// Follows the run into its recording; without --record it does nothing. Destroyed, it closes the file.
class Recording {
 public:
  /// Makes the file, so that a wrong name is told before the work starts.
  Status create(const std::string& file) {
    if (file.empty()) return {};
    auto created = RecordingWriter::create(file);
    if (!created) return created.error();
    writer_ = std::move(*created);
    return {};
  }
  void start(const RunParameters& parameters, const Scene& scene, std::shared_ptr<const Journal> journal) {
    if (writer_) writer_->start(recording_header(parameters, scene.input, scene.notes), std::move(journal));
  }
  /// Says at once, and once, that nothing more can be written; the run goes on without its recording. From
  /// the run's thread.
  void tell_failure(ProgressLine& progress) {
    if (!writer_ || told_) return;
    const auto error = writer_->progress().error;
    if (!error) return;
    told_ = true;
    progress.finish();
    std::fprintf(stderr, "isoscope-run: %s The run goes on; the recording ends here.\n",
                 error->line().c_str());
  }
  bool told() const { return told_; }
  Status finish(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                const Journal& journal) {
    if (!writer_) return {};
    writer_->end([&] { return recording_end(parameters, scene, result, journal); });
    return writer_->finish();
  }

 private:
  std::unique_ptr<RecordingWriter> writer_;
  bool told_ = false;
};

/// Never pauses; ends the run once it is cancelled or a breakpoint holds, and shows progress.
class BatchGate : public Gate {
 public:
  BatchGate(RunControl& control, ProgressLine& progress, BreakpointSet& breakpoints, Recording& recording)
      : control_(&control), progress_(&progress), breakpoints_(&breakpoints), recording_(&recording),
        asks_(breakpoints.any_enabled()) {}
  Verdict pass(const Journal& journal, const Event& event) override {
    if (event.operation) {
      progress_->operation(journal, event.stage);
      recording_->tell_failure(*progress_);
      tell_spill_error(journal);
    }
    if (asks_ && !hit_) {
      hit_ = breakpoints_->ask(journal);
      if (hit_) control_->cancel();
    }
    return control_->cancelled() ? Verdict::stop : Verdict::go_on;
  }
  CriteriaParameters wanted_parameters() const override { return criteria_; }
  void set(const CriteriaParameters& criteria) { criteria_ = criteria; }
  /// What made the run stop.
  const std::optional<BreakpointHit>& hit() const { return hit_; }

 private:
  RunControl* control_;
  ProgressLine* progress_;
  BreakpointSet* breakpoints_;
  Recording* recording_;
  bool asks_, spill_told_ = false;
  std::optional<BreakpointHit> hit_;
  CriteriaParameters criteria_;

  void tell_spill_error(const Journal& journal) {
    if (spill_told_) return;
    const auto error = journal.spill_error();
    if (!error) return;
    spill_told_ = true;
    progress_->finish();
    std::fprintf(stderr, "isoscope-run: note: %s\n", error->line().c_str());
  }
};

const Verb verbs[] = {
    {{"replay", "RUN.isorun", "reads a recording"}, replay},
    {{"diff", "A.isorun B.isorun", "tells what differs between two"}, diff},
    {{"recover", "BROKEN.isorun -o OUT.isorun", "saves what is sound in a damaged one"}, recover},
    {{"tiles", "cut|step|rerun|join|status", "makes a run in tiles, in parts"}, tiles},
};

void note(const std::string& text) {
  std::fprintf(stderr, "isoscope-run: note: %s\n", text.c_str());
}

int run(int argc, char** argv) {
  CommandLine app{
      "Isoscope's batch program: isotopic approximation within a tolerance volume, without a window.",
      "isoscope-run"};
  RunOptions options(app);
  Outputs outputs;
  bool quiet = false, compare = false, list_gallery = false;
  std::string tiles_folder, tile_memory = usual_tile_memory;
  double history_limit = usual_history_mib;
  app.option("-o,--output", outputs.mesh, "the resulting mesh: .off, .obj, .ply or .stl");
  app.option("--report", outputs.report, "the report as JSON; - for standard output");
  app.option(
      "--tiles", tiles_folder,
      "make the run in tiles, which are kept in this folder: begun there, or gone on with; the input has to "
      "be closed and free of intersections, and normals (condition 3) are not kept");
  app.option("--tile-memory", tile_memory, tile_memory_help);
  app.flag("--compare", compare,
           "print the stages side by side: operations, vertices, times, rejections by reason");
  app.option("--history-limit", history_limit,
             "of the journal in memory, MiB; what is older goes to the disk; default " +
                 std::to_string(usual_history_mib),
             1, 1048576);
  app.flag("--quiet", quiet, "print nothing but warnings and errors");
  app.flag("--list-gallery", list_gallery, "list the bundled models");
  app.version(std::string("isoscope-run ") + std::string(version()));
  for (const Verb& verb : verbs) app.verb(verb.told);
  app.exit_status(
      "0 finished and certified; 1 finished, not certified; 2 usage; 3 bad input, or one that is "
      "not worked on at this tolerance; 4 stopped by a limit "
      "or by the user, but in the improver with --effort 3, which ends only so and as if it had finished; "
      "5 stopped at a breakpoint.");
  app.see_also("isoscope");
  app.see_also("isoscope-sweep");
  if (const auto status = run_verb(verbs, argc, argv)) return *status;
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (list_gallery) return answer(gallery_table());
  BreakpointSet breakpoints;
  if (Status added = add_breakpoints(options.breakpoints(), breakpoints); !added)
    return fail(added.error(), 2);
  const auto parameters = options.finish();
  if (!parameters) return fail(parameters.error(), 2);
  if (parameters->input.empty()) {
    return fail(
        {ErrorCode::usage, "INPUT is missing.", "Give a mesh file or gallery:NAME; --help tells more."}, 2);
  }
  outputs.recording = options.recording();
  const bool report_to_stdout = outputs.report == "-";
  if (compare && report_to_stdout) {
    return fail({ErrorCode::usage, "--compare and --report - both print to standard output.",
                 "Give a file for the report."},
                2);
  }
  for (const std::string& input : {parameters->input, parameters->inside})
    if (Status writable = check_outputs(outputs, input); !writable) return fail(writable.error(), 2);
  if (!tiles_folder.empty()) {
    if (!outputs.recording.empty() || compare || breakpoints.any_enabled())
      return fail({ErrorCode::usage, "A run in tiles has no journal to record, to compare or to break at.",
                   "Leave --record, --compare and --break out."},
                  2);
    return run_in_tiles(*parameters, tiles_folder, tile_memory, outputs, quiet);
  }
  Recording recording;
  if (Status made = recording.create(outputs.recording); !made) return fail(made.error(), 2);

  const ThreadLimit threads(parameters->threads);
  RunControl control;
  const Interruptible signals(control);
  ProgressLine progress(!quiet);
  control.on_progress([&](std::string_view part, double fraction) { progress.part(part, fraction); });

  auto journal = std::make_shared<Journal>();
  journal->keep_within(static_cast<std::size_t>(history_limit * 1048576.0));
  BatchGate gate(control, progress, breakpoints, recording);
  Pipeline pipeline(*parameters, journal, gate, control);
  const auto scene = pipeline.prepare();
  progress.finish();
  if (!scene) return fail(scene.error(), exit_status(scene.error().code));
  gate.set(parameters->criteria((*scene)->delta, (*scene)->default_sigma));
  breakpoints.set_expected([&] { return expected_genus(**scene); });
  for (const ParameterWarning& w : (*scene)->warnings) note(w.message);
  if (!(*scene)->thickening_note.empty()) note((*scene)->thickening_note);
  if (const std::string start = start_note(*parameters, **scene); !start.empty() && !quiet) note(start);
  if (parameters->effort == endless_effort && parameters->time_limit == 0 && !quiet)
    note("The improver goes on until Ctrl-C; --time-limit ends it as well.");
  recording.start(*parameters, **scene, journal);
  const auto result = pipeline.run();
  progress.finish();
  if (!result) return fail(result.error(), exit_status(result.error().code));

  if (const std::string crumbs = crumbs_note(result->crumbs, result->size().vertices); !crumbs.empty())
    note(crumbs);

  constexpr int stopped_at_breakpoint = 5;
  int status = gate.hit() ? stopped_at_breakpoint : result->exit_status();
  const bool refused = result->refused();
  if (refused && !outputs.mesh.empty())
    note("What Z is at this tolerance is no result: " + outputs.mesh + " is not written.");
  if (result->failure) fail(*result->failure, status);
  if (gate.hit()) {
    std::fprintf(stderr, "isoscope-run: %s: %s\n", gate.hit()->note().c_str(),
                 describe(*journal, journal->events()[gate.hit()->event]).c_str());
  }
  if (Status recorded = recording.finish(*parameters, **scene, *result, *journal); !recorded) {
    status = recording.told() ? 1 : fail(recorded.error(), 1);
  }
  if (!outputs.mesh.empty() && !refused && result->mesh.triangles.empty()) {
    note("There is no Z yet: " + outputs.mesh + " is not written.");
    if (status == 0) status = 1;
  } else if (!outputs.mesh.empty() && !refused) {
    if (Status written = write_mesh(outputs.mesh, result->mesh); !written) status = fail(written.error(), 1);
  }
  const std::vector<StageStatistics> stages = gather_statistics(*journal);
  if (!outputs.report.empty()) {
    const std::string text = report_json(*parameters, **scene, *result, stages);
    Status written = report_to_stdout ? print(text) : write_text_file(outputs.report, text);
    if (!written) status = fail(written.error(), 1);
  }
  if (refused) return status;
  if (quiet || report_to_stdout) {
    for (const std::string& warning : warnings(*parameters, **scene, *result, gate.hit().has_value()))
      note(warning);
  } else {
    if (Status written = print(
            summary(*parameters, **scene, *result, stages, gate.hit() ? gate.hit()->note() : std::string()));
        !written) {
      status = fail(written.error(), 1);
    }
  }
  if (compare) {
    if (Status written = print((quiet ? "" : "\n") + compare_table(stages)); !written) {
      status = fail(written.error(), 1);
    }
  }
  return status;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "isoscope-run: memory is exhausted. Take a larger tolerance or a larger --sigma.\n");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "isoscope-run: internal error: %s\n", e.what());
  }
  return 1;
}
