// Commit by commit: rows, their checksum, and only then the journal.
#include "recording/recording_reader.h"

#include "recording/commit_batch.h"
#include "recording/database.h"
#include "recording/delta_codec.h"
#include "recording/file_checks.h"
#include "recording/geometry_codec.h"

#include <vector>

namespace isoscope {

namespace {

namespace fs = std::filesystem;
using Access = Database::Access;

template <class Enum> bool read_enum(std::int64_t number, int count, Enum& value) {
  if (number < 0 || number >= count) return false;
  value = static_cast<Enum>(number);
  return true;
}

} // namespace

struct RecordingReader::Impl {
  fs::path file;
  Access access = Access::grow;
  Database database;
  RecordingHeader header;
  std::uint64_t input_digest = 0;
  Query commits, events, operations, sample_sets, criteria, texts, repairs, sweeps, marks;
  DeltaDecoder deltas;
  Digest checksum, proven; ///< of what was read, after the last commit
  RecordingCounts read;
  std::int64_t last_commit = 0;
  std::size_t next_criteria = 0; ///< of `waiting`
  std::vector<Journal::ParameterRecord> waiting;
  std::optional<Error> broken; ///< nothing can be read after it
  bool half_appended = false;  ///< in the middle of a commit, of which the journal has a part

  explicit Impl(Database d) : database(std::move(d)) {}

  Status prepare() {
    const auto version = database.number("PRAGMA user_version");
    if (!version) return version.error();
    const std::string facet = *version < 2 ? "-1,-1,-1" : "facet_a,facet_b,facet_c";
    const std::string event_columns =
        "SELECT kind,stage,condition,reason,operation,tet,sample,vertex,other,x,y,z,witness_x,witness_y,"
        "witness_z,value,limit_value,count,text,detail,step," +
        facet + " FROM event_rows WHERE id>=? AND id<? ORDER BY id";
    const std::pair<Query*, std::string_view> all[] = {
        {&commits,
         "SELECT id,events,operations,texts,repairs,sample_sets,criteria,marks,checksum FROM commits "
         "WHERE id>? ORDER BY id LIMIT 1"},
        {&events, event_columns},
        {&operations, "SELECT bad_samples,zero_set_vertices,tets,largest_error,smallest_height,seconds,delta "
                      "FROM operations WHERE step>=? AND step<? ORDER BY step"},
        {&sample_sets, "SELECT data FROM sample_sets WHERE id>=? AND id<? ORDER BY id"},
        {&criteria, "SELECT step,delta,sigma,alpha,shrink,certified,condition_1,condition_2,condition_3,"
                    "condition_4 FROM criteria WHERE id>=? AND id<? ORDER BY id"},
        {&texts, "SELECT text FROM texts WHERE id>=? AND id<? ORDER BY id"},
        {&repairs, "SELECT id,sweeps FROM repairs WHERE id>=? AND id<? ORDER BY id"},
        {&sweeps, "SELECT largest_distance,energy,moved,flipped,points_added,distance_left,worst_facet FROM "
                  "sweeps WHERE repair=? ORDER BY sweep"},
        {&marks, "SELECT event,seconds FROM stage_marks WHERE id>=? AND id<? ORDER BY id"}};
    for (const auto& [query, statement] : all) {
      auto prepared = database.prepare(statement);
      if (!prepared) return prepared.error();
      *query = std::move(*prepared);
    }
    return {};
  }

  Status read_header() {
    auto run = database.prepare("SELECT key,value FROM run");
    if (!run) return run.error();
    run->start();
    const Status told = run->each([&] {
      if (run->text(0) == "program") header.program = run->text(1);
      if (run->text(0) == "parameters") header.parameters = run->text(1);
      return true;
    });
    if (!told) return told;
    auto input = database.prepare("SELECT name,digest,data FROM input");
    if (!input) return input.error();
    input->start();
    const auto row = input->next();
    if (!row) return row.error();
    if (!*row)
      return Error{ErrorCode::bad_input, file.string() + " holds no run: it ended before the run began.",
                   "If the run is still being prepared, open it again in a moment."};
    auto soup = decode_soup(input->bytes(2), &header.notes);
    if (!soup || digest_text(digest(*soup)) != input->text(1))
      return damaged(file, "its input does not match the checksum");
    soup->name = input->text(0);
    input_digest = digest(*soup);
    header.input = std::make_shared<const TriangleSoup>(std::move(*soup));
    return {};
  }

