// SQLite behind values: one connection, prepared statements, errors as sentences.
#pragma once

#include "base/status.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace isoscope {

class PageFile;
class PageSystem;
struct StoredValue;

/// What to do with a damaged recording, as a sentence.
std::string recover_hint(const std::string& file);

/// Bytes that are no text.
struct Blob {
  std::string_view bytes;
};

/// A prepared statement of a Database, which must outlive it.
class Query {
 public:
  Query() = default;

  /// Binds the values in order and runs a statement that gives no rows.
  template <class... Values> Status run(const Values&... values) {
    return bound(values...) ? finish() : failure();
  }
  /// Binds values as another file had them; `number`: what stands for the first one.
  Status run(const std::vector<StoredValue>& values, const std::int64_t* number);
  /// Binds and makes ready for next().
  template <class... Values> void start(const Values&... values) { good_ = bound(values...); }
  /// The next row, if there is one; fails when the file cannot be read.
  Result<bool> next();

  std::int64_t integer(int column) const;
  /// Bit for bit: −0 and NaN, which SQLite does not keep, are stored as eight bytes.
  double real(int column) const;
  std::string text(int column) const;
  /// Text or blob; valid until the next row.
  std::string_view bytes(int column) const;
  bool null(int column) const;
  /// Numbers and ids from a column on.
  template <class... Values> void read(int column, Values&... values) const { (take(column++, values), ...); }
  /// Calls take() for each row that is left, until it says false.
  template <class Take> Status each(Take take) {
    for (;;) {
      const auto row = next();
      if (!row) return row.error();
      if (!*row || !take()) return {};
    }
  }

 private:
  friend class Database;
  struct Close {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Close> statement_;
  std::string file_;
  bool good_ = false;

  template <class Value> void take(int column, Value& value) const {
    if constexpr (std::is_same_v<Value, bool>)
      value = integer(column) != 0;
    else if constexpr (std::is_floating_point_v<Value>)
      value = static_cast<Value>(real(column));
    else if constexpr (std::is_integral_v<Value>)
      value = static_cast<Value>(integer(column));
    else // an id, -1 where it is none
      value = Value(integer(column) < 0 ? Value::none : static_cast<std::uint32_t>(integer(column)));
  }
  template <class... Values> bool bound(const Values&... values) {
    reset();
    [[maybe_unused]] int place = 0;
    return (bind(++place, values) && ...);
  }
  void reset();
  template <std::integral Number> bool bind(int place, Number value) {
    return bind_integer(place, static_cast<std::int64_t>(value));
  }
  bool bind_integer(int place, std::int64_t value);
  bool bind(int place, double value);
  bool bind(int place, std::string_view text);
  bool bind(int place, std::nullptr_t);
  bool bind(int place, Blob blob);
  Status finish();
  Error failure() const;
};

/// A connection to one file; used by one thread at a time.
class Database {
 public:
  enum class Access {
    create, ///< a new file, or an empty one
    grow,   ///< an existing one, to read and to mend what a killed writer left
    read,   ///< an existing one that cannot be written
    frozen  ///< the same where not even a lock can be taken; nobody may be writing it
  };
  /// An empty name makes a new file that vanishes with the connection.
  static Result<Database> open(const std::filesystem::path& file, Access access);
  /// One that is only read, page by page, without any lock; queries must be gone before it. `file` is what
  /// messages call it.
  static Result<Database> over(PageFile pages, const std::filesystem::path& file);

  Status execute(const char* statements);
  Result<Query> prepare(std::string_view statement);
  /// The first column of the first row of a statement.
  Result<std::int64_t> number(const char* statement);
  Result<std::string> word(const char* statement);

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  std::shared_ptr<const PageSystem> pages_; ///< outlives the connection
  std::unique_ptr<sqlite3, Close> connection_;
  std::string file_;
};

} // namespace isoscope
