// What does not fit into memory: written, read here and there, sorted.
#include "base/external_sort.h"
#include "base/scratch_file.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

using namespace isoscope;

TEST_CASE("A scratch file gives back what was appended, and leaves nothing") {
  const TemporaryFolder folder;
  ScratchFile file(folder / ".");
  for (std::uint64_t i = 0; i < 100000; ++i) file.append(&i, sizeof i);
  CHECK(file.size() == 800000);
  BlockReader reader(file, 100000);
  for (std::uint64_t i = 0; i < 100000; i += 977) CHECK(reader.record<std::uint64_t>(i) == i);
  const std::uint64_t more = 7;
  file.append(&more, sizeof more);
  std::uint64_t back = 0;
  file.read(800000, &back, sizeof back);
  CHECK(back == 7);
  CHECK(file.status().ok());
  CHECK(std::filesystem::is_empty(folder / "."));
}

TEST_CASE("A scratch file that cannot be made says so") {
  ScratchFile file("/nowhere/at/all");
  const int i = 5;
  file.append(&i, sizeof i);
  int back = 1;
  file.read(0, &back, sizeof back);
  CHECK(back == 0);
  REQUIRE(!file.status().ok());
  CHECK(file.status().error().code == ErrorCode::io);
}

TEST_CASE("More than fits into memory comes out in order, as does what fits") {
  const TemporaryFolder folder;
  for (const std::size_t count : {0, 100, 50000}) {
    ExternalSort<std::uint32_t, std::less<>> sort(1, folder / ".");
    std::vector<std::uint32_t> all;
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < count; ++i) {
      random = random * 1664525 + 1013904223;
      all.push_back(random >> 12);
      sort.add(all.back());
    }
    CHECK(sort.size() == count);
    std::vector<std::uint32_t> sorted;
    REQUIRE(sort.each([&](std::uint32_t x) { sorted.push_back(x); }).ok());
    std::sort(all.begin(), all.end());
    CHECK(sorted == all);
  }
}