  /// Calls `take` for each row of a query over a range of ids; the number of rows must be that of the range.
  template <class Take>
  Status rows(Query& query, std::size_t from, std::size_t to, const char* what, Take take) {
    query.start(from, to);
    std::size_t count = 0;
    bool sensible = true;
    const Status told = query.each([&] {
      sensible = count < to - from && take();
      count += sensible;
      return sensible;
    });
    if (!told) return told;
    if (!sensible) return damaged(file, std::string("a row of its ") + what + " makes no sense");
    if (count != to - from) return damaged(file, std::string("rows of its ") + what + " are missing");
    return {};
  }

  bool take_event(CommitBatch& batch) {
    Event e;
    if (!read_enum(events.integer(0), event_kind_count, e.kind) ||
        !read_enum(events.integer(1), stage_count, e.stage) ||
        !read_enum(events.integer(2), condition_count, e.condition) ||
        !read_enum(events.integer(3), reason_count, e.reason))
      return false;
    events.read(4, e.operation, e.tet, e.sample, e.vertex, e.other, e.point.x, e.point.y, e.point.z,
                e.witness.x, e.witness.y, e.witness.z, e.value, e.limit, e.count, e.text, e.detail, e.step,
                e.facet[0], e.facet[1], e.facet[2]);
    batch.events.push_back(e);
    return true;
  }

  bool take_operation(CommitBatch& batch) {
    StepFigures f;
    operations.read(0, f.bad_samples, f.zero_set_vertices, f.tets, f.largest_error, f.smallest_height,
                    f.seconds);
    batch.figures.push_back(f);
    batch.deltas.emplace_back(operations.bytes(6));
    return true;
  }

  bool take_criteria(CommitBatch& batch) {
    Journal::ParameterRecord r;
    CriteriaParameters& c = r.criteria;
    criteria.read(0, r.step, c.delta, c.sigma, c.alpha, c.shrink, c.certified, c.condition_1, c.condition_2,
                  c.condition_3, c.condition_4);
    batch.criteria.push_back(r);
    return true;
  }

  void take_mark(CommitBatch& batch) {
    Journal::StageMark mark;
    marks.read(0, mark.event, mark.seconds);
    batch.marks.push_back(mark);
  }

  Status read_repairs(CommitBatch& batch, std::size_t to) {
    std::vector<std::size_t> counts;
    if (Status s = rows(repairs, read.repairs, to, "repairs",
                        [&] {
                          counts.push_back(static_cast<std::size_t>(repairs.integer(1)));
                          return true;
                        });
        !s)
      return s;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      RepairDetail& detail = batch.repairs.emplace_back();
      sweeps.start(read.repairs + i);
      std::optional<Triangle3> facet(std::in_place);
      const Status told = sweeps.each([&] {
        RepairSweep w;
        sweeps.read(0, w.largest_distance, w.energy, w.moved, w.flipped, w.points_added, w.distance_left);
        facet = decode_triangle(sweeps.bytes(6));
        if (!facet) return false;
        w.worst_facet = *facet;
        detail.push_back(w);
        return true;
      });
      if (!told) return told;
      if (!facet) return damaged(file, "a facet of its repairs is cut off");
      if (detail.size() != counts[i]) return damaged(file, "sweeps of its repairs are missing");
    }
    return {};
  }

