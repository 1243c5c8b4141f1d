// SQLite's calls and what its codes mean to a person.
#include "recording/database.h"

#include "recording/bytes.h"
#include "recording/page_file.h"
#include "recording/page_scan.h"
#include "recording/page_system.h"

#include <sqlite3.h>

#include <bit>
#include <cmath>

namespace isoscope {

namespace {

/// A reader or a writer holds its locks for milliseconds.
constexpr int patience_ms = 10000;

Error error_of(sqlite3* connection, const std::string& file, int code) {
  switch (code & 0xff) {
  case SQLITE_FULL:
    return {ErrorCode::io, "The disk is full: " + file + " could not be written further.",
            "What was committed before is safe; free some space and record again."};
  case SQLITE_NOTADB:
    return {ErrorCode::bad_input, file + " is not a recording.",
            "Give a file that --record has written; if it is one that was damaged: " + recover_hint(file)};
  case SQLITE_CORRUPT:
    return {ErrorCode::bad_input, file + " is damaged: " + sqlite3_errmsg(connection) + ".",
            recover_hint(file)};
  case SQLITE_BUSY:
  case SQLITE_LOCKED:
    return {ErrorCode::io, file + " is in use by another program.", "Wait until it has ended."};
  case SQLITE_CANTOPEN:
  case SQLITE_READONLY:
  case SQLITE_PERM:
  case SQLITE_AUTH:
    return {ErrorCode::io, "Cannot open " + file + " to write: it or its folder is missing or not writable.",
            "Make the folder, or give another file."};
  case SQLITE_NOMEM:
    return {ErrorCode::io, "Memory is exhausted while " + file + " is used.", ""};
  case SQLITE_IOERR:
    return {ErrorCode::io, file + " could not be read or written: " + sqlite3_errmsg(connection) + ".",
            "Is the disk full, the file size limited, or the medium gone?"};
  default:
    return {ErrorCode::bad_input,
            file + " does not hold what a recording holds: " + sqlite3_errmsg(connection) + ".",
            recover_hint(file)};
  }
}

/// A path as a URI, for the options that only a URI can carry.
std::string frozen_uri(const std::string& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '%' || c == '?' || c == '#') {
      constexpr char digits[] = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', digits[byte >> 4], digits[byte & 15]};
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

} // namespace

std::string recover_hint(const std::string& file) {
  return "isoscope-run recover " + file + " -o OUT.isorun saves what is sound.";
}

void Query::Close::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Database::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

void Query::reset() {
  sqlite3_reset(statement_.get());
  good_ = true;
}

bool Query::bind_integer(int place, std::int64_t value) {
  return sqlite3_bind_int64(statement_.get(), place, value) == SQLITE_OK;
}

bool Query::bind(int place, double value) {
  if (!std::isnan(value) && !same_bits(value, -0.0))
    return sqlite3_bind_double(statement_.get(), place, value) == SQLITE_OK;
  ByteWriter bits;
  bits.real(value);
  return sqlite3_bind_blob(statement_.get(), place, bits.bytes().data(), 8, SQLITE_TRANSIENT) == SQLITE_OK;
}

bool Query::bind(int place, std::string_view text) {
  return sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(), SQLITE_TRANSIENT,
                             SQLITE_UTF8) == SQLITE_OK;
}

bool Query::bind(int place, std::nullptr_t) {
  return sqlite3_bind_null(statement_.get(), place) == SQLITE_OK;
}

bool Query::bind(int place, Blob blob) {
  return sqlite3_bind_blob64(statement_.get(), place, blob.bytes.data(), blob.bytes.size(),
                             SQLITE_TRANSIENT) == SQLITE_OK;
}

Status Query::run(const std::vector<StoredValue>& values, const std::int64_t* number) {
  reset();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const StoredValue& v = values[i];
    const int place = static_cast<int>(i) + 1;
    bool good = false;
    if (i == 0 && number != nullptr) {
      good = bind_integer(place, *number);
    } else {
      switch (v.kind) {
      case StoredValue::Kind::null:
        good = bind(place, nullptr);
        break;
      case StoredValue::Kind::integer:
        good = bind_integer(place, v.integer);
        break;
      case StoredValue::Kind::real:
        good = bind(place, v.real);
        break;
      case StoredValue::Kind::text:
        good = bind(place, std::string_view(v.bytes));
        break;
      case StoredValue::Kind::blob:
        good = bind(place, Blob{v.bytes});
        break;
      }
    }
    if (!good) return failure();
  }
  return finish();
}

