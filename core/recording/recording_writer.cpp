// One transaction a commit: rows of the journal, then how far it went and the checksum.
#include "recording/recording_writer.h"

#include "base/pending_file.h"
#include "recording/database.h"
#include "recording/delta_codec.h"
#include "recording/geometry_codec.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

/// Statements of the tables that grow.
struct Statements {
  Query event, operation, sample_set, criteria, text, repair, sweep, mark, commit, ending;
};

Status prepare(Database& database, Query& query, std::string_view statement) {
  auto prepared = database.prepare(statement);
  if (!prepared) return prepared.error();
  query = std::move(*prepared);
  return {};
}

template <class Name> Status write_names(Database& database, const char* statement, int count, Name name_of) {
  auto query = database.prepare(statement);
  if (!query) return query.error();
  for (int i = 0; i < count; ++i)
    if (Status s = query->run(i, name_of(i)); !s) return s;
  return {};
}

Status write_all_names(Database& database) {
  if (Status s = write_names(database, "INSERT INTO kinds VALUES(?,?)", event_kind_count,
                             [](int i) { return name(static_cast<EventKind>(i)); });
      !s)
    return s;
  if (Status s = write_names(database, "INSERT INTO stages VALUES(?,?)", stage_count,
                             [](int i) { return name(static_cast<Stage>(i)); });
      !s)
    return s;
  if (Status s = write_names(database, "INSERT INTO conditions VALUES(?,?)", condition_count,
                             [](int i) { return name(static_cast<Condition>(i)); });
      !s)
    return s;
  return write_names(database, "INSERT INTO reasons VALUES(?,?)", reason_count,
                     [](int i) { return name(static_cast<Reason>(i)); });
}

/// Takes an older recording away; refuses to touch anything else.
Status clear_place(const fs::path& file) {
  std::error_code failure;
  if (!fs::exists(file, failure)) return {};
  if (fs::is_directory(file, failure))
    return Error{ErrorCode::io, "Cannot record to " + file.string() + ": it is a folder.",
                 "Give a file in it."};
  const Error foreign{ErrorCode::usage, file.string() + " exists and is not a recording.",
                      "Give another file, or remove it."};
  if (!fs::is_regular_file(file, failure)) return foreign;
  if (fs::file_size(file, failure) > 0) {
    auto database = Database::open(file, Database::Access::grow);
    if (!database) return database.error();
    const auto application = database->number("PRAGMA application_id");
    if (!application && application.error().code == ErrorCode::io) return application.error();
    if (!application || *application != recording_application_id) return foreign;
    // Leaving the write-ahead log needs the file alone: it fails while anybody uses it.
    if (Status alone = database->execute("PRAGMA busy_timeout=200; PRAGMA journal_mode=DELETE"); !alone)
      return Error{ErrorCode::io, file.string() + " is in use by another program.",
                   "Give another file, or wait until it has ended."};
  }
  if (!fs::remove(file, failure))
    return Error{ErrorCode::io, "Cannot replace " + file.string() + ": its folder is not writable.",
                 "Give another file."};
  return {};
}

/// -1 where an id is none: SQLite's NULL would cost as much and say less to a query.
std::int64_t number_of(std::uint32_t id) {
  return id == 0xffffffffu ? -1 : std::int64_t{id};
}

} // namespace

struct RecordingWriter::Impl {
  fs::path file;
  Options options;
  Database database;
  Statements statements;
  DeltaEncoder deltas;
  Digest checksum;
  RecordingCounts written;

  RecordingHeader header;
  std::shared_ptr<const Journal> journal;
  std::thread thread;

  mutable std::mutex mutex;
  std::condition_variable wake;
  // Under the mutex.
  RecordingProgress progress;
  bool quit = false;
  std::function<RecordingEnd()> describe_end;
  std::size_t end_events = 0;

  explicit Impl(Database d) : database(std::move(d)) {}

