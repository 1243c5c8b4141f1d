// The start is the first operation, with the box in its event; points that are held are told before it.
#include "tiles/tile_run.h"

#include "base/memory.h"
#include "base/stopwatch.h"
#include "improve/free_improvement.h"
#include "journal/stage_log.h"
#include "mesh/zero_set.h"
#include "recording/recording_writer.h"
#include "run/passing_gate.h"
#include "run/recorded_run.h"
#include "simplify/tessellation.h"
#include "tiles/tile_piece.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace isoscope {
namespace {

constexpr std::string_view kept_words = "Z keeps this point on its side.";
/// The whole input is in memory anyhow; answers do not depend on it.
constexpr double all_memory = std::numeric_limits<double>::infinity();
constexpr std::string_view start_words = "Z before tile ";

/// What a run in tiles asks of one that shows a tile of it.
RunParameters parameters_of_tile(const TileManifest& m, int effort, double longest_edge) {
  RunParameters p = m.parameters;
  // As it was asked for, where that still means the same without what was left out of the input.
  const bool same = !p.tolerance.automatic && p.tolerance.absolute(longest_edge) == m.delta;
  if (!same) p.tolerance = {m.delta, false};
  p.start = FirstZ::input;
  p.effort = effort;
  p.drop_small = 0; // those are gone
  p.time_limit = 0;
  p.conditions[2] = false; // which tiles do not keep
  return p;
}

/// Tells once that a recording has events, so that it can be opened.
class TellingGate : public PassingGate {
 public:
  TellingGate(const RecordingWriter& writer, const std::function<void()>& tell)
      : writer_(writer), tell_(tell), told_(!tell) {}
  Verdict pass(const Journal&, const Event&) override {
    constexpr std::size_t events_by_question = 16;
    if (!told_ && events_++ % events_by_question == 0 && writer_.progress().events > 0) tell();
    return Verdict::go_on;
  }
  void tell() {
    if (!std::exchange(told_, true)) tell_();
  }

 private:
  const RecordingWriter& writer_;
  const std::function<void()>& tell_;
  bool told_;
  std::size_t events_ = 0;
};

bool tells_kept_point(const Journal& journal, const Event& e) {
  return e.kind == EventKind::warning && journal.texts()[e.text] == kept_words;
}

} // namespace

Result<TileStart> tile_start(const TileFolder& folder, const TileRound& round, std::size_t tile) {
  if (Status there = check_tile(round, tile); !there) return there.error();
  const TileManifest& m = folder.manifest();
  const auto since = folder.in_vain_since(round, round.tiles[tile].tile);
  if (!since) return since.error();
  if (*since)
    return Error{ErrorCode::usage,
                 "Round " + std::to_string(round.number) + " has left tile " + std::to_string(tile) +
                     " as it was, as round " + std::to_string(**since) + " took nothing from it.",
                 "Make a tile of that round once more."};
  TileStart start;
  start.box = folder.grid().bounds(round.tiling, round.tiles[tile].tile);
  start.words = std::to_string(tile) + " of round " + std::to_string(round.number);
  start.kept = kept_points(m, start.box);
  auto z = folder.z_before(round.number, all_of_space);
  auto input = folder.input(all_of_space);
  if (!z) return z.error();
  if (!input) return input.error();
  start.z = mesh_of(std::move(*z));
  TriangleSoup soup = soup_of(std::move(*input));
  soup.name = std::filesystem::path(m.parameters.input).stem().string() + "-tile";
  start.parameters = parameters_of_tile(m, round.effort, soup.bounds().longest_edge());
  start.input = std::make_shared<const TriangleSoup>(std::move(soup));
  return start;
}

std::optional<TileStart> tile_start(const RunParameters& parameters,
                                    std::shared_ptr<const TriangleSoup> input, const Journal& recorded) {
  if (recorded.operations().empty()) return std::nullopt;
  const Operation& first = recorded.operations()[0];
  const Event e = recorded.events()[first.event];
  const std::string words = recorded.texts()[e.text];
  if (e.kind != EventKind::start || !words.starts_with(start_words)) return std::nullopt;
  TileStart start;
  start.parameters = parameters;
  start.input = std::move(input);
  start.box = {e.point, e.witness};
  start.words = words.substr(start_words.size());
  for (std::size_t i = 0; i < first.event; ++i)
    if (tells_kept_point(recorded, recorded.events()[i])) start.kept.push_back(recorded.events()[i].point);
  Complex complex;
  complex.apply(first.delta());
  start.z = triangulate(extract_zero_set(complex));
  return start;
}

TileRun::TileRun(TileStart start, std::shared_ptr<Journal> journal, Gate& gate, RunControl& control)
    : start_(std::move(start)), journal_(std::move(journal)), gate_(gate), control_(control),
      preparation_(start_.parameters, control) {}

Result<std::shared_ptr<const Scene>> TileRun::prepare() {
  auto scene = preparation_.make(start_.input, {}, ThinParts::accept);
  if (!scene) return scene;
  scene_ = *scene;
  journal_->add_sample_set(scene_->samples);
  journal_->add_parameters(start_.parameters.criteria(scene_->delta, scene_->default_sigma));
  return scene;
}

