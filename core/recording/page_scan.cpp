// Pages, cells and records, every offset checked against what is there.
#include "recording/page_scan.h"

#include "recording/page_file.h"

#include <bit>
#include <optional>
#include <string_view>

namespace isoscope {

namespace {

constexpr std::uint8_t keyed_interior = 2, table_interior = 5, keyed_leaf = 10, table_leaf = 13;
constexpr std::size_t leaf_header = 8, interior_header = 12;
constexpr int deepest = 20; ///< a tree of more levels would be larger than any file

/// Reads the numbers of a page or a record; beyond the end it fails.
class Bytes {
 public:
  Bytes(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  bool failed() const { return failed_; }
  std::size_t at() const { return at_; }
  std::size_t left() const { return failed_ || at_ > bytes_.size() ? 0 : bytes_.size() - at_; }
  /// The highest byte first.
  std::uint64_t fixed(std::size_t size) {
    if (left() < size) failed_ = true;
    std::uint64_t v = 0;
    for (std::size_t i = 0; i < size && !failed_; ++i) v = v << 8 | byte();
    return v;
  }
  /// Seven bits a byte, the highest first; a ninth byte has eight.
  std::uint64_t variable() {
    std::uint64_t v = 0;
    for (int i = 0; i < 9; ++i) {
      if (left() == 0) failed_ = true;
      if (failed_) return 0;
      const std::uint8_t b = byte();
      if (i == 8) return v << 8 | b;
      v = v << 7 | (b & 0x7f);
      if ((b & 0x80) == 0) break;
    }
    return v;
  }
  std::string_view take(std::size_t size) {
    if (left() < size) failed_ = true;
    if (failed_) return {};
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

 private:
  std::uint8_t byte() { return static_cast<std::uint8_t>(bytes_[at_++]); }
  std::string_view bytes_;
  std::size_t at_;
  bool failed_ = false;
};

std::int64_t with_sign(std::uint64_t v, std::size_t size) {
  const int unused = 64 - 8 * static_cast<int>(size);
  return static_cast<std::int64_t>(v << unused) >> unused;
}

/// False for types that no file has.
bool read_value(Bytes& in, std::uint64_t type, StoredValue& value) {
  constexpr std::size_t sizes[] = {0, 1, 2, 3, 4, 6, 8};
  if (type == 0) return true;
  if (type <= 6 || type == 8 || type == 9) {
    value.kind = StoredValue::Kind::integer;
    value.integer = type <= 6 ? with_sign(in.fixed(sizes[type]), sizes[type]) : type == 9 ? 1 : 0;
    return !in.failed();
  }
  if (type == 7) {
    value.kind = StoredValue::Kind::real;
    value.real = std::bit_cast<double>(in.fixed(8));
    return !in.failed();
  }
  if (type < 12) return false;
  value.kind = type % 2 == 0 ? StoredValue::Kind::blob : StoredValue::Kind::text;
  const std::uint64_t size = (type - 12) / 2;
  if (size > in.left()) return false;
  value.bytes = in.take(static_cast<std::size_t>(size));
  return true;
}

/// A record must fill its bytes to the last: most damage shows itself so.
bool read_record(std::string_view payload, std::vector<StoredValue>& values) {
  Bytes header(payload, 0);
  const std::uint64_t header_size = header.variable();
  if (header.failed() || header_size > payload.size()) return false;
  Bytes body(payload, static_cast<std::size_t>(header_size));
  values.clear();
  while (header.at() < header_size) {
    const std::uint64_t type = header.variable();
    if (header.failed() || !read_value(body, type, values.emplace_back())) return false;
  }
  return header.at() == header_size && body.left() == 0;
}

} // namespace

struct PageScan::Impl {
  PageFile file;
  std::vector<bool> reached; ///< by page, from 1

  explicit Impl(PageFile f) : file(std::move(f)), reached(file.pages() + 1, false) {}

  /// A page's kind, cells and the child behind the last cell.
  struct Page {
    std::string bytes;
    std::uint8_t kind = 0;
    std::vector<std::size_t> cells;
    std::uint32_t last_child = 0;
    bool leaf() const { return kind == table_leaf || kind == keyed_leaf; }
  };