  Status make_tables() {
    // The tables are in the file itself before the write-ahead log begins: whoever finds the file alone knows
    // what it is. A lost disk would lose an empty file, so nobody waits for it here.
    Status made = database.execute("PRAGMA synchronous=OFF; BEGIN IMMEDIATE");
    if (made) made = database.execute(recording_schema);
    if (made) made = write_all_names(database);
    if (made)
      made = database.execute(("PRAGMA application_id=" + std::to_string(recording_application_id) +
                               "; PRAGMA user_version=" + std::to_string(recording_version) +
                               "; COMMIT; PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL")
                                  .c_str());
    // The first look in that mode takes the lock that tells others that the file is in use.
    if (made)
      if (const auto looked = database.number("SELECT count(*) FROM run"); !looked) return looked.error();
    return made;
  }

  Status prepare_statements() {
    const std::pair<Query*, std::string_view> all[] = {
        {&statements.event,
         "INSERT INTO event_rows VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"},
        {&statements.operation, "INSERT INTO operations VALUES(?,?,?,?,?,?,?,?,?)"},
        {&statements.sample_set, "INSERT INTO sample_sets VALUES(?,?,?,?)"},
        {&statements.criteria, "INSERT INTO criteria VALUES(?,?,?,?,?,?,?,?,?,?,?)"},
        {&statements.text, "INSERT INTO texts VALUES(?,?)"},
        {&statements.repair, "INSERT INTO repairs VALUES(?,?)"},
        {&statements.sweep, "INSERT INTO sweeps VALUES(?,?,?,?,?,?,?,?,?)"},
        {&statements.mark, "INSERT INTO stage_marks VALUES(?,?,?)"},
        {&statements.commit, "INSERT INTO commits(events,operations,texts,repairs,sample_sets,criteria,marks,"
                             "checksum) VALUES(?,?,?,?,?,?,?,?)"},
        {&statements.ending, "INSERT OR REPLACE INTO ending VALUES(1,?,?,?,?)"}};
    for (const auto& [query, statement] : all)
      if (Status s = prepare(database, *query, statement); !s) return s;
    return {};
  }

  /// What of the journal can be written now: whole operations, and nothing that speaks of a later event.
  RecordingCounts available() const {
    const Journal& j = *journal;
    RecordingCounts counts = written;
    const std::size_t events = std::min(j.events().size(), written.events + options.events_per_commit);
    const std::size_t operations = j.operations().size();
    for (; counts.events < events; ++counts.events) {
      if (!j.events()[counts.events].operation) continue;
      if (counts.operations >= operations) break; // its operation is on its way
      ++counts.operations;
    }
    // These are put there before the event that names them.
    counts.texts = j.texts().size();
    counts.repairs = j.repairs().size();
    counts.sample_sets = j.sample_sets().size();
    while (counts.criteria < j.parameters().size() &&
           j.parameters()[counts.criteria].step <= counts.operations)
      ++counts.criteria;
    while (counts.marks < j.stage_marks().size() && j.stage_marks()[counts.marks].event < counts.events)
      ++counts.marks;
    return counts;
  }

  Status write_header() {
    auto run = database.prepare("INSERT INTO run VALUES(?,?)");
    if (!run) return run.error();
    if (Status s = run->run("program", header.program); !s) return s;
    if (Status s = run->run("parameters", header.parameters); !s) return s;
    auto input = database.prepare("INSERT INTO input VALUES(1,?,?,?,?,?)");
    if (!input) return input.error();
    const TriangleSoup& soup = *header.input;
    return input->run(soup.name, soup.points.size(), soup.triangles.size(), digest_text(digest(soup)),
                      Blob{encode(soup, header.notes)});
  }

  Status write_event(std::size_t i) {
    const Event& e = journal->events()[i];
    checksum.add(e);
    return statements.event.run(
        i, e.step, static_cast<int>(e.kind), static_cast<int>(e.stage), static_cast<int>(e.condition),
        static_cast<int>(e.reason), e.operation, number_of(e.tet.value), number_of(e.sample.value),
        number_of(e.vertex.value), number_of(e.other.value), e.point.x, e.point.y, e.point.z, e.witness.x,
        e.witness.y, e.witness.z, e.value, e.limit, e.count, e.text, e.detail, number_of(e.facet[0].value),
        number_of(e.facet[1].value), number_of(e.facet[2].value));
  }

