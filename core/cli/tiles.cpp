// The parts of a run in tiles, each of which may be a program of its own on any machine that sees the folder.
#include "cli/tiles.h"

#include "base/numbers.h"
#include "base/parallel.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/interruptible.h"
#include "cli/options.h"
#include "cli/progress_line.h"
#include "cli/summary.h"
#include "cli/verbs.h"
#include "run/report.h"
#include "tiles/tile_join.h"
#include "tiles/tile_progress.h"
#include "tiles/tile_run.h"
#include "tiles/tile_work.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace isoscope {
namespace {

/// What a part of a run in tiles is done under: threads, signals and a line of progress.
class Work {
 public:
  Work(unsigned threads, bool quiet) : threads_(threads), signals_(control), progress_(!quiet) {
    control.on_progress([this](std::string_view part, double fraction) { progress_.part(part, fraction); });
  }
  RunControl control;
  int ended(const Error& error) {
    progress_.finish();
    return fail(error);
  }
  void finish() { progress_.finish(); }

 private:
  ThreadLimit threads_;
  Interruptible signals_;
  ProgressLine progress_;
};

/// What is left once all tiles are there.
int deliver(const TileFolder& folder, const Outputs& outputs, bool quiet, Work& work) {
  const auto joined = join_tiles(folder, outputs.mesh, work.control);
  if (!joined) return work.ended(joined.error());
  work.finish();
  const auto note = [](const std::string& text) {
    std::fprintf(stderr, "isoscope-run: note: %s\n", text.c_str());
  };
  for (const ParameterWarning& w : joined->scene->warnings) note(w.message);
  if (!joined->scene->thickening_note.empty()) note(joined->scene->thickening_note);
  const RunResult& result = joined->result;
  int status = result.exit_status();
  const bool to_stdout = outputs.report == "-";
  if (!outputs.report.empty()) {
    const std::string text = report_json(joined->parameters, *joined->scene, result, {});
    Status written = to_stdout ? print(text) : write_text_file(outputs.report, text);
    if (!written) status = fail(written.error(), 1);
  }
  if (quiet || to_stdout) {
    for (const std::string& warning : warnings(joined->parameters, *joined->scene, result, false))
      note(warning);
  } else if (Status written = print(summary(joined->parameters, *joined->scene, result, {}, "")); !written) {
    status = fail(written.error(), 1);
  }
  return status;
}

int cut(int argc, char** argv) {
  CommandLine app{
      "Cuts a closed input that is free of intersections into tiles, which isoscope-run tiles step "
      "improves one by one, in any order, in any number of programs.",
      "isoscope-run tiles cut"};
  RunOptions options(app);
  std::string folder, memory = usual_tile_memory;
  bool quiet = false;
  app.option("FOLDER", folder, "where the tiles go; made where it is not there", true);
  app.option("--tile-memory", memory, tile_memory_help);
  app.flag("--quiet", quiet, "print nothing but warnings and errors");
  app.exit_status("0 the tiles are there; 1 they cannot be written; 2 usage, or an input that is no closed "
                  "surface free of intersections; 3 bad input; 4 stopped.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  const auto parameters = options.finish();
  if (!parameters) return fail(parameters.error(), 2);
  if (!options.recording().empty() || !options.breakpoints().empty())
    return fail({ErrorCode::usage, "A run in tiles has no journal to record or to break at.",
                 "Leave --record and --break out."},
                2);
  const auto bytes = read_bytes(memory);
  if (!bytes) return fail(bytes.error(), 2);
  Work work(parameters->threads, quiet);
  work.control.cancel_after(parameters->time_limit);
  const auto made = cut_into_tiles(*parameters, folder, *bytes, work.control);
  if (!made) return work.ended(made.error());
  const auto round = made->round();
  if (!round) return work.ended(round.error());
  work.finish();
  if (quiet || !*round) return 0;
  const Status printed = print(line("Tiles", grouped(made->manifest().triangles) + " triangles, " +
                                                 counted((*round)->tiles.size(), "tile") + " in round 1"));
  return printed ? 0 : fail(printed.error(), 1);
}

Result<std::size_t> read_tile(const std::string& text) {
  const auto number = read_number<std::size_t>(text);
  if (number) return *number;
  return Error{ErrorCode::usage, "--tile is " + text + ", which is no number.", "Tiles count from 0."};
}

int step(int argc, char** argv) {
  CommandLine app{
      "Improves tiles of a folder: one, those of the round at hand, or all there are until the end. "
      "Programs that do the same tile at once do no harm; one that is killed loses the tile in hand.",
      "isoscope-run tiles step"};
  std::string folder, tile;
  unsigned threads = 0;
  bool quiet = false;
  app.option("FOLDER", folder, "of isoscope-run tiles cut", true);
  app.option(
      "--tile", tile,
      "the number of a tile of the round at hand, from 0 on, as isoscope-run tiles status counts them; "
      "one that is there already, or that the round has not, is no error. Without it all tiles of all "
      "rounds are made");
  app.option("--threads", threads, "number of threads, 0 for all cores; the result does not depend on it");
  app.flag("--quiet", quiet, "print nothing but warnings and errors");
  app.exit_status("0 made; 1 a file cannot be written; 2 usage; 3 a file is damaged; 4 stopped.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  const auto found = TileFolder::open(folder);
  if (!found) return fail(found.error());
  Work work(threads, quiet);
  Status made;
  if (tile.empty()) {
    made = make_all_tiles(*found, work.control);
  } else {
    const auto number = read_tile(tile);
    if (!number) return fail(number.error(), 2);
    const auto round = found->round();
    if (!round) return work.ended(round.error());
    if (*round && *number < (*round)->tiles.size())
      made = make_tile_if_missing(*found, **round, *number, work.control);
  }
  if (!made) return work.ended(made.error());
  work.finish();
  return 0;
}

int rerun(int argc, char** argv) {
  CommandLine app{"Makes a tile of a round once more, as a run with a journal, and records it: "
                  "all of Z is there, and one tile of it changes. The tiles stay as they are. Ω and the "
                  "certificate are of the whole input, which has to fit into the memory.",
                  "isoscope-run tiles rerun"};
  std::string folder, tile, recording;
  unsigned threads = 0, number_of_round = 0;
  bool quiet = false;
  app.option("FOLDER", folder, "of isoscope-run tiles cut", true);
  app.option("--tile", tile, "the number of the tile, from 0 on", true);
  app.option("--round", number_of_round,
             "the number of the round, from 1 on; without it the one that was begun last");
  app.option("--record", recording, "where the recording goes: RUN.isorun", true);
  app.option("--threads", threads, "number of threads, 0 for all cores");
  app.flag("--quiet", quiet, "print nothing but warnings and errors");
  app.exit_status(
      "0 recorded, and Z is as the tile's file has it where that is there; 1 it is not, or a file "
      "cannot be written; 2 usage; 3 a file is damaged; 4 stopped.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  const auto number = read_tile(tile);
  if (!number) return fail(number.error(), 2);
  const auto found = TileFolder::open(folder);
  if (!found) return fail(found.error());
  const auto last = found->last_begun();
  if (!last) return fail(last.error());
  TileRound round = last->value_or(TileRound());
  if (number_of_round > 0) {
    auto chosen = found->begun(number_of_round);
    if (!chosen) return fail(chosen.error(), 2);
    round = std::move(*chosen);
  }
  Work work(threads, quiet);
  const auto made = record_tile(*found, round, *number, recording, work.control);
  if (!made) return work.ended(made.error());
  work.finish();
  if (made->result.end != RunResult::End::finished) return 4;
  if (made->as_made == false)
    return fail({ErrorCode::internal, "Z is not what the tile's file has.",
                 "Was it made by another version of the program?"},
                1);
  if (quiet) return 0;
  const Status printed =
      print(line("Recording", recording + ": " + counted(made->operations, "operation") +
                                  (made->as_made ? ", the tile comes out as its file has it" : "")));
  return printed ? 0 : fail(printed.error(), 1);
}

int join(int argc, char** argv) {
  CommandLine app{"Joins the tiles of a folder once all are made, proves the mesh and writes it.",
                  "isoscope-run tiles join"};
  std::string folder;
  unsigned threads = 0;
  bool quiet = false;
  Outputs outputs;
  app.option("FOLDER", folder, "of isoscope-run tiles cut", true);
  app.option("-o,--output", outputs.mesh, "the resulting mesh: .off, .obj, .ply or .stl");
  app.option("--report", outputs.report, "the report as JSON; - for standard output");
  app.option("--threads", threads, "number of threads, 0 for all cores");
  app.flag("--quiet", quiet, "print nothing but warnings and errors");
  app.exit_status(
      "0 certified; 1 not certified, or a file cannot be written; 2 usage, or tiles are left; 3 a "
      "file is damaged; 4 stopped.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  const auto found = TileFolder::open(folder);
  if (!found) return fail(found.error());
  if (Status writable = check_outputs(outputs, found->manifest().parameters.input); !writable)
    return fail(writable.error(), 2);
  Work work(threads, quiet);
  return deliver(*found, outputs, quiet, work);
}

/// The tiles by state, why some failed, and the time that is left.
std::string told(const TileProgress& p) {
  std::string states = grouped(p.count(TileState::made)) + " of " + grouped(p.tiles.size()) + " made";
  for (const TileState state : {TileState::in_hand, TileState::lost, TileState::failed})
    if (p.count(state) > 0) states += ", " + grouped(p.count(state)) + " " + std::string(name(state));
  std::string text = line("Tiles", states);
  for (std::size_t i = 0; i < p.tiles.size(); ++i)
    if (p.tiles[i].state == TileState::failed)
      text += line("", "tile " + std::to_string(i) + " failed: " + p.tiles[i].words);
  if (const std::string left = time_left_words(p); !left.empty()) text += line("Left", left);
  return text;
}

int status(int argc, char** argv) {
  CommandLine app{"Tells how far the tiles of a folder are.", "isoscope-run tiles status"};
  std::string folder;
  bool count = false;
  app.option("FOLDER", folder, "of isoscope-run tiles cut", true);
  app.flag(
      "--count", count,
      "print one number: how many tiles the round at hand has, 0 when all rounds are done, for a job array");
  app.exit_status("0 told; 2 usage; 3 a file is damaged.");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  const auto found = TileFolder::open(folder);
  if (!found) return fail(found.error());
  const auto round = found->round();
  if (!round) return fail(round.error());
  std::string text;
  if (count) {
    text = std::to_string(*round ? (*round)->tiles.size() : 0) + "\n";
  } else if (!*round) {
    const auto rounds = found->complete_rounds();
    if (!rounds) return fail(rounds.error());
    text = line("Tiles", "done, " + counted(*rounds, "round"));
  } else {
    const TileRound& r = **round;
    text =
        line("Round",
             std::to_string(r.number) + ": " +
                 (r.tiling.whole
                      ? "all in one tile"
                      : "tiles of " +
                            general(std::ldexp(bricks_of_tile * found->manifest().brick, r.tiling.level), 4) +
                            ", moved by " + std::to_string(r.tiling.shift) + "/4") +
                 ", effort " + std::to_string(r.effort)) +
        line("Z", grouped(r.facets) + " facets before the round");
    const auto progress = progress_of(*found);
    if (!progress) return fail(progress.error());
    text += told(*progress);
  }
  const Status printed = print(text);
  return printed ? 0 : fail(printed.error(), 1);
}

const Verb parts[] = {
    {{"cut", "MODEL FOLDER --tolerance P", "cuts an input into tiles"}, cut},
    {{"step", "FOLDER [--tile K]", "improves tiles"}, step},
    {{"rerun", "FOLDER [--round N] --tile K --record RUN.isorun", "makes a tile once more and records it"},
     rerun},
    {{"join", "FOLDER -o OUT", "joins them, proves the mesh and writes it"}, join},
    {{"status", "FOLDER", "tells how far they are"}, status},
};

} // namespace

Result<double> read_bytes(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const std::string_view unit = end;
  double factor = 0;
  if (unit == "KiB") factor = std::exp2(10);
  if (unit == "MiB") factor = std::exp2(20);
  if (unit == "GiB") factor = std::exp2(30);
  if (unit == "TiB") factor = std::exp2(40);
  if (!(number > 0) || !std::isfinite(number) || factor == 0)
    return Error{ErrorCode::usage, "--tile-memory is " + text + ", which is no size.",
                 "Give it as 2GiB or 512MiB."};
  return number * factor;
}

int run_in_tiles(const RunParameters& parameters, const std::string& folder, const std::string& memory,
                 const Outputs& outputs, bool quiet) {
  const auto bytes = read_bytes(memory);
  if (!bytes) return fail(bytes.error(), 2);
  Work work(parameters.threads, quiet);
  work.control.cancel_after(parameters.time_limit);
  const bool cut_before = TileFolder::exists(folder);
  const auto found =
      cut_before ? TileFolder::open(folder) : cut_into_tiles(parameters, folder, *bytes, work.control);
  if (!found) return work.ended(found.error());
  if (cut_before && !is_run_of(*found, parameters, *bytes))
    return work.ended({ErrorCode::usage, folder + " has the tiles of another run.",
                       "Give what it was cut with, or another folder."});
  if (Status made = make_all_tiles(*found, work.control); !made) return work.ended(made.error());
  return deliver(*found, outputs, quiet, work);
}

int tiles(int argc, char** argv) {
  if (const auto status = run_verb(parts, argc, argv)) return *status;
  CommandLine app{"A run in tiles, in parts: the improving in bounded memory, in any number of programs and "
                  "on many machines.",
                  "isoscope-run tiles"};
  for (const Verb& part : parts) app.verb(part.told);
  if (const auto ended = app.parse(argc, argv)) return *ended;
  return fail({ErrorCode::usage, "Which part?", "cut, step, rerun, join or status; --help tells more."}, 2);
}

} // namespace isoscope
