// Every request is made as the window's workers make it: a play head, a probe, a state check.
#include "bench/latency.h"

#include "criteria/nearest_sample.h"
#include "questions/state_check.h"
#include "questions/target_study.h"
#include "recording/recording_reader.h"
#include "recording/recording_writer.h"
#include "run/complete_run.h"
#include "run/parameters_json.h"
#include "run/recorded_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <random>

namespace isoscope::bench {

namespace {

/// A recording in memory, as a session holds it.
struct Opened {
  RunParameters parameters;
  std::shared_ptr<const TriangleSoup> input;
  std::shared_ptr<Journal> journal = std::make_shared<Journal>();
  std::shared_ptr<const Scene> scene;
};

Result<Opened> read(const std::filesystem::path& file) {
  auto reader = RecordingReader::open(file);
  if (!reader) return reader.error();
  auto parameters = parse_parameters((*reader)->header().parameters);
  if (!parameters) return parameters.error();
  Opened opened;
  opened.parameters = std::move(*parameters);
  opened.input = (*reader)->header().input;
  for (;;) {
    const auto more = (*reader)->read_commit(*opened.journal);
    if (!more) return more.error();
    if (!*more) break;
  }
  if (opened.journal->steps() == 0)
    return Error{ErrorCode::usage, file.string() + " holds no operation.", "Record a whole run."};
  return opened;
}

/// Uniform numbers that are the same on every machine.
class Places {
 public:
  explicit Places(std::uint64_t seed) : generator_(seed) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(generator_() % n); }

 private:
  std::mt19937_64 generator_;
};

/// The play head: one playback, the last state kept.
class Head {
 public:
  Head(const Opened& opened, std::size_t history_limit) : playback_(opened.journal) {
    const std::size_t taken = opened.journal->memory_bytes();
    playback_.set_keyframe_limit(history_limit > taken ? history_limit - taken : 0);
  }
  std::shared_ptr<const StateSnapshot> show(Step step) {
    return last_ = make_snapshot(playback_, step, {}, nullptr, last_.get());
  }

 private:
  Playback playback_;
  std::shared_ptr<const StateSnapshot> last_;
};

void measure_moves(const Opened& opened, const LatencyOptions& options, std::vector<Distribution>& rows) {
  const Step steps = opened.journal->steps();
  Head head(opened, options.history_limit);
  Distribution first("first jump to the end"), seek("seek, any state to any other"), forward("step forward"),
      back("step back");
  first.measure([&] { head.show(steps); });
  Places places(options.seed);
  for (std::size_t i = 0; i < options.repeats; ++i) {
    const auto step = static_cast<Step>(1 + places.below(steps));
    seek.measure([&] { head.show(step); });
    back.measure([&] { head.show(step - 1); });
    forward.measure([&] { head.show(step); });
  }
  Playback bare(opened.journal);
  bare.seek(steps);
  Distribution deltas("of it: keyframe and deltas"), samples("of it: samples to tetrahedra");
  for (std::size_t i = 0; i < options.repeats; ++i) {
    const auto step = static_cast<Step>(1 + places.below(steps));
    deltas.measure([&] { bare.seek(step); });
    samples.measure([&] { bare.sample_sets(); });
  }
  rows.insert(rows.end(), {first, seek, deltas, samples, forward, back});
}

/// A collapse or a rejection of an edge that T still has.
std::optional<EdgeQuestion> question_at(const Journal& journal, std::size_t event) {
  const Event& e = journal.events()[event];
  if (e.kind != EventKind::rejection && e.kind != EventKind::collapse) return std::nullopt;
  if (e.stage == Stage::improve) return std::nullopt;
  return EdgeQuestion{e.vertex, e.other, static_cast<std::uint32_t>(event)};
}

void measure_edges(const Opened& opened, const LatencyOptions& options, std::vector<Distribution>& rows) {
  const Journal& journal = *opened.journal;
  Head head(opened, options.history_limit);
  Distribution xrays("X-ray of an edge"), studies("what-if: a target of one's own");
  std::shared_ptr<const BoundarySamples> indexed;
  std::optional<NearestSample> nearest;
  Places places(options.seed);
  for (std::size_t i = 0; i < 50 * options.repeats && xrays.size() < options.repeats; ++i) {
    const std::size_t event = places.below(journal.events().size());
    const auto question = question_at(journal, event);
    if (!question) continue;
    const Event& e = journal.events()[event];
    const auto state = head.show(e.operation ? e.step + 1 : e.step);
    if (state->samples && state->samples != indexed) {
      indexed = state->samples;
      nearest.emplace(indexed->positions, indexed->labels);
    }
    const XrayContext context{*opened.scene, journal, opened.parameters, nearest ? &*nearest : nullptr};
    std::optional<EdgeXray> xray;
    Distribution once(xrays.what());
    once.measure([&] { xray = edge_xray(*state, *question, context); });
    if (!xray) continue;
    xrays.add(once.quantile(Distribution::Clock::wall, 1), once.quantile(Distribution::Clock::processor, 1));
    const Vec3 a = xray->star.vertices[0].position, b = xray->star.vertices[1].position;
    studies.measure([&] { study_target(*xray, 0.5 * (a + b), context); });
  }
  rows.insert(rows.end(), {xrays, studies});
}

void measure_checks(const Opened& opened, const LatencyOptions& options, std::vector<Distribution>& rows) {
  Head head(opened, options.history_limit);
  Distribution checks("check of a whole state");
  Places places(options.seed);
  for (std::size_t i = 0; i < std::max<std::size_t>(1, options.repeats / 10); ++i) {
    const auto state = head.show(static_cast<Step>(places.below(opened.journal->steps() + 1)));
    checks.measure([&] { check_state(*opened.journal, *state, opened.scene.get(), RunControl()); });
  }
  rows.push_back(checks);
}

} // namespace