  Status write_operation(std::size_t step) {
    const Operation& o = journal->operations()[step];
    const std::string_view bytes = deltas.encode(o.delta());
    const StepFigures& f = o.figures;
    checksum.add(bytes);
    add_to(checksum, f);
    return statements.operation.run(step, o.event, f.bad_samples, f.zero_set_vertices, f.tets,
                                    f.largest_error, f.smallest_height, f.seconds, Blob{bytes});
  }

  Status write_sample_set(std::size_t i) {
    const auto& set = journal->sample_sets()[i];
    const BoundarySamples nothing;
    const std::string bytes = encode(set ? *set : nothing);
    checksum.add(std::string_view(bytes));
    return statements.sample_set.run(i, set ? set->size() : 0, set ? set->sigma : 0.0, Blob{bytes});
  }

  Status write_criteria(std::size_t i) {
    const Journal::ParameterRecord& record = journal->parameters()[i];
    const CriteriaParameters& c = record.criteria;
    add_to(checksum, record);
    return statements.criteria.run(i, record.step, c.delta, c.sigma, c.alpha, c.shrink, c.certified,
                                   c.condition_1, c.condition_2, c.condition_3, c.condition_4);
  }

  Status write_repair(std::size_t i) {
    const RepairDetail& sweeps = journal->repairs()[i];
    checksum.add(sweeps.size());
    if (Status s = statements.repair.run(i, sweeps.size()); !s) return s;
    for (std::size_t k = 0; k < sweeps.size(); ++k) {
      const RepairSweep& w = sweeps[k];
      checksum.add(w);
      if (Status s = statements.sweep.run(i, k, w.largest_distance, w.energy, w.moved, w.flipped,
                                          w.points_added, w.distance_left, Blob{encode(w.worst_facet)});
          !s)
        return s;
    }
    return {};
  }

  Status write_rows(const RecordingCounts& to) {
    for (std::size_t i = written.sample_sets; i < to.sample_sets; ++i)
      if (Status s = write_sample_set(i); !s) return s;
    for (std::size_t i = written.criteria; i < to.criteria; ++i)
      if (Status s = write_criteria(i); !s) return s;
    for (std::size_t i = written.texts; i < to.texts; ++i) {
      checksum.add(std::string_view(journal->texts()[i]));
      if (Status s = statements.text.run(i, journal->texts()[i]); !s) return s;
    }
    for (std::size_t i = written.repairs; i < to.repairs; ++i)
      if (Status s = write_repair(i); !s) return s;
    for (std::size_t i = written.marks; i < to.marks; ++i) {
      const Journal::StageMark& mark = journal->stage_marks()[i];
      add_to(checksum, mark);
      if (Status s = statements.mark.run(i, mark.event, mark.seconds); !s) return s;
    }
    std::size_t step = written.operations;
    for (std::size_t i = written.events; i < to.events; ++i) {
      if (Status s = write_event(i); !s) return s;
      if (!journal->events()[i].operation) continue;
      if (Status s = write_operation(step++); !s) return s;
    }
    return statements.commit.run(to.events, to.operations, to.texts, to.repairs, to.sample_sets, to.criteria,
                                 to.marks, digest_text(checksum.value()));
  }

  Status transaction(const std::function<Status()>& write) {
    if (Status begun = database.execute("BEGIN IMMEDIATE"); !begun) return begun;
    Status done = write();
    if (done) done = database.execute("COMMIT");
    // After some errors SQLite has rolled back already, and this says so: the first error counts.
    if (!done && !database.execute("ROLLBACK").ok()) return done;
    return done;
  }

  /// Commits until nothing is left to write.
  Status catch_up() {
    for (;;) {
      const RecordingCounts to = available();
      if (to == written) return {};
      if (Status s = transaction([&] { return write_rows(to); }); !s) return s;
      const bool more = to.events - written.events == options.events_per_commit;
      written = to;
      note_progress();
      if (!more) return {};
    }
  }