Result<RunResult> TileRun::run() {
  const Stopwatch watch;
  const CriteriaParameters criteria = start_.parameters.criteria(scene_->delta, scene_->default_sigma);
  std::vector<Triangle3> near = facets_of(*start_.input);
  keep_meeting(near, Box3{start_.box.lo, start_.box.hi}.grown(tile_input_reach * scene_->delta));
  const TileGround omega(std::move(near), scene_->delta, start_.kept, start_.box, all_memory, control_);
  Recorder recorder(*journal_, gate_);
  StageLog log(recorder, control_);
  log.begin(Stage::improve);
  for (const Vec3 p : start_.kept) {
    Event e;
    e.kind = EventKind::warning;
    e.point = p;
    e.text = journal_->add_text(std::string(kept_words));
    log.event(e);
  }
  Complex z;
  Delta delta = free_start(start_.z);
  z.apply(delta);
  Event e;
  e.kind = EventKind::start;
  e.count = static_cast<std::uint32_t>(delta.added_vertices.size());
  e.point = start_.box.lo;
  e.witness = start_.box.hi;
  e.text = journal_->add_text(std::string(start_words) + start_.words);
  StepFigures figures;
  figures.zero_set_vertices = e.count;
  figures.smallest_height = std::numeric_limits<float>::infinity();
  log.operation(e, std::move(delta), figures);
  if (!control_.cancelled() && !log.stopped())
    improve_free_piece(z, omega.ground(), tile_options(criteria, start_.parameters.effort), log);
  log.end();
  RunResult result;
  if (log.stopped()) result.end = control_.timed_out() ? RunResult::End::limit : RunResult::End::stopped;
  result.last_stage = Stage::improve;
  result.form = z.form;
  result.mesh = triangulate(extract_zero_set(z));
  result.certificate =
      certify(result.mesh, preparation_.volume(), scene_->expected, control_,
              {start_.parameters.cover, start_.parameters.topology == TopologyMode::separate, true});
  result.crumbs = count_small_parts(result.mesh, crumb_size * scene_->delta);
  result.normals = measure_normal_deviation(result.mesh, preparation_.volume(), control_);
  result.seconds = watch.seconds();
  result.peak_memory_bytes = peak_memory_bytes();
  return result;
}

Result<bool> is_as_made(const TriangleMesh& mesh, const TileFolder& folder, const TileRound& round,
                        std::size_t tile) {
  const GridPlace& place = round.tiles[tile].tile;
  std::vector<Triangle3> made;
  if (Status read = read_facets(folder.output(round.number, place), all_of_space, made); !read)
    return read.error();
  std::vector<Triangle3> own = facets_of(mesh);
  keep_own(own, folder.grid(), round.tiling, place);
  make_canonical(own);
  make_canonical(made);
  return own == made;
}

Result<RecordedTile> record_tile(const TileFolder& folder, const TileRound& round, std::size_t tile,
                                 const std::filesystem::path& recording, RunControl& control,
                                 const std::function<void()>& begun) {
  control.report("the tile", -1);
  auto start = tile_start(folder, round, tile);
  if (!start) return start.error();
  auto writer = RecordingWriter::create(recording);
  if (!writer) return writer.error();
  auto journal = std::make_shared<Journal>();
  TellingGate gate(**writer, begun);
  TileRun run(std::move(*start), journal, gate, control);
  const auto scene = run.prepare();
  if (!scene) return scene.error();
  (*writer)->start(recording_header(run.start().parameters, (*scene)->input), journal);
  auto result = run.run();
  if (!result) return result.error();
  RecordedTile recorded;
  recorded.operations = journal->operations().size();
  std::error_code failed;
  if (std::filesystem::exists(folder.output(round.number, round.tiles[tile].tile), failed) &&
      result->end == RunResult::End::finished) {
    const auto same = is_as_made(result->mesh, folder, round, tile);
    if (same) recorded.as_made = *same;
  }
  (*writer)->end([&, scene] { return recording_end(run.start().parameters, **scene, *result, *journal); });
  if (Status written = (*writer)->finish(); !written) return written.error();
  gate.tell();
  recorded.result = std::move(*result);
  return recorded;
}

Result<ReplayVerdict> check_tile_replay(TileStart start, const Journal& recorded, bool ended,
                                        RunControl& control) {
  if (!ended)
    return Error{ErrorCode::usage, "The run of this tile did not come to its end.",
                 "Record the tile anew: isoscope-run tiles rerun."};
  auto journal = std::make_shared<Journal>();
  PassingGate gate;
  TileRun run(std::move(start), journal, gate, control);
  if (const auto scene = run.prepare(); !scene) return scene.error();
  if (const auto result = run.run(); !result) return result.error();
  if (control.cancelled()) return Error{ErrorCode::cancelled, "The check was stopped.", ""};
  return compare_journals(recorded, *journal);
}

} // namespace isoscope
