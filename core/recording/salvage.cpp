// Rows from the pages go into a new recording that nobody sees, and the reader reads that one.
#include "recording/salvage.h"

#include "recording/database.h"
#include "recording/geometry_codec.h"
#include "recording/page_scan.h"
#include "recording/recording_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace isoscope {

namespace {

namespace fs = std::filesystem;
using Kind = StoredValue::Kind;

/// A table, and by what its rows are known where nothing leads to them.
struct Table {
  std::string_view name;
  PageScan::Tree tree;
  std::size_t columns;
  Kind last; ///< of the last column; null: of any kind
};

constexpr auto numbered = PageScan::Tree::table, keyed = PageScan::Tree::keyed;
/// Those that a journal is read from. No two kept alike have the same number of columns and last kind.
constexpr std::array tables{Table{"run", keyed, 2, Kind::text},
                            Table{"input", numbered, 6, Kind::blob},
                            Table{"event_rows", numbered, 25, Kind::null},
                            Table{"operations", numbered, 9, Kind::blob},
                            Table{"sample_sets", numbered, 4, Kind::blob},
                            Table{"criteria", numbered, 11, Kind::null},
                            Table{"texts", numbered, 2, Kind::text},
                            Table{"repairs", numbered, 2, Kind::integer},
                            Table{"sweeps", keyed, 9, Kind::blob},
                            Table{"stage_marks", numbered, 3, Kind::null},
                            Table{"commits", numbered, 9, Kind::text},
                            Table{"ending", numbered, 5, Kind::text}};
/// Their rows look like those of `texts`, and every writer makes them anew.
constexpr std::array<std::string_view, 4> name_tables{"kinds", "stages", "conditions", "reasons"};

bool fits(const Table& table, const StoredRow& row) {
  if (row.values.size() != table.columns) return false;
  return table.last == Kind::null || row.values.back().kind == table.last;
}

/// Where the tables' roots are: every recording makes them in the same order.
Result<std::map<std::string, std::uint32_t, std::less<>>> roots_of(Database& fresh) {
  auto query = fresh.prepare("SELECT name,rootpage FROM sqlite_schema WHERE type='table'");
  if (!query) return query.error();
  std::map<std::string, std::uint32_t, std::less<>> roots;
  query->start();
  const Status told = query->each([&] {
    query->read(1, roots[query->text(0)]);
    return true;
  });
  if (!told) return told.error();
  return roots;
}

/// A new recording in a nameless file that goes with it.
Result<Database> nameless_recording() {
  auto database = Database::open("", Database::Access::create);
  if (!database) return database.error();
  Status made = database->execute("PRAGMA synchronous=OFF; PRAGMA journal_mode=OFF; BEGIN");
  if (made) made = database->execute(recording_schema);
  if (made)
    made = database->execute(("PRAGMA application_id=" + std::to_string(recording_application_id) +
                              "; PRAGMA user_version=" + std::to_string(recording_version))
                                 .c_str());
  if (!made) return made.error();
  return database;
}

/// Puts rows into a table; the first one of a number or key stays.
class Inserter {
 public:
  Status prepare(Database& database, const Table& table) {
    std::string statement = "INSERT OR IGNORE INTO " + std::string(table.name) + " VALUES(?";
    for (std::size_t i = 1; i < table.columns; ++i) statement += ",?";
    auto prepared = database.prepare(statement + ")");
    if (!prepared) return prepared.error();
    query_ = std::move(*prepared);
    table_ = &table;
    return {};
  }
  const Table& table() const { return *table_; }
  /// Rows that the table does not take are left out; an error of the disk is kept.
  void insert(const StoredRow& row) {
    if (!error_.ok() || !fits(*table_, row)) return;
    Status done = query_.run(row.values, table_->tree == numbered ? &row.number : nullptr);
    if (!done && done.error().code == ErrorCode::io) error_ = done;
  }
  const Status& error() const { return error_; }

 private:
  Query query_;
  const Table* table_ = nullptr;
  Status error_;
};

Status fill(Database& fresh, PageScan& scan) {
  const auto roots = roots_of(fresh);
  if (!roots) return roots.error();
  std::array<Inserter, tables.size()> inserters;
  for (std::size_t i = 0; i < tables.size(); ++i)
    if (Status s = inserters[i].prepare(fresh, tables[i]); !s) return s;
  for (const std::string_view name : name_tables)
    scan.walk(roots->find(name)->second, numbered, [](const StoredRow&) {});
  for (Inserter& into : inserters)
    scan.walk(roots->find(into.table().name)->second, into.table().tree,
              [&](const StoredRow& row) { into.insert(row); });
  for (const PageScan::Tree tree : {numbered, keyed})
    scan.walk_lost(tree, [&](const StoredRow& row) {
      for (Inserter& into : inserters)
        if (into.table().tree == tree) into.insert(row);
    });
  for (const Inserter& into : inserters)
    if (!into.error()) return into.error();
  return fresh.execute("COMMIT");
}

/// Puts a substitute in the place of the input where the file's digest says that it is the same.
Status substitute_input(Database& fresh, const TriangleSoup& soup) {
  auto query = fresh.prepare("UPDATE input SET data=? WHERE digest=?");
  if (!query) return query.error();
  return query->run(Blob{encode(soup)}, std::string_view(digest_text(digest(soup))));
}

Status substitute_samples(Database& fresh, const BoundarySamples& samples) {
  auto query = fresh.prepare("INSERT OR REPLACE INTO sample_sets VALUES(0,?,?,?)");
  if (!query) return query.error();
  return query->run(samples.size(), samples.sigma, Blob{encode(samples)});
}

} // namespace

Result<Salvage> salvage_recording(const fs::path& file, const SalvageSubstitutes& substitutes) {
  auto scan = PageScan::open(file);
  if (!scan) return scan.error();
  auto fresh = nameless_recording();
  if (!fresh) return fresh.error();
  Status filled = fill(*fresh, *scan);
  if (filled && substitutes.input) filled = substitute_input(*fresh, *substitutes.input);
  if (filled && substitutes.samples) filled = substitute_samples(*fresh, *substitutes.samples);
  if (!filled) return filled.error();
  const auto rows = fresh->number("SELECT (SELECT count(*) FROM event_rows) + (SELECT count(*) FROM input)");
  if (!rows) return rows.error();
  if (*rows == 0)
    return Error{ErrorCode::bad_input,
                 "Nothing of " + file.string() +
                     " can be saved: it holds no input and no event of a recording.",
                 "Take another copy, or record the run again."};
  Salvage found;
  auto parameters = fresh->word("SELECT value FROM run WHERE key='parameters'");
  if (parameters) found.header.parameters = std::move(*parameters);
  auto opened = RecordingReader::over(std::move(*fresh), file);
  if (!opened) return found;
  RecordingReader& reader = **opened;
  found.header = reader.header();
  for (;;) {
    const auto more = reader.read_commit(*found.journal);
    if (!more) found.damage = more.error().message;
    if (!more || !*more) break;
  }
  found.proven = found.journal->events().size();
  reader.read_unproven(*found.journal);
  const std::size_t events = found.journal->events().size();
  found.rows_behind = reader.events_behind(events);
  if (found.damage.empty() && events == found.proven && found.rows_behind == 0)
    if (auto end = reader.end(); end.ok()) found.end = std::move(*end);
  return found;
}

} // namespace isoscope
