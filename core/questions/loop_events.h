// Which loops of the open rim an operation works on: cutting, simplifying, filling (§4.1).
#pragma once

#include "journal/journal.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

class Rim;

/// What is done to a loop.
enum class LoopWork : std::uint8_t {
  cutting,     ///< an edge is split along the wall over it, or Z is cut there
  simplifying, ///< an edge of its border collapses
  filling      ///< its hole is closed
};
constexpr int loop_work_count = 3;

/// What operations of this kind do to loops; nothing for kinds that never do. Relocations move all borders at
/// once and do not count.
std::optional<LoopWork> loop_work(EventKind kind);

/// The numbers of the loops that an event's operation works on, ascending: of a split along the
/// wall, and of the collapse of an edge of the border, that which is nearest to its place; of the cut all of
/// them; of a filling those that it names.
std::vector<std::uint32_t> loops_touched(const Journal& journal, const Event& event, const Rim& rim);

} // namespace isoscope
