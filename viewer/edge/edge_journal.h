// What the journal says of an edge in its inspector, the gate at which one stands, and numbers against
// limits.
#pragma once

#include "journal/journal.h"
#include "ui/ui.h"

#include <string_view>

namespace isoscope::panels {

/// Whether one steps through gates and stands at this one.
bool at_gate(const Ui& ui, std::size_t gate);
/// The ground of the gate at which one stands; brings it into sight when it is reached.
void gate_ground(const Ui& ui, ImVec2 low, ImVec2 size);

/// What a number of a reason means: lengths are told in δ.
struct Measured {
  double value = 0, limit = 0;
  const char* unit = "";
  bool upper = true;   ///< the limit must not be exceeded
  bool number = false; ///< there is one
};
Measured measured(Reason reason, double value, double limit, double delta);

/// What the journal says of the edge's event, where it measured something; the sweeps of a repair.
void event_details(Ui& ui, const Journal& journal, std::uint32_t index);
/// Other events of the edge, newest first.
void edge_history(Ui& ui, const Journal& journal, VertexId a, VertexId b);

} // namespace isoscope::panels
