// The entry that drivers call, the same for all targets.
#include "fuzz/target.h"

#include <cstdio>
#include <cstdlib>

namespace isoscope::fuzz {

namespace {

std::size_t& count() {
  static std::size_t accepted = 0;
  return accepted;
}

} // namespace

void require(bool sound, std::string_view message) {
  if (sound) return;
  std::fprintf(stderr, "finding: %.*s\n", static_cast<int>(message.size()), message.data());
  std::abort();
}

std::size_t accepted_inputs() {
  return count();
}

} // namespace isoscope::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoscope::fuzz;
  if (target().accepts({reinterpret_cast<const char*>(data), size})) ++count();
  return 0;
}