Error Query::failure() const {
  sqlite3* connection = sqlite3_db_handle(statement_.get());
  return error_of(connection, file_, sqlite3_errcode(connection));
}

Status Query::finish() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_DONE && code != SQLITE_ROW) {
    Error error = failure();
    sqlite3_reset(statement_.get());
    return error;
  }
  sqlite3_reset(statement_.get());
  return {};
}

Result<bool> Query::next() {
  if (!good_) return failure();
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  Result<bool> result = code == SQLITE_DONE ? Result<bool>(false) : Result<bool>(failure());
  sqlite3_reset(statement_.get());
  return result;
}

std::int64_t Query::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Query::real(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_BLOB)
    return sqlite3_column_double(statement_.get(), column);
  ByteReader bits(bytes(column));
  return bits.real();
}

std::string Query::text(int column) const {
  return std::string(bytes(column));
}

std::string_view Query::bytes(int column) const {
  const void* data = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return data == nullptr ? std::string_view()
                         : std::string_view(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

bool Query::null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

Result<Database> Database::open(const std::filesystem::path& file, Access access) {
  int flags = SQLITE_OPEN_NOMUTEX;
  flags |= access == Access::create ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
           : access == Access::grow ? SQLITE_OPEN_READWRITE
                                    : SQLITE_OPEN_READONLY;
  Database database;
  database.file_ = file.string();
  std::string name = database.file_;
  if (access == Access::frozen) {
    flags |= SQLITE_OPEN_URI;
    name = frozen_uri(name);
  }
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &connection, flags, nullptr);
  database.connection_.reset(connection);
  if (code != SQLITE_OK) return error_of(connection, database.file_, code);
  sqlite3_busy_timeout(connection, patience_ms);
  return database;
}

Result<Database> Database::over(PageFile pages, const std::filesystem::path& file) {
  Database database;
  database.file_ = file.string();
  auto system = PageSystem::add(std::move(pages));
  sqlite3* connection = nullptr;
  const int code =
      sqlite3_open_v2("pages", &connection, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, system->name());
  database.pages_ = std::move(system);
  database.connection_.reset(connection);
  if (code != SQLITE_OK) return error_of(connection, database.file_, code);
  return database;
}

Status Database::execute(const char* statements) {
  const int code = sqlite3_exec(connection_.get(), statements, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) return error_of(connection_.get(), file_, code);
  return {};
}

Result<Query> Database::prepare(std::string_view statement) {
  Query query;
  query.file_ = file_;
  sqlite3_stmt* prepared = nullptr;
  const int code = sqlite3_prepare_v3(connection_.get(), statement.data(), static_cast<int>(statement.size()),
                                      SQLITE_PREPARE_PERSISTENT, &prepared, nullptr);
  query.statement_.reset(prepared);
  if (code != SQLITE_OK) return error_of(connection_.get(), file_, code);
  return query;
}

Result<std::int64_t> Database::number(const char* statement) {
  auto query = prepare(statement);
  if (!query) return query.error();
  query->start();
  const auto row = query->next();
  if (!row) return row.error();
  return *row ? query->integer(0) : 0;
}

Result<std::string> Database::word(const char* statement) {
  auto query = prepare(statement);
  if (!query) return query.error();
  query->start();
  const auto row = query->next();
  if (!row) return row.error();
  return *row ? query->text(0) : std::string();
}

} // namespace isoscope
