// SQLite's tables of functions. A file that says that nothing can change it is never locked, and nobody looks
// for a log beside it.
#include "recording/page_system.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>

namespace isoscope {

namespace {

/// What SQLite keeps of an open file: it begins as SQLite says.
struct OpenPages {
  sqlite3_file base;
  PageFile* pages;
};

PageFile& pages_of(sqlite3_file* file) {
  return *reinterpret_cast<OpenPages*>(file)->pages;
}

int close(sqlite3_file*) {
  return SQLITE_OK;
}

int read_pages(PageFile& pages, char* into, std::size_t size, std::uint64_t at) {
  const std::size_t page_size = pages.page_size();
  bool whole = true;
  while (size > 0) {
    const std::uint64_t number = at / page_size;
    const auto within = static_cast<std::size_t>(at % page_size);
    const std::size_t part = std::min(size, page_size - within);
    std::string bytes =
        number < pages.pages() ? pages.page(static_cast<std::uint32_t>(number + 1)) : std::string();
    whole = whole && bytes.size() >= within + part;
    bytes.resize(page_size, '\0');
    // The head says that there is a log; here what it held is in the pages already.
    constexpr std::size_t write_version = 18, read_version = 19;
    if (number == 0) bytes[write_version] = bytes[read_version] = 1;
    std::memcpy(into, bytes.data() + within, part);
    into += part;
    at += part;
    size -= part;
  }
  return whole ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
}

int read(sqlite3_file* file, void* into, int size, sqlite3_int64 at) {
  try {
    return read_pages(pages_of(file), static_cast<char*>(into), static_cast<std::size_t>(size),
                      static_cast<std::uint64_t>(at));
  } catch (const std::bad_alloc&) {
    return SQLITE_IOERR_NOMEM;
  }
}

int write(sqlite3_file*, const void*, int, sqlite3_int64) {
  return SQLITE_READONLY;
}

int truncate(sqlite3_file*, sqlite3_int64) {
  return SQLITE_READONLY;
}

int sync(sqlite3_file*, int) {
  return SQLITE_OK;
}

int size_of(sqlite3_file* file, sqlite3_int64* size) {
  PageFile& pages = pages_of(file);
  *size = static_cast<sqlite3_int64>(pages.pages() * pages.page_size());
  return SQLITE_OK;
}

int lock(sqlite3_file*, int) {
  return SQLITE_OK;
}

int check_lock(sqlite3_file*, int* held) {
  *held = 0;
  return SQLITE_OK;
}

int control(sqlite3_file*, int, void*) {
  return SQLITE_NOTFOUND;
}

int sector_size(sqlite3_file*) {
  return 4096;
}

int characteristics(sqlite3_file*) {
  return SQLITE_IOCAP_IMMUTABLE;
}

const sqlite3_io_methods& methods() {
  static const sqlite3_io_methods all = [] {
    sqlite3_io_methods m{};
    m.iVersion = 1;
    m.xClose = close;
    m.xRead = read;
    m.xWrite = write;
    m.xTruncate = truncate;
    m.xSync = sync;
    m.xFileSize = size_of;
    m.xLock = lock;
    m.xUnlock = lock;
    m.xCheckReservedLock = check_lock;
    m.xFileControl = control;
    m.xSectorSize = sector_size;
    m.xDeviceCharacteristics = characteristics;
    return m;
  }();
  return all;
}

int open(sqlite3_vfs* system, const char*, sqlite3_file* file, int flags, int* flags_out) {
  file->pMethods = nullptr;
  if ((flags & SQLITE_OPEN_MAIN_DB) == 0) return SQLITE_CANTOPEN;
  file->pMethods = &methods();
  reinterpret_cast<OpenPages*>(file)->pages = static_cast<PageFile*>(system->pAppData);
  if (flags_out != nullptr) *flags_out = flags;
  return SQLITE_OK;
}

int no_delete(sqlite3_vfs*, const char*, int) {
  return SQLITE_READONLY;
}

int no_other_file(sqlite3_vfs*, const char*, int, int* there) {
  *there = 0;
  return SQLITE_OK;
}

int same_name(sqlite3_vfs*, const char* name, int size, char* out) {
  sqlite3_snprintf(size, out, "%s", name);
  return SQLITE_OK;
}

} // namespace

struct PageSystem::Impl {
  PageFile pages;
  std::string name;
  sqlite3_vfs system{};

  explicit Impl(PageFile p) : pages(std::move(p)) {}
};

PageSystem::PageSystem(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

PageSystem::~PageSystem() {
  sqlite3_vfs_unregister(&impl_->system);
}

std::shared_ptr<const PageSystem> PageSystem::add(PageFile pages) {
  sqlite3_initialize();
  auto impl = std::make_unique<Impl>(std::move(pages));
  char name[40];
  sqlite3_snprintf(sizeof name, name, "isoscope-pages-%p", static_cast<void*>(impl.get()));
  impl->name = name;
  // Clocks and chance are the machine's own.
  const sqlite3_vfs* const usual = sqlite3_vfs_find(nullptr);
  impl->system = *usual;
  impl->system.pNext = nullptr;
  impl->system.zName = impl->name.c_str();
  impl->system.szOsFile = sizeof(OpenPages);
  impl->system.pAppData = &impl->pages;
  impl->system.xOpen = open;
  impl->system.xDelete = no_delete;
  impl->system.xAccess = no_other_file;
  impl->system.xFullPathname = same_name;
  sqlite3_vfs_register(&impl->system, 0);
  return std::shared_ptr<const PageSystem>(new PageSystem(std::move(impl)));
}

const char* PageSystem::name() const {
  return impl_->name.c_str();
}

} // namespace isoscope
