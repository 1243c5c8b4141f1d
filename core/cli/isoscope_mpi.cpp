// The ranks of an MPI job improve the tiles of a folder: rank 0 deals them out, all of them work, and the
// files are all the state there is. The one program that knows MPI.
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "cli/command_line.h"
#include "cli/exit_status.h"
#include "cli/interruptible.h"
#include "run/report.h"
#include "tiles/tile_dealer.h"
#include "tiles/tile_work.h"

#include <mpi.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace isoscope;

constexpr int dealer = 0;
constexpr int order_tag = 1, outcome_tag = 2;
/// Waiting for a message must not take the core of a rank that works.
constexpr std::chrono::milliseconds between_looks{2};

/// What the dealer sends: one order for each answer, and among them that the tile at hand is to be left.
struct Order {
  enum class Kind : std::uint32_t { tile, leave_it, end };
  Kind kind = Kind::end;
  std::uint32_t round = 0;
  std::int32_t level = 0, shift = 0, whole = 0, effort = 1;
  GridPlace tile{};
  std::uint64_t facets = 0;
};

/// What a rank answers when it is free: how its tile ended; the first one that it is there.
struct Outcome {
  std::int32_t code = none;
  std::string message, remedy;
  static constexpr std::int32_t none = -1; ///< no error

  std::string bytes() const { return std::to_string(code) + '\0' + message + '\0' + remedy; }
  static Outcome of(const std::string& bytes) {
    const std::size_t first = bytes.find('\0'), second = bytes.find('\0', first + 1);
    return {std::stoi(bytes.substr(0, first)), bytes.substr(first + 1, second - first - 1),
            bytes.substr(second + 1)};
  }
  Status status() const {
    if (code == none) return {};
    return Error{static_cast<ErrorCode>(code), message, remedy};
  }
};

Outcome outcome_of(const Status& status) {
  if (status) return {};
  return {static_cast<std::int32_t>(status.error().code), status.error().message, status.error().remedy};
}

Order order_of(const TileRound& round) {
  return {Order::Kind::tile,          round.number, round.tiling.level,  round.tiling.shift,
          round.tiling.whole ? 1 : 0, round.effort, round.tiles[0].tile, round.tiles[0].facets};
}

TileRound round_of(const Order& order) {
  TileRound round;
  round.number = order.round;
  round.tiling = {order.level, order.shift, order.whole != 0};
  round.effort = order.effort;
  round.tiles = {{order.tile, order.facets}};
  return round;
}

/// Makes tiles on a thread of its own, so that messages are read meanwhile.
class TileMaker {
 public:
  TileMaker(const TileFolder& folder, const RunControl& control)
      : folder_(folder), control_(control), thread_([this] { work(); }) {}
  ~TileMaker() {
    {
      const std::lock_guard lock(mutex_);
      end_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }
  TileMaker(const TileMaker&) = delete;
  TileMaker& operator=(const TileMaker&) = delete;

  void make(TileRound alone) {
    {
      const std::lock_guard lock(mutex_);
      todo_ = std::move(alone);
    }
    wake_.notify_one();
  }
  /// How the tile ended, once.
  std::optional<Status> ended() {
    const std::lock_guard lock(mutex_);
    return std::exchange(ended_, std::nullopt);
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [&] { return end_ || todo_; });
      if (end_) return;
      const TileRound alone = *std::exchange(todo_, std::nullopt);
      lock.unlock();
      const Status made = make_tile_if_missing(folder_, alone, 0, control_);
      lock.lock();
      ended_ = made;
    }
  }

  const TileFolder& folder_;
  const RunControl& control_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<TileRound> todo_;
  std::optional<Status> ended_;
  bool end_ = false;
  std::thread thread_; ///< last: it uses all the others
};

std::string here() {
  char name[MPI_MAX_PROCESSOR_NAME] = "";
  int length = 0;
  MPI_Get_processor_name(name, &length);
  return name;
}

