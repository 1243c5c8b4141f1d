// A mixing of bits that any computer repeats: for orders and draws that have to look like chance.
#pragma once

#include <cstdint>

namespace isoscope {

/// Steps between the states of SplitMix64 [Steele et al. 2014]: 2^64 over the golden ratio.
constexpr std::uint64_t golden_step = 0x9e3779b97f4a7c15u;

/// The output of SplitMix64 for a state.
constexpr std::uint64_t scrambled(std::uint64_t state) {
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
  return state ^ (state >> 31);
}

} // namespace isoscope