  Status write_end(const RecordingEnd& end, std::size_t events) {
    return transaction([&] { return statements.ending.run(events, end.state, end.certified, end.report); });
  }

  void note_progress() {
    std::error_code none;
    std::uint64_t bytes = fs::file_size(file, none);
    if (none) bytes = 0;
    const std::uint64_t log = fs::file_size(file.string() + "-wal", none);
    const std::lock_guard lock(mutex);
    progress.bytes = bytes + (none ? 0 : log);
    progress.events = written.events;
  }

  Status work() {
    if (Status s = prepare_statements(); !s) return s;
    if (Status s = transaction([this] { return write_header(); }); !s) return s;
    if (Status s = catch_up(); !s) return s;
    for (;;) {
      std::function<RecordingEnd()> describe;
      std::size_t events = 0;
      bool last = false;
      {
        std::unique_lock lock(mutex);
        wake.wait_for(lock, options.interval, [this] { return quit || describe_end; });
        describe = std::exchange(describe_end, nullptr);
        events = end_events;
        last = quit;
      }
      if (Status s = catch_up(); !s) return s;
      if (describe) {
        if (Status s = write_end(describe(), events); !s) return s;
      }
      if (last) break;
    }
    statements = {};
    // One file without a log beside it: it opens from any medium and can be copied as it is.
    // While a reader has it open this is refused, and the last reader does it.
    [[maybe_unused]] const Status alone =
        database.execute("PRAGMA busy_timeout=200; PRAGMA journal_mode=DELETE");
    note_progress();
    return {};
  }

  /// The whole life of the writer's thread; nothing may escape from it.
  void live() {
    Status ended;
    try {
      ended = work();
    } catch (const std::bad_alloc&) {
      ended = Error{ErrorCode::io, "Memory is exhausted: " + file.string() + " is not written further.", ""};
    }
    if (ended) return;
    const std::lock_guard lock(mutex);
    progress.error = ended.error();
  }

  void join() {
    {
      const std::lock_guard lock(mutex);
      quit = true;
    }
    wake.notify_all();
    if (thread.joinable()) thread.join();
  }
};

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const fs::path& file) {
  return create(file, Options());
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const fs::path& named, Options options) {
  const fs::path file = behind_links(named); // a link stays where it is
  if (Status cleared = clear_place(file); !cleared) return cleared.error();
  auto database = Database::open(file, Database::Access::create);
  if (!database) return database.error();
  auto impl = std::make_unique<Impl>(std::move(*database));
  impl->file = file;
  impl->progress.file = file;
  impl->options = options;
  if (Status made = impl->make_tables(); !made) {
    impl.reset();
    std::error_code failure;
    fs::remove(file, failure);
    return made.error();
  }
  impl->note_progress();
  return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(impl)));
}

RecordingWriter::~RecordingWriter() {
  const bool was_started = started();
  impl_->join();
  const fs::path file = impl_->file;
  impl_.reset();
  std::error_code failure;
  if (!was_started) fs::remove(file, failure);
}

void RecordingWriter::start(RecordingHeader header, std::shared_ptr<const Journal> journal) {
  impl_->header = std::move(header);
  impl_->journal = std::move(journal);
  impl_->thread = std::thread([impl = impl_.get()] { impl->live(); });
}

bool RecordingWriter::started() const {
  return impl_->journal != nullptr;
}

void RecordingWriter::end(std::function<RecordingEnd()> describe) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->describe_end = std::move(describe);
    impl_->end_events = impl_->journal->events().size();
  }
  impl_->wake.notify_all();
}

Status RecordingWriter::finish() {
  impl_->join();
  const std::lock_guard lock(impl_->mutex);
  if (impl_->progress.error) return *impl_->progress.error;
  return {};
}

RecordingProgress RecordingWriter::progress() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->progress;
}

} // namespace isoscope