/// A message, where one has come.
std::optional<std::pair<int, std::string>> received(int source, int tag) {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(source, tag, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int count = 0;
  MPI_Get_count(&status, MPI_BYTE, &count);
  std::string bytes(static_cast<std::size_t>(count), '\0');
  MPI_Recv(bytes.data(), count, MPI_BYTE, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return std::pair(status.MPI_SOURCE, std::move(bytes));
}

void send(const Order& order, int rank) {
  MPI_Send(&order, sizeof order, MPI_BYTE, rank, order_tag, MPI_COMM_WORLD);
}

/// Deals until no tile is left, one could not be made, or somebody wants the end; ranks that are at a tile
/// then are told to leave it.
class Dealing {
 public:
  Dealing(const TileFolder& folder, int ranks, RunControl& control, bool quiet)
      : dealing_(folder), control_(control), own_(folder, control), quiet_(quiet),
        at_work_(static_cast<std::size_t>(ranks), false), here_(ranks), free_{dealer} {}

  Status run() {
    while (here_ > 0) {
      bool still = !look();
      if (control_.cancelled() && !error_)
        error_ = {ErrorCode::cancelled, "The job was stopped.",
                  "What is done is kept: go on with the same folder."};
      if (error_) recall();
      while (!free_.empty() && serve(free_.back())) {
        free_.pop_back();
        still = false;
      }
      if (still) std::this_thread::sleep_for(between_looks);
    }
    if (error_) return *error_;
    return {};
  }

 private:
  /// Takes what ranks have answered; false where nobody has.
  bool look() {
    bool any = false;
    if (const auto ended = own_.ended()) {
      take(dealer, *ended);
      any = true;
    }
    while (const auto answer = received(MPI_ANY_SOURCE, outcome_tag)) {
      take(answer->first, Outcome::of(answer->second).status());
      any = true;
    }
    return any;
  }
  void take(int rank, const Status& made) {
    const auto at = static_cast<std::size_t>(rank);
    if (at_work_[at]) dealing_.done(); // else it says that it is there
    at_work_[at] = false;
    free_.push_back(rank);
    if (made || error_) return;
    const Error& why = made.error();
    error_ = {why.code, why.message + " (Rank " + std::to_string(rank) + ".)", why.remedy};
  }
  /// Tells all that are at a tile to leave it.
  void recall() {
    if (std::exchange(recalled_, true)) return;
    control_.cancel();
    for (std::size_t rank = 1; rank < at_work_.size(); ++rank)
      if (at_work_[rank]) send({.kind = Order::Kind::leave_it}, static_cast<int>(rank));
  }
  /// Gives a free rank what is next; false where there is nothing at present.
  bool serve(int rank) {
    if (!error_ && !dealing_.finished()) {
      const auto dealt = dealing_.deal();
      if (dealt && *dealt) {
        give(rank, **dealt);
        return true;
      }
      if (!dealt) error_ = dealt.error();
      if (!error_ && !dealing_.finished()) return false;
    }
    if (rank != dealer) send({.kind = Order::Kind::end}, rank);
    --here_;
    return true;
  }
  void give(int rank, const TileRound& alone) {
    tell(alone.number);
    at_work_[static_cast<std::size_t>(rank)] = true;
    if (rank == dealer)
      own_.make(alone);
    else
      send(order_of(alone), rank);
  }
  void tell(std::uint32_t round) {
    if (quiet_ || round == told_) return;
    told_ = round;
    static_cast<void>(
        print(line("Round", std::to_string(round) + ": " + counted(dealing_.round().tiles.size(), "tile") +
                                ", " + grouped(dealing_.round().facets) + " facets of Z")));
  }

  TileDealer dealing_;
  RunControl& control_;
  TileMaker own_;
  bool quiet_, recalled_ = false;
  std::vector<bool> at_work_; ///< by rank
  int here_;                  ///< ranks that have not been told the end
  std::vector<int> free_;
  std::optional<Error> error_;
  std::uint32_t told_ = 0;
};

/// Makes what the dealer sends until it sends the end.
void serve(const std::string& path, unsigned threads, RunControl& control) {
  const auto answer = [](const Status& status) {
    const std::string bytes = outcome_of(status).bytes();
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, dealer, outcome_tag, MPI_COMM_WORLD);
  };
  const ThreadLimit limit(threads);
  const auto folder = TileFolder::open(path);
  std::optional<TileMaker> maker;
  if (folder) {
    maker.emplace(*folder, control);
    answer({});
  } else {
    answer(Error{folder.error().code, "On " + here() + ": " + folder.error().message, folder.error().remedy});
  }
  for (;;) {
    if (const auto made = maker ? maker->ended() : std::nullopt) answer(*made);
    const auto message = received(dealer, order_tag);
    if (!message) {
      std::this_thread::sleep_for(between_looks);
      continue;
    }
    Order order;
    std::memcpy(&order, message->second.data(), sizeof order);
    if (order.kind == Order::Kind::end) return;
    if (order.kind == Order::Kind::leave_it)
      control.cancel();
    else
      maker->make(round_of(order));
  }
}

int work(const std::string& path, unsigned threads, bool quiet) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  RunControl control;
  const Interruptible signals(control);
  // One rank alone says what is wrong with the folder.
  std::optional<TileFolder> folder;
  int status = 0;
  if (rank == dealer) {
    auto found = TileFolder::open(path);
    if (found)
      folder = std::move(*found);
    else
      status = fail(found.error());
  }
  int wrong = status;
  MPI_Bcast(&wrong, 1, MPI_INT, dealer, MPI_COMM_WORLD);
  if (wrong != 0) return status;
  if (rank != dealer) {
    serve(path, threads, control);
    return 0;
  }
  const Stopwatch watch;
  const ThreadLimit limit(threads);
  Dealing dealing(*folder, ranks, control, quiet);
  if (const Status made = dealing.run(); !made) return fail(made.error());
  if (quiet) return 0;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f s", watch.seconds());
  const Status printed =
      print(line("Tiles", "done, " + counted(std::size_t(ranks), "rank") + ", " + seconds));
  return printed ? 0 : fail(printed.error(), 1);
}

int run(int argc, char** argv) {
  CommandLine app{
      "Improves the tiles of a folder by the ranks of an MPI job, which all see the folder: mpirun -n 8 "
      "isoscope-mpi FOLDER. A job that is killed loses the tiles in hand; the same line goes on.",
      "isoscope-mpi"};
  std::string folder;
  unsigned threads = 1;
  bool quiet = false;
  app.option("FOLDER", folder, "of isoscope-run tiles cut, on a file system that all ranks share", true);
  app.option(
      "--threads", threads,
      "number of threads of each rank, 0 for all cores; default 1; the result depends neither on it nor "
      "on the number of ranks");
  app.flag("--quiet", quiet, "print nothing but errors");
  app.version("isoscope-mpi " + std::string(version()));
  app.notes("The mesh is joined, proven and written by isoscope-run tiles join FOLDER -o OUT, as after "
            "isoscope-run tiles step, which may work on the same folder meanwhile.");
  app.exit_status(
      "0 all tiles are made; 1 a file cannot be written; 2 usage; 3 a file is damaged; 4 stopped.");
  app.see_also("isoscope-run-tiles");
  if (const auto ended = app.parse(argc, argv)) return *ended;
  if (Status whole = app.check_values(); !whole) return fail(whole.error(), 2);
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  const int status = work(folder, threads, quiet);
  MPI_Finalize();
  return status;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "isoscope-mpi: internal error: %s\n", e.what());
  }
  return 1;
}