  Status read_rows(const RecordingCounts& to, CommitBatch& batch) {
    const auto all = [](auto take) {
      return [take] {
        take();
        return true;
      };
    };
    Status told = rows(sample_sets, read.sample_sets, to.sample_sets, "sample sets",
                       all([&] { batch.sample_sets.emplace_back(sample_sets.bytes(0)); }));
    if (told)
      told = rows(criteria, read.criteria, to.criteria, "parameters", [&] { return take_criteria(batch); });
    if (told)
      told = rows(texts, read.texts, to.texts, "texts", all([&] { batch.texts.push_back(texts.text(0)); }));
    if (told) told = read_repairs(batch, to.repairs);
    if (told) told = rows(marks, read.marks, to.marks, "stages", all([&] { take_mark(batch); }));
    if (told) told = rows(events, read.events, to.events, "events", [&] { return take_event(batch); });
    if (!told) return told;
    return rows(operations, read.operations, to.operations, "operations",
                [&] { return take_operation(batch); });
  }

  void add_criteria(Journal& journal) {
    while (next_criteria < waiting.size() && waiting[next_criteria].step <= journal.steps())
      journal.add_parameters(waiting[next_criteria++].criteria);
  }

  Status append(CommitBatch& batch, Journal& journal) {
    for (const std::string& bytes : batch.sample_sets) {
      auto samples = decode_samples(bytes);
      if (!samples) return damaged(file, "a sample set cannot be read");
      journal.add_sample_set(std::make_shared<const BoundarySamples>(std::move(*samples)));
    }
    // The first text and the first repair are there in every journal.
    for (std::size_t i = 0; i < batch.texts.size(); ++i)
      if (read.texts + i >= journal.texts().size()) journal.add_text(std::move(batch.texts[i]));
    for (std::size_t i = 0; i < batch.repairs.size(); ++i)
      if (read.repairs + i >= journal.repairs().size()) journal.add_repair(std::move(batch.repairs[i]));
    waiting.insert(waiting.end(), batch.criteria.begin(), batch.criteria.end());
    std::size_t mark = 0, step = 0;
    for (std::size_t i = 0; i < batch.events.size(); ++i) {
      const Event& e = batch.events[i];
      add_criteria(journal);
      if (e.step != journal.steps()) return damaged(file, "its steps are out of order");
      if (e.operation) {
        Delta delta;
        if (!deltas.decode(batch.deltas[step], delta)) return damaged(file, "an operation cannot be read");
        journal.add_operation(e, std::move(delta), batch.figures[step]);
        ++step;
        continue;
      }
      std::optional<double> seconds;
      if (mark < batch.marks.size() && batch.marks[mark].event == journal.events().size())
        seconds = batch.marks[mark++].seconds;
      journal.add_event(e, seconds);
    }
    add_criteria(journal);
    return {};
  }

  Result<bool> read_commit(Journal& journal) {
    if (broken) return *broken;
    commits.start(last_commit);
    const auto row = commits.next();
    if (!row) return fail(row.error(), journal);
    if (!*row) return false;
    const std::int64_t id = commits.integer(0);
    RecordingCounts to;
    std::size_t* const counts[] = {&to.events,      &to.operations, &to.texts, &to.repairs,
                                   &to.sample_sets, &to.criteria,   &to.marks};
    for (int i = 0; i < 7; ++i) *counts[i] = static_cast<std::size_t>(commits.integer(i + 1));
    const std::string expected = commits.text(8);
    CommitBatch batch;
    const Status read_all = read_rows(to, batch);
    commits.start(last_commit); // lets go of the row: no lock is held between two commits
    if (!read_all) return fail(read_all.error(), journal);
    if (!add_to(checksum, batch) || digest_text(checksum.value()) != expected)
      return fail(damaged(file, "what it holds does not match its checksum"), journal);
    if (Status appended = append(batch, journal); !appended) {
      half_appended = true;
      return fail(appended.error(), journal);
    }
    read = to;
    proven = checksum;
    last_commit = id;
    return true;
  }

  /// Lets go of the database that it had.
  Status change_to(Database other) {
    for (Query* query :
         {&commits, &events, &operations, &sample_sets, &criteria, &texts, &repairs, &sweeps, &marks})
      *query = Query();
    database = std::move(other);
    return prepare();
  }

