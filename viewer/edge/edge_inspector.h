// The X-ray of the selected edge in the inspector.
#pragma once

#include "edge/probe.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// Verdict, checks, kernel, candidates, cost; after T what the journal tells.
void edge_details(Ui& ui, EdgeProbe& probe, const StateSnapshot& state);

/// What the evaluator says of the edge, in a few words: whether it speaks of the journal's decision or of
/// what would be if it were tried now.
struct EdgeVerdict {
  std::string words;
  Rgb color = 0;
  MarkerShape shape = MarkerShape::disc;
};
EdgeVerdict edge_verdict(const Ui& ui, const EdgeXray& xray);

/// Verdict, numbers before and after, where to snap, the branch.
void what_if(Ui& ui, const EdgeProbe& probe, const EdgeXray& xray);
/// Which neighbouring collapses would make this one possible.
void unlock(Ui& ui, EdgeProbe& probe);
/// The number of a check beside its limit, in short: "0.97 / 1 δ".
std::string check_text(CollapseCheck check, const CheckVerdict& verdict, const CollapseAttempt& attempt,
                       double delta);
/// Where no candidate lay in the kernel: which points were outside, and by how much.
void outside_kernel(Ui& ui, const EdgeXray& xray);
/// Bars of the candidates by reason, and the list of them: hovering one shows its ghost.
void candidates(Ui& ui, const EdgeXray& xray);
/// What the search left out, Ψ and cells of the octree, with switches of the view: a legend in words.
void search_regions(Ui& ui, const EdgeXray& xray);
/// The half-spaces and the polyhedron; the slider that pushes the planes of an empty one.
void kernel(Ui& ui, const EdgeXray& xray);
/// What the constraints cost, at the target or where one is tried.
void cost(Ui& ui, const EdgeXray& xray, const TargetStudy* study);
/// Whether one steps through gates and stands at this one.
bool at_gate(const Ui& ui, std::size_t gate);
/// The ground of the gate at which one stands; brings it into sight when it is reached.
void gate_ground(const Ui& ui, ImVec2 low, ImVec2 size);

/// A number with its limit, told in δ where it is a length.
struct Measured {
  double value = 0, limit = 0;
  const char* unit = "";
  bool upper = true;   ///< the limit must not be exceeded
  bool number = false; ///< there is one
};
Measured measured(Measure measure, double value, double limit, double delta);

/// What the journal says of the edge's event, where it measured something; the sweeps of a repair.
void event_details(Ui& ui, const Journal& journal, std::uint32_t index);
/// Other events of the edge, newest first.
void edge_history(Ui& ui, const Journal& journal, VertexId a, VertexId b);

} // namespace isoscope::panels
