// Rows of an SQLite file read from its pages alone: damage in one place hides no row in another.
#pragma once

#include "base/status.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace isoscope {

/// A value of a stored row.
struct StoredValue {
  enum class Kind : std::uint8_t { null, integer, real, text, blob };
  Kind kind = Kind::null;
  std::int64_t integer = 0;
  double real = 0;
  std::string bytes; ///< of texts and blobs
};

/// A row as a page holds it. The column that is the row's number is null in tables that have such numbers.
struct StoredRow {
  std::int64_t number = 0; ///< 0 in tables WITHOUT ROWID
  std::vector<StoredValue> values;
};

/// The pages of a file, with those of a write-ahead log beside it where its checksums are right. Nothing is
/// ever written. Format: https://www.sqlite.org/fileformat2.html
class PageScan {
 public:
  using Take = std::function<void(const StoredRow& row)>;
  enum class Tree : std::uint8_t {
    table, ///< rows with numbers, in the leaves
    keyed  ///< WITHOUT ROWID: rows in all pages
  };

  /// Fails with io or bad_input when the file cannot be read at all.
  static Result<PageScan> open(const std::filesystem::path& file);
  ~PageScan();
  PageScan(PageScan&&) noexcept;
  PageScan& operator=(PageScan&&) noexcept;

  std::size_t pages() const;
  /// Every sound row of the tree with this root, in its order, as far as its pages lead.
  void walk(std::uint32_t root, Tree tree, const Take& take);
  /// Every sound row of leaves that no walk has reached: what led to them is damaged.
  void walk_lost(Tree tree, const Take& take);

 private:
  struct Impl;
  explicit PageScan(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
