// Where a picked element lies at a step.
#pragma once

#include "questions/snapshot.h"
#include "scene/view_settings.h"

#include <optional>

namespace isoscope {

/// The ends of a picked edge. One that the current operation collapsed lies where it was before it.
std::optional<std::array<Vec3, 2>> edge_positions(const StateSnapshot& state, const Pick& pick);
/// Everything of the element, but for corners of the first box where a tetrahedron has others; empty where
/// the state has it not.
Box3 pick_bounds(const StateSnapshot& state, const Pick& pick);

/// Of Z at a picked edge or vertex, outwards, of unit length; zero where it has no facet of Z.
Vec3 surface_normal(const StateSnapshot& state, const Pick& pick);

/// A direction of unit length from which a place of Z is seen, with nothing of Z before it within `reach`:
/// `now` if it will do, else the normal, else the one of a few that is nearest to both. Where all are hidden,
/// the normal, or `now` if it is on the normal's side.
Vec3 unhidden_direction(const ZeroSet& zero, Vec3 place, Vec3 now, Vec3 normal, double reach);

/// By how much the moves of the current operation are enlarged so that a sweep of small ones can be seen: 1,
/// 2 or 5 times a power of ten. A high quantile of their lengths decides.
double move_scale(const StateSnapshot& state, double pixels_per_unit);
/// Where the arrow of a move ends that is enlarged by `scale`: no move is drawn shorter than it is, and none
/// enlarged beyond twice the length that the scale aims at.
Vec3 arrow_tip(const StateSnapshot::Move& move, double scale, double pixels_per_unit);

} // namespace isoscope