  std::optional<Page> read_page(std::uint32_t number) {
    Page page;
    page.bytes = file.page(number);
    const std::size_t begin = number == 1 ? 100 : 0; // the file's own header
    Bytes in(page.bytes, begin);
    page.kind = static_cast<std::uint8_t>(in.fixed(1));
    in.fixed(2);
    const std::size_t count = in.fixed(2);
    in.fixed(3);
    if (in.failed()) return std::nullopt;
    switch (page.kind) {
    case table_interior:
    case keyed_interior:
      page.last_child = static_cast<std::uint32_t>(in.fixed(4));
      break;
    case table_leaf:
    case keyed_leaf:
      break;
    default:
      return std::nullopt;
    }
    const std::size_t first = begin + (page.leaf() ? leaf_header : interior_header) + 2 * count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = in.fixed(2);
      if (in.failed()) break; // the page is cut off
      if (at >= first && at < page.bytes.size()) page.cells.push_back(at);
    }
    return page;
  }

  /// What a cell's payload is, from the page and the pages that it runs over into.
  std::optional<std::string> read_payload(Bytes& in, std::uint64_t size, bool table) {
    const std::size_t usable = file.page_size();
    if (size > file.pages() * usable) return std::nullopt;
    const std::size_t total = static_cast<std::size_t>(size);
    const std::size_t most = table ? usable - 35 : (usable - 12) * 64 / 255 - 23;
    std::size_t here = total;
    if (total > most) {
      const std::size_t least = (usable - 12) * 32 / 255 - 23;
      here = least + (total - least) % (usable - 4);
      if (here > most) here = least;
    }
    std::string payload(in.take(here));
    std::uint64_t next = here < total ? in.fixed(4) : 0;
    if (in.failed()) return std::nullopt;
    while (payload.size() < total) {
      if (next == 0 || next > file.pages()) return std::nullopt;
      const std::string bytes = file.page(static_cast<std::uint32_t>(next));
      Bytes page(bytes, 0);
      next = page.fixed(4);
      const std::size_t part = std::min(total - payload.size(), usable - 4);
      payload += page.take(part);
      if (page.failed()) return std::nullopt;
    }
    return payload;
  }

  /// The row of a cell, after the child's number where there is one.
  std::optional<StoredRow> read_row(Bytes& in, bool table) {
    StoredRow row;
    const std::uint64_t size = in.variable();
    if (table) row.number = static_cast<std::int64_t>(in.variable());
    if (in.failed()) return std::nullopt;
    const auto payload = read_payload(in, size, table);
    if (!payload || !read_record(*payload, row.values)) return std::nullopt;
    return row;
  }

  void take_leaf(const Page& page, const Take& take) {
    for (const std::size_t at : page.cells) {
      Bytes in(page.bytes, at);
      if (const auto row = read_row(in, page.kind == table_leaf)) take(*row);
    }
  }

  void walk(std::uint64_t number, Tree tree, const Take& take, int depth) {
    if (number == 0 || number > file.pages() || reached[number] || depth > deepest) return;
    const auto page = read_page(static_cast<std::uint32_t>(number));
    const bool table = tree == Tree::table;
    if (!page || (table != (page->kind == table_leaf || page->kind == table_interior))) return;
    reached[number] = true;
    if (page->leaf()) return take_leaf(*page, take);
    for (const std::size_t at : page->cells) {
      Bytes in(page->bytes, at);
      walk(in.fixed(4), tree, take, depth + 1);
      if (table) continue;
      if (const auto row = read_row(in, false)) take(*row);
    }
    walk(page->last_child, tree, take, depth + 1);
  }
};

PageScan::PageScan(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PageScan::~PageScan() = default;
PageScan::PageScan(PageScan&&) noexcept = default;
PageScan& PageScan::operator=(PageScan&&) noexcept = default;

Result<PageScan> PageScan::open(const std::filesystem::path& file) {
  auto opened = PageFile::open(file);
  if (!opened) return opened.error();
  return PageScan(std::make_unique<Impl>(std::move(*opened)));
}

std::size_t PageScan::pages() const {
  return impl_->file.pages();
}

void PageScan::walk(std::uint32_t root, Tree tree, const Take& take) {
  impl_->walk(root, tree, take, 0);
}

void PageScan::walk_lost(Tree tree, const Take& take) {
  const std::uint8_t wanted = tree == Tree::table ? table_leaf : keyed_leaf;
  for (std::size_t number = 1; number <= impl_->file.pages(); ++number) {
    if (impl_->reached[number]) continue;
    const auto page = impl_->read_page(static_cast<std::uint32_t>(number));
    if (page && page->kind == wanted) impl_->take_leaf(*page, take);
  }
}

} // namespace isoscope