  Result<bool> go_on_in(Database other) {
    if (half_appended) return *broken;
    if (Status changed = change_to(std::move(other)); !changed) return changed.error();
    broken.reset();
    checksum = proven;
    const Error another{ErrorCode::usage, file.string() + " holds another run now.",
                        "Open it again to see that one."};
    auto input = database.prepare("SELECT digest FROM input");
    if (!input) return input.error();
    input->start();
    const auto has_input = input->next();
    if (!has_input) return has_input.error();
    if (!*has_input) return false;
    if (input->text(0) != digest_text(input_digest)) return another;
    if (last_commit == 0) return true;
    commits.start(last_commit - 1);
    const auto row = commits.next();
    if (!row) return row.error();
    if (!*row || commits.integer(0) != last_commit) return false;
    const bool same = commits.text(8) == digest_text(proven.value());
    commits.start(last_commit);
    return same ? Result<bool>(true) : another;
  }

  /// Whether a query over a range of ids has the row of this one.
  bool has_row(Query& query, std::size_t id) {
    query.start(id, id + 1);
    const auto row = query.next();
    return row.ok() && *row;
  }

  /// Everything that events speak of, behind the last commit.
  void read_unproven_rest(Journal& journal, CommitBatch& rest) {
    for (std::size_t i = read.texts; has_row(texts, i); ++i)
      if (i >= journal.texts().size()) journal.add_text(texts.text(0));
    for (std::size_t i = read.sample_sets; has_row(sample_sets, i); ++i) {
      auto samples = decode_samples(sample_sets.bytes(0));
      if (!samples) break;
      journal.add_sample_set(std::make_shared<const BoundarySamples>(std::move(*samples)));
    }
    for (std::size_t i = read.criteria; has_row(criteria, i); ++i) take_criteria(rest);
    waiting.insert(waiting.end(), rest.criteria.begin(), rest.criteria.end());
    for (std::size_t i = read.marks; has_row(marks, i); ++i) take_mark(rest);
    for (;; ++read.repairs) {
      rest.repairs.clear();
      if (!read_repairs(rest, read.repairs + 1)) break;
      if (read.repairs >= journal.repairs().size()) journal.add_repair(std::move(rest.repairs.front()));
    }
  }

  void read_unproven(Journal& journal) {
    if (journal.events().size() != read.events) return; // a commit stopped in its middle
    CommitBatch rest;
    read_unproven_rest(journal, rest);
    std::size_t mark = 0;
    for (std::size_t i = read.events; has_row(events, i); ++i) {
      rest.events.clear();
      add_criteria(journal);
      if (!take_event(rest)) break;
      const Event& e = rest.events.front();
      const std::size_t step = journal.steps();
      if (e.step != step || e.text >= journal.texts().size() || e.detail >= journal.repairs().size()) break;
      if (!e.operation) {
        while (mark < rest.marks.size() && rest.marks[mark].event < i) ++mark;
        std::optional<double> seconds;
        if (mark < rest.marks.size() && rest.marks[mark].event == i) seconds = rest.marks[mark++].seconds;
        journal.add_event(e, seconds);
        continue;
      }
      rest.deltas.clear();
      rest.figures.clear();
      Delta delta;
      if (!has_row(operations, step) || !take_operation(rest) || !deltas.decode(rest.deltas.front(), delta))
        break;
      if (delta.sample_set && delta.sample_set->after >= journal.sample_sets().size()) break;
      journal.add_operation(e, std::move(delta), rest.figures.front());
    }
    add_criteria(journal);
    broken = Error{ErrorCode::internal, "What lies behind the last commit has been read already.", ""};
  }

  std::size_t events_behind(std::size_t event) {
    auto query = database.prepare("SELECT count(*) FROM event_rows WHERE id>=?");
    if (!query) return 0;
    query->start(event);
    const auto row = query->next();
    return row.ok() && *row ? static_cast<std::size_t>(query->integer(0)) : 0;
  }

