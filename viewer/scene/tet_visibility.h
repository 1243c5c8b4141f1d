// Which tetrahedra the filter and the clip let see, and in which role; drawing and picking agree through
// this.
#pragma once

#include "questions/snapshot.h"
#include "scene/clip.h"
#include "scene/view_settings.h"

#include <cstdint>

namespace isoscope {

/// Why a tetrahedron is drawn; the first that applies.
enum class TetRole : std::uint8_t { hidden, violates_1, violates_2, violates_3, changed, plain };

/// The role by the filter alone: by its switches, and by its side once Z is embedded (`embedded`).
TetRole tet_role(std::uint8_t flags, const TetFilter& filter, bool embedded = false);

/// Calls visit(TetId, TetRole) for every tetrahedron that filter and clip let see, ascending by slot.
template <class Visit>
void for_each_visible_tet(const StateSnapshot& state, const TetFilter& wanted, const Clip& clip,
                          Visit&& visit) {
  const std::size_t count = std::min(state.complex.tets.size(), state.tet_flags.size());
  // Where an operation made all of T anew, what it changed tells nothing.
  constexpr std::size_t most_changed = 1500;
  TetFilter filter = wanted;
  filter.changed = wanted.changed && state.added_tets.size() <= most_changed;
  for (std::size_t i = 0; i < count; ++i) {
    if (!state.complex.tets[i].alive()) continue;
    const TetRole role = tet_role(state.tet_flags[i], filter, state.complex.form == ZeroForm::embedded);
    if (role == TetRole::hidden) continue;
    const TetId id(i);
    if (clip.active() && !clip.shows_cell(state.complex.positions(id))) continue;
    visit(id, role);
  }
}

} // namespace isoscope
