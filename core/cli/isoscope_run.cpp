// The batch program: the whole run without a display, a mesh and a report at its end.
#include "base/parallel.h"
#include "cli/options.h"
#include "cli/progress_line.h"
#include "input/mesh_io.h"
#include "run/pipeline.h"
#include "run/report.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include <unistd.h>

namespace {

using namespace isoscope;

/// Counts SIGINT and SIGTERM; the run polls it between operations. A signal handler can reach nothing but a
/// global.
volatile std::sig_atomic_t signals_received = 0;

extern "C" void on_signal(int) {
  signals_received = signals_received + 1;
  if (signals_received > 1) _exit(4);
}

/// Never pauses; passes signals on to the run's control and shows progress.
class BatchGate : public Gate {
 public:
  BatchGate(RunControl& control, ProgressLine& progress) : control_(&control), progress_(&progress) {}
  Verdict pass(const Journal& journal, const Event& event) override {
    if (signals_received > 0) control_->cancel();
    if (event.operation) progress_->operation(journal, event.stage);
    return control_->cancelled() ? Verdict::stop : Verdict::go_on;
  }
  CriteriaParameters wanted_parameters() const override {
    CriteriaParameters unchanged;
    unchanged.sigma = 0;
    return unchanged;
  }

 private:
  RunControl* control_;
  ProgressLine* progress_;
};

int exit_status(ErrorCode code) {
  switch (code) {
  case ErrorCode::usage:
    return 2;
  case ErrorCode::bad_input:
    return 3;
  case ErrorCode::unsupported:
    return 3;
  case ErrorCode::cancelled:
    return 4;
  default:
    return 1;
  }
}

int fail(const Error& error, int status) {
  std::fprintf(stderr, "isoscope-run: %s\n", error.line().c_str());
  return status;
}

/// Tries what the run will need at its end, before hours of work.
Status check_outputs(const std::string& mesh, const std::string& report) {
  if (!mesh.empty()) {
    if (Status s = check_writable_mesh(mesh); !s) return s;
  }
  if (report.empty() || report == "-") return {};
  const std::filesystem::path probe = report + ".part";
  if (std::filesystem::is_directory(report)) {
    return Error{ErrorCode::io, "Cannot write " + report + ": it is a directory.", "Give a file."};
  }
  return write_text_file(probe, "").ok() && std::remove(probe.c_str()) == 0
             ? Status()
             : Status(Error{ErrorCode::io,
                            "Cannot write " + report + ": its folder is missing or not writable.",
                            "Give another file."});
}

void print_summary(const Scene& scene, const RunResult& result, const Journal& journal) {
  const Certificate& c = result.certificate;
  std::printf("%zu samples, %u Steiner points, Z: %zu vertices, %zu facets, %zu component%s, χ %ld; %.2f s\n",
              scene.samples->size(), static_cast<unsigned>(journal.steps()), result.mesh.points.size(),
              result.mesh.triangles.size(), c.components, c.components == 1 ? "" : "s",
              c.euler_characteristic, result.seconds);
  if (c.holds()) {
    std::printf("certified: closed 2-manifold, intersection-free, inside Ω (d <= %.4f δ), separating, "
                "topology as expected\n",
                c.max_distance / scene.delta);
  } else {
    std::printf("not certified:\n");
    for (const std::string& failure : c.failures) std::printf("  %s\n", failure.c_str());
  }
}

int run(int argc, char** argv) {
  CLI::App app{
      "Isoscope's batch program: isotopic approximation within a tolerance volume, without a window.",
      "isoscope-run"};
  RunOptions options(app, false);
  std::string output, report;
  bool quiet = false, list_gallery = false;
  app.add_option("-o,--output", output, "the resulting mesh: .off, .obj, .ply or .stl");
  app.add_option("--report", report, "the report as JSON; - for standard output");
  app.add_flag("--quiet", quiet, "print nothing but errors");
  app.add_flag("--list-gallery", list_gallery, "list the bundled models");
  app.set_version_flag("--version", std::string("isoscope-run ") + std::string(version()));
  app.footer("Exit status: 0 finished and certified; 1 finished, not certified; 2 usage; 3 bad input; 4 "
             "stopped by a limit "
             "or by the user.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  if (list_gallery) {
    std::fputs(gallery_table().c_str(), stdout);
    return 0;
  }
  const auto parameters = options.finish();
  if (!parameters) return fail(parameters.error(), 2);
  if (parameters->input.empty()) {
    return fail(
        {ErrorCode::usage, "INPUT is missing.", "Give a mesh file or gallery:NAME; --help tells more."}, 2);
  }
  if (Status writable = check_outputs(output, report); !writable) return fail(writable.error(), 2);

  const ThreadLimit threads(parameters->threads);
  RunControl control;
  ProgressLine progress(quiet);
  control.on_progress([&](std::string_view part, double fraction) {
    if (signals_received > 0) control.cancel();
    progress.part(part, fraction);
  });
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);

  auto journal = std::make_shared<Journal>();
  BatchGate gate(control, progress);
  Pipeline pipeline(*parameters, journal, gate, control);
  const auto scene = pipeline.prepare();
  progress.clear();
  if (!scene) return fail(scene.error(), exit_status(scene.error().code));
  if (!quiet) {
    for (const ParameterWarning& w : (*scene)->warnings)
      std::fprintf(stderr, "warning: %s\n", w.message.c_str());
    if (!(*scene)->thickening_note.empty())
      std::fprintf(stderr, "note: %s\n", (*scene)->thickening_note.c_str());
  }
  const auto result = pipeline.run();
  progress.clear();
  if (!result) return fail(result.error(), exit_status(result.error().code));

  int status = result->exit_status();
  if (!output.empty()) {
    if (Status written = write_mesh(output, result->mesh); !written) status = fail(written.error(), 1);
  }
  if (!report.empty()) {
    const std::string text = report_json(*parameters, **scene, *result, gather_statistics(*journal));
    if (report == "-") {
      if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
        status = fail({ErrorCode::io, "Cannot write the report to standard output.", ""}, 1);
      }
    } else if (Status written = write_text_file(report, text); !written) {
      status = fail(written.error(), 1);
    }
  }
  if (!quiet && report != "-") print_summary(**scene, *result, *journal);
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