  /// Nothing is read after an error; it tells how much is sound.
  Error fail(Error error, const Journal& journal) {
    if (error.code == ErrorCode::bad_input)
      error.remedy = "The " + std::to_string(journal.events().size()) +
                     " events before the damage are sound. " + error.remedy;
    broken = error;
    return error;
  }

  Result<std::optional<RecordingEnd>> end() {
    auto query = database.prepare("SELECT events,state,certified,report FROM ending");
    if (!query) return query.error();
    query->start();
    const auto row = query->next();
    if (!row) return row.error();
    if (!*row || static_cast<std::size_t>(query->integer(0)) != read.events)
      return std::optional<RecordingEnd>();
    return std::optional<RecordingEnd>({query->text(1), query->integer(2) != 0, query->text(3)});
  }

  /// Leaves the write-ahead log, which only the last user of the file can.
  bool alone() {
    if (access != Access::grow) return access == Access::frozen;
    const auto mode = database.word("PRAGMA journal_mode=DELETE");
    return mode.ok() && *mode == "delete";
  }
};

RecordingReader::RecordingReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RecordingReader::~RecordingReader() = default;

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const fs::path& file) {
  if (Status head = check_head(file); !head) return head.error();
  if (has_stale_log(file)) {
    auto pages = recording_over_pages(file, PageFile::Log::ignored);
    return pages ? over(std::move(*pages), file) : pages.error();
  }
  std::optional<Error> first;
  for (const Access access : {Access::grow, Access::read, Access::frozen}) {
    if (access == Access::frozen && fs::exists(file.string() + "-wal")) break;
    auto database = Database::open(file, access);
    if (!database) {
      if (!first) first = database.error();
      continue;
    }
    auto impl = std::make_unique<Impl>(std::move(*database));
    impl->file = file;
    impl->access = access;
    Status ready = impl->database.execute("PRAGMA busy_timeout=2000");
    if (ready) ready = check_version(impl->database, file);
    if (ready) ready = impl->read_header();
    if (ready) ready = impl->prepare();
    if (ready) return std::unique_ptr<RecordingReader>(new RecordingReader(std::move(impl)));
    // Where locks or the log cannot be written, reading alone may still do.
    if (ready.error().code != ErrorCode::io) return ready.error();
    if (!first) first = ready.error();
  }
  return Error{ErrorCode::io, "Cannot read " + file.string() + ": " + first->message,
               "Copy it with the file " + file.filename().string() +
                   "-wal beside it, if there is one, to a folder where you may write."};
}

Result<std::unique_ptr<RecordingReader>> RecordingReader::over(Database database, const fs::path& file) {
  auto impl = std::make_unique<Impl>(std::move(database));
  impl->file = file;
  impl->access = Access::frozen;
  if (Status ready = impl->read_header(); !ready) return ready.error();
  if (Status ready = impl->prepare(); !ready) return ready.error();
  return std::unique_ptr<RecordingReader>(new RecordingReader(std::move(impl)));
}

Result<bool> RecordingReader::go_on_in(Database database) {
  return impl_->go_on_in(std::move(database));
}

const RecordingHeader& RecordingReader::header() const {
  return impl_->header;
}

std::uint64_t RecordingReader::input_digest() const {
  return impl_->input_digest;
}

std::uint64_t RecordingReader::file_bytes() const {
  std::error_code none;
  const std::uint64_t bytes = fs::file_size(impl_->file, none);
  if (none) return 0;
  const std::uint64_t log = fs::file_size(impl_->file.string() + "-wal", none);
  return bytes + (none ? 0 : log);
}

Result<bool> RecordingReader::read_commit(Journal& journal) {
  return impl_->read_commit(journal);
}

void RecordingReader::read_unproven(Journal& journal) {
  impl_->read_unproven(journal);
}

std::size_t RecordingReader::events_behind(std::size_t event) {
  return impl_->events_behind(event);
}

Result<std::optional<RecordingEnd>> RecordingReader::end() {
  return impl_->end();
}

bool RecordingReader::growing() {
  return !impl_->alone();
}

bool is_recording_name(const fs::path& file) {
  return file.extension() == ".isorun";
}

} // namespace isoscope
