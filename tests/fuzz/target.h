// What a fuzz target is: a reader of hostile bytes, with what it is fed from. Each program has one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope::fuzz {

struct Target {
  std::string_view name;
  /// Sound inputs, made in code, from which mutations begin.
  std::vector<std::string> (*seeds)();
  /// What the readers' language is made of, for mutations to put in.
  std::vector<std::string_view> words;
  /// Reads the bytes; whether they were accepted. Breaks off by require() where what was read is unsound.
  bool (*accepts)(std::string_view bytes);
  /// The most memory that reading may hold at once: so many bytes, and so many more for each byte of the
  /// input.
  std::size_t memory_base, memory_per_byte;
};

/// Defined by each target's file.
const Target& target();

/// Ends the program with a message where `sound` is false: a finding.
void require(bool sound, std::string_view message);
/// How many of the inputs so far were accepted.
std::size_t accepted_inputs();

} // namespace isoscope::fuzz

/// What libFuzzer and our own driver call.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