void Distribution::measure(const std::function<void()>& work) {
  const auto begun = std::chrono::steady_clock::now();
  const std::clock_t spent = std::clock();
  work();
  const double processor = static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
  add(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), processor);
}

void Distribution::add(double wall_seconds, double processor_seconds) {
  seconds_[static_cast<std::size_t>(Clock::wall)].add(wall_seconds);
  seconds_[static_cast<std::size_t>(Clock::processor)].add(processor_seconds);
}

Status record_run(const std::string& model, const Tolerance& tolerance, const std::filesystem::path& file) {
  RunParameters parameters;
  parameters.input = model;
  parameters.tolerance = tolerance;
  test::CompleteRun run(parameters);
  if (!run.prepare()) return *run.error;
  auto writer = RecordingWriter::create(file);
  if (!writer) return writer.error();
  (*writer)->start(recording_header(parameters, run.scene->input), run.journal);
  if (!run.run()) return *run.error;
  (*writer)->end([&] { return recording_end(parameters, *run.scene, *run.result, *run.journal); });
  return (*writer)->finish();
}

Result<std::vector<Distribution>> measure_latencies(const std::filesystem::path& recording,
                                                    const LatencyOptions& options) {
  Distribution reading("opening: the journal"), rebuilding("opening: Ω made again");
  std::optional<Result<Opened>> opened;
  reading.measure([&] { opened.emplace(read(recording)); });
  if (!*opened) return opened->error();
  Opened& run = **opened;
  std::optional<Error> error;
  rebuilding.measure([&] {
    RunControl control;
    auto scene = rebuild_scene(run.parameters, run.input, *run.journal, control);
    if (scene)
      run.scene = std::move(*scene);
    else
      error = scene.error();
  });
  if (error) return *error;
  std::vector<Distribution> rows{reading, rebuilding};
  measure_moves(run, options, rows);
  measure_edges(run, options, rows);
  measure_checks(run, options, rows);
  return rows;
}

std::string table(const std::vector<Distribution>& rows) {
  char line[200];
  std::snprintf(line, sizeof line, "%-32s %6s %10s %10s %10s %10s %10s %10s\n", "ms", "times", "median",
                "95 %", "largest", "CPU median", "CPU 95 %", "CPU largest");
  std::string text = line;
  for (const Distribution& row : rows) {
    std::snprintf(line, sizeof line, "%-32s %6zu", row.what().c_str(), row.size());
    text += line;
    for (const auto clock : {Distribution::Clock::wall, Distribution::Clock::processor}) {
      for (const double part : {0.5, 0.95, 1.0}) {
        std::snprintf(line, sizeof line, " %10.2f", 1e3 * row.quantile(clock, part));
        text += line;
      }
    }
    text += "\n";
  }
  return text;
}

} // namespace isoscope::bench
