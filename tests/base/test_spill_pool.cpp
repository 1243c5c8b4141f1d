// Memory that goes to the disk and stays readable at its addresses, also for those who read meanwhile.
#include "base/spill_list.h"
#include "base/spill_pool.h"

#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include <sys/resource.h>

using namespace isoscope;

namespace {

struct Record {
  std::uint64_t number = 0, square = 0, rest[6] = {};
};

Record record_of(std::size_t i) {
  Record r{i, i * i, {}};
  for (std::uint64_t& x : r.rest) x = ~i;
  return r;
}

bool is_record(const Record& r, std::size_t i) {
  const Record wanted = record_of(i);
  return std::memcmp(&r, &wanted, sizeof r) == 0;
}

/// Every element, in an order that jumps about.
std::size_t wrong_elements(const SpillList<Record>& list) {
  std::size_t wrong = 0;
  const std::size_t n = list.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = k * 7919 % n;
    wrong += is_record(list[i], i) ? 0u : 1u;
  }
  return wrong;
}

} // namespace

TEST_CASE("Beyond the limit the oldest segments leave memory, and everything is read as before") {
  SpillPool pool;
  SpillList<Record> list(pool);
  constexpr std::size_t count = 40001; // not a multiple of 7919
  for (std::size_t i = 0; i < count; ++i) list.push_back(record_of(i));
  const std::size_t all = pool.memory_bytes();
  CHECK(all >= count * sizeof(Record));
  CHECK(pool.disk_bytes() == 0);
  const Record* first = &list[0];

  pool.keep_within(all / 2);
  CHECK(pool.memory_bytes() <= all / 2);
  CHECK(pool.disk_bytes() >= all - pool.memory_bytes() - 20 * 4096);
  CHECK(first == &list[0]);
  CHECK(wrong_elements(list) == 0);

  pool.keep_within(0);
  CHECK(pool.memory_bytes() <= 2048 * sizeof(Record) + 4096); // the segment that grows stays
  CHECK(wrong_elements(list) == 0);
  pool.release_read_back();
  CHECK(wrong_elements(list) == 0);

  for (std::size_t i = count; i < 2 * count; ++i) list.push_back(record_of(i));
  CHECK(pool.memory_bytes() <= 2 * (2048 * sizeof(Record) + 4096));
  CHECK(list.size() == 2 * count);
  CHECK(wrong_elements(list) == 0);
  CHECK(!pool.error());
}

TEST_CASE("Nothing of the file is left in its folder") {
  const TemporaryFolder folder;
  SpillPool pool(folder.path());
  SpillList<Record> list(pool);
  pool.keep_within(0);
  for (std::size_t i = 0; i < 10000; ++i) list.push_back(record_of(i));
  CHECK(pool.disk_bytes() > 0);
  CHECK(std::filesystem::is_empty(folder.path()));
  CHECK(wrong_elements(list) == 0);
}

TEST_CASE("Without a place for the file everything stays in memory, and the pool says why") {
  const TemporaryFolder folder;
  SpillPool pool(folder / "missing");
  SpillList<Record> list(pool);
  pool.keep_within(1000);
  for (std::size_t i = 0; i < 10000; ++i) list.push_back(record_of(i));
  CHECK(pool.disk_bytes() == 0);
  CHECK(wrong_elements(list) == 0);
  REQUIRE(pool.error());
  CHECK(pool.error()->code == ErrorCode::io);
  CHECK(pool.error()->message.find((folder / "missing").string()) != std::string::npos);
  CHECK(pool.error()->remedy.find("TMPDIR") != std::string::npos);
}

TEST_CASE("On a disk that becomes full the rest stays in memory, and what was written is still read") {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{300000, limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  SpillPool pool;
  SpillList<Record> list(pool);
  pool.keep_within(0);
  for (std::size_t i = 0; i < 20000; ++i) list.push_back(record_of(i));
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
  CHECK(pool.disk_bytes() > 0);
  CHECK(pool.disk_bytes() <= 300000);
  REQUIRE(pool.error());
  CHECK(pool.error()->message.find("there is no room") != std::string::npos);
  CHECK(wrong_elements(list) == 0);
}

TEST_CASE("Readers see every element complete while a writer appends and a third one changes the limit") {
  SpillPool pool;
  SpillList<Record> list(pool);
  pool.keep_within(400000);
  constexpr std::size_t count = 60000;
  std::atomic<bool> done{false};
  std::atomic<std::size_t> wrong{0};
  std::vector<std::thread> others;
  for (std::size_t r = 0; r < 2; ++r)
    others.emplace_back([&, r] {
      for (std::size_t k = r; !done; k += 7919) {
        const std::size_t n = list.size();
        if (n == 0) continue;
        for (const std::size_t i : {k % n, n - 1}) wrong += is_record(list[i], i) ? 0u : 1u;
      }
    });
  others.emplace_back([&] {
    for (std::size_t k = 0; !done; ++k) {
      pool.keep_within(k % 2 == 0 ? 400000 : 100000);
      if (k % 3 == 0) pool.release_read_back();
      std::this_thread::yield();
    }
  });
  for (std::size_t i = 0; i < count; ++i) list.push_back(record_of(i));
  done = true;
  for (std::thread& t : others) t.join();
  CHECK(wrong == 0);
  CHECK(wrong_elements(list) == 0);
  CHECK(pool.disk_bytes() > 0);
}
