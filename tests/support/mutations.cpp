// Edits and damage by a SplitMix64 generator.
#include "support/mutations.h"

#include "base/scramble.h"

#include <algorithm>

namespace isoscope::test {

namespace {

void edit(std::string& bytes, Draws& draws, std::span<const std::string_view> words) {
  const std::size_t at = draws.below(bytes.size());
  switch (draws.below(8)) {
  case 0:
    bytes[at] = static_cast<char>(draws.below(256));
    break;
  case 1:
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << draws.below(8)));
    break;
  case 2:
    bytes.resize(at);
    break;
  case 3:
    bytes.erase(at, 1 + draws.below(8));
    break;
  case 4:
    bytes.insert(at, bytes.substr(draws.below(bytes.size()), draws.below(40)));
    break;
  case 5:
    if (!words.empty()) bytes.insert(at, words[draws.below(words.size())]);
    break;
  case 6: { // a short piece many times: long lists and deep nesting
    const std::string piece = bytes.substr(draws.below(bytes.size()), 1 + draws.below(4));
    std::string many;
    for (std::size_t i = 0, n = 1 + draws.below(200); i < n; ++i) many += piece;
    bytes.insert(at, many);
    break;
  }
  default:
    bytes[at] = static_cast<char>('0' + draws.below(10));
    break;
  }
}

void damage(std::string& bytes, Draws& draws) {
  const std::size_t at = draws.below(bytes.size());
  const std::size_t length = std::min(1 + draws.below(64), bytes.size() - at);
  switch (draws.below(5)) {
  case 0:
    bytes[at] = static_cast<char>(draws.below(256));
    break;
  case 1: // what numbers of variable length go on with
    bytes.replace(at, length, length, '\xff');
    break;
  case 2:
    bytes.replace(at, length, bytes.substr(draws.below(bytes.size() - length + 1), length));
    break;
  case 3:
    bytes.replace(at, length, length, '\0');
    break;
  default: // digits stay digits: texts in JSON go on being JSON
    for (std::size_t i = at; i < bytes.size() && i < at + 400; ++i)
      if (bytes[i] >= '0' && bytes[i] <= '9') bytes[i] = "0123456789-.eE"[draws.below(14)];
  }
}

} // namespace

Draws::Draws(std::uint64_t seed) : state_(scrambled(seed)) {}

std::size_t Draws::below(std::size_t n) {
  state_ += golden_step;
  return static_cast<std::size_t>(scrambled(state_) % n);
}

std::string edited(std::string bytes, Draws& draws, std::span<const std::string_view> words) {
  for (std::size_t i = 0, n = 1 + draws.below(3); i < n && !bytes.empty(); ++i) edit(bytes, draws, words);
  return bytes;
}

std::string damaged(std::string bytes, Draws& draws) {
  for (std::size_t i = 0, n = 1 + draws.below(4); i < n && !bytes.empty(); ++i) damage(bytes, draws);
  return bytes;
}

} // namespace isoscope::test
